#pragma once
/// Tells which kernels the BLAS in use chose for this processor, and whether they are known to be slow.

#include <cstdint>
#include <string>

namespace rollcon {

/// Holds what OpenBLAS says of itself; all are empty with another BLAS.
struct BlasKernels {
  std::string core;    ///< "Haswell", "Cooperlake", ...
  std::string config;  ///< "OpenBLAS 0.3.21 DYNAMIC_ARCH ..."
};
BlasKernels blas_kernels();

/// Returns what to tell the user about factorising a dense matrix with that many unknowns; empty: nothing.
std::string slow_factorization(const BlasKernels& kernels, std::int64_t unknowns);

}  // namespace rollcon
