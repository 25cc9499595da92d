// Compares stresses and displacements at random points under random tractions on every kind of element with direct
// quadrature.

#include <random>

#include "bodies/halfspace/inside/direct.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using inside::Solid;
using inside::Values;

constexpr Solid solid{2, 0.3};

/// Makes four by three cells of a size near 1, distorted.
Frame frame_of(ElementType type, double perturbed, double bent) {
  const double x[] = {0, 1, 1.8, 3, 4}, y[] = {0, 0.7, 2, 3};
  SurfaceMesh mesh = frames::rectangle(type, x, y);
  if (perturbed > 0) mesh = frames::perturb(std::move(mesh), perturbed, 5);
  if (bent > 0) mesh = frames::bend_midsides(std::move(mesh), bent, 6);
  return build_frame(std::move(mesh), Axes{});
}

/// Returns points at a depth, over the frame and beside it.
std::vector<std::array<double, 3>> points_at(double depth, int count, std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> x(-1, 5), y(-1, 4);
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < count; ++i) points.push_back({x(engine), y(engine), depth});
  return points;
}

struct Worst {
  double stress = 0, motion = 0;
};

void compare(const Frame& frame, double depth, double accuracy, Worst& worst) {
  const std::vector<double> load = inside::random_load(frame, 1);
  const auto points = points_at(depth, 6, 2);
  const std::vector<Values> values = inside::from_library(frame, load, solid, points, accuracy);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Values exact = inside::direct(frame, load, solid, points[p][0], points[p][1], points[p][2]);
    worst.stress = std::max(worst.stress, inside::stress_difference(values[p], exact));
    worst.motion = std::max(worst.motion, inside::motion_difference(values[p], exact));
  }
}

/// Elements under unit loads have stresses to the accuracy asked for, and displacements to much more.
void expect_accuracy(const std::string& what, const Worst& worst, double accuracy, double of_stress, double of_motion) {
  expect_error(what + ": stresses, over the accuracy asked for", worst.stress / accuracy, of_stress);
  expect_error(what + ": displacements, likewise", worst.motion / accuracy, of_motion);
}

constexpr ElementType types[] = {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                 ElementType::quad9};

TEST(inside_random_load, affine_elements_match_direct_quadrature) {
  Worst worst;
  for (const ElementType type : types)
    for (const double depth : {1e-3, 0.05, 0.4, 3.0}) compare(frame_of(type, 0, 0), depth, 1e-5, worst);
  expect_accuracy("parallelograms and triangles", worst, 1e-5, 0.2, 0.0029);
}

TEST(inside_random_load, distorted_elements_match_direct_quadrature) {
  Worst worst;
  for (const ElementType type : types)
    for (const double depth : {1e-3, 0.1, 1.0}) compare(frame_of(type, 0.2, 0), depth, 1e-5, worst);
  expect_accuracy("distorted elements", worst, 1e-5, 0.17, 0.0035);
}

TEST(inside_random_load, curved_elements_match_direct_quadrature) {
  Worst worst;
  for (const ElementType type : {ElementType::tri6, ElementType::quad8, ElementType::quad9})
    for (const double depth : {1e-3, 0.1, 1.0}) compare(frame_of(type, 0.1, 0.1), depth, 1e-5, worst);
  expect_accuracy("curved elements", worst, 1e-5, 0.086, 0.0017);
}

TEST(inside_random_load, accuracy_asked_for_is_met) {
  for (const double accuracy : {1e-3, 1e-7, 1e-9}) {
    Worst worst;
    for (const double depth : {1e-2, 0.3, 2.0}) compare(frame_of(ElementType::quad9, 0.2, 0), depth, accuracy, worst);
    char text[60];
    std::snprintf(text, sizeof text, "accuracy %g", accuracy);
    expect_accuracy(text, worst, accuracy, 0.07, 0.0016);
  }
}

TEST(inside_random_load, slender_elements_keep_the_accuracy) {
  // The comparison is with the library's own best, which the other tests compare with direct quadrature.
  double worst = 0;
  for (const double width : {1.0, 0.1, 0.01}) {
    const double x[] = {-1, 1}, y[] = {-width, width};
    SurfaceMesh mesh = frames::rectangle(ElementType::quad4, x, y);
    for (const double off : {0.0, 0.3}) {
      mesh.node[3][0] -= off;
      const Frame frame = build_frame(mesh, Axes{});
      const std::vector<double> load = inside::random_load(frame, 1);
      std::mt19937 engine(5);
      std::uniform_real_distribution<double> unit(-1, 1);
      std::vector<std::array<double, 3>> points;
      for (int k = 0; k < 190; ++k)
        points.push_back({1.3 * unit(engine), 2 * width * unit(engine), width * std::pow(10, 2 * unit(engine) - 2)});
      for (int k = 0; k < 10; ++k) points.push_back({1 + 1e-8 * k, width * (1 - 0.1 * k), 0});
      const std::vector<Values> rough = inside::from_library(frame, load, solid, points, 1e-5);
      const std::vector<Values> fine = inside::from_library(frame, load, solid, points, 1e-9);
      for (std::size_t p = 0; p < points.size(); ++p)
        worst = std::max(worst, inside::stress_difference(rough[p], fine[p]) / 1e-5);
    }
  }
  expect_error("elements up to 1 : 100: stresses, over the accuracy asked for", worst, 0.4);
}

}  // namespace
}  // namespace rollcon
