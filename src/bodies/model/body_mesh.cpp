#include "bodies/model/body_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "mesh/surface_geometry.hpp"
#include "mesh/surface_quadrature.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using FaceOfNodes = std::map<std::vector<std::int32_t>, std::size_t>;

std::vector<std::int32_t> sorted(std::vector<std::int32_t> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

void tag_by_side(const FaceNaming& naming, const std::vector<BoundaryFace>& origin, SurfaceMesh& surface) {
  const auto before = [](const BoundaryFace& a, const BoundaryFace& b) {
    return a.element != b.element ? a.element < b.element : a.side < b.side;
  };
  for (const BoundaryFace& face : naming.face) {
    const auto found = std::lower_bound(origin.begin(), origin.end(), face, before);
    if (found == origin.end() || before(face, *found))
      fail(Status::err_mesh,
           "face %d of element %lld (both counting from %d), which was given tag %d, is not on the "
           "body's boundary",
           face.side + surface.index_base, static_cast<long long>(face.element) + surface.index_base,
           surface.index_base, naming.tag);
    surface.tag[static_cast<std::size_t>(found - origin.begin())] = naming.tag;
  }
}

void tag_by_elements(const FaceNaming& naming, const FaceOfNodes& face_of_nodes, SurfaceMesh& surface) {
  const auto width = static_cast<std::size_t>(node_count(naming.type));
  for (std::size_t first = 0; first < naming.connectivity.size(); first += width) {
    const auto from = naming.connectivity.begin() + static_cast<std::ptrdiff_t>(first);
    const auto found = face_of_nodes.find(sorted({from, from + static_cast<std::ptrdiff_t>(width)}));
    if (found == face_of_nodes.end()) {
      std::string nodes;
      for (std::size_t k = 0; k < width; ++k)
        nodes += (k ? ", " : "") + std::to_string(from[static_cast<std::ptrdiff_t>(k)] + surface.index_base);
      fail(Status::err_mesh,
           "surface element %zu with tag %d (counting from %d), of nodes %s, is not a boundary face "
           "of the body's volume elements",
           first / width + static_cast<std::size_t>(surface.index_base), naming.tag, surface.index_base, nodes.c_str());
    }
    surface.tag[found->second] = naming.tag;
  }
}

}  // namespace

std::vector<Vec3> FaceLoad::by_node(std::size_t nodes) const {
  std::vector<Vec3> all;
  if (node.empty()) return all;
  all.assign(nodes, Vec3{0, 0, 0});
  for (std::size_t k = 0; k < node.size(); ++k) all[static_cast<std::size_t>(node[k])] = of_node[k];
  return all;
}

Vec3 FaceLoad::turned(const Vec3& v, const Vec3& normal) const {
  if (along == Vec3{0, 0, 0}) return v;
  const Vec3 tangent = normalized(along - dot(along, normal) * normal);
  return v[0] * tangent + v[1] * cross(normal, tangent) + v[2] * normal;
}

bool BodyMesh::taken(std::int32_t tag) const {
  const auto has = [&](const auto& entry) { return entry.tag == tag; };
  return std::any_of(load.begin(), load.end(), has) || std::any_of(spring.begin(), spring.end(), has);
}

bool BodyMesh::moved() const {
  const std::vector<Vec3>& given = section.swept() ? given_value : held_value;
  return std::any_of(given.begin(), given.end(), [](const Vec3& v) { return v != Vec3{0, 0, 0}; });
}

void tag_by_nodes(const FaceNaming& naming, SurfaceMesh& surface) {
  std::vector<std::uint8_t> named(static_cast<std::size_t>(surface.nodes()), 0);
  for (const std::int32_t k : naming.nodes) named[static_cast<std::size_t>(k)] = 1;
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const auto nodes = surface.element(e);
    if (std::all_of(nodes.begin(), nodes.end(),
                    [&](std::int32_t k) { return named[static_cast<std::size_t>(k)] != 0; }))
      surface.tag[static_cast<std::size_t>(e)] = naming.tag;
  }
}

void update_boundary(BodyMesh& mesh) {
  if (mesh.boundary_current || mesh.volume.elements() == 0) return;
  std::vector<BoundaryFace> origin = boundary_faces(mesh.volume);
  SurfaceMesh surface = boundary_surface(mesh.volume, origin);
  surface.index_base = mesh.surface.index_base;
  FaceOfNodes face_of_nodes;
  const bool by_elements = std::any_of(mesh.naming.begin(), mesh.naming.end(),
                                       [](const FaceNaming& naming) { return !naming.connectivity.empty(); });
  for (std::int64_t e = 0; by_elements && e < surface.elements(); ++e) {
    const auto nodes = surface.element(e);
    face_of_nodes.emplace(sorted({nodes.begin(), nodes.end()}), static_cast<std::size_t>(e));
  }
  surface.node.swap(mesh.surface.node);
  try {
    for (const FaceNaming& naming : mesh.naming) {
      if (!naming.face.empty()) tag_by_side(naming, origin, surface);
      if (!naming.nodes.empty()) tag_by_nodes(naming, surface);
      if (!naming.connectivity.empty()) tag_by_elements(naming, face_of_nodes, surface);
    }
  } catch (...) {
    surface.node.swap(mesh.surface.node);
    throw;
  }
  std::swap(mesh.surface, surface);
  std::swap(mesh.origin, origin);
  mesh.boundary_current = true;
}

