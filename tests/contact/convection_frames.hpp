#pragma once
/// Makes frames, directions and views of the rows for tests of the convective derivative.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "contact/convection/convection.hpp"
#include "mesh/topology.hpp"
#include "support/frames.hpp"

namespace rollcon::convection_test {

constexpr ElementType all_types[] = {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                     ElementType::quad9};
constexpr double directions[] = {0, 7, 30, 45, 90, 133, 180, 245, 301};

struct Direction {
  double ex, ey;
  explicit Direction(double degrees)
      : ex(std::cos(degrees * std::numbers::pi / 180)), ey(std::sin(degrees * std::numbers::pi / 180)) {}
};

struct NamedFrame {
  std::string name;
  Frame frame;
};

inline std::vector<NamedFrame> frames_of(ElementType type) {
  using namespace frames;
  const auto u = uniform_lines(-1, 1, is_quadratic(type) ? 8 : 16);
  const std::string id = ", type " + std::to_string(static_cast<int>(type));
  std::vector<NamedFrame> all;
  auto add = [&](const char* name, SurfaceMesh mesh) {
    all.push_back({name + id, build_frame(std::move(mesh), Axes{})});
  };
  add("uniform", rectangle(type, u, u));
  add("cosine lines", rectangle(type, cosine_lines(1, 8), cosine_lines(1, 8)));
  add("random", perturb(rectangle(type, u, u), 0.25, 3));
  add("random 1:100", stretch(perturb(rectangle(type, u, u), 0.25, 5), 1, 0.01));
  if (corner_count(type) == 3) {
    const auto radius = contact_radii(1, 8, 1.3);
    add("rings graded to the contact's edge", ring_disc(type, radius, ring_counts(radius)));
  } else {
    add("O-grid", o_grid(type, 8, 3, 1.3, 1.3));
  }
  return all;
}

template <class F>
double apply(const Frame& frame, const SparseRows& d, std::size_t i, F w, double* scale = nullptr) {
  double sum = 0, size = 0;
  for (auto k = static_cast<std::size_t>(d.start[i]); k < static_cast<std::size_t>(d.start[i + 1]); ++k) {
    const auto j = static_cast<std::size_t>(d.column[k]);
    const double difference = w(frame.x[j], frame.y[j]) - w(frame.x[i], frame.y[i]);
    sum += d.value[k] * difference;
    size += std::abs(d.value[k] * difference);
  }
  if (scale) *scale = size;
  return sum;
}

inline bool empty_row(const SparseRows& d, std::size_t i) {
  return d.start[i] == d.start[i + 1];
}

inline std::vector<double> dense(const SparseRows& d) {
  const std::size_t n = d.start.size() - 1;
  std::vector<double> a(n * n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (auto k = static_cast<std::size_t>(d.start[i]); k < static_cast<std::size_t>(d.start[i + 1]); ++k)
      a[i * n + static_cast<std::size_t>(d.column[k])] += d.value[k];
  return a;
}

/// Returns the largest difference of two operators' rows over the row's size.
inline double row_difference(const std::vector<double>& a, const std::vector<double>& b, double factor) {
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(a.size()))));
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double size = 1e-300, difference = 0;
    for (std::size_t j = 0; j < n; ++j) {
      size = std::max(size, std::abs(a[i * n + j]));
      difference = std::max(difference, std::abs(a[i * n + j] - b[i * n + j] / factor));
    }
    worst = std::max(worst, difference / size);
  }
  return worst;
}

}  // namespace rollcon::convection_test
