/// Tests a flat half-space scene in axes that stand askew on its plane: every node then has a local triad that differs
/// from the axes, and the answer is known exactly.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "contact/newton/newton.hpp"
#include "contact/operators/dense_operators.hpp"
#include "support/frames.hpp"

namespace rollcon {
namespace {

constexpr double young = 1e4;

struct Quiet final : Monitor {
  bool step(const StepRecord&) override { return false; }
};

/// Takes points in the askew axes' projection.
class Stretched final : public Compliance {
 public:
  Stretched(std::unique_ptr<Compliance> inner, double factor) : inner_(std::move(inner)), factor_(factor) {}
  std::int64_t nodes() const override { return inner_->nodes(); }
  bool couples() const override { return inner_->couples(); }
  void block(Points p, const ComplianceBlock& out) const override {
    const std::vector<double> x = stretched(p);
    inner_->block({x, p.y}, out);
  }
  void apply(Points p, const double* t, double* u) const override {
    const std::vector<double> x = stretched(p);
    inner_->apply({x, p.y}, t, u);
  }
  void set_threads(int) override {}
  std::int64_t kernel_evaluations() const override { return 0; }
  std::size_t bytes() const override { return 0; }

 private:
  std::vector<double> stretched(Points p) const {
    std::vector<double> x(p.x.begin(), p.x.end());
    for (double& v : x) v *= factor_;
    return x;
  }
  std::unique_ptr<Compliance> inner_;
  double factor_;
};

struct Pair {
  double poisson1, poisson2;
  const char* name;
};
constexpr Pair pairs[] = {{0.3, 0.3, "decoupled"}, {0.3, -2, "coupled"}};  // -2: rigid

struct Solved {
  Problem problem;
  Iterate iterate;
  NewtonReport report;
};

/// Puts a sphere on the plane, with axes askew by `tilt` about t2.
struct Setting {
  Frame flat, askew;
  double cosine, sine;
  std::unique_ptr<Compliance> flat_compliance, askew_compliance;

  Setting(double tilt, const Pair& pair) : cosine(std::cos(tilt)), sine(std::sin(tilt)) {
    const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 14);
    const SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
    flat = build_frame(mesh, {});
    askew = build_frame(mesh, {{0, 0, 0}, {cosine, 0, -sine}, {0, 1, 0}, {sine, 0, cosine}});
    curve_frame(askew, std::vector<Vec3>(mesh.node.size(), Vec3{0, 0, 1}));
    HalfspaceConstants c = halfspace_constants(young, pair.poisson1, 1);
    if (pair.poisson2 > -1) {
      const HalfspaceConstants d = halfspace_constants(young, pair.poisson2, -1);
      c = {c.cn + d.cn, c.cv + d.cv, pair.poisson1 == pair.poisson2 ? 0 : c.ck + d.ck};
    }
    flat_compliance = make_halfspace_compliance(flat, c, 1e-8, 1);
    askew_compliance = std::make_unique<Stretched>(make_halfspace_compliance(flat, c, 1e-8, 1), 1 / cosine);
  }

