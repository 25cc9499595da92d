#pragma once
/// Works with dense symmetric matrices of displacement components.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "linalg/dense.hpp"
#include "linalg/sparse_factor.hpp"
#include "mesh/surface_mesh.hpp"

namespace rollcon::condensed {

/// Factorises the rows and columns named; they are rows 3 * node + component. err_argument, which calls the matrix
/// `what`, names the first force that does no work, or work of the wrong sign.
std::unique_ptr<SparseFactor> factor_of(const RowMatrix<double>& matrix, std::span<const std::int64_t> unknown,
                                        const char* what, std::int32_t index_base);
/// Returns the inverse, row by row.
std::vector<double> inverse(SparseFactor& factor);

/// Returns Young's modulus of the half-space that gives way as the body does under opposite forces on the ends of an
/// edge between corners, normal to its face: the median over all edges. 0: no edge gives way.
double local_young(const SurfaceMesh& surface, const RowMatrix<double>& flexibility, double poisson);

}  // namespace rollcon::condensed
