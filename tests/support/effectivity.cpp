#include "support/effectivity.hpp"

#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "support/carter_strip.hpp"
#include "support/example3.hpp"
#include "support/frames.hpp"
#include "support/graded_disc.hpp"
#include "support/scene.hpp"
#include "support/steady_rolling.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::scenes {
namespace {

using closed_forms::Hertz;
using closed_forms::steady_rolling;

const Elastic steel{.shear = 82000, .poisson = 0.28};

double seconds() {
  using clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(clock::now().time_since_epoch()).count();
}

/// Solves a scene, then asks for its estimates, and measures both.
class Judge {
 public:
  Judge(std::string scene, std::string model, std::string mesh, std::string scheme) {
    record_.scene = std::move(scene);
    record_.model = std::move(model);
    record_.mesh = std::move(mesh);
    record_.scheme = std::move(scheme);
    began_ = seconds();
  }

  Solution solve(RollingPair& pair) {
    pair_ = &pair;
    record_.status = pair.solve();
    record_.solve_seconds = seconds() - began_;
    const double asked = seconds();
    pair.stat("error_estimate");
    record_.estimate_seconds = seconds() - asked;
    std::int64_t elements = 0;
    rollcon_contact_get_size(pair.handle(), &record_.nodes, &elements);
    record_.in_contact = std::llround(pair.stat("nodes_contact"));
    Solution s = pair.solution();
    for (std::size_t k = 0; k < s.nodes(); ++k)
      magnitude_ += s.area[k] * std::hypot(s.traction[k][0], s.traction[k][1]);
    return s;
  }

  void normal(double error, const std::string& against) {
    add("normal force", "error_estimate_normal", std::abs(error), against);
  }
  /// Compares the estimate of a tangential force, in units of force.
  void tangential(double error, const std::string& against) {
    add("tangential force", "error_estimate_tangential", std::abs(error) / magnitude_, against);
  }
  void tractions(double error, const std::string& against) {
    add("tractions", "error_estimate_tractions", error, against);
  }
  Judgement result() const { return list_; }

 private:
  void add(const char* quantity, const char* statistic, double error, const std::string& against) {
    Judged r = record_;
    r.quantity = quantity;
    r.against = against;
    r.estimate = pair_->stat(statistic);
    r.error = error;
    list_.push_back(std::move(r));
  }

  Judged record_;
  Judgement list_;
  RollingPair* pair_ = nullptr;
  double began_ = 0, magnitude_ = 0;
};

/// Returns the relative L2 error of the interpolated pressure, by quadrature on every element cut in 8 x 8.
double pressure_error(const SurfaceMesh& mesh, const Solution& s, const Hertz& exact) {
  constexpr int cuts = 8;
  const PlaneRule square = square_rule(3), triangle = triangle_rule(3);
  double sum = 0;
  Shape shape;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto nodes = mesh.element(e);
    const auto add = [&](double xi, double eta, double w) {
      evaluate_shape(type, xi, eta, shape);
      double x = 0, y = 0, p = 0, x_xi = 0, x_eta = 0, y_xi = 0, y_eta = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto k = static_cast<std::size_t>(nodes[i]);
        x += shape.value[i] * s.x[k];
        y += shape.value[i] * s.y[k];
        p += shape.value[i] * s.pressure[k];
        x_xi += shape.d_xi[i] * s.x[k];
        x_eta += shape.d_eta[i] * s.x[k];
        y_xi += shape.d_xi[i] * s.y[k];
        y_eta += shape.d_eta[i] * s.y[k];
      }
      sum += w * (x_xi * y_eta - x_eta * y_xi) * std::pow(p - exact.pressure(x, y), 2);
    };
    const double h = 1.0 / cuts;
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; j < cuts; ++j) {
        if (corner_count(type) == 4) {
          for (std::size_t q = 0; q < square.size(); ++q)
            add(-1 + h * (2 * i + 1 + square.xi[q]), -1 + h * (2 * j + 1 + square.eta[q]), h * h * square.w[q]);
          continue;
        }
        if (i + j >= cuts) continue;
        for (std::size_t q = 0; q < triangle.size(); ++q) {
          add(h * (i + triangle.xi[q]), h * (j + triangle.eta[q]), h * h * triangle.w[q]);
          if (i + j + 1 < cuts) add(h * (i + 1 - triangle.xi[q]), h * (j + 1 - triangle.eta[q]), h * h * triangle.w[q]);
        }
      }
  }
  return std::sqrt(sum / (exact.p0 * exact.p0 * std::numbers::pi * exact.a * exact.b / 2));
}

const double creep_mu = 0.33;
const Hertz& creep_hertz() {
  static const Hertz hertz =
      closed_forms::hertz_from_load(.0008, .0002814173138, closed_forms::effective_modulus(steel, steel), 106700);
  return hertz;
}

