/// Tests every way in which a frame can be wrong, with the words that the caller reads.

#include "mesh/frame.hpp"
#include "mesh/refusals.hpp"
#include "support/frames.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

void expect_refused(const SurfaceMesh& mesh, const std::string& words, Status status = Status::err_mesh,
                    const Axes& axes = {}) {
  expect_error_text([&] { build_frame(mesh, axes); }, words, status);
}

SurfaceMesh grid(ElementType type, int n = 3) {
  const auto u = frames::uniform_lines(0, n, n);
  return frames::rectangle(type, u, u);
}

void repeat_element(SurfaceMesh& mesh, std::int64_t e) {
  const std::vector<std::int32_t> copy(mesh.element(e).begin(), mesh.element(e).end());
  surfaces::add_element(mesh, mesh.type[surfaces::at(e)], copy);
}

struct WrongFrame {
  SurfaceMesh mesh;
  void (*spoil)(SurfaceMesh&);
  const char* words;
};

TEST(FrameErrors, AreNamed) {
  using M = SurfaceMesh;
  SurfaceMesh of_none, four;
  of_none.offset = {0};
  four.node = {{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {0.8, 1, 0}};
  const SurfaceMesh quads = grid(ElementType::quad4), one = grid(ElementType::quad4, 1);
  for (const WrongFrame& wrong : std::vector<WrongFrame>{
           {of_none,
            [](M& m) {
              m.node = {{0, 0, 0}};
            },
            "no elements"},
           {quads, [](M& m) { m.connectivity[5] = 99; }, "first: element 2 (quad4), node 100 of 1..16"},
           {quads, [](M& m) { m.connectivity[6] = m.connectivity[5]; },
            "repeated within an element; 1 such in the frame; first: element 2 (quad4), node 3"},
           {grid(ElementType::tri6), [](M& m) { repeat_element(m, 3); },
            "same element is given twice; 1 such in the frame; first: elements 4 and 19"},
           {one,
            [](M& m) {
              m.node.insert(m.node.end(), {{0.5, 3, 0}, {0.5, 4, 0}});
              for (const std::int32_t third : {4, 5}) surfaces::add_element(m, ElementType::tri3, {2, 3, third});
            },
            "more than two elements share an edge; 1 such in the frame; first: edge 3-4"},
           {four,
            [](M& m) {
              for (const std::int32_t third : {2, 3}) surfaces::add_element(m, ElementType::tri3, {0, 1, third});
            },
            "same side of their common edge"},
           // Element 2 gets its own node on the edge it shares with element 1.
           {grid(ElementType::quad8, 2),
            [](M& m) {
              ASSERT_EQ(m.element(1)[7], m.element(0)[5]);
              m.node.push_back(m.node[surfaces::at(m.element(0)[5])]);
              m.connectivity[15] = static_cast<std::int32_t>(m.node.size()) - 1;
            },
            "share an edge but not its midside node; 1 such"},
           {grid(ElementType::tri3), [](M& m) { m.node[5] = m.node[6]; }, "two of its nodes coincide"},
           {grid(ElementType::tri3, 1),
            [](M& m) {
              m.node = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
            },
            "its Jacobian vanishes"},
           {one,
            [](M& m) {
              m.node[3] = {0.3, 0.3, 0};
            },
            "its Jacobian changes sign; 1 such in the frame; first: element 1 (quad4)"},
           // All sides are straight and sound; only the centre of the quad9 is pushed against one of them.
           {grid(ElementType::quad9, 1),
            [](M& m) {
              m.node[8] = {0.5, 0.98, 0};
            },
            "its Jacobian changes sign"},
           {quads, [](M& m) { std::swap(m.connectivity[9], m.connectivity[11]); },
            "element that looks away from the normal n (flipped: clockwise seen from its tip): reverse the order of "
            "its "
            "nodes, or leave the faces of a far side out; 1 such in the frame; first: element 3"},
       }) {
    SurfaceMesh mesh = wrong.mesh;
    wrong.spoil(mesh);
    mesh.index_base = 1;
    expect_refused(mesh, wrong.words);
  }
}

TEST(FrameErrors, QuadraticElementNearFolding) {
  // A midside node on an edge of length 1 folds the element when it moves to a quarter; just before, the element is
  // sound.
  for (ElementType type : {ElementType::tri6, ElementType::quad8, ElementType::quad9}) {
    for (double at : {0.27, 0.24}) {
      SurfaceMesh mesh = grid(type, 1);
      const auto n = mesh.element(0);
      const auto corners = static_cast<std::size_t>(corner_count(type));
      const Vec3 a = mesh.node[static_cast<std::size_t>(n[0])];
      const Vec3 b = mesh.node[static_cast<std::size_t>(n[1])];
      mesh.node[static_cast<std::size_t>(n[corners])] = {a[0] + at * (b[0] - a[0]), a[1] + at * (b[1] - a[1]), 0};
      if (at > 0.25)
        EXPECT_NO_THROW(build_frame(mesh, Axes{}));
      else
        expect_refused(mesh, "its Jacobian changes sign");
    }
  }
}

TEST(FrameErrors, AllElementsFlipped) {
  Axes down;
  down.t2 = {0, -1, 0};
  down.n = {0, 0, -1};
  expect_refused(grid(ElementType::tri6), "all elements look away from the normal n", Status::err_mesh, down);
}

TEST(FrameErrors, SteepElement) {
  auto tilted = [](double degrees) {
    const double slope = std::tan(degrees * 3.14159265358979 / 180);
    return frames::transform(grid(ElementType::quad4), [=](const Vec3& p) { return Vec3{p[0], p[1], slope * p[0]}; });
  };
  EXPECT_NO_THROW(build_frame(tilted(59), Axes{}));
  expect_refused(tilted(61), "steeper than 60 degrees");
  expect_refused(frames::transform(grid(ElementType::quad4),
                                   [](const Vec3& p) {
                                     return Vec3{p[0], 0, p[1]};
                                   }),
                 "steeper than 60 degrees");
}

TEST(FrameErrors, OfARingIsCalledThat) {
  expect_refused(frames::transform(grid(ElementType::quad4, 16),
                                   [](const Vec3& p) {
                                     const double turn = 2 * 3.14159265358979 / 16 * p[0];
                                     return Vec3{std::sin(turn), p[1], std::cos(turn)};
                                   }),
                 "closed about an axis");
}

TEST(FrameErrors, SheetsOverOneAnother) {
  SurfaceMesh mesh = grid(ElementType::quad4);
  const SurfaceMesh upper = mesh;
  for (Vec3 p : upper.node) mesh.node.push_back({p[0], p[1], p[2] + 1});
  for (std::int64_t e = 0; e < 9; ++e) {
    repeat_element(mesh, e);
    for (std::size_t i = 0; i < 4; ++i) mesh.connectivity[36 + 4 * surfaces::at(e) + i] += 16;
  }
  expect_refused(mesh, "folds over itself");
}

TEST(FrameErrors, SpiralThatReturnsOverItself) {
  // A strip of squares is wound by more than a turn, and locally sound everywhere.
  const int n = 40;
  SurfaceMesh mesh = frames::transform(
      frames::rectangle(ElementType::quad4, frames::uniform_lines(0, 7, n), frames::uniform_lines(1, 2, 2)),
      [](const Vec3& p) {
        return Vec3{p[1] * std::sin(p[0]), -p[1] * std::cos(p[0]), 0.1 * p[0]};
      });
  for (std::size_t i = 0; i < mesh.connectivity.size(); i += 4)
    std::swap(mesh.connectivity[i + 1], mesh.connectivity[i + 3]);
  expect_refused(mesh, "folds over itself");
}

TEST(FrameErrors, NotFinite) {
  SurfaceMesh mesh = grid(ElementType::quad4);
  mesh.node[7][1] = std::numeric_limits<double>::quiet_NaN();
  mesh.index_base = 1;
  expect_refused(mesh, "coordinate y of node 8 (counting from 1)", Status::err_nonfinite);
}

TEST(FrameErrors, ExtremeSize) {
  expect_refused(frames::stretch(grid(ElementType::quad4), 1e80, 1e80), "allowed");
  expect_refused(frames::stretch(grid(ElementType::quad4), 1e-80, 1e-80), "allowed");
}

TEST(FrameErrors, AxesNotOrthonormal) {
  Axes axes;
  axes.t2 = {0.1, 1, 0};
  expect_refused(grid(ElementType::quad4), "not orthonormal", Status::err_argument, axes);
}

}  // namespace
}  // namespace rollcon
