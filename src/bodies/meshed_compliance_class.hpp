#pragma once
/// See meshed_compliance.hpp; condensed in meshed_compliance.cpp, written out in meshed_expansion.cpp, between nodes in
/// meshed_between.cpp.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bodies/meshed_compliance.hpp"
#include "bodies/meshed_zone.hpp"
#include "bodies/model/surface_response.hpp"

namespace rollcon {

/// Displacements between the body's nodes by the shape functions of its faces.
class ByShapeFunctions : public Compliance {
 public:
  ByShapeFunctions(MeshedZone zone, int threads) : zone_(std::move(zone)), threads_(threads) {}

  std::int64_t nodes() const override { return zone_.frame.nodes(); }
  bool couples() const override { return true; }
  void block(Points points, const ComplianceBlock& out) const override;
  void apply(Points points, const double* traction, double* displacement) const override;
  bool offset(Points points, double* u) const override;
  bool everywhere(const double* traction, SurfaceState& state) const override;
  bool expand(Points points, ExpandedCompliance& out) const override;
  void find_meshes(std::array<MeshOnFrame, 2>& found) const override;
  std::string description() const override;
  bool resolves_frame() const override;
  void set_threads(int threads) override { threads_ = threads; }
  std::int64_t kernel_evaluations() const override { return 0; }
  std::size_t bytes() const override { return response_.bytes() + (loads_ ? loads_->load.bytes() : 0); }

 protected:
  enum Place { at_nodes, inside, beyond };  ///< of the zone
  /// Points of one place, and those among all that were asked for.
  struct Group {
    Place place = at_nodes;
    std::vector<double> x, y;
    std::vector<std::size_t> point;
    std::vector<Interpolation> where;
  };
  /// Moves points besides what is interpolated; null: nothing does.
  virtual const Compliance* local(Place /*place*/) const { return nullptr; }
  /// The rows of the zone that are interpolated at points of a place.
  virtual const RowMatrix<double>& smooth(Place /*place*/) const { return response_; }
  /// Nodes of the body that are nodes of the frame move as the response says.
  virtual bool nodes_move_alone() const { return true; }
  /// Adds what local() does at points, less what smooth() leaves out of the response, to their rows.
  virtual void add_local(const Group& /*group*/, std::size_t /*points*/, ExpandedCompliance& /*out*/) const {}

  const SurfaceOutline& outline() const;

  MeshedZone zone_;
  int threads_;
  mutable RowMatrix<double> response_;  ///< (3 rows) x (3 frame nodes), local components; made when first asked for

 private:
  std::vector<Group> groups(Points points) const;
  /// What block and apply need of the body; it factorises and condenses for it.
  void require_response() const;
  const SurfaceLoads* require_loads() const;
  SparseMatrix local_loads() const;
  SparseMatrix local_displacements(const std::vector<Group>& groups, std::size_t points) const;
  /// Adds tractions in the body's axes, by column of the loads, to a state of boundary elements.
  void add_tractions(const std::vector<Vec3>& on_body, SurfaceState& state) const;

  mutable std::unique_ptr<const SurfaceOutline> outline_;  ///< made with the response
  mutable std::shared_ptr<const SurfaceLoads> loads_;      ///< made when written out
};

/// Displacements between the body's nodes and beyond the zone as those of a half-space with the body's constants, and
/// the interpolated difference, which is smooth. Under the load of a single node finite elements move by what the mesh
/// does not resolve: their difference is not smooth, and within the zone the half-space takes the remainder of the
/// tractions instead.
class BetweenNodes final : public ByShapeFunctions {
 public:
  BetweenNodes(MeshedZone zone, double accuracy, int threads);

  void find_meshes(std::array<MeshOnFrame, 2>& found) const override;
  bool resolves_frame() const override { return true; }
  void set_threads(int threads) override;
  std::int64_t kernel_evaluations() const override;
  std::size_t bytes() const override {
    return ByShapeFunctions::bytes() + correction_.bytes() + halfspace_on_zone_.bytes();
  }

 private:
  const Compliance* local(Place place) const override;
  const RowMatrix<double>& smooth(Place place) const override;
  bool nodes_move_alone() const override { return outline().seen.rows() == 0; }
  void add_local(const Group& group, std::size_t points, ExpandedCompliance& out) const override;
  bool corrects(Place place) const {
    return place == beyond || (place == inside && zone_.body.traits().smooth_difference);
  }
  void require_halfspace_on_zone() const;

  double accuracy_;
  // Made when first asked for at points between nodes.
  mutable std::unique_ptr<Compliance> halfspace_, remainder_;
  mutable RowMatrix<double> correction_;         ///< response less the half-space's
  mutable RowMatrix<double> halfspace_on_zone_;  ///< that part alone
};

}  // namespace rollcon
