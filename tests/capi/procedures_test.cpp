/// Tests options of the solution procedures: what is refused, and that every other combination answers like the
/// standard one, in whatever order and units they come.

#include <iterator>

#include "procedures_fixture.hpp"

using namespace capi_test;

namespace {

struct Setting {
  const char *name, *value;
};

struct Senseless {
  std::vector<Setting> set;        ///< "procedure" has its options
  std::vector<std::string> words;  ///< words of the message: the option and the reason
};

const Senseless senseless[] = {
    {{{"procedure", "slip_estimate=jacobi"}}, {"slip_estimate", "'jacobi'", "jacobian", "reduced"}},
    {{{"procedure", "slip_estimate=extrapolation jacobian=b_derivative"}},
     {"slip_estimate", "'extrapolation'", "'b_derivative'", "reduced"}},
    {{{"procedure", "slip_estimate=pseudo_temporal jacobian=simplified system=monolithic"}},
     {"slip_estimate", "'pseudo_temporal'", "'simplified'", "reduced"}},
    {{{"procedure", "jacobian=reduced"}, {"convection", "characteristic"}},
     {"jacobian", "'reduced'", "convection", "'characteristic'", "godunov", "least_squares"}},
    {{{"procedure", "jacobian=reduced system=monolithic"}, {"convection", "characteristic"}},
     {"jacobian", "'reduced'", "convection", "'characteristic'"}},
    {{{"preconditioner", "bodies"}, {"linear_solver", "gmres"}},
     {"preconditioner", "'bodies'", "system", "'condensed'"}},
    {{{"procedure", "system=monolithic"}, {"preconditioner", "bodies"}, {"linear_solver", "lu"}},
     {"preconditioner", "'bodies'", "linear_solver", "'lu'", "gmres"}},
    {{{"procedure", "system=monolithic"}, {"preconditioner", "kept_lu"}, {"linear_solver", "gmres"}},
     {"preconditioner", "'kept_lu'", "system", "'monolithic'", "bodies"}},
    {{{"preconditioner", "none"}}, {"preconditioner", "'none'", "linear_solver", "'auto'"}},
    {{{"preconditioner", "diagonal"}, {"linear_solver", "lu"}},
     {"preconditioner", "'diagonal'", "linear_solver", "'lu'", "gmres"}},
    {{{"preconditioner", "none"}, {"linear_solver", "gmres"}}, {"preconditioner", "'none'", "jacobian", "'exact'"}},
    {{{"procedure", "line_search=armijo"}}, {"line_search", "'armijo'", "jacobian", "'exact'"}},
    {{{"procedure", "line_search=off"}}, {"line_search", "'off'", "jacobian", "'exact'"}},
};

const char* const texts[] = {"linear_solver", "preconditioner", "convection"};

}  // namespace

class procedures : public ProcedureScene {
 protected:
  std::string text(const char* name) const {
    char value[64];
    EXPECT_EQ(rollcon_contact_get_str(contact, name, sizeof value, value, nullptr), ROLLCON_OK);
    return value;
  }
};
using procedures_long = procedures;

TEST_F(procedures, combinations_without_sense_are_refused_with_the_reason) {
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK) << error();
  const Results reference = results();
  std::vector<std::string> before;
  for (const char* name : texts) before.push_back(text(name));
  for (const Senseless& s : senseless) {
    std::string what;
    for (const Setting& option : s.set) {
      set(option.name, option.value);
      what += std::string(option.name) + "=" + option.value + " ";
    }
    SCOPED_TRACE(what);
    EXPECT_FAILS(rollcon_contact_solve(contact), OPTION, "'");
    for (const std::string& word : s.words)
      EXPECT_NE(error().find(word), std::string::npos) << "'" << word << "' in: " << error();
    double t[3];
    EXPECT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, t, nullptr), ROLLCON_ERR_STATE)
        << "a failed solve discards the last solution";
    set("procedure", "");
    for (std::size_t i = 0; i < std::size(texts); ++i) set(texts[i], before[i].c_str());
    ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK) << error();
    EXPECT_LT(difference(results().traction, reference.traction), 1e-8);
  }
}

TEST_F(procedures, unknown_words_are_refused_and_change_nothing) {
  set("procedure", "system=monolithic");
  EXPECT_FAILS(rollcon_contact_set_procedure(contact, "monolithic"), OPTION, "'monolithic'", "system=monolithic");
  EXPECT_FAILS(rollcon_contact_set_procedure(contact, "system=other"), OPTION, "system", "'other'", "condensed");
  EXPECT_FAILS(rollcon_contact_set_procedure(contact, "jacobian=exact tolerance=1"), OPTION, "'tolerance'", "jacobian");
  EXPECT_FAILS(rollcon_contact_set_procedure(contact, nullptr), ARGUMENT, "procedure is NULL");
  EXPECT_FAILS(rollcon_contact_set_str(contact, "system", "condensed"), OPTION, "'system'");
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  char plan[8192];
  ASSERT_EQ(rollcon_contact_get_plan(contact, sizeof plan, plan, nullptr), ROLLCON_OK);
  EXPECT_NE(std::string(plan).find("monolithic"), std::string::npos) << plan;
}

