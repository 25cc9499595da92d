// Measures the paper's example 4, a wheel on a rigid rail head: longitudinal force over element size, the wheel of
// boundary or of finite elements.

#include "support/example4.hpp"

#include <cmath>

#include "meshes.hpp"
#include "study.hpp"
#include "support/graded_disc.hpp"

namespace rollcon::bench {
namespace {

namespace example4 = scenes::example4;

constexpr double creepage = -9e-4;
constexpr double half_width = 65, rim = 60, sector = 120;  ///< size of the part of the wheel
constexpr double zone_along = 5.49, zone_across = 7;

/// Makes the wheel of examples/wheel_mesh.h with n by n elements in the zone: lines along the tread, across, and from
/// the rim's inner face to the conical tread.
surfaces::Block wheel_block(int n, bool volume) {
  surfaces::Block b;
  const int beyond = std::max(2, n / 2);
  b.line[0] = lines_with_zone(zone_along / 2, n, beyond, sector / 2);
  b.line[1] = lines_with_zone(zone_across / 2, n, beyond, half_width);
  b.line[2] =
      surfaces::graded_to(volume ? std::max(4, n) : std::max(2, n / 2), 0, 1, volume ? zone_along / n / rim : 4 / rim);
  const double inner = example4::radius - rim;
  b.map = [inner](const Vec3& q) {
    const double angle = q[0] / example4::radius;
    const double tread = example4::radius - example4::cone * q[1];
    const double r = inner + q[2] * (tread - inner);
    return Vec3{r * std::sin(angle), q[1], r * std::cos(angle)};
  };
  b.tag = {6, 7, 4, 5, 3, 1};
  b.zone_from = {beyond, beyond};
  b.zone_to = {beyond + n, beyond + n};
  b.zone_tag = 2;
  return b;
}

scenes::MeshedBody wheel(const BodyKind& kind, int n) {
  scenes::MeshedBody body = meshed_block(wheel_block(n, kind.volume), kind, example4::material);
  body.held_tag = {3, 6, 7};
  body.contact_tag = {1, 2};
  return body;
}

/// Makes a cylinder along x of quad8 whose top is the origin.
scenes::MeshedBody rail() {
  constexpr double half_length = 10, half_angle = 20 / example4::rail;
  scenes::MeshedBody body;
  body.mesh =
      frames::transform(frames::rectangle(ElementType::quad8, frames::uniform_lines(-half_length, half_length, 8),
                                          frames::uniform_lines(-half_angle, half_angle, 8)),
                        [](const Vec3& q) {
                          return Vec3{q[0], example4::rail * std::sin(q[1]), example4::rail * (std::cos(q[1]) - 1)};
                        });
  body.mesh.tag.assign(body.mesh.tag.size(), 1);
  return body;
}

/// The wheel stands on its top: the rail lies above it, tilted like the cone.
std::unique_ptr<scenes::RollingPair> roll(const scenes::MeshedBody& on, int threads) {
  auto p = std::make_unique<scenes::RollingPair>(on, rail(), threads);
  const double c = 1 / std::hypot(1, example4::cone), s = example4::cone * c;
  p->axes({0, 0, example4::radius}, {1, 0, 0}, {0, s, c});
  p->pose(2, {{{1, 0, 0}, {0, -c, -s}, {0, s, -c}}}, {0, 0, example4::radius});
  p->frame_from_body(1, 2).friction(example4::mu).approach(example4::depth);
  p->speed(example4::speed).creep(creepage, 0, 0);
  return p;
}

const closed_forms::Hertz hertz =
    closed_forms::hertz_from_approach(1 / (2 * example4::radius), 1 / (2 * example4::rail),
                                      closed_forms::effective_modulus(example4::material), example4::depth);

/// Returns forces and moment over those of half-spaces with this approach.
scenes::RollingAnswer found(const scenes::Solution& s) {
  return scenes::found_forces(s, example4::mu * hertz.load, std::sqrt(hertz.a * hertz.b));
}

/// Lays rings graded to the edge of the contact on top of the wheel.
SurfaceMesh graded_frame(int rings) {
  const double c = 1 / std::hypot(1, example4::cone), s = example4::cone * c;
  SurfaceMesh frame = scenes::graded_disc(hertz.a, hertz.b, rings);
  for (Vec3& x : frame.node) x = {x[0], c * x[1], example4::radius - s * x[1]};
  return frame;
}

/// Adds a reference with such rings on a fine wheel: tangential forces, moment and normal force.
void add_reference(FrameLimits& limits, const BodyKind& kind, int parts, int coarse, int rings, int threads) {
  add_frame_limits(
      limits, parts, coarse, rings, [&](int n) { return roll(wheel(kind, n), threads); },
      [](scenes::RollingPair& pair, int n) {
        pair.frame(graded_frame(n)).solve();
        const scenes::Solution solution = pair.solution();
        const scenes::RollingAnswer answer = found(solution);
        return std::vector{answer.force[0], answer.force[1], answer.moment, -solution.force[2]};
      });
}

/// Returns the meshes of the reference.
int parts_of(const BodyKind& kind, bool quick) {
  return quick ? 4 : kind.volume ? 10 : 8;
}
int coarse_of(const BodyKind& kind, bool quick) {
  return quick ? 3 : kind.volume ? 7 : 6;
}

std::vector<int> sizes(const BodyKind& kind, bool quick) {
  if (quick) return kind.quadratic ? std::vector{3, 4} : std::vector{6, 8};
  return kind.quadratic ? std::vector{3, 4, 5, 6, 7} : std::vector{6, 8, 10, 12, 14};
}

void run(Runner& runner) {
  std::vector<BodyKind> kinds = boundary_elements();
  for (BodyKind& kind : finite_elements()) kinds.push_back(std::move(kind));
  Study study;
  FrameLimits limits;
  for (const BodyKind& kind : kinds)
    if (kind.name == "quad8" || kind.name == "hex20")
      add_reference(limits, kind, parts_of(kind, runner.quick), coarse_of(kind, runner.quick), runner.quick ? 8 : 16,
                    runner.threads);
  Record blank{.case_name = "example4"};
  blank.threads = runner.threads;
  blank.quantity = "tangential force over mu Fn of half-spaces at creepage -9e-4 and approach 0.015 mm";
  const auto solve = [&](const BodyKind& kind, double across, const MakePair& make) {
    blank.model = kind.volume ? "FEM on rigid rail" : "BEM on rigid rail";
    solve_by_schemes(runner, blank, make, [&](Record& record, const Solved& solved) {
      record.extra.emplace_back("normal_force", -solved.solution.force[2]);
      record.extra.emplace_back("p0", solved.pair->stat("max_pressure"));
      study.add(record, found(solved.solution), across);
    });
  };
  const auto zone_name = [](const BodyKind& kind, int n) {
    return kind.name + ", zone " + std::to_string(n) + " x " + std::to_string(n);
  };
  for (const BodyKind& kind : kinds) {
    for (const int n : sizes(kind, runner.quick)) {
      blank.element = kind.name;
      blank.mesh = zone_name(kind, n);
      const scenes::MeshedBody on = wheel(kind, n);
      solve(kind, n * (kind.quadratic ? 2 : 1), [&] { return roll(on, runner.threads); });
    }
    if (kind.name != "quad8" && kind.name != "hex20") continue;
    const int parts = runner.quick ? 3 : kind.volume ? 6 : 5;
    const scenes::MeshedBody on = wheel(kind, parts);
    for (const int rings : {4, 5, 6, 8, 10}) {
      if (runner.quick && rings > 5) continue;
      blank.element = "laid on " + kind.name;
      blank.mesh = std::to_string(rings) + " graded rings on " + zone_name(kind, parts);
      solve(kind, 2 * rings, [&] {
        auto pair = roll(on, runner.threads);
        pair->frame(graded_frame(rings));
        return pair;
      });
    }
  }
  study.compare("normal_force", combine(limits[3]));
  study.emit(runner, rolling_limit(combine(limits[0]), combine(limits[1]), combine(limits[2])),
             "own extrapolation, frames graded to the contact's edge");
}

}  // namespace

std::vector<Case> example4_cases() {
  return {{"example4", "wheel on a rigid rail head, the paper's example 4: every element", run}};
}

}  // namespace rollcon::bench
