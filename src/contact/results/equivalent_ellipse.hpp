#pragma once
/// Finds the Hertzian contact that stands for a contact patch of another shape, for creep-force tables and simplified
/// theories (docs/tables.md).

#include <array>
#include <span>

namespace rollcon {

struct Solution;

class Body;

/// Holds what two bodies have in common with two equal ones.
struct CommonElasticity {
  double shear = 0, poisson = 0;
  /// Difference of (1 - 2 nu) / (2 G), by which pressure strains body 1 more along the surface.
  double strained = 0;
};
CommonElasticity common_elasticity(const Body& body1, const Body& body2);

/// Returns the longitudinal creepage that this strain amounts to under the pressure of Hertz, on average.
double strain_creepage(double strained, double load, double a, double b);

struct EquivalentEllipse {
  double shear = 0, poisson = 0;  ///< constants of two equal bodies
  double strained = 0;            ///< CommonElasticity::strained
  double friction = 0;            ///< coefficient at the speed of the rigid slip, mean over the pressure
  double a = 0, b = 0;            ///< semi-axes along and across the rolling direction
  double load = 0;
  double filled = 1;  ///< share of the ellipse of its pressures' moments that the contact fills
  /// Longitudinal, lateral, spin, at the centre; without strain_creepage(), which stands for `strained` on average.
  std::array<double, 3> creepage{};
  std::array<double, 2> centre{};  ///< centre in the axes of the contact
};

/// Holds a place with its load, the place where slip is taken for it, the rigid slip there and the friction.
struct LoadedPlace {
  double load = 0, x = 0, y = 0;
  double slip_x = 0, slip_y = 0, slip1 = 0, slip2 = 0;
  double friction = 0;
};

/// Fits the ellipse to pressures over an area. err_state: nothing carries load, or pressures lie on patches apart.
EquivalentEllipse equivalent_ellipse(std::span<const LoadedPlace> place, double area, const CommonElasticity& common);

/// Fits the ellipse to the last solution, which needs no friction. err_state: nothing carries load, pressures lie on
/// patches apart from each other, or bodies are shifted without rolling; err_unsupported: a body has a mesh, or
/// friction is not the same in all directions.
EquivalentEllipse equivalent_ellipse(const Solution& state, double area);

}  // namespace rollcon
