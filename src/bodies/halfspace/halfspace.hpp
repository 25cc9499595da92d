#pragma once
/// Makes the compliance of half-spaces on a contact frame: Boussinesq and Cerruti's surface solutions, with tractions
/// interpolated by the frame's own shape functions. One or both bodies are elastic; a pair of half-spaces is one
/// compliance with summed constants.
///
/// With d = x - y from source to observer, r = |d|, and tractions on body 1 in (t1, t2, n):
///   u_n = integral of  cn/r tn - ck (d . tt)/r^2
///   u_t = integral of  cn/r tt + cv d (d . tt)/r^3 + ck d/r^2 tn
/// with cn_a = (1-nu)/(2 pi G), cv_a = nu/(2 pi G), ck_a = +-(1-2nu)/(4 pi G) of each body a (+ for body 1, - for body
/// 2, whose outward normal is -n and whose traction is -t; a rigid body adds nothing). cn, cv, ck are the sums, so that
/// A t is u1 - u2.

#include <memory>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

struct HalfspaceConstants {
  double cn = 0;  ///< factor of 1/r, normal and tangential
  double cv = 0;  ///< factor of d d^T / r^3
  double ck = 0;  ///< factor of normal-tangential coupling, signed
};

/// Describes a delayed part of a displacement in steady rolling: ratio times the mean of the displacements that the
/// material has had, of weight exp(-s / length) / length at the distance s upstream, towards +t1.
struct Lag {
  double ratio = 0, length = 0;
  bool slope = false;  ///< the mean is that of the displacement's slope along t1
};

/// Holds the lags of a body and what its own constants are.
struct LaggingBody {
  HalfspaceConstants c;
  std::vector<Lag> lag;
};

/// Returns the constants of one body. sign = +1 for body 1, -1 for body 2.
HalfspaceConstants halfspace_constants(double young, double poisson, int sign);

/// Takes a frame, which must outlive the compliance. tolerance: error of each integral relative to the largest entry of
/// its row; threads: most threads of block and apply.
std::unique_ptr<Compliance> make_halfspace_compliance(const Frame& frame, HalfspaceConstants c, double tolerance,
                                                      int threads);
/// Makes the compliance of half-spaces that creep in steady rolling: that of the constants c, and the lags of bodies,
/// of which there may be none. Other frames than lattices along t1 take integrals along lines.
std::unique_ptr<Compliance> make_lagging_compliance(const Frame& frame, HalfspaceConstants c,
                                                    std::vector<LaggingBody> bodies, double tolerance, int threads);

}  // namespace rollcon
