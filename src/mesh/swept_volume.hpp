#pragma once
/// Makes volume elements of a part of the body that a section sweeps, for pictures.

#include "mesh/swept_section.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

struct SweptVolume {
  SurfaceMesh surface;  ///< nodes alone
  VolumeElements volume;
};

/// Sweeps the section over an angle, at most 2 pi, whose middle is `middle`. Elements are as long there as faces of the
/// surface, and longer with the distance.
SweptVolume sweep_volume(const SweptSection& section, double middle, double sector);

}  // namespace rollcon
