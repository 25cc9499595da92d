/// Digests, writes, reads and checks what a body was given.

#include <algorithm>
#include <cmath>
#include <string>

#include "bodies/body_model.hpp"
#include "bodies/body_options.hpp"
#include "bodies/model/archive.hpp"
#include "mesh/volume_shape.hpp"
#include "support/error.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

/// Bytes that an entry of a list takes at least.
constexpr std::size_t least_material = 20, least_option = 28, least_naming = 40, least_load = 76, least_face = 12,
                      least_body_force = 84, least_spring = 28;

void require(bool good, const char* what) {
  if (!good) fail(Status::err_mesh, "%s", what);
}

template <class Archive, class Model>
void materials(Archive& ar, Model& model) {
  std::vector<std::pair<std::int32_t, Elastic>> all(model.material.begin(), model.material.end());
  ar.list(all, least_material, [](auto& a, auto& entry) {
    a(entry.first);
    a(entry.second.young);
    a(entry.second.poisson);
  });
  if constexpr (Archive::reads) model.material = {all.begin(), all.end()};
}

template <class Archive, class Model>
void relaxations(Archive& ar, Model& model) {
  std::vector<std::pair<std::int32_t, Relaxation>> all(model.relaxation.begin(), model.relaxation.end());
  ar.list(all, least_material, [](auto& a, auto& entry) {
    a(entry.first);
    a.list(entry.second.term, sizeof(PronyTerm), [](auto& b, auto& t) { b(t.ratio), b(t.time); });
    a.list(entry.second.point, sizeof(ModulusPoint), [](auto& b, auto& p) { b(p.frequency), b(p.storage), b(p.loss); });
    a(entry.second.misfit);
  });
  if constexpr (Archive::reads) model.relaxation = {all.begin(), all.end()};
}

struct NamedValue {
  std::string name;
  SettingType type = SettingType::integer;
  std::int64_t integer = 0;
  double real = 0;
};

// Options go by name: a later library may have more of them.
template <class Archive, class Model>
void options(Archive& ar, Model& model) {
  const auto& table = body_option_table();
  std::vector<NamedValue> all;
  if constexpr (!Archive::reads)
    for (const Setting& s : table.settings()) {
      const bool integer = s.type == SettingType::integer;
      all.push_back({s.name, s.type, integer ? table.get_int(model.options, s.name) : 0,
                     integer ? 0 : table.get_real(model.options, s.name)});
    }
  ar.list(all, least_option, [](auto& a, auto& value) {
    a(value.name);
    a(value.type);
    a(value.integer);
    a(value.real);
  });
  if constexpr (Archive::reads)
    for (const NamedValue& value : all) {
      if (value.type == SettingType::integer)
        table.set_int(model.options, value.name.c_str(), value.integer);
      else
        table.set_real(model.options, value.name.c_str(), value.real);
    }
}

template <class Archive, class Mesh>
void mesh_content(Archive& ar, Mesh& mesh, const BodyTraits& traits) {
  const bool volume = traits.volume;
  if constexpr (!Archive::reads)
    if (mesh.section.swept()) {
      BodyMesh given = unswept(mesh);
      return mesh_content(ar, given, traits);
    }
  ar(mesh.surface.index_base);
  ar(mesh.surface.node);
  if (!volume) {  // update_boundary() makes the surface of a volume
    ar(mesh.surface.type);
    ar(mesh.surface.tag);
    ar(mesh.surface.connectivity);
  }
  ar(mesh.volume.type);
  ar(mesh.volume.tag);
  ar(mesh.volume.connectivity);
  ar.list(mesh.naming, least_naming, [](auto& a, auto& naming) {
    a(naming.tag);
    a.list(naming.face, least_face, [](auto& b, auto& face) {
      b(face.element);
      b(face.side);
    });
    a(naming.nodes);
    a(naming.connectivity);
    a(naming.type);
  });
  ar(mesh.held);
  ar(mesh.held_value);
  ar.list(mesh.load, least_load, [](auto& a, auto& load) {
    a(load.tag);
    a(load.traction);
    a(load.pressure);
    a(load.node);
    a(load.of_node);
    a(load.along);
  });
  ar.list(mesh.body_force, least_body_force, [](auto& a, auto& load) {
    a(load.tag);
    a(load.force);
    a(load.density);
    a(load.origin);
    a(load.rate);
  });
  ar(mesh.contact_tag);
  if (traits.given) {
    CondensedMatrix matrix;
    if (!Archive::reads && mesh.matrix) matrix = *mesh.matrix;
    ar(matrix.form);
    ar(matrix.value);
    if constexpr (Archive::reads) mesh.matrix = std::make_shared<const CondensedMatrix>(std::move(matrix));
  }
  if (!traits.filled()) return;
  ar.list(mesh.spring, least_spring, [](auto& a, auto& spring) {
    a(spring.tag);
    a(spring.stiffness);
  });
  if (!traits.section) return;
  ar(mesh.path.sweep);
  ar(mesh.path.origin);
  ar(mesh.path.axis);
  ar(mesh.path.period);
}

