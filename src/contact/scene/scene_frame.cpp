/// Sets frame and axes of a scene.

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "contact/scene/scene.hpp"
#include "mesh/mesh_inputs.hpp"
#include "mesh/strip_mesh.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

/// Returns the unit vector; v is scaled first, so that no finite input overflows or underflows.
Vec3 unit(const double* v, const char* name) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest == 0) fail(Status::err_argument, "%s is the zero vector", name);
  int exponent = 0;
  std::frexp(largest, &exponent);
  const Vec3 scaled{std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent), std::ldexp(v[2], -exponent)};
  const double length = std::sqrt(dot(scaled, scaled));
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

}  // namespace

Scene::Scene(std::int32_t index_base) {
  mesh_.index_base = index_base;
  mesh_.offset.push_back(0);
}

void Scene::set_frame_nodes(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride) {
  replace_frame(mesh_of_nodes(n, x, node_stride, component_stride, mesh_.index_base), {});
}

void Scene::set_made_frame(SurfaceMesh mesh, bool ends_at_edge, bool given) {
  mesh.index_base = mesh_.index_base;
  replace_frame(std::move(mesh), {});
  ends_at_edge_ = ends_at_edge;
  frame_given_ = given;
}

void Scene::set_placed_frame(SurfaceMesh mesh, const FramePlace& place) {
  set_made_frame(std::move(mesh), true, false);
  unplaced_ = mesh_.node;
  place_frame(place);
}

void Scene::set_strips(const strips::StripLayout& layout, const std::vector<double>& geometry) {
  if (strips_ && strips_->layout.counts == layout.counts && strips_->layout.parts == layout.parts) {
    if (strips_->layout.across != layout.across) strips_->layout = layout;
    strips_->geometry = geometry;
    ++revision.place;
  } else {
    auto made = std::make_unique<strips::StripFrame>(strips::StripFrame{layout, geometry, {}});
    set_made_frame(strips::strip_mesh(*made), true, false);
    strips_ = std::move(made);
  }
  strips::put_nodes(*strips_, axes_, mesh_.node);
}

void Scene::put_nodes(const FramePlace& place, std::vector<Vec3>& node) const {
  for (std::size_t k = 0; k < unplaced_.size(); ++k) {
    const double x = place.length * unplaced_[k][0] + place.shear * unplaced_[k][1], y = place.width * unplaced_[k][1];
    node[k] = axes_.origin + x * axes_.t1 + y * axes_.t2;
  }
}

void Scene::place_frame(const FramePlace& place) {
  place_ = place;
  ++revision.place;
  put_nodes(place, mesh_.node);
}

SurfaceMesh Scene::mesh_at(const FramePlace& place) const {
  SurfaceMesh mesh = mesh_;
  put_nodes(place, mesh.node);
  return mesh;
}

void Scene::forget_frame() {
  if (!frame_given_) return;
  SurfaceMesh none;
  none.index_base = mesh_.index_base;
  none.offset.push_back(0);
  replace_frame(std::move(none), {});
  frame_given_ = false;
}

void Scene::take_over(const Scene& other) {
  options = other.options;
  const std::int64_t mesh = revision.mesh, place = revision.place;
  revision = other.revision;
  revision.mesh = mesh;
  revision.place = place;
  pose_ = other.pose_;
  axes_ = other.axes_;
  gap_ = other.gap_;
  if (gap_.kind == GapKind::nodes) gap_ = {};
  rolling_ = other.rolling_;
  load_ = other.load_;
  friction_ = other.friction_;
  across_ = other.across_;
}

void Scene::replace_frame(SurfaceMesh mesh, FrameSource source) {
  frame_given_ = true;
  ends_at_edge_ = false;
  unplaced_.clear();
  strips_.reset();
  place_ = {};
  std::swap(mesh_, mesh);
  std::swap(frame_source_, source);
  ++revision.mesh;
  if (gap_.kind == GapKind::nodes) {
    ++revision.gap;
    gap_.kind = GapKind::none;
  }
  if (!creep_field_.empty()) ++revision.kinematics;
  if (!friction_field_.empty()) ++revision.friction;
  gap_.node.clear();
  creep_field_.clear();
  friction_field_.clear();
}

void Scene::add_frame_elements(std::int32_t type, std::int64_t n, const std::int32_t* connectivity,
                               std::int32_t index_base, std::int32_t tag) {
  if (ends_at_edge_)
    fail(Status::err_state, "the frame was made by the library: rollcon_contact_frame_nodes starts another one");
  if (frame_source_.body >= 0)
    fail(Status::err_state, "the frame was taken from body %d: rollcon_contact_frame_nodes starts another one",
         frame_source_.body + 1);
  append_elements(mesh_, type, n, connectivity, index_base, tag, "frame", "rollcon_contact_frame_nodes");
  if (n > 0) ++revision.mesh;
}

void Scene::set_axes(const double* origin, const double* rolling, const double* normal) {
  require_finite_vector(origin, "origin");
  require_finite_vector(rolling, "rolling");
  require_finite_vector(normal, "normal");
  Axes axes;
  axes.origin = {origin[0], origin[1], origin[2]};
  axes.n = unit(normal, "normal");
  const Vec3 direction = unit(rolling, "rolling");
  axes.t2 = cross(axes.n, direction);
  // Below this sine the tangential part of `rolling` is mostly rounding.
  constexpr double least_sine = 1e-8;
  if (dot(axes.t2, axes.t2) < least_sine * least_sine)
    fail(Status::err_argument, "rolling is parallel to normal: no direction in the tangent plane");
  axes.t2 = unit(axes.t2.data(), "rolling");
  const double leftover = dot(axes.t2, axes.n);  // rounding, divided by the sine
  for (std::size_t i = 0; i < 3; ++i) axes.t2[i] -= leftover * axes.n[i];
  axes.t2 = unit(axes.t2.data(), "rolling");
  axes.t1 = cross(axes.t2, axes.n);
  if (axes.origin == axes_.origin && axes.t1 == axes_.t1 && axes.t2 == axes_.t2 && axes.n == axes_.n) return;
  axes_ = axes;
  ++revision.axes;
}

}  // namespace rollcon
