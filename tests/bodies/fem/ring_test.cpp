// The ring of the paper's first example, of finite elements, under loads on a patch of its outer surface
// (support/loaded_ring.hpp).

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/loaded_ring_body.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

namespace loaded_ring = statics::loaded_ring;
using loaded_ring::Load;
using statics::StaticBody;
using validation::expect_error;
using validation::expect_order;
using validation::observed_order;

struct Case {
  VolumeType type;
  loaded_ring::Quarter elements;
  double bound;
};

std::vector<loaded_ring::ListedError> errors_of(const Case& c, Load kind, double poisson, std::int64_t& nodes) {
  StaticBody body(volumes::block(loaded_ring::quarter(c.elements), c.type), loaded_ring::young, poisson);
  nodes = body.mesh().nodes();
  loaded_ring::hold_quarter(body, kind);
  return loaded_ring::listed_errors(body, kind, poisson);
}

class FemPatchLoad : public ::testing::TestWithParam<Case> {};

TEST_P(FemPatchLoad, moves_the_ring_as_listed) {
  const Case& c = GetParam();
  for (const auto& [kind, poisson] : {std::pair{Load::normal, 0.3}, {Load::tangential, 0.3}, {Load::normal, 0.49}}) {
    if (corner_count(c.type) < 8 && !is_quadratic(c.type) && poisson > 0.45) continue;
    std::int64_t nodes = 0;
    for (const auto& [what, error] : errors_of(c, kind, poisson, nodes))
      expect_error(volumes::name_of(c.type) + " quarter ring, " + std::to_string(nodes) + " nodes, " + what, error,
                   c.bound);
  }
}

constexpr auto ring_type_name = [](const auto& param) { return volumes::name_of(param.param.type); };

// 2 % for hex8 and 0.5 % for hex20 are asked for.
INSTANTIATE_TEST_SUITE_P(Ring, FemPatchLoad,
                         ::testing::Values(Case{VolumeType::hex8, {8, 20, 6, 14}, 0.02},
                                           Case{VolumeType::hex20, {4, 10, 3, 8}, 0.005}),
                         ring_type_name);
INSTANTIATE_TEST_SUITE_P(Ring_long, FemPatchLoad,
                         ::testing::Values(Case{VolumeType::wedge6, {8, 20, 6, 14}, 0.02},
                                           Case{VolumeType::wedge15, {4, 10, 3, 8}, 0.008},
                                           Case{VolumeType::tet4, {10, 20, 6, 14}, 0.1},
                                           Case{VolumeType::tet10, {6, 12, 3, 10}, 0.02}),
                         ring_type_name);

// Orders from the root mean square of all listed errors; edges of the patch and of the ring limit those of quadratic
// elements.
TEST(FemRing_long, refinement) {
  for (const VolumeType type : {VolumeType::hex8, VolumeType::hex20}) {
    const bool quadratic = is_quadratic(type);
    double error[2] = {};
    for (const int level : {0, 1}) {
      const int f = (quadratic ? 1 : 2) << level;
      std::int64_t nodes = 0;
      const auto errors = errors_of({type, {2 * f, 5 * f, 3 * f, 4 * f}, 0}, Load::normal, 0.3, nodes);
      for (const auto& e : errors) error[level] += e.error * e.error / static_cast<double>(errors.size());
      error[level] = std::sqrt(error[level]);
      validation::report(volumes::name_of(type) + " ring, " + std::to_string(nodes) + " nodes: mean error",
                         error[level]);
    }
    expect_order(volumes::name_of(type) + " ring", observed_order(error[0], error[1], 2, 1), quadratic ? 1.7 : 1.2);
  }
}

}  // namespace
}  // namespace rollcon
