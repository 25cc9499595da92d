// Tests that what ends as converged carries its loads and obeys its laws, whichever part was solved last.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "bodies/halfspace/halfspace.hpp"
#include "contact/cases/solve_many.hpp"
#include "contact/newton/newton.hpp"
#include "contact/operators/dense_operators.hpp"
#include "contact/scene_fixture.hpp"
#include "linalg/fft.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double load = 10, bound = 1e-8;

/// Gives equal steel half-spaces, a few nodes in contact, tangential loads that are all given, near what friction
/// carries; a moment of 0.25 is a fifth too much.
void give_loads(Pair& pair, double moment) {
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 13);
  pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
  Scene& scene = pair.contact->scene;
  scene.set_gap_quadratic(0.01, 0.01, 0);
  pair.friction(0.25);
  scene.prescribe(3, 2, load);
  scene.prescribe(1, 2, 0.8 * 0.25 * load);
  scene.prescribe(2, 2, 0);
  scene.prescribe(4, 2, moment);
}

TEST(last_guard, several_loads_leave_the_normal_one_as_it_is) {
  for (const double moment : {0.0, 0.05, 0.1, 0.15, 0.25})
    for (const std::string operators : {"dense", "table", "fft"}) {
      if (operators == "fft" && !has_fft()) continue;
      Pair pair(2.1e5, 0.3, 2.1e5, 0.3);
      give_loads(pair, moment);
      pair.contact->scene.options.set_text("operators", operators.c_str());
      Status status = Status::err_load;
      try {
        status = pair.contact->solve();
      } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::err_load);
      }
      // Few nodes touch.
      EXPECT_EQ(status, moment > 0.2 ? Status::err_load : Status::coarse) << moment << operators;
      if (status != Status::coarse) continue;
      std::printf("moment %.2f, %s: loads off by %.1e, laws by %.1e (bound %.0e)\n", moment, operators.c_str(),
                  pair.contact->stat("law_equilibrium"), pair.worst_law(), bound);
      EXPECT_LT(pair.worst_law(), bound) << moment << operators;
    }
}

TEST(last_guard, neither_do_cases_of_a_list) {
  Pair pair(2.1e5, 0.3, 2.1e5, 0.3);
  give_loads(pair, 0.25);
  const std::array<double, 2> value{load, 2 * load};
  std::array<std::int32_t, 2> status{};
  std::array<double, 6> force{};
  const Parameter parameter[] = {Parameter::normal};
  CaseList list;
  list.parameter = parameter;
  list.cases = 2;
  list.value = value.data();
  CaseResults results;
  results.status = status.data();
  const CaseColumn columns[] = {{.kind = CaseColumn::Kind::force, .width = 3}};
  results.column = columns;
  results.row = force.data();
  results.stride = 3;
  (void)pair.contact->solve_many(list, results);
  for (std::size_t i = 0; i < 2; ++i) {
    const double off = std::abs(force[3 * i + 2] / -value[i] - 1);
    std::printf("case %zu: status %d, normal load off by %.1e (bound %.0e)\n", i, status[i], off, bound);
    EXPECT_EQ(status[i], static_cast<std::int32_t>(i == 0 ? Status::err_load : Status::coarse));
    if (i == 1) {
      EXPECT_LT(off, bound);
    }
  }
}

/// Spoils what the normal part found, once, when the tangential part begins.
struct Spoiler final : Monitor {
  enum class What { nothing, pressures, approach } what = What::nothing;
  Iterate* iterate = nullptr;
  bool step(const StepRecord& record) override {
    if (record.part != Part::tangential || what == What::nothing) return false;
    if (what == What::approach) iterate->motion[approach] *= 1.3;
    if (what == What::pressures)
      for (std::vector<double>* v : {&iterate->lambda[2], &iterate->image[2]})
        for (double& x : *v) x *= 1.5;
    what = What::nothing;
    return false;
  }
};

struct Solved {
  NewtonReport report;
  Iterate iterate;
  double load = 0;
};

Solved solve_spoilt(Spoiler::What what, bool by_force, bool again) {
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 10);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, lines, lines), {});
  HalfspaceConstants c = halfspace_constants(1e4, 0.3, 1), d = halfspace_constants(1e4, 0.3, -1);
  const auto compliance = make_halfspace_compliance(frame, {c.cn + d.cn, c.cv + d.cv, 0}, 1e-8, 1);
  Problem p;
  take_frame(p, frame);
  p.convection = make_convection(frame, Scheme::characteristic, false);
  const auto op = std::make_shared<DenseOperators>();
  assemble_operators(frame, *compliance, p.convection, true, *op);
  p.op = op;
  set_scales(p);
  for (const Vec3& x : frame.mesh.node) p.gap.push_back(0.01 * (x[0] * x[0] + x[1] * x[1]));
  p.mu.assign(p.gap.size(), 0.3);
  p.stiffness = 5e3;
  Prescribed given;
  given.by_force = {true, false, by_force, false};
  given.value = {20, 0, by_force ? 150 : 0.02, 1e-3};
  Solved s;
  s.iterate.resize(p.nodes);
  Newton newton;
  Spoiler spoiler;
  spoiler.iterate = &s.iterate;
  if (again) {
    EXPECT_EQ(newton.solve(p, given, s.iterate, false, 1e-10, 500, spoiler).outcome, Outcome::converged);
    given.value[xi1] = 25;
  }
  spoiler.what = what;
  s.report = newton.solve(p, given, s.iterate, false, 1e-10, 500, spoiler);
  s.load = load_on_body1(p, approach, s.iterate.lambda).value;
  return s;
}

// A part that is solved on top of wrong pressures does not end the solve.
TEST(last_guard, sees_what_was_not_solved_last) {
  for (const bool again : {false, true})
    for (const bool by_force : {true, false}) {
      const Solved right = solve_spoilt(Spoiler::What::nothing, by_force, again);
      ASSERT_EQ(right.report.outcome, Outcome::converged);
      EXPECT_EQ(right.report.refuted, 0);
      EXPECT_EQ(right.report.fallbacks, 0);
      for (const auto what : {Spoiler::What::pressures, Spoiler::What::approach}) {
        // A given approach is given again when the next part begins.
        const Solved s = solve_spoilt(what, by_force, again);
        double off = std::abs(s.load / right.load - 1), most = 0;
        for (const double l : right.iterate.lambda[2]) most = std::max(most, -l);
        for (std::size_t k = 0; k < right.iterate.lambda[2].size(); ++k)
          off = std::max(off, std::abs(s.iterate.lambda[2][k] - right.iterate.lambda[2][k]) / most);
        std::printf("%s, normal by %s, %s spoilt: %lld refuted, pressures off by %.1e (bound %.0e)\n",
                    again ? "warm" : "cold", by_force ? "force" : "motion",
                    what == Spoiler::What::pressures ? "pressures" : "approach",
                    static_cast<long long>(s.report.refuted), off, bound);
        EXPECT_GE(s.report.refuted, 1);
        EXPECT_EQ(s.report.outcome, Outcome::converged);
        EXPECT_LT(off, bound);
      }
    }
}

}  // namespace
}  // namespace rollcon
