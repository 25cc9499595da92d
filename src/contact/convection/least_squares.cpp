#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "contact/convection/convection.hpp"
#include "contact/convection/rows.hpp"
#include "mesh/topology.hpp"

/// Fits the gradient over upwind neighbours, equations (43)-(45), in coordinates along the path: d = s e + t (e turned
/// by 90 degrees), so that the row is minus the gradient's component along e.
///
/// The fit is weighted by (cos theta / |d|)^2, theta the angle between d and e. Neighbours across the flow (ties) then
/// enter and leave without a jump as the flow turns, and both sides alike; they keep a small weight, because next to a
/// single oblique neighbour they alone determine the gradient. Two neighbours are interpolated whatever their weights.
/// With equal weights, ties couple nodes across the flow to one another and the march down the stick zone can become
/// singular (measured on squares with diagonal neighbours, crossed at 45 degrees).
///
/// Neighbours are those along edges: along lines of nodes the row is then the plain upwind difference, and nothing
/// smears across the flow. With the diagonals of quadrilaterals the error of D for a smooth field rose by 15 % on
/// squares along their lines (0 to 15 % oblique) and by 15 to 30 % on most sheared ones; what they improve, oblique
/// marches and irregular quadrilaterals, is left to the wider stencils below.

namespace rollcon {
namespace {

/// The cos^2 that a tie has in the weights.
constexpr double tie_weight = 1e-6;
/// Growth of an error in w per step of the march downstream, sum |c_J| / |sum c_J|, that a stencil may have where one
/// without growth exists, and where the path leaves the frame next to the node.
constexpr double usable_growth = 1.5, tolerable_growth = 4;
/// Amplification sum |c_J| |x_J - x_I| (1 for a node straight upstream) up to which the neighbours' own fit is taken
/// without a look at wider stencils.
constexpr double good_amplification = 2.5;

struct Neighbour {
  std::int32_t node;
  double s, t;  ///< along the path (upstream positive) and across it
  double length() const { return std::hypot(s, t); }
};

struct Stencil {
  std::vector<std::int32_t> node;
  std::vector<double> c;
  double growth = 0, amplification = 0;
  double truncation = 0;  ///< sum |c_J| |x_J - x_I|^2, which bounds the error of a smooth field

  void add(const Neighbour& j, double coefficient) {
    if (coefficient == 0) return;
    node.push_back(j.node);
    c.push_back(coefficient);
    sum_ += coefficient;
    growth += std::abs(coefficient);
    amplification += std::abs(coefficient) * j.length();
    truncation += std::abs(coefficient) * j.length() * j.length();
  }
  void finish() { growth = sum_ < 0 ? growth / -sum_ : 1e300; }

 private:
  double sum_ = 0;
};

/// Makes the weighted fit; nothing if all neighbours are collinear and not along the path.
std::optional<Stencil> fit(std::span<const Neighbour> upwind) {
  double ss = 0, st = 0, tt = 0;  // moments of the directions d / |d|
  auto weight = [](double cosine) { return std::max(cosine * cosine, tie_weight); };
  for (const Neighbour& j : upwind) {
    const double a = j.s / j.length(), b = j.t / j.length(), w = weight(a);
    ss += w * a * a;
    st += w * a * b;
    tt += w * b * b;
  }
  const double determinant = ss * tt - st * st;
  // 1 - cos^2 of the angle between the weighted s and t: 0 for directions on one line.
  const bool collinear = determinant <= 1e-10 * ss * tt;
  if (collinear && tt > 1e-14 * ss) return std::nullopt;
  Stencil stencil;
  double largest = 0;
  std::vector<double> c;
  for (const Neighbour& j : upwind) {
    const double d = j.length(), a = j.s / d, b = j.t / d;
    const double along = collinear ? a / ss : (tt * a - st * b) / determinant;
    c.push_back(-weight(a) * along / d);
    largest = std::max(largest, std::abs(c.back()) * d);
  }
  for (std::size_t k = 0; k < upwind.size(); ++k)
    if (std::abs(c[k]) * upwind[k].length() > 1e-14 * largest) stencil.add(upwind[k], c[k]);
  stencil.finish();
  return stencil;
}

/// Finds the pair of neighbours with the path between them that has the least truncation: e = alpha d_J + beta d_K,
/// alpha, beta >= 0. It is exact for linear fields without growth.
std::optional<Stencil> enclosing_pair(std::span<const Neighbour> neighbours) {
  std::optional<Stencil> best;
  for (const Neighbour& j : neighbours)
    for (const Neighbour& k : neighbours) {
      if (j.t > 0 || k.t < 0 || j.node == k.node) continue;
      const double cross = j.s * k.t - j.t * k.s;
      if (cross <= 1e-6 * j.length() * k.length()) continue;
      Stencil pair;
      pair.add(j, -k.t / cross);
      pair.add(k, j.t / cross);
      pair.finish();
      if (!best || pair.truncation < best->truncation * (1 - 1e-12)) best = pair;
    }
  return best;
}

/// Takes the difference along the nearest path of the neighbours, the fit of least norm, as the last resort.
Stencil along_neighbours(std::span<const Neighbour> upwind) {
  double sum = 0;
  for (const Neighbour& j : upwind) sum += j.s * j.s / (j.length() * j.length());
  Stencil stencil;
  for (const Neighbour& j : upwind) {
    const double d = j.length();
    stencil.add(j, -(j.s / d) / (d * sum));
  }
  stencil.finish();
  return stencil;
}

class LeastSquares {
 public:
  LeastSquares(const Frame& frame, double ex, double ey)
      : frame_(frame), ex_(ex), ey_(ey), near_(neighbours(frame.nodes(), split_elements(frame.mesh), false)) {}

