#pragma once
/// Holds a body: its model and what the caller gave for it. Half-spaces need no mesh; rigid bodies may have a surface
/// mesh, from which gaps are computed. Finite-element bodies have volume elements.

#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bodies/body_model.hpp"
#include "bodies/model/body_group.hpp"
#include "bodies/model/section_profile.hpp"
#include "geometry/profile_fit.hpp"
#include "support/context.hpp"

namespace rollcon {

class Body {
 public:
  /// Throws err_unsupported for kinds that this build does not have, and err_argument for numbers that are no kind.
  Body(std::shared_ptr<Context> context, std::int32_t kind);

  // Setters check what can be checked at once; if they throw, everything stays as it was. err_state: the body is
  // prepared, or a half-space is given what needs a mesh.

  /// Sets finite E > 0 and -1 < nu <= 0.5: of the finite elements with this tag, or of the whole body where it is of
  /// another kind. err_state: the body is rigid.
  void set_elastic(std::int32_t tag, double young, double poisson);
  // Half-spaces relax, and sections (err_state: the body is another one).

  /// Sets how a material relaxes from its elastic constants, which are those at once: checked_relaxation().
  void set_viscoelastic(std::int32_t tag, std::int64_t n, const double* ratios, const double* times);
  /// Sets it by storage and loss moduli, which take the place of Young's modulus: checked_moduli(). err_state: the
  /// material has no Poisson's ratio yet; err_argument: no Prony series is near the moduli, and half-spaces need one.
  void set_moduli(std::int32_t tag, std::int64_t n, const double* frequencies, const double* storage,
                  const double* loss);
  void set_relaxation(std::int32_t tag, Relaxation checked);
  /// Forgets elements, supports, loads and contact faces.
  void set_nodes(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride);
  /// Reads all of a mesh from a file, see mesh_file.hpp, in place of what there was; part: see part_of. Gmsh's
  /// physical groups are tags. err_io, err_mesh, err_argument.
  void read_mesh(const char* path, const char* part);
  /// Gives a tag to the elements of a group of that file and to its faces; a group of nodes alone names the faces
  /// between them. err_argument: no such group.
  void tag_group(const char* name, std::int32_t tag);
  /// Returns the numbers of a prepared body's nodes in the mesh's file; empty: they count from 1.
  std::span<const std::int64_t> node_numbers() const;
  std::int32_t group_count() const;
  std::string group_name(std::int64_t i) const;
  std::vector<std::int32_t> group_nodes(const char* name) const;  ///< nodes counted from 0, ascending
  /// Adds elements. Finite-element bodies take volume elements, whose tag names their material, and surface elements,
  /// which give their tag to the boundary faces with the same nodes.
  void add_elements(std::int32_t type, std::int64_t n, const std::int32_t* connectivity, std::int32_t index_base,
                    std::int32_t tag);
  /// Tags boundary faces of finite elements by element and side.
  void tag_faces(std::int64_t n, const std::int32_t* element, const std::int32_t* side, std::int32_t index_base,
                 std::int32_t tag);
  /// Tags the faces all of whose nodes are given; any body with a mesh has such faces.
  void tag_faces_of_nodes(std::int64_t n, const std::int32_t* node, std::int32_t index_base, std::int32_t tag);
  /// Holds more components; one held twice takes the last value. dof_mask: 1 x, 2 y, 4 z; value: 3 per node (unused
  /// components ignored), null: zero.
  void set_support(std::int64_t n, const std::int32_t* node, std::int32_t index_base, std::int32_t dof_mask,
                   const double* value);
  void set_traction(std::int32_t tag, const double* traction);
  void set_pressure(std::int32_t tag, double pressure);
  /// Takes tractions by node, in the body's axes; along not null: see FaceLoad.
  void set_node_tractions(std::int32_t tag, std::int64_t n, const std::int32_t* node, std::int32_t index_base,
                          const double* along, const double* traction);
  /// Puts faces with a tag on springs: stiffness per area along the body's axes, 0 lets go. Finite elements and
  /// sections.
  void set_springs(std::int32_t tag, const double* stiffness);
  // Finite elements with a tag take a force per volume, and the force of a rotation with vector `rate` about an axis
  // through `origin`.
  void set_body_force(std::int32_t tag, const double* force);
  void set_rotation(std::int32_t tag, double density, const double* origin, const double* rate);
  void set_contact_faces(std::int64_t n, const std::int32_t* tag);
  // A body of kind condensed has a stiffness or flexibility (form: MatrixForm) of all nodes, rows 3 * node + component.

