#include "contact/operators/hierarchical/hierarchical_operator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "contact/lattice_case.hpp"
#include "support/graded_disc.hpp"

namespace rollcon {
namespace {

using Fields = std::vector<double>[3];

double largest(const std::vector<double>& v) {
  double m = 0;
  for (const double x : v) m = std::max(m, std::abs(x));
  return m;
}

struct Operands {
  Frame frame;
  Convection convection;
  std::unique_ptr<Compliance> compliance;

  Operands(const SurfaceMesh& mesh, const HalfspaceConstants& c, double accuracy,
           Scheme scheme = Scheme::characteristic)
      : frame(build_frame(mesh, Axes{})),
        convection(convection_of(frame, scheme)),
        compliance(make_halfspace_compliance(frame, c, accuracy, 1)) {}
};

/// Returns the largest error of slip and of normal displacements, over the largest of each.
std::array<double, 2> errors(const Operands& on, double accuracy, int threads = 1) {
  const HierarchicalOperator op(on.frame, *on.compliance, on.convection, true, accuracy, threads);
  DenseOperators dense;
  assemble_operators(on.frame, *on.compliance, on.convection, true, dense);
  const auto n = static_cast<std::size_t>(on.frame.nodes());
  frames::Random random(5);
  Fields lambda, found, exact;
  std::vector<std::int32_t> all;
  for (std::size_t k = 0; k < n; ++k) all.push_back(static_cast<std::int32_t>(k));
  for (int c = 0; c < 3; ++c) {
    lambda[c].resize(n), found[c].resize(n), exact[c].resize(n);
    for (double& l : lambda[c]) l = 1 + 0.3 * random();
  }
  op.images({}, {}, {}, lambda, found);
  dense.images({}, {}, all, lambda, exact);
  double error[3] = {};
  for (int r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < n; ++k) error[r] = std::max(error[r], std::abs(found[r][k] - exact[r][k]));
  const double slip = std::max(largest(exact[0]), largest(exact[1]));
  for (std::size_t k = 0; k < n; k += 7) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(op.own(r, c, k), dense.own(r, c, k), 1e-12 * slip);
    for (int r = 0; r < 2; ++r) EXPECT_NEAR(op.slip_norm(r, k), dense.slip_norm(r, k), 0.05 * dense.slip_norm(r, k));
  }
  return {std::max(error[0], error[1]) / slip, error[2] / largest(exact[2])};
}

SurfaceMesh irregular(ElementType type, int n) {
  const auto lines = frames::uniform_lines(-1, 1, n);
  const SurfaceMesh corners =
      frames::rectangle(type == ElementType::tri6 ? ElementType::tri3 : ElementType::quad4, lines, lines);
  const SurfaceMesh linear =
      frames::perturb(type == ElementType::tri3 ? frames::rectangle(type, lines, lines) : corners, 0.2, 3);
  return type == ElementType::tri3 || type == ElementType::quad4 ? linear : frames::to_quadratic(linear, type);
}

TEST(HierarchicalOperator, EqualsTheDenseOperators) {
  const auto expect = [](const char* name, const SurfaceMesh& mesh, Scheme scheme, const HalfspaceConstants& c) {
    const auto [slip, normal] = errors(Operands(mesh, c, 1e-6, scheme), 1e-6);
    std::printf("%-16s %-14s %6lld nodes: error of slip %.1e, bound 5e-6, of displacement %.1e, bound 1e-6\n", name,
                scheme.name, static_cast<long long>(mesh.nodes()), slip, normal);
    EXPECT_LT(slip, 5e-6) << name;
    EXPECT_GT(slip, 1e-12) << name << ": no two squares are far from each other";
    EXPECT_LT(normal, 1e-6) << name;
  };
  expect("tri3", irregular(ElementType::tri3, 28), Scheme::characteristic, unlike);
  for (const char* scheme : {"godunov", "least_squares"})
    expect("tri3", irregular(ElementType::tri3, 44), scheme_of(scheme), unlike);
  expect("tri3, alike", irregular(ElementType::tri3, 26), Scheme::characteristic, alike);
  expect("tri3, no shear", irregular(ElementType::tri3, 26), Scheme::characteristic, incompressible);
  expect("tri6", irregular(ElementType::tri6, 20), Scheme::characteristic, unlike);
  expect("quad8", irregular(ElementType::quad8, 22), Scheme::characteristic, unlike);
  expect("graded disc", scenes::graded_disc(1, 2, 14), Scheme::characteristic, unlike);
  expect("far from origin",
         frames::transform(irregular(ElementType::tri3, 28),
                           [](const Vec3& x) {
                             return Vec3{x[0] + 1000, x[1] - 300, x[2]};
                           }),
         Scheme::characteristic, alike);
}

TEST(HierarchicalOperator, ErrorsFallWithTheAccuracy) {
  const SurfaceMesh mesh = irregular(ElementType::tri3, 28);
  for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
    const auto [slip, normal] = errors(Operands(mesh, unlike, 1e-10), accuracy);
    std::printf("accuracy %.0e: error of slip %.1e, bound %.0e, of displacement %.1e\n", accuracy, slip, 5 * accuracy,
                normal);
    EXPECT_LT(slip, 5 * accuracy);
    EXPECT_GT(slip, 1e-12) << "no two squares are far from each other";
    EXPECT_LT(normal, accuracy);
  }
}

TEST(HierarchicalOperator, ThreadsDoNotChangeABit) {
  const Operands on(irregular(ElementType::tri3, 26), unlike, 1e-6);
  const auto one = errors(on, 1e-6, 1), three = errors(on, 1e-6, 3);
  EXPECT_EQ(one, three);
}

TEST(HierarchicalOperator, RowsThatAreAskedForDoNotDependOnOthers) {
  const Operands on(irregular(ElementType::tri3, 26), unlike, 1e-6);
  const HierarchicalOperator op(on.frame, *on.compliance, on.convection, true, 1e-6, 2);
  const auto n = static_cast<std::size_t>(on.frame.nodes());
  Fields lambda, all, some;
  for (int c = 0; c < 3; ++c) lambda[c].assign(n, 0), all[c].assign(n, 0), some[c].assign(n, 0);
  for (std::size_t k = 0; k < n / 5; ++k) lambda[0][k] = lambda[2][k] = 1;
  op.images({}, {}, {}, lambda, all);
  const std::vector<std::int32_t> asked{3, 400, static_cast<std::int32_t>(n) - 1};
  op.images({}, {}, asked, lambda, some);
  for (const std::int32_t k : asked)
    for (int r = 0; r < 3; ++r) EXPECT_EQ(some[r][static_cast<std::size_t>(k)], all[r][static_cast<std::size_t>(k)]);
}

TEST(HierarchicalOperator_long, MemoryGrowsWithTheNodes) {
  double before = 0;
  for (const int n : {50, 100, 200}) {
    const Operands on(irregular(ElementType::tri3, n), alike, 1e-6);
    const HierarchicalOperator op(on.frame, *on.compliance, on.convection, true, 1e-6, 2);
    const double per_node = static_cast<double>(op.bytes()) / static_cast<double>(on.frame.nodes());
    std::printf("%6lld nodes: %.0f bytes for each\n", static_cast<long long>(on.frame.nodes()), per_node);
    if (before > 0) {
      EXPECT_LT(per_node, 1.4 * before);
    }
    before = per_node;
  }
}

}  // namespace
}  // namespace rollcon
