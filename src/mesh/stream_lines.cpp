#include "mesh/stream_lines.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/topology.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double same_line = 1e-9;  // of the frame's width
constexpr double lift = 1e-13;      // likewise, or of y

}  // namespace

StreamLines::StreamLines(const Frame& frame) : frame_(frame) {
  const LinearCells cells = split_elements(frame.mesh);
  std::vector<std::uint8_t> met(frame.x.size(), 0);
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto cell = cells[c];
    for (std::size_t i = 2; i < cell.size(); ++i) {
      Triangle t{0, 0, {cell[0], cell[i - 1], cell[i]}};
      const double a = frame.y[at(t.node[0])], b = frame.y[at(t.node[1])], d = frame.y[at(t.node[2])];
      t.low = std::min({a, b, d});
      t.high = std::max({a, b, d});
      tallest_ = std::max(tallest_, t.high - t.low);
      triangle_.push_back(t);
    }
    for (const std::int32_t k : cell) met[at(k)] = 1;
  }
  std::sort(triangle_.begin(), triangle_.end(), [](const Triangle& a, const Triangle& b) { return a.low < b.low; });
  for (std::size_t k = 0; k < met.size(); ++k)
    if (met[k]) node_.push_back(static_cast<std::int32_t>(k));
  if (node_.empty()) return;
  std::sort(node_.begin(), node_.end(),
            [&](std::int32_t a, std::int32_t b) { return frame.y[at(a)] < frame.y[at(b)]; });
  least_y_ = frame.y[at(node_.front())];
  greatest_y_ = frame.y[at(node_.back())];
  rounding_ = same_line * (greatest_y_ - least_y_);
  lowest_ = least_y_ + lift * std::max(greatest_y_ - least_y_, std::abs(least_y_));
  for (std::size_t first = 0; first < node_.size();) {
    const double y = frame.y[at(node_[first])];
    std::size_t last = first;
    while (last < node_.size() && frame.y[at(node_[last])] - y <= rounding_) ++last;
    std::sort(node_.begin() + static_cast<std::ptrdiff_t>(first), node_.begin() + static_cast<std::ptrdiff_t>(last),
              [&](std::int32_t a, std::int32_t b) { return frame.x[at(a)] > frame.x[at(b)]; });
    y_.push_back(y);
    start_.push_back(last);
    first = last;
  }
}

// Nodes on the line count as above it, so that lines of nodes belong to the triangles below and no piece is there
// twice; the lowest line is lifted by rounding.
void StreamLines::cut(double y, std::vector<LinePiece>& pieces) const {
  pieces.clear();
  if (y < least_y_ - rounding_ || y > greatest_y_ + rounding_) return;
  y = std::clamp(y, lowest_, greatest_y_);
  const auto crossing = [&](std::int32_t a, std::int32_t b) {
    if (a > b) std::swap(a, b);  // the same from both sides of an edge
    const double ya = frame_.y[at(a)], part = (y - ya) / (frame_.y[at(b)] - ya);
    return LinePiece::End{(1 - part) * frame_.x[at(a)] + part * frame_.x[at(b)], {a, b}, part};
  };
  auto t = std::lower_bound(triangle_.begin(), triangle_.end(), y - 2 * tallest_,
                            [](const Triangle& a, double low) { return a.low < low; });
  for (; t != triangle_.end() && t->low < y; ++t) {
    if (t->high < y) continue;
    bool above[3];
    for (std::size_t i = 0; i < 3; ++i) above[i] = frame_.y[at(t->node[i])] >= y;
    // The corner that is alone on its side.
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
