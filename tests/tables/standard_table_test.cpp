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

TEST(standard_table, beside_contacts) {
  const auto table = ForceTable::standard(std::make_shared<Context>());
  const Elastic steel{.shear = 82000, .poisson = 0.28};
  for (const double spin : {0.0, 2e-4, -6e-4})
    for (const double ratio : {0.2, 1.0, 4.0}) {
      const double a = 5 * std::sqrt(ratio), b = 5 / std::sqrt(ratio);
      const auto hertz = closed_forms::hertz_from_axes(a, b, 1000, closed_forms::effective_modulus(steel, steel));
      RollingPair pair(steel, steel);
      pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(0.3).creep(8e-4, 4e-4, spin);
      pair.option("frame_accuracy", 0.005);
      ASSERT_GE(pair.solve(), 0);
      const auto s = pair.solution();
      const double in[9] = {82000, 0.28, 0.3, a, b, hertz.load, 8e-4, 4e-4, spin};
      double f[3];
      table->evaluate(1, in, f, nullptr);
      const double bound = 0.3 * hertz.load;
      const std::string name = "a/b = " + std::to_string(ratio) + ", spin " + std::to_string(spin) + ": ";
      expect_error(name + "force", std::hypot(f[0] - s.force[0], f[1] - s.force[1]) / bound, 5e-3);
      expect_error(name + "moment", (f[2] - s.moment[2]) / (bound * 5), 5e-3);
    }
}

}  // namespace
}  // namespace rollcon
