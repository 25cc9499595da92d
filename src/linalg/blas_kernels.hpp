#pragma once
/// Which kernels the BLAS in use chose for this processor, and whether they are known to be slow.

#include <cstdint>
#include <string>

namespace rollcon {

/// What OpenBLAS says of itself; empty with another BLAS.
struct BlasKernels {
  std::string core;    ///< "Haswell", "Cooperlake", ...
  std::string config;  ///< "OpenBLAS 0.3.21 DYNAMIC_ARCH ..."
};
BlasKernels blas_kernels();

/// What to tell the user of factorising a dense matrix with that many unknowns; empty: nothing.
std::string slow_factorization(const BlasKernels& kernels, std::int64_t unknowns);

}  // namespace rollcon
