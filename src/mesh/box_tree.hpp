#pragma once
/// Holds a binary tree of boxes, halved at the median of their middles along the longest side.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "mesh/box.hpp"

namespace rollcon {

class BoxTree {
 public:
  /// Adds a box; boxes count from 0 in the order in which they are added. All are added before the tree is built.
  void add(const Box& box) { leaf_.push_back({box, static_cast<std::int64_t>(leaf_.size())}); }
  void build() { divide(0, leaf_.size()); }

  /// The reach of a box that is not met exceeds any limit.
  static constexpr double missed = std::numeric_limits<double>::quiet_NaN();
  /// Calls visit(number) for the boxes whose reach(box) is at most limit(), nearer parts of the tree first. The reach
  /// of a box is at most that of any box within it.
  template <class Reach, class Limit, class Visit>
  void walk(const Reach& reach, const Limit& limit, const Visit& visit) const {
    walk_part(0, reach, limit, visit);
  }

 private:
  struct Leaf {
    Box box;
    std::int64_t number;
  };
  struct Part {
    Box box;
    std::size_t first, last;  ///< range of leaves
    std::size_t second = 0;   ///< index of the second half; that of the first half comes next; 0: not halved
  };
  static constexpr std::size_t undivided = 8;

  void divide(std::size_t first, std::size_t last) {
    const std::size_t self = part_.size();
    Box box;
    for (std::size_t i = first; i < last; ++i) box.add(leaf_[i].box);
    part_.push_back({box, first, last});
    if (last - first <= undivided) return;
    const Vec3 size = box.size();
    const auto axis = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    const auto at = [&](std::size_t i) { return leaf_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(at(first), at(middle), at(last), [axis](const Leaf& a, const Leaf& b) {
      return a.box.low[axis] + a.box.high[axis] < b.box.low[axis] + b.box.high[axis];
    });
    divide(first, middle);
    part_[self].second = part_.size();
    divide(middle, last);
  }

  template <class Reach, class Limit, class Visit>
  void walk_part(std::size_t self, const Reach& reach, const Limit& limit, const Visit& visit) const {
    const auto within = [&](double r) { return r <= limit(); };
    const Part& part = part_[self];
    if (part.second == 0) {
      for (std::size_t i = part.first; i < part.last; ++i)
        if (within(reach(leaf_[i].box))) visit(leaf_[i].number);
      return;
    }
    std::pair<double, std::size_t> half[] = {{reach(part_[self + 1].box), self + 1},
                                             {reach(part_[part.second].box), part.second}};
    if (half[1].first < half[0].first) std::swap(half[0], half[1]);
    for (const auto& [least, next] : half)
      if (within(least)) walk_part(next, reach, limit, visit);
  }

  std::vector<Leaf> leaf_;
  std::vector<Part> part_;
};

}  // namespace rollcon
