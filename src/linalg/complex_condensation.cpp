#include "linalg/complex_condensation.hpp"

#include <algorithm>
#include <numeric>

#include "linalg/lapack.hpp"
#include "linalg/sparse_factor.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using Complex = std::complex<double>;

/// Columns join a front whose rows they nearly share: so many more rows cost less than another front.
constexpr std::size_t spare_rows = 6;

/// Returns the inverse, times a scale, of the matrix that was factorised in the last front.
std::vector<Complex> inverse_of(const std::vector<Complex>& front, std::int64_t size, double scale) {
  const int n = static_cast<int>(size);
  const Complex one = 1;
  std::vector<Complex> b(at(n) * at(n));
  for (std::size_t k = 0; k < at(n); ++k) b[k * at(n) + k] = scale;
  ztrsm_("L", "L", "N", "N", &n, &n, &one, front.data(), &n, b.data(), &n);
  ztrsm_("L", "L", "T", "N", &n, &n, &one, front.data(), &n, b.data(), &n);
  return b;
}

}  // namespace

ComplexCondensation::ComplexCondensation(const SparseMatrix& pattern, std::span<const std::int64_t> order,
                                         std::int64_t condensed)
    : order_(order.begin(), order.end()) {
  const std::int64_t n = pattern.columns, interior = n - condensed;
  std::vector<std::int64_t> place(at(n)), step_of(at(n), -1), seen(at(n), -1);
  for (std::int64_t k = 0; k < n; ++k) place[at(order_[at(k)])] = k;
  struct Entry {
    std::int64_t row, from;
  };
  std::vector<std::vector<Entry>> own(at(n));
  for (std::int64_t j = 0; j < n; ++j)
    for (std::int64_t k = pattern.start[at(j)]; k < pattern.start[at(j + 1)]; ++k) {
      const auto [column, row] = std::minmax(place[at(j)], place[at(pattern.row[at(k)])]);
      own[at(column)].push_back({row, k});
    }
  // Rows below the diagonal of each column of L, and the columns whose first such row it is.
  std::vector<std::vector<std::int64_t>> below(at(interior)), children(at(interior));
  for (std::int64_t p = 0; p < interior; ++p) {
    std::vector<std::int64_t>& rows = below[at(p)];
    const auto add = [&](std::int64_t r) {
      if (r > p && seen[at(r)] != p) seen[at(r)] = p, rows.push_back(r);
    };
    for (const Entry& e : own[at(p)]) add(e.row);
    for (const std::int64_t c : children[at(p)]) std::for_each(below[at(c)].begin(), below[at(c)].end(), add);
    std::sort(rows.begin(), rows.end());
    if (!rows.empty() && rows[0] < interior) children[at(rows[0])].push_back(p);
  }
  for (std::int64_t p = 0; p < interior; ++p) {
    const bool joins = p > 0 && !below[at(p - 1)].empty() && below[at(p - 1)][0] == p &&
                       below[at(p)].size() + 1 <= below[at(p - 1)].size() + spare_rows;
    if (!joins) step_.emplace_back();
    step_.back().row.push_back(p);
    ++step_.back().columns;
    step_of[at(p)] = std::ssize(step_) - 1;
  }
  step_.emplace_back();
  for (std::int64_t p = interior; p < n; ++p) step_.back().row.push_back(p), step_of[at(p)] = std::ssize(step_) - 1;
  for (std::size_t s = 0; s < step_.size(); ++s) {
    Step& step = step_[s];
    if (s + 1 < step_.size()) {
      const auto& rest = below[at(step.row.back())];
      step.row.insert(step.row.end(), rest.begin(), rest.end());
      const bool inside = !rest.empty() && rest[0] < interior;
      if (!rest.empty()) step_[inside ? at(step_of[at(rest[0])]) : step_.size() - 1].child.push_back(s);
    }
    const std::size_t size = step.row.size();
    for (std::size_t k = 0; k < size; ++k) {
      const std::int64_t column = step.row[k];
      if (step_of[at(column)] != static_cast<std::int64_t>(s)) break;
      for (const Entry& e : own[at(column)]) {
        const auto row = std::lower_bound(step.row.begin(), step.row.end(), e.row) - step.row.begin();
        step.entry.push_back(e.from);
        step.target.push_back(k * size + at(row));
      }
    }
    for (std::size_t k = 0; k < at(step.columns); ++k) nonzeros_ += static_cast<std::int64_t>(size - k);
  }
}

