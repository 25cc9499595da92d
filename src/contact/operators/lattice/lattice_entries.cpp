#include "contact/operators/lattice/lattice_entries.hpp"

#include <algorithm>

#include "support/interrupt.hpp"

namespace rollcon {
LatticeEntries::LatticeEntries(const Lattice& lattice, const TranslationKernel& kernel, double delta, Hat x, Hat y,
                               std::int64_t margin)
    : couples_(kernel.couples()),
      shears_(kernel.shears()),
      e_(lattice.ex),
      s_(lattice.ey),
      delta_(delta),
      cut_y_(y != Hat::whole) {
  const LatticeHat hat{lattice.dx, lattice.dy, x, y};
  const OffsetReach reach{lattice.nx - 1 + margin, lattice.ny - 1 + margin};
  here_ = kernel.on_lattice(hat, 0, 0, reach);
  if (delta != 0) ahead_ = kernel.on_lattice(hat, delta * lattice.ex, -delta * lattice.ey, reach);
}

EntryKinds LatticeEntries::kinds() const {
  EntryKinds k;
  const auto add = [&](int r, int c) {
    if (!present(r, c)) return;
    k.use[r][c] = {static_cast<int>(k.kind.size()), 1};
    k.kind.push_back({r, c});
  };
  add(0, 0);
  add(1, 1);
  add(0, 1);
  k.use[1][0] = k.use[0][1];
  add(2, 2);
  add(0, 2);
  add(1, 2);
  if (delta_ != 0) {
    add(2, 0);
    add(2, 1);
  } else {  // normal and tangential displacements are each other's with the sign changed
    for (int t = 0; t < 2; ++t) k.use[2][t] = {k.use[t][2].kind, -1};
  }
  return k;
}

void LatticeEntries::row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&entry)[3][3],
                         Workspace& w) const {
  check_interrupt();
  const auto n = static_cast<std::size_t>(count);
  if (w.memory.size() < 18 * n) w.memory.assign(18 * n, 0.0);
  // Everything that an entry wanted is turned from is needed, along the lattice's axes.
  const auto any = [&](int r, int c) {
    const int last_r = r < 2 ? 1 : 2, last_c = c < 2 ? 1 : 2;
    for (int a = r < 2 ? 0 : 2; a <= last_r; ++a)
      for (int b = c < 2 ? 0 : 2; b <= last_c; ++b)
        if (entry[a][b] != nullptr) return true;
    return false;
  };
  double *here[3][3] = {}, *ahead[3][3] = {};
  bool any_slip = false, any_at_all = false;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      if (!any(r, c)) continue;
      double* const own = w.memory.data() + static_cast<std::size_t>(2 * (3 * r + c)) * n;
      here[r][c] = own;
      any_at_all = true;
      if (r < 2) ahead[r][c] = own + n, any_slip = true;
    }
  if (!any_at_all) return;
  here_->row(j, first, count, here);
  if (ahead_ && any_slip) {
    ahead_->row(j, first, count, ahead);
    const double factor = 1 / delta_;
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c)
        for (std::size_t m = 0; ahead[r][c] != nullptr && m < n; ++m)
          here[r][c][m] = (here[r][c][m] - ahead[r][c][m]) * factor;
  }
  // Displacements d = d1 (e, s) + d2 (-s, e), and tractions alike, are turned to the frame's axes.
  const double turn[3][3] = {{e_, -s_, 0}, {s_, e_, 0}, {0, 0, 1}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      double* const to = entry[r][c];
      if (to == nullptr) continue;
      std::fill_n(to, n, 0.0);
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const double factor = turn[r][a] * turn[c][b];
          for (std::size_t m = 0; factor != 0 && m < n; ++m) to[m] += factor * here[a][b][m];
        }
    }
}

}  // namespace rollcon