  /// Takes the n = (3 nodes)^2 numbers of the matrix. err_argument names the entry that cannot be.
  void set_condensed(std::int32_t form, std::int64_t n, const double* matrix);
  /// Reads it from a file, see matrix_file.hpp. err_io.
  void read_condensed(std::int32_t form, const char* path);
  /// Writes the matrix of a prepared body with equations on the nodes of its contact faces, ascending. err_io.
  void write_condensed(std::int32_t form, const char* path) const;
  /// Turns a section about an axis.
  void revolve(const double* origin, const double* axis) { set_path(Sweep::revolved, origin, axis, 0); }
  /// Draws a section along a line; all on it repeats after the period.
  void extrude(const double* origin, const double* direction, double period) {
    set_path(Sweep::extruded, origin, direction, period);
  }
  // Half-spaces and rigid bodies without a mesh take a profile; a new one replaces the last and has no place yet.

  /// Takes the profile through n points (y, z), see profile_through; err_argument, err_nonfinite.
  void set_profile(std::int64_t n, const double* points, double filter_length);
  /// Takes a profile of a named shape, see profile_of_shape.
  void set_profile_shape(const char* shape, std::int64_t n, const double* parameters);
  /// Reads a file, see profile_file.hpp, whose numbers count in `unit`; mirror: 1 y, 2 z, 3 both, 4 z where
  /// the shape says so, 5 y, too. err_io, err_argument.
  void read_profile(const char* path, double unit, std::int32_t mirror, double filter_length);
  /// Reads a list of slices, see slice_file.hpp, whose profiles' numbers count in `unit`; replaces the profile and all
  /// slices.
  void read_slices(const char* path, double millimetre, double unit, std::int32_t mirror, double filter_length);
  /// Writes the profile's points in `unit`. err_state: there is no profile; err_io.
  void write_profile(const char* path, double unit) const;
  /// Places the profile with its x along `along`, its z along the part of z_axis at right angles to that and its y
  /// along their product z x x. err_state: there is no profile.
  void extrude_profile(const double* origin, const double* along, const double* z_axis);
  /// Places the profile with its y along the axis and its points at radius + z from it. err_state: there is no profile.
  void revolve_profile(const double* origin, const double* axis, double radius);
  /// Takes the mirror image of the profile in its y axis; what varies it is lost.
  void turn_profile_over();
  /// Takes the profile as that at one place of several, at this length along the body or angle round it; feature: n arc
  /// lengths of points that correspond, see ProfileSlice. Profiles that are set later leave it. err_state: no profile.
  void add_slice(double u, std::int64_t n, const double* feature);
  /// Adds a wave to z along or round the body, see ProfileWave.
  void add_wave(double amplitude, double wavelength, double phase);
  /// Returns what add_slice() and add_wave() were given, of a profile that has a place; null: nothing.
  std::shared_ptr<const ProfileSlices> slices() const;
  /// Returns a number that changes with each slice and wave.
  std::size_t variations() const;
  /// Returns the profile that was set last; that of a section is the line of its contact edges (section_profile).
  /// err_state: there is none.
  std::shared_ptr<const ProfileCurve> profile() const;
  /// Returns that of the slice nearest to 0, or the profile where there are no slices.
  std::shared_ptr<const ProfileCurve> nominal_profile() const;
  /// Returns that of a prepared section. Errors are those of profile_of().
  std::shared_ptr<const SectionProfile> section_profile() const;
  /// Makes another body of this kind and material (a half-space for a section), not prepared, with this profile, which
  /// has no place yet. err_state: there is no profile.
  std::shared_ptr<Body> with_profile_alone() const;
  /// Makes a half-space of these constants with this profile instead.
  std::shared_ptr<Body> with_profile_alone(double young, double poisson) const;
  /// Tells whether both bodies have the same elastic constants at the contact.
  bool same_elastic(const Body& other) const;
  /// Returns the radius at z = 0 of a revolved profile; infinite: there is none.
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
  /// Reads a prepared body from a file that save() wrote; nothing is assembled or factorised. err_io, err_unsupported.
  static std::shared_ptr<Body> load(std::shared_ptr<Context> context, const std::string& path);
  /// Makes another body of this context from what was given for this one, not prepared.
  std::shared_ptr<Body> copy() const;

