// Kalker's coefficients over axis ratio and Poisson's ratio, and the creep-force curve.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench.hpp"
#include "support/graded_disc.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Hertz;
using scenes::RollingPair;

constexpr const char* scheme = "characteristic";

void emit(Runner& runner, Record record, const std::string& what, double value, double reference,
          const std::string& against) {
  record.quantity = what;
  record.value = value;
  record.error = value / reference - 1;
  record.against = against;
  runner.emit(record);
}

void coefficients(Runner& runner) {
  const double mu = 0.3;
  const int rings = runner.quick ? 7 : 9;
  for (double ratio : {0.2, 0.5, 1.0, 2.0, 5.0})
    for (double nu : {0.0, 0.25, 0.5}) {
      const closed_forms::Elastic body{.shear = 82000, .poisson = nu};
      const Hertz hertz = closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000,
                                                        closed_forms::effective_modulus(body, body));
      const auto table = closed_forms::kalker_table(ratio, nu);
      const double unit = 0.006 * mu * hertz.load / body.shear;  // 0.6 % of mu P without slip
      double began = now();
      RollingPair pair(body, body, runner.threads);
      pair.frame(scenes::graded_disc(hertz.a, hertz.b, rings, ElementType::tri6));
      pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(mu);
      pair.option("convection", scheme);
      auto solve = [&](double xi, double eta, double phi, Record& record) {
        record = {.case_name = "kalker", .method = scheme, .model = "half-spaces"};
        char name[60];
        std::snprintf(name, sizeof name, "tri6 rings %d, a/b = %g, nu = %g", rings, ratio, nu);
        record.mesh = name;
        record.threads = runner.threads;
        pair.creep(xi, eta, phi);
        const auto s = timed_solve(pair, record, began);
        began = now();
        record.extra = {{"a_over_b", ratio}, {"nu", nu}};
        return s;
      };
      const double xi = unit / table.c11, eta = unit / table.c22;
      const double phi = unit / std::max(table.c23, table.c33);
      const std::string against = "Kalker's table (three digits)";
      Record record;
      auto s = solve(xi, 0, 0, record);
      emit(runner, record, "C11", -s.force[0] / (body.shear * xi), table.c11, against);
      s = solve(0, eta, 0, record);
      emit(runner, record, "C22", -s.force[1] / (body.shear * eta), table.c22, against);
      s = solve(0, 0, phi, record);
      emit(runner, record, "C23", -s.force[1] / (body.shear * phi), table.c23, against);
      emit(runner, record, "C33", -s.moment[2] / (body.shear * phi), table.c33, against);
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
    record.quantity = "F/(mu P), error in mu P";
    record.value = s.force[0] / (mu * hertz.load);
    record.error = record.value - point.force_ratio;
    record.against = "CONTACT, grid 44 x 48";
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
