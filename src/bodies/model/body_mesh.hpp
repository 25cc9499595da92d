#pragma once
/// Holds what the caller gave for a body with a mesh; ids and numbers are checked, shapes not yet.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bodies/model/condensed_matrix.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/swept_section.hpp"
#include "mesh/volume_boundary.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

struct FaceLoad {
  std::int32_t tag = 0;
  Vec3 traction{0, 0, 0};  ///< traction in the body's axes
  double pressure = 0;     ///< acts against the outward normal and adds to the traction

  // Tractions by node add to these and are linear or quadratic between nodes, as the faces are.
  std::vector<std::int32_t> node{};
  std::vector<Vec3> of_node{};
  /// Direction whose part in the surface is t: nodal tractions are components along t, normal x t and the outward
  /// normal. Zero: they are in the body's axes.
  Vec3 along{0, 0, 0};

  /// Returns of_node for all nodes of the body; empty: none has a traction.
  std::vector<Vec3> by_node(std::size_t nodes) const;
  /// Turns components at a point with this unit normal into the body's axes.
  Vec3 turned(const Vec3& components, const Vec3& normal) const;
};

/// Holds a load on the elements of one material, in the body's axes: force + density omega x (x - origin) x omega.
struct BodyForce {
  std::int32_t tag = 0;
  Vec3 force{0, 0, 0};  ///< force per volume
  double density = 0;
  Vec3 origin{0, 0, 0}, rate{0, 0, 0};  ///< point on the axis and vector omega of the rotation

  Vec3 at(const Vec3& x) const { return force + density * cross(cross(rate, x - origin), rate); }
};

/// Holds springs on faces with a tag: the traction on them is minus the stiffness times the displacement.
struct Spring {
  std::int32_t tag = 0;
  Vec3 stiffness{0, 0, 0};  ///< stiffness per area along the body's axes; of sections along those at their place
};

/// Records one call that gave boundary faces of a volume a tag: by element and side, by the set of nodes that they lie
/// on, or as surface elements. Later calls win.
struct FaceNaming {
  std::int32_t tag = 0;
  std::vector<BoundaryFace> face{};
  std::vector<std::int32_t> nodes{};
  std::vector<std::int32_t> connectivity{};
  ElementType type{};  ///< type of the surface elements in connectivity
};

struct Elastic {
  double young = 0, poisson = 0;
  bool operator==(const Elastic&) const = default;
};

struct BodyMesh {
  /// Surface with outward normals by the right-hand rule, and all nodes of the body. update_boundary makes it where the
  /// body is a volume.
  SurfaceMesh surface;
  VolumeElements volume;             ///< elements; empty: the body is given by its surface
  std::vector<FaceNaming> naming;    ///< tags given to a volume's faces
  std::vector<BoundaryFace> origin;  ///< face of the volume that each surface element is
  bool boundary_current = false;

  // A section's plane elements and supports stand in surface and held, too, until they are swept.
  SectionPath path;
  SweptSection section;                  ///< section that sweeping took; swept() is false before
  std::vector<std::uint8_t> given_held;  ///< supports of its plane nodes
  std::vector<Vec3> given_value;

  std::shared_ptr<const CondensedMatrix> matrix;  ///< matrix of a body whose stiffness or flexibility is given

  std::string passed_over;        ///< parts of the mesh's file that were not read
  std::vector<double> thickness;  ///< thickness behind each surface element, from thinness(), which explains 0

  std::vector<std::uint8_t> held;     ///< bits by node: bit c is set when displacement component c is given
  std::vector<Vec3> held_value;       ///< given displacement by node, in the body's axes
  std::vector<FaceLoad> load;         ///< loads, one per tag at most
  std::vector<BodyForce> body_force;  ///< loads of volume elements, one per tag at most
  std::vector<Spring> spring;         ///< elastic supports, one per tag at most
  /// Tags of faces that may come into contact; empty: all faces that are neither held nor loaded nor on springs.
  std::vector<std::int32_t> contact_tag;

  /// Tells whether displacements are given that are not zero.
  bool moved() const;
  /// Tells whether the body has loads or given displacements of its own.
  /// Tells whether faces with a tag are loaded or stand on springs.
  bool taken(std::int32_t tag) const;
  bool loaded() const { return !load.empty() || !body_force.empty() || moved(); }
};

