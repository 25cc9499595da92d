#include "contact/linear/reduced_system.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {

void ReducedSystem::gather(const Problem& problem, const Prescribed& given, Part part,
                           std::span<const std::int32_t> active, const std::vector<double> (&lambda)[3], bool changed) {
  const bool same = !changed && part == part_ && active.size() == nodes_.size() &&
                    std::equal(active.begin(), active.end(), nodes_.begin());
  if (!same) {
    part_ = part;
    nodes_.assign(active.begin(), active.end());
    count_ = 0;
    if (tangential())
      component_[static_cast<std::size_t>(count_++)] = 0, component_[static_cast<std::size_t>(count_++)] = 1;
    if (normal()) component_[static_cast<std::size_t>(count_++)] = 2;
    const auto na = static_cast<std::int64_t>(nodes_.size());
    const std::int64_t rows = rows_ = count_ * na;
    op_ = problem.op.get();
    formed_ = !op_->all_at_once();
    product_.resize(static_cast<std::size_t>(rows));
    law_.resize(nodes_.size());
    rn_.resize(nodes_.size());
    rt_.resize(nodes_.size());
    for (std::size_t a = 0; a < nodes_.size(); ++a) {
      const auto i = static_cast<std::size_t>(nodes_[a]);
      rn_[a] = problem.rn[i];
      rt_[a] = problem.rt.empty() ? 0 : given.slip_scale * problem.rt[i];
    }
    if (!formed_) {
      for (int c = 0; c < count_; ++c)
        for (std::vector<double>* v : {&field_lambda_[component(c)], &field_image_[component(c)]})
          v->assign(static_cast<std::size_t>(problem.nodes), 0.0);
      gather_borders(problem, given, lambda);
      return;
    }
    if (matrix_.bytes() < static_cast<std::size_t>(rows * rows) * sizeof(double))
      matrix_.reserve(with_room(rows), with_room(rows));
    matrix_.resize(rows, rows);
    for (int r = 0; r < count_; ++r)
      for (std::int64_t a = 0; a < na; ++a) {
        const int row = component(r);
        const double scale = row == 2 ? rn_[static_cast<std::size_t>(a)] : rt_[static_cast<std::size_t>(a)];
        double* out = matrix_.row(r * na + a);
        for (int c = 0; c < count_; ++c, out += na) {
          const double* from =
              op_->row(row, component(c), static_cast<std::size_t>(nodes_[static_cast<std::size_t>(a)]));
          for (std::int64_t j = 0; j < na; ++j) out[j] = from ? scale * from[nodes_[static_cast<std::size_t>(j)]] : 0;
        }
      }
  }
  gather_borders(problem, given, lambda);
}

void ReducedSystem::gather_borders(const Problem& problem, const Prescribed& given,
                                   const std::vector<double> (&lambda)[3]) {
  borders_ = 0;
  for (const int m : {xi1, xi2, spin, tilt1, tilt2, approach}) {
    if (!has_motion(part_, m) || !given.by_force[static_cast<std::size_t>(m)]) continue;
    add_border(problem, given, m, lambda);
    // The border is dropped if no active node has a part in the load and no load is asked for: one node at the origin
    // has no moment. motion() then says zero.
    const Border& last = border_[static_cast<std::size_t>(borders_ - 1)];
    const bool carried = std::any_of(std::begin(last.row), std::end(last.row), [](auto& row) { return !row.empty(); });
    if (!carried && last.right == 0 && given.value[static_cast<std::size_t>(m)] == 0) --borders_;
  }
  size_ = count_ * active() + borders_;
}

