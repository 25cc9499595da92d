#pragma once
/// Divides a frame into squares, each of them into four where it holds many nodes, and says which pairs of squares are
/// far from each other and which are near.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec2.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

struct SquareCell {
  int level = 0;              ///< the width is that of the root over 2^level
  std::int64_t i = 0, j = 0;  ///< place among the squares of its level
  std::array<std::int32_t, 4> child{-1, -1, -1, -1};
  std::vector<std::int32_t> node, element;  ///< nodes within, and elements whose middle is; leaves alone
  std::vector<std::int32_t> near;           ///< leaves with elements that are near, itself among them; leaves alone
  bool leaf() const { return child[0] < 0; }
};

/// Names the place of an observing square relative to a source square: how much finer it is by level, and the distance
/// of their centres in half widths of the finer one.
struct CellShift {
  int finer = 0;
  std::int64_t di = 0, dj = 0;
  auto operator<=>(const CellShift&) const = default;
};

/// Names two squares that are far from each other, and their shift by number.
struct FarCells {
  std::int32_t shift = 0, target = 0, source = 0;
};

class SquareCells {
 public:
  /// Nodes and elements reach beyond their square by at most this part of its width.
  static constexpr double overhang = 0.15;

  /// Takes a plane frame; reach: how far from each node its equations look at displacements.
  SquareCells(const Frame& frame, std::span<const double> reach);

  const std::vector<SquareCell>& cells() const { return cell_; }  ///< parents before their children
  const std::vector<CellShift>& shifts() const { return shift_; }
  const std::vector<FarCells>& far() const { return far_; }  ///< in ascending order of shifts
  double width(const SquareCell& c) const;
  Vec2 centre(const SquareCell& c) const;

 private:
  void divide(std::int32_t at);
  void meet(std::int32_t target, std::int32_t source);
  bool apart(const SquareCell& a, const SquareCell& b, CellShift& shift) const;

  struct Extent {
    double x, y, reach;
  };
  std::vector<Extent> node_, element_;
  Vec2 origin_{};
  double width_ = 1;
  std::vector<SquareCell> cell_;
  std::vector<CellShift> shift_;
  std::vector<FarCells> far_;
};

}  // namespace rollcon
