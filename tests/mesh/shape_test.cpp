#include "mesh/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/frames.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using validation::expect_error;

constexpr ElementType all_types[] = {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                     ElementType::quad9};

std::string named(const char* what, ElementType type) {
  return std::string(what) + ", type " + std::to_string(static_cast<int>(type));
}

/// Random points of the reference element.
std::vector<ReferencePoint> points(ElementType type) {
  frames::Random random(7);
  std::vector<ReferencePoint> p;
  for (int k = 0; k < 50; ++k) {
    double u = random(), v = random();
    if (corner_count(type) == 3) {
      u = 0.5 * (1 + u), v = 0.5 * (1 + v);
      if (u + v > 1) u = 1 - u, v = 1 - v;
    }
    p.push_back({u, v});
  }
  return p;
}

TEST(Shape, PartitionOfUnityAndZeroGradientSum) {
  for (ElementType type : all_types) {
    double error = 0;
    for (const auto& [u, v] : points(type)) {
      Shape s;
      evaluate_shape(type, u, v, s);
      double sum = -1, du = 0, dv = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(node_count(type)); ++i)
        sum += s.value[i], du += s.d_xi[i], dv += s.d_eta[i];
      error = std::max({error, std::abs(sum), std::abs(du), std::abs(dv)});
    }
    expect_error(named("partition of unity", type), error, 2e-15);
  }
}

TEST(Shape, OneAtOwnNodeZeroAtOthers) {
  for (ElementType type : all_types) {
    double error = 0;
    const auto nodes = reference_nodes(type);
    ASSERT_EQ(nodes.size(), static_cast<std::size_t>(node_count(type)));
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      Shape s;
      evaluate_shape(type, nodes[j].xi, nodes[j].eta, s);
      for (std::size_t i = 0; i < nodes.size(); ++i) error = std::max(error, std::abs(s.value[i] - (i == j ? 1 : 0)));
    }
    expect_error(named("nodal values", type), error, 1e-15);
  }
}

TEST(Shape, DerivativesMatchDifferences) {
  // Central differences are exact for degree 2 in each variable; what remains is rounding / h.
  const double h = 1e-4;
  for (ElementType type : all_types) {
    double error = 0;
    for (const auto& [u, v] : points(type)) {
      Shape s, a, b, c, d;
      evaluate_shape(type, u, v, s);
      evaluate_shape(type, u + h, v, a);
      evaluate_shape(type, u - h, v, b);
      evaluate_shape(type, u, v + h, c);
      evaluate_shape(type, u, v - h, d);
      for (std::size_t i = 0; i < static_cast<std::size_t>(node_count(type)); ++i)
        error = std::max({error, std::abs((a.value[i] - b.value[i]) / (2 * h) - s.d_xi[i]),
                          std::abs((c.value[i] - d.value[i]) / (2 * h) - s.d_eta[i])});
    }
    expect_error(named("derivatives against differences", type), error, 1e-11);
  }
}

TEST(Shape, QuadraticElementsReproduceQuadratics) {
  auto f = [](double u, double v) { return 1 - 2 * u + 3 * v + u * u - 2 * u * v + 0.5 * v * v; };
  for (ElementType type : all_types) {
    if (!is_quadratic(type)) continue;
    double error = 0;
    const auto nodes = reference_nodes(type);
    for (const auto& [u, v] : points(type)) {
      Shape s;
      evaluate_shape(type, u, v, s);
      double sum = -f(u, v);
      for (std::size_t i = 0; i < nodes.size(); ++i) sum += s.value[i] * f(nodes[i].xi, nodes[i].eta);
      error = std::max(error, std::abs(sum));
    }
    expect_error(named("quadratic field", type), error, 1e-14);
  }
}

}  // namespace
}  // namespace rollcon
