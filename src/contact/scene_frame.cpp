/// Frame and axes of a scene.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/scene.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

constexpr std::int64_t max_count = std::numeric_limits<std::int32_t>::max();  // ids are int32

void require_strides(std::int64_t n, std::int64_t node_stride, std::int64_t component_stride) {
  if (node_stride < 1 || component_stride < 1)
    fail(Status::err_argument, "strides are %lld and %lld; allowed: 1 or more",
         static_cast<long long>(node_stride), static_cast<long long>(component_stride));
  std::int64_t along_nodes = 0, along_components = 0, last = 0, bytes = 0;
  if (__builtin_mul_overflow(n - 1, node_stride, &along_nodes) ||
      __builtin_mul_overflow(std::int64_t{2}, component_stride, &along_components) ||
      __builtin_add_overflow(along_nodes, along_components, &last) ||
      __builtin_mul_overflow(last + 1, std::int64_t{sizeof(double)}, &bytes))
    fail(Status::err_argument, "n = %lld with strides %lld and %lld is beyond the address space",
         static_cast<long long>(n), static_cast<long long>(node_stride),
         static_cast<long long>(component_stride));
}

/// Room for `more` entries, so that adding them cannot throw; grows geometrically.
template <class T>
void make_room(std::vector<T>& v, std::size_t more) {
  if (v.size() + more > v.capacity()) v.reserve(std::max(v.size() + more, 2 * v.capacity()));
}

/// Unit vector; scaled first, so that no finite input overflows or underflows.
Vec3 unit(const double* v, const char* name) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest == 0) fail(Status::err_argument, "%s is the zero vector", name);
  int exponent = 0;
  std::frexp(largest, &exponent);
  const Vec3 scaled{std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent),
                    std::ldexp(v[2], -exponent)};
  const double length = std::sqrt(dot(scaled, scaled));
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

void require_finite_vector(const double* v, const char* name) {
  require_pointer(v, name);
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(v[i]))
      fail(Status::err_nonfinite, "component %c of %s is %g", "xyz"[i], name, v[i]);
  }
}

}  // namespace

Scene::Scene(std::int32_t index_base) {
  mesh_.index_base = index_base;
  mesh_.offset.push_back(0);
}

void Scene::set_frame_nodes(std::int64_t n, const double* x, std::int64_t node_stride,
                            std::int64_t component_stride) {
  if (n < 1 || n > max_count)
    fail(Status::err_argument, "n is %lld; allowed: 1 to %lld", static_cast<long long>(n),
         static_cast<long long>(max_count));
  require_pointer(x, "x");
  require_strides(n, node_stride, component_stride);
  const std::int32_t base = mesh_.index_base;
  for (std::int64_t i = 0; i < n; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double v = x[i * node_stride + j * component_stride];
      if (!std::isfinite(v))
        fail(Status::err_nonfinite, "coordinate %c of node %lld (counting from %d) is %g", "xyz"[j],
             static_cast<long long>(i) + base, base, v);
    }
  }
  SurfaceMesh mesh;
  mesh.index_base = base;
  mesh.offset.push_back(0);
  mesh.node.resize(static_cast<std::size_t>(n));
  for (std::int64_t i = 0; i < n; ++i) {
    const double* first = x + i * node_stride;
    mesh.node[static_cast<std::size_t>(i)] = {first[0], first[component_stride],
                                              first[2 * component_stride]};
  }

  std::swap(mesh_, mesh);
  ++revision.mesh;
  if (gap_given_) ++revision.gap;
  if (!creep_field_.empty()) ++revision.kinematics;
  if (!friction_field_.empty()) ++revision.friction;
  gap_given_ = false;
  gap_.clear();
  creep_field_.clear();
  friction_field_.clear();
}

void Scene::add_frame_elements(std::int32_t type, std::int64_t n, const std::int32_t* connectivity,
                               std::int32_t index_base, std::int32_t tag) {
  if (!is_element_type(type))
    fail(Status::err_argument,
         "type is %d; allowed: 203 (tri3), 206 (tri6), 214 (quad4), 218 (quad8), 219 (quad9)",
         type);
  if (index_base != 0 && index_base != 1)
    fail(Status::err_argument, "index_base is %d; allowed: 0, 1", index_base);
  require_count(n, "n");
  if (mesh_.nodes() == 0)
    fail(Status::err_state,
         "the frame has no nodes: call rollcon_contact_set_frame_nodes before its elements");
  if (n > max_count - mesh_.elements())
    fail(Status::err_argument, "n is %lld; a frame has at most %lld elements",
         static_cast<long long>(n), static_cast<long long>(max_count));
  if (n == 0) return;
  require_pointer(connectivity, "connectivity");
  const auto element_type = static_cast<ElementType>(type);
  const int width = node_count(element_type);
  for (std::int64_t k = 0; k < n * width; ++k) {
    const std::int64_t node = std::int64_t{connectivity[k]} - index_base;
    if (node < 0 || node >= mesh_.nodes())
      fail(Status::err_mesh,
           "node %lld of element %lld (both counting from %d) has id %d; allowed: %d to %lld",
           static_cast<long long>(k % width) + index_base,
           static_cast<long long>(k / width) + index_base, index_base, connectivity[k], index_base,
           static_cast<long long>(mesh_.nodes()) - 1 + index_base);
  }

  const auto count = static_cast<std::size_t>(n);
  make_room(mesh_.type, count);
  make_room(mesh_.tag, count);
  make_room(mesh_.offset, count);
  make_room(mesh_.connectivity, count * static_cast<std::size_t>(width));
  for (std::int64_t e = 0; e < n; ++e) {
    mesh_.type.push_back(element_type);
    mesh_.tag.push_back(tag);
    for (int k = 0; k < width; ++k)
      mesh_.connectivity.push_back(connectivity[e * width + k] - index_base);
    mesh_.offset.push_back(static_cast<std::int64_t>(mesh_.connectivity.size()));
  }
  mesh_.index_base = index_base;
  ++revision.mesh;
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
  const double leftover = dot(axes.t2, axes.n);  // rounding over the sine
  for (std::size_t i = 0; i < 3; ++i) axes.t2[i] -= leftover * axes.n[i];
  axes.t2 = unit(axes.t2.data(), "rolling");
  axes.t1 = cross(axes.t2, axes.n);
  if (axes.origin == axes_.origin && axes.t1 == axes_.t1 && axes.t2 == axes_.t2 &&
      axes.n == axes_.n)
    return;
  axes_ = axes;
  ++revision.axes;
}

}  // namespace rollcon
