// Displacements and stresses inside the bodies.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "checks.hpp"
#include "contact_solver.hpp"
#include "files.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

constexpr int most_blocks = 10, most_points = 9999;

/// Places of centres of elements that a block names: all, every n-th of a range, or a list.
std::vector<double> centres(int kind, const std::vector<double>& q, int count, double first, double step) {
  std::vector<double> places;
  const auto add = [&](int i) {
    if (i >= 1 && i <= count) places.push_back(first + (i - 1) * step);
  };
  if (kind == 1) {
    for (int i = 1; i <= count; ++i) add(i);
  } else if (kind == 2) {
    const int low = whole(q[0]), by = std::max(1, whole(q[1])), high = std::min(whole(q[2]), count);
    for (int i = std::max(low, 1); i <= high; i += by) add(i);
  } else {
    for (const double i : q) add(whole(i));
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Finds the coordinates of the points of a block, in ascending order.
Lists lay_points(const BlockInput& input, const Grid& grid) {
  Lists at = input.lists;
  if (input.kind() != 9) {
    at[0] = centres(input.kind(), at[0], grid.mx, grid.xc, grid.dx);
    at[1] = centres(input.kind(), at[1], grid.my, grid.yc, grid.dy);
  }
  if (input.isubs <= 3) {
    const auto& z = input.lists[2];
    at[2].clear();
    for (int k = 0; k < std::clamp(whole(z[0]), 0, most_points); ++k) at[2].push_back(z[1] + k * z[2]);
  }
  for (auto& v : at) std::sort(v.begin(), v.end());
  return at;
}

/// Fills a block with displacements and stresses. With mirror -1 the contact is the mirror image of the one that the
/// block lies in.
void fill_block(rollcon_contact* contact, const ContactResult& result, double mirror, SubsurfaceBlock& block) {
  const auto [x, y, z] = lay_points(block.input, result.grid);
  block.nx = int(x.size());
  block.ny = int(y.size());
  block.nz = int(z.size());
  const double c = std::cos(result.chi), s = std::sin(result.chi);
  const size_t n = x.size() * y.size() * z.size();
  if (n > 20000000) throw Failure(CNTC_err_other, "a block has more than 20000000 points");
  block.columns.assign(21 * n, 0);
  // The axes of rollcon's contact: t1 is turned by chi, and body 2 lies at n > 0.
  for (const int body : {1, 2}) {
    std::vector<double> points;
    std::vector<size_t> which;
    for (size_t k = 0; k < n; ++k) {
      const double px = x[k % x.size()], py = y[k / x.size() % y.size()], pz = z[k / (x.size() * y.size())];
      if ((pz >= 0 ? 2 : 1) != body) continue;
      points.insert(points.end(), {c * px + s * mirror * py, c * mirror * py - s * px, pz});
      which.push_back(k);
      std::copy_n(std::initializer_list<double>{px, py, pz}.begin(), 3, &block.columns[21 * k]);
    }
    if (which.empty()) continue;
    const auto m = int64_t(which.size());
    std::vector<double> u(3 * which.size()), t(6 * which.size()), principal(3 * which.size()), mises(which.size()),
        shear(which.size());
    check(rollcon_contact_get_fields_at(contact, body, m, points.data(), ROLLCON_IN_CONTACT, u.data(), t.data()));
    check(rollcon_stress_invariants(m, t.data(), principal.data(), mises.data(), shear.data()));
    for (size_t i = 0; i < which.size(); ++i) {
      double* to = &block.columns[21 * which[i]];
      const double *v = &u[3 * i], *q = &t[6 * i], *p = &principal[3 * i];
      to[3] = c * v[0] - s * v[1];
      to[4] = mirror * (s * v[0] + c * v[1]);
      to[5] = v[2];
      to[6] = (q[0] + q[1] + q[2]) / 3;
      to[7] = mises[i];
      to[8] = 2 * shear[i];
      std::copy_n(p, 3, to + 9);
      const double xx = c * c * q[0] - 2 * c * s * q[3] + s * s * q[1],
                   yy = s * s * q[0] + 2 * c * s * q[3] + c * c * q[1],
                   xy = mirror * (c * s * (q[0] - q[1]) + (c * c - s * s) * q[3]), xz = c * q[4] - s * q[5],
                   yz = mirror * (s * q[4] + c * q[5]);
      const double tensor[9] = {xx, xy, xz, xy, yy, yz, xz, yz, q[2]};
      std::copy_n(tensor, 9, to + 12);
    }
  }
}

}  // namespace

void add_block(Call& c, int iblk, int isubs, int npx, int npy, int npz, const double* x, const double* y,
               const double* z) {
  auto& blocks = c.p.blocks[c.icp];
  if (iblk == 0) return blocks.clear();
  if (iblk < 1 || iblk > most_blocks || size_t(iblk) > blocks.size() + 1)
    return say(c, "block %d; allowed: 1 to %d, at most one beyond the last", iblk, most_blocks);
  blocks.resize(size_t(iblk - 1));
  if (isubs < 1 || isubs == 4 || isubs == 8 || isubs > 9) return void(no_method(c, isubs));
  SubsurfaceBlock block;
  block.input.isubs = isubs;
  const int counts[] = {npx, npy, npz}, kind = block.input.kind();
  for (int k = 0; k < 3; ++k) {
    const bool used = k == 2 || kind != 1;
    const int least = !used ? 0 : (k < 2 && kind == 2) || (k == 2 && isubs <= 3) ? 3 : 1;
    if (counts[k] < least || counts[k] > most_points)
      return say(c, "method %d needs %d to %d numbers in each list, not %d", isubs, least, most_points, counts[k]);
  }
  const double* const lists[] = {x, y, z};
  for (size_t k = kind == 1 ? 2 : 0; k < 3; ++k) {
    if (!all_finite(c, counts[k], lists[k])) return;
    auto& list = block.input.lists[k];
    list.assign(lists[k], lists[k] + counts[k]);
    // Numbers of elements and of steps down have no length.
    if (k == 2 || kind == 9)
      for (size_t i = k == 2 && isubs <= 3 ? 1 : 0; i < list.size(); ++i) list[i] *= c.units().length;
  }
  blocks.push_back(std::move(block));
}

namespace {

/// Calculates the blocks of a patch, or of all patches with icp -1; returns an error code.
int calculate_blocks(Problem& p, int icp, std::string& why) {
  const int first = icp > 0 && p.module == 1 ? icp : 1, last = icp > 0 && p.module == 1 ? icp : int(p.patches.size());
  for (int k = first; k <= last; ++k) {
    if (k < 1 || size_t(k) > p.patches.size() || !p.patches[size_t(k - 1)].solved) return CNTC_err_icp;
    const int key = p.module == 3 ? p.icp : k;
    if (p.module == 1 && !p.blocks.count(k) && p.blocks.count(-1)) p.blocks[k] = p.blocks[-1];
    rollcon_contact* contact = p.module == 3 ? p.contact->handle() : wheel_contact(p, k);
    if (!contact) {
      why = "stresses need patches that are solved on the caller's grid: set flag 2901 to 0";
      return CNTC_err_other;
    }
    const double mirror = p.module == 1 ? p.wheel->sign : 1;
    try {
      for (SubsurfaceBlock& block : p.blocks[key]) fill_block(contact, p.patches[size_t(k - 1)], mirror, block);
    } catch (const Failure& failure) {
      why = failure.what();
      return failure.code;
    }
    write_subsurface(p, k);
  }
  return 0;
}

SubsurfaceBlock* block_of(Call& c, int iblk) {
  auto found = c.p.blocks.find(c.icp);
  if (found == c.p.blocks.end() && c.p.module == 1) found = c.p.blocks.find(-1);
  if (found == c.p.blocks.end() || iblk < 1 || size_t(iblk) > found->second.size()) return nullptr;
  return &found->second[size_t(iblk - 1)];
}

}  // namespace

void calculate_subsurface(Call& c, ErrorCode error) {
  std::string why;
  error.value = calculate_blocks(c.p, c.icp, why);
  if (!why.empty()) say(c, "%s", why.c_str());
}

void get_block_size(Call& c, int iblk, int& nx, int& ny, int& nz) {
  const SubsurfaceBlock* block = block_of(c, iblk);
  nx = block ? block->nx : -1;
  ny = block ? block->ny : -1;
  nz = block ? block->nz : -1;
  const ContactResult* r = block && block->columns.empty() ? c.result() : nullptr;
  if (!r) return;
  const auto [x, y, z] = lay_points(block->input, r->grid);
  nx = int(x.size());
  ny = int(y.size());
  nz = int(z.size());
}

void get_block_results(Call& c, int iblk, int n, int columns, const int* which, double* values) {
  const SubsurfaceBlock* block = block_of(c, iblk);
  if (!block || block->columns.empty()) return say(c, "block %d was not calculated", iblk);
  if (columns < 1 || columns > 1000 || n < 1 || !which || !values) return say(c, "there are no columns or no rows");
  const double length = c.units().length, stress = c.units().stress();
  const size_t points = block->columns.size() / 21;
  for (int j = 0; j < columns; ++j)
    for (size_t k = 0; k < std::min(points, size_t(n)); ++k) {
      const int q = which[j];
      values[size_t(j) * size_t(n) + k] =
          q < 1 || q > 21 ? -999 : block->columns[21 * k + size_t(q - 1)] / (q <= 6 ? length : stress);
    }
}

}  // namespace cntc
