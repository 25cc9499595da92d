#pragma once
/// Computes an independent reference for the half-space integrals over one element: adaptive nested Gauss rules, with
/// the reference domain cut into triangles at the observer's own point when it lies on the element. It has nothing in
/// common with the library but the numbering of the nodes.

#include <array>
#include <optional>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon::brute_force {

struct Element {
  ElementType type;
  std::vector<double> x, y;
};

/// Returns a frame that is this one element.
Frame frame_of(const Element& element);

struct Reference {
  double xi, eta;
};

/// Returns the position of a reference point.
std::array<double, 2> position(const Element& element, Reference at);

/// Holds at value[k][i] the integrals of N_i times 1/r, dx^2/r^3, dx dy/r^3, dx/r^2, dy/r^2, d = observer - source.
/// `on` is the observer's reference point if it is on the element (the observer is then its exact image, px and py
/// being that image rounded).
using Integrals = std::array<std::array<double, max_element_nodes>, 5>;
Integrals integrate(const Element& element, double px, double py, std::optional<Reference> on = {});

/// Has the library compute these integrals.
Integrals from_library(const Element& element, double px, double py, double tolerance);

/// Returns the largest difference over the largest entry.
double relative_error(const Integrals& value, const Integrals& reference);

}  // namespace rollcon::brute_force
