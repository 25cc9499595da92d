/// Tests that lines across frames cover the width once, through every kind of element, and meet the nodes on them.

#include "mesh/stream_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/frames.hpp"

namespace rollcon {
namespace {

Frame rectangle(ElementType type, double turn) {
  SurfaceMesh mesh = frames::rectangle(type, frames::uniform_lines(-2, 2, 8), frames::uniform_lines(-1, 1, 5));
  for (Vec3& p : mesh.node)
    p = {std::cos(turn) * p[0] - std::sin(turn) * p[1], std::sin(turn) * p[0] + std::cos(turn) * p[1], 0};
  return build_frame(std::move(mesh), {});
}

// A linear function is exact at the ends of pieces, and pieces follow each other without a gap from the entry to the
// exit of the line.
TEST(stream_lines, cover_the_width_once) {
  for (const ElementType type :
       {ElementType::tri3, ElementType::quad4, ElementType::tri6, ElementType::quad8, ElementType::quad9})
    for (const double turn : {0.0, 0.3}) {
      const Frame frame = rectangle(type, turn);
      const StreamLines lines(frame);
      std::vector<double> f(frame.x.size());
      for (std::size_t k = 0; k < f.size(); ++k) f[k] = 3 * frame.x[k] - frame.y[k] + 1;
      std::vector<LinePiece> pieces;
      double worst = 0, widest = 0;
      for (double y = -0.95; y < 1; y += 0.1) {
        lines.cut(y, pieces);
        ASSERT_FALSE(pieces.empty());
        double width = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
          if (i > 0) worst = std::max(worst, std::abs(pieces[i].upstream.x - pieces[i - 1].downstream.x));
          for (const auto& end : {pieces[i].upstream, pieces[i].downstream})
            worst = std::max(worst, std::abs(end.value(f.data()) - (3 * end.x - y + 1)));
          width += pieces[i].length();
        }
        if (turn == 0) worst = std::max(worst, std::abs(width - 4));
        widest = std::max(widest, width);
      }
      std::printf("element %d, turned by %.1f: off by %.1e (bound 1e-12), widest line %.3f\n", static_cast<int>(type),
                  turn, worst, widest);
      EXPECT_LE(worst, 1e-12);
      EXPECT_GT(widest, 3.9);
    }
}

TEST(stream_lines, have_every_node_once) {
  for (const ElementType type : {ElementType::tri3, ElementType::quad4, ElementType::quad9})
    for (const double turn : {0.0, 0.3}) {
      const Frame frame = rectangle(type, turn);
      const StreamLines lines(frame);
      std::vector<int> met(frame.x.size(), 0);
      std::vector<LinePiece> pieces;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        lines.cut(lines.y(i), pieces);
        for (const std::int32_t k : lines.nodes(i)) {
          ++met[static_cast<std::size_t>(k)];
          // A piece ends there, except at corners of a frame that is turned.
          const bool ends = std::any_of(pieces.begin(), pieces.end(), [&](const LinePiece& piece) {
            return std::abs(piece.upstream.x - lines.x(k)) < 1e-9 || std::abs(piece.downstream.x - lines.x(k)) < 1e-9;
          });
          EXPECT_TRUE(ends || (pieces.empty() && turn != 0)) << k;
        }
      }
      EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(met.size()));
      if (turn == 0) {
        EXPECT_EQ(lines.size(), type == ElementType::quad9 ? 11U : 6U);
      }
    }
}

// Nodes of a line whose y differ by rounding are on it: the pieces are those of the straight frame.
TEST(stream_lines, rounding_decides_nothing) {
  for (const ElementType type : {ElementType::tri3, ElementType::quad4, ElementType::quad9}) {
    const Frame straight = rectangle(type, 0);
    Frame rough = straight;
    for (std::size_t k = 0; k < rough.y.size(); ++k) rough.y[k] += 1e-15 * (static_cast<double>(k * 7 % 5) - 2);
    const StreamLines lines(straight), rough_lines(rough);
    ASSERT_EQ(lines.size(), rough_lines.size());
    std::vector<LinePiece> pieces, rough_pieces;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines.cut(lines.y(i), pieces);
      for (const double y : {rough_lines.y(i), lines.y(i), lines.y(i) + 3e-15}) {
        rough_lines.cut(y, rough_pieces);
        ASSERT_EQ(pieces.size(), rough_pieces.size());
        for (std::size_t k = 0; k < pieces.size(); ++k) {
          EXPECT_NEAR(pieces[k].upstream.x, rough_pieces[k].upstream.x, 1e-9);
          EXPECT_NEAR(pieces[k].downstream.x, rough_pieces[k].downstream.x, 1e-9);
        }
      }
    }
  }
}

TEST(stream_lines, beside_the_frame_there_are_none) {
  const Frame frame = rectangle(ElementType::quad4, 0);
  const StreamLines lines(frame);
  std::vector<LinePiece> pieces;
  for (const double y : {-1.01, 1.01, 5.0}) {
    lines.cut(y, pieces);
    EXPECT_TRUE(pieces.empty());
  }
  for (const double y : {-1.0, 1.0}) {
    lines.cut(y, pieces);
    double width = 0;
    for (const LinePiece& piece : pieces) width += piece.length();
    EXPECT_NEAR(width, 4, 1e-9);
  }
}

}  // namespace
}  // namespace rollcon
