#pragma once
/// Declares the inner loop of the integrals over strips: fourth antiderivatives (twice along x, twice along y) of the
/// half-space's kernels, summed over the three feet of each strip's hat. It is compiled for each instruction set.
///
/// With d = (x, y) from source to observer, r = |d|, X = asinh(x/|y|), Y = asinh(y/|x|), L = ln r, A = atan(y/x), B =
/// atan(x/y):
///   1/r:     x^2 y Y/2 + x y^2 X/2 - r^3/6
///   x^2/r^3: r^3/6 + y^2 (x X - r)/2,  y^2/r^3: that of 1/r less this
///   xy/r^3:  -(x y r/3 + x^3 Y/6 + y^3 X/6)
///   x/r^2:   -x^3 L/6 + x y^2 L/2 + x^2 y A/2 + y^3 B/6,  y/r^2: with x and y exchanged

#include "support/instruction_set.hpp"

namespace rollcon::strips {

/// Takes one observer before all places of sources: values[k][n] = sum over feet f of weight[f][n] F_k(x - place[n],
/// y - foot[f][n]). Rates follow each value: such sums of dF/dx, of dF/dy, and of dF/dy with `turn` for weight.
struct KernelJob {
  double x, y;          ///< observer
  int count;            ///< count of places
  const double* place;  ///< places along x
  const double *foot[3], *weight[3], *turn[3];
  double cn, cv, ck;  ///< compliances of the bodies (docs/theory.md, section 3)
  double* values;
};

/// Computes the displacements of a job in this order, each of `count` numbers (with rates: four times as many):
///   normal: gap by pressure; with coupling also by traction along x and along y
///   slip: K11, K12, K22 of tractions; with coupling also along x and along y by pressure
struct StripKernels {
  void (*normal[2][2])(const KernelJob&);  ///< loops by [coupling][rates]
  void (*slip[2][2])(const KernelJob&);
};

const StripKernels& strip_kernels(InstructionSet set = instruction_set());

}  // namespace rollcon::strips
