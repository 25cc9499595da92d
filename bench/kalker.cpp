// Measures Kalker's coefficients over axis ratio and Poisson's ratio, and the creep-force curve.

#include <array>
#include <cmath>
#include <cstdio>

#include "bench.hpp"
#include "support/graded_disc.hpp"
#include "support/linear_theory.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Hertz;
using scenes::RollingPair;

constexpr const char* scheme = "characteristic";

void coefficients(Runner& runner) {
  namespace linear = scenes::linear_theory;
  const int rings = runner.quick ? 7 : 9;
  for (double ratio : {0.2, 0.5, 1.0, 2.0, 5.0})
    for (double nu : {0.0, 0.25, 0.5}) {
      const closed_forms::Elastic body{.shear = 82000, .poisson = nu};
      const Hertz hertz = linear::ellipse(ratio, body);
      const linear::Coefficients table = linear::table(ratio, nu);
      const linear::Motions motions(table, hertz, body, 0.006);
      double began = now();
      RollingPair pair(body, body, runner.threads);
      pair.frame(scenes::graded_disc(hertz.a, hertz.b, rings, ElementType::tri6));
      pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(linear::mu);
      pair.option("convection", scheme);
      std::array<scenes::RollingAnswer, 3> found;
      std::array<Record, 3> record;
      for (std::size_t k = 0; k < 3; ++k) {
        const linear::Motion& motion = motions.all[k];
        record[k] = {.case_name = "kalker", .method = scheme, .model = "half-spaces"};
        char name[60];
        std::snprintf(name, sizeof name, "tri6 rings %d, a/b = %g, nu = %g", rings, ratio, nu);
        record[k].mesh = name;
        record[k].threads = runner.threads;
        record[k].quantity = motion.name;
        record[k].against = "Kalker's table (three digits)";
        pair.creep(motion.creep[0], motion.creep[1], motion.creep[2]);
        found[k] = motions.found(timed_solve(pair, record[k], began));
        began = now();
        record[k].judge(scenes::rolling_errors(found[k], motions.exact(motion, table)));
      }
      const linear::Coefficients c = motions.coefficients(found);
      const double main[] = {c.c11, c.c22, c.c23};
      for (std::size_t k = 0; k < 3; ++k) {
        record[k].value = main[k];
        record[k].extra = {{"a_over_b", ratio}, {"nu", nu}};
        if (k == 1) record[k].extra.emplace_back("C32", c.c32);
        if (k == 2) record[k].extra.emplace_back("C33", c.c33);
        runner.emit(record[k]);
      }
    }
}

void creep_curve(Runner& runner) {
  const closed_forms::Elastic steel{.shear = 82000, .poisson = 0.28};
  const double mu = 0.33;
  const Hertz hertz =
      closed_forms::hertz_from_load(.0008, .0002814173138, closed_forms::effective_modulus(steel, steel), 106700);
  double began = now();
  RollingPair pair(steel, steel, runner.threads);
  pair.frame(scenes::graded_disc(hertz.a, hertz.b, runner.quick ? 8 : 14));
  pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(mu);
  pair.option("convection", scheme);
  for (const auto& point : closed_forms::creep_curve()) {
    Record record{.case_name = "creep_curve", .method = scheme, .model = "half-spaces"};
    record.mesh = "rings";
    record.threads = runner.threads;
    pair.creep(-point.xi, 0, 0);
    const auto s = timed_solve(pair, record, began);
    began = now();
    record.quantity = "F/(mu P)";
    const auto found = scenes::found_forces(s, mu * hertz.load, std::sqrt(hertz.a * hertz.b));
    record.judge(scenes::rolling_errors(found, {{point.force_ratio, 0}, 0}));
    record.value = found.force[0];
    record.against = "CONTACT, grid 44 x 48; zeros by symmetry";
    record.extra = {{"xi", point.xi}, {"contact", point.force_ratio}};
    runner.emit(record);
  }
}

}  // namespace

std::vector<Case> kalker_cases() {
  return {{"kalker", "creepage coefficients of linear theory", coefficients},
          {"creep_curve", "longitudinal creepage from stick to slip", creep_curve}};
}

}  // namespace rollcon::bench
