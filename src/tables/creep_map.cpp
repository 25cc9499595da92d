#include "tables/creep_map.hpp"

#include <algorithm>
#include <cmath>

#include "io/section_file.hpp"

namespace rollcon {
namespace {

/// Returns weights of four values at -1, 0, 1 and 2, the outer ones of which may not be known, for t from 0 to 1.
std::array<double, 4> cubic_weights(double t, bool before, bool after) {
  const double rise = t * t * (3 - 2 * t), first = t * (1 - t) * (1 - t), last = t * t * (t - 1);
  std::array<double, 4> w{0, 1 - rise, rise, 0};
  const auto add_slope = [&](std::size_t from, std::size_t to, double factor) {
    w[to] += factor / static_cast<double>(to - from);
    w[from] -= factor / static_cast<double>(to - from);
  };
  add_slope(before ? 0 : 1, 2, first);
  add_slope(1, after ? 3 : 2, last);
  return w;
}

/// Holds a node in a file.
struct NodeRecord {
  std::int64_t place[2], known;
  CreepMap::Numbers value;
};

}  // namespace

CreepMap::CreepMap(SectionReader& file) {
  std::uint64_t count = 0;
  file.read(&count, sizeof count);
  if (count > file.left() / sizeof(NodeRecord)) file.fail_here("a map is longer than its section");
  for (; count > 0; --count) {
    NodeRecord r{};
    file.read(&r, sizeof r);
    for (const double v : r.value)
      if (!std::isfinite(v)) file.fail_here("a number is not finite");
    node_[{r.place[0], r.place[1]}] = {r.known != 0, r.value};
  }
}

void CreepMap::save(SectionWriter& file) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t count = node_.size();
  file.write(&count, sizeof count);
  for (const auto& [place, node] : node_) {
    const NodeRecord r{{place.first, place.second}, node.known, node.value};
    file.write(&r, sizeof r);
  }
}

const CreepMap::Node& CreepMap::node(const Place& place, const Find& find) {
  const auto known = node_.find(place);
  return known != node_.end() ? known->second : node_.emplace(place, find(place)).first->second;
}

double CreepMap::at(double x, double y, const Find& find, Numbers& found) {
  const std::lock_guard lock(mutex_);
  const double left = std::floor(x), below = std::floor(y);
  const auto i = static_cast<std::int64_t>(left), j = static_cast<std::int64_t>(below);
  std::array<std::array<const Node*, 4>, 4> near{};
  std::array<bool, 4> there{};
  // The cell's own rows come first: where they are not known nothing more is looked for.
  for (const std::size_t b : {1, 2, 0, 3}) {
    for (const std::size_t a : {1, 2, 0, 3}) {
      near[b][a] = &node({i + static_cast<std::int64_t>(a) - 1, j + static_cast<std::int64_t>(b) - 1}, find);
      if (a == 2 && b != 0 && b != 3 && !(near[b][1]->known && near[b][2]->known)) return 0;
    }
    there[b] = near[b][1]->known && near[b][2]->known;
  }
  found = {};
  const std::array<double, 4> up = cubic_weights(y - below, there[0], there[3]);
  for (std::size_t b = 0; b < 4; ++b) {
    if (!there[b]) continue;
    const std::array<double, 4> along = cubic_weights(x - left, near[b][0]->known, near[b][3]->known);
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t k = 0; k < numbers; ++k) found[k] += up[b] * along[a] * near[b][a]->value[k];
  }
  // A corner of the cell one of whose neighbours is not known is doubted.
  double doubt = 0;
  for (std::size_t b = 0; b < 2; ++b)
    for (std::size_t a = 0; a < 2; ++a) {
      bool all = true;
      for (std::size_t k = 0; k < 9; ++k) all = all && near[b + k / 3][a + k % 3]->known;
      const double s = a == 0 ? 1 - x + left : x - left, t = b == 0 ? 1 - y + below : y - below;
      if (!all) doubt += s * s * (3 - 2 * s) * t * t * (3 - 2 * t);
    }
  return std::max(0.0, 1 - doubt);
}

}  // namespace rollcon
