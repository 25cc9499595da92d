#pragma once
/// Makes bodies by sections for tests: rectangles divided by lines, turned about y or drawn along x.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bodies/body.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::sections {

/// Describes a rectangle in the plane (y, z) at x = 0. Tags of edges: 1 least y, 2 most y, 3 least z, 4 most z.
struct Rectangle {
  std::vector<double> y, z;
};
/// Returns lines from a to b that are fine at both ends.
std::vector<double> fine_at_ends(int n, double a, double b);
/// Returns the plane mesh; `map` moves its nodes in the plane.
SurfaceMesh rectangle(const Rectangle& shape, ElementType type, const surfaces::Map& map = {});

class SectionBody {
 public:
  SectionBody(SurfaceMesh plane, double young, double poisson);
  /// Tags edges all of whose nodes `where` has.
  SectionBody& tag(std::int32_t tag, const std::function<bool(const Vec3&)>& where);
  SectionBody& tag_sides(const Rectangle& shape);
  SectionBody& hold(const std::function<bool(const Vec3&)>& where, std::int32_t mask = 7,
                    const std::function<Vec3(const Vec3&)>& value = {});
  SectionBody& contact(std::int32_t tag);
  SectionBody& turn_about_y();
  SectionBody& draw_along_x(double period);
  SectionBody& prepare() {
    body_->prepare();
    return *this;
  }
  Body& body() { return *body_; }
  const SurfaceMesh& plane() const { return plane_; }
  const SurfaceMesh& surface() const { return body_->mesh().surface; }
  /// Returns the displacement under own loads of the surface's node next to x.
  Vec3 displacement(const Vec3& x) const;

 private:
  SurfaceMesh plane_;
  std::shared_ptr<Context> context_;
  std::unique_ptr<Body> body_;
};

}  // namespace rollcon::sections
