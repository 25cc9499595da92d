#pragma once
/// A body: its model and what the caller gave for it. Half-spaces need no mesh; rigid bodies may have a surface mesh,
/// from which gaps are computed. Finite-element bodies have volume elements.

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "bodies/body_model.hpp"
#include "bodies/model/body_group.hpp"
#include "geometry/profile_fit.hpp"
#include "support/context.hpp"

namespace rollcon {

class Body {
 public:
  /// Throws Error(err_unsupported) for kinds this build does not have, err_argument for others.
  Body(std::shared_ptr<Context> context, std::int32_t kind);

  // Setters check what can be checked at once, throw Error and then leave everything as it was. After prepare:
  // err_state. Half-spaces: err_state for all that needs a mesh.

  /// E > 0, -1 < nu <= 0.5, finite. Not for rigid bodies (err_state). Finite elements: for those with this tag; all
  /// others have one material.
  void set_elastic(std::int32_t tag, double young, double poisson);
  /// Forgets elements, supports, loads and contact faces.
  void set_nodes(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride);
  /// All of a mesh from a file, see mesh_file.hpp, in place of what there was; part: see part_of. Gmsh's physical
  /// groups are tags. err_io, err_mesh, err_argument.
  void read_mesh(const char* path, const char* part);
  /// Gives a tag to the elements of a group of that file and to its faces; a group of nodes alone names the faces
  /// between them. err_argument: no such group.
  void tag_group(const char* name, std::int32_t tag);
  std::int32_t group_count() const;
  std::string group_name(std::int64_t i) const;
  std::vector<std::int32_t> group_nodes(const char* name) const;  ///< ascending, from 0
  /// Finite-element bodies take volume elements, whose tag names their material, and surface elements, which give their
  /// tag to the boundary faces with the same nodes.
  void add_elements(std::int32_t type, std::int64_t n, const std::int32_t* connectivity, std::int32_t index_base,
                    std::int32_t tag);
  /// Tags boundary faces of finite elements by element and side.
  void tag_faces(std::int64_t n, const std::int32_t* element, const std::int32_t* side, std::int32_t index_base,
                 std::int32_t tag);
  /// Tags the faces all of whose nodes are given: of any body with a mesh.
  void tag_faces_of_nodes(std::int64_t n, const std::int32_t* node, std::int32_t index_base, std::int32_t tag);
  /// dof_mask: 1 x, 2 y, 4 z; value: 3 per node (unused components ignored), null: zero. Adds to what is held already;
  /// a component held twice takes the last value.
  void set_support(std::int64_t n, const std::int32_t* node, std::int32_t index_base, std::int32_t dof_mask,
                   const double* value);
  void set_traction(std::int32_t tag, const double* traction);
  void set_pressure(std::int32_t tag, double pressure);
  /// Takes tractions by node, in the body's axes; along not null: see FaceLoad.
  void set_node_tractions(std::int32_t tag, std::int64_t n, const std::int32_t* node, std::int32_t index_base,
                          const double* along, const double* traction);
  // Loads on the finite elements with a tag: force per volume, and that of a rotation with this vector about an axis
  // through origin.
  void set_body_force(std::int32_t tag, const double* force);
  void set_rotation(std::int32_t tag, double density, const double* origin, const double* rate);
  void set_contact_faces(std::int64_t n, const std::int32_t* tag);
  // Half-spaces and rigid bodies without a mesh take a profile, which forgets the one before and its place.

  /// Through n points (y, z), see profile_through; err_argument, err_nonfinite.
  void set_profile(std::int64_t n, const double* points, double filter_length);
  /// See profile_of_shape.
  void set_profile_shape(const char* shape, std::int64_t n, const double* parameters);
  /// Reads a file, see profile_file.hpp, whose numbers count in `unit`; mirror: 1 y, 2 z, 3 both. err_io, err_argument.
  void read_profile(const char* path, double unit, std::int32_t mirror, double filter_length);
  /// Its points in `unit`. err_state without a profile, err_io.
  void write_profile(const char* path, double unit) const;
  /// x, y, z of the profile: along, z_axis x along, z_axis made normal to it. err_state without a profile.
  void extrude_profile(const double* origin, const double* along, const double* z_axis);
  /// y along the axis, radius + z away from it.
  void revolve_profile(const double* origin, const double* axis, double radius);
  /// err_state without a profile.
  std::shared_ptr<const ProfileCurve> profile() const;
  /// Another body of this kind and material with this profile, which has no place yet; not prepared. err_state without
  /// a profile.
  std::shared_ptr<Body> with_profile_alone() const;
  /// The elastic constants at the contact are those of the other.
  bool same_elastic(const Body& other) const;
  /// The radius at z = 0 of a revolved profile; infinite: there is none.
  double revolved_radius() const {
    return model_->profile.place == ProfilePlace::revolved ? model_->profile.radius : INFINITY;
  }
  double profile_length() const;
  ProfilePoint profile_point(double s) const;
  void set_int(const char* option, std::int64_t value);
  void set_real(const char* option, double value);
  std::int64_t get_int(const char* option) const;
  double get_real(const char* option) const;