  Solved solve(bool tilted, Scheme scheme, const std::array<bool, motion_count>& by_force, const MotionValues& value,
               double mu) const {
    Solved s;
    Problem& p = s.problem;
    const Frame& frame = tilted ? askew : flat;
    take_frame(p, frame);
    p.convection = make_convection(frame, scheme, false);
    const auto op = std::make_shared<DenseOperators>();
    assemble_operators(frame, tilted ? *askew_compliance : *flat_compliance, p.convection, mu > 0, *op);
    p.op = op;
    set_scales(p);
    for (const Vec3& x : frame.mesh.node) p.gap.push_back(0.01 * (x[0] * x[0] + x[1] * x[1]));
    p.mu.assign(p.gap.size(), mu);
    if (!p.convection.rows.start.empty())
      for (std::size_t i = 0; i < p.gap.size(); ++i)
        if (p.convection.rows.start[i] == p.convection.rows.start[i + 1]) p.mu[i] = 0;
    p.stiffness = young;
    const Prescribed given{.by_force = by_force, .value = value};
    s.iterate.resize(p.nodes);
    Newton newton;
    Quiet quiet;
    s.report = newton.solve(p, given, s.iterate, mu == 0, 1e-11, 200, quiet);
    return s;
  }
};

double difference(const Solved& a, const Solved& b) {
  double worst = 0, scale = 0;
  for (int c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < a.problem.gap.size(); ++k) {
      worst = std::max(worst, std::abs(a.iterate.lambda[c][k] - b.iterate.lambda[c][k]));
      scale = std::max(scale, std::abs(b.iterate.lambda[c][k]));
    }
  return worst / scale;
}

constexpr double depth = 0.02, creep1 = -1.2e-3, creep2 = 4e-4, spin_rate = 3e-4;
constexpr std::array<bool, motion_count> by_motion{};

MotionValues askew_motion(const Setting& s) {
  return {creep1 / s.cosine, creep2, depth / s.cosine, spin_rate / s.cosine};
}

TEST(tilted_plane, motions_are_projected) {
  for (const Pair& pair : pairs)
    for (const Scheme scheme : {scheme_of("godunov"), scheme_of("least_squares"), Scheme::characteristic}) {
      const Setting setting(0.4, pair);
      const Solved flat = setting.solve(false, scheme, by_motion, {creep1, creep2, depth, spin_rate}, 0.3);
      const Solved askew = setting.solve(true, scheme, by_motion, askew_motion(setting), 0.3);
      ASSERT_EQ(flat.report.outcome, Outcome::converged);
      ASSERT_EQ(askew.report.outcome, Outcome::converged);
      const double error = difference(askew, flat);
      std::printf("%s, %s: tractions in askew axes differ by %.1e (bound 1e-9)\n", pair.name, scheme.name, error);
      EXPECT_LT(error, 1e-9);
    }
}

TEST(tilted_plane, loads_are_the_resultant_in_the_axes) {
  for (const Pair& pair : pairs) {
    const Setting s(0.4, pair);
    const Solved flat = s.solve(false, Scheme::characteristic, by_motion, {creep1, creep2, depth, spin_rate}, 0.3);
    const auto load = [](const Solved& of, int m) { return load_on_body1(of.problem, m, of.iterate.lambda).value; };
    double about_t1 = 0;
    for (std::size_t k = 0; k < flat.problem.gap.size(); ++k)
      about_t1 += flat.problem.moment_y[k] * flat.iterate.lambda[2][k];
    const double fx = load(flat, xi1), fz = -load(flat, approach);
    const MotionValues expected{s.cosine * fx - s.sine * fz, load(flat, xi2), -(s.sine * fx + s.cosine * fz),
                                s.sine * about_t1 + s.cosine * load(flat, spin)};
    const Solved askew = s.solve(true, Scheme::characteristic, by_motion, askew_motion(s), 0.3);
    for (int m = 0; m < 4; ++m) {
      const double error = std::abs(load(askew, m) - expected[static_cast<std::size_t>(m)]) / std::abs(fz);
      std::printf("%s: load %d in askew axes: error %.1e (bound 1e-9)\n", pair.name, m, error);
      EXPECT_LT(error, 1e-9);
    }

    // The motions come back when loads are given: all of them, or some.
    const MotionValues motion = askew_motion(s);
    for (const std::array<bool, motion_count>& by_force : {std::array<bool, motion_count>{true, true, true, true},
                                                           {true, false, false, false},
                                                           {false, false, true, false},
                                                           {true, true, false, false},
                                                           {false, true, true, true}}) {
      MotionValues value = motion;
      for (std::size_t m = 0; m < 4; ++m)
        if (by_force[m]) value[m] = expected[m];
      const Solved found = s.solve(true, Scheme::characteristic, by_force, value, 0.3);
      ASSERT_EQ(found.report.outcome, Outcome::converged);
      EXPECT_EQ(found.report.fallbacks, 0);
      double error = 0;
      for (std::size_t m = 0; m < 4; ++m) error = std::max(error, std::abs(found.iterate.motion[m] / motion[m] - 1));
      std::printf("%s, loads given %d%d%d%d: motions off by %.1e (bound 1e-7), tractions %.1e\n", pair.name,
                  by_force[0], by_force[1], by_force[2], by_force[3], error, difference(found, flat));
      EXPECT_LT(error, 1e-7);
      EXPECT_LT(difference(found, flat), 1e-7);
    }
  }
}

TEST(tilted_plane, normal_load_without_friction) {
  const Setting s(0.4, pairs[0]);
  const std::array<bool, motion_count> by_force{false, false, true, false};
  const Solved flat = s.solve(false, Scheme::characteristic, by_force, {0, 0, 400, 0}, 0);
  const Solved askew = s.solve(true, Scheme::characteristic, by_force, {0, 0, 400 * s.cosine, 0}, 0);
  ASSERT_EQ(askew.report.outcome, Outcome::converged);
  const double error = std::abs(askew.iterate.motion[approach] * s.cosine / flat.iterate.motion[approach] - 1);
  std::printf("approach found: error %.1e (bound 1e-9)\n", error);
  EXPECT_LT(error, 1e-9);
  EXPECT_LT(difference(askew, flat), 1e-9);
}

TEST(tilted_plane, a_load_beyond_friction_is_seen_for_what_friction_carries) {
  // Pressures alone push along the askew t1; what counts is the part of friction.
  const Setting s(0.4, pairs[0]);
  const Solved slow = s.solve(true, Scheme::characteristic, by_motion, askew_motion(s), 0.3);
  double pressures = 0, force = 0;
  for (std::size_t k = 0; k < slow.problem.gap.size(); ++k) {
    const double carried = slow.problem.weight[k] * slow.iterate.lambda[2][k];
    force -= carried;
    pressures += slow.problem.turn[k][2][0] * carried;
  }
  const std::array<bool, motion_count> by_force{true, false, false, false};
  for (const double part : {0.95, 1.05}) {
    const double value = pressures + part * s.cosine * 0.3 * force;
    const Solved found = s.solve(true, Scheme::characteristic, by_force, {value, 0, depth / s.cosine, 0}, 0.3);
    std::printf("%.2f of what friction can carry along t1: outcome %d\n", part, static_cast<int>(found.report.outcome));
    EXPECT_EQ(found.report.outcome, part < 1 ? Outcome::converged : Outcome::no_solution);
  }
}

// The work of loads is the work of tractions: load rows are the motions' columns times the weights.
TEST(tilted_plane, load_rows_are_the_transposed_columns) {
  const std::vector<double> lines = frames::cosine_lines(1, 6);
  const SurfaceMesh plane = frames::perturb(frames::rectangle(ElementType::quad9, lines, lines), 0.1, 7);
  const auto bowl = [](const Vec3& p) {
    return Vec3{p[0], p[1], -0.2 * p[0] * p[0] - 0.3 * p[1] * p[1] + 0.1 * p[0] * p[1]};
  };
  Frame frame = build_frame(frames::transform(plane, bowl), {});
  std::vector<Vec3> normal;
  for (const Vec3& p : plane.node) normal.push_back({0.4 * p[0] - 0.1 * p[1], 0.6 * p[1] - 0.1 * p[0], 1});
  curve_frame(frame, normal);
  Problem p;
  take_frame(p, frame);
  p.convection.slip_x = frame.x;
  p.convection.slip_y = frame.y;
  double worst = 0;
  for (std::size_t k = 0; k < normal.size(); ++k) {
    const double w = p.weight[k];
    const Triad t = frame.triad(k);
    const Vec3 direction[3] = {t.t1, t.t2, t.n};
    for (const int m : {xi1, xi2}) {
      const auto column = p.slip_column(m, k);
      const auto row = p.load_row(m, k);
      for (std::size_t c = 0; c < 2; ++c) {
        worst = std::max(worst, std::abs(row[c] - w * column[c]));
        worst = std::max(worst, std::abs(column[c] - direction[c][static_cast<std::size_t>(m)]));
      }
      worst = std::max(worst, std::abs(row[2] - w * t.n[static_cast<std::size_t>(m)]));
    }
    const auto push = p.load_row(approach, k);
    worst = std::max(worst, std::abs(push[2] + w * p.closing(k)));
    worst = std::max(worst, std::abs(push[0] + w * t.t1[2]));
    // A spin moves by N x r per unit; the moment rows integrate r over the node's shape function.
    const Vec3 arm{-frame.y[k], frame.x[k], 0};
    const auto turning = p.slip_column(spin, k);
    for (std::size_t c = 0; c < 2; ++c) worst = std::max(worst, std::abs(turning[c] - dot(arm, direction[c])));
    const Vec3 moment{-p.moment_y[k], p.moment_x[k], 0};
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(p.load_row(spin, k)[c] - dot(moment, direction[c])));
  }
  std::printf("load rows against columns: %.1e (bound 1e-14)\n", worst);
  EXPECT_LT(worst, 1e-14);
}

}  // namespace
}  // namespace rollcon
