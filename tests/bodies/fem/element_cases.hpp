#pragma once
/// Makes elements of every formulation in awkward shapes, and computes with their stiffness.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "bodies/fem/element_stiffness.hpp"
#include "mesh/volume_shape.hpp"

namespace rollcon::fem::elements {

struct Formulation {
  VolumeType type;
  Hex8 hex8 = Hex8::enhanced;

  std::size_t nodes() const { return static_cast<std::size_t>(node_count(type)); }
  std::string name() const {
    switch (type) {
      case VolumeType::tet4:
        return "tet4";
      case VolumeType::tet10:
        return "tet10";
      case VolumeType::wedge6:
        return "wedge6";
      case VolumeType::wedge15:
        return "wedge15";
      case VolumeType::hex20:
        return "hex20";
      case VolumeType::hex8:
        break;
    }
    return hex8 == Hex8::b_bar ? "hex8_b_bar" : "hex8";
  }
};

inline const std::array<Formulation, 7> all{{{VolumeType::tet4},
                                             {VolumeType::tet10},
                                             {VolumeType::wedge6},
                                             {VolumeType::wedge15},
                                             {VolumeType::hex8},
                                             {VolumeType::hex8, Hex8::b_bar},
                                             {VolumeType::hex20}}};
inline const std::array<Formulation, 3> quadratic{{{VolumeType::tet10}, {VolumeType::wedge15}, {VolumeType::hex20}}};

using Nodes = std::vector<Vec3>;
using Map = std::function<Vec3(const Vec3&)>;

/// Returns the reference element under a map; it is curved where the map is.
inline Nodes mapped(VolumeType type, const Map& map) {
  Nodes x;
  for (const Vec3& node : reference_nodes(type)) x.push_back(map(node));
  return x;
}

inline Nodes box(VolumeType type, const Vec3& edge) {
  return mapped(type, [&](const Vec3& r) { return Vec3{edge[0] * r[0], edge[1] * r[1], edge[2] * r[2]}; });
}

/// Returns a parallelepiped of no special shape.
inline Nodes slanted(VolumeType type) {
  return mapped(type, [](const Vec3& r) {
    return Vec3{1 + 2 * r[0] + 0.5 * r[1] - 0.3 * r[2], 0.4 * r[0] + 1.5 * r[1] + 0.6 * r[2],
                -2 - 0.2 * r[0] + 0.3 * r[1] + 0.9 * r[2]};
  });
}

/// Moves corners at random; edges stay straight.
inline Nodes distorted(VolumeType type) {
  Nodes x = slanted(type);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  for (std::size_t i = 0; i < static_cast<std::size_t>(corner_count(type)); ++i)
    x[i] = x[i] + Vec3{move(random), move(random), move(random)};
  if (is_quadratic(type)) {
    std::size_t middle = static_cast<std::size_t>(corner_count(type));
    for (const auto& edge : edges_of(type))
      x[middle++] = 0.5 * (x[static_cast<std::size_t>(edge[0])] + x[static_cast<std::size_t>(edge[1])]);
  }
  return x;
}

/// Moves every node at random, midside ones too.
inline Nodes curved(VolumeType type) {
  Nodes x = distorted(type);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> move(-0.07, 0.07);
  for (Vec3& node : x) node = node + Vec3{move(random), move(random), move(random)};
  return x;
}

struct Stiffness {
  std::size_t n = 0;
  std::vector<double> k;

  double operator()(std::size_t r, std::size_t c) const { return k[r * n + c]; }
  double largest() const {
    double most = 0;
    for (double entry : k) most = std::fmax(most, std::abs(entry));
    return most;
  }
  std::vector<double> times(std::span<const double> u) const {
    std::vector<double> f(n, 0.0);
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) f[r] += k[r * n + c] * u[c];
    return f;
  }
  double energy(std::span<const double> u) const {
    double sum = 0;
    const std::vector<double> f = times(u);
    for (std::size_t r = 0; r < n; ++r) sum += f[r] * u[r];
    return sum;
  }
};

inline Stiffness stiffness(const Formulation& f, const Nodes& x, double poisson) {
  Stiffness result;
  result.n = 3 * f.nodes();
  result.k.assign(result.n * result.n, std::nan(""));
  element_stiffness(f.type, x, poisson, result.k.data(), f.hex8);
  return result;
}

/// Returns the nodal values of a field.
inline std::vector<double> at_nodes(const Nodes& x, const Map& field) {
  std::vector<double> u;
  for (const Vec3& node : x)
    for (double component : field(node)) u.push_back(component);
  return u;
}

/// Returns text like " nu 0.4999999".
inline std::string with(double poisson) {
  char text[32];
  std::snprintf(text, sizeof text, ", nu %.9g", poisson);
  return text;
}

/// Returns the largest difference of entries over the largest entry of `b`; NaN passes on.
inline double difference(std::span<const double> a, std::span<const double> b) {
  double most = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double d = std::abs(a[i] - b[i]);
    if (!(d <= most)) most = d;
    size = std::fmax(size, std::abs(b[i]));
  }
  return most / size;
}

}  // namespace rollcon::fem::elements
