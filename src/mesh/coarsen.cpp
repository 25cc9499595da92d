/// Takes out nodes one by one by moving them onto a neighbour that stays (collapsing the edge between them), which
/// leaves a valid triangulation at any time.

#include "mesh/coarsen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>

#include "mesh/topology.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using Triangle = std::array<std::int32_t, 3>;

std::int32_t middle_node(const Frame& frame) {
  double x = 0, y = 0, nodes = 0;
  for (std::size_t k = 0; k < frame.used.size(); ++k)
    if (frame.used[k]) x += frame.x[k], y += frame.y[k], ++nodes;
  std::int32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < frame.used.size(); ++k) {
    const double distance = std::hypot(frame.x[k] - x / nodes, frame.y[k] - y / nodes);
    if (frame.used[k] && distance < least * (1 - 1e-9)) best = static_cast<std::int32_t>(k), least = distance;
  }
  return best;
}

// Returns the node in the middle, or one beside it that has more neighbours: on triangles that halve a grid's
// quadrilaterals by turns, nodes of four and of eight neighbours alternate, and those of eight are a coarser grid.
std::int32_t first_node(const Frame& frame, const Neighbours& next) {
  const std::int32_t middle = middle_node(frame);
  std::int32_t best = middle;
  for (const std::int32_t k : next[middle])
    if (next[k].size() > next[best].size()) best = k;
  return best;
}

// Chooses the nodes that stay: no two of them are neighbours, and every other node is next to one. Starting in the
// middle, the next is always the one with the greatest fraction of its neighbours out already, which is every second
// one on a grid.
std::vector<std::uint8_t> choose_nodes(const Frame& frame, const Neighbours& next) {
  enum : std::uint8_t { undecided, stays, goes };
  const std::size_t n = at(frame.nodes());
  std::vector<std::uint8_t> fate(n, undecided);
  std::vector<std::size_t> out(n, 0);               // number of neighbours that go
  std::set<std::pair<double, std::int32_t>> queue;  // by falling fraction, then in the order of nodes
  const auto key = [&](std::int32_t k) {
    return std::pair(-static_cast<double>(out[at(k)]) / static_cast<double>(next[k].size()), k);
  };
  for (std::size_t k = 0; k < n; ++k)
    if (frame.used[k]) queue.insert(key(static_cast<std::int32_t>(k)));
  for (std::int32_t k = first_node(frame, next);; k = queue.begin()->second) {
    queue.erase(key(k));
    fate[at(k)] = stays;
    for (const std::int32_t j : next[k]) {
      if (fate[at(j)] != undecided) continue;
      fate[at(j)] = goes;
      queue.erase(key(j));
      for (const std::int32_t i : next[j]) {
        if (fate[at(i)] != undecided) continue;
        queue.erase(key(i));
        ++out[at(i)];
        queue.insert(key(i));
      }
    }
    if (queue.empty()) break;
  }
  for (auto& f : fate) f = f == stays;
  return fate;
}

// Measures lengths around a node the way its neighbours show them, so that a stretched mesh is judged as if it were
// not.
struct Metric {
  double xx = 0, xy = 0, yy = 0, root = 0;  ///< square root of the determinant in `root`

  double operator()(double x, double y) const { return xx * x * x + 2 * xy * x * y + yy * y * y; }
};

