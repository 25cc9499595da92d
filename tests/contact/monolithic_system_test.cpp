/// Tests that a step of the monolithic system is that of the condensed one, whatever the bodies, the scheme, the loads,
/// the form and the solver.

#include "contact/monolithic_case.hpp"
#include "procedures/step_system.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace monolithic_test;

constexpr double bound = 1e-9;
const Scheme schemes[] = {scheme_of("godunov"), scheme_of("least_squares"), Scheme::characteristic};

StepOptions monolithic(const Case& c, LinearMethod linear = LinearMethod::lu,
                       Preconditioner preconditioner = Preconditioner::automatic) {
  return {true, c.tangential, linear, preconditioner};
}

/// Returns the difference of the step from that by condensed formulas: with the bodies' unknowns written out, and with
/// them eliminated.
double step_error(const Case& c) {
  double worst = 0;
  const Point expected = condensed_step(c);
  for (const bool whole : {true, false}) {
    const Problem problem = whole ? written_out(c) : c.problem;
    StepOptions options = monolithic(c);
    options.monolithic = whole;
    StepSystem system(problem, *c.frame, *c.compliance, options);
    Point z = c.z, next;
    system.update(z);
    if (!system.solve(c.step, z, 1e-13, next)) return INFINITY;
    worst = std::max(worst, difference(c, next, expected));
  }
  return worst;
}

TEST(monolithic_system, half_spaces) {
  for (const double poisson2 : {-2.0, 0.1, 0.3})
    for (const Scheme scheme : schemes)
      for (const Motions& motions : {Motions{}, Motions{true, false}, Motions{true, true}}) {
        const Case c = halfspaces(8, 0.3, poisson2, scheme, motions);
        expect_error(c.name + ", " + scheme.name + (motions.approach_by_force ? ", load" : "") +
                         (motions.creep_by_force ? ", forces" : ""),
                     step_error(c), bound);
      }
}

TEST(monolithic_system, bodies_with_random_equations) {
  for (const bool direct : {false, true})
    for (const Scheme scheme : schemes) {
      const Case c = random_bodies(6, direct, scheme, {true, true});
      expect_error(c.name + ", " + scheme.name, step_error(c), bound);
    }
}

constexpr Model pairs[][2] = {{Model::fem, Model::rigid},     {Model::fem, Model::fem},
                              {Model::bem, Model::bem},       {Model::fem, Model::bem},
                              {Model::fem, Model::halfspace}, {Model::halfspace, Model::bem}};

TEST(monolithic_system_long, finite_and_boundary_elements) {
  for (const auto& models : pairs)
    for (const Scheme scheme : schemes) {
      const Case c = meshed({.model = {models[0], models[1]}}, scheme, {true, true});
      expect_error(c.name + ", " + scheme.name, step_error(c), bound);
    }
}

TEST(monolithic_system_long, curved_and_laid_frames) {
  for (const auto& models : {pairs[1], pairs[3]})
    for (const bool own : {false, true})
      for (const Scheme scheme : schemes) {
        Case c = meshed({.model = {models[0], models[1]}, .curved = true, .own_frame = own}, scheme, {true, true});
        expect_error(c.name + ", " + scheme.name, step_error(c), bound);
        if (scheme == Scheme::characteristic) continue;
        make_reduced(c);
        expect_error(c.name + ", reduced, " + scheme.name, step_error(c), bound);
      }
}

TEST(monolithic_system, without_friction) {
  for (const bool force : {false, true}) {
    for (Case c : {halfspaces(8, 0.3, -2, scheme_of("godunov"), {force, false}),
                   random_bodies(6, true, scheme_of("godunov"), {force, false})}) {
      make_frictionless(c);
      expect_error(c.name + (force ? ", frictionless, load" : ", frictionless"), step_error(c), bound);
    }
  }
}

