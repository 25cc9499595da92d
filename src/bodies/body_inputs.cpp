/// Takes what a caller gives for a body with a mesh, and its options.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "bodies/body.hpp"
#include "bodies/body_options.hpp"
#include "mesh/mesh_inputs.hpp"
#include "mesh/surface_geometry.hpp"
#include "mesh/volume_shape.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

/// Loads and given displacements beyond it would leave the range of doubles on their way.
constexpr double most_given = 1e100;

void require_mesh_kind(const BodyTraits& traits, const char* what) {
  if (!traits.meshed) fail(Status::err_state, "a %s has no mesh and takes no %s", traits.name, what);
}

void require_elastic_mesh_kind(const BodyTraits& traits, const char* what) {
  require_mesh_kind(traits, what);
  if (!traits.elastic) fail(Status::err_state, "a %s body takes no %s", traits.name, what);
}

void require_node_ids(std::int64_t n, const std::int32_t* node, std::int32_t index_base, std::int64_t nodes,
                      const char* what) {
  require_count(n, "n");
  require_index_base(index_base);
  if (nodes == 0) fail(Status::err_state, "the body has no nodes: call rollcon_body_set_nodes before its %s", what);
  if (n == 0) return;
  require_pointer(node, "nodes");
  for (std::int64_t i = 0; i < n; ++i) {
    const std::int64_t id = std::int64_t{node[i]} - index_base;
    if (id < 0 || id >= nodes)
      fail(Status::err_mesh, "entry %lld of nodes (counting from %d) has id %d; allowed: %d to %lld",
           static_cast<long long>(i) + index_base, index_base, node[i], index_base,
           static_cast<long long>(nodes) - 1 + index_base);
  }
}

void require_volume(const BodyTraits& traits) {
  if (!traits.filled()) fail(Status::err_state, "a %s body has no volume elements: no forces act inside", traits.name);
}

void require_moderate(const double* v, const char* name) {
  require_finite_vector(v, name);
  for (int c = 0; c < 3; ++c)
    if (std::abs(v[c]) > most_given)
      fail(Status::err_argument, "component %c of %s is %g; allowed: -%g to %g", "xyz"[c], name, v[c], most_given,
           most_given);
}

template <class Load>
Load& load_of(std::vector<Load>& load, std::int32_t tag) {
  const auto found = std::find_if(load.begin(), load.end(), [&](const Load& l) { return l.tag == tag; });
  if (found != load.end()) return *found;
  load.push_back({.tag = tag});
  return load.back();
}

}  // namespace

void Body::require_unprepared(const char* what) const {
  if (prepared()) fail(Status::err_state, "the body is prepared: its %s fixed", what);
}

// Throws err_state without elements, err_argument if no face has the tag. entry: how messages name the tag. Tags given
// to faces of a volume count before its boundary is known.
void Body::require_tag(std::int32_t tag, const std::string& entry) const {
  if (given().surface.elements() == 0 && given().volume.elements() == 0)
    fail(Status::err_state, "the body has no %selements: call rollcon_body_add_elements before naming their tags",
         traits_.volume ? "volume " : "");
  const std::vector<std::int32_t>& tags = given().surface.tag;
  const bool volume = given().volume.elements() > 0 || traits_.section;
  if (volume ? tag == 0 || std::any_of(given().naming.begin(), given().naming.end(),
                                       [&](const FaceNaming& n) { return n.tag == tag; })
             : std::find(tags.begin(), tags.end(), tag) != tags.end())
    return;
  std::set<std::int32_t> present;
  if (volume) {
    present.insert(0);
    for (const FaceNaming& naming : given().naming) present.insert(naming.tag);
  } else {
    present.insert(tags.begin(), tags.end());
  }
  constexpr std::size_t most_named = 16;
  std::string names;
  std::size_t named = 0;
  for (const std::int32_t p : present) {
    if (named++ == most_named) {
      names += ", ...";
      break;
    }
    names += (names.empty() ? "" : ", ") + std::to_string(p);
  }
  fail(Status::err_argument, "%s is %d, which no face has; tags of this body: %s", entry.c_str(), tag, names.c_str());
}

void Body::require_takes_mesh() const {
  require_unprepared("mesh is");
  if (model_->profile.curve) fail(Status::err_state, "the body has a profile: it takes no mesh as well");
}