  BodyKind kind() const { return traits_.kind; }
  const BodyTraits& traits() const { return traits_; }
  bool prepared() const { return prepared_.load(); }
  bool rigid() const { return !traits_.elastic; }
  /// Tells whether the body has a mesh, also while another thread gives it or prepares the body.
  bool meshed() const;
  /// Tells whether the body has a mesh or a profile, at any time; else it takes the plane of the contact's axes.
  bool has_surface() const;
  /// Counts nodes and elements (of a volume: those inside) given so far, at any time.
  std::pair<std::int64_t, std::int64_t> size() const;
  // Elastic constants at the contact: a prepared body of several materials has those of most of its contact faces.
  double young() const { return model_->contact_material.young; }
  double poisson() const { return model_->contact_material.poisson; }
  /// Tells whether a material of the body relaxes.
  bool creeps() const { return !model_->relaxation.empty(); }
  /// Says how the material at the contact relaxes; no terms: it does not.
  const Relaxation& relaxation() const;
  const BodyMesh& mesh() const { return model_->mesh; }
  /// Copies the surface as it is now, also while another thread gives more of it or prepares the body. err_mesh: faces
  /// of finite elements were tagged that are not on the boundary.
  SurfaceMesh surface_copy();
  const BodyOptions& options() const { return options_; }
  /// Returns what became of the points of its profile, or of all its slices.
  FitReport fit_report() const;
  Context& context() const { return *context_; }

  /// Returns the contact faces or the profile of a prepared body, in its axes; null: it takes the plane of the
  /// contact's axes.
  const Surface* surface() const { return model_->surface.get(); }

  // Prepared bodies with a mesh have these.
  const TractionNodes& traction_nodes() const { return model_->traction_nodes; }
  /// Returns fans that tags and supports do not divide, with normals of the surface itself.
  const TractionNodes& smooth_fans() const { return model_->smooth_fans; }
  /// Returns the search over the faces that may come into contact.
  const SurfaceSearch& search() const { return *model_->search; }
  /// Returns null for rigid bodies.
  Condensed* response() const { return model_->response.get(); }
  const OwnLoads& own() const { return model_->own; }

  // Any prepared body has these.
  /// Tells whether the body shares what an equal one had: nothing was assembled for it.
  bool shared() const { return shared_; }
  /// Tells whether both have one mesh and equations in memory: they are one handle twice, or equal bodies.
  bool same_as(const Body& other) const { return model_ == other.model_; }
  /// Tells whether load() read the body.
  bool loaded() const { return loaded_; }

 private:
  void require_unprepared(const char* what) const;
  void require_takes_mesh() const;
  void take_matrix(CondensedMatrix matrix);
  void set_path(Sweep sweep, const double* origin, const double* axis, double period);
  /// Makes a mesh with these nodes, none of them held, and no elements.
  BodyMesh empty_mesh(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride) const;
  const BodyGroup& group(const char* name) const;
  void require_tag(std::int32_t tag, const std::string& entry) const;
  void require_complete() const;
  void require_materials() const;
  void require_takes_profile() const;
  void require_profile() const;
  void replace_profile(ProfileCurve curve, const FitReport& fit = {});
  /// Returns how points become a curve, by the options. err_nonfinite.
  ProfileFit profile_fit(double filter_length) const;
  /// Logs what is told of a file and of the fit.
  void tell_of_profile(const std::string& told) const;
  /// Takes what a file has, if one is given.
  void prepare(SectionReader* saved);
  void log_preparation() const;
  BodyMesh& given() { return model_->mesh; }
  const BodyMesh& given() const { return model_->mesh; }

  std::shared_ptr<Context> context_;
  const BodyTraits& traits_;
  mutable std::mutex mutex_;  ///< guards everything below until prepared
  std::atomic<bool> prepared_{false};
  bool shared_ = false, loaded_ = false;
  bool shared_equations_ = false;     ///< a body under other loads had the equations
  std::shared_ptr<BodyModel> model_;  ///< the body's own model until prepared
  BodyOptions options_;
  std::vector<BodyGroup> group_;      ///< groups of the file that the mesh came from
  std::vector<std::int64_t> number_;  ///< numbers of the nodes in that file; empty: they count from 1
  mutable std::shared_ptr<const SectionProfile> boundary_;  ///< null until it is asked for
};

}  // namespace rollcon