TEST(monolithic_system, reduced_unknowns) {
  for (const Scheme scheme : {scheme_of("godunov"), scheme_of("least_squares")})
    for (const Motions& motions : {Motions{}, Motions{true, true}})
      for (Case c : {halfspaces(8, 0.3, -2, scheme, motions), halfspaces(8, 0.3, 0.1, scheme, motions),
                     random_bodies(6, false, scheme, motions), random_bodies(6, true, scheme, motions)}) {
        make_reduced(c);
        expect_error(c.name + ", reduced, " + scheme.name + (motions.creep_by_force ? ", forces" : ""), step_error(c),
                     bound);
      }
}

constexpr Preconditioner preconditioners[] = {Preconditioner::none, Preconditioner::diagonal,
                                              Preconditioner::automatic};

const char* name_of(Preconditioner p) {
  return p == Preconditioner::none ? "none" : p == Preconditioner::diagonal ? "diagonal" : "factors";
}

/// Takes steps one after the other, the last with other states and laws, in the way of Newton's iteration.
double gmres_error(Case c, const StepOptions& options, StepCounters& counters) {
  const Problem problem = options.monolithic ? written_out(c) : c.problem;
  StepSystem system(problem, *c.frame, *c.compliance, options);
  Point next;
  double worst = 0;
  for (int i = 0; i < 2; ++i) {
    Point z = c.z;
    system.update(z);
    if (!system.solve(c.step, z, 1e-13, next)) return INFINITY;
    worst = std::max(worst, difference(c, next, condensed_step(c)));
    shift_states(c);
  }
  counters = system.counters();
  return worst;
}

TEST(monolithic_system_long, gmres_with_every_preconditioner) {
  for (const int form : {0, 1, 2})
    for (const Case& standard : {halfspaces(8, 0.3, -2, scheme_of("godunov"), {true, true}),
                                 meshed({.model = {Model::fem, Model::fem}}, scheme_of("least_squares"), {true, true}),
                                 meshed({.model = {Model::fem, Model::bem}}, scheme_of("godunov"), {true, true}),
                                 random_bodies(6, true, scheme_of("godunov"), {true, true})})
      for (const Preconditioner p : preconditioners) {
        Case c = standard;
        if (form == 1) make_reduced(c);
        if (form == 2) make_frictionless(c);
        for (const bool whole : {true, false}) {
          StepOptions options = monolithic(c, LinearMethod::gmres, p);
          options.monolithic = whole;
          StepCounters counters;
          const double error = gmres_error(c, options, counters);
          const char* forms[] = {", ", ", reduced, ", ", frictionless, "};
          expect_error(c.name + (whole ? "" : ", condensed") + forms[form] + name_of(p) + ", " +
                           std::to_string(counters.iterations) + " iterations",
                       error, 1e-8);
          EXPECT_GT(counters.iterations, 0);
          // The solution converged without help if factors are those that the preconditioner is made of.
          const bool plain = p != Preconditioner::automatic;
          EXPECT_LE(counters.factorizations, plain && !whole ? 0 : plain ? 2 : 4);
        }
      }
}

TEST(monolithic_system, looser_tolerance_takes_fewer_iterations) {
  const Case c = meshed({.model = {Model::fem, Model::fem}}, scheme_of("godunov"), {true, false});
  const Point exact = condensed_step(c);
  std::int64_t last = 0;
  for (const double eta : {0.1, 1e-4, 1e-8}) {
    const Problem problem = written_out(c);
    StepSystem system(problem, *c.frame, *c.compliance, monolithic(c, LinearMethod::gmres, Preconditioner::bodies));
    Point z = c.z, next;
    system.update(z);
    ASSERT_TRUE(system.solve(c.step, z, eta, next));
    const std::int64_t iterations = system.counters().iterations;
    std::printf("eta %.0e: %lld iterations, error %.1e\n", eta, static_cast<long long>(iterations),
                difference(c, next, exact));
    EXPECT_GT(iterations, last);
    EXPECT_LT(difference(c, next, exact), 100 * eta);
    last = iterations;
  }
}