BodyMesh Body::empty_mesh(std::int64_t n, const double* x, std::int64_t node_stride,
                          std::int64_t component_stride) const {
  BodyMesh mesh;
  mesh.surface = mesh_of_nodes(n, x, node_stride, component_stride, given().surface.index_base);
  mesh.held.assign(static_cast<std::size_t>(n), 0);
  mesh.held_value.assign(static_cast<std::size_t>(n), Vec3{0, 0, 0});
  return mesh;
}

void Body::set_nodes(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride) {
  require_mesh_kind(traits_, "nodes");
  const std::lock_guard lock(mutex_);
  require_takes_mesh();
  BodyMesh mesh = empty_mesh(n, x, node_stride, component_stride);
  std::swap(given(), mesh);
  group_.clear();
  number_.clear();
}

void Body::add_elements(std::int32_t type, std::int64_t n, const std::int32_t* connectivity, std::int32_t index_base,
                        std::int32_t tag) {
  require_mesh_kind(traits_, "elements");
  const std::lock_guard lock(mutex_);
  require_unprepared("mesh is");
  const char* node_setter = "rollcon_body_set_nodes";
  if (!traits_.volume) {
    append_elements(given().surface, type, n, connectivity, index_base, tag, "body", node_setter);
    return;
  }
  if (is_volume_type(type)) {
    append_elements(given().volume, given().surface.nodes(), type, n, connectivity, index_base, tag, node_setter);
  } else if (is_element_type(type)) {
    SurfaceMesh faces;  // mesh whose checks are used
    faces.offset = {0};
    faces.node.swap(given().surface.node);
    try {
      append_elements(faces, type, n, connectivity, index_base, tag, "body", node_setter);
      if (n > 0)
        given().naming.push_back(
            {.tag = tag, .connectivity = std::move(faces.connectivity), .type = static_cast<ElementType>(type)});
    } catch (...) {
      faces.node.swap(given().surface.node);
      throw;
    }
    faces.node.swap(given().surface.node);
  } else {
    fail(Status::err_argument,
         "type is %d; allowed: 304 (tet4), 310 (tet10), 326 (wedge6), 335 (wedge15), 338 (hex8), "
         "350 (hex20), and for tags of faces 203 (tri3), 206 (tri6), 214 (quad4), 218 (quad8)",
         type);
  }
  if (n == 0) return;
  given().surface.index_base = index_base;
  given().boundary_current = false;
}

void Body::tag_faces(std::int64_t n, const std::int32_t* element, const std::int32_t* side, std::int32_t index_base,
                     std::int32_t tag) {
  if (!traits_.filled())
    fail(Status::err_state,
         "the body has no volume elements whose faces could be tagged: it is not a finite-element "
         "body");
  const std::lock_guard lock(mutex_);
  require_unprepared("mesh is");
  require_count(n, "n");
  require_index_base(index_base);
  const VolumeElements& volume = given().volume;
  const SurfaceMesh& plane = given().surface;
  const std::int64_t elements = traits_.volume ? volume.elements() : plane.elements();
  if (elements == 0)
    fail(Status::err_state, "the body has no %selements: call rollcon_body_add_elements before tagging faces",
         traits_.volume ? "volume " : "");
  if (n == 0) return;
  require_pointer(element, "elements");
  require_pointer(side, "faces");
  FaceNaming naming{.tag = tag};
  naming.face.reserve(static_cast<std::size_t>(n));
  for (std::int64_t i = 0; i < n; ++i) {
    const std::int64_t e = std::int64_t{element[i]} - index_base;
    const auto entry = static_cast<long long>(i) + index_base;
    if (e < 0 || e >= elements)
      fail(Status::err_mesh, "entry %lld of elements (counting from %d) is %d; allowed: %d to %lld", entry, index_base,
           element[i], index_base, static_cast<long long>(elements) - 1 + index_base);
    const auto own = static_cast<std::size_t>(e);
    const std::int64_t sides =
        traits_.volume ? std::ssize(faces_of(volume.type[own])) : std::int64_t{corner_count(plane.type[own])};
    const std::int64_t s = std::int64_t{side[i]} - index_base;
    if (s < 0 || s >= sides)
      fail(Status::err_mesh, "entry %lld of faces (counting from %d) is %d; allowed for its element: %d to %lld", entry,
           index_base, side[i], index_base, static_cast<long long>(sides) - 1 + index_base);
    naming.face.push_back({e, static_cast<std::int32_t>(s)});
  }
  given().naming.push_back(std::move(naming));
  given().surface.index_base = index_base;
  given().boundary_current = false;
}