  /// Checks that the body is complete (err_state), its mesh (err_mesh) and supports, assembles and factorises
  /// (err_singular), and freezes it. Idempotent; contacts in several threads may call it at the same time. Only a
  /// prepared body may be read. A body equal to one that was prepared in the same context shares what that one has.
  void prepare() { prepare(nullptr); }
  /// Writes the body, prepared if it was not, to a file: what was given, and what of its equations is kept. err_io. See
  /// body_file.cpp for the sections.
  void save(const std::string& path);
  /// A prepared body from such a file; nothing is assembled or factorised. err_io, err_unsupported.
  static std::shared_ptr<Body> load(std::shared_ptr<Context> context, const std::string& path);
  /// Another body of this context that was given the same, not prepared.
  std::shared_ptr<Body> copy() const;

  BodyKind kind() const { return traits_.kind; }
  const BodyTraits& traits() const { return traits_; }
  bool prepared() const { return prepared_.load(); }
  bool rigid() const { return !traits_.elastic; }
  /// May be asked while another thread gives the mesh or prepares the body.
  bool meshed() const;
  /// A mesh or a profile; likewise. Others take the plane of the contact's axes.
  bool has_surface() const;
  /// Nodes and elements (of a volume: those inside) given so far; likewise.
  std::pair<std::int64_t, std::int64_t> size() const;
  /// The material at the contact: of a prepared body of several, that of the greatest part of its contact faces.
  double young() const { return model_->contact_material.young; }
  double poisson() const { return model_->contact_material.poisson; }
  const BodyMesh& mesh() const { return model_->mesh; }
  /// The surface as it is now; also while another thread gives more of it or prepares the body. Throws err_mesh when
  /// faces of finite elements were tagged that are not on the boundary.
  SurfaceMesh surface_copy();
  const BodyOptions& options() const { return options_; }
  Context& context() const { return *context_; }

  /// Its contact faces or profile, in its axes; null: the body takes the plane of the contact's axes. Of a prepared
  /// body.
  const Surface* surface() const { return model_->surface.get(); }

  // Prepared bodies with a mesh have these.
  const TractionNodes& traction_nodes() const { return model_->traction_nodes; }
  /// Fans that tags and supports do not divide: normals of the surface itself.
  const TractionNodes& smooth_fans() const { return model_->smooth_fans; }
  /// Over the faces that may come into contact.
  const SurfaceSearch& search() const { return *model_->search; }
  /// Null for rigid bodies.
  Condensed* response() const { return model_->response.get(); }
  const OwnLoads& own() const { return model_->own; }

  // Any prepared body has these.
  /// Prepared by sharing what an equal body had: nothing was assembled for this one.
  bool shared() const { return shared_; }
  /// Both have the same mesh and equations in memory: one handle twice, or equal bodies.
  bool same_as(const Body& other) const { return model_ == other.model_; }
  /// Read from a file.
  bool loaded() const { return loaded_; }

 private:
  void require_unprepared(const char* what) const;
  void require_takes_mesh() const;
  /// A mesh with these nodes, none of them held, and no elements.
  BodyMesh empty_mesh(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride) const;
  const BodyGroup& group(const char* name) const;
  void require_tag(std::int32_t tag, const std::string& entry) const;
  void require_complete() const;
  void require_materials() const;
  void require_takes_profile() const;
  void require_profile() const;
  void replace_profile(ProfileCurve curve);
  /// Logs what is told of the file, and of the fit.
  void fit_profile(const std::vector<Vec2>& point, double filter_length, const PointName& name, std::string told = {});
  /// Takes what a file has, if one is given.
  void prepare(SectionReader* saved);
  void log_preparation() const;
  BodyMesh& given() { return model_->mesh; }
  const BodyMesh& given() const { return model_->mesh; }

  std::shared_ptr<Context> context_;
  const BodyTraits& traits_;
  mutable std::mutex mutex_;  ///< of everything below until prepared
  std::atomic<bool> prepared_{false};
  bool shared_ = false, loaded_ = false;
  bool shared_equations_ = false;     ///< of a body under other loads
  std::shared_ptr<BodyModel> model_;  ///< its own until prepared
  BodyOptions options_;
  std::vector<BodyGroup> group_;  ///< of the file that the mesh came from
};

}  // namespace rollcon
