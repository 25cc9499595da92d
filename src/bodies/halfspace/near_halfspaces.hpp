#pragma once
/// Describes displacements that are nearly those of half-spaces.

#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "linalg/dense.hpp"

namespace rollcon {

struct NearHalfspaces {
  HalfspaceConstants constants;
  /// Adds to component i of point p the sum over k and j of left(3 p + i, 3 k + j) times row k of right on component j
  /// of the nodes' tractions.
  struct Part {
    RowMatrix<double> left, right;
  };
  std::vector<Part> part;
};

}  // namespace rollcon
