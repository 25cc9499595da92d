#include "bodies/fem/element_stress.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/fem/element_strain.hpp"
#include "mesh/volume_shape.hpp"

namespace rollcon::fem {
namespace {

VolumeType linear_type(VolumeType type) {
  switch (corner_count(type)) {
    case 4:
      return VolumeType::tet4;
    case 6:
      return VolumeType::wedge6;
    default:
      return VolumeType::hex8;
  }
}

/// Solves the symmetric system in place, b: n x columns; n small.
void solve_small(std::vector<double>& a, int n, std::vector<double>& b, int columns) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  for (int p = 0; p < n; ++p)
    for (int r = 0; r < n; ++r) {
      if (r == p) continue;
      const double factor = a[at(r * n + p)] / a[at(p * n + p)];
      for (int c = p; c < n; ++c) a[at(r * n + c)] -= factor * a[at(p * n + c)];
      for (int c = 0; c < columns; ++c) b[at(r * columns + c)] -= factor * b[at(p * columns + c)];
    }
  for (int p = 0; p < n; ++p)
    for (int c = 0; c < columns; ++c) b[at(p * columns + c)] /= a[at(p * n + p)];
}

std::vector<double> make_to_nodes(VolumeType type, Hex8 hex8) {
  const ElementTable& table = element_table(type, hex8);
  const auto points = static_cast<std::size_t>(table.points), nodes = static_cast<std::size_t>(table.nodes);
  if (points == 1) return std::vector<double>(nodes, 1.0);
  const VolumeType linear = linear_type(type);
  const int corners = corner_count(type);
  const auto n = static_cast<std::size_t>(corners);
  const Vec3 centre = [&] {
    Vec3 sum{};
    for (const Vec3& node : reference_nodes(linear)) sum = sum + (1.0 / corners) * node;
    return sum;
  }();
  std::vector<double> mass(n * n, 0.0), b(n * points);
  VolumeShape shape;
  for (std::size_t q = 0; q < points; ++q) {
    evaluate_shape(linear, centre + table.offset[q], shape);
    for (std::size_t i = 0; i < n; ++i) {
      b[i * points + q] = table.w[q] * shape.value[i];
      for (std::size_t j = 0; j < n; ++j) mass[i * n + j] += table.w[q] * shape.value[i] * shape.value[j];
    }
  }
  solve_small(mass, corners, b, table.points);
  std::vector<double> result(nodes * points, 0.0);
  for (std::size_t k = 0; k < nodes; ++k) {
    evaluate_shape(linear, reference_nodes(type)[k], shape);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t q = 0; q < points; ++q) result[k * points + q] += shape.value[i] * b[i * points + q];
  }
  return result;
}

/// Returns node displacements and the incompatible modes that go with them, unknown 3 * function + component.
void extend(const ElementStrain& strain, double poisson, const double* u, double* all) {
  const int size = 3 * strain.table->functions(), unknowns = 3 * strain.table->nodes;
  std::copy_n(u, unknowns, all);
  if (size == unknowns) return;
  double k[max_columns * max_columns];
  extended_stiffness(strain, poisson, k);
  condense(k, size, unknowns);
  for (int e = unknowns; e < size; ++e) {
    double sum = 0;
    for (int c = 0; c < e; ++c) sum += k[e * size + c] * all[c];
    all[e] = -sum / k[e * size + e];
  }
}

/// Sets theta[m] to the integral of f_m div u.
void dilatation(const ElementStrain& strain, const double* all, double* theta) {
  const int functions = strain.table->functions();
  for (int m = 0; m < strain.table->modes; ++m) {
    theta[m] = 0;
    for (int a = 0; a < 3; ++a)
      for (int i = 0; i < functions; ++i) theta[m] += strain.dilatation[m][a * functions + i] * all[3 * i + a];
  }
}

/// Returns the mean stress at point q over the moduli's unit.
double mean_stress(const ElementStrain& strain, const Moduli& moduli, const double* theta, int q) {
  const int modes = strain.table->modes;
  double f[max_modes], sum = 0;
  for (int m = 0; m < modes; ++m) {
    f[m] = strain.table->mode[static_cast<std::size_t>(q * modes + m)];
    for (int k = 0; k < m; ++k) f[m] -= strain.triangle[m][k] * f[k];
    f[m] /= strain.triangle[m][m];
    sum += (m == 0 ? moduli.bulk : moduli.varying) * f[m] * theta[m];
  }
  return sum;
}

void stress_at(const ElementStrain& strain, const Moduli& moduli, const double* all, double mean, int q,
               double* stress) {
  const int functions = strain.table->functions();
  double h[3][3] = {};  // derivative to x_b of component a
  for (int b = 0; b < 3; ++b)
    for (int i = 0; i < functions; ++i)
      for (int a = 0; a < 3; ++a) h[a][b] += strain.g.at[q][b * functions + i] * all[3 * i + a];
  const double third = (h[0][0] + h[1][1] + h[2][2]) / 3;
  for (int a = 0; a < 3; ++a) stress[a] = 2 * moduli.shear * (h[a][a] - third) + mean;
  stress[3] = moduli.shear * (h[0][1] + h[1][0]);
  stress[4] = moduli.shear * (h[0][2] + h[2][0]);
  stress[5] = moduli.shear * (h[1][2] + h[2][1]);
}

void places(VolumeType type, const ElementTable& table, std::span<const Vec3> x, double* place) {
  Vec3 centre{};
  const auto corners = static_cast<std::size_t>(corner_count(type));
  for (const Vec3& node : reference_nodes(type).first(corners))
    centre = centre + (1.0 / static_cast<double>(corners)) * node;
  VolumeShape shape;
  for (const Vec3& offset : table.offset) {
    evaluate_shape(type, centre + offset, shape);
    Vec3 at{0, 0, 0};
    for (std::size_t k = 0; k < x.size(); ++k) at = at + shape.value[k] * x[k];
    place = std::copy(at.begin(), at.end(), place);
  }
}

}  // namespace

int stress_points(VolumeType type, Hex8 hex8) {
  return element_table(type, hex8).points;
}

double element_stress(VolumeType type, std::span<const Vec3> x, double poisson, Hex8 hex8, const double* u,
                      double* stress, double* place) {
  ElementStrain strain;
  find_strain(type, x, hex8, strain);
  const ElementTable& table = *strain.table;
  double volume = 0;
  for (int q = 0; q < table.points; ++q) volume += strain.g.volume[q];
  if (place) places(type, table, x, place);
  if (stress) {
    double all[max_columns], theta[max_modes];
    extend(strain, poisson, u, all);
    dilatation(strain, all, theta);
    const Moduli moduli = moduli_of(strain, poisson, std::ldexp(1.0, -strain.exponent));
    for (int q = 0; q < table.points; ++q)
      stress_at(strain, moduli, all, mean_stress(strain, moduli, theta, q), q,
                stress + static_cast<std::ptrdiff_t>(6 * q));
  }
  return std::ldexp(volume, 3 * strain.exponent);
}

const std::vector<double>& to_nodes(VolumeType type, Hex8 hex8) {
  static const OfEachElement<std::vector<double>> made(&make_to_nodes);
  return made.of(type, hex8);
}

}  // namespace rollcon::fem