TEST(monolithic_system, units_change_nothing) {
  for (const LinearMethod solver : {LinearMethod::lu, LinearMethod::gmres})
    for (const auto& models : {pairs[3], pairs[4]}) {
      Point solution[2];
      std::int64_t iterations[2];
      constexpr double millimetre = 1e3, megapascal = 1e-6;
      for (int i = 0; i < 2; ++i) {
        const Case c = meshed(
            {.model = {models[0], models[1]}, .length = i == 0 ? 1 : millimetre, .stress = i == 0 ? 1 : megapascal},
            scheme_of("godunov"), {true, true});
        const Problem problem = written_out(c);
        StepSystem system(problem, *c.frame, *c.compliance, monolithic(c, solver, Preconditioner::bodies));
        Point z = c.z;
        system.update(z);
        ASSERT_TRUE(system.solve(c.step, z, 1e-8, solution[i]));
        iterations[i] = system.counters().iterations;
      }
      double worst = 0, scale = 0;
      for (int i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < solution[0].lambda[i].size(); ++k) {
          const double one = solution[0].lambda[i][k], other = solution[1].lambda[i][k] / megapascal;
          worst = std::max(worst, std::abs(one - other));
          scale = std::max(scale, std::abs(one));
        }
      EXPECT_EQ(iterations[0], iterations[1]);
      // Boundary integrals are cut off at one relative accuracy, rounding aside.
      expect_error(solver == LinearMethod::lu ? "LU, other units" : "GMRES, other units", worst / scale, 1e-6);
    }
}

TEST(monolithic_system, update_gives_displacements_and_slip_of_tractions) {
  for (const Tangential tangential : {Tangential::slip, Tangential::shift})
    for (const Scheme scheme : schemes) {
      if (tangential == Tangential::shift && scheme == Scheme::characteristic) continue;
      Case c = meshed({.model = {Model::fem, Model::bem}}, scheme, {});
      c.tangential = tangential;
      const Problem problem = written_out(c);
      StepSystem system(problem, *c.frame, *c.compliance, monolithic(c));
      Point z = c.z;
      const Point expected = image_of(c, c.z);
      system.update(z);
      expect_error(std::string("update, ") + scheme.name, difference(c, z, expected), bound);
      for (auto& v : z.lambda) std::fill(v.begin(), v.end(), 0.0);
      system.update(z);
      EXPECT_EQ(*std::max_element(z.depth.begin(), z.depth.end()), 0);
    }
}

TEST(monolithic_system, says_when_nothing_carries_the_load) {
  Case c = halfspaces(6, 0.3, -2, scheme_of("godunov"), {true, false});
  for (PairState& state : c.step.state)
    if (state != PairState::unused) state = PairState::open;
  Point z = c.z, next;
  StepSystem system(c.problem, *c.frame, *c.compliance, monolithic(c));
  system.update(z);
  EXPECT_FALSE(system.solve(c.step, z, 1e-8, next));
}

TEST(monolithic_system, says_when_no_creepage_is_determined) {
  // Sliding pairs of the reduced form do not feel the creepages.
  Case c = meshed({.model = {Model::fem, Model::rigid}}, scheme_of("godunov"), {true, true});
  make_reduced(c);
  for (std::size_t k = 0; k < c.step.state.size(); ++k)
    if (c.step.state[k] == PairState::stick) c.step.state[k] = PairState::open;
  for (const LinearMethod solver : {LinearMethod::lu, LinearMethod::gmres}) {
    Point z = c.z, next;
    StepSystem system(c.problem, *c.frame, *c.compliance, monolithic(c, solver, Preconditioner::bodies));
    system.update(z);
    EXPECT_FALSE(system.solve(c.step, z, 1e-8, next));
  }
}

}  // namespace
}  // namespace rollcon
