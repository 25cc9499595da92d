#pragma once
/// Computes what stiffness and stresses of one element both need: gradients of its functions and its dilatations.

#include <span>

#include "bodies/fem/element_stiffness_table.hpp"

namespace rollcon::fem {

constexpr int max_columns = 3 * max_functions;

/// Holds columns of gradients: the derivative to x_a of function i stands at a * functions + i.
struct Gradients {
  int columns = 0;
  double volume[max_points];  ///< weight times det J
  double at[max_points][max_columns];
};

/// Holds strains in units of a power of two near the element's size: lengths are over 2^exponent.
struct ElementStrain {
  const ElementTable* table = nullptr;
  int exponent = 0;
  Gradients g;
  /// Integrals of the dilatation's functions f_m times the gradient, and the lower triangle that the table's
  /// modes are to be solved with to give f_m at a point.
  double dilatation[max_modes][max_columns];
  double triangle[max_modes][max_modes];
};

void find_strain(VolumeType type, std::span<const Vec3> x, Hex8 hex8, ElementStrain& out);

/// Holds moduli over Young's, in a unit of length that is the element's.
struct Moduli {
  double shear = 0, bulk = 0;
  double varying = 0;  ///< replaces bulk for the part of the dilatation that varies
};
Moduli moduli_of(const ElementStrain& strain, double poisson, double unit);

/// Computes the stiffness of nodes and incompatible modes, (3 functions) squared, nodes first; E = 1.
void extended_stiffness(const ElementStrain& strain, double poisson, double* k);

/// Eliminates the unknowns from `keep` on, the last first. Row e keeps what it was when e was eliminated.
void condense(double* k, int size, int keep);

}  // namespace rollcon::fem
