#include "linalg/panel_lu.hpp"

#include <algorithm>
#include <cstdint>

#include "linalg/lapack.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

/// Operations between two checks for a stop: a second or two. Slabs of few columns cost a large update its speed.
constexpr double most_of_panel = 2.5e10, most_of_slab = 1e11;

struct Columns {
  int n;
  double* a;
  int* pivot;

  double* entry(int i, int j) const { return a + i + static_cast<std::int64_t>(j) * n; }

  /// Repeats in columns first to last the exchanges of rows that steps `from` to `to` made.
  void exchange(int first, int last, int from, int to) const {
    const int columns = last - first, least = from + 1, step = 1;
    dlaswp_(&columns, entry(0, first), &n, &least, &to, pivot, &step);
  }

  /// Brings columns middle to last up to date with the factors in columns first to middle.
  void update(int first, int middle, int last) const {
    constexpr double one = 1, minus = -1;
    const int done = middle - first, below = n - middle;
    const int slab = std::max(static_cast<int>(most_of_slab / (static_cast<double>(done) * (done + 2 * below))), 64);
    for (int j = middle; j < last; j += slab) {
      check_interrupt();
      const int columns = std::min(slab, last - j);
      exchange(j, j + columns, first, middle);
      dtrsm_("L", "L", "N", "U", &done, &columns, &one, entry(first, first), &n, entry(first, j), &n);
      dgemm_("N", "N", &below, &columns, &done, &minus, entry(middle, first), &n, entry(first, j), &n, &one,
             entry(middle, j), &n);
    }
  }

  /// Factorises columns first to last, the rows above which are done, one half after the other.
  int factor(int first, int last) const {
    const int rows = n - first, columns = last - first;
    int info = 0;
    if (static_cast<double>(rows) * columns * columns < most_of_panel) {
      check_interrupt();
      dgetrf_(&rows, &columns, entry(first, first), &n, pivot + first, &info);
      for (int i = first; i < last; ++i) pivot[i] += first;
      return info == 0 ? 0 : first + info;
    }
    const int middle = first + columns / 2;
    info = factor(first, middle);
    update(first, middle, last);
    const int later = factor(middle, last);
    exchange(first, middle, middle, last);
    return info == 0 ? later : info;
  }
};

}  // namespace

int factor_by_panels(int n, double* a, int* pivot) {
  return Columns{n, a, pivot}.factor(0, n);
}

}  // namespace rollcon
