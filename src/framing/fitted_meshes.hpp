#pragma once
/// Makes meshes of frames that are laid on a contact before its pressures are known (docs/theory.md, section 4).

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "contact/scene/scene.hpp"
#include "framing/contact_edge.hpp"
#include "framing/makers.hpp"
#include "framing/outline.hpp"

namespace rollcon {

/// Tells what frames are made for.
struct FrameShape {
  /// Factor on outlines, which are too short by up to 3 parts in a thousand. Strips that are 2 % too short cost 1.5 %
  /// of the force; strips that are 2 % too long cost up to 0.2 %.
  static constexpr double usual_stretch = 1.004;

  /// Hertz's ellipse, a stretched disc.
  FramePlace place;
  double load = 0;  ///< Hertz's load
  /// Outlines, one for each patch; empty: the ellipse alone.
  std::vector<Outline> outline;
  /// Factor by which strips are longer than the outlines or the ellipse.
  double stretch = 1;
  AtBodyEnds at_body_ends = AtBodyEnds::closer;
  /// True: one regular lattice lies over all outlines, because strips do not follow their shapes.
  bool lattice = false;
  /// True: pressures of half-spaces cause slip that strips resolve slowly, so that there are lattices.
  bool unlike = false;
  bool conformal = false;  ///< frames follow the bodies' surfaces
  /// True: a half-space or rigid body ends at the contact, where pressures have no bound; lattices are finer across.
  bool sharp = false;
  Rectangle box{};  ///< around all of the contact, a little wider

  std::vector<Rectangle> boxes() const;  ///< around the patches
  /// Sets box.
  void find_box();
};

/// Makes strips over each outline, cut where a body ends. gap: infinite where one of the bodies is not.
SurfaceMesh strips_over(const FrameShape& shape, const GapBetween& gap, const Axes& axes, std::int64_t along,
                        std::int64_t across);
/// Makes a lattice over all outlines, with the given numbers of intervals over the smallest one. One more interval lies
/// on every side, unless a body ends before. Conformal frames have one for each group of outlines beside each other.
SurfaceMesh lattice_over(const FrameShape& shape, const GapBetween& gap, const Axes& axes, std::int64_t along,
                         std::int64_t across);
/// Returns the last place from `inside` to `outside` that has a gap; none if all places have one or `inside` has none.
std::optional<double> end_of_body(const std::function<double(double)>& gap, double inside, double outside);

}  // namespace rollcon
