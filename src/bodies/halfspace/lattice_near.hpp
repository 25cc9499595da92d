#pragma once
/// Computes half-space integrals of a lattice's hats near their source, where no rule of a few points does: they are
/// exact to rounding for cells of any shape.
///
/// Along the longer side of a cell the integral is a sum of second antiderivatives H of the kernel at the hat's kinks.
/// Across, each of these is integrated as its distance asks for: by a closed form (antiderivatives in both directions
/// lose digits with the square of the cell's sides' ratio, so it serves kinks near the observer only), by a rule, or by
/// a rule after what is singular in it was taken out.

#include <cstdint>
#include <vector>

#include "bodies/halfspace/hat_rules.hpp"
#include "bodies/halfspace/kernels.hpp"

namespace rollcon::halfspace {

struct OffsetRange {
  std::int64_t first = 0, last = -1;
  std::int64_t size() const { return last - first + 1; }
  bool contains(std::int64_t i) const { return first <= i && i <= last; }
};

/// Size of the ellipse around the hat on which the kernel must be analytic for a rule to be used.
inline constexpr double smallest_ellipse = 5.5;
/// Distance of a singularity, in half-widths along or beside the axis, that leaves this ellipse free.
inline constexpr double clear_along = (smallest_ellipse + 1 / smallest_ellipse) / 2;
inline constexpr double clear_beside = (smallest_ellipse - 1 / smallest_ellipse) / 2;

/// Returns the sum of the semi-axes of the ellipse with foci -1, 1 through the point (along, beside).
double ellipse_size(double along, double beside);
/// Returns the points of a hat's rule for an error 1 / digits where the kernel is analytic on an ellipse of this size.
int hat_points(double size, double digits);
/// Returns the rule for half-width 1; 1 <= n <= max_hat_points.
const LineRule& stored_hat_rule(Hat hat, int n);

/// Fills value[k][(j - y.first) * x.size() + i - x.first] with integral k of kernels.hpp of a source at the origin for
/// the observer at (shift_x + i dx, shift_y + j dy). Integrals that `terms` does not want stay empty.
void near_lattice_integrals(const LatticeHat& hat, double shift_x, double shift_y, int terms, OffsetRange x,
                            OffsetRange y, std::vector<double> (&value)[integral_count]);

}  // namespace rollcon::halfspace
