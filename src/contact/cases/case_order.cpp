#include "contact/cases/case_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/index.hpp"

namespace rollcon {
namespace {

// A chain starts cold: short ones waste iterations, long ones threads.
constexpr std::int64_t shortest_chain = 4, longest_chain = 32, chains_wanted = 16;

class Walk {
 public:
  Walk(std::int64_t columns, const double* value, std::vector<std::int64_t> priority)
      : columns_(columns), value_(value), priority_(std::move(priority)), backwards_(priority_.size() + 1, false) {}

  bool less(std::int64_t a, std::int64_t b) const { return compare(a, b, 0) < 0; }
  bool equal(std::int64_t a, std::int64_t b) const { return compare(a, b, 0) == 0; }

  /// Sorts by the columns from `depth` on, each part of a column's range in the direction opposite to the last one's.
  void arrange(std::span<std::int64_t> part, std::size_t depth) {
    if (depth >= priority_.size() || part.size() < 2) return;
    const auto less = [&](std::int64_t a, std::int64_t b) { return compare(a, b, depth) < 0; };
    std::sort(part.begin(), part.end(), less);
    if (backwards_[depth]) std::reverse(part.begin(), part.end());
    backwards_[depth] = !backwards_[depth];
    if (depth + 1 == priority_.size()) return;
    std::size_t values = 1;
    for (std::size_t i = 1; i < part.size(); ++i) values += differs(part[i - 1], part[i], depth);
    const bool table = 2 * values <= part.size();
    const auto left = static_cast<double>(priority_.size() - depth);
    const std::size_t strips =
        rollcon::at(to_index(std::max(1.0, std::round(std::pow(static_cast<double>(part.size()), 1 / left)))));
    const std::size_t strip = (part.size() + strips - 1) / strips;
    for (std::size_t first = 0; first < part.size();) {
      std::size_t end = std::min(part.size(), first + (table ? 1 : strip));
      while (table && end < part.size() && !differs(part[first], part[end], depth)) ++end;
      arrange(part.subspan(first, end - first), depth + 1);
      first = end;
    }
  }

 private:
  double at(std::int64_t row, std::size_t depth) const { return value_[row * columns_ + priority_[depth]]; }
  bool differs(std::int64_t a, std::int64_t b, std::size_t depth) const { return at(a, depth) != at(b, depth); }
  /// Compares by all columns, that of `depth` first.
  int compare(std::int64_t a, std::int64_t b, std::size_t depth) const {
    for (std::size_t i = 0; i < priority_.size(); ++i) {
      const std::size_t d = (depth + i) % priority_.size();
      if (differs(a, b, d)) return at(a, d) < at(b, d) ? -1 : 1;
    }
    return 0;
  }

  std::int64_t columns_;
  const double* value_;
  std::vector<std::int64_t> priority_;
  std::vector<bool> backwards_;
};

}  // namespace

CaseOrder order_cases(std::int64_t cases, std::int64_t columns, const double* value,
                      std::span<const std::int64_t> priority) {
  std::vector<std::int64_t> varied;  // columns with more than one value
  for (const std::int64_t c : priority)
    for (std::int64_t i = 1; i < cases; ++i)
      if (value[i * columns + c] != value[c]) {
        varied.push_back(c);
        break;
      }
  Walk walk(columns, value, varied);
  CaseOrder order;
  std::vector<std::int64_t> sorted(static_cast<std::size_t>(cases));
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](std::int64_t a, std::int64_t b) {
    if (walk.less(a, b)) return true;
    return !walk.less(b, a) && a < b;
  });
  order.solved_as.resize(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool first = i == 0 || !walk.equal(sorted[i - 1], sorted[i]);
    if (first) order.solved.push_back(sorted[i]);
    order.solved_as[static_cast<std::size_t>(sorted[i])] = order.solved.back();
  }
  walk.arrange(order.solved, 0);
  const auto n = static_cast<std::int64_t>(order.solved.size());
  const std::int64_t length = std::clamp((n + chains_wanted - 1) / chains_wanted, shortest_chain, longest_chain);
  for (std::int64_t first = 0; first < n; first += length) order.chain_begin.push_back(first);
  order.chain_begin.push_back(n);
  return order;
}

}  // namespace rollcon
