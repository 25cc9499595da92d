#include "mesh/mesh_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/input_checks.hpp"

namespace rollcon {

namespace {

constexpr std::int64_t max_count = std::numeric_limits<std::int32_t>::max();  // ids are int32

void require_strides(std::int64_t n, std::int64_t node_stride, std::int64_t component_stride) {
  if (node_stride < 1 || component_stride < 1)
    fail(Status::err_argument, "strides are %lld and %lld; allowed: 1 or more", static_cast<long long>(node_stride),
         static_cast<long long>(component_stride));
  std::int64_t along_nodes = 0, along_components = 0, last = 0, bytes = 0;
  if (__builtin_mul_overflow(n - 1, node_stride, &along_nodes) ||
      __builtin_mul_overflow(std::int64_t{2}, component_stride, &along_components) ||
      __builtin_add_overflow(along_nodes, along_components, &last) ||
      __builtin_mul_overflow(last + 1, std::int64_t{sizeof(double)}, &bytes))
    fail(Status::err_argument, "n = %lld with strides %lld and %lld is beyond the address space",
         static_cast<long long>(n), static_cast<long long>(node_stride), static_cast<long long>(component_stride));
}

/// Makes room for `more` entries, so that adding them cannot throw; grows geometrically.
template <class T>
void make_room(std::vector<T>& v, std::size_t more) {
  if (v.size() + more > v.capacity()) v.reserve(std::max(v.size() + more, 2 * v.capacity()));
}

/// Appends elements to a surface or to the inside of a body.
template <class Type, class Elements>
void append(Elements& to, Type type, std::int64_t n, const std::int32_t* connectivity, std::int32_t index_base,
            std::int32_t tag) {
  const auto count = static_cast<std::size_t>(n);
  const int width = node_count(type);
  make_room(to.type, count);
  make_room(to.tag, count);
  make_room(to.offset, count);
  make_room(to.connectivity, count * static_cast<std::size_t>(width));
  for (std::int64_t e = 0; e < n; ++e) {
    to.type.push_back(type);
    to.tag.push_back(tag);
    for (int k = 0; k < width; ++k) to.connectivity.push_back(connectivity[e * width + k] - index_base);
    to.offset.push_back(static_cast<std::int64_t>(to.connectivity.size()));
  }
}

void require_elements(std::int64_t n, std::int64_t present, std::int64_t nodes, int width,
                      const std::int32_t* connectivity, std::int32_t index_base, const char* owner,
                      const char* node_setter) {
  require_index_base(index_base);
  require_count(n, "n");
  if (nodes == 0) fail(Status::err_state, "the %s has no nodes: call %s before its elements", owner, node_setter);
  if (n > max_count - present)
    fail(Status::err_argument, "n is %lld; a %s has at most %lld elements", static_cast<long long>(n), owner,
         static_cast<long long>(max_count));
  if (n == 0) return;
  require_pointer(connectivity, "connectivity");
  for (std::int64_t k = 0; k < n * width; ++k) {
    const std::int64_t node = std::int64_t{connectivity[k]} - index_base;
    if (node < 0 || node >= nodes)
      fail(Status::err_mesh, "node %lld of element %lld (both counting from %d) has id %d; allowed: %d to %lld",
           static_cast<long long>(k % width) + index_base, static_cast<long long>(k / width) + index_base, index_base,
           connectivity[k], index_base, static_cast<long long>(nodes) - 1 + index_base);
  }
}

}  // namespace

SurfaceMesh mesh_of_nodes(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride,
                          std::int32_t index_base) {
  if (n < 1 || n > max_count)
    fail(Status::err_argument, "n is %lld; allowed: 1 to %lld", static_cast<long long>(n),
         static_cast<long long>(max_count));
  require_pointer(x, "x");
  require_strides(n, node_stride, component_stride);
  for (std::int64_t i = 0; i < n; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double v = x[i * node_stride + j * component_stride];
      if (!std::isfinite(v))
        fail(Status::err_nonfinite, "coordinate %c of node %lld (counting from %d) is %g", "xyz"[j],
             static_cast<long long>(i) + index_base, index_base, v);
    }
  }
  SurfaceMesh mesh;
  mesh.index_base = index_base;
  mesh.offset.push_back(0);
  mesh.node.resize(static_cast<std::size_t>(n));
  for (std::int64_t i = 0; i < n; ++i) {
    const double* first = x + i * node_stride;
    mesh.node[static_cast<std::size_t>(i)] = {first[0], first[component_stride], first[2 * component_stride]};
  }
  return mesh;
}

void append_elements(SurfaceMesh& mesh, std::int32_t type, std::int64_t n, const std::int32_t* connectivity,
                     std::int32_t index_base, std::int32_t tag, const char* owner, const char* node_setter) {
  if (!is_element_type(type))
    fail(Status::err_argument, "type is %d; allowed: 203 (tri3), 206 (tri6), 214 (quad4), 218 (quad8), 219 (quad9)",
         type);
  const auto element_type = static_cast<ElementType>(type);
  require_elements(n, mesh.elements(), mesh.nodes(), node_count(element_type), connectivity, index_base, owner,
                   node_setter);
  append(mesh, element_type, n, connectivity, index_base, tag);
  if (n > 0) mesh.index_base = index_base;
}

void append_elements(VolumeElements& volume, std::int64_t nodes, std::int32_t type, std::int64_t n,
                     const std::int32_t* connectivity, std::int32_t index_base, std::int32_t tag,
                     const char* node_setter) {
  const auto element_type = static_cast<VolumeType>(type);
  require_elements(n, volume.elements(), nodes, node_count(element_type), connectivity, index_base, "body",
                   node_setter);
  append(volume, element_type, n, connectivity, index_base, tag);
}

}  // namespace rollcon
