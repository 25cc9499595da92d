#pragma once
/// Makes frames of triangles in rings graded to the edge of an elliptic contact.

#include "support/frames.hpp"

namespace rollcon::scenes {

/// Makes n rings inside the contact; the frame reaches 15 % beyond it.
inline SurfaceMesh graded_disc(double a, double b, int n, ElementType type = ElementType::tri3) {
  const auto radii = frames::contact_radii(1, n, 1.15);
  const auto counts = frames::ring_counts(radii);
  return frames::stretch(frames::ring_disc(type, radii, counts), a, b);
}

}  // namespace rollcon::scenes
