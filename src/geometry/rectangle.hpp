#pragma once
/// Represents a part of a plane with its sides along the axes there.

namespace rollcon {

struct Rectangle {
  double x_least, x_greatest, y_least, y_greatest;
  bool operator==(const Rectangle&) const = default;
};

}  // namespace rollcon