void ReducedSystem::add_border(const Problem& problem, const Prescribed& given, int m,
                               const std::vector<double> (&lambda)[3]) {
  Border& border = border_[static_cast<std::size_t>(borders_++)];
  const std::size_t na = nodes_.size();
  border.motion = m;
  double mean = 0, area = 0;
  for (std::size_t a = 0; a < na; ++a) {
    mean += changes_gap(m) ? rn_[a] : rt_[a];
    area += std::abs(problem.weight[static_cast<std::size_t>(nodes_[a])]);
  }
  mean = na > 0 ? mean / static_cast<double>(na) : 1;
  const double arm = m >= spin ? problem.length : 1;
  border.scale = mean * arm;
  const double unit = area * arm;
  const double sign = m == approach ? -1 : 1;  // sign of the load row, which makes it symmetric with the column
  border.per_load = sign / unit;
  border.right = sign * given.value[static_cast<std::size_t>(m)] / unit;
  for (int c = 0; c < 3; ++c) {
    border.column[c].clear();
    border.row[c].clear();
    const bool own = c == 2 ? normal() : tangential();
    if (!own) {
      for (std::size_t k = 0; k < problem.turn.size(); ++k)
        border.right -= sign * problem.load_row(m, k)[static_cast<std::size_t>(c)] * lambda[c][k] / unit;
      continue;
    }
    border.column[c].resize(na);
    border.row[c].resize(na);
    bool any_column = false, any_row = false;
    for (std::size_t a = 0; a < na; ++a) {
      const auto i = static_cast<std::size_t>(nodes_[a]);
      double column = 0;
      if (c < 2)
        column = rt_[a] * problem.slip_column(m, i)[static_cast<std::size_t>(c)];
      else
        column = rn_[a] * problem.closing(m, i);
      border.column[c][a] = column / border.scale;
      border.row[c][a] = sign * problem.load_row(m, i)[static_cast<std::size_t>(c)] / unit;
      any_column = any_column || border.column[c][a] != 0;
      any_row = any_row || border.row[c][a] != 0;
    }
    if (!any_column) border.column[c].clear();
    if (!any_row) border.row[c].clear();
  }
}

// Fills a right side; constant(a, c): what tangential row c of node a equals, of_load(border): its load row.
template <class Constant, class OfLoad>
void ReducedSystem::fill_side(std::span<const double> gap, std::span<const double> slip1, std::span<const double> slip2,
                              Constant constant, OfLoad of_load, std::vector<double>& b) const {
  const std::size_t na = nodes_.size();
  b.resize(static_cast<std::size_t>(size_));
  if (tangential())
    for (std::size_t a = 0; a < na; ++a) {
      const TangentialLaw& law = law_[a];
      const double s1 = rt_[a] * slip1[a], s2 = rt_[a] * slip2[a];
      for (std::size_t c = 0; c < 2; ++c) b[c * na + a] = constant(a, c) - law.slip[c][0] * s1 - law.slip[c][1] * s2;
    }
  if (normal()) {
    const std::size_t first = static_cast<std::size_t>(count_ - 1) * na;
    for (std::size_t a = 0; a < na; ++a) b[first + a] = rn_[a] * gap[a];
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(borders_); ++k)
    b[static_cast<std::size_t>(count_) * na + k] = of_load(border_[k]);
}

void ReducedSystem::right_side(std::span<const double> known_gap, std::span<const double> known_slip1,
                               std::span<const double> known_slip2, std::vector<double>& b) const {
  fill_side(
      known_gap, known_slip1, known_slip2, [&](std::size_t a, std::size_t c) { return law_[a].constant[c]; },
      [](const Border& border) { return border.right; }, b);
}

void ReducedSystem::rate_side(std::span<const double> gap, std::span<const double> slip1, std::span<const double> slip2,
                              std::span<const double> bound1, std::span<const double> bound2, const MotionValues& load,
                              std::vector<double>& b) const {
  fill_side(
      gap, slip1, slip2, [&](std::size_t a, std::size_t c) { return c == 0 ? bound1[a] : bound2[a]; },
      [&](const Border& border) { return border.per_load * load[static_cast<std::size_t>(border.motion)]; }, b);
}

// Applies operators that are not formed; tractions of nodes that are not active stay zero in field_lambda_.
void ReducedSystem::apply_field(const double* x) {
  const std::size_t na = nodes_.size();
  for (int r = 0; r < count_; ++r)
    for (std::size_t a = 0; a < na; ++a)
      field_lambda_[component(r)][static_cast<std::size_t>(nodes_[a])] = x[static_cast<std::size_t>(r) * na + a];
  op_->images(components_of(part_), components_of(part_), nodes_, field_lambda_, field_image_);
  for (int r = 0; r < count_; ++r)
    for (std::size_t a = 0; a < na; ++a) {
      const int c = component(r);
      product_[static_cast<std::size_t>(r) * na + a] =
          (c == 2 ? rn_[a] : rt_[a]) * field_image_[c][static_cast<std::size_t>(nodes_[a])];
    }
}

void ReducedSystem::border_column(int k, double* y) const {
  const std::size_t na = nodes_.size();
  const Border& border = border_[static_cast<std::size_t>(k)];
  const auto entry = [&](int c, std::size_t a) { return border.column[c].empty() ? 0.0 : border.column[c][a]; };
  if (tangential())
    for (std::size_t a = 0; a < na; ++a)
      for (std::size_t i = 0; i < 2; ++i)
        y[i * na + a] = law_[a].slip[i][0] * entry(0, a) + law_[a].slip[i][1] * entry(1, a);
  if (!normal()) return;
  const std::size_t first = static_cast<std::size_t>(count_ - 1) * na;
  for (std::size_t a = 0; a < na; ++a) y[first + a] = entry(2, a);
}