// Checks of a profile what setters check when a caller gives it follow.

void check_pieces(const std::vector<ProfilePiece>& piece) {
  constexpr double most = 1e31, most_turned = 3.2;
  const auto moderate = [](double x) { return std::abs(x) <= most; };
  require(!piece.empty(), "a profile has no piece");
  for (const ProfilePiece& p : piece) {
    require(p.length > 0 && moderate(p.length), "the length of a profile's piece is out of range");
    require(std::abs(p.curvature) * p.length <= most_turned, "an arc of a profile turns too far");
    require(dot(p.along, p.along) > 0, "a piece of a profile has no direction");
    for (const Vec2& v : {p.start, p.along, p.square, p.cube})
      require(moderate(v[0]) && moderate(v[1]), "a number of a profile is out of range");
  }
}

void check_profile(const BodyProfile& profile) {
  constexpr double unit = 1e-9;
  require(profile.place == ProfilePlace::extruded || profile.place == ProfilePlace::revolved, "a profile has no place");
  for (const double x : profile.origin) require(std::isfinite(x), "a number is not finite");
  require(std::abs(length(profile.axis) - 1) < unit && std::abs(length(profile.z) - 1) < unit,
          "a direction of a profile is no unit vector");
  require(std::isfinite(profile.radius), "a number is not finite");
  for (const ProfileSlice& slice : profile.slice)
    require(slice.feature.size() == profile.slice[0].feature.size(), "slices have unlike numbers of features");
}

template <class Archive, class Curve>
void curve_content(Archive& ar, Curve& curve) {
  std::vector<ProfilePiece> piece;
  if constexpr (!Archive::reads) piece = curve->pieces();
  ar.list(piece, sizeof(ProfilePiece), [](auto& a, auto& p) {
    a(p.length);
    a(p.start);
    a(p.along);
    a(p.square);
    a(p.cube);
    a(p.curvature);
  });
  if constexpr (Archive::reads) {
    check_pieces(piece);
    curve = std::make_shared<const ProfileCurve>(std::move(piece));
  }
}

template <class Archive, class Profile>
void slices_content(Archive& ar, Profile& profile) {
  constexpr std::size_t least = 2 * sizeof(double);
  ar.list(profile.slice, least, [](auto& a, auto& slice) {
    a(slice.u);
    a(slice.feature);
    curve_content(a, slice.curve);
    if constexpr (Archive::reads) require(std::isfinite(slice.u), "a number is not finite");
  });
  ar.list(profile.wave, least, [](auto& a, auto& wave) {
    a(wave.amplitude);
    a(wave.length);
    a(wave.phase);
    if constexpr (Archive::reads)
      require(std::isfinite(wave.amplitude) && std::isfinite(wave.phase) && wave.length > 0,
              "a wave of a profile is out of range");
  });
}

template <class Archive, class Profile>
void profile_content(Archive& ar, Profile& profile) {
  std::uint8_t given = profile.curve ? 1 : 0;
  ar(given);
  if (given == 0) return;
  curve_content(ar, profile.curve);
  ar(profile.place);
  ar(profile.origin);
  ar(profile.axis);
  ar(profile.z);
  ar(profile.radius);
  slices_content(ar, profile);
  if constexpr (Archive::reads) check_profile(profile);
}

