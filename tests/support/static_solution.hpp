#pragma once
/// Solves a body under loads and given displacements, without contact: set up from a mesh in a few lines, of boundary
/// elements or of finite ones, solved, and asked for displacements and tractions.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bodies/body.hpp"
#include "mesh/surface_mesh.hpp"
#include "support/any_element.hpp"

namespace rollcon::statics {

/// Holds a symmetric 3 x 3 tensor, for example the stress of a uniform strain field.
using Tensor = std::array<Vec3, 3>;
inline Vec3 times(const Tensor& a, const Vec3& x) {
  return {dot(a[0], x), dot(a[1], x), dot(a[2], x)};
}
/// Applies Hooke's law, for nu < 0.5.
Tensor strain_of(const Tensor& stress, double young, double poisson);

class StaticBody {
 public:
  StaticBody(SurfaceMesh mesh, double young, double poisson, double accuracy = 1e-6);
  StaticBody(const volumes::Mesh& mesh, double young, double poisson);
  StaticBody(const surfaces::Block& shape, AnyElement type, double young, double poisson, double accuracy = 1e-6);

  /// Returns the surface; with finite elements the boundary, and all nodes.
  const SurfaceMesh& mesh() const { return mesh_; }
  Body& body() { return *body_; }

  /// Holds components by bits 1 x, 2 y, 4 z at zero, or at value(x).
  StaticBody& hold(std::span<const std::int32_t> nodes, std::int32_t dof_mask = 7,
                   const std::function<Vec3(const Vec3&)>& value = {});
  StaticBody& hold_tags(std::initializer_list<std::int32_t> tags, std::int32_t dof_mask = 7,
                        const std::function<Vec3(const Vec3&)>& value = {});
  /// Holds six components at three nodes that are no neighbours, which take no load when the load is balanced.
  StaticBody& hold_statically(const std::function<Vec3(const Vec3&)>& value = {});
  StaticBody& traction(std::int32_t tag, const Vec3& t);
  StaticBody& pressure(std::int32_t tag, double p);
  /// Throws rollcon::Error.
  StaticBody& solve();

  Vec3 displacement(std::int32_t node) const;
  Vec3 displacement(const Vec3& near) const;  ///< displacement of the nearest node
  /// What the supports exert, about the origin.
  Resultant reaction() const { return body_->own().reaction; }
  /// Returns what a traction node has (boundary elements).
  Vec3 traction_at(std::int64_t fan) const;
  /// Returns the sum over all elements of integral t, and of x cross t about the origin (boundary elements).
  Resultant resultant(std::initializer_list<std::int32_t> tags) const;

  /// Returns the largest difference from a field over all nodes, over the field's largest length.
  double displacement_error(const std::function<Vec3(const Vec3&)>& exact) const;
  /// Returns the largest difference of tractions from sigma(x) n, over all traction nodes of faces with flat normals
  /// (boundary elements).
  double traction_error(const std::function<Tensor(const Vec3&)>& stress) const;

 private:
  StaticBody(BodyKind kind, double young, double poisson, const std::vector<Vec3>& node);

  SurfaceMesh mesh_;
  std::shared_ptr<Context> context_;
  std::unique_ptr<Body> body_;
};

/// Holds displacements of nodes of the body, u[3 r + c], under tractions given at the nodes of its faces.
struct Loaded {
  std::vector<std::int32_t> node;  ///< ascending
  std::vector<Vec3> u;
  Vec3 at(std::int32_t node_of_body) const;
};
Loaded load_faces(Body& body, std::span<const std::int64_t> faces, const std::function<Vec3(const Vec3&)>& traction,
                  int threads = 1);

}  // namespace rollcon::statics
