#pragma once
/// Generates meshes for tests and benches: contact frames in the plane z = 0, nodes 0-based, corners counter-clockwise.
/// Everything is reproducible, because the random numbers come from a generator of its own.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon::frames {

/// Returns n + 1 equidistant lines from a to b.
std::vector<double> uniform_lines(double a, double b, int n);
/// Returns n + 1 lines -a cos(pi k / n), graded to both ends of [-a, a].
std::vector<double> cosine_lines(double a, int n);

/// Makes a rectangle with element corners on the given lines; triangles halve each quadrilateral along alternating
/// diagonals. It takes any element type; midside nodes and centres are on the straight edges.
SurfaceMesh rectangle(ElementType type, std::span<const double> x, std::span<const double> y);

/// Makes a disc of quadrilaterals: core x core elements inside a rounded square, `rings` rings of 4 core elements
/// around it. It has semi-axes ax, ay; the core's half-diagonal is core_fraction of them. With core = 16, rings = 6 it
/// has 673 nodes (quad4) or 1985 (quad8), 640 elements. Midside nodes are straight.
SurfaceMesh o_grid(ElementType type, int core, int rings, double ax, double ay, double core_fraction = 0.6);

/// Makes a disc of triangles: a node at the centre, then rings of count[k] nodes at radius[k] (ascending), each ring
/// turned by half its spacing against the one before.
SurfaceMesh ring_disc(ElementType type, std::span<const double> radius, std::span<const int> count);

/// Makes the frame of the paper's third example: 703 nodes (tri3) or 2745 (tri6), 1340 elements, 64 edges on the rim of
/// radius r.
SurfaceMesh paper_disc(ElementType type, double r);

/// Returns radii of rings graded to a contact's edge: r = a sin(pi k / 2n), k = 1..n, mirrored outwards while the
/// radius stays below `outer`, closed by a ring at `outer`.
std::vector<double> contact_radii(double a, int n, double outer);
/// Returns node counts for such rings: as many as keep the spacing along a ring near the largest spacing between rings,
/// at least 6.
std::vector<int> ring_counts(std::span<const double> radius);

/// Puts quadratic elements on the corners of a linear mesh (tri3 -> tri6, quad4 -> quad8 or quad9, tri3 and quad4 mixed
/// with quad8 or quad9 -> tri6 and that), with new nodes after the old ones.
SurfaceMesh to_quadratic(const SurfaceMesh& linear, ElementType type);

/// Moves interior corner nodes at random by up to `fraction` of their shortest edge; midside nodes and centres follow
/// to the middle of their corners.
SurfaceMesh perturb(SurfaceMesh mesh, double fraction, std::uint32_t seed);
/// Displaces interior midside nodes at random by up to `fraction` of their edge's length.
SurfaceMesh bend_midsides(SurfaceMesh mesh, double fraction, std::uint32_t seed);

/// Moves every node x to map(x).
SurfaceMesh transform(SurfaceMesh mesh, const std::function<Vec3(const Vec3&)>& map);
SurfaceMesh stretch(SurfaceMesh mesh, double sx, double sy);
/// Turns the mesh about n by `angle` (radian, counter-clockwise).
SurfaceMesh rotate(SurfaceMesh mesh, double angle);

/// Generates random numbers, uniform in [-1, 1), by a linear congruence.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed * 2654435761u + 12345u) {}
  double operator()();
  double between(double low, double high) { return low + (high - low) * 0.5 * (1 + (*this)()); }

 private:
  std::uint64_t state_;
};

}  // namespace rollcon::frames
