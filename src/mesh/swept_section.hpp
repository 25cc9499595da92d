#pragma once
/// Describes a body as a plane section carried round an axis or along a line, and makes the surface that it sweeps.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

enum class Sweep : std::int32_t { none = 0, revolved = 1, extruded = 2 };

/// Says how the section is carried. All angles are parts of 2 pi of the whole way: once round the axis, or one period.
struct SectionPath {
  Sweep sweep = Sweep::none;
  Vec3 origin{0, 0, 0}, axis{0, 0, 0};  ///< point and unit direction of the axis, or of the line
  double period = 0;                    ///< length after which an extruded body and all on it repeat
};

/// Holds right-handed unit vectors at the section's place: e1 away from the axis (extruded: in the section), `along`
/// the way, e2 along the axis (extruded: in the section).
struct SectionAxes {
  Vec3 e1{1, 0, 0}, along{0, 1, 0}, e2{0, 0, 1};
  std::array<Vec3, 3> all() const { return {e1, along, e2}; }
};

/// Names a side of an element on the section's boundary; the section lies left of it, seen against `along`.
struct SectionEdge {
  std::int64_t element = 0;
  std::int32_t side = 0, tag = 0;
  std::array<std::int32_t, 3> node{-1, -1, -1};  ///< ends, then the middle of a quadratic one
  std::size_t nodes() const { return node[2] < 0 ? 2 : 3; }
};

class SweptSection {
 public:
  /// Takes plane elements, whose nodes lie in a plane through the axis, or at right angles to the line. Throws err_mesh
  /// naming what does not fit.
  SweptSection(const SurfaceMesh& plane, const SectionPath& path);
  SweptSection() = default;

  const SurfaceMesh& plane() const { return plane_; }
  const SectionPath& path() const { return path_; }
  bool revolved() const { return path_.sweep == Sweep::revolved; }
  bool swept() const { return !profile_.empty(); }
  /// Returns coordinates of a node along e1 and e2; of a revolved one the first is its distance from the axis.
  const std::array<double, 2>& place(std::int32_t node) const { return place_[static_cast<std::size_t>(node)]; }
  double orientation(std::int64_t element) const { return turn_[static_cast<std::size_t>(element)]; }
  std::vector<SectionEdge>& edges() { return edge_; }
  const std::vector<SectionEdge>& edges() const { return edge_; }
  /// Tells whether a node of the edge lies on the axis: what it sweeps has no surface there.
  bool meets_axis(const SectionEdge& edge) const;
  /// Returns the length of the way per radian at a distance from the axis.
  double way(double p) const { return revolved() ? p : path_.period / (2 * pi); }
  SectionAxes axes(double angle) const;
  Vec3 point(std::int32_t node, double angle) const;
  const std::array<Vec3, 3>& axes_at_start() const { return start_; }

  /// Chooses stations for the surface of some edges, 1.5 times as close as their nodes on average, and returns it:
  /// quad4, or quad9 of quadratic edges, looking out of the body. Node i of the profile at station k has number k *
  /// profile + i. err_mesh: the edges have linear and quadratic elements. stations: how many all along; 0: as said.
  SurfaceMesh sweep(std::span<const std::size_t> edge, std::int64_t stations);
  // What sweep() chose:
  const std::vector<std::int32_t>& profile() const { return profile_; }
  /// Returns places in the profile of the nodes of edge i of those swept.
  const std::array<std::int32_t, 3>& of_edge(std::size_t i) const { return in_profile_[i]; }
  const std::vector<std::size_t>& swept_edges() const { return chosen_; }
  /// Returns the plane element behind a face of the surface.
  std::int64_t element_under(std::int64_t face) const {
    return edge_[chosen_[static_cast<std::size_t>(face) % chosen_.size()]].element;
  }
  bool quadratic() const { return quadratic_; }
  std::int64_t stations() const { return stations_; }  ///< stations of the whole way
  double step() const { return 2 * pi / static_cast<double>(stations_); }
  /// Returns the station, counted from the section's place, of the surface's station k.
  std::int64_t station(std::int64_t k) const { return first_ + k; }
  bool closed() const { return count_ == stations_; }
  std::int64_t surface_stations() const { return count_; }

  static constexpr double pi = 3.14159265358979323846;

 private:
  void find_axes();
  void orient();
  void find_edges();
  void choose_stations(std::int64_t wished, double spacing, double farthest);

  SurfaceMesh plane_;
  SectionPath path_;
  std::array<Vec3, 3> start_{};
  std::vector<std::array<double, 2>> place_;
  std::vector<double> turn_;  ///< 1: the element's nodes run from e1 to e2; -1: the other way
  std::vector<SectionEdge> edge_;
  std::vector<std::size_t> chosen_;
  std::vector<std::int32_t> profile_;
  std::vector<std::array<std::int32_t, 3>> in_profile_;
  bool quadratic_ = false;
  std::int64_t stations_ = 0, first_ = 0, count_ = 0;
};

}  // namespace rollcon
