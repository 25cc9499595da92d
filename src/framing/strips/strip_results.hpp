#pragma once
/// Reads results off a solution on strips.

#include "framing/strips/strip_contact.hpp"

namespace rollcon::strips {

struct PressurePeak {
  double pressure = 0;
  Vec2 at{};
};

/// Returns the largest pressure, as the top of a curve between the nodes. Displacements fix the mean of a pressure
/// beside a node, so that nodes of a curve that bends are above it: by the mean of what its chords cut off, which is
/// taken away. The square of the pressure is taken for a parabola along each row and across rows: exact for an ellipse.
PressurePeak largest_pressure(const StripState& state);
double area(const StripState& state);  ///< area in contact
/// Returns what the tangential force and its moment about the origin lack because tractions are linear between nodes:
/// friction opposes slip, whose direction is far from linear beside a pole of sliding. Slip is taken for linear.
std::array<double, 3> lacking_at_poles(const StripState& solution);

/// Measures how far a solution is from contacts that strips do not fit; all measures are continuous.
struct StripTrust {
  /// Least pressure between two peaks of a row or of rows over the lower peak (both over those of an ellipse): 1
  /// without a valley, 0 where a part is about to split.
  double joined = 1;
  /// Least distance of two parts over the smaller half width; a large number for one part.
  double apart = 1e9;
  /// Depth to which the outline is hollow over the longest half chord.
  double hollow = 0;
  /// Outlines as hollow as that are not trusted; waists are less so until they part.
  static constexpr double most_hollow = 0.7;
  /// Returns the weight of the strips beside their neighbours (strip_bridge.hpp): 1 where no neck is near, 0 before
  /// strips fail.
  double share() const;
};
StripTrust trust(const StripState& state);

}  // namespace rollcon::strips
