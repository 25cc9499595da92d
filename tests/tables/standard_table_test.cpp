/// Compares the table that comes with the library with contacts.

#include <cmath>
#include <memory>
#include <string>

#include "support/context.hpp"
#include "support/error.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"
#include "tables/force_table.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;

TEST(standard_table, results_that_are_no_numbers_are_errors) {
  const auto table = ForceTable::standard(std::make_shared<Context>());
  double input[9] = {8e4, 0.28, 0.3, 1, 1, 100, 1e308, 0, 0}, force[3];
  try {
    table->evaluate(1, input, force, nullptr);
    FAIL() << force[0];
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_nonfinite) << error.what();
  }
  input[6] = 1;
  table->evaluate(1, input, force, nullptr);
  EXPECT_NEAR(std::abs(force[0]), 30, 0.1);
}

struct Beside {
  double poisson, ratio, spin, longitudinal = 8e-4;
};

/// Compares the table with a contact on the library's frame.
void compare(const ForceTable& table, const Beside& c) {
  const Elastic steel{.shear = 82000, .poisson = c.poisson};
  const double a = 5 * std::sqrt(c.ratio), b = 5 / std::sqrt(c.ratio);
  const auto hertz = closed_forms::hertz_from_axes(a, b, 1000, closed_forms::effective_modulus(steel, steel));
  RollingPair pair(steel, steel);
  pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(0.3).creep(c.longitudinal, 4e-4, c.spin);
  pair.option("frame_accuracy", 0.005);
  ASSERT_GE(pair.solve(), 0);
  const auto s = pair.solution();
  const double in[9] = {82000, c.poisson, 0.3, a, b, hertz.load, c.longitudinal, 4e-4, c.spin};
  double f[3];
  table.evaluate(1, in, f, nullptr);
  const double bound = 0.3 * hertz.load;
  const std::string name = "nu " + std::to_string(c.poisson) + ", a/b = " + std::to_string(c.ratio) + ", spin " +
                           std::to_string(c.spin) + ": ";
  expect_error(name + "force", std::hypot(f[0] - s.force[0], f[1] - s.force[1]) / bound, 5e-3);
  expect_error(name + "moment", (f[2] - s.moment[2]) / (bound * 5), 5e-3);
}

TEST(standard_table, beside_contacts) {
  const auto table = ForceTable::standard(std::make_shared<Context>());
  for (const double spin : {0.0, 2e-4, -6e-4})
    for (const double ratio : {0.2, 1.0, 4.0}) compare(*table, {0.28, ratio, spin});
}

TEST(standard_table, beyond_its_ratios_of_poisson) {
  const auto table = ForceTable::standard(std::make_shared<Context>());
  for (const double poisson : {0.24, 0.25, 0.31, 0.34}) {
    compare(*table, {poisson, 0.5, 2e-4, 2e-4});
    compare(*table, {poisson, 4, -6e-4});
  }
}

}  // namespace
}  // namespace rollcon