double ReducedSystem::border_product(int k, const double* x) const {
  const std::size_t na = nodes_.size();
  double sum = 0;
  for (int c = 0; c < count_; ++c) {
    const auto& row = border_[static_cast<std::size_t>(k)].row[component(c)];
    for (std::size_t a = 0; a < row.size(); ++a) sum += row[a] * x[static_cast<std::size_t>(c) * na + a];
  }
  return sum;
}

void ReducedSystem::apply(const double* x, double* y) {
  const std::int64_t rows = rows_;
  if (!formed_)
    apply_field(x);
  else
    multiply(matrix_.data(), rows, rows, x, 0, product_.data());
  add_laws(x, y);
}

void ReducedSystem::apply_known(const double* x, std::span<const double> product, double* y) {
  std::copy(product.begin(), product.end(), product_.begin());
  add_laws(x, y);
}

// Adds laws and borders to the scaled operator rows.
void ReducedSystem::add_laws(const double* x, double* y) const {
  const std::size_t na = nodes_.size();
  const std::int64_t rows = rows_;
  std::copy(product_.begin(), product_.begin() + rows, y);
  const double* motion = x + rows;
  for (int k = 0; k < borders_; ++k) {
    const Border& border = border_[static_cast<std::size_t>(k)];
    double sum = 0;
    for (int c = 0; c < count_; ++c) {
      const auto& column = border.column[component(c)];
      const auto& row = border.row[component(c)];
      const std::size_t first = static_cast<std::size_t>(c) * na;
      for (std::size_t a = 0; a < column.size(); ++a) y[first + a] += column[a] * motion[k];
      for (std::size_t a = 0; a < row.size(); ++a) sum += row[a] * x[first + a];
    }
    y[rows + k] = sum;
  }
  if (!tangential()) return;
  const bool full = normal();
  for (std::size_t a = 0; a < na; ++a) {
    const TangentialLaw& law = law_[a];
    const double s1 = y[a], s2 = y[na + a];
    const double l1 = x[a], l2 = x[na + a], ln = full ? x[2 * na + a] : 0;
    y[a] = law.own[0][0] * l1 + law.own[0][1] * l2 + law.own[0][2] * ln + law.slip[0][0] * s1 + law.slip[0][1] * s2;
    y[na + a] =
        law.own[1][0] * l1 + law.own[1][1] * l2 + law.own[1][2] * ln + law.slip[1][0] * s1 + law.slip[1][1] * s2;
  }
}

void ReducedSystem::start(const std::vector<double> (&lambda)[3], const MotionValues& motion,
                          std::vector<double>& x) const {
  const std::size_t na = nodes_.size();
  x.resize(static_cast<std::size_t>(size_));
  for (int r = 0; r < count_; ++r)
    for (std::size_t a = 0; a < na; ++a)
      x[static_cast<std::size_t>(r) * na + a] = lambda[component(r)][static_cast<std::size_t>(nodes_[a])];
  for (int k = 0; k < borders_; ++k) {
    const Border& border = border_[static_cast<std::size_t>(k)];
    x[static_cast<std::size_t>(rows_ + k)] = motion[static_cast<std::size_t>(border.motion)] * border.scale;
  }
}

void ReducedSystem::pair_block(std::int64_t a, double (&block)[3][3]) const {
  const std::int64_t na = active();
  double own[3][3] = {};
  for (int r = 0; r < count_; ++r)
    for (int c = 0; c < count_; ++c) {
      const int row = component(r);
      const double scale = row == 2 ? normal_scale(a) : slip_scale(a);
      own[r][c] = formed_ ? matrix_.row(r * na + a)[c * na + a]
                          : scale * op_->own(row, component(c), static_cast<std::size_t>(nodes_[at(a)]));
    }
  for (int r = 0; r < count_; ++r)
    for (int c = 0; c < count_; ++c) {
      block[r][c] = own[r][c];
      if (component(r) == 2) continue;
      const TangentialLaw& law = law_[static_cast<std::size_t>(a)];
      block[r][c] = law.own[r][component(c)] + law.slip[r][0] * own[0][c] + law.slip[r][1] * own[1][c];
    }
}

double ReducedSystem::motion(const Prescribed& given, int m, const double* x) const {
  for (int k = 0; k < borders_; ++k)
    if (border_[static_cast<std::size_t>(k)].motion == m)
      return x[rows_ + k] / border_[static_cast<std::size_t>(k)].scale;
  return given.value[static_cast<std::size_t>(m)];
}

}  // namespace rollcon
