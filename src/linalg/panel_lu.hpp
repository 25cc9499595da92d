#pragma once
/// Computes LU factors with partial pivoting by parts, and checks between them whether the caller still wants it.

namespace rollcon {

/// Does what LAPACK's getrf does with an n by n column-major matrix: leaves the factors in place, and the row that each
/// step took (from 1) in pivot. Returns getrf's info. Throws Cancelled; the matrix is then neither itself nor its
/// factors.
int factor_by_panels(int n, double* a, int* pivot);

}  // namespace rollcon
