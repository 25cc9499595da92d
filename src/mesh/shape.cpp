#include "mesh/shape.hpp"

namespace rollcon {
namespace {

constexpr ReferencePoint triangle_nodes[6] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
constexpr ReferencePoint square_nodes[9] = {{-1, -1}, {1, -1}, {1, 1},  {-1, 1}, {0, -1},
                                            {1, 0},   {0, 1},  {-1, 0}, {0, 0}};

void set(Shape& s, std::size_t i, double value, double d_xi, double d_eta) {
  s.value[i] = value;
  s.d_xi[i] = d_xi;
  s.d_eta[i] = d_eta;
}

/// Barycentric coordinates L_i have constant derivatives.
constexpr double bary_xi[3] = {-1, 1, 0}, bary_eta[3] = {-1, 0, 1};

void tri3(double xi, double eta, Shape& s) {
  const double l[3] = {1 - xi - eta, xi, eta};
  for (std::size_t i = 0; i < 3; ++i) set(s, i, l[i], bary_xi[i], bary_eta[i]);
}

void tri6(double xi, double eta, Shape& s) {
  const double l[3] = {1 - xi - eta, xi, eta};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double slope = 4 * l[i] - 1;
    set(s, i, l[i] * (2 * l[i] - 1), slope * bary_xi[i], slope * bary_eta[i]);
    set(s, 3 + i, 4 * l[i] * l[j], 4 * (bary_xi[i] * l[j] + l[i] * bary_xi[j]),
        4 * (bary_eta[i] * l[j] + l[i] * bary_eta[j]));
  }
}

void quad4(double xi, double eta, Shape& s) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [a, b] = square_nodes[i];
    set(s, i, 0.25 * (1 + a * xi) * (1 + b * eta), 0.25 * a * (1 + b * eta), 0.25 * b * (1 + a * xi));
  }
}

void quad8(double xi, double eta, Shape& s) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [a, b] = square_nodes[i];
    set(s, i, 0.25 * (1 + a * xi) * (1 + b * eta) * (a * xi + b * eta - 1),
        0.25 * a * (1 + b * eta) * (2 * a * xi + b * eta), 0.25 * b * (1 + a * xi) * (a * xi + 2 * b * eta));
  }
  for (std::size_t i = 4; i < 8; ++i) {
    const auto [a, b] = square_nodes[i];
    if (a == 0)
      set(s, i, 0.5 * (1 - xi * xi) * (1 + b * eta), -xi * (1 + b * eta), 0.5 * b * (1 - xi * xi));
    else
      set(s, i, 0.5 * (1 + a * xi) * (1 - eta * eta), 0.5 * a * (1 - eta * eta), -eta * (1 + a * xi));
  }
}

/// Evaluates the one-dimensional quadratic Lagrange function of the node at a in {-1, 0, 1}, and its derivative.
struct Line3 {
  double value, slope;
};
Line3 line3(double a, double t) {
  if (a == 0) return {1 - t * t, -2 * t};
  return {0.5 * t * (t + a), t + 0.5 * a};
}

void quad9(double xi, double eta, Shape& s) {
  for (std::size_t i = 0; i < 9; ++i) {
    const Line3 u = line3(square_nodes[i].xi, xi), v = line3(square_nodes[i].eta, eta);
    set(s, i, u.value * v.value, u.slope * v.value, u.value * v.slope);
  }
}

}  // namespace

void evaluate_shape(ElementType type, double xi, double eta, Shape& shape) {
  switch (type) {
    case ElementType::tri3:
      return tri3(xi, eta, shape);
    case ElementType::tri6:
      return tri6(xi, eta, shape);
    case ElementType::quad4:
      return quad4(xi, eta, shape);
    case ElementType::quad8:
      return quad8(xi, eta, shape);
    case ElementType::quad9:
      return quad9(xi, eta, shape);
  }
}

std::span<const ReferencePoint> reference_nodes(ElementType type) {
  const auto n = static_cast<std::size_t>(node_count(type));
  if (corner_count(type) == 3) return {triangle_nodes, n};
  return {square_nodes, n};
}

}  // namespace rollcon
