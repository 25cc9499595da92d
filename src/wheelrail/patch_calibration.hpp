#pragma once
/// Calibrates the ellipse that stands for a patch, so that a creep-force table has the patch's own linear theory
/// (docs/wheelrail.md, Forces from a table).

#include <array>

#include "contact/results/equivalent_ellipse.hpp"
#include "tables/creep_map.hpp"
#include "tables/force_table.hpp"

namespace rollcon {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Says how the creepages of an ellipse follow from those of its patch. x is along the rolling direction and y across
/// the rail to the right, both from the patch's reference. Creepages are those at the middle of both surfaces there,
/// brought to the ellipse's centre; height is the turning about y over the speed.
struct PatchCalibration {
  Matrix3 stretch{};                ///< creepages of linear theory by those of the patch
  std::array<double, 3> lifted{};   ///< and by height
  std::array<double, 3> sliding{};  ///< creepages of sliding by height
  Matrix3 linear{};                 ///< the ellipse's forces by creepages, over G a b, lengths over sqrt(a b)
  std::array<double, 2> centre{};   ///< centre of pressure
  double a = 0, b = 0;              ///< semi-axes over those of the Hertzian patch
  double load = 0, pressure = 0;    ///< load and largest pressure over those of the Hertzian patch
  double filled = 0;                ///< share of the ellipse of its pressures' moments that the patch fills
  double spin = 0, height = 0;      ///< motions of natural rolling, without translation
  /// What is missing there, under friction of 0.3, about the centre over the load: forces along x and y and moment, and
  /// their derivatives by both creepages and spin.
  std::array<double, 3> missing{};
  Matrix3 missing_by{};
};
constexpr double calibration_friction = 0.3;
static_assert(sizeof(PatchCalibration) == sizeof(CreepMap::Numbers));

/// Holds motions over the speed and the forces that they cause.
struct CalibratedForces {
  std::array<double, 3> force{};    ///< along x and y, and moment about the centre
  std::array<double, 3> sliding{};  ///< creepages of sliding at the centre
};

/// Looks forces up for creepages at the patch's middle; e: all of the ellipse but its creepages. Throws what
/// ForceTable::evaluate() does.
CalibratedForces calibrated_forces(const PatchCalibration& c, const ForceTable& table, EquivalentEllipse e,
                                   const std::array<double, 3>& creepage, double height);

}  // namespace rollcon