template <class Archive, class Model>
void content(Archive& ar, Model& model) {
  ar(model.kind);
  materials(ar, model);
  relaxations(ar, model);
  options(ar, model);
  if constexpr (Archive::reads) require(find_traits(model.kind) != nullptr, "the kind of body is unknown");
  mesh_content(ar, model.mesh, model.traits());
  profile_content(ar, model.profile);
}

template <class Type>
std::vector<std::int64_t> offsets(const std::vector<Type>& types, const std::vector<std::int32_t>& tags,
                                  const std::vector<std::int32_t>& connectivity) {
  std::vector<std::int64_t> offset{0};
  for (const Type type : types) {
    require(node_count(type) > 0, "an element's type is unknown");
    offset.push_back(offset.back() + node_count(type));
  }
  require(tags.size() == types.size() && static_cast<std::size_t>(offset.back()) == connectivity.size(),
          "counts of elements, tags and nodes do not match");
  return offset;
}

void require_ids(const std::vector<std::int32_t>& id, std::int64_t count) {
  require(std::all_of(id.begin(), id.end(), [&](std::int32_t k) { return k >= 0 && k < count; }),
          "the id of a node is out of range");
}

void require_all_finite(const std::vector<Vec3>& vectors) {
  for (const Vec3& v : vectors)
    for (const double x : v) require(std::isfinite(x), "a number is not finite");
}

void check_naming(const FaceNaming& naming, const BodyMesh& mesh) {
  for (const BoundaryFace& face : naming.face) {
    const bool plane = mesh.volume.elements() == 0;
    require(face.element >= 0 && face.element < (plane ? mesh.surface.elements() : mesh.volume.elements()),
            "a tagged face belongs to no element");
    const auto e = static_cast<std::size_t>(face.element);
    const std::size_t sides =
        plane ? static_cast<std::size_t>(corner_count(mesh.surface.type[e])) : faces_of(mesh.volume.type[e]).size();
    require(face.side >= 0 && static_cast<std::size_t>(face.side) < sides, "an element has no such face");
  }
  require_ids(naming.nodes, mesh.surface.nodes());
  require_ids(naming.connectivity, mesh.surface.nodes());
  if (naming.connectivity.empty()) return;
  const int width = node_count(naming.type);
  require(width > 0 && naming.connectivity.size() % static_cast<std::size_t>(width) == 0,
          "a surface element is incomplete");
}

void check_materials(BodyModel& model) {
  require(model.traits().elastic || model.material.empty(), "a rigid body has a material");
  for (const auto& [tag, elastic] : model.material) {
    require_elastic_constants(elastic.young, elastic.poisson);
    require(model.traits().filled() || tag == 0, "a body of one material has several");
    model.contact_material = elastic;
  }
  for (const auto& [tag, relaxation] : model.relaxation) {
    require(model.traits().half_space || model.traits().section, "a body relaxes that is no half-space nor a section");
    double left = 1, before = 0;
    for (const PronyTerm& t : relaxation.term) {
      require(t.ratio > 0 && t.time > before && std::isfinite(t.time), "a term of a relaxation is out of range");
      left -= t.ratio, before = t.time;
    }
    require(left > 0 && left < 1, "the terms of a relaxation are out of range");
    before = 0;
    for (const ModulusPoint& p : relaxation.point) {
      require(p.frequency > before && p.storage > 0 && p.loss >= 0 && std::isfinite(p.frequency * p.storage * p.loss),
              "a modulus over frequency is out of range");
      before = p.frequency;
    }
  }
}