TEST_F(procedures, a_tolerance_needs_gmres) {
  set("linear_tolerance", 1e-3);
  for (const char* solver : {"auto", "lu"}) {
    set("linear_solver", solver);
    EXPECT_FAILS(rollcon_contact_solve(contact), OPTION, "linear_tolerance", "0.001", "linear_solver", "gmres");
  }
  set("linear_solver", "gmres");
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  set("linear_tolerance", 0.0);
  set("linear_solver", "auto");
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
}

TEST_F(procedures, line_searches_belong_to_the_published_ones) {
  const Results reference = standard();
  double worst = 0;
  for (const char* search : {"auto", "armijo", "off"})
    for (const char* system : {"condensed", "monolithic"})
      for (const char* jacobian : {"exact", "b_derivative", "simplified", "reduced"}) {
        const bool own = std::string(system) == "condensed" && std::string(jacobian) == "exact";
        const std::string procedure =
            std::string("system=") + system + " jacobian=" + jacobian + " line_search=" + (own ? "auto" : search);
        set("procedure", procedure.c_str());
        ASSERT_EQ(solve_cold(), ROLLCON_OK) << procedure;
        worst = std::max(worst, difference(results().traction, reference.traction));
      }
  std::printf("line searches: tractions differ by %.1e (bound 1e-6)\n", worst);
  EXPECT_LE(worst, 1e-6);
}

TEST_F(procedures, tolerances_do_not_change_the_answer) {
  const Results reference = standard();
  struct Case {
    const char *jacobian, *slip_estimate, *linear_solver, *name;
    double value;
  };
  double worst = 0;
  for (const Case& c : {Case{"b_derivative", "auto", "gmres", "linear_tolerance", 1e-1},
                        Case{"b_derivative", "auto", "gmres", "linear_tolerance", 1e-8},
                        Case{"b_derivative", "auto", "gmres_adaptive", "linear_tolerance", 0.9},
                        Case{"exact", "auto", "gmres_adaptive", "linear_tolerance", 0.9},
                        Case{"simplified", "auto", "gmres_adaptive", "linear_tolerance", 0.1}})
    for (const char* system : {"condensed", "monolithic"}) {
      double before = 0;
      ASSERT_EQ(rollcon_contact_get_real(contact, c.name, &before), ROLLCON_OK);
      set(Procedure{system, c.jacobian, c.slip_estimate, c.linear_solver});
      set(c.name, c.value);
      EXPECT_EQ(solve_cold(), ROLLCON_OK) << system << " " << c.jacobian << " " << c.name;
      const Results r = results();
      const double error = difference(r.traction, reference.traction);
      std::printf("%-10s %-12s %-22s %5g: %3.0f iterations, error %.1e (bound 1e-6)\n", system, c.jacobian, c.name,
                  c.value, r.iterations, error);
      worst = std::max(worst, error);
      EXPECT_LE(error, 1e-6);
      set(c.name, before);
    }
}

TEST_F(procedures_long, give_the_results_of_the_standard_one) {
  for (const bool force : {false, true}) {
    if (force) {
      by_force(ROLLCON_NORMAL, 280);
      by_force(ROLLCON_LONGITUDINAL, 12);
    }
    const Results reference = standard();
    double worst = 0, worst_law = 0;
    for (const Procedure& p : all_procedures()) {
      SCOPED_TRACE(p.name());
      set(p);
      ASSERT_EQ(solve_cold(), ROLLCON_OK) << error();
      const Results r = results();
      EXPECT_EQ(r.state, reference.state);
      const double motion =
          std::max({std::abs(r.approach / reference.approach - 1), std::abs(r.creep[0] / reference.creep[0] - 1),
                    std::abs(r.force[2] / reference.force[2] - 1), std::abs(r.force[0] / reference.force[0] - 1),
                    std::abs(r.moment[2] / reference.moment[2] - 1)});
      const double error = std::max({difference(r.traction, reference.traction), difference(r.gap, reference.gap),
                                     difference(r.slip, reference.slip), motion});
      EXPECT_LE(error, 1e-6);
      EXPECT_LE(r.law, 1e-6);
      worst = std::max(worst, error);
      worst_law = std::max(worst_law, r.law);
    }
    std::printf("%s: tractions, gap, slip, motions differ by %.1e (bound 1e-6), laws %.1e\n",
                force ? "forces given" : "motions given", worst, worst_law);
  }
}

