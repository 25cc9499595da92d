/// Finds where a frame cuts the contact off, and where it ends because a body does.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bodies/missed_nodes.hpp"
#include "contact/scene/geometry.hpp"
#include "mesh/element_sides.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Returns coordinates in the axes (t1, t2, n).
Vec3 in_axes(const Axes& axes, const Vec3& x) {
  const Vec3 r = x - axes.origin;
  return {dot(r, axes.t1), dot(r, axes.t2), dot(r, axes.n)};
}

/// Holds a straight piece of an edge of the body, in the axes; `side`: length of the element's side.
struct Piece {
  Vec3 from, to;
  double side;

  /// Says whether the point stands on it, seen along the normal of the axes.
  bool holds(const Vec3& p) const {
    constexpr double within = 1e-3,
                     above = 1e-2;  // fractions of the side: frames are at most 60 degrees steep
    const Vec3 d = to - from, r = p - from;
    const double square = d[0] * d[0] + d[1] * d[1];
    const double t = square > 0 ? std::clamp((r[0] * d[0] + r[1] * d[1]) / square, 0.0, 1.0) : 0.0;
    const Vec3 off = r - t * d;
    return std::hypot(off[0], off[1]) <= within * side && std::abs(off[2]) <= above * side;
  }
};

class BodyEdges {
 public:
  /// Collects the edges at which faces that a frame may lie on end: nothing goes on beyond them, or a face that is too
  /// steep for a frame.
  BodyEdges(const Frame& frame, const Body& body, const Pose& pose, int which)
      : axes_(frame.axes),
        mesh_(body.mesh().surface),
        fans_(body.smooth_fans()),
        pose_(pose),
        out_(pose.turn_back((which == 0 ? 1.0 : -1.0) * frame.axes.n)) {
    for (std::size_t k = 0; k < frame.used.size(); ++k) {
      if (!frame.used[k]) continue;
      low_ = {std::min(low_[0], frame.x[k]), std::min(low_[1], frame.y[k])};
      high_ = {std::max(high_[0], frame.x[k]), std::max(high_[1], frame.y[k])};
    }
    const std::vector<Side> sides = sorted_sides(corner_cells(mesh_));
    for_each_edge(sides, [&](const Side& a, std::size_t count) {
      if (ends(a, count > 1 ? &a + 1 : nullptr)) add(a);
    });
  }

  bool hold(const Vec3& point) const {
    return std::any_of(piece_.begin(), piece_.end(), [&](const Piece& piece) { return piece.holds(point); });
  }

 private:
  std::int32_t fan(std::int64_t element, std::int32_t node) const {
    const auto nodes = mesh_.element(element);
    const auto i = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    return fans_.of[at(mesh_.offset[at(element)] + i)];
  }
  bool carries(const Side& side) const {
    constexpr double smallest_cosine = 0.5;  // equal to that of frames
    const ReferencePoint middle = side_middle(mesh_.type[at(side.cell)], side_number(mesh_, side));
    return dot(unit_normal(mesh_, side.cell, middle.xi, middle.eta), out_) >= smallest_cosine;
  }
  bool ends(const Side& a, const Side* b) const {
    if (!b) return carries(a);
    if (fan(a.cell, a.from) == fan(b->cell, a.from) && fan(a.cell, a.to) == fan(b->cell, a.to)) return false;
    return carries(a) != carries(*b);
  }
  void add(const Side& side) {
    const auto place = [&](std::int32_t k) { return in_axes(axes_, pose_.place(mesh_.node[at(k)])); };
    const Vec3 a = place(side.from), b = place(side.to);
    const std::int32_t k = midside_node(mesh_, side);
    const Vec3 middle = k < 0 ? 0.5 * (a + b) : place(k);
    for (std::size_t c = 0; c < 2; ++c)
      if (std::max({a[c], b[c], middle[c]}) < low_[c] - length(b - a) ||
          std::min({a[c], b[c], middle[c]}) > high_[c] + length(b - a))
        return;
    // Chords stand for a curved side: they miss it by 1/64 of its own height.
    const int pieces = k < 0 ? 1 : 8;
    const auto curve = [&](double t) {  // t from -1 to 1
      return 0.5 * t * (t - 1) * a + (1 - t * t) * middle + 0.5 * t * (t + 1) * b;
    };
    for (int i = 0; i < pieces; ++i)
      piece_.push_back({curve(2.0 * i / pieces - 1), curve(2.0 * (i + 1) / pieces - 1), length(b - a)});
  }

  const Axes& axes_;
  const SurfaceMesh& mesh_;
  const TractionNodes& fans_;
  const Pose& pose_;
  Vec3 out_;  ///< outward normal of the body, in its axes
  static constexpr double far = std::numeric_limits<double>::infinity();
  std::array<double, 2> low_{far, far}, high_{-far, -far};  ///< box of the frame
  std::vector<Piece> piece_;
};

}  // namespace

// Frees nodes of the rim only where all that bounds the frame there is a body's end: a contact that itself ends beside
// the end of a body does so at the corner, too.
void find_rim(Frame& frame, const PairOfBodies& pair, const KnownGap* gap) {
  const std::vector<Side> sides = sorted_sides(split_elements(frame.mesh));
  frame.rim = rim_nodes(frame.nodes(), sides);
  std::vector<std::uint8_t> ends(frame.rim.size(), 0);
  for (std::size_t k = 0; gap && k < ends.size(); ++k)
    ends[k] = frame.rim[k] && gap->ends_at(frame.x[k], frame.y[k], element_size(frame, k));
  // The end of a caller's grid is where the caller ends the body: its pressure is not doubted.
  frame.ends = gap && !gap->beyond_bounds() ? ends : std::vector<std::uint8_t>{};
  for (int b = 0; b < 2; ++b) {
    const Body& body = *pair.body[at(b)];
    const Pose& pose = pair.pose[at(b)];
    if (!body.meshed()) continue;
    const BodyEdges edges(frame, body, pose, b);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (!frame.rim[k] || ends[k]) continue;
      const auto found = meet_contact_faces(frame, k, frame.axes.n, body, pose, b);
      ends[k] = found && edges.hold(in_axes(frame.axes, pose.place(found->x)));
    }
  }
  frame.rim.assign(ends.size(), 0);
  for_each_edge(std::span<const Side>(sides), [&](const Side& side, std::size_t count) {
    if (count > 1 || (ends[at(side.from)] && ends[at(side.to)])) return;
    frame.rim[at(side.from)] = frame.rim[at(side.to)] = 1;
  });
}

}  // namespace rollcon
