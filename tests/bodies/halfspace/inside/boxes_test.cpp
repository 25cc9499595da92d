// Compares boxes of elements seen from afar: their error with its bound, and many points with few.

#include "bodies/halfspace/far_field.hpp"
#include "bodies/halfspace/inside/direct.hpp"
#include "bodies/halfspace/source_tree.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace halfspace;
using inside::Solid;
using inside::Values;

std::vector<LoadedElement> loaded(const Frame& frame, const std::vector<double>& t) {
  std::vector<LoadedElement> elements;
  for (std::int64_t i = 0; i < frame.elements(); ++i) {
    LoadedElement e;
    e.geometry = plane_geometry(frame, i);
    e.element.type = e.geometry.type;
    const auto ids = frame.mesh.element(i);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const auto id = static_cast<std::size_t>(ids[k]);
      e.element.x[k] = frame.x[id], e.element.y[k] = frame.y[id];
      for (std::size_t c = 0; c < 3; ++c) e.element.traction[c][k] = t[3 * id + c];
    }
    elements.push_back(e);
  }
  return elements;
}

/// Returns the worst error of the first box, over the error that it was made for, seen from where each grid only just
/// serves.
double worst_of_box(double aspect, double error, bool uniform) {
  const std::vector<double> x = frames::uniform_lines(-1, 1, 4), y = frames::uniform_lines(-aspect, aspect, 4);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, x, y), Axes{});
  std::vector<double> t = inside::random_load(frame, 3);
  if (uniform) std::fill(t.begin(), t.end(), 1.0);
  const std::vector<LoadedElement> elements = loaded(frame, t);
  const SourceTree tree(elements, error);
  const InteriorKernels& kernels = interior_kernels(instruction_set());
  NearPoints fine;
  plain_rule(ElementType::quad4, 19, fine);
  pad_points(fine);
  frames::Random random(7);
  double worst = 0;
  for (int k = 0; k < 4000; ++k) {
    const double around = random.between(0, 2 * std::numbers::pi), up = random.between(0, 1.5) * (k % 2);
    const double r = std::exp(random.between(0, 3.5));
    const auto place = [&](double s) {
      return InteriorPoint{s * r * std::cos(around) * std::cos(up),
                           s * r * std::sin(around) * std::cos(up) * std::max(1.0, aspect),
                           s * r * std::sin(up) + 1e-9};
    };
    const InteriorPoint at = place(1);
    const int grid = tree.grid(tree.boxes()[0], at);
    if (grid < 0 || tree.grid(tree.boxes()[0], place(0.97)) == grid) continue;
    double box[interior_count] = {}, exact[interior_count] = {};
    kernels.push(tree.forces(0, grid), at, 0.6, box);
    for (const LoadedElement& e : elements) kernels.element(e.element, fine, at, 0.6, exact);
    const double share = 4 * aspect / (at.x * at.x + at.y * at.y + at.z * at.z) * 2 * std::numbers::pi;
    for (int c = 0; c < 6; ++c) worst = std::max(worst, std::abs(box[c] - exact[c]) / share / error);
  }
  return worst;
}

TEST(inside_boxes, error_of_a_box_is_within_its_bound) {
  for (const double aspect : {1.0, 3.0, 0.2})
    for (const double error : {1e-4, 1e-7})
      for (const bool uniform : {true, false}) {
        char text[120];
        std::snprintf(text, sizeof text, "box 1 : %g, %s load, error over that allowed, %g", aspect,
                      uniform ? "uniform" : "random", error);
        expect_error(text, worst_of_box(aspect, error, uniform), 1);
      }
}

/// Compares 256 points in a grid at a depth, in one call, which takes boxes, and in four, which do not.
double many_against_few(const Frame& frame, double depth, double accuracy) {
  const std::vector<double> t = inside::random_load(frame, 3);
  std::vector<std::array<double, 3>> points;
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i) points.push_back({-1.2 + 0.16 * i, -1.2 + 0.16 * j, depth});
  const std::vector<Values> all = inside::from_library(frame, t, {1, 0.3}, points, accuracy);
  double worst = 0;
  for (std::size_t first = 0; first < points.size(); first += 64) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<Values> few = inside::from_library(frame, t, {1, 0.3}, {begin, begin + 64}, accuracy / 10);
    for (std::size_t p = 0; p < few.size(); ++p)
      worst = std::max(worst, inside::stress_difference(all[first + p], few[p]));
  }
  return worst;
}

TEST(inside_boxes, many_points_agree_with_few) {
  const std::vector<double> line = frames::uniform_lines(-1, 1, 12);
  double worst = 0;
  for (const ElementType type : {ElementType::quad4, ElementType::tri6}) {
    const Frame frame = build_frame(frames::perturb(frames::rectangle(type, line, line), 0.2, 4), Axes{});
    for (const double depth : {0.0, 0.1, 1.0}) worst = std::max(worst, many_against_few(frame, depth, 1e-5));
  }
  expect_error("many points against few, accuracy 1e-5", worst, 2.9e-6);
}

TEST(inside_boxes, regular_and_irregular_frames_agree) {
  // Linear tractions are the same on every frame.
  const std::vector<double> line = frames::uniform_lines(-1, 1, 16);
  const SurfaceMesh grid = frames::rectangle(ElementType::quad4, line, line);
  const Frame regular = build_frame(grid, Axes{});
  const Frame triangles =
      build_frame(frames::perturb(frames::rectangle(ElementType::tri3, line, line), 0.3, 5), Axes{});
  const auto linear = [](const Frame& frame) {
    std::vector<double> t;
    for (std::size_t k = 0; k < frame.x.size(); ++k)
      t.insert(t.end(), {0.3 + 0.2 * frame.x[k], -0.1 * frame.y[k], 0.7 - 0.3 * frame.x[k]});
    return t;
  };
  std::vector<std::array<double, 3>> points;
  for (int k = 0; k < 240; ++k) points.push_back({-1.2 + 0.01 * k, 0.9 * std::sin(0.1 * k), 1e-3 * std::exp(0.03 * k)});
  const std::vector<Values> a = inside::from_library(regular, linear(regular), {1, 0.3}, points, 1e-6);
  const std::vector<Values> b = inside::from_library(triangles, linear(triangles), {1, 0.3}, points, 1e-6);
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p) worst = std::max(worst, inside::stress_difference(a[p], b[p]));
  expect_error("a grid of quadrilaterals and irregular triangles, accuracy 1e-6", worst, 3.7e-7);
}

}  // namespace
}  // namespace rollcon
