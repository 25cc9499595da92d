#include "contact/operators/hierarchical/square_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::size_t most_nodes = 48;  // squares of more nodes are divided
constexpr int most_levels = 24;

}  // namespace

SquareCells::SquareCells(const Frame& frame, std::span<const double> reach) {
  for (std::size_t k = 0; k < frame.x.size(); ++k) node_.push_back({frame.x[k], frame.y[k], reach[k]});
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    double low_x = INFINITY, high_x = -INFINITY, low_y = INFINITY, high_y = -INFINITY;
    for (const std::int32_t k : frame.mesh.element(e)) {
      low_x = std::min(low_x, frame.x[at(k)]), high_x = std::max(high_x, frame.x[at(k)]);
      low_y = std::min(low_y, frame.y[at(k)]), high_y = std::max(high_y, frame.y[at(k)]);
    }
    element_.push_back(
        {0.5 * (low_x + high_x), 0.5 * (low_y + high_y), 0.5 * std::max(high_x - low_x, high_y - low_y)});
  }
  double low_x = INFINITY, high_x = -INFINITY, low_y = INFINITY, high_y = -INFINITY;
  SquareCell root;
  for (const auto* all : {&node_, &element_})
    for (std::size_t k = 0; k < all->size(); ++k) {
      const Extent& e = (*all)[k];
      low_x = std::min(low_x, e.x), high_x = std::max(high_x, e.x);
      low_y = std::min(low_y, e.y), high_y = std::max(high_y, e.y);
      (all == &node_ ? root.node : root.element).push_back(static_cast<std::int32_t>(k));
    }
  width_ = std::max(high_x - low_x, high_y - low_y) * (1 + 1e-9);
  origin_ = {0.5 * (low_x + high_x - width_), 0.5 * (low_y + high_y - width_)};
  cell_.push_back(std::move(root));
  for (std::size_t c = 0; c < cell_.size(); ++c) divide(static_cast<std::int32_t>(c));
  meet(0, 0);
  std::sort(far_.begin(), far_.end(), [](const FarCells& a, const FarCells& b) {
    return std::tie(a.shift, a.target, a.source) < std::tie(b.shift, b.target, b.source);
  });
}

double SquareCells::width(const SquareCell& c) const {
  return std::ldexp(width_, -c.level);
}

Vec2 SquareCells::centre(const SquareCell& c) const {
  const double w = width(c);
  return {origin_[0] + (static_cast<double>(c.i) + 0.5) * w, origin_[1] + (static_cast<double>(c.j) + 0.5) * w};
}

void SquareCells::divide(std::int32_t index) {
  SquareCell parent = cell_[at(index)];
  const double half = width(parent) / 2;
  const auto reaches_far = [&](const std::vector<Extent>& all, const std::vector<std::int32_t>& within) {
    return std::any_of(within.begin(), within.end(),
                       [&](std::int32_t k) { return all[at(k)].reach > overhang * half; });
  };
  if (parent.node.size() <= most_nodes || parent.level == most_levels || reaches_far(node_, parent.node) ||
      reaches_far(element_, parent.element))
    return;
  const Vec2 middle = centre(parent);
  for (int q = 0; q < 4; ++q) {
    SquareCell child;
    child.level = parent.level + 1;
    child.i = 2 * parent.i + q % 2;
    child.j = 2 * parent.j + q / 2;
    const auto take = [&](const std::vector<Extent>& all, const std::vector<std::int32_t>& from,
                          std::vector<std::int32_t>& to) {
      for (const std::int32_t k : from)
        if ((all[at(k)].x >= middle[0]) == (q % 2 == 1) && (all[at(k)].y >= middle[1]) == (q / 2 == 1)) to.push_back(k);
    };
    take(node_, parent.node, child.node);
    take(element_, parent.element, child.element);
    parent.child[at(q)] = static_cast<std::int32_t>(cell_.size());
    cell_.push_back(std::move(child));
  }
  parent.node = {};
  parent.element = {};
  cell_[at(index)] = std::move(parent);
}

// Squares are far from each other where the gap between them is no less than the width of the wider one.
bool SquareCells::apart(const SquareCell& a, const SquareCell& b, CellShift& shift) const {
  const int finest = std::max(a.level, b.level);
  const std::int64_t unit_a = std::int64_t{1} << (finest - a.level), unit_b = std::int64_t{1} << (finest - b.level);
  shift = {a.level - b.level, (2 * a.i + 1) * unit_a - (2 * b.i + 1) * unit_b,
           (2 * a.j + 1) * unit_a - (2 * b.j + 1) * unit_b};
  return std::max(std::abs(shift.di), std::abs(shift.dj)) >= unit_a + unit_b + 2 * std::max(unit_a, unit_b);
}

// Descends from two squares to all pairs that are far from each other or are leaves.
void SquareCells::meet(std::int32_t target, std::int32_t source) {
  std::map<CellShift, std::int32_t> number;
  std::vector<std::array<std::int32_t, 2>> open{{target, source}};
  while (!open.empty()) {
    const auto [t, s] = open.back();
    open.pop_back();
    const SquareCell &a = cell_[at(t)], &b = cell_[at(s)];
    if ((a.leaf() && a.node.empty()) || (b.leaf() && b.element.empty())) continue;
    CellShift shift;
    if (apart(a, b, shift)) {
      const auto [found, fresh] = number.try_emplace(shift, static_cast<std::int32_t>(shift_.size()));
      if (fresh) shift_.push_back(shift);
      far_.push_back({found->second, t, s});
    } else if (a.leaf() && b.leaf()) {
      cell_[at(t)].near.push_back(s);
    } else {
      const bool both = !a.leaf() && !b.leaf() && a.level == b.level;
      const bool divide_a = both || (!a.leaf() && (b.leaf() || a.level < b.level));
      for (const std::int32_t ca : divide_a ? a.child : std::array<std::int32_t, 4>{t, -1, -1, -1})
        for (const std::int32_t cb : both || !divide_a ? b.child : std::array<std::int32_t, 4>{s, -1, -1, -1})
          if (ca >= 0 && cb >= 0) open.push_back({ca, cb});
    }
  }
}

}  // namespace rollcon
