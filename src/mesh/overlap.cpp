#include "mesh/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace rollcon {
namespace {

struct Box {
  double low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double high[2] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(double x, double y) {
    low[0] = std::min(low[0], x), high[0] = std::max(high[0], x);
    low[1] = std::min(low[1], y), high[1] = std::max(high[1], y);
  }
  bool holds(double x, double y) const { return x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1]; }
};

/// Binary tree over cells: node i covers order[begin, end); children by halving at the median.
class BoxTree {
 public:
  BoxTree(const LinearCells& cells, std::span<const double> x, std::span<const double> y)
      : cells_(cells), x_(x), y_(y), order_(static_cast<std::size_t>(cells.size())) {
    std::iota(order_.begin(), order_.end(), std::int64_t{0});
    for (std::int64_t c = 0; c < cells.size(); ++c) {
      double sx = 0, sy = 0;
      for (std::int32_t k : cells[c]) sx += x[static_cast<std::size_t>(k)], sy += y[static_cast<std::size_t>(k)];
      const auto count = static_cast<double>(cells[c].size());
      centre_x_.push_back(sx / count);
      centre_y_.push_back(sy / count);
    }
    if (!order_.empty()) build(0, order_.size());
  }

  /// Calls f(cell) for cells whose box holds the point, until f returns true.
  template <class F>
  bool any_at(double x, double y, F f) const {
    return !part_.empty() && visit(0, x, y, f);
  }

 private:
  struct Part {
    Box box;
    std::size_t begin, end;
    std::size_t right = 0;  ///< second child (the first follows its parent); 0: leaf
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t self = part_.size();
    part_.push_back({{}, begin, end});
    Box box;
    for (std::size_t i = begin; i < end; ++i)
      for (std::int32_t k : cells_[order_[i]])
        box.add(x_[static_cast<std::size_t>(k)], y_[static_cast<std::size_t>(k)]);
    part_[self].box = box;
    if (end - begin <= 4) return self;
    const bool wide = box.high[0] - box.low[0] > box.high[1] - box.low[1];
    const std::vector<double>& position = wide ? centre_x_ : centre_y_;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::int64_t a, std::int64_t b) {
      return position[static_cast<std::size_t>(a)] < position[static_cast<std::size_t>(b)];
    });
    build(begin, middle);
    const std::size_t right = build(middle, end);
    part_[self].right = right;
    return self;
  }

  template <class F>
  bool visit(std::size_t i, double x, double y, F& f) const {
    const Part& part = part_[i];
    if (!part.box.holds(x, y)) return false;
    if (part.right) return visit(i + 1, x, y, f) || visit(part.right, x, y, f);
    for (std::size_t k = part.begin; k < part.end; ++k)
      if (f(order_[k])) return true;
    return false;
  }

  const LinearCells& cells_;
  std::span<const double> x_, y_;
  std::vector<double> centre_x_, centre_y_;
  std::vector<std::int64_t> order_;
  std::vector<Part> part_;
};

}  // namespace

ElementOverlap find_overlap(const LinearCells& cells, std::span<const double> x, std::span<const double> y,
                            double tolerance) {
  const BoxTree tree(cells, x, y);
  auto inside = [&](std::int64_t cell, double px, double py) {
    const auto n = cells[cell];
    for (std::size_t i = 0; i < n.size(); ++i) {
      const auto a = static_cast<std::size_t>(n[i]);
      const auto b = static_cast<std::size_t>(n[(i + 1) % n.size()]);
      const double ex = x[b] - x[a], ey = y[b] - y[a];
      // Twice the area against the edge squared: depth over edge length.
      const double area = ex * (py - y[a]) - ey * (px - x[a]);
      if (area <= tolerance * (ex * ex + ey * ey)) return false;
    }
    return true;
  };
  const auto cover = [&](double px, double py, auto own) {
    std::int64_t other = -1;
    tree.any_at(px, py, [&](std::int64_t d) {
      if (own(d) || !inside(d, px, py)) return false;
      other = d;
      return true;
    });
    return other;
  };
  constexpr std::int64_t unknown = -2;
  std::vector<std::int64_t> over(x.size(), unknown);  // another cell that covers the vertex; -1: none
  ElementOverlap result;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto own = cells[c];
    std::int64_t other = -1;
    double cx = 0, cy = 0;
    for (const std::int32_t k : own) {
      const auto v = static_cast<std::size_t>(k);
      cx += x[v] / static_cast<double>(own.size());
      cy += y[v] / static_cast<double>(own.size());
      if (over[v] == unknown)
        over[v] = cover(x[v], y[v], [&](std::int64_t d) {
          const auto n = cells[d];
          return std::find(n.begin(), n.end(), k) != n.end();
        });
      if (other < 0) other = over[v];
    }
    if (other < 0) other = cover(cx, cy, [&](std::int64_t d) { return d == c; });
    if (other < 0) continue;
    if (result.count++ == 0) result.first = c, result.second = other;
  }
  return result;
}

}  // namespace rollcon
