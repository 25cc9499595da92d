#include "bodies/halfspace/interior_kernels.hpp"

namespace rollcon::halfspace {

extern const InteriorKernels interior_kernels_baseline, interior_kernels_avx2, interior_kernels_avx512;

const InteriorKernels& interior_kernels(InstructionSet set) {
  return chosen(set, interior_kernels_baseline, interior_kernels_avx2, interior_kernels_avx512);
}

void pad_points(NearPoints& points) {
  for (int q = points.n; q % point_padding != 0; ++q) {
    points.xi[q] = points.xi[points.n - 1];
    points.eta[q] = points.eta[points.n - 1];
    points.w[q] = 0;
  }
}

}  // namespace rollcon::halfspace
