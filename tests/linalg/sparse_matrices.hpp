#pragma once
/// Makes symmetric sparse matrices for tests, and their products and solutions without the sparse factors.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "linalg/factored_matrix.hpp"
#include "linalg/sparse_matrix.hpp"
#include "support/frames.hpp"

namespace rollcon::sparse {

using Unknowns = std::vector<std::int64_t>;

inline std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// Collects entries on and below the diagonal; what is added at one place is summed.
class Entries {
 public:
  explicit Entries(std::int64_t n) : column_(at(n)) {
    for (std::int64_t j = 0; j < n; ++j) add(j, j, 0);
  }
  void add(std::int64_t i, std::int64_t j, double value) { column_[at(std::min(i, j))][std::max(i, j)] += value; }
  SparseMatrix matrix() const {
    SparseMatrix a;
    a.columns = static_cast<std::int64_t>(column_.size());
    a.start = {0};
    for (const auto& column : column_) {
      for (const auto& [i, value] : column) {
        a.row.push_back(i);
        a.value.push_back(value);
      }
      a.start.push_back(static_cast<std::int64_t>(a.row.size()));
    }
    return a;
  }

 private:
  std::vector<std::map<std::int64_t, double>> column_;
};

/// Returns springs between neighbours on a grid of n^3 points with `fields` unknowns each, coupled at every point;
/// `ground` holds the points of the lowest layer.
inline SparseMatrix springs(std::int64_t n, std::int64_t fields, double ground, double stiffest = 1) {
  const std::int64_t points = n * n * n;
  Entries entries(points * fields);
  frames::Random random(3);
  const auto spring = [&](std::int64_t i, std::int64_t j, double k) {
    entries.add(i, i, k);
    entries.add(j, j, k);
    entries.add(i, j, -k);
  };
  const auto couple = [&](std::int64_t p, std::int64_t q) {
    for (std::int64_t a = 0; a < fields; ++a)
      for (std::int64_t b = 0; b < fields; ++b) spring(p * fields + a, q * fields + b, std::pow(stiffest, random()));
  };
  for (std::int64_t p = 0; p < points; ++p) {
    const std::int64_t x = p % n, y = p / n % n, z = p / (n * n);
    for (std::int64_t a = 0; a < fields; ++a)
      for (std::int64_t b = 0; b < a; ++b) spring(p * fields + a, p * fields + b, 0.5);
    if (x + 1 < n) couple(p, p + 1);
    if (y + 1 < n) couple(p, p + n);
    if (z + 1 < n) couple(p, p + n * n);
    for (std::int64_t a = 0; z == 0 && a < fields; ++a) entries.add(p * fields + a, p * fields + a, ground);
  }
  return entries.matrix();
}

/// Returns a random pattern, diagonally dominant.
inline SparseMatrix random_matrix(std::int64_t n, double density) {
  frames::Random random(11);
  Entries entries(n);
  for (std::int64_t j = 0; j < n; ++j) {
    entries.add(j, j, 4 + density * static_cast<double>(n));
    for (std::int64_t i = j + 1; i < n; ++i) {
      const double chosen = random(), value = random();
      if (std::abs(chosen) < density) entries.add(i, j, value);
    }
  }
  return entries.matrix();
}

inline SparseMatrix two_by_two(double first, double beside, double second) {
  Entries entries(2);
  entries.add(0, 0, first);
  entries.add(1, 0, beside);
  entries.add(1, 1, second);
  return entries.matrix();
}

inline std::vector<double> multiply(const SparseMatrix& a, const std::vector<double>& x) {
  std::vector<double> y(x.size());
  for (std::int64_t j = 0; j < a.columns; ++j) {
    for (std::int64_t k = a.start[at(j)]; k < a.start[at(j + 1)]; ++k) {
      const std::int64_t i = a.row[at(k)];
      y[at(i)] += a.value[at(k)] * x[at(j)];
      if (i != j) y[at(j)] += a.value[at(k)] * x[at(i)];
    }
  }
  return y;
}

/// Returns columns of the inverse for these unknowns, by LAPACK.
inline std::vector<double> dense_columns(const SparseMatrix& a, const Unknowns& unknowns) {
  FactoredMatrix dense;
  double* entry = dense.prepare(a.columns);
  std::fill_n(entry, a.columns * a.columns, 0.0);
  for (std::int64_t j = 0; j < a.columns; ++j)
    for (std::int64_t k = a.start[at(j)]; k < a.start[at(j + 1)]; ++k)
      entry[a.row[at(k)] + j * a.columns] = entry[j + a.row[at(k)] * a.columns] = a.value[at(k)];
  EXPECT_TRUE(dense.factor());
  const auto count = static_cast<std::int64_t>(unknowns.size());
  std::vector<double> b(at(a.columns * count));
  for (std::int64_t r = 0; r < count; ++r) b[at(r * a.columns + unknowns[at(r)])] = 1;
  dense.solve(b.data(), count);
  return b;
}

inline std::vector<double> identity(std::size_t n) {
  std::vector<double> b(n * n);
  for (std::size_t k = 0; k < n; ++k) b[k * n + k] = 1;
  return b;
}

/// Returns every third unknown backwards, then a few from the front: neither sorted nor together.
inline Unknowns scattered(std::int64_t n) {
  Unknowns list;
  for (std::int64_t u = n - 1; u >= n / 2; u -= 3) list.push_back(u);
  for (std::int64_t u = 0; u < n / 8; ++u) list.push_back(u);
  return list;
}

inline double largest(const std::vector<double>& a) {
  double value = 0;
  for (const double x : a) value = std::max(value, std::abs(x));
  return value;
}

inline double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double value = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k) value = std::max(value, std::abs(a[k] - b[k]));
  return value / largest(b);
}

/// Puts both on the diagonal of one matrix.
inline SparseMatrix side_by_side(const SparseMatrix& a, const SparseMatrix& b) {
  SparseMatrix both = a;
  both.columns += b.columns;
  for (std::int64_t j = 1; j <= b.columns; ++j) both.start.push_back(a.start.back() + b.start[at(j)]);
  for (const std::int64_t i : b.row) both.row.push_back(a.columns + i);
  both.value.insert(both.value.end(), b.value.begin(), b.value.end());
  return both;
}

}  // namespace rollcon::sparse
