#pragma once
/// Measures loads that the reactions of a body's supports miss, and loads that bend the body where its mesh cannot.
/// Only boundary elements can miss loads: nothing in their equations keeps the balance.

namespace rollcon {

struct Imbalances {
  /// Largest parts missed, over all frames, of uniform tractions along the body's axes and of a uniform pressure.
  double along[3] = {0, 0, 0}, pressure = 0;
  /// Part of the work of uniform tractions along each of the body's axes that bends elements too long for its
  /// thickness.
  double bent[3] = {0, 0, 0};
  /// Young's modulus that a given matrix shows between neighbouring nodes; 0: none is given, or it does not tell.
  double local_young = 0;
};

/// Returns zeros where there is no response.
template <class Response>
Imbalances imbalances_of(const Response* response) {
  return response ? response->imbalances() : Imbalances{};
}

}  // namespace rollcon
