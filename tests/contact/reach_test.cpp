/// Nodes out of reach have no rows, results are those of all rows, and nodes come back when a scene needs them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double bound = 1e-10;
constexpr double nodes = 19 * 19;

struct Two {
  Pair some, all;

  Two(double young2, double poisson2) : some(1e4, 0.3, young2, poisson2), all(1e4, 0.3, young2, poisson2) {
    each([&](Pair& pair) {
      const std::vector<double> lines = frames::uniform_lines(-1.8, 1.8, 18);
      pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
      Scene& s = pair.contact->scene;
      s.set_gap_quadratic(0.01, 0.01, 0);
      pair.friction(0.3);
      s.prescribe(3, 1, 0.02);
      s.set_creep(-2e-3, 5e-4, 1e-3);
      s.options.set_real("tolerance", 1e-13);
      s.options.set_text("operators", "dense");
      s.options.set_int("reach", &pair == &some);
    });
  }
  void each(const std::function<void(Pair&)>& change) {
    change(some);
    change(all);
  }
  /// Solves both and compares tractions, and the fields at every node.
  void expect_equal(const std::string& what) {
    each([&](Pair& pair) { ASSERT_GE(static_cast<int>(pair.contact->solve()), 0) << what; });
    const double off = largest_difference(some.tractions(), all.tractions());
    EXPECT_LT(off, bound) << what;
    double fields = 0;
    for (const Field which : {Field::gap, Field::slip}) {
      std::vector<double> v[2];
      int i = 0;
      each([&](Pair& pair) {
        v[i].resize(static_cast<std::size_t>(2 * pair.contact->nodes()));
        pair.contact->field(which, InAxes::local, static_cast<std::int64_t>(v[i].size()), v[i].data());
        ++i;
      });
      fields = std::max(fields, largest_difference(v[0], v[1]));
    }
    std::printf(
        "%s: %g of %g rows, %g came back; tractions differ by %.1e (bound %.0e), gap and slip %.1e (bound 1e-6)\n",
        what.c_str(), stat("rows_assembled"), nodes, stat("nodes_returned"), off, bound, fields);
    EXPECT_LT(fields, 1e-6) << what << ": rows and integrals themselves";
    EXPECT_EQ(some.contact->stat("nodes_stick"), all.contact->stat("nodes_stick"));
    EXPECT_EQ(some.contact->stat("nodes_slip"), all.contact->stat("nodes_slip"));
  }
  double stat(const char* name) const { return some.contact->stat(name); }
};

TEST(reach, saves_rows_in_every_scheme_and_pair) {
  for (const char* scheme : {"characteristic", "least_squares", "godunov"})
    for (const double poisson2 : {0.3, 0.1, -2.0}) {
      Two two(1e4, poisson2);
      two.each([&](Pair& p) { p.contact->scene.options.set_text("convection", scheme); });
      two.expect_equal(scheme);
      EXPECT_LT(two.stat("rows_assembled"), 0.55 * nodes);
      EXPECT_EQ(two.stat("nodes_reach"), two.stat("rows_assembled"));
      EXPECT_EQ(two.stat("nodes_returned"), 0);
      EXPECT_LT(two.stat("kernel_evaluations"), 0.75 * two.all.contact->stat("kernel_evaluations"));
      EXPECT_NEAR(two.stat("operator_bytes"),
                  two.all.contact->stat("operator_bytes") * two.stat("rows_assembled") / nodes, 2e5);
      EXPECT_EQ(two.all.contact->stat("rows_assembled"), nodes);
      EXPECT_NE(two.some.contact->plan().find("are out of it"), std::string::npos);
      EXPECT_NE(two.all.contact->plan().find("option reach is 0"), std::string::npos);
    }
}

TEST(reach, grows_with_load_and_approach) {
  for (const double poisson2 : {0.3, 0.1}) {
    Two two(1e4, poisson2);
    double last = 0;
    for (const double depth : {0.004, 0.0042, 0.02, 0.03, 0.002}) {
      two.each([&](Pair& p) { p.contact->scene.prescribe(3, 1, depth); });
      two.expect_equal("approach " + std::to_string(depth));
      EXPECT_GE(two.stat("rows_assembled"), last) << "rows stay";
      last = two.stat("rows_assembled");
    }
    for (const double load : {50.0, 400.0}) {
      two.each([&](Pair& p) { p.contact->scene.prescribe(3, 2, load); });
      two.expect_equal("load " + std::to_string(load));
    }
    EXPECT_LE(two.stat("compliance_assemblies"), 6);
  }
}

