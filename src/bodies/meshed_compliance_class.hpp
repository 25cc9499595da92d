#pragma once
/// See meshed_compliance.hpp; condensed in meshed_compliance.cpp, between nodes in meshed_between.cpp, written out in
/// meshed_expansion.cpp.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bodies/frame_on_body.hpp"
#include "bodies/meshed_compliance.hpp"
#include "bodies/model/surface_response.hpp"
#include "geometry/surface_search.hpp"
#include "mesh/shape.hpp"

namespace rollcon {

class MeshedCompliance final : public Compliance {
 public:
  MeshedCompliance(const Frame& frame, const PairOfBodies& pair, int which, double accuracy, int threads);

  std::int64_t nodes() const override { return frame_.nodes(); }
  bool couples() const override { return true; }
  void block(Points points, const ComplianceBlock& out) const override;
  void apply(Points points, const double* traction, double* displacement) const override;
  bool offset(Points points, double* u) const override;
  bool everywhere(const double* traction, SurfaceState& state) const override;
  bool expand(Points points, ExpandedCompliance& out) const override;
  void find_meshes(std::array<MeshOnFrame, 2>& found) const override;
  std::string description() const override;
  bool resolves_frame() const override;
  void set_threads(int threads) override {
    threads_ = threads;
    for (Compliance* part : {halfspace_.get(), remainder_.get()})
      if (part) part->set_threads(threads);
  }
  std::int64_t kernel_evaluations() const override {
    return (halfspace_ ? halfspace_->kernel_evaluations() : 0) + (remainder_ ? remainder_->kernel_evaluations() : 0);
  }
  std::size_t bytes() const override {
    return response_.bytes() + correction_.bytes() + halfspace_on_zone_.bytes() + (loads_ ? loads_->load.bytes() : 0);
  }

 private:
  /// Zone rows and weights that interpolate to a point of the surface.
  struct Interpolation {
    bool beyond = false;  ///< the point is over no element of the zone
    std::vector<std::int64_t> row;
    std::vector<double> weight;

    std::size_t size() const { return row.size(); }
    void add(std::int64_t to, double value) { row.push_back(to), weight.push_back(value); }
  };
  Interpolation locate(double x, double y) const;
  void bend(double x, double y, Interpolation& where) const;
  void find_curvatures(std::span<const std::int64_t> elements);
  /// Row of the frame node that stands exactly here and is a node of the body; -1: none.
  std::int64_t row_of_node(double x, double y) const;
  /// What block and apply need of the body; it factorises and condenses for it.
  void require_response() const;
  const SurfaceOutline& outline() const;
  /// The outline's column of each node of the frame; -1: none.
  std::vector<std::int64_t> columns(const SurfaceOutline& outline) const;
  /// The frame's own at its nodes: at a ridge the field knows only one of the faces that meet there.
  Triad triad(double x, double y) const {
    const auto found = node_at_.find({x, y});
    return found == node_at_.end() ? local_triad(frame_.axes, normals_.at(x, y))
                                   : frame_.triad(static_cast<std::size_t>(found->second));
  }
  /// Directions of the local components there, in the body's axes.
  using LocalAxes = std::array<Vec3, 3>;
  LocalAxes local_axes(double x, double y) const {
    const Triad t = triad(x, y);
    return {pose_.turn_back(t.t1), pose_.turn_back(t.t2), pose_.turn_back(t.n)};
  }

  const Frame& frame_;
  const Body& body_;
  PairOfBodies pair_;
  Pose pose_;
  int which_;
  double accuracy_;
  int threads_;
  NormalField normals_;
  FrameOnBody on_body_;
  std::vector<double> zone_x_, zone_y_;  ///< of the response's rows, in the axes
  std::vector<std::int64_t> row_of_body_node_;
  std::map<std::pair<double, double>, std::int64_t> node_at_;  ///< frame nodes that are used
  std::unique_ptr<SurfaceSearch> zone_;
  /// Second derivatives xx, xy, yy of a field at a zone row, by the rows around it.
  struct Curvature {
    std::vector<std::int64_t> row;
    std::vector<std::array<double, 3>> weight;
  };
  std::vector<Curvature> curvature_;  ///< of each zone row, where displacements are to bend between linear faces' nodes
  MeshOnFrame under_;                 ///< the zone
  // Made when first asked for: condensed, written out, and at points between nodes.
  mutable std::unique_ptr<const SurfaceOutline> outline_;
  mutable RowMatrix<double> response_;  ///< (3 rows) x (3 frame nodes), local components
  mutable std::shared_ptr<const SurfaceLoads> loads_;
  mutable std::unique_ptr<Compliance> halfspace_, remainder_;
  mutable RowMatrix<double> correction_;         ///< response less the half-space's
  mutable RowMatrix<double> halfspace_on_zone_;  ///< that part alone

  /// Displacements between nodes: a local part, which needs no unknowns, and one interpolated on the zone: of the
  /// response or, when the local part corrects, of its difference from that part.
  struct Local {
    const Compliance* compliance = nullptr;
    bool corrects = false;
  };
  Local local_part(bool beyond) const;
  struct Between {
    const Compliance* local;
    const RowMatrix<double>* smooth;
  };
  Between between(bool beyond) const;
  void require_halfspace_on_zone() const;
  SparseMatrix local_loads() const;
  /// Adds tractions in the body's axes, by column of the loads, to a state of boundary elements.
  void add_tractions(const std::vector<Vec3>& on_body, SurfaceState& state) const;
  SparseMatrix local_displacements(Points points) const;
  /// As asked for; and on a boundary-element body's own faces where it is thin: a half-space between their nodes would
  /// be far softer than the body.
  bool by_shape_functions() const {
    return body_.options().between_nodes == 1 ||
           (body_.traits().smooth_difference && on_body_.of_faces() && under_.under_faces < least_depth);
  }
  static constexpr double least_depth = 2.6;  ///< no ratio of usual meshes: rounding decides there
  /// Points that are not nodes of the body: those of the zone, and those beyond it.
  struct Others {
    std::vector<double> x, y;
    std::vector<std::size_t> point;  ///< of those asked for
    std::vector<Interpolation> where;
  };
  std::array<Others, 2> others(Points points) const;
  void subtract_interpolated(const Others& group, RowMatrix<double>& direct) const;
};

}  // namespace rollcon
