#pragma once
/// A part of a plane, its sides along the axes there.

namespace rollcon {

struct Rectangle {
  double x_least, x_greatest, y_least, y_greatest;
  bool operator==(const Rectangle&) const = default;
};

}  // namespace rollcon