  /// Returns the candidates but i itself, seen from node i. Rounding beside the path or across it is taken out: on
  /// lines of nodes it must not decide which stencil encloses the path.
  std::vector<Neighbour> around(std::int32_t i, std::span<const std::int32_t> candidates) const {
    std::vector<Neighbour> found;
    const auto a = static_cast<std::size_t>(i);
    for (std::int32_t node : candidates) {
      const auto b = static_cast<std::size_t>(node);
      const double dx = frame_.x[b] - frame_.x[a], dy = frame_.y[b] - frame_.y[a];
      if (node == i) continue;
      Neighbour j{node, dx * ex_ + dy * ey_, dy * ex_ - dx * ey_};
      const double rounding = flow_rounding * j.length();
      if (std::abs(j.s) <= rounding) j.s = 0;
      if (std::abs(j.t) <= rounding) j.t = 0;
      found.push_back(j);
    }
    return found;
  }

  std::span<const std::int32_t> ring(std::int32_t i) const { return near_[i]; }

  /// Returns neighbours of neighbours, those of the first ring included.
  std::vector<std::int32_t> two_rings(std::int32_t i) const {
    std::vector<std::int32_t> node;
    for (std::int32_t j : near_[i]) {
      node.push_back(j);
      node.insert(node.end(), near_[j].begin(), near_[j].end());
    }
    std::sort(node.begin(), node.end());
    node.erase(std::unique(node.begin(), node.end()), node.end());
    return node;
  }

 private:
  const Frame& frame_;
  double ex_, ey_;
  Neighbours near_;
};

/// Returns those upstream or across the flow; none if nothing lies upstream.
std::vector<Neighbour> upwind_of(std::vector<Neighbour> neighbours) {
  std::erase_if(neighbours, [](const Neighbour& j) { return j.s < 0; });
  const bool upstream = std::any_of(neighbours.begin(), neighbours.end(), [](const Neighbour& j) { return j.s > 0; });
  if (!upstream) neighbours.clear();
  return neighbours;
}

/// Returns the one with the least truncation among those that grow no more than allowed.
std::optional<Stencil> better(std::optional<Stencil> a, std::optional<Stencil> b, double growth) {
  if (a && a->growth > growth) a.reset();
  if (b && b->growth > growth) b.reset();
  if (!a || (b && b->truncation < a->truncation)) return b;
  return a;
}

void add_row(RowBuilder& rows, std::int32_t i, const Stencil& stencil) {
  for (std::size_t k = 0; k < stencil.node.size(); ++k) {
    rows.add(i, stencil.node[k], stencil.c[k]);
    rows.add(i, i, -stencil.c[k]);
  }
}

}  // namespace

SparseRows least_squares(const Frame& frame, double ex, double ey) {
  const LeastSquares scheme(frame, ex, ey);
  RowBuilder rows(frame.nodes());
  std::vector<std::uint8_t> fallback(static_cast<std::size_t>(frame.nodes()), 0);
  std::optional<SparseRows> flux;
  for (std::int32_t i = 0; i < frame.nodes(); ++i) {
    const std::vector<Neighbour> ring = scheme.around(i, scheme.ring(i));
    const std::vector<Neighbour> first = upwind_of(ring);
    if (first.empty()) continue;
    const std::optional<Stencil> own = fit(first);
    if (own && own->growth <= usable_growth && own->amplification <= good_amplification) {
      add_row(rows, i, *own);
      continue;
    }
    const std::vector<Neighbour> wide = upwind_of(scheme.around(i, scheme.two_rings(i)));
    std::optional<Stencil> chosen = better(own, enclosing_pair(wide), usable_growth);
    // On slender cells a path can enter between a neighbour upstream and one that counts as downstream only because the
    // half plane of (x_J - x_I) . v < 0 does not follow the stretching.
    if (!chosen) chosen = enclosing_pair(ring);
    // The path leaves the frame next to the node.
    if (!chosen) chosen = better(own, fit(wide), tolerable_growth);
    fallback[static_cast<std::size_t>(i)] = !chosen || !own || chosen->c != own->c;
    if (chosen) {
      add_row(rows, i, *chosen);
      continue;
    }
    if (!flux) flux = godunov(frame, ex, ey);
    const auto begin = static_cast<std::size_t>(flux->start[static_cast<std::size_t>(i)]);
    const auto end = static_cast<std::size_t>(flux->start[static_cast<std::size_t>(i) + 1]);
    if (begin == end) add_row(rows, i, along_neighbours(first));
    for (std::size_t k = begin; k < end; ++k) rows.add(i, flux->column[k], flux->value[k]);
  }
  SparseRows result = rows.finish();
  result.fallback = std::move(fallback);
  return result;
}

Convection make_least_squares(const Frame& frame, double /*step*/, bool /*ends_at_edge*/) {
  return at_nodes(frame, least_squares(frame, 1, 0));
}

}  // namespace rollcon
