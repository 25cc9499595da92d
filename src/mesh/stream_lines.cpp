#include "mesh/stream_lines.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mesh/topology.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double same_line = 1e-9;  // fraction of the frame's width
constexpr double lift = 1e-13;      // fraction of the frame's width, or of y

}  // namespace

StreamLines::StreamLines(const Frame& frame) : frame_(frame), level_(frame.y) {
  const LinearCells cells = split_elements(frame.mesh);
  std::vector<std::uint8_t> met(frame.x.size(), 0);
  for (std::int64_t c = 0; c < cells.size(); ++c)
    for (const std::int32_t k : cells[c]) met[at(k)] = 1;
  for (std::size_t k = 0; k < met.size(); ++k)
    if (met[k]) node_.push_back(static_cast<std::int32_t>(k));
  if (node_.empty()) return;
  std::sort(node_.begin(), node_.end(),
            [&](std::int32_t a, std::int32_t b) { return frame.y[at(a)] < frame.y[at(b)]; });
  const double least = frame.y[at(node_.front())], width = frame.y[at(node_.back())] - least;
  rounding_ = same_line * width;
  lowest_ = least + lift * std::max(width, std::abs(least));
  for (std::size_t first = 0; first < node_.size();) {
    const double y = frame.y[at(node_[first])];
    std::size_t last = first;
    for (; last < node_.size() && frame.y[at(node_[last])] - y <= rounding_; ++last) level_[at(node_[last])] = y;
    std::sort(node_.begin() + static_cast<std::ptrdiff_t>(first), node_.begin() + static_cast<std::ptrdiff_t>(last),
              [&](std::int32_t a, std::int32_t b) { return frame.x[at(a)] > frame.x[at(b)]; });
    y_.push_back(y);
    start_.push_back(last);
    first = last;
  }
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto cell = cells[c];
    for (std::size_t i = 2; i < cell.size(); ++i) {
      Triangle t{0, 0, {cell[0], cell[i - 1], cell[i]}};
      std::tie(t.low, t.high) = std::minmax({level_[at(t.node[0])], level_[at(t.node[1])], level_[at(t.node[2])]});
      tallest_ = std::max(tallest_, t.high - t.low);
      triangle_.push_back(t);
    }
  }
  std::sort(triangle_.begin(), triangle_.end(), [](const Triangle& a, const Triangle& b) { return a.low < b.low; });
}

// Nodes on the line count as above it, so that lines of nodes belong to the triangles below and no piece is there
// twice; the lowest line is lifted by rounding.
void StreamLines::cut(double y, std::vector<LinePiece>& pieces) const {
  pieces.clear();
  if (y_.empty() || y < y_.front() - rounding_ || y > y_.back() + rounding_) return;
  const auto next = std::lower_bound(y_.begin(), y_.end(), y - rounding_);
  if (next != y_.end() && *next <= y + rounding_) y = *next;
  y = std::clamp(y, lowest_, y_.back());
  const auto crossing = [&](std::int32_t a, std::int32_t b) {
    if (a > b) std::swap(a, b);  // equal from both sides of an edge
    const double ya = level_[at(a)], part = (y - ya) / (level_[at(b)] - ya);
    return LinePiece::End{(1 - part) * frame_.x[at(a)] + part * frame_.x[at(b)], {a, b}, part};
  };
  auto t = std::lower_bound(triangle_.begin(), triangle_.end(), y - 2 * tallest_,
                            [](const Triangle& a, double low) { return a.low < low; });
  for (; t != triangle_.end() && t->low < y; ++t) {
    if (t->high < y) continue;
    bool above[3];
    for (std::size_t i = 0; i < 3; ++i) above[i] = level_[at(t->node[i])] >= y;
    // One corner is alone on its side.
    const std::size_t alone = above[0] == above[1] ? 2 : above[0] == above[2] ? 1 : 0;
    LinePiece piece{crossing(t->node[alone], t->node[(alone + 1) % 3]),
                    crossing(t->node[alone], t->node[(alone + 2) % 3])};
    if (piece.upstream.x < piece.downstream.x) std::swap(piece.upstream, piece.downstream);
    if (piece.length() > 0) pieces.push_back(piece);
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const LinePiece& a, const LinePiece& b) { return a.upstream.x > b.upstream.x; });
}

}  // namespace rollcon
