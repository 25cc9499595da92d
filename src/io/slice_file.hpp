#pragma once
/// Reads lists of slices of rails (.slcs) and wheels (.slcw) that vary: docs/profiles.md.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rollcon {

struct SliceFile {
  struct Slice {
    double u;                     ///< millimetres along a rail, radian round a wheel
    std::string path;             ///< its profile, with the folder of the list
    std::vector<double> feature;  ///< millimetres of arc, < 0: missing; empty: none are given
  };
  std::vector<Slice> slice;
  std::vector<std::array<double, 3>> wave;  ///< amplitude, length (millimetres or radian), phase
  bool round = false;                       ///< places are angles
  bool smooth = false;
};

/// Throws err_io naming the file and the line.
SliceFile read_slice_file(const std::string& path);

}  // namespace rollcon