std::string face_name(const BodyMesh& mesh, std::int64_t element) {
  const std::int32_t base = mesh.surface.index_base;
  if (mesh.origin.empty())
    return "element " + std::to_string(element + base) + " (counting from " + std::to_string(base) + ")";
  const BoundaryFace& face = mesh.origin[static_cast<std::size_t>(element)];
  return "face " + std::to_string(face.side + base) + " of element " + std::to_string(face.element + base) +
         " (both counting from " + std::to_string(base) + ")";
}

namespace {

std::vector<std::uint8_t> touched_nodes(const SurfaceMesh& surface, const std::vector<std::int64_t>& element) {
  std::vector<std::uint8_t> touched(static_cast<std::size_t>(surface.nodes()), 0);
  for (const std::int64_t e : element)
    for (const std::int32_t k : surface.element(e)) touched[static_cast<std::size_t>(k)] = 1;
  return touched;
}

std::vector<std::int32_t> marked(const std::vector<std::uint8_t>& wanted) {
  std::vector<std::int32_t> node;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (wanted[k]) node.push_back(static_cast<std::int32_t>(k));
  return node;
}

}  // namespace

void add_face_loads(const BodyMesh& mesh, double reference, std::vector<double>& force) {
  constexpr int degree = 7;  // N_i times the vector area, a polynomial
  const SurfaceMesh& surface = mesh.surface;
  for (const FaceLoad& load : mesh.load) {
    const std::vector<Vec3> by_node = load.by_node(surface.node.size());
    for (std::int64_t e = 0; e < surface.elements(); ++e) {
      if (surface.tag[at(e)] != load.tag) continue;
      const auto nodes = surface.element(e);
      for (const auto& [weight, shape] : tabulated<degree>(surface.type[at(e)])) {
        const Vec3 normal = combine(surface, e, shape, surface.node[at(nodes[0])]).normal;
        Vec3 part = length(normal) * load.traction - load.pressure * normal, own{0, 0, 0};
        for (std::size_t a = 0; a < nodes.size() && !by_node.empty(); ++a)
          own = own + shape.value[a] * by_node[at(nodes[a])];
        part = (weight / reference) * (part + length(normal) * load.turned(own, normalized(normal)));
        for (std::size_t a = 0; a < nodes.size(); ++a)
          for (std::size_t c = 0; c < 3; ++c) force[3 * at(nodes[a]) + c] += shape.value[a] * part[c];
      }
    }
  }
}

std::vector<std::int64_t> contact_elements_facing(const BodyMesh& mesh, const Vec3& normal) {
  constexpr double least_cosine = 0.25;
  std::vector<std::int64_t> face;
  const SurfaceMesh& surface = mesh.surface;
  for (const std::int64_t e : contact_elements(mesh)) {
    const auto nodes = surface.element(e);
    const auto corner = [&](std::size_t i) { return surface.node[at(nodes[i])]; };
    const std::size_t last = at(corner_count(surface.type[at(e)])) - 1;
    const Vec3 n = cross(corner(last - 1) - corner(0), corner(last) - corner(last == 3 ? 1 : 0));
    if (dot(n, normal) > least_cosine * length(n)) face.push_back(e);
  }
  return face;
}

std::vector<std::int32_t> nodes_of(const SurfaceMesh& surface, const std::vector<std::int64_t>& element) {
  return marked(touched_nodes(surface, element));
}

std::vector<std::int32_t> nodes_around(const SurfaceMesh& surface, const std::vector<std::int64_t>& element) {
  std::vector<std::int64_t> all(surface.type.size());
  std::iota(all.begin(), all.end(), 0);
  return nodes_around(surface, element, all);
}

std::vector<std::int32_t> nodes_around(const SurfaceMesh& surface, const std::vector<std::int64_t>& element,
                                       const std::vector<std::int64_t>& among) {
  const std::vector<std::uint8_t> touched = touched_nodes(surface, element);
  std::vector<std::uint8_t> wanted(touched.size(), 0);
  for (const std::int64_t e : among) {
    const auto nodes = surface.element(e);
    if (std::any_of(nodes.begin(), nodes.end(),
                    [&](std::int32_t k) { return touched[static_cast<std::size_t>(k)] != 0; }))
      for (const std::int32_t k : nodes) wanted[static_cast<std::size_t>(k)] = 1;
  }
  return marked(wanted);
}

std::vector<std::uint8_t> held_elements(const BodyMesh& mesh) {
  std::vector<std::uint8_t> held(static_cast<std::size_t>(mesh.surface.elements()), 7);
  for (std::size_t e = 0; e < held.size(); ++e)
    for (const std::int32_t k : mesh.surface.element(static_cast<std::int64_t>(e)))
      held[e] &= mesh.held[static_cast<std::size_t>(k)];
  return held;
}

std::vector<std::int64_t> contact_elements(const BodyMesh& mesh) {
  constexpr std::uint8_t all_components = 7;
  const std::set<std::int32_t> wanted(mesh.contact_tag.begin(), mesh.contact_tag.end());
  const std::vector<std::uint8_t> held = held_elements(mesh);
  std::vector<std::int64_t> element;
  for (std::size_t e = 0; e < held.size(); ++e) {
    const std::int32_t tag = mesh.surface.tag[e];
    const bool chosen = wanted.empty() ? held[e] != all_components && !mesh.taken(tag) : wanted.count(tag) != 0;
    if (chosen) element.push_back(static_cast<std::int64_t>(e));
  }
  return element;
}

}  // namespace rollcon
