#pragma once
/// Solves a pin in a hole of a plate, equal materials, without friction: Persson 1964; Ciavarella and Decuzzi, Int. J.
/// Solids Struct. 38 (2001) 4507-4523.

#include <cmath>
#include <numbers>

namespace rollcon {

/// Relates pressure times radius over load per length, and clearance E / (1 - nu^2) over that load.
struct Persson {
  double b;  ///< tangent of half the angle of contact
  explicit Persson(double angle) : b(std::tan(angle / 2)) {}
  double clearance() const {
    const double bb = b * b;
    return (2 * (1 - bb) - std::log(1 + bb) / (1 + bb)) / (std::numbers::pi * bb);
  }
  double pressure(double angle) const {
    const double t = std::tan(angle / 2), c = std::sqrt(1 + b * b);
    if (!(std::abs(t) < b)) return 0;
    const double s = std::sqrt(b * b - t * t);
    return 2 * s / (std::numbers::pi * c * (1 + t * t)) +
           std::log((c + s) / (c - s)) / (2 * std::numbers::pi * c * c * b * b);
  }
};

}  // namespace rollcon
