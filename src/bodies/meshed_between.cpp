/// Gives a meshed body's displacements between its nodes: a local part and an interpolated one.

#include <utility>

#include "bodies/halfspace/near_halfspaces.hpp"
#include "bodies/meshed_compliance_class.hpp"
#include "bodies/remainder_compliance.hpp"
#include "linalg/row_basis.hpp"
#include "support/index.hpp"

namespace rollcon {

BetweenNodes::BetweenNodes(MeshedZone zone, double accuracy, int threads)
    : ByShapeFunctions(std::move(zone), threads), accuracy_(accuracy) {
  if (!zone_.on_body.of_faces() && !zone_.body.traits().smooth_difference) zone_.let_bend();
}

const Compliance* BetweenNodes::local(Place place) const {
  if (place == at_nodes) return nullptr;
  const SurfaceOutline& seen = outline();
  if (!corrects(place)) {
    if (seen.seen.rows() > 0 && !remainder_)
      remainder_ = make_remainder_compliance(zone_.frame, zone_.pair, zone_.which, seen, accuracy_, threads_);
    return remainder_.get();
  }
  if (!halfspace_) {
    const bool known = seen.young > 0;
    halfspace_ =
        make_halfspace_compliance(zone_.frame,
                                  halfspace_constants(known ? seen.young : zone_.body.young(),
                                                      known ? seen.poisson : zone_.body.poisson(), zone_.sign()),
                                  accuracy_, threads_);
  }
  return halfspace_.get();
}

const RowMatrix<double>& BetweenNodes::smooth(Place place) const {
  if (!corrects(place)) return response_;
  if (correction_.empty()) {
    require_halfspace_on_zone();
    correction_.resize(response_.rows(), response_.columns());
    for (std::int64_t r = 0; r < response_.rows(); ++r)
      for (std::int64_t k = 0; k < response_.columns(); ++k)
        correction_.row(r)[k] = response_.row(r)[k] - halfspace_on_zone_.row(r)[k];
    halfspace_on_zone_.release();
  }
  return correction_;
}

void BetweenNodes::require_halfspace_on_zone() const {
  if (!halfspace_on_zone_.empty()) return;
  ExpandedCompliance zone;
  add_direct(*local(beyond), {zone_.x, zone_.y}, zone);
  halfspace_on_zone_ = std::move(zone.direct);
}

void BetweenNodes::add_local(const Group& group, std::size_t points, ExpandedCompliance& out) const {
  const Compliance* part = local(group.place);
  if (!part) return;
  require_direct(static_cast<std::int64_t>(points), nodes(), out);
  add_block(*part, {group.x, group.y}, group.point, out.direct);
  if (!corrects(group.place)) return;
  require_halfspace_on_zone();
  for (std::size_t b = 0; b < group.point.size(); ++b)
    for (std::int64_t i = 0; i < 3; ++i) {
      double* row = out.direct.row(3 * static_cast<std::int64_t>(group.point[b]) + i);
      const Interpolation& where = group.where[b];
      for (std::size_t a = 0; a < where.size(); ++a)
        axpy(-where.weight[a], halfspace_on_zone_.row(3 * where.row[a] + i), row, out.direct.columns());
    }
}

// The body feels what it has seen of the tractions: an orthonormal basis of that serves its response and the remainder.
// The form is of use where few nodes of the body lie under the frame.
bool BetweenNodes::near_halfspaces(Points points, NearHalfspaces& out) const {
  constexpr double rounding = 1e-12;
  constexpr std::int64_t least = 10;  // nodes of the frame for each of these
  if (outline().seen.rows() == 0 || least * outline().seen.rows() > nodes()) return false;
  const std::vector<Group> all = groups(points);
  if (all.size() != 1 || corrects(all[0].place)) return false;
  const RowBasis seen = row_basis(outline().seen, rounding);
  const std::int64_t rank = seen.row.rows();
  NearHalfspaces remainder;
  if (!local(all[0].place)->near_halfspaces(points, remainder)) return false;
  out.constants = {out.constants.cn + remainder.constants.cn, out.constants.cv + remainder.constants.cv,
                   out.constants.ck + remainder.constants.ck};
  NearHalfspaces::Part& part = out.part.emplace_back();
  part.left.resize(3 * std::ssize(points.x), 3 * rank);
  const RowMatrix<double>& felt = remainder.part.at(0).left;
  for (std::int64_t r = 0; r < felt.rows(); ++r)
    for (std::int64_t s = 0; s < felt.columns() / 3; ++s)
      for (std::int64_t k = 0; k < rank; ++k)
        for (std::int64_t j = 0; j < 3; ++j)
          part.left.row(r)[3 * k + j] += seen.weight.row(s)[k] * felt.row(r)[3 * s + j];
  RowMatrix<double> by_basis;
  by_basis.resize(response_.rows(), 3 * rank);
  for (std::int64_t r = 0; r < response_.rows(); ++r)
    for (std::int64_t k = 0; k < rank; ++k)
      for (std::int64_t n = 0; n < nodes(); ++n)
        for (std::int64_t j = 0; j < 3; ++j)
          by_basis.row(r)[3 * k + j] += response_.row(r)[3 * n + j] * seen.row.row(k)[n];
  for (std::size_t b = 0; b < all[0].point.size(); ++b)
    for (std::size_t a = 0; a < all[0].where[b].size(); ++a)
      for (std::int64_t i = 0; i < 3; ++i)
        axpy(all[0].where[b].weight[a], by_basis.row(3 * all[0].where[b].row[a] + i),
             part.left.row(3 * static_cast<std::int64_t>(all[0].point[b]) + i), 3 * rank);
  part.right = seen.row;
  return true;
}

void BetweenNodes::find_meshes(std::array<MeshOnFrame, 2>& found) const {
  ByShapeFunctions::find_meshes(found);
  found[at(zone_.which)].between_nodes = !zone_.on_body.of_faces();
}

void BetweenNodes::set_threads(int threads) {
  ByShapeFunctions::set_threads(threads);
  for (Compliance* part : {halfspace_.get(), remainder_.get()})
    if (part) part->set_threads(threads);
}

std::int64_t BetweenNodes::kernel_evaluations() const {
  return (halfspace_ ? halfspace_->kernel_evaluations() : 0) + (remainder_ ? remainder_->kernel_evaluations() : 0);
}

}  // namespace rollcon