TEST(reach, small_changes_assemble_nothing) {
  Two two(1e4, 0.3);
  two.expect_equal("first");
  const double rows = two.stat("rows_assembled"), kernels = two.stat("compliance_assemblies");
  for (const double depth : {0.0205, 0.021, 0.0195}) {
    two.each([&](Pair& p) { p.contact->scene.prescribe(3, 1, depth); });
    two.expect_equal("approach " + std::to_string(depth));
  }
  EXPECT_EQ(two.stat("rows_assembled"), rows);
  EXPECT_EQ(two.stat("compliance_assemblies"), kernels);
}

TEST(reach_long, brings_back_what_the_guess_left_out) {
  using Gap = double (*)(double, double);
  const std::pair<const char*, Gap> gaps[] = {
      {"flat with a step", [](double x, double y) { return std::hypot(x, y) < 1.2 ? 0.0 : 0.006; }},
      {"two bumps",
       [](double x, double y) {
         return std::min(0.02 * ((x - 1) * (x - 1) + y * y), 0.004 + 0.02 * ((x + 1) * (x + 1) + y * y));
       }},
      {"a needle in a plain",
       [](double x, double y) { return std::min(0.3 * (x * x + y * y), 0.01 + 0.0005 * (x * x + y * y)); }}};
  double returned = 0;
  const auto solve = [&](const char* name, Gap gap, How how, double value) {
    Two two(1e4, 0.1);
    two.each([&](Pair& p) {
      std::vector<double> h;
      for (const Vec3& x : p.contact->scene.mesh().node) h.push_back(gap(x[0], x[1]));
      p.contact->scene.set_gap(p.contact->nodes(), h.data());
      p.contact->scene.prescribe(3, static_cast<std::int32_t>(how), value);
    });
    two.expect_equal(name);
    returned += two.stat("nodes_returned");
  };
  for (const auto& [name, gap] : gaps)
    for (const double load : {20.0, 200.0, 600.0}) solve(name, gap, How::by_force, load);
  // Contact reaches to 0.86 of the approach, that of the guess to a half.
  for (const double depth : {0.01, 0.012, 0.014})
    solve(
        "a cusp", [](double x, double y) { return 0.012 * std::pow(std::hypot(x, y), 0.25); }, How::by_motion, depth);
  EXPECT_GT(returned, 0) << "no scene of this test puts the check to work";
}

TEST(reach, is_left_off_where_its_bound_does_not_hold) {
  Pair quadratic(1e4, 0.3, 1e4, 0.3);
  const std::vector<double> lines = frames::uniform_lines(-1.8, 1.8, 9);
  quadratic.frame(frames::rectangle(ElementType::quad9, lines, lines));
  quadratic.contact->scene.set_gap_quadratic(0.01, 0.01, 0);
  quadratic.friction(0.3);
  quadratic.contact->scene.prescribe(3, 1, 0.02);
  ASSERT_EQ(quadratic.contact->solve(), Status::ok);
  EXPECT_EQ(quadratic.contact->stat("rows_assembled"), nodes);
  EXPECT_NE(quadratic.contact->plan().find("quadratic elements change sign"), std::string::npos);

  Two strong(1e4, -2);
  strong.each([](Pair& p) { p.friction(1.5); });
  strong.expect_equal("strong friction");
  EXPECT_EQ(strong.stat("rows_assembled"), nodes);
}

TEST(reach, serves_sensitivities_and_estimates) {
  Two two(1e4, 0.1);
  two.expect_equal("first");
  for (const Parameter parameter : {Parameter::normal, Parameter::longitudinal, Parameter::friction}) {
    double force[2][3];
    int i = 0;
    two.each([&](Pair& p) { p.contact->sensitivity(parameter, force[i++], nullptr, nullptr, nullptr); });
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(force[0][c], force[1][c], 1e-8 * std::abs(force[1][2]) + 1e-8);
  }
  for (const char* name : {"error_estimate_normal", "error_estimate_tangential"})
    EXPECT_NEAR(two.stat(name), two.all.contact->stat(name), 1e-6) << name;
  EXPECT_LT(two.stat("rows_assembled"), nodes) << "they need no more rows";
}

}  // namespace
}  // namespace rollcon