TEST_F(procedures, switching_warm_and_cold_changes_nothing) {
  const Results reference = standard();
  std::vector<Procedure> all = all_procedures();
  // Neighbouring procedures have as little in common as possible.
  std::vector<Procedure> mixed;
  for (std::size_t i = 0; i < all.size(); ++i) mixed.push_back(all[(i * 11) % all.size()]);
  double worst = 0;
  for (const Procedure& p : mixed) {
    SCOPED_TRACE(p.name());
    set(p);
    ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK) << error();
    const Results warm = results();
    EXPECT_LE(warm.iterations, 30) << "from the solution itself";
    ASSERT_EQ(solve_cold(), ROLLCON_OK) << error();
    worst = std::max(
        {worst, difference(warm.traction, reference.traction), difference(results().traction, reference.traction)});
  }
  set(Procedure{});
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  worst = std::max(worst, difference(results().traction, reference.traction));
  std::printf("switching: tractions differ by %.1e (bound 1e-6)\n", worst);
  EXPECT_LE(worst, 1e-6);
}

TEST_F(procedures_long, changed_creepages_start_from_the_last_solution) {
  const double creep[2][3] = {{-8e-4, 4e-4, 2e-4}, {-1.1e-3, 3e-4, 1e-4}};
  Results reference[2];
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(rollcon_contact_set_creep(contact, creep[i][0], creep[i][1], creep[i][2]), ROLLCON_OK);
    reference[i] = standard();
  }
  double worst = 0;
  for (const Procedure& p : all_procedures()) {
    SCOPED_TRACE(p.name());
    set(p);
    for (int i = 0; i < 4; ++i) {
      const auto& c = creep[i % 2];
      ASSERT_EQ(rollcon_contact_set_creep(contact, c[0], c[1], c[2]), ROLLCON_OK);
      ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK) << error();
      const double error = difference(results().traction, reference[i % 2].traction);
      EXPECT_LE(error, 1e-6);
      worst = std::max(worst, error);
    }
  }
  std::printf("warm re-solves: tractions differ by %.1e (bound 1e-6)\n", worst);
}

TEST_F(procedures_long, units_do_not_matter) {
  // The scene is solved in metres and pascals, and in millimetres and megapascals.
  rollcon_body* ball = nullptr;
  rollcon_contact* metric = nullptr;
  ASSERT_EQ(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &ball), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_set_elastic(ball, 0, 1e10, 0.3), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_create(context, ball, plane, &metric), ROLLCON_OK);
  const SquareFrame in_mm = frame;
  for (const bool force : {false, true}) {
    double worst = 0;
    for (const Procedure& p : all_procedures()) {
      SCOPED_TRACE(p.name());
      Results r[2];
      for (int unit = 0; unit < 2; ++unit) {
        const double m = unit == 0 ? 1 : 1e-3;
        frame = in_mm;
        for (double& x : frame.x) x *= m;
        if (unit == 1) std::swap(contact, metric);
        set_scene();
        ASSERT_EQ(rollcon_contact_set_gap_quadratic(contact, 0.01 / m, 0.01 / m, 0), ROLLCON_OK);
        ASSERT_EQ(rollcon_contact_set_rolling(contact, 10 * m), ROLLCON_OK);
        set("convection", "godunov");
        by_motion(ROLLCON_NORMAL, 0.02 * m);
        ASSERT_EQ(rollcon_contact_set_creep(contact, -8e-4, 4e-4, 2e-4 / m), ROLLCON_OK);
        by_motion(ROLLCON_LONGITUDINAL, -8e-4);
        if (force) {
          by_force(ROLLCON_NORMAL, 280);
          by_force(ROLLCON_LONGITUDINAL, 12);
        }
        set(p);
        ASSERT_EQ(solve_cold(), ROLLCON_OK) << error();
        r[unit] = results();
        if (unit == 1) std::swap(contact, metric);
      }
      for (double& t : r[1].traction) t *= 1e-6;
      for (double& g : r[1].gap) g *= 1e3;
      for (double& s : r[1].slip) s *= 1e3;
      EXPECT_EQ(r[0].iterations, r[1].iterations);
      const double error = std::max(
          {difference(r[1].traction, r[0].traction), difference(r[1].gap, r[0].gap), difference(r[1].slip, r[0].slip)});
      EXPECT_LE(error, 1e-9);
      worst = std::max(worst, error);
    }
    std::printf("units: results differ by %.1e (bound 1e-9)\n", worst);
  }
  rollcon_contact_release(metric);
  rollcon_body_release(ball);
}