void Body::tag_faces_of_nodes(std::int64_t n, const std::int32_t* node, std::int32_t index_base, std::int32_t tag) {
  require_mesh_kind(traits_, "faces");
  const std::lock_guard lock(mutex_);
  require_unprepared("mesh is");
  require_node_ids(n, node, index_base, given().surface.nodes(), "faces");
  if (given().surface.elements() == 0 && given().volume.elements() == 0)
    fail(Status::err_state, "the body has no elements: call rollcon_body_add_elements before tagging their faces");
  if (n == 0) return;
  given().surface.index_base = index_base;
  FaceNaming naming{.tag = tag};
  for (std::int64_t i = 0; i < n; ++i) naming.nodes.push_back(node[i] - index_base);
  if (traits_.filled()) {
    given().naming.push_back(std::move(naming));
    given().boundary_current = false;
  } else {
    tag_by_nodes(naming, given().surface);
  }
}

void Body::set_support(std::int64_t n, const std::int32_t* node, std::int32_t index_base, std::int32_t dof_mask,
                       const double* value) {
  require_elastic_mesh_kind(traits_, "supports");
  const std::lock_guard lock(mutex_);
  require_unprepared("supports are");
  require_node_ids(n, node, index_base, given().surface.nodes(), "supports");
  if (dof_mask < 1 || dof_mask > 7)
    fail(Status::err_argument, "dof_mask is %d; allowed: 1 to 7, a sum of 1 (x), 2 (y), 4 (z)", dof_mask);
  for (std::int64_t i = 0; i < n && value; ++i) {
    for (int c = 0; c < 3; ++c) {
      if (dof_mask >> c & 1 && !std::isfinite(value[3 * i + c]))
        fail(Status::err_nonfinite, "component %c of entry %lld of values (counting from %d) is %g", "xyz"[c],
             static_cast<long long>(i) + index_base, index_base, value[3 * i + c]);
      if (dof_mask >> c & 1 && std::abs(value[3 * i + c]) > most_given)
        fail(Status::err_argument, "component %c of entry %lld of values (counting from %d) is %g; allowed: -%g to %g",
             "xyz"[c], static_cast<long long>(i) + index_base, index_base, value[3 * i + c], most_given, most_given);
    }
  }
  for (std::int64_t i = 0; i < n; ++i) {
    const auto id = static_cast<std::size_t>(node[i] - index_base);
    given().held[id] = static_cast<std::uint8_t>(given().held[id] | dof_mask);
    for (std::size_t c = 0; c < 3; ++c) {
      if (dof_mask >> c & 1) given().held_value[id][c] = value ? value[3 * static_cast<std::size_t>(i) + c] : 0;
    }
  }
}

void Body::set_traction(std::int32_t tag, const double* traction) {
  require_elastic_mesh_kind(traits_, "tractions");
  require_moderate(traction, "traction");
  const std::lock_guard lock(mutex_);
  require_unprepared("loads are");
  require_tag(tag, "tag");
  load_of(given().load, tag).traction = {traction[0], traction[1], traction[2]};
}

void Body::set_pressure(std::int32_t tag, double pressure) {
  require_elastic_mesh_kind(traits_, "pressures");
  require_finite(pressure, "pressure");
  if (std::abs(pressure) > most_given)
    fail(Status::err_argument, "pressure is %g; allowed: -%g to %g", pressure, most_given, most_given);
  const std::lock_guard lock(mutex_);
  require_unprepared("loads are");
  require_tag(tag, "tag");
  load_of(given().load, tag).pressure = pressure;
}

void Body::set_springs(std::int32_t tag, const double* stiffness) {
  require_elastic_mesh_kind(traits_, "springs");
  if (!traits_.filled())
    fail(Status::err_unsupported, "springs are for finite elements and sections, not for a %s body", traits_.name);
  require_moderate(stiffness, "stiffness");
  for (int c = 0; c < 3; ++c)
    if (stiffness[c] < 0)
      fail(Status::err_argument, "component %c of stiffness is %g; allowed: 0 to %g", "xyz"[c], stiffness[c],
           most_given);
  const std::lock_guard lock(mutex_);
  require_unprepared("springs are");
  require_tag(tag, "tag");
  load_of(given().spring, tag).stiffness = {stiffness[0], stiffness[1], stiffness[2]};
}

