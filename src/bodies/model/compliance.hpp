#pragma once
/// Defines the one seam between bodies and contact: from nodal tractions on the contact frame to surface displacements
/// of a body (or of a pair of bodies).

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bodies/model/expanded_compliance.hpp"
#include "bodies/model/surface_state.hpp"

namespace rollcon {

class Condensed;
struct Frame;
class TranslationKernel;
struct NearHalfspaces;  // bodies/halfspace/near_halfspaces.hpp

/// Names points of the contact surface by their coordinates in the plane of the frame's axes (t1, t2): on a curved
/// frame, the points of the surface above them. x.size() == y.size().
struct Points {
  std::span<const double> x, y;
  std::size_t size() const { return x.size(); }
};

/// Points to where dense rows go. a[i][j] (null: not wanted) holds the displacement component i at point p per unit
/// traction component j of node k, at a[i][j][p * stride + k]. Components are 0 = t1, 1 = t2, 2 = n in the frame's
/// axes, or on a curved frame in the local ones at point and node.
struct ComplianceBlock {
  double* a[3][3] = {};
  std::ptrdiff_t stride = 0;
};

/// Holds memory, zero at first, for the blocks that `wanted` asks for, with `columns` nodes.
class BlockBuffer {
 public:
  BlockBuffer(const ComplianceBlock& wanted, std::size_t points, std::int64_t columns) {
    block_.stride = static_cast<std::ptrdiff_t>(columns);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (wanted.a[i][j]) {
          memory_[i][j].assign(points * static_cast<std::size_t>(columns), 0.0);
          block_.a[i][j] = memory_[i][j].data();
        }
  }
  const ComplianceBlock& block() const { return block_; }
  const double* row(std::size_t i, std::size_t j, std::size_t point) const {
    return block_.a[i][j] + static_cast<std::ptrdiff_t>(point) * block_.stride;
  }

 private:
  std::vector<double> memory_[3][3];
  ComplianceBlock block_;
};

/// Describes the mesh of a body under a frame.
struct MeshOnFrame {
  const Condensed* response = nullptr;  ///< null: the body has no mesh
  double under_faces = 0;   ///< thickness over length of faces (square root of the area), mean by area; at most 10
  double glued = INFINITY;  ///< least thickness where the other side is held
  double spacing = 0;       ///< distance between nodes of faces, mean by number of faces
  /// Least half widths of contacts whose pressures, and whose creepages, the volume elements show.
  double pressed = INFINITY, rolled = INFINITY;
  bool between_nodes = false;  ///< true: displacements between nodes are a half-space's
};

class Compliance {
 public:
  virtual ~Compliance() = default;

  /// Returns how many nodes carry tractions (all nodes of the frame).
  virtual std::int64_t nodes() const = 0;
  /// Returns false where normal tractions cause no tangential displacement, nor the reverse: blocks [n][t] and [t][n]
  /// are zero and need not be asked for.
  virtual bool couples() const = 0;
  /// Writes every wanted entry of the dense rows of A at any points of the surface.
  virtual void block(Points points, const ComplianceBlock& out) const = 0;
  /// Computes u = A t at any points without forming A: traction[3*k+j], displacement[3*p+i].
  virtual void apply(Points points, const double* traction, double* displacement) const = 0;
  /// Returns the displacement u[3*p+i] without any traction on the frame, which loads and given displacements of the
  /// bodies elsewhere cause. False: it is zero everywhere, and u is not written.
  virtual bool offset(Points /*points*/, double* /*u*/) const { return false; }
  /// Returns what a body with a mesh does, in its axes, under tractions of the frame on its surface, without loads of
  /// its own. False: the body has no mesh, and nothing is written.
  virtual bool everywhere(const double* /*traction*/, SurfaceState& /*state*/) const { return false; }
  /// Returns false when the frame has more nodes than the displacements of this body can tell apart: alone it makes
  /// singular equations.
  virtual bool resolves_frame() const { return true; }
  /// Gives the same displacements with the unknowns of the bodies written out (adds to `out`, whose matrices belong to
  /// the same points). Condenses and factorises nothing. False: has no such form.
  virtual bool expand(Points /*points*/, ExpandedCompliance& /*out*/) const { return false; }
  /// Returns the kernel of displacements that depend on the offset alone, under the frame's own shape functions; null:
  /// they depend on the place.
  virtual std::shared_ptr<const TranslationKernel> translation() const { return nullptr; }
  /// Adds half-spaces that give most of the displacements of points, and what is left of them. False: has no such form.
  virtual bool near_halfspaces(Points /*points*/, NearHalfspaces& /*out*/) const { return false; }
  /// Returns the compliance of the same bodies under some elements of the frame, a frame in the same axes, which must
  /// outlive it; null: not known. It uses one thread.
  virtual std::unique_ptr<Compliance> on_part(const Frame& /*part*/) const { return nullptr; }
  /// Follows nodes of the frame that have moved in its plane. False: the compliance has to be made again.
  virtual bool follow_frame() { return false; }
  /// Fills the entries of bodies that have a mesh.
  virtual void find_meshes(std::array<MeshOnFrame, 2>& /*found*/) const {}
  /// Returns one line for the plan: the model, and how the frame lies on it.
  virtual std::string description() const { return {}; }
  /// Sets how many threads block and apply may use.
  virtual void set_threads(int threads) = 0;
  /// Counts kernel evaluations (point times quadrature point) since construction, for statistics.
  virtual std::int64_t kernel_evaluations() const = 0;
  virtual std::size_t bytes() const = 0;
};

}  // namespace rollcon
