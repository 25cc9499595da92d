#pragma once
/// Finds displacements that particles had a step before, by rows of the compliance at points upstream of the nodes. The
/// rows stay while steps go the same distance.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "contact/operators/dense_operators.hpp"

namespace rollcon {

struct Prepared;

class CarriedRows {
 public:
  /// Finds carried[c], c = t1, t2, at all used nodes, under tractions on the frame of `on`, whose material travels its
  /// distance. Another version of the operators, or another distance, makes the rows again.
  void apply(const Prepared& on, std::int64_t version, const std::vector<double> (&lambda)[3],
             std::vector<double> (&carried)[3]);
  std::size_t bytes() const;
  std::int64_t made() const { return made_; }

 private:
  void make(const Prepared& on);
  void make_dense(const Prepared& on);

  std::int64_t version_ = -1, made_ = 0;
  double distance_ = 0;
  bool differences_ = false;  ///< rows give what displacements lose upstream, over the distance
  std::shared_ptr<DenseOperators> dense_;
  std::shared_ptr<const Operators> rows_;  ///< null: none are made
  std::vector<std::int32_t> node_;         ///< used nodes
  std::vector<double> lost_[3];            ///< workspace
};

/// Returns where a node's particle was a step before, along t1 in the projection.
double upstream(const Prepared& on, std::size_t node);

}  // namespace rollcon
