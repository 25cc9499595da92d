#include "bodies/halfspace/lattice_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/halfspace/halfspace_kernel.hpp"
#include "support/error.hpp"
#include "support/frames.hpp"

namespace rollcon {
namespace {

using namespace halfspace;

struct Integrals {
  std::vector<double> value[integral_count];
};

Integrals row(const LatticeIntegrals& lattice, std::int64_t j, std::int64_t first, std::int64_t count) {
  Integrals out;
  double* pointer[integral_count];
  for (int k = 0; k < integral_count; ++k) {
    out.value[k].assign(static_cast<std::size_t>(count), 0.0);
    pointer[k] = out.value[k].data();
  }
  lattice.row(j, first, count, pointer);
  return out;
}

/// Rows are compared at these offsets, in cells.
const int samples[] = {-80, -40, -21, -13, -8, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 6, 10, 30, 79};
constexpr int reach = 80;

struct Kind {
  Hat x, y;
  int at_x, at_y;  ///< node of a frame of 8 x 8 cells with this hat
};
const Kind kinds[] = {
    {Hat::whole, Hat::whole, 4, 4},  {Hat::after, Hat::whole, 0, 4},  {Hat::before, Hat::whole, 8, 4},
    {Hat::whole, Hat::after, 4, 0},  {Hat::whole, Hat::before, 4, 8}, {Hat::after, Hat::after, 0, 0},
    {Hat::before, Hat::after, 8, 0}, {Hat::after, Hat::before, 0, 8}, {Hat::before, Hat::before, 8, 8}};

/// Returns the largest difference over the largest integral; the compliance of a frame gives the five integrals when
/// its constants pick them out.
double error_against_compliance(double dx, double dy, double shift_x, double shift_y) {
  const Frame frame = build_frame(
      frames::rectangle(ElementType::quad4, frames::uniform_lines(0, 8 * dx, 8), frames::uniform_lines(0, 8 * dy, 8)),
      Axes{});
  std::vector<double> px, py;
  for (const int j : samples)
    for (const int i : samples) {
      px.push_back((4 + i) * dx + shift_x);
      py.push_back((4 + j) * dy + shift_y);
    }
  const auto nodes = static_cast<std::size_t>(frame.nodes());
  std::vector<double> block[3][3];
  ComplianceBlock out;
  out.stride = frame.nodes();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      block[r][c].resize(px.size() * nodes);
      out.a[r][c] = block[r][c].data();
    }
  make_halfspace_compliance(frame, {0, 1, 1}, 1e-13, 1)->block({px, py}, out);
  double worst = 0;
  for (const Kind& kind : kinds) {
    const LatticeIntegrals lattice({dx, dy, kind.x, kind.y}, shift_x, shift_y, all_terms, {reach + 8, reach + 8});
    std::size_t node = nodes;
    for (std::size_t k = 0; k < nodes; ++k)
      if (std::abs(frame.x[k] - kind.at_x * dx) < 1e-9 * dx && std::abs(frame.y[k] - kind.at_y * dy) < 1e-9 * dy)
        node = k;
    EXPECT_LT(node, nodes);
    double largest = 0, error = 0;
    std::size_t p = 0;
    for (const int j : samples) {
      const Integrals value = row(lattice, j + 4 - kind.at_y, -reach + 4 - kind.at_x, 2 * reach + 1);
      for (const int i : samples) {
        const std::size_t at = p++ * nodes + node;
        const double expected[] = {block[0][0][at] + block[1][1][at], block[0][0][at], block[0][1][at], block[0][2][at],
                                   block[1][2][at]};
        for (int k = 0; k < integral_count; ++k) {
          const double found = value.value[k][static_cast<std::size_t>(i + reach)];
          largest = std::max(largest, std::abs(expected[k]));
          error = std::max(error, std::abs(found - expected[k]));
        }
      }
    }
    worst = std::max(worst, error / largest);
  }
  std::printf("dx/dy %g, shift %g %g: error %.2e\n", dx / dy, shift_x / dx, shift_y / dy, worst);
  return worst;
}

TEST(LatticeKernel, EqualsTheComplianceOfTheSameFrame) {
  constexpr double bound = 5e-14;
  std::printf("bound %.0e\n", bound);
  EXPECT_LT(error_against_compliance(1, 1, 0, 0), bound);
  EXPECT_LT(error_against_compliance(0.5, 0.5, 0.3, 0), bound);
  EXPECT_LT(error_against_compliance(1, 2, 0.6, 0.1), bound);
  EXPECT_LT(error_against_compliance(0.3, 0.1, -0.05, 0.02), bound);
  EXPECT_LT(error_against_compliance(1, 1, 2.4, -1.7), bound);
  EXPECT_LT(error_against_compliance(1e-4, 1e-4, 1e-10, 0), bound);
  EXPECT_LT(error_against_compliance(5, 0.1, 0, 0), bound);
  EXPECT_LT(error_against_compliance(5, 0.1, 3, 0), bound);
  EXPECT_LT(error_against_compliance(0.1, 5, 0.06, 0), bound);
}

// Antiderivatives in both directions lose digits with the square of the sides' ratio.
TEST(LatticeKernel, SlenderCellsLoseNoDigits) {
  constexpr double bound = 1e-12;  // the compliance's own rounding grows with the ratio
  std::printf("bound %.0e\n", bound);
  for (const double ratio : {1e3, 1e-3, 1e4}) {
    EXPECT_LT(error_against_compliance(ratio, 1, 0, 0), bound);
    EXPECT_LT(error_against_compliance(ratio, 1, 0.6 * ratio, 0), bound);
  }
}

TEST(LatticeKernel, WorkFollowsTheOffsetsAskedForNotTheCells) {
  // All offsets near the source would be some 1e15.
  for (const double ratio : {1e12, 1e-12}) {
    const LatticeIntegrals lattice({ratio, 1}, 0.3 * ratio, 0.1, all_terms, {20, 20});
    const Integrals value = row(lattice, 20, -20, 41);
    for (const double v : value.value[0]) EXPECT_GT(v, 0) << ratio;
    EXPECT_THROW(row(lattice, 21, -20, 41), Error);
    EXPECT_THROW(row(lattice, 0, -21, 41), Error);
  }
}

TEST(LatticeKernel, EveryInstructionSet) {
  const InstructionSet best = best_instruction_set();
  const LatticeIntegrals lattice({0.3, 0.2}, 0.1, 0, all_terms, {60, 60});
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    for (const std::int64_t j : {0, 3, 17, 60}) {
      const Integrals expected = row(lattice, j, -33, 79);
      force_instruction_set(set);
      const Integrals value = row(lattice, j, -33, 79);
      force_instruction_set(best);
      for (int k = 0; k < integral_count; ++k)
        for (std::size_t m = 0; m < 79; ++m) EXPECT_NEAR(value.value[k][m], expected.value[k][m], 1e-15);
    }
}

TEST(LatticeKernel, IntegralsThatAreNotWantedAreLeftAlone) {
  const LatticeIntegrals all({0.3, 0.2}, 0.1, 0, all_terms, {60, 60});
  for (const int terms : {0, 1, 2}) {
    const LatticeIntegrals some({0.3, 0.2}, 0.1, 0, terms, {60, 60});
    for (const std::int64_t j : {0, 20}) {
      const Integrals expected = row(all, j, -30, 61), value = row(some, j, -30, 61);
      for (int k = 0; k < integral_count; ++k) {
        const bool wanted = k == 0 || (k < 3 ? (terms & with_shear) : (terms & with_coupling)) != 0;
        for (std::size_t m = 0; m < 61; ++m) EXPECT_NEAR(value.value[k][m], wanted ? expected.value[k][m] : 0, 1e-15);
      }
    }
  }
}

TEST(LatticeKernel, HatRulesIntegratePolynomials) {
  for (const Hat hat : {Hat::before, Hat::whole, Hat::after})
    for (int n = 1; n <= max_hat_points; ++n) {
      const LineRule rule = hat_rule(hat, n);
      ASSERT_EQ(rule.x.size(), static_cast<std::size_t>(n));
      for (int degree = 0; degree < 2 * n; ++degree) {
        double sum = 0;
        for (std::size_t q = 0; q < rule.x.size(); ++q) sum += rule.w[q] * std::pow(rule.x[q], degree);
        // The expected values are the integral of x^d (1 - x) on [0, 1], and that of its mirror image.
        const double half = 1.0 / ((degree + 1) * (degree + 2)), mirror = degree % 2 == 0 ? 1 : -1;
        const double expected = hat == Hat::after ? half : hat == Hat::before ? mirror * half : (1 + mirror) * half;
        EXPECT_NEAR(sum, expected, 1e-15) << n << " " << degree;
      }
    }
}

TEST(LatticeKernel, AComplianceHasIt) {
  const Frame frame = build_frame(
      frames::rectangle(ElementType::quad4, frames::uniform_lines(0, 1, 2), frames::uniform_lines(0, 1, 2)), Axes{});
  const auto kernel = make_halfspace_compliance(frame, {0.5, 0.25, -0.125}, 1e-6, 1)->translation();
  EXPECT_TRUE(kernel->couples());
  EXPECT_TRUE(kernel->shears());
  const auto [normal, along, across] = kernel->softness(2);
  EXPECT_DOUBLE_EQ(normal, 0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(along, normal);
  EXPECT_DOUBLE_EQ(across, 1.5 * normal);
}

}  // namespace
}  // namespace rollcon
