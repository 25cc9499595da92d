// Tests shape functions of surface and of volume elements.

#include "mesh/shape.hpp"

#include "mesh/volume_shape.hpp"
#include "support/any_element.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Holds the functions at a point; surface elements do not use the third coordinate.
struct Functions {
  std::vector<double> value;
  std::vector<Vec3> d;
};

Functions functions_at(AnyElement type, const Vec3& x) {
  Functions f;
  if (const auto* volume = std::get_if<VolumeType>(&type)) {
    VolumeShape s;
    evaluate_shape(*volume, x, s);
    f.value.assign(s.value.begin(), s.value.begin() + node_count(*volume));
    f.d.assign(s.d.begin(), s.d.begin() + node_count(*volume));
  } else {
    const auto surface = std::get<ElementType>(type);
    Shape s;
    evaluate_shape(surface, x[0], x[1], s);
    for (std::size_t i = 0; i < static_cast<std::size_t>(node_count(surface)); ++i) {
      f.value.push_back(s.value[i]);
      f.d.push_back({s.d_xi[i], s.d_eta[i], 0});
    }
  }
  return f;
}

std::vector<Vec3> nodes_of(AnyElement type) {
  std::vector<Vec3> nodes;
  if (const auto* volume = std::get_if<VolumeType>(&type)) {
    const auto all = reference_nodes(*volume);
    nodes.assign(all.begin(), all.end());
  } else {
    for (const ReferencePoint& r : reference_nodes(std::get<ElementType>(type))) nodes.push_back({r.xi, r.eta, 0});
  }
  return nodes;
}

/// Returns random points of the reference element: triangles and tetrahedra have no negative coordinates, and a sum
/// below 1.
std::vector<Vec3> points_of(AnyElement type) {
  const int corners = std::visit([](auto t) { return corner_count(t); }, type);
  const std::size_t simplex = is_finite_element(type) ? (corners == 4   ? 3
                                                         : corners == 6 ? 2
                                                                        : 0)
                              : corners == 3          ? 2
                                                      : 0;
  frames::Random random(7);
  std::vector<Vec3> points;
  while (points.size() < 50) {
    Vec3 x{random(), random(), is_finite_element(type) ? random() : 0};
    double sum = 0;
    for (std::size_t c = 0; c < simplex; ++c) sum += x[c] = 0.5 * (1 + x[c]);
    if (sum <= 1) points.push_back(x);
  }
  return points;
}

class ShapeFunctions : public ::testing::TestWithParam<AnyElement> {};

TEST_P(ShapeFunctions, PartitionOfUnityAndZeroGradientSum) {
  double error = 0;
  for (const Vec3& x : points_of(GetParam())) {
    const Functions f = functions_at(GetParam(), x);
    double sum = -1;
    Vec3 gradient{0, 0, 0};
    for (std::size_t i = 0; i < f.value.size(); ++i) {
      sum += f.value[i];
      gradient = gradient + f.d[i];
    }
    error = std::max({error, std::abs(sum), length(gradient)});
  }
  expect_error("partition of unity", error, 1e-14);
}

TEST_P(ShapeFunctions, OneAtOwnNodeZeroAtOthers) {
  double error = 0;
  const auto nodes = nodes_of(GetParam());
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const Functions f = functions_at(GetParam(), nodes[j]);
    ASSERT_EQ(f.value.size(), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) error = std::max(error, std::abs(f.value[i] - (i == j ? 1 : 0)));
  }
  expect_error("nodal values", error, 1e-15);
}

TEST_P(ShapeFunctions, DerivativesMatchDifferences) {
  // Central differences are exact for degree 2 in each variable; what remains is rounding / h.
  const double h = 1e-4;
  double error = 0;
  for (const Vec3& x : points_of(GetParam())) {
    const Functions f = functions_at(GetParam(), x);
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 more = x, less = x;
      more[c] += h;
      less[c] -= h;
      const Functions a = functions_at(GetParam(), more), b = functions_at(GetParam(), less);
      for (std::size_t i = 0; i < f.value.size(); ++i)
        error = std::max(error, std::abs((a.value[i] - b.value[i]) / (2 * h) - f.d[i][c]));
    }
  }
  expect_error("derivatives against differences", error, 2e-11);
}

TEST_P(ShapeFunctions, ReproducePolynomials) {
  const bool quadratic = is_quadratic_element(GetParam());
  const auto field = [&](const Vec3& x) {
    const double linear = 1 - 2 * x[0] + 3 * x[1] + 0.7 * x[2];
    return quadratic ? linear + x[0] * x[0] - 2 * x[0] * x[1] + 0.5 * x[1] * x[1] + 0.3 * x[1] * x[2] - x[2] * x[2] +
                           1.5 * x[2] * x[0]
                     : linear;
  };
  double error = 0;
  const auto nodes = nodes_of(GetParam());
  for (const Vec3& x : points_of(GetParam())) {
    const Functions f = functions_at(GetParam(), x);
    double sum = -field(x);
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += f.value[i] * field(nodes[i]);
    error = std::max(error, std::abs(sum));
  }
  expect_error(quadratic ? "quadratic field" : "linear field", error, 3e-14);
}

INSTANTIATE_TEST_SUITE_P(All, ShapeFunctions, ::testing::ValuesIn(all_elements()),
                         [](const auto& param) { return name_of(param.param); });

}  // namespace
}  // namespace rollcon
