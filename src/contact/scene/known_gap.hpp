#pragma once
/// Provides the undeformed gap over the plane of the axes where it is known between the nodes of a frame, too: given on
/// a grid, or between surfaces.

#include <memory>
#include <vector>

#include "bodies/contact_surface.hpp"
#include "contact/scene/scene.hpp"
#include "geometry/rectangle.hpp"
#include "geometry/vec2.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Holds where both bodies are above a point of the axes' plane, and how these heights change along it.
struct Heights {
  double height[2] = {};
  Vec2 slope[2] = {};

  double gap() const { return height[1] - height[0]; }
};

/// Serves one thread at a time.
class KnownGap {
 public:
  virtual ~KnownGap() = default;
  /// Returns the gap at a point of the axes' plane; +infinity where a body is not there.
  virtual double operator()(double x, double y) const = 0;
  /// Returns false where a body is not there.
  virtual bool heights(double x, double y, Heights& found) const = 0;
  /// Says whether a body ends within rounding of the point; size: extent of what is finely resolved there.
  virtual bool ends_at(double x, double y, double size) const = 0;
  /// Returns the region beyond which nothing is known, or one of the bodies is not there. err_state: it has no end.
  virtual Rectangle bounds() const = 0;
  /// Takes a region in which many heights are going to be asked for: surfaces are then met faster there.
  virtual void look_over(const Rectangle&) {}
  /// Says what to tell where a contact reaches the bounds; null: a body ends there.
  virtual const char* beyond_bounds() const = 0;
};

/// Returns false where only nodes have a gap, or it is of planes or quadratic between bodies without a mesh.
bool is_gap_known(const Scene& scene, const PairOfBodies& pair);
/// Returns the gap as the scene is now, which refers to the bodies; null where it is not known.
std::unique_ptr<KnownGap> known_gap(const Scene& scene, const PairOfBodies& pair);
/// Makes that of it, without allocating where surfaces have one before.
void update_known_gap(const Scene& scene, const PairOfBodies& pair, std::unique_ptr<KnownGap>& gap);
/// Fills in the gap at the nodes of a frame, far apart where a body is not there; allocates nothing once `gap` has had
/// this size. Returns false where it is not known.
bool fill_known_gap(const Scene& scene, const PairOfBodies& pair, const Frame& frame, std::vector<double>& gap);

}  // namespace rollcon