void ComplexCondensation::eliminate(const Step& step, Front& a) const {
  constexpr double least = 1e-14;
  const std::size_t n = step.row.size(), columns = at(step.columns);
  std::vector<double> before(columns);
  for (std::size_t k = 0; k < columns; ++k) before[k] = std::abs(a[k * n + k]);
  for (std::size_t k = 0; k < columns; ++k) {
    Complex* own = a.data() + k * n;
    if (!(std::abs(own[k]) > least * before[k])) throw ZeroPivot(order_[at(step.row[k])]);
    const Complex inverse = 1.0 / std::sqrt(own[k]);
    own[k] = 1.0 / inverse;
    for (std::size_t i = k + 1; i < columns; ++i) own[i] *= inverse;
    for (std::size_t j = k + 1; j < columns; ++j) {
      Complex* to = a.data() + j * n;
      const double x = own[j].real(), y = own[j].imag();
      for (std::size_t i = j; i < columns; ++i)
        to[i] -= Complex{own[i].real() * x - own[i].imag() * y, own[i].real() * y + own[i].imag() * x};
    }
  }
  const int rows = static_cast<int>(n), c = static_cast<int>(columns), rest = rows - c;
  if (rest == 0 || c == 0) return;
  const Complex one = 1, minus = -1;
  ztrsm_("R", "L", "T", "N", &rest, &c, &one, a.data(), &rows, a.data() + c, &rows);
  zsyrk_("L", "N", &rest, &c, &minus, a.data() + c, &rows, &one, a.data() + columns * (n + 1), &rows);
}

std::vector<ComplexCondensation::Front> ComplexCondensation::factorised(std::span<const Complex> value,
                                                                        bool keep) const {
  std::vector<Front> front(step_.size());
  std::vector<std::size_t> local(order_.size());
  for (std::size_t s = 0; s < step_.size(); ++s) {
    const Step& step = step_[s];
    const std::size_t n = step.row.size();
    Front& a = front[s];
    a.assign(n * n, 0);
    for (std::size_t k = 0; k < n; ++k) local[at(step.row[k])] = k;
    for (std::size_t k = 0; k < step.entry.size(); ++k) a[step.target[k]] += value[at(step.entry[k])];
    for (const std::size_t c : step.child) {
      const Step& child = step_[c];
      const std::size_t size = child.row.size();
      for (std::size_t j = at(child.columns); j < size; ++j)
        for (std::size_t i = j; i < size; ++i)
          a[local[at(child.row[j])] * n + local[at(child.row[i])]] += front[c][j * size + i];
      front[c].resize(keep ? at(child.columns) * size : 0);
      front[c].shrink_to_fit();
    }
    if (s + 1 < step_.size()) eliminate(step, a);
  }
  Step last = step_.back();
  last.columns = std::ssize(last.row);
  eliminate(last, front.back());
  return front;
}

std::vector<Complex> ComplexCondensation::inverse(std::span<const Complex> value, double scale) const {
  return inverse_of(factorised(value, false).back(), std::ssize(step_.back().row), scale);
}

// No load acts on the other unknowns, so each front's own unknowns follow from those of later fronts.
std::vector<Complex> ComplexCondensation::everywhere(std::span<const Complex> value, double scale) const {
  const std::vector<Front> front = factorised(value, true);
  const std::size_t all = order_.size(), m = step_.back().row.size();
  const std::vector<Complex> condensed = inverse_of(front.back(), std::ssize(step_.back().row), scale);
  std::vector<Complex> x(m * all), later, own;
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t i = 0; i < m; ++i) x[k * all + at(order_[all - m + i])] = condensed[k * m + i];
  for (std::size_t s = step_.size() - 1; s-- > 0;) {
    const Step& step = step_[s];
    const int rows = static_cast<int>(step.row.size()), c = static_cast<int>(step.columns), rest = rows - c,
              columns = static_cast<int>(m);
    const Complex one = 1, minus = -1, zero = 0;
    own.assign(at(c) * m, 0), later.resize(at(rest) * m);
    const auto place = [&](std::size_t k, int i) -> Complex& { return x[k * all + at(order_[at(step.row[at(i)])])]; };
    for (std::size_t k = 0; k < m; ++k)
      for (int i = 0; i < rest; ++i) later[k * at(rest) + at(i)] = place(k, c + i);
    if (rest > 0)
      zgemm_("T", "N", &c, &columns, &rest, &minus, front[s].data() + c, &rows, later.data(), &rest, &zero, own.data(),
             &c);
    ztrsm_("L", "L", "T", "N", &c, &columns, &one, front[s].data(), &rows, own.data(), &c);
    for (std::size_t k = 0; k < m; ++k)
      for (int i = 0; i < c; ++i) place(k, i) = own[k * at(c) + at(i)];
  }
  return x;
}

}  // namespace rollcon
