#include "contact/convection/convection.hpp"

#include "contact/convection_frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace convection_test;

/// Returns 1 for nodes whose path upstream enters one of their cells; 0 where it leaves the frame.
std::vector<char> path_enters(const Frame& frame, const LinearCells& cells, Direction e) {
  std::vector<char> enters(frame.x.size(), 0);
  auto side = [&](std::int32_t from, std::int32_t to) {
    const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
    return (frame.x[j] - frame.x[i]) * e.ey - (frame.y[j] - frame.y[i]) * e.ex;
  };
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    for (std::size_t k = 0; k < n.size(); ++k)
      if (side(n[k], n[(k + 1) % n.size()]) > 0 && side(n[k], n[(k + n.size() - 1) % n.size()]) < 0)
        enters[static_cast<std::size_t>(n[k])] = 1;
  }
  return enters;
}

TEST(Convection, LeastSquaresIsExactForLinearFields) {
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type)) {
      const LinearCells cells = split_elements(f.frame.mesh);
      double worst = 0;
      int leaving = 0, inexact = 0;
      for (double degrees : directions) {
        const Direction e(degrees);
        const SparseRows d = least_squares(f.frame, e.ex, e.ey);
        const auto enters = path_enters(f.frame, cells, e);
        for (std::size_t i = 0; i < f.frame.x.size(); ++i) {
          double scale;
          const double exact = -(2 * e.ex - 50 * e.ey);
          const double error = apply(
                                   f.frame, d, i, [](double x, double y) { return 3 + 2 * x - 50 * y; }, &scale) -
                               exact;
          const double relative = std::abs(error) / std::max(scale, std::abs(exact));
          if (!f.frame.rim[i] || enters[i])
            worst = std::max(worst, relative);
          else if (!empty_row(d, i))
            ++leaving, inexact += relative > 1e-9;
        }
      }
      expect_error("least squares, linear field, " + f.name, worst, 1e-10);
      std::printf("  path leaves the frame: %d rows, %d without a stencil for both directions\n", leaving, inexact);
    }
}

TEST(Convection, GodunovIsExactAlongTheLinesOfUniformSquares) {
  const auto u = frames::uniform_lines(-1, 1, 10);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, u, u), Axes{});
  for (double degrees : {0.0, 90.0, 180.0, 270.0}) {
    const Direction e(degrees);
    const SparseRows d = godunov(frame, e.ex, e.ey);
    double error = 0;
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
      // The leading rim has no inflow; the trailing rim has half a cell for a whole face.
      const double s = frame.x[i] * e.ex + frame.y[i] * e.ey;
      if (std::abs(s) > 0.99) continue;
      const double exact = -(2 * e.ex - 5 * e.ey);
      error = std::max(error, std::abs(apply(frame, d, i, [](double x, double y) { return 2 * x - 5 * y; }) - exact));
    }
    expect_error("Godunov, linear field along lines, degrees " + std::to_string(degrees), error, 1e-12);
  }
}

TEST(Convection, RigidTranslationGivesNothing) {
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type)) {
      double error = 0;
      for (double degrees : directions) {
        const Direction e(degrees);
        for (const SparseRows& d : {godunov(f.frame, e.ex, e.ey), least_squares(f.frame, e.ex, e.ey)})
          for (std::size_t i = 0; i < f.frame.x.size(); ++i) {
            double sum = 0, size = 1e-300;
            for (auto k = static_cast<std::size_t>(d.start[i]); k < static_cast<std::size_t>(d.start[i + 1]); ++k)
              sum += d.value[k], size += std::abs(d.value[k]);
            error = std::max(error, std::abs(sum) / size);
          }
      }
      expect_error("row sums, both schemes, " + f.name, error, 1e-14);
    }
}

TEST(Convection, GodunovTakesFromUpstreamOnly) {
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type))
      for (double degrees : directions) {
        const Direction e(degrees);
        const SparseRows d = godunov(f.frame, e.ex, e.ey);
        for (std::size_t i = 0; i < f.frame.x.size(); ++i)
          for (auto k = static_cast<std::size_t>(d.start[i]); k < static_cast<std::size_t>(d.start[i + 1]); ++k) {
            if (static_cast<std::size_t>(d.column[k]) == i)
              ASSERT_GT(d.value[k], 0) << f.name;
            else
              ASSERT_LT(d.value[k], 0) << f.name;
          }
      }
}

TEST(Convection, LeastSquaresHasNoColumnDownstream) {
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type)) {
      // A row on slender cells may take a neighbour of the cell through which the path enters although the half plane
      // of upwind neighbours misses it; it interpolates, and never extrapolates.
      int rows = 0, entries = 0;
      for (double degrees : directions) {
        const Direction e(degrees);
        const SparseRows d = least_squares(f.frame, e.ex, e.ey);
        for (std::size_t i = 0; i < f.frame.x.size(); ++i) {
          rows += !empty_row(d, i);
          for (auto k = static_cast<std::size_t>(d.start[i]); k < static_cast<std::size_t>(d.start[i + 1]); ++k) {
            const auto j = static_cast<std::size_t>(d.column[k]);
            const double dx = f.frame.x[j] - f.frame.x[i], dy = f.frame.y[j] - f.frame.y[i];
            if (j == i || dx * e.ex + dy * e.ey >= -1e-9 * std::hypot(dx, dy)) continue;
            ++entries;
            ASSERT_TRUE(f.frame.rim[i] || d.value[k] < 0) << f.name;
            ASSERT_TRUE(d.fallback[i]) << f.name;
          }
        }
      }
      std::printf("%-66s rows %d, entries downstream %d\n", f.name.c_str(), rows, entries);
      if (f.name.find("1:100") == std::string::npos) {
        EXPECT_LE(entries, rows / 10) << f.name;
      }
    }
}