void set_creep_curve(RollingPair& pair, const SurfaceMesh& mesh, double xi, const char* scheme) {
  const Hertz& h = creep_hertz();
  pair.frame(mesh).gap_quadratic(h.A, h.B).load(h.load).friction(creep_mu);
  pair.creep(-xi, 0, 0).option("convection", scheme);
}

}  // namespace

JudgedFrame judged_grid(double a, double b, int across, bool triangles, bool quadratic) {
  const int n = quadratic ? across * 14 / 24 : across * 28 / 24;
  const double reach = 28.0 / 24;
  const auto x = frames::uniform_lines(-reach * a, reach * a, n);
  const auto y = frames::uniform_lines(-reach * b, reach * b, n);
  const ElementType type = triangles ? (quadratic ? ElementType::tri6 : ElementType::tri3)
                                     : (quadratic ? ElementType::quad8 : ElementType::quad4);
  const std::string name = triangles ? (quadratic ? "tri6" : "tri3") : quadratic ? "quad8" : "quad4";
  return {name + " grid " + std::to_string(across), frames::rectangle(type, x, y)};
}

JudgedFrame judged_unstructured(double a, double b, int across) {
  constexpr double fraction = 0.2;
  JudgedFrame frame = judged_grid(a, b, across, true);
  return {"tri3 at random " + std::to_string(across), frames::perturb(frame.mesh, fraction, 3)};
}

JudgedFrame judged_rings(double a, double b, int rings) {
  return {"rings " + std::to_string(rings), graded_disc(a, b, rings)};
}

Judgement judge_hertz(const JudgedFrame& frame) {
  const Hertz exact = closed_forms::hertz_from_axes(1, 1, 1000, closed_forms::effective_modulus(steel, steel));
  Judge judge("Hertz", "half-spaces", frame.name, "-");
  RollingPair pair(steel, steel);
  pair.frame(frame.mesh).gap_quadratic(exact.A, exact.B).friction(0).approach(exact.approach);
  const Solution s = judge.solve(pair);
  judge.normal(-s.force[2] / exact.load - 1, "Hertz's closed form");
  judge.tractions(pressure_error(frame.mesh, s, exact), "Hertz's closed form");
  return judge.result();
}

Judgement judge_carter(int across, bool graded, const char* scheme) {
  const Strip strip{carter.hertz, 20};
  const auto mesh = frames::rectangle(ElementType::quad4, graded ? graded_nodes(across) : strip_nodes(across),
                                      strip_lines(strip.half_length));
  Judge judge("Carter", "half-spaces", (graded ? "graded " : "uniform ") + std::to_string(across), scheme);
  RollingPair pair(roller, roller);
  pair.frame(mesh).option("convection", scheme);
  load_strip(pair, strip, mesh);
  const Solution s = judge.solve(pair);
  const CarterErrors errors = compare(middle_section(s));
  judge.normal(-s.force[2] / strip.total_load() - 1, "load of the strip");
  judge.tangential(errors.force * s.force[0], "Carter's closed form, middle section");
  return judge.result();
}

Judgement judge_steady_rolling(const std::string& which, const JudgedFrame& frame, const char* scheme) {
  namespace sr = scenes::steady_rolling;
  Judge judge("case " + which, "half-spaces", frame.name, scheme);
  RollingPair pair(sr::steel, sr::steel);
  sr::prepare(pair, frame.mesh, which);
  pair.option("convection", scheme);
  const Solution s = judge.solve(pair);
  // The error is that of the force at the approach found, because F goes with its power 3/2.
  judge.normal(1 - std::pow(s.approach / sr::hertz.approach, 1.5), "Hertz's closed form");
  const auto limit = sr::limit(which).force;
  judge.tangential(sr::mu * sr::hertz.load * sr::errors(s, which).force * std::hypot(limit[0], limit[1]),
                   "CONTACT extrapolated");
  return judge.result();
}

Judgement judge_linear_theory(int direction, int rings, const char* scheme) {
  constexpr double mu = 0.3, ratio = 2, share = 0.006;
  const Elastic body{.shear = 82000, .poisson = 0.25};
  const Hertz h = closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000,
                                                closed_forms::effective_modulus(body, body));
  const auto table = closed_forms::kalker_table(ratio, body.poisson);
  const double unit = share * mu * h.load / body.shear;
  const char* names[] = {"C11", "C22", "C23"};
  const double c[] = {table.c11, table.c22, table.c23};
  const auto d = static_cast<std::size_t>(direction - 1);
  Judge judge(std::string("Kalker ") + names[d], "half-spaces", "rings " + std::to_string(rings), scheme);
  RollingPair pair(body, body);
  pair.frame(graded_disc(h.a, h.b, rings)).gap_quadratic(h.A, h.B).load(h.load).friction(mu);
  pair.option("convection", scheme);
  const double motion = unit / c[d];
  pair.creep(d == 0 ? motion : 0, d == 1 ? motion : 0, d == 2 ? motion : 0);
  const Solution s = judge.solve(pair);
  const double exact = -body.shear * c[d] * motion;
  judge.tangential(s.force[d == 0 ? 0 : 1] - exact, "Kalker's table (three digits)");
  return judge.result();
}

