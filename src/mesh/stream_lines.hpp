#pragma once
/// Follows lines along the rolling direction across a frame, on which material travels: what happens to it at one point
/// depends on what happened upstream.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

/// Is the part of a line within one linear triangle. Values vary linearly over it.
struct LinePiece {
  /// Is a point on an edge of the mesh.
  struct End {
    double x = 0;
    std::int32_t node[2] = {0, 0};
    double part = 0;  ///< weight of the second node

    double value(const double* f) const { return (1 - part) * f[node[0]] + part * f[node[1]]; }
  };
  End upstream, downstream;  ///< material enters where x is greater

  double length() const { return upstream.x - downstream.x; }
};

class StreamLines {
 public:
  /// Takes quadratic elements as the linear cells between their nodes, quadrilaterals as two triangles.
  explicit StreamLines(const Frame& frame);

  std::size_t size() const { return start_.size() - 1; }
  double y(std::size_t line) const { return y_[line]; }
  double x(std::int32_t node) const { return frame_.x[static_cast<std::size_t>(node)]; }
  /// Returns the nodes of elements that are on a line, the greatest x first. Every such node is on one line.
  std::span<const std::int32_t> nodes(std::size_t line) const {
    return {node_.data() + start_[line], start_[line + 1] - start_[line]};
  }
  /// Returns the pieces of the line at y, the most upstream first, without overlap; lines beside the frame have none.
  void cut(double y, std::vector<LinePiece>& pieces) const;

 private:
  struct Triangle {
    double low, high;  ///< extent in y
    std::int32_t node[3];
  };
  const Frame& frame_;
  std::vector<double> level_;       ///< y of the nodes, without rounding between those on one line
  std::vector<Triangle> triangle_;  ///< sorted by `low`
  double tallest_ = 0, rounding_ = 0;
  double lowest_ = 0;  ///< y at which a line has triangles below it
  std::vector<double> y_;
  std::vector<std::size_t> start_{0};
  std::vector<std::int32_t> node_;
};

}  // namespace rollcon
