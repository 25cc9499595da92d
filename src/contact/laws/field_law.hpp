#pragma once
/// Defines friction that follows the whole solution, not the node alone: its temperature, the slip upstream. A solve
/// has its coefficients given, as Coulomb's law has, and is repeated until they are those of what it finds.

#include <span>

#include "mesh/stream_lines.hpp"

namespace rollcon {

/// Holds fields at the nodes of a solution.
struct FrictionField {
  const StreamLines& lines;
  std::span<const double> mu;  ///< coefficients that the law reaches at most
  std::span<const double> slip_speed;
  std::span<const double> pressure;
  std::span<const double> temperature;  ///< temperatures of both surfaces, two a node; empty where no law wants them
  double speed = 0;                     ///< speed of the material against x
};

class FieldLaw {
 public:
  virtual ~FieldLaw() = default;
  /// Finds the coefficient of each node over what its law reaches at most: 0 to 1.
  virtual void ratios(const FrictionField& field, std::span<double> ratio) const = 0;
  virtual bool wants_temperature() const { return false; }
};

}  // namespace rollcon
