#pragma once
/// What the caller gave for a body with a mesh; ids and numbers checked, shapes not yet.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_boundary.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

struct FaceLoad {
  std::int32_t tag = 0;
  Vec3 traction{0, 0, 0};  ///< in the body's axes
  double pressure = 0;     ///< against the outward normal, added to the traction

  // Tractions by node come besides, linear or quadratic between as the faces are.
  std::vector<std::int32_t> node{};
  std::vector<Vec3> of_node{};
  /// Unless zero these are components along its part in the surface, across (normal x that) and along the outward
  /// normal.
  Vec3 along{0, 0, 0};

  /// of_node of all nodes of the body; empty: none has any.
  std::vector<Vec3> by_node(std::size_t nodes) const;
  /// Turns components into the body's axes, where the unit normal is this one.
  Vec3 turned(const Vec3& components, const Vec3& normal) const;
};

/// A load on the elements of one material, in the body's axes: force + density omega x (x - origin) x omega.
struct BodyForce {
  std::int32_t tag = 0;
  Vec3 force{0, 0, 0};  ///< per volume
  double density = 0;
  Vec3 origin{0, 0, 0}, rate{0, 0, 0};  ///< of the rotation

  Vec3 at(const Vec3& x) const { return force + density * cross(cross(rate, x - origin), rate); }
};

/// One call that gave boundary faces of a volume a tag: by element and side, by the set of nodes that they lie on, or
/// as surface elements. Later calls win.
struct FaceNaming {
  std::int32_t tag = 0;
  std::vector<BoundaryFace> face{};
  std::vector<std::int32_t> nodes{};
  std::vector<std::int32_t> connectivity{};
  ElementType type{};  ///< of the surface elements in connectivity
};

struct Elastic {
  double young = 0, poisson = 0;
  bool operator==(const Elastic&) const = default;
};

struct BodyMesh {
  /// Outward normals by the right-hand rule. Of a volume: its boundary, made by update_boundary; the nodes are all
  /// nodes of the body.
  SurfaceMesh surface;
  VolumeElements volume;             ///< empty: the body is given by its surface
  std::vector<FaceNaming> naming;    ///< of a volume's faces
  std::vector<BoundaryFace> origin;  ///< of each surface element, in the volume
  bool boundary_current = false;
  std::string passed_over;        ///< what was not read of the file that the mesh came from
  std::vector<double> thickness;  ///< behind each surface element, filled by thinness(), which explains 0

  std::vector<std::uint8_t> held;     ///< per node: bit c is set when displacement component c is given
  std::vector<Vec3> held_value;       ///< per node, in the body's axes
  std::vector<FaceLoad> load;         ///< one per tag at most
  std::vector<BodyForce> body_force;  ///< likewise, of volume elements
  /// Tags of faces that may come into contact; empty: all faces that are neither held nor loaded.
  std::vector<std::int32_t> contact_tag;

  /// Displacements are given that are not zero.
  bool moved() const;
  /// The body has loads of its own.
  bool loaded() const { return !load.empty() || !body_force.empty() || moved(); }
};

struct BodyOptions {
  double accuracy = 1e-6;          ///< "accuracy": of the boundary integrals
  double edge_angle = 40;          ///< "edge_angle", degrees: beyond it an edge separates faces
  std::int64_t keep_factors = 1;   ///< "keep_factors": 0 frees the factors once a frame has its compliance
  std::int64_t between_nodes = 0;  ///< "between_nodes": 0 with half-space, 1 shape functions
  std::int64_t hex8 = 0;           ///< "hex8": 0 enhanced, 1 B-bar
  std::int64_t prepare = 1;        ///< "prepare": 0 checks only, 1 factorises what is known to be needed
  std::int64_t cache_bytes = std::int64_t{1} << 28U;  ///< "cache_bytes": of responses kept
};

/// Gives the tag to the surface elements all of whose nodes are named.
void tag_by_nodes(const FaceNaming& naming, SurfaceMesh& surface);

/// Makes the surface of a body with volume elements, and its tags; nothing else to do when it is current or there are
/// none. Throws err_mesh naming the element and face, or the surface element, that is no boundary face; the mesh is
/// then unchanged.
void update_boundary(BodyMesh& mesh);

/// "element 12 (counting from 1)", or "face 2 of element 12 (both counting from 1)".
std::string face_name(const BodyMesh& mesh, std::int64_t element);

/// Held components common to all nodes of each element: bit c.
std::vector<std::uint8_t> held_elements(const BodyMesh& mesh);

/// Elements that may come into contact, ascending.
std::vector<std::int64_t> contact_elements(const BodyMesh& mesh);

/// The given faces' nodes, ascending.
std::vector<std::int32_t> nodes_of(const SurfaceMesh& surface, const std::vector<std::int64_t>& element);

/// The given faces' nodes and those of all surface elements, or of the ones named, that touch them, ascending.
std::vector<std::int32_t> nodes_around(const SurfaceMesh& surface, const std::vector<std::int64_t>& element);
std::vector<std::int32_t> nodes_around(const SurfaceMesh& surface, const std::vector<std::int64_t>& element,
                                       const std::vector<std::int64_t>& among);

}  // namespace rollcon
