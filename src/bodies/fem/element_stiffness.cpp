// Deviatoric strain point by point, dilatation projected (docs/theory.md):
//
//   u.K u = integral 2 G dev e : dev e + sum over m of kappa_m |integral f_m div u|^2
//
// f_0, f_1, ...: 1 and some reference coordinates, made orthonormal on the element in this order; kappa_0 the bulk
// modulus, the others too, or at most cap * G. Incompatible modes enter as further shape functions with the gradient
// (det J0 / det J) J0^-T grad(1 - xi_r^2), J0 the Jacobian at the centre: it integrates to zero, so that constant
// stress does no work on them (patch test). They are condensed.

#include "bodies/fem/element_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/fem/element_stiffness_table.hpp"

namespace rollcon::fem {
namespace {

constexpr int max_columns = 3 * max_functions;

/// Columns of gradients: derivative to x_a of function i stands at a * functions + i.
struct Gradients {
  int columns = 0;
  double volume[max_points];  ///< weight times det J
  double at[max_points][max_columns];
};

struct Jacobian {
  double inverse[3][3];  ///< [reference direction][component]
  double det;
};

/// d: [direction][node]; x: [component][node].
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

/// Nodes about their mean, in units of a power of two near the element's size, which is returned as its exponent:
/// nothing overflows or loses digits, whatever the unit and the origin.
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

/// s[row][column] = integral of the product of two gradients; full.
void gradient_products(const ElementTable& table, const Gradients& g, double (*s)[max_columns]) {
  const int columns = g.columns;
  for (int r = 0; r < columns; ++r) {
    double* row = s[r];
    for (int c = r; c < columns; ++c) row[c] = 0;
    for (int q = 0; q < table.points; ++q) {
      const double* at = g.at[q];
      const double factor = g.volume[q] * at[r];
      for (int c = r; c < columns; ++c) row[c] += factor * at[c];
    }
  }
  for (int r = 1; r < columns; ++r)
    for (int c = 0; c < r; ++c) s[r][c] = s[c][r];
}

/// v[m][column] = integral of f_m times the gradient.
void dilatations(const ElementTable& table, const Gradients& g, double (*v)[max_columns]) {
  const int modes = table.modes, columns = g.columns;
  double gram[max_modes][max_modes] = {};
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

/// Eliminates the unknowns from `keep` on, the last first; k: size x size.
void condense(double* k, int size, int keep) {
  for (int e = size - 1; e >= keep; --e) {
    const double* pivot_row = k + e * size;
    const double inverse = 1 / pivot_row[e];
    for (int r = 0; r < e; ++r)
      for (int c = 0; c < e; ++c) k[r * size + c] -= (pivot_row[r] * pivot_row[c]) * inverse;
  }
}

}  // namespace

void element_stiffness(VolumeType type, std::span<const Vec3> x, double poisson, double* k, Hex8 hex8) {
  const ElementTable& table = element_table(type, hex8);
  const int functions = table.functions(), size = 3 * functions, unknowns = 3 * table.nodes;
  double place[3][max_functions] = {}, s[max_columns][max_columns], v[max_modes][max_columns];
  Gradients g;
  const int exponent = normalise(x, place);
  gradients(table, place, g);
  gradient_products(table, g, s);
  dilatations(table, g, v);

  const double unit = std::ldexp(1.0, exponent);
  const double shear = unit / (2 * (1 + poisson)), bulk = unit / (3 * (1 - 2 * poisson));
  const double varying = std::sqrt(std::min(bulk, table.cap * shear));
  for (int m = 0; m < table.modes; ++m)
    for (int c = 0; c < size; ++c) v[m][c] *= m == 0 ? std::sqrt(bulk) : varying;

  double extended[max_columns * max_columns];
  double* full = size == unknowns ? k : extended;
  for (int i = 0; i < functions; ++i)
    for (int a = 0; a < 3; ++a) {
      const int ai = a * functions + i;
      double row[max_columns];  // what dilatations add to row ai
      for (int c = 0; c < size; ++c) row[c] = (-2.0 / 3) * shear * s[ai][c];
      for (int m = 0; m < table.modes; ++m)
        for (int c = 0; c < size; ++c) row[c] += v[m][ai] * v[m][c];
      for (int b = 0; b < 3; ++b) {
        const double* across = s[b * functions + i] + a * functions;
        for (int j = 0; j < functions; ++j) row[b * functions + j] += shear * across[j];
      }
      const double *x0 = s[i], *x1 = s[functions + i] + functions, *x2 = s[2 * functions + i] + 2 * functions;
      double* own = row + a * functions;
      for (int j = 0; j < functions; ++j) own[j] += shear * (x0[j] + x1[j] + x2[j]);
      double* out = full + (3 * i + a) * size;
      for (int b = 0; b < 3; ++b)
        for (int j = 0; j < functions; ++j) out[3 * j + b] = row[b * functions + j];
    }
  if (size == unknowns) return;
  condense(full, size, unknowns);
  for (int r = 0; r < unknowns; ++r) std::copy_n(full + r * size, unknowns, k + r * unknowns);
}

// Where the error of a pressurised cylinder and of a block under a patch load passes three times that of nu = 0.3
// (tet4, wedge6); the others are accurate at 0.499999 too.
double largest_poisson(VolumeType type) {
  switch (type) {
    case VolumeType::tet4:
    case VolumeType::wedge6:
      return 0.45;
    default:
      return 0.4999999;
  }
}

}  // namespace rollcon::fem
