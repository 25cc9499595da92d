#include "contact/operators/lattice/lattice_entries.hpp"

#include "support/interrupt.hpp"

namespace rollcon {
namespace {

using halfspace::integral_count;

int terms_of(HalfspaceConstants c) {
  return (c.cv != 0 ? halfspace::with_shear : 0) + (c.ck != 0 ? halfspace::with_coupling : 0);
}

halfspace::OffsetReach reach_of(const Lattice& lattice, std::int64_t margin) {
  return {lattice.nx - 1 + margin, lattice.ny - 1 + margin};
}

}  // namespace

LatticeEntries::LatticeEntries(const Lattice& lattice, HalfspaceConstants c, double delta, Hat x, Hat y,
                               std::int64_t margin)
    : c_(c),
      e_(lattice.ex),
      s_(lattice.ey),
      delta_(delta),
      cut_y_(y != Hat::whole),
      here_({lattice.dx, lattice.dy, x, y}, 0, 0, terms_of(c), reach_of(lattice, margin)),
      ahead_({lattice.dx, lattice.dy, x, y}, delta * lattice.ex, -delta * lattice.ey, terms_of(c),
             reach_of(lattice, margin)) {}

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
  } else {  // displacements: normal and tangential ones are each other's with the sign changed
    for (int t = 0; t < 2; ++t) k.use[2][t] = {k.use[t][2].kind, -1};
  }
  return k;
}

void LatticeEntries::row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&entry)[3][3],
                         Workspace& w) const {
  check_interrupt();
  const auto n = static_cast<std::size_t>(count);
  double *here[integral_count], *slip[integral_count];
  bool any_slip = false, any_normal = false;
  for (int k = 0; k < 3; ++k) {
    any_normal = any_normal || entry[2][k] != nullptr;
    any_slip = any_slip || entry[0][k] != nullptr || entry[1][k] != nullptr;
  }
  if (!any_slip && !any_normal) return;
  for (int k = 0; k < integral_count; ++k) {
    if (w.here[k].size() < n) w.here[k].assign(n, 0.0), w.ahead[k].assign(n, 0.0);
    here[k] = w.here[k].data();
    slip[k] = w.ahead[k].data();
  }
  here_.row(j, first, count, here);
  if (delta_ == 0) {
    for (int k = 0; k < integral_count; ++k) slip[k] = here[k];
  } else if (any_slip) {
    ahead_.row(j, first, count, slip);
    const double factor = 1 / delta_;
    for (int k = 0; k < integral_count; ++k)
      for (std::size_t m = 0; m < n; ++m) slip[k][m] = (here[k][m] - slip[k][m]) * factor;
  }
  // To the frame's axes: d = d1 (e, s) + d2 (-s, e).
  const double ee = e_ * e_, es = e_ * s_, ss = s_ * s_, e = e_, s = s_;
  const auto fill = [&](int r, int c, auto value) {
    if (entry[r][c] == nullptr) return;
    for (std::size_t m = 0; m < n; ++m) entry[r][c][m] = value(m);
  };
  const double cn = c_.cn, cv = c_.cv, ck = c_.ck;
  const double *i0 = slip[0], *xx = slip[1], *xy = slip[2], *jx = slip[3], *jy = slip[4];
  if (cv != 0) {
    fill(0, 0, [=](std::size_t m) { return cn * i0[m] + cv * (ee * xx[m] - 2 * es * xy[m] + ss * (i0[m] - xx[m])); });
    fill(1, 1, [=](std::size_t m) { return cn * i0[m] + cv * (ss * xx[m] + 2 * es * xy[m] + ee * (i0[m] - xx[m])); });
    const auto mixed = [=](std::size_t m) { return cv * (es * (2 * xx[m] - i0[m]) + (ee - ss) * xy[m]); };
    fill(0, 1, mixed);
    fill(1, 0, mixed);
  } else {
    for (int t = 0; t < 2; ++t) {
      fill(t, t, [=](std::size_t m) { return cn * i0[m]; });
      fill(t, 1 - t, [](std::size_t) { return 0.0; });
    }
  }
  const double* normal = here[0];
  fill(2, 2, [=](std::size_t m) { return cn * normal[m]; });
  const double *kx = here[3], *ky = here[4];
  if (ck != 0) {
    fill(0, 2, [=](std::size_t m) { return ck * (e * jx[m] - s * jy[m]); });
    fill(1, 2, [=](std::size_t m) { return ck * (s * jx[m] + e * jy[m]); });
    fill(2, 0, [=](std::size_t m) { return -ck * (e * kx[m] - s * ky[m]); });
    fill(2, 1, [=](std::size_t m) { return -ck * (s * kx[m] + e * ky[m]); });
  } else {
    for (int t = 0; t < 2; ++t) {
      fill(t, 2, [](std::size_t) { return 0.0; });
      fill(2, t, [](std::size_t) { return 0.0; });
    }
  }
}

}  // namespace rollcon
