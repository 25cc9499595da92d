#include "contact/problem/problem.hpp"

#include <algorithm>
#include <cmath>

#include "contact/problem/moments.hpp"
#include "support/index.hpp"

namespace rollcon {

void Iterate::resize(std::int64_t n) {
  const auto size = static_cast<std::size_t>(n);
  for (int c = 0; c < 3; ++c) {
    lambda[c].assign(size, 0.0);
    image[c].assign(size, 0.0);
  }
  slip_valid.assign(size, 1);
  gap_valid.assign(size, 1);
  motion = {};
}

void Iterate::clear() {
  resize(static_cast<std::int64_t>(lambda[0].size()));
}

void Iterate::clear_tractions() {
  const auto kept = motion;
  clear();
  motion = kept;
}

void Iterate::invalidate() {
  std::fill(slip_valid.begin(), slip_valid.end(), std::uint8_t{0});
  std::fill(gap_valid.begin(), gap_valid.end(), std::uint8_t{0});
}

void Iterate::update(const Problem& problem, Components wanted, std::int64_t i) const {
  const Operators& op = *problem.op;
  const bool all = op.all_at_once();
  if (all && op.coupled && op.tangential) wanted = {};
  const auto node = static_cast<std::int32_t>(i);
  op.images(wanted, {}, all ? std::span<const std::int32_t>{} : std::span(&node, 1), lambda, image);
  const auto mark = [&](std::vector<std::uint8_t>& valid) {
    if (all)
      std::fill(valid.begin(), valid.end(), std::uint8_t{1});
    else
      valid[at(i)] = 1;
  };
  if (wanted.slip()) mark(slip_valid);
  if (wanted.normal()) mark(gap_valid);
}

void Iterate::update_slip(const Problem& problem, std::int64_t i) const {
  if (!slip_valid[at(i)]) update(problem, slip_components, i);
}

void Iterate::update_gap(const Problem& problem, std::int64_t i) const {
  if (!gap_valid[at(i)]) update(problem, normal_component, i);
}

std::vector<double> Problem::undeformed_gaps() const {
  std::vector<double> undeformed = gap;
  for (std::size_t k = 0; k < gap.size(); ++k) undeformed[k] += closing(k) * datum;
  return undeformed;
}

std::array<double, 2> Problem::slip_column(int m, std::size_t k) const {
  std::array<double, 2> axes{0, 0};
  switch (m) {
    case xi1:
      axes = {motion_scale, 0};
      break;
    case xi2:
      axes = {0, motion_scale};
      break;
    case spin:
      axes = {-motion_scale * convection.slip_y[k], motion_scale * convection.slip_x[k]};
      break;
    default:
      return axes;
  }
  if (turn.empty()) return axes;
  const Turn& t = turn[k];
  return {t[0][0] * axes[0] + t[0][1] * axes[1], t[1][0] * axes[0] + t[1][1] * axes[1]};
}

std::array<double, 3> Problem::load_row(int m, std::size_t k) const {
  std::array<double, 3> axes{0, 0, 0};
  switch (m) {
    case xi1:
      axes[0] = weight[k];
      break;
    case xi2:
      axes[1] = weight[k];
      break;
    case approach:
      axes[2] = -weight[k];
      break;
    case tilt1:
      axes[1] = -moment_z[k];
      axes[2] = moment_y[k];
      break;
    case tilt2:
      axes[0] = moment_z[k];
      axes[2] = -moment_x[k];
      break;
    default:
      axes[0] = -moment_y[k];
      axes[1] = moment_x[k];
  }
  if (turn.empty()) return axes;
  std::array<double, 3> row{};
  for (std::size_t c = 0; c < 3; ++c)
    row[c] = turn[k][c][0] * axes[0] + turn[k][c][1] * axes[1] + turn[k][c][2] * axes[2];
  return row;
}

double load_of_pressures(const Problem& p, int motion, const std::vector<double>& normal) {
  double sum = 0;
  for (std::size_t k = 0; k < p.turn.size(); ++k) sum += p.load_row(motion, k)[2] * normal[k];
  return sum;
}

void take_frame(Problem& p, const Frame& frame) {
  p.nodes = frame.nodes();
  p.weight = frame.weight;
  p.cell_area = frame.cell_area;
  p.used = frame.used;
  p.length = std::sqrt(frame.area);
  moment_weights(frame, p.moment_x, p.moment_y, p.moment_z);
  const Axes& axes = frame.axes;
  const auto in_axes = [&](const Vec3& v) { return std::array{dot(v, axes.t1), dot(v, axes.t2), dot(v, axes.n)}; };
  p.turn.clear();
  for (std::size_t k = 0; k < frame.n.size(); ++k)
    p.turn.push_back({in_axes(frame.t1[k]), in_axes(frame.t2[k]), in_axes(frame.n[k])});
  const std::size_t n = at(p.nodes);
  for (std::vector<double>& v : p.tilting) v.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = frame.x[k], y = frame.y[k], z = frame.z[k];
    const std::array normal = p.turn.empty() ? std::array{0.0, 0.0, 1.0} : p.turn[k][2];
    p.tilting[0][k] = y * normal[2] - z * normal[1];
    p.tilting[1][k] = z * normal[0] - x * normal[2];
  }
}

