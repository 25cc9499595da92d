#include "bodies/halfspace/strip_integrals.hpp"

#include <cstddef>

namespace rollcon::strips {

void StripIntegrals::lay(const StripLayout& layout, const StripBodies& bodies, const double* geometry) {
  layout_ = &layout;
  bodies_ = bodies;
  geometry_ = geometry;
  const auto places = static_cast<std::size_t>(layout.places);
  place_.resize(places);
  foot_.resize(3 * places);
  scale_.resize(static_cast<std::size_t>(layout.rows));
  for (auto& f : field_) f.resize(places);
  for (auto& v : values_) v.resize(20 * places);
  const int columns = layout.counts.along + 1;
  for (int row = 0; row < layout.rows; ++row) {
    const int part = layout.part_of(row), line = row % layout.rows_each;
    const double c = geometry[row], s = geometry[layout.half_of(row)], m = geometry[layout.centre_of(part)],
                 w = geometry[layout.width_of(part)];
    scale_[row] = 1 / (s * w);
    for (int i = 0; i < columns; ++i) place_[row * columns + i] = c + s * layout.along[i];
    for (int f = 0; f < 3; ++f)
      for (int i = 0; i < columns; ++i) foot_[f * layout.places + row * columns + i] = m + w * layout.across[line + f];
  }
}

void StripIntegrals::set_field(int field, const double* traction) {
  const StripLayout& l = *layout_;
  const int columns = l.counts.along + 1;
  double* q = field_[field].data();
  for (int row = 0; row < l.rows; ++row) {
    double before = 0, left = 0;
    for (int i = 0; i < columns; ++i) {
      const double after = i < l.nodes_each ? traction[row * l.nodes_each + i] : 0;
      const double right = i < columns - 1 ? (after - before) * l.slope[i] : 0;
      q[row * columns + i] = (right - left) * scale_[row];
      before = after;
      left = right;
    }
  }
}

Observation StripIntegrals::observe(Displacement what, bool rates, double x, double y, int slot) {
  const StripLayout& l = *layout_;
  KernelJob job{};
  job.x = x;
  job.y = y;
  job.count = l.places;
  job.place = place_.data();
  for (int f = 0; f < 3; ++f) {
    job.foot[f] = foot_.data() + f * l.places;
    job.weight[f] = l.weight.data() + f * l.places;
    job.turn[f] = l.turn.data() + f * l.places;
  }
  job.cn = bodies_.cn;
  job.cv = bodies_.cv;
  job.ck = bodies_.ck;
  job.values = values_[slot].data();
  const StripKernels& kernels = strip_kernels();
  (what == Displacement::slip ? kernels.slip : kernels.normal)[coupled()][rates](job);
  return {job.values, (rates ? 4 : 1) * l.places};
}

void StripIntegrals::add_row(const Observation& from, int kind, double factor, double* row) const {
  const StripLayout& l = *layout_;
  const int inside = l.nodes_each;
  const double* g = from.values + static_cast<std::ptrdiff_t>(kind) * from.stride;
  for (int k = 0; k < l.rows; ++k, g += inside + 2, row += inside) {
    const double scale = factor * scale_[k];
    for (int i = 0; i < inside; ++i)
      row[i] += scale * ((g[i] - g[i + 1]) * l.slope[i] + (g[i + 2] - g[i + 1]) * l.slope[i + 1]);
  }
}

double StripIntegrals::displacement(const Observation& from, int kind, int field) const {
  const double* g = from.values + static_cast<std::ptrdiff_t>(kind) * from.stride;
  const double* q = field_[field].data();
  const int used = layout_->rows * (layout_->counts.along + 1);
  double sum = 0;
  for (int i = 0; i < used; ++i) sum += q[i] * g[i];
  return sum;
}

double StripIntegrals::add_rates(const Observation& from, int kind, int field, const StripPoint& at, double factor,
                                 double* rates) const {
  const StripLayout& l = *layout_;
  const double* g = from.values + static_cast<std::ptrdiff_t>(kind) * from.stride;
  const double *gx = g + l.places, *gy = gx + l.places, *gw = gy + l.places, *q = field_[field].data();
  const int columns = l.counts.along + 1;
  double sum = 0, sum_x = 0, sum_y = 0;
  for (int k = 0; k < l.rows; ++k) {
    double u = 0, ux = 0, uxv = 0, uy = 0, uyw = 0;
    for (int i = 0; i < columns; ++i, ++g, ++gx, ++gy, ++gw, ++q) {
      u += *q * *g;
      ux += *q * *gx;
      uxv += *q * *gx * l.along[i];
      uy += *q * *gy;
      uyw += *q * *gw;
    }
    const int part = l.part_of(k), half = l.half_of(k), width = l.width_of(part);
    rates[k] -= factor * ux;
    rates[half] -= factor * (uxv + u / geometry_[half]);
    rates[l.centre_of(part)] -= factor * uy;
    rates[width] -= factor * (uyw + u / geometry_[width]);
    sum += u;
    sum_x += ux;
    sum_y += uy;
  }
  l.add_motion(at, factor * sum_x, factor * sum_y, rates);
  return sum;
}

}  // namespace rollcon::strips