struct BodyOptions {
  double accuracy = 1e-6;          ///< "accuracy": relative error of the boundary integrals
  double edge_angle = 40;          ///< "edge_angle", degrees: beyond it an edge separates faces
  std::int64_t keep_factors = 1;   ///< "keep_factors": 0 frees the factors once a frame has its compliance
  std::int64_t between_nodes = 0;  ///< "between_nodes": 0 with half-space, 1 shape functions
  std::int64_t hex8 = 0;           ///< "hex8": 0 enhanced, 1 B-bar
  std::int64_t prepare = 1;        ///< "prepare": 0 checks only, 1 factorises what is known to be needed
  std::int64_t factor = 0;         ///< "factor": 0 by size, 1 dense, 2 hierarchical
  double factor_accuracy = 1e-5;   ///< "factor_accuracy": relative accuracy of hierarchical factors
  std::int64_t factor_ranks = 0;   ///< "factor_ranks": 1 shares the factorisation among the ranks of the context
  std::int64_t stations = 0;       ///< "stations": nodes of a section's surface all along its way; 0: by the section's
  std::int64_t sector = 360;       ///< "sector", degrees: part of a section's way that pictures show
  std::int64_t smooth_slices = 0;  ///< "smooth_slices": 0 splines through the slices of a profile, 1 near to them
  std::int64_t filter_order = 3;   ///< "filter_order": 2 or 3, see ProfileFit, and the next four
  std::int64_t points_alike = 0;   ///< "points_alike"
  double kink_angle = 30;          ///< "kink_angle", degrees
  double kink_beside = 1.0 / 3;    ///< "kink_beside"
  double zigzag_angle = 90;        ///< "zigzag_angle", degrees
  std::int64_t cache_bytes = std::int64_t{1} << 28U;  ///< "cache_bytes": most bytes of responses kept
};

/// Gives the tag to the surface elements all of whose nodes are named.
void tag_by_nodes(const FaceNaming& naming, SurfaceMesh& surface);

/// Makes the surface of a body with volume elements, and its tags; does nothing when it is current or there are no such
/// elements. Throws err_mesh naming the element and face, or the surface element, that is no boundary face; the mesh
/// is then unchanged.
void update_boundary(BodyMesh& mesh);

/// Puts the surface that a section sweeps in place of its plane elements, from the edges that may come into contact;
/// does nothing when that is done. stations: see BodyOptions. err_mesh, err_state.
void sweep_section(BodyMesh& mesh, std::int64_t stations);
/// Returns the mesh as it was given, before it was swept.
BodyMesh unswept(const BodyMesh& mesh);

/// Returns "element 12 (counting from 1)", or "face 2 of element 12 (both counting from 1)".
std::string face_name(const BodyMesh& mesh, std::int64_t element);

/// Returns for each element the components, bit c, that all of its nodes hold.
std::vector<std::uint8_t> held_elements(const BodyMesh& mesh);

/// Adds the nodal forces of tractions and pressures on faces, over a reference modulus, to force[3 * node + c].
void add_face_loads(const BodyMesh& mesh, double reference, std::vector<double>& force);

/// Returns the elements that may come into contact, ascending.
std::vector<std::int64_t> contact_elements(const BodyMesh& mesh);
/// Returns those of them whose corners look the way of a normal: walls of the body beside it are left out.
std::vector<std::int64_t> contact_elements_facing(const BodyMesh& mesh, const Vec3& normal);

/// Returns the given faces' nodes, ascending.
std::vector<std::int32_t> nodes_of(const SurfaceMesh& surface, const std::vector<std::int64_t>& element);

/// Returns the given faces' nodes and those of all surface elements, or of the ones named, that touch them, ascending.
std::vector<std::int32_t> nodes_around(const SurfaceMesh& surface, const std::vector<std::int64_t>& element);
std::vector<std::int32_t> nodes_around(const SurfaceMesh& surface, const std::vector<std::int64_t>& element,
                                       const std::vector<std::int64_t>& among);

}  // namespace rollcon