Metric metric_of(const Frame& frame, std::int32_t k, std::span<const std::int32_t> next) {
  double xx = 0, xy = 0, yy = 0;
  for (const std::int32_t j : next) {
    const double x = frame.x[at(j)] - frame.x[at(k)], y = frame.y[at(j)] - frame.y[at(k)];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double determinant = xx * yy - xy * xy;
  return {yy / determinant, -xy / determinant, xx / determinant, 1 / std::sqrt(determinant)};
}

class Triangulation {
 public:
  explicit Triangulation(const Frame& frame) : frame_(frame) {
    const LinearCells cells = split_elements(frame.mesh);
    const Neighbours next = neighbours(frame.nodes(), cells, true);
    stays_ = choose_nodes(frame, next);
    around_.resize(frame.used.size());
    metric_.resize(frame.used.size());
    for (std::size_t k = 0; k < metric_.size(); ++k) {
      const auto node = static_cast<std::int32_t>(k);
      if (frame.used[k]) metric_[k] = metric_of(frame, node, next[node]);
    }
    for (std::int64_t c = 0; c < cells.size(); ++c) {
      const auto n = cells[c];
      if (n.size() == 3) {
        add({n[0], n[1], n[2]});
      } else if (distance(n[0], n[2]) <= distance(n[1], n[3])) {
        add({n[0], n[1], n[2]});
        add({n[0], n[2], n[3]});
      } else {
        add({n[0], n[1], n[3]});
        add({n[1], n[2], n[3]});
      }
    }
  }

  std::vector<Triangle> coarsen() {
    std::vector<std::int32_t> rest;
    for (std::size_t k = 0; k < around_.size(); ++k)
      if (!stays_[k] && !around_[k].empty()) rest.push_back(static_cast<std::int32_t>(k));
    for (std::size_t before = rest.size() + 1; rest.size() < before;) {
      before = rest.size();
      std::erase_if(rest, [this](std::int32_t k) { return take_out(k); });
    }
    std::erase_if(triangle_, [](const Triangle& t) { return t[0] == t[1]; });
    return triangle_;
  }

 private:
  double distance(std::int32_t a, std::int32_t b) const {
    return std::hypot(frame_.x[at(a)] - frame_.x[at(b)], frame_.y[at(a)] - frame_.y[at(b)]);
  }
  double twice_area(const Triangle& t) const {
    const std::size_t a = at(t[0]), b = at(t[1]), c = at(t[2]);
    const std::vector<double>&x = frame_.x, &y = frame_.y;
    return (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
  }
  // Returns 1 for an equilateral triangle, 0 for a flat one, and a negative value for one turned over.
  double quality(const Triangle& t, const Metric& metric) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = at(t[i]), b = at(t[(i + 1) % 3]);
      sum += metric(frame_.x[b] - frame_.x[a], frame_.y[b] - frame_.y[a]);
    }
    return 2 * std::sqrt(3.0) * metric.root * twice_area(t) / sum;
  }
  bool contains(std::int32_t t, std::int32_t k) const {
    const Triangle& n = triangle_[at(t)];
    return n[0] == k || n[1] == k || n[2] == k;
  }
  void add(const Triangle& t) {
    for (const std::int32_t k : t) around_[at(k)].push_back(static_cast<std::int32_t>(triangle_.size()));
    triangle_.push_back(t);
  }
  std::vector<std::int32_t> ring(std::int32_t k) const {
    std::vector<std::int32_t> nodes;
    for (const std::int32_t t : around_[at(k)])
      for (const std::int32_t j : triangle_[at(t)])
        if (j != k) nodes.push_back(j);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  // Says whether the rim stays: a node of the rim may move along it only, where it is straight.
  bool keeps_rim(std::int32_t k, std::int32_t target) const {
    if (!frame_.rim[at(k)]) return true;
    std::vector<std::int32_t> along;
    for (const std::int32_t j : ring(k))
      if (std::count_if(around_[at(k)].begin(), around_[at(k)].end(), [&](std::int32_t t) { return contains(t, j); }) ==
          1)
        along.push_back(j);
    if (along.size() != 2 || (along[0] != target && along[1] != target)) return false;
    constexpr double straight = 1e-9;
    return std::abs(twice_area({k, along[0], along[1]})) < straight * distance(k, along[0]) * distance(k, along[1]);
  }

  // Returns the quality of the worst triangle left around k moved onto target; negative if the move must not be done.
  double outcome(std::int32_t k, std::int32_t target) const {
    if (!keeps_rim(k, target)) return -1;
    const std::vector<std::int32_t> a = ring(k), b = ring(target);
    std::vector<std::int32_t> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    std::size_t lost = 0;
    double worst = std::numeric_limits<double>::infinity();
    for (const std::int32_t t : around_[at(k)]) {
      if (contains(t, target)) {
        ++lost;
        continue;
      }
      Triangle moved = triangle_[at(t)];
      std::replace(moved.begin(), moved.end(), k, target);
      worst = std::min(worst, quality(moved, metric_[at(k)]));
    }
    constexpr double flat = 1e-2;
    return common.size() == lost && worst > flat ? worst : -1;
  }

  bool take_out(std::int32_t k) {
    std::int32_t target = -1;
    double best = 0;
    for (const std::int32_t j : ring(k)) {
      if (!stays_[at(j)]) continue;
      const double worst = outcome(k, j);
      if (worst > best * (1 + 1e-9)) best = worst, target = j;
    }
    if (target < 0) return false;
    for (const std::int32_t t : std::vector<std::int32_t>(around_[at(k)])) {
      Triangle& n = triangle_[at(t)];
      if (contains(t, target)) {
        for (const std::int32_t j : n) std::erase(around_[at(j)], t);
        n = {0, 0, 0};
        continue;
      }
      std::replace(n.begin(), n.end(), k, target);
      around_[at(target)].push_back(t);
    }
    around_[at(k)].clear();
    return true;
  }

  const Frame& frame_;
  std::vector<std::uint8_t> stays_;
  std::vector<Metric> metric_;
  std::vector<Triangle> triangle_;  ///< lost triangles have all corners 0
  std::vector<std::vector<std::int32_t>> around_;
};

}  // namespace

CoarseMesh coarsen(const Frame& frame) {
  CoarseMesh mesh;
  mesh.corner = Triangulation(frame).coarsen();
  std::vector<std::int32_t> place(frame.used.size(), -1);
  for (const Triangle& t : mesh.corner)
    for (const std::int32_t k : t) place[at(k)] = 0;
  for (std::size_t k = 0; k < place.size(); ++k)
    if (place[k] == 0) {
      place[k] = static_cast<std::int32_t>(mesh.node.size());
      mesh.node.push_back(static_cast<std::int32_t>(k));
    }
  for (Triangle& t : mesh.corner)
    for (std::int32_t& k : t) k = place[at(k)];
  return mesh;
}

}  // namespace rollcon