TEST(Convection, RowsAreEmptyOnlyWithoutUpstreamNeighbour) {
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type)) {
      const Neighbours near = neighbours(f.frame.nodes(), split_elements(f.frame.mesh), false);
      for (double degrees : directions) {
        const Direction e(degrees);
        const SparseRows d = least_squares(f.frame, e.ex, e.ey);
        for (std::size_t i = 0; i < f.frame.x.size(); ++i) {
          bool upstream = false;
          for (std::int32_t node : near[static_cast<std::int64_t>(i)]) {
            const auto j = static_cast<std::size_t>(node);
            const double dx = f.frame.x[j] - f.frame.x[i], dy = f.frame.y[j] - f.frame.y[i];
            upstream = upstream || dx * e.ex + dy * e.ey > 1e-9 * std::hypot(dx, dy);
          }
          ASSERT_EQ(empty_row(d, i), !upstream) << f.name;
        }
      }
    }
}

TEST(Convection, TurnedFramesHaveTheSameOperator) {
  const double turn = 0.6180339887;
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type)) {
      if (f.frame.nodes() > 700) continue;  // dense comparison
      const Frame turned = build_frame(frames::rotate(f.frame.mesh, turn), Axes{});
      double error = 0;
      for (double degrees : {0.0, 30.0, 45.0, 133.0, 180.0}) {
        const Direction e(degrees);
        const double fx = std::cos(turn) * e.ex - std::sin(turn) * e.ey;
        const double fy = std::sin(turn) * e.ex + std::cos(turn) * e.ey;
        error = std::max(
            {error, row_difference(dense(godunov(f.frame, e.ex, e.ey)), dense(godunov(turned, fx, fy)), 1),
             row_difference(dense(least_squares(f.frame, e.ex, e.ey)), dense(least_squares(turned, fx, fy)), 1)});
      }
      expect_error("turned frame, " + f.name, error, 1e-8);
    }
}

TEST(Convection, ScalesLikeOneOverLength) {
  for (ElementType type : all_types)
    for (const NamedFrame& f : frames_of(type)) {
      const Frame small = build_frame(frames::stretch(f.frame.mesh, 1e-6, 1e-6), Axes{});
      const Direction e(30);
      expect_error("Godunov at 1e-6 of the size, " + f.name,
                   row_difference(dense(godunov(f.frame, e.ex, e.ey)), dense(godunov(small, e.ex, e.ey)), 1e6), 1e-10);
      expect_error(
          "least squares at 1e-6 of the size, " + f.name,
          row_difference(dense(least_squares(f.frame, e.ex, e.ey)), dense(least_squares(small, e.ex, e.ey)), 1e6),
          1e-10);
    }
}

TEST(Convection, MirroredNodesHaveMirroredRows) {
  const auto u = frames::uniform_lines(-1, 1, 6);
  for (ElementType type : {ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    const Frame frame = build_frame(frames::rectangle(type, u, u), Axes{});
    const std::size_t n = frame.x.size();
    std::vector<std::size_t> image(n, n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (std::hypot(frame.x[i] - frame.x[j], frame.y[i] + frame.y[j]) < 1e-12) image[i] = j;
    for (bool flux : {false, true}) {
      const auto up = dense(flux ? godunov(frame, 0.8, 0.6) : least_squares(frame, 0.8, 0.6));
      const auto down = dense(flux ? godunov(frame, 0.8, -0.6) : least_squares(frame, 0.8, -0.6));
      std::vector<double> mirrored(n * n);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) mirrored[i * n + j] = down[image[i] * n + image[j]];
      expect_error(
          std::string(flux ? "Godunov" : "least squares") + " mirrored, type " + std::to_string(static_cast<int>(type)),
          row_difference(up, mirrored, 1), 1e-12);
    }
  }
}

TEST(Convection, ChangesContinuouslyAcrossATie) {
  // Flow along lines of nodes has neighbours exactly across it; a turn by 1e-6 must change little.
  const auto u = frames::uniform_lines(-1, 1, 6);
  for (ElementType type : all_types) {
    const Frame frame = build_frame(frames::rectangle(type, u, u), Axes{});
    const auto at = dense(least_squares(frame, 1, 0));
    for (double turn : {1e-6, -1e-6}) {
      const auto off = dense(least_squares(frame, std::cos(turn), std::sin(turn)));
      // Rows at the leading rim appear when an upwind neighbour does, so inner nodes are compared.
      const std::size_t n = frame.x.size();
      double worst = 0;
      for (std::size_t i = 0; i < n; ++i) {
        if (frame.rim[i]) continue;
        for (std::size_t j = 0; j < n; ++j)
          worst = std::max(worst, std::abs(at[i * n + j] - off[i * n + j]) / at[i * n + i]);
      }
      expect_error("turn by 1e-6, type " + std::to_string(static_cast<int>(type)), worst, 1e-4);
    }
  }
}

}  // namespace
}  // namespace rollcon
