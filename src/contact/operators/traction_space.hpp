#pragma once
/// Describes tractions that depend on fewer numbers than the nodes of a frame, as the unknowns of another discrete
/// problem of the same contact (contact/estimate/error_estimate.hpp).

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "contact/convection/convection.hpp"
#include "contact/operators/dense_operators.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

struct TractionSpace {
  Frame frame;                     ///< nodes of this frame carry the unknowns; in loaded_space() it has no elements
  std::vector<std::int32_t> node;  ///< fine frame's node for each of them
  SparseRows fine;                 ///< tractions at the fine frame's nodes from the unknowns
};

/// Makes linear triangles on about a quarter of the nodes (mesh/coarsen.hpp); tractions in between are interpolated in
/// the projection, by components in the local triads. err_mesh: the coarse triangles do not make a valid frame.
TractionSpace coarse_space(const Frame& fine);
/// Takes all nodes of the frame.
TractionSpace whole_space(const Frame& fine);
/// Takes the nodes with pressure; all others are unloaded.
TractionSpace loaded_space(const Frame& fine, const std::vector<double>& normal);

/// Returns displacements of tractions in the space: same bodies, same integrals. Both must outlive it.
std::unique_ptr<Compliance> compliance_of(const Compliance& fine, const TractionSpace& space);
/// Makes normal rows from those of the fine frame, without any integral.
void take_normal_rows(const Operators& fine, const TractionSpace& space, DenseOperators& op);

/// Turns sums over the fine frame's nodes (weights) into sums over the space's.
std::vector<double> gather(const TractionSpace& space, const std::vector<double>& fine);
/// Picks values at the space's nodes.
std::vector<double> pick(const TractionSpace& space, const std::vector<double>& fine);
/// Returns tractions at the fine frame's nodes.
std::vector<double> spread(const TractionSpace& space, const std::vector<double>& unknowns);

}  // namespace rollcon
