#pragma once
/// Declares the classes behind meshed_compliance.hpp: meshed_compliance.cpp condenses, meshed_expansion.cpp writes
/// unknowns out, meshed_between.cpp gives displacements between nodes.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bodies/meshed_compliance.hpp"
#include "bodies/meshed_zone.hpp"
#include "bodies/model/surface_response.hpp"

namespace rollcon {

/// Interpolates displacements between the body's nodes by the shape functions of its faces.
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
  enum Place { at_nodes, inside, beyond };  ///< where a point is in the zone
  /// Holds the points of one place, and their numbers among all that were asked for.
  struct Group {
    Place place = at_nodes;
    std::vector<double> x, y;
    std::vector<std::size_t> point;
    std::vector<Interpolation> where;
  };
  /// Returns what moves points besides what is interpolated; null: nothing does.
  virtual const Compliance* local(Place /*place*/) const { return nullptr; }
  /// Returns the rows of the zone that are interpolated at points of a place.
  virtual const RowMatrix<double>& smooth(Place /*place*/) const { return response_; }
  /// Tells whether nodes of the body that are nodes of the frame move as the response says.
  virtual bool nodes_move_alone() const { return true; }
  /// Adds what local() does at points, less what smooth() leaves out of the response, to their rows.
  virtual void add_local(const Group& /*group*/, std::size_t /*points*/, ExpandedCompliance& /*out*/) const {}

  const SurfaceOutline& outline() const;
  std::vector<Group> groups(Points points) const;

  MeshedZone zone_;
  int threads_;
  mutable RowMatrix<double> response_;  ///< (3 rows) x (3 frame nodes), local components; made on first use

 private:
  /// Makes what block and apply need of the body, which factorises and condenses for it.
  void require_response() const;
  const SurfaceLoads* require_loads() const;
  SparseMatrix local_loads() const;
  SparseMatrix local_displacements(const std::vector<Group>& groups, std::size_t points) const;
  /// Adds tractions in the body's axes, by column of the loads, to a state of boundary elements.
  void add_tractions(const std::vector<Vec3>& on_body, SurfaceState& state) const;

  mutable std::unique_ptr<const SurfaceOutline> outline_;  ///< null until the response is made
  mutable std::shared_ptr<const SurfaceLoads> loads_;      ///< null until unknowns are written out
};

/// Gives displacements between the body's nodes and beyond the zone as those of a half-space with the body's constants,
/// plus the interpolated difference, which is smooth. Under the load of a single node finite elements move by what the
/// mesh does not resolve: their difference is not smooth, and within the zone the half-space takes the remainder of the
/// tractions instead.
class BetweenNodes final : public ByShapeFunctions {
 public:
  BetweenNodes(MeshedZone zone, double accuracy, int threads);

  void find_meshes(std::array<MeshOnFrame, 2>& found) const override;
  bool resolves_frame() const override { return true; }
  bool near_halfspaces(Points points, NearHalfspaces& out) const override;
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
  // These members are made when points between nodes are first asked for.
  mutable std::unique_ptr<Compliance> halfspace_, remainder_;
  mutable RowMatrix<double> correction_;         ///< response less the half-space's rows
  mutable RowMatrix<double> halfspace_on_zone_;  ///< half-space's rows alone
};

}  // namespace rollcon