void take_strips(Problem& p, const Frame& frame) {
  const strips::StripLayout& l = frame.strips->layout;
  const double* g = frame.strips->geometry.data();
  p.weight = frame.weight;
  p.cell_area = frame.cell_area;
  p.length = std::sqrt(frame.area);
  for (auto* moment : {&p.moment_x, &p.moment_y, &p.moment_z}) std::fill(moment->begin(), moment->end(), 0.0);
  for (std::size_t i = 0; i < l.centroid.size(); ++i) {
    const std::size_t k = at(frame.strips->node[i]);
    p.moment_x[k] = frame.weight[k] * l.x(l.centroid[i], g);
    p.moment_y[k] = frame.weight[k] * l.y(l.centroid[i], g);
  }
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    p.tilting[0][k] = frame.y[k];
    p.tilting[1][k] = -frame.x[k];
  }
}

LoadSum load_on_body1(const Problem& p, int motion, const std::vector<double> (&lambda)[3]) {
  LoadSum sum;
  const bool by_rows = !p.turn.empty() || motion >= tilt1;
  for (std::size_t k = 0; by_rows && k < at(p.nodes); ++k) {
    const std::array<double, 3> row = p.load_row(motion, k);
    for (std::size_t c = 0; c < 3; ++c) {
      const double term = row[c] * lambda[c][k];
      sum.value += term;
      sum.magnitude += std::abs(term);
    }
  }
  if (by_rows) return sum;
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.nodes); ++k) {
    double term = 0;
    switch (motion) {
      case xi1:
        term = p.weight[k] * lambda[0][k];
        break;
      case xi2:
        term = p.weight[k] * lambda[1][k];
        break;
      case approach:
        term = -p.weight[k] * lambda[2][k];
        break;
      default:
        term = p.moment_x[k] * lambda[1][k] - p.moment_y[k] * lambda[0][k];
    }
    sum.value += term;
    sum.magnitude += std::abs(term);
  }
  return sum;
}

double load_error(const Problem& p, const Prescribed& given, Part part, const std::vector<double> (&lambda)[3]) {
  return load_error(given, part, [&](int m) { return load_on_body1(p, m, lambda); });
}

void sum_tractions(const Problem& p, const std::vector<double> (&lambda)[3], Vec3& force, Vec3& moment) {
  force = moment = {};
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.nodes); ++k) {
    Vec3 t{lambda[0][k], lambda[1][k], lambda[2][k]};
    if (!p.turn.empty()) {
      t = {};
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t c = 0; c < 3; ++c) t[j] += lambda[c][k] * p.turn[k][c][j];
    }
    const Vec3 m = cross({p.moment_x[k], p.moment_y[k], p.moment_z[k]}, t);
    for (std::size_t j = 0; j < 3; ++j) force[j] += p.weight[k] * t[j], moment[j] += m[j];
  }
}

void set_scales(Problem& problem) {
  const Operators& op = *problem.op;
  const std::size_t n = at(problem.nodes);
  problem.rn.assign(n, 0.0);
  problem.rt.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k)
    if (problem.used[k]) problem.rn[k] = 1 / std::abs(op.own(2, 2, k));
  if (!op.tangential) return;
  double mean = 0;
  std::int64_t counted = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!problem.used[k]) continue;
    const double norm = std::max(op.slip_norm(0, k), op.slip_norm(1, k));
    if (norm > 0) {
      problem.rt[k] = 1 / norm;
      mean += problem.rt[k];
      ++counted;
    }
  }
  mean = counted > 0 ? mean / static_cast<double>(counted) : 1;
  for (std::size_t k = 0; k < n; ++k)
    if (problem.used[k] && problem.rt[k] == 0) problem.rt[k] = mean;
}

void estimate_scales(Problem& p) {
  // A square of side h under unit pressure sinks 1.12 h / E*; across it slip per unit speed changes by a part of 1 /
  // E*.
  constexpr double sinking = 1.12, slipping = 0.5;
  const std::size_t n = at(p.nodes);
  p.rn.assign(n, 0.0);
  p.rt.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    if (!p.used[k]) continue;
    p.rn[k] = p.stiffness / (sinking * std::sqrt(p.cell_area[k]));
    p.rt[k] = p.stiffness * slipping;
  }
}

}  // namespace rollcon
