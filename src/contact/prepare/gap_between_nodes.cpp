#include "contact/prepare/gap_between_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <span>
#include <utility>

#include "contact/solution.hpp"
#include "mesh/quadratic_fit.hpp"
#include "mesh/topology.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Holds a triangle or quadrilateral of the frame.
struct Patch {
  std::array<std::int32_t, 4> corner{};
  std::size_t corners = 0;
  double area = 0;
};

Patch make_patch(const Frame& frame, std::initializer_list<std::int32_t> nodes) {
  Patch patch;
  for (const std::int32_t k : nodes) patch.corner[patch.corners++] = k;
  for (std::size_t i = 0; i < patch.corners; ++i) {
    const std::size_t a = at(patch.corner[i]), b = at(patch.corner[(i + 1) % patch.corners]);
    patch.area += 0.5 * (frame.x[a] * frame.y[b] - frame.x[b] * frame.y[a]);
  }
  return patch;
}

// Returns the linear cells where `rate` is not zero everywhere. Triangles that have a long edge in common are taken two
// at a time, because the integrals at a point are what an estimate costs.
std::vector<Patch> patches(const Frame& frame, const std::vector<double>& rate) {
  const LinearCells cells = split_elements(frame.mesh);
  std::vector<Patch> result;
  std::vector<std::uint8_t> open(at(cells.size()), 0);
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    if (std::all_of(n.begin(), n.end(), [&](std::int32_t k) { return rate[at(k)] == 0; })) continue;
    if (n.size() == 4)
      result.push_back(make_patch(frame, {n[0], n[1], n[2], n[3]}));
    else
      open[at(c)] = 1;
  }
  struct Shared {
    double length;
    std::int32_t from, to;  // counter-clockwise in `left`
    std::int64_t left, right;
  };
  std::vector<Shared> shared;
  const std::vector<Side> side = sorted_sides(cells);
  for (std::size_t i = 0; i + 1 < side.size(); ++i) {
    const Side &a = side[i], &b = side[i + 1];
    if (a.low() != b.low() || a.high() != b.high() || !open[at(a.cell)] || !open[at(b.cell)]) continue;
    shared.push_back({std::hypot(frame.x[at(a.to)] - frame.x[at(a.from)], frame.y[at(a.to)] - frame.y[at(a.from)]),
                      a.from, a.to, a.cell, b.cell});
  }
  std::stable_sort(shared.begin(), shared.end(),
                   [](const Shared& a, const Shared& b) { return a.length > b.length * (1 + 1e-9); });
  const auto opposite = [&](std::int64_t c, const Shared& edge) {
    std::int32_t node = -1;
    for (const std::int32_t k : cells[c])
      if (k != edge.from && k != edge.to) node = k;
    return node;
  };
  for (const Shared& edge : shared) {
    if (!open[at(edge.left)] || !open[at(edge.right)]) continue;
    open[at(edge.left)] = open[at(edge.right)] = 0;
    result.push_back(make_patch(frame, {edge.from, opposite(edge.right, edge), edge.to, opposite(edge.left, edge)}));
  }
  for (std::int64_t c = 0; c < cells.size(); ++c)
    if (open[at(c)]) result.push_back(make_patch(frame, {cells[c][0], cells[c][1], cells[c][2]}));
  return result;
}

// Evaluates a smooth nodal field in the middle of a cell: the mean of its corners, less how far the quadratic
// polynomial fitted to the nodes around lies above that mean.
class Middle {
 public:
  explicit Middle(const Frame& frame)
      : frame_(frame), next_(neighbours(frame.nodes(), split_elements(frame.mesh), true)) {}

  double operator()(std::span<const std::int32_t> corner, double x, double y, const std::vector<double>& field) {
    double mean = 0;
    const double share = 1.0 / static_cast<double>(corner.size());
    for (const std::int32_t k : corner) mean += share * field[at(k)];
    patch_.assign(corner.begin(), corner.end());
    for (const std::int32_t k : corner) patch_.insert(patch_.end(), next_[k].begin(), next_[k].end());
    std::sort(patch_.begin(), patch_.end());
    patch_.erase(std::unique(patch_.begin(), patch_.end()), patch_.end());
    for (auto& v : at_) v.clear();
    for (const std::int32_t k : patch_) {
      at_[0].push_back(frame_.x[at(k)]);
      at_[1].push_back(frame_.y[at(k)]);
      at_[2].push_back(field[at(k)]);
    }
    const auto fit = fit_quadratic(x, y, at_[0], at_[1], at_[2]);
    if (!fit) return mean;
    double fitted_mean = 0;
    for (const std::int32_t k : corner) fitted_mean += share * (*fit)(frame_.x[at(k)], frame_.y[at(k)]);
    return mean + fit->c[0] - fitted_mean;
  }

 private:
  const Frame& frame_;
  Neighbours next_;
  std::vector<std::int32_t> patch_;
  std::vector<double> at_[3];  ///< x, y and field of the patch
};

// Computes normal displacements alone: the integrals of the tangential ones cost as much again.
std::vector<double> normal_displacements(const Solution& s, const std::vector<double>& x,
                                         const std::vector<double>& y) {
  constexpr std::size_t chunk = 64;
  const std::size_t n = at(s.prepared->problem.nodes);
  const bool coupled = s.prepared->compliance->couples() && !s.prepared->problem.op->coupling_vanished;
  std::vector<double> u(x.size(), 0.0), row[3];
  ComplianceBlock out;
  out.stride = s.prepared->problem.nodes;
  for (std::size_t c = coupled ? 0 : 2; c < 3; ++c) {
    row[c].resize(chunk * n);
    out.a[2][c] = row[c].data();
  }
  for (std::size_t first = 0; first < x.size(); first += chunk) {
    const std::size_t count = std::min(chunk, x.size() - first);
    s.prepared->compliance->block({{x.data() + first, count}, {y.data() + first, count}}, out);
    for (std::size_t c = coupled ? 0 : 2; c < 3; ++c)
      for (std::size_t i = 0; i < count; ++i)
        u[first + i] += dot(row[c].data() + i * n, s.iterate.lambda[c].data(), s.prepared->problem.nodes);
  }
  return u;
}

}  // namespace

double gap_force(const Solution& s, const std::vector<double>& rate) {
  const Problem& p = s.prepared->problem;
  const Frame& frame = s.prepared->frame;
  std::vector<double> rigid(at(p.nodes)), x, y, gap, factor;
  for (std::size_t k = 0; k < rigid.size(); ++k) rigid[k] = p.rigid_gap(k, s.iterate.motion);
  Middle middle(frame);
  for (const Patch& patch : patches(frame, rate)) {
    const std::span<const std::int32_t> corner(patch.corner.data(), patch.corners);
    const double share = 1.0 / static_cast<double>(patch.corners);
    double mx = 0, my = 0, mean_rate = 0;
    for (const std::int32_t k : corner) {
      mx += share * frame.x[at(k)];
      my += share * frame.y[at(k)];
      mean_rate += share * rate[at(k)];
    }
    x.push_back(mx);
    y.push_back(my);
    gap.push_back(middle(corner, mx, my, rigid));
    // The gap vanishes at the corners. The mean of a quadratic polynomial that does is 3/4 of its value in the middle
    // of a triangle, and 2/3 of that in a parallelogram.
    factor.push_back((patch.corners == 3 ? 0.75 : 2.0 / 3) * mean_rate * patch.area);
  }
  const std::vector<double> u = normal_displacements(s, x, y);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += factor[i] * (gap[i] - u[i]);
  return sum;
}

}  // namespace rollcon
