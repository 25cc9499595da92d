#include "contact/prepare/before_touch.hpp"

#include <algorithm>
#include <cmath>

#include "contact/prepare/carried_rows.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Interpolates the power 2/3 of gaps on a regular frame, because it is linear beyond a contact's edge.
class GapBetweenPlaces {
 public:
  GapBetweenPlaces(const Lattice& lattice, std::vector<double>& gap) : lattice_(lattice), root_(gap) {
    for (double& g : root_) g = std::cbrt(g * g);
  }
  double operator()(double x, double y) const {
    const double u = x - lattice_.x0, v = y - lattice_.y0;
    double part[2] = {(u * lattice_.ex + v * lattice_.ey) / lattice_.dx,
                      (v * lattice_.ex - u * lattice_.ey) / lattice_.dy};
    std::int64_t cell[2];
    for (const auto& [axis, places] : {std::pair{0, lattice_.nx}, {1, lattice_.ny}}) {
      cell[axis] = to_index(std::clamp(std::floor(part[axis]), 0.0, static_cast<double>(places - 2)));
      part[axis] -= static_cast<double>(cell[axis]);
    }
    const auto root = [&](std::int64_t i, std::int64_t j) {
      const std::int32_t k = lattice_.node[at((cell[1] + j) * lattice_.nx + cell[0] + i)];
      return k < 0 ? 0 : root_[at(k)];
    };
    const auto line = [&](std::int64_t j) { return (1 - part[0]) * root(0, j) + part[0] * root(1, j); };
    const double found = std::max(0.0, (1 - part[1]) * line(0) + part[1] * line(1));
    return found * std::sqrt(found);
  }

 private:
  const Lattice& lattice_;
  std::vector<double>& root_;
};

/// Returns how far upstream the gap of particles that roll in is taken: far from edges gaps grow faster than shifts.
double counted_distance(const PastStep& last, const Prepared& on) {
  constexpr double most = 0.4;  // part of the contact's length
  double least = INFINITY, greatest = -INFINITY;
  const std::vector<double>& x = last.on->frame.x;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (last.lambda[2][k] < 0) least = std::min(least, x[k]), greatest = std::max(greatest, x[k]);
  return std::min(on.distance, most * std::max(0.0, greatest - least));
}

}  // namespace

// Shift and gap have the same shape near the contact's edge. Their ratio is that of the compliances times that of
// tangential traction to pressure just after touch. The gap is that of the particle at the beginning of the step.
void find_shift_before_touch(const PastStep& last, const std::vector<double> (*lambda)[3], StepWorkspace& work,
                             Prepared& on, bool rolls_in) {
  Problem& p = on.problem;
  const bool rolls = on.distance != 0;
  if (rolls && !(rolls_in && on.lattice && last.on)) return;
  MotionValues before = last.motion;
  before[approach] -= p.datum;
  const std::size_t n = at(p.nodes);
  p.before_touch.assign(n, 0.0);
  work.apart.clear();
  for (std::size_t k = 0; k < n; ++k)
    if (p.used[k] && (!lambda || !((*lambda)[2][k] < 0))) work.apart.push_back(static_cast<std::int32_t>(k));
  for (auto& image : work.image) image.resize(n);
  if (lambda) p.op->images(normal_component, {}, work.apart, *lambda, work.image);
  std::vector<double>& gap = work.image[0];
  gap.assign(n, 0.0);
  for (const std::int32_t i : work.apart) {
    const std::size_t k = at(i);
    gap[k] = std::max(0.0, p.rigid_gap(k, before) - (lambda ? work.image[2][k] : work.displacement[3 * k + 2]));
  }
  const double ahead = rolls ? counted_distance(last, on) : 0;
  std::optional<GapBetweenPlaces> between;
  if (rolls) between.emplace(*on.lattice, gap);
  for (std::size_t k = 0; k < n; ++k) {
    if (!p.used[k]) continue;
    const double ratio = (p.op->own(0, 0, k) + p.op->own(1, 1, k)) / (2 * p.op->own(2, 2, k));
    p.before_touch[k] = ratio * (between ? (*between)(on.frame.x[k] + ahead, on.frame.y[k]) : gap[k]);
  }
}

}  // namespace rollcon