// Checks of a mesh what setters check when a caller gives it.
void check_mesh(BodyModel& model) {
  BodyMesh& mesh = model.mesh;
  const std::int64_t nodes = mesh.surface.nodes();
  require(model.traits().meshed || nodes == 0, "a half-space has nodes");
  require(!model.profile.curve || (nodes == 0 && !(model.traits().meshed && model.traits().elastic)),
          "a body with a mesh has a profile");
  require(model.traits().volume || (mesh.volume.type.empty() && (model.traits().section || mesh.naming.empty())),
          "a body without volume has volume elements");
  const auto sweep = static_cast<std::int32_t>(mesh.path.sweep);
  require(sweep >= 0 && sweep <= 2 && (sweep == 0 || std::abs(length(mesh.path.axis) - 1) < 1e-9) &&
              std::isfinite(mesh.path.period) && (sweep != 2 || mesh.path.period > 0),
          "the way of a section is out of range");
  require_all_finite({mesh.path.origin});
  require(mesh.surface.index_base == 0 || mesh.surface.index_base == 1, "the index base is neither 0 nor 1");
  if (!model.traits().volume)
    mesh.surface.offset = offsets(mesh.surface.type, mesh.surface.tag, mesh.surface.connectivity);
  mesh.volume.offset = offsets(mesh.volume.type, mesh.volume.tag, mesh.volume.connectivity);
  require_ids(mesh.surface.connectivity, nodes);
  require_ids(mesh.volume.connectivity, nodes);
  for (const FaceNaming& naming : mesh.naming) check_naming(naming, mesh);
  require(mesh.held.size() == mesh.surface.node.size() && mesh.held_value.size() == mesh.held.size(),
          "counts of nodes and supports do not match");
  for (const std::uint8_t held : mesh.held) require(held <= 7, "a support holds no such component");
  if (model.traits().given) require_matrix(*mesh.matrix, nodes, mesh.surface.index_base);
  require_all_finite(mesh.surface.node);
  require_all_finite(mesh.held_value);
  for (const FaceLoad& load : mesh.load) {
    require_all_finite({load.traction});
    require(std::isfinite(load.pressure), "a number is not finite");
    require(load.node.size() == load.of_node.size(), "counts of nodes and tractions do not match");
    require_ids(load.node, nodes);
    require_all_finite(load.of_node);
    require_all_finite({load.along});
  }
  for (const Spring& spring : mesh.spring)
    for (const double k : spring.stiffness)
      require(k >= 0 && std::isfinite(k), "the stiffness of a spring is out of range");
  for (const BodyForce& load : mesh.body_force) {
    require_all_finite({load.force, load.origin, load.rate});
    require(std::isfinite(load.density), "a number is not finite");
  }
}

}  // namespace

void require_elastic_constants(double young, double poisson) {
  require_finite(young, "young");
  require_finite(poisson, "poisson");
  // Squares of stiffnesses and compliances beyond these would leave the range of doubles.
  constexpr double least = 1e-60, most = 1e60;
  if (!(young >= least && young <= most))
    fail(Status::err_argument, "young is %g; allowed: > 0, from %g to %g", young, least, most);
  if (!(poisson > -1 && poisson <= 0.5))
    fail(Status::err_argument, "poisson is %g; allowed: -1 < poisson <= 0.5", poisson);
}

ContentDigest digest_of(const BodyModel& model) {
  Digest digest;
  OutArchive ar(digest);
  content(ar, model);
  return digest.value();
}

ContentDigest digest_without_loads(const BodyModel& model) {
  BodyModel bare;
  bare.kind = model.kind;
  bare.material = model.material;
  bare.relaxation = model.relaxation;
  bare.mesh = model.mesh;
  bare.profile = model.profile;
  bare.options = model.options;
  bare.mesh.load.clear();
  bare.mesh.body_force.clear();
  bare.mesh.held_value.assign(bare.mesh.held.size(), Vec3{0, 0, 0});
  return digest_of(bare);
}

void write_content(const BodyModel& model, SectionWriter& file) {
  file.begin("body");
  OutArchive ar(file);
  content(ar, model);
}

void read_content(SectionReader& file, BodyModel& model) {
  file.begin("body");
  InArchive ar(file);
  try {
    content(ar, model);
    file.end();
    check_materials(model);
    check_mesh(model);
  } catch (const Error& e) {
    if (e.status() == Status::err_io) throw;
    file.fail_here(e.what());
  }
}

}  // namespace rollcon