std::vector<double> creep_curve_axes() {
  return {creep_hertz().a, creep_hertz().b};
}

Judgement judge_creep_curve(double xi, const JudgedFrame& frame, const char* scheme) {
  static std::map<double, double> reference;
  if (!reference.count(xi)) {
    RollingPair fine(steel, steel);
    set_creep_curve(fine, graded_disc(creep_hertz().a, creep_hertz().b, 18), xi, "characteristic");
    fine.solve();
    reference[xi] = fine.solution().force[0];
  }
  char name[40];
  std::snprintf(name, sizeof name, "creepage %.1e", xi);
  Judge judge(name, "half-spaces", frame.name, scheme);
  RollingPair pair(steel, steel);
  set_creep_curve(pair, frame.mesh, xi, scheme);
  const Solution s = judge.solve(pair);
  judge.normal(1 - std::pow(s.approach / creep_hertz().approach, 1.5), "Hertz's closed form");
  judge.tangential(s.force[0] - reference[xi], "18 graded rings, characteristic");
  return judge.result();
}

Judgement judge_example3(int nodes, const char* scheme) {
  const double a = example3::hertz().a;
  static double reference = 0;
  if (reference == 0) {
    auto fine = example3::pair(graded_disc(a, a, 18), "characteristic");
    fine->solve();
    reference = fine->solution().creep[0];
  }
  const bool rings = nodes < 100;
  const example3::NamedFrame frame =
      rings ? example3::NamedFrame{"rings " + std::to_string(nodes), graded_disc(a, a, nodes)} : example3::frame(nodes);
  Judge judge("example 3", "half-space on rigid", frame.name, scheme);
  auto pair = example3::pair(frame.mesh, scheme);
  const Solution s = judge.solve(*pair);
  // The force at the creepage found follows from the creepage at the force given.
  double rate[3] = {};
  rollcon_contact_get_sensitivity(pair->handle(), ROLLCON_LONGITUDINAL, nullptr, nullptr, nullptr, rate);
  judge.tangential((s.creep[0] - reference) / rate[0], "18 graded rings, characteristic");
  return judge.result();
}

Judgement judge_block(bool finite_elements, int across, const char* scheme) {
  constexpr double curvature = 0.005, approach = 0.02, mu = 0.3, creep = 1.5e-3, reach = 1.7;
  constexpr int finest = 32;
  const Elastic material{.shear = 2e3 / 2.6, .poisson = 0.3};
  const auto make = [&] {
    surfaces::Block shape;
    const int faces = finite_elements ? 12 : 8;
    shape.line = {frames::uniform_lines(-6, 6, faces), frames::uniform_lines(-6, 6, faces),
                  frames::uniform_lines(-6, 0, finite_elements ? 6 : 3)};
    MeshedBody body = finite_elements ? meshed(volumes::block(shape, VolumeType::hex8), material)
                                      : meshed(surfaces::block(shape, ElementType::quad8), material);
    body.held_tag = {5};
    body.contact_tag = {6};
    return body;
  };
  const auto prepare = [&](RollingPair& pair, int n, const char* convection) {
    pair.axes({0, 0, 0}, {1, 0, 0}, {0, 0, 1}).rectangle(ElementType::quad4, n, n, reach, reach);
    pair.gap_quadratic(curvature, curvature);
    pair.friction(mu).approach(approach).creep(-creep, 0, 0).option("convection", convection);
  };
  static std::map<bool, std::array<double, 3>> reference;
  if (!reference.count(finite_elements)) {
    RollingPair fine(make(), RigidBody{}, 1);
    prepare(fine, finest, "characteristic");
    fine.solve();
    reference[finite_elements] = fine.solution().force;
  }
  const auto& exact = reference[finite_elements];
  const std::string against = "the same under 32 x 32, characteristic";
  Judge judge("ball on block", finite_elements ? "hex8" : "BEM quad8", "quad4 grid " + std::to_string(across), scheme);
  RollingPair pair(make(), RigidBody{}, 1);
  prepare(pair, across, scheme);
  const Solution s = judge.solve(pair);
  judge.normal(s.force[2] / exact[2] - 1, against);
  judge.tangential(std::hypot(s.force[0] - exact[0], s.force[1] - exact[1]), against);
  return judge.result();
}

}  // namespace rollcon::scenes
