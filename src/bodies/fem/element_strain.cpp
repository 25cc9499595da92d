// Computes gradients and dilatations of one element; element_stiffness.cpp says what they mean.

#include "bodies/fem/element_strain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rollcon::fem {
namespace {

struct Jacobian {
  double inverse[3][3];  ///< [reference direction][component]
  double det;
};

/// Takes derivatives d[direction][node] and places x[component][node].
Jacobian jacobian(const double* d, const double (*x)[max_functions], int nodes) {
  double j[3][3];  // [component][reference direction]
  for (int a = 0; a < 3; ++a)
    for (int r = 0; r < 3; ++r) {
      double sum = 0;
      for (int i = 0; i < nodes; ++i) sum += d[r * nodes + i] * x[a][i];
      j[a][r] = sum;
    }
  Jacobian result;
  for (int a = 0; a < 3; ++a)
    for (int r = 0; r < 3; ++r) {
      const int b = (a + 1) % 3, c = (a + 2) % 3, s = (r + 1) % 3, t = (r + 2) % 3;
      result.inverse[r][a] = j[b][s] * j[c][t] - j[b][t] * j[c][s];
    }
  result.det = 0;
  for (int a = 0; a < 3; ++a) result.det += j[a][0] * result.inverse[0][a];
  for (auto& row : result.inverse)
    for (double& entry : row) entry /= result.det;
  return result;
}

/// Puts nodes about their mean, in units of a power of two near the element's size, and returns its exponent: nothing
/// overflows or loses digits, whatever the unit and the origin.
int normalise(std::span<const Vec3> node, double (*x)[max_functions]) {
  double size = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t i = 0; i < node.size(); ++i) {
      x[a][i] = node[i][a] - node[0][a];
      size = std::max(size, std::abs(x[a][i]));
    }
  int exponent = 0;
  std::frexp(size, &exponent);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t i = 0; i < node.size(); ++i) x[a][i] = std::ldexp(x[a][i], -exponent);
  return exponent;
}

void gradients(const ElementTable& table, const double (*x)[max_functions], Gradients& g) {
  const int n = table.nodes, functions = table.functions();
  g.columns = 3 * functions;
  const Jacobian centre = jacobian(table.centre.data(), x, n);
  for (int q = 0; q < table.points; ++q) {
    const auto point = static_cast<std::size_t>(q);
    const double* d = table.d.data() + 3 * n * q;
    const Jacobian here = jacobian(d, x, n);
    g.volume[q] = table.w[point] * here.det;
    for (int a = 0; a < 3; ++a) {
      double* row = g.at[q] + a * functions;
      const double f0 = here.inverse[0][a], f1 = here.inverse[1][a], f2 = here.inverse[2][a];
      for (int i = 0; i < n; ++i) row[i] = d[i] * f0 + d[n + i] * f1 + d[2 * n + i] * f2;
      for (int e = n; e < functions; ++e) {
        const auto r = static_cast<std::size_t>(table.bubble[static_cast<std::size_t>(e - n)]);
        row[e] = -2 * table.offset[point][r] * (centre.det / here.det) * centre.inverse[r][a];
      }
    }
  }
}

/// Sets v[m][column] to the integral of f_m times the gradient; gram: see ElementStrain::triangle.
void dilatations(const ElementTable& table, const Gradients& g, double (*v)[max_columns], double (*gram)[max_modes]) {
  const int modes = table.modes, columns = g.columns;
  for (int m = 0; m < modes; ++m) std::fill_n(gram[m], modes, 0.0);
  for (int m = 0; m < modes; ++m) {
    for (int c = 0; c < columns; ++c) v[m][c] = 0;
    for (int q = 0; q < table.points; ++q) {
      const double* mode = table.mode.data() + q * modes;
      const double factor = g.volume[q] * mode[m];
      for (int l = 0; l <= m; ++l) gram[m][l] += factor * mode[l];
      for (int c = 0; c < columns; ++c) v[m][c] += factor * g.at[q][c];
    }
  }
  // Cholesky's factor of the Gram matrix, row by row, and its inverse applied to v.
  for (int m = 0; m < modes; ++m) {
    for (int l = 0; l <= m; ++l) {
      for (int k = 0; k < l; ++k) gram[m][l] -= gram[m][k] * gram[l][k];
      gram[m][l] = l < m ? gram[m][l] / gram[l][l] : std::sqrt(gram[m][m]);
    }
    for (int c = 0; c < columns; ++c) {
      for (int k = 0; k < m; ++k) v[m][c] -= gram[m][k] * v[k][c];
      v[m][c] /= gram[m][m];
    }
  }
}

}  // namespace

void find_strain(VolumeType type, std::span<const Vec3> x, Hex8 hex8, ElementStrain& out) {
  double place[3][max_functions] = {};
  out.table = &element_table(type, hex8);
  out.exponent = normalise(x, place);
  gradients(*out.table, place, out.g);
  dilatations(*out.table, out.g, out.dilatation, out.triangle);
}

Moduli moduli_of(const ElementStrain& strain, double poisson, double unit) {
  Moduli m;
  m.shear = unit / (2 * (1 + poisson));
  m.bulk = unit / (3 * (1 - 2 * poisson));
  m.varying = std::min(m.bulk, strain.table->cap * m.shear);
  return m;
}

}  // namespace rollcon::fem
