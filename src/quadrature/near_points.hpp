#pragma once
/// Holds the points that a kernel of the near field takes at a time.

namespace rollcon::quadrature {

inline constexpr int near_capacity = 128;

/// Stores points in reference coordinates, weights without the Jacobian, with room for padding.
struct NearPoints {
  int n = 0;
  alignas(64) double xi[near_capacity], eta[near_capacity], w[near_capacity];
};

}  // namespace rollcon::quadrature