void Body::set_node_tractions(std::int32_t tag, std::int64_t n, const std::int32_t* node, std::int32_t index_base,
                              const double* along, const double* traction) {
  require_elastic_mesh_kind(traits_, "tractions");
  const std::lock_guard lock(mutex_);
  require_unprepared("loads are");
  require_node_ids(n, node, index_base, given().surface.nodes(), "tractions");
  require_tag(tag, "tag");
  if (along) require_moderate(along, "along");
  if (n > 0) require_pointer(traction, "tractions");
  for (std::int64_t i = 0; i < 3 * n; ++i) {
    const auto entry = static_cast<long long>(i / 3) + index_base;
    if (!std::isfinite(traction[i]))
      fail(Status::err_nonfinite, "component %lld of entry %lld of tractions (counting from %d) is %g",
           static_cast<long long>(i % 3), entry, index_base, traction[i]);
    if (std::abs(traction[i]) > most_given)
      fail(Status::err_argument,
           "component %lld of entry %lld of tractions (counting from %d) is %g; allowed: -%g to %g",
           static_cast<long long>(i % 3), entry, index_base, traction[i], most_given, most_given);
  }
  FaceLoad& load = load_of(given().load, tag);
  load.node.clear();
  load.of_node.clear();
  for (std::int64_t i = 0; i < n; ++i) {
    load.node.push_back(node[i] - index_base);
    load.of_node.push_back({traction[3 * i], traction[3 * i + 1], traction[3 * i + 2]});
  }
  load.along = Vec3{0, 0, 0};
  if (along && (along[0] != 0 || along[1] != 0 || along[2] != 0))
    load.along = normalized({along[0], along[1], along[2]});
}

void Body::set_body_force(std::int32_t tag, const double* force) {
  require_volume(traits_);
  require_moderate(force, "force");
  const std::lock_guard lock(mutex_);
  require_unprepared("loads are");
  load_of(given().body_force, tag).force = {force[0], force[1], force[2]};
}

void Body::set_rotation(std::int32_t tag, double density, const double* origin, const double* rate) {
  require_volume(traits_);
  require_finite(density, "density");
  if (!(density >= 0 && density <= most_given))
    fail(Status::err_argument, "density is %g; allowed: 0 to %g", density, most_given);
  require_moderate(origin, "origin");
  require_moderate(rate, "rate");
  const std::lock_guard lock(mutex_);
  require_unprepared("loads are");
  BodyForce& load = load_of(given().body_force, tag);
  load.density = density;
  load.origin = {origin[0], origin[1], origin[2]};
  load.rate = {rate[0], rate[1], rate[2]};
}

void Body::set_path(Sweep sweep, const double* origin, const double* axis, double period) {
  if (!traits_.section)
    fail(Status::err_state, "a %s body is not carried: rollcon_body_create with ROLLCON_BODY_SECTION makes one that is",
         traits_.name);
  require_moderate(origin, "origin");
  require_moderate(axis, sweep == Sweep::revolved ? "axis" : "direction");
  const Vec3 along{axis[0], axis[1], axis[2]};
  if (!(length(along) > 0))
    fail(Status::err_argument, "%s is zero; allowed: any other vector",
         sweep == Sweep::revolved ? "axis" : "direction");
  if (sweep == Sweep::extruded) {
    require_finite(period, "period");
    if (!(period > 0 && period <= most_given))
      fail(Status::err_argument, "period is %g; allowed: > 0, up to %g", period, most_given);
  }
  const std::lock_guard lock(mutex_);
  require_unprepared("way is");
  given().path = {sweep, {origin[0], origin[1], origin[2]}, (1 / length(along)) * along, period};
}

void Body::set_contact_faces(std::int64_t n, const std::int32_t* tag) {
  require_mesh_kind(traits_, "contact faces");
  const std::lock_guard lock(mutex_);
  require_unprepared("contact faces are");
  require_count(n, "n");
  if (n > 0) require_pointer(tag, "tags");
  std::vector<std::int32_t> named;
  for (std::int64_t i = 0; i < n; ++i) {
    require_tag(tag[i], "entry " + std::to_string(i) + " of tags (counting from 0)");
    if (std::find(named.begin(), named.end(), tag[i]) == named.end()) named.push_back(tag[i]);
  }
  std::swap(given().contact_tag, named);
}

void Body::set_int(const char* option, std::int64_t value) {
  const std::lock_guard lock(mutex_);
  require_unprepared("options are");
  body_option_table().set_int(options_, option, value);
}

void Body::set_real(const char* option, double value) {
  const std::lock_guard lock(mutex_);
  require_unprepared("options are");
  body_option_table().set_real(options_, option, value);
}

// Options need no lock: prepare only reads them, and calls on a handle that set them exclude each other.
std::int64_t Body::get_int(const char* option) const {
  return body_option_table().get_int(options_, option);
}

double Body::get_real(const char* option) const {
  return body_option_table().get_real(options_, option);
}

}  // namespace rollcon
