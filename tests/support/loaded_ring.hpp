#pragma once
/// Compares the ring of the paper's first example under loads on a patch of its outer surface with Fourier series with
/// high-order elements in the section (relative accuracy 1e-5).

#include <cstdint>
#include <string>
#include <vector>

#include "support/surface_meshes.hpp"

namespace rollcon::statics::loaded_ring {

inline constexpr double young = 1e4, inner = 25, outer = 50, side = 4, load = 100;

enum class Load { normal, tangential, axial };

/// Describes half of the circumference and half of the width, between planes of (anti)symmetry; the hub is tag 5.
struct Quarter {
  /// Numbers of elements: half of the zone |s| <= 2, half of the rest, half of the width, from the hub outwards.
  int zone, far, across, deep;
};
surfaces::Block quarter(const Quarter& q);

/// Returns the faces of the patch |s| <= 1; their edges must lie at its ends.
std::vector<std::int64_t> patch_of(const SurfaceMesh& mesh);
/// Returns the traction on the patch, at a point of the outer surface.
Vec3 traction(Load kind, const Vec3& x);
/// Returns the nodes of the outer surface no further than 2 from the patch's middle, ascending.
std::vector<std::int32_t> nodes_near_patch(const SurfaceMesh& mesh);

/// Holds displacements of the outer surface near the patch, and their mean over the patch.
struct Answer {
  std::vector<std::int32_t> node;
  std::vector<Vec3> u;
  const SurfaceMesh* mesh = nullptr;
  Vec3 mean{0, 0, 0};  ///< local components s, y, n (inwards)

  Vec3 local(std::size_t k) const;
  bool has_line(double s) const;
  /// Interpolates along a line s = const of nodes.
  Vec3 at(double s, double y) const;
  void find_mean();
};

/// Holds the error of a listed value: against the largest displacement of the row's load for the small components,
/// against the value itself for the component of the load. Points on no line of nodes are left out.
struct ListedError {
  std::string what;
  double error = 0;
};
std::vector<ListedError> listed_errors(const Answer& answer, Load kind, double poisson);

}  // namespace rollcon::statics::loaded_ring
