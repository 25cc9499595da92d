// Tests that on the surface results are limits from inside: tractions come back, displacements are those of the
// surface's own integrals.

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/halfspace/inside/direct.hpp"
#include "mesh/shape.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using inside::Solid;
using inside::Values;

constexpr Solid solid{2, 0.3};

Frame frame_of(ElementType type) {
  const double x[] = {0, 1, 1.8, 3, 4}, y[] = {0, 0.7, 2, 3};
  return build_frame(frames::perturb(frames::rectangle(type, x, y), 0.15, 3), Axes{});
}

/// Returns smooth tractions that are zero on the rim of the frame.
std::vector<double> smooth(const Frame& frame) {
  std::vector<double> t;
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    const double x = frame.x[k], y = frame.y[k], bump = frame.rim[k] ? 0 : x * (4 - x) * y * (3 - y) / 9;
    t.insert(t.end(), {0.3 * bump * (1 - 0.2 * x), -0.2 * bump * (0.5 + y), bump});
  }
  return t;
}

struct Sample {
  double x, y;
  std::array<double, 3> traction;
};

/// Returns points of every element, its nodes and points of its edges among them.
std::vector<Sample> samples(const Frame& frame, const std::vector<double>& t) {
  std::vector<Sample> points;
  const auto add = [&](std::int64_t e, ElementType type, double xi, double eta) {
    Shape s;
    evaluate_shape(type, xi, eta, s);
    Sample p{0, 0, {0, 0, 0}};
    const auto ids = frame.mesh.element(e);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const auto id = static_cast<std::size_t>(ids[k]);
      p.x += s.value[k] * frame.x[id];
      p.y += s.value[k] * frame.y[id];
      for (std::size_t j = 0; j < 3; ++j) p.traction[j] += s.value[k] * t[3 * id + j];
    }
    points.push_back(p);
  };
  for (std::int64_t e = 0; e < frame.elements(); e += 2) {
    const ElementType type = frame.mesh.type[static_cast<std::size_t>(e)];
    if (corner_count(type) == 3)
      for (const auto& [xi, eta] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.3, 0.0}, {0.4, 0.6}, {0.2, 0.3}, {1e-7, 0.5}})
        add(e, type, xi, eta);
    else
      for (const auto& [xi, eta] : {std::pair{-1.0, -1.0}, {1.0, 1.0}, {0.3, -1.0}, {1.0, 0.4}, {0.2, 0.3}, {0.999, 0}})
        add(e, type, xi, eta);
  }
  return points;
}

constexpr ElementType types[] = {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                 ElementType::quad9};

TEST(inside_surface, tractions_come_back_under_elements_edges_and_nodes) {
  double back = 0, jump = 0;
  for (const ElementType type : types) {
    const Frame frame = frame_of(type);
    const std::vector<double> t = smooth(frame);
    const std::vector<Sample> sample = samples(frame, t);
    const double largest = *std::max_element(t.begin(), t.end());
    std::vector<std::array<double, 3>> on, below;
    for (const Sample& p : sample) on.push_back({p.x, p.y, 0}), below.push_back({p.x, p.y, 1e-6});
    const std::vector<Values> s = inside::from_library(frame, t, solid, on, 1e-6);
    const std::vector<Values> near = inside::from_library(frame, t, solid, below, 1e-6);
    for (std::size_t p = 0; p < sample.size(); ++p) {
      const auto& f = sample[p].traction;
      // The outward normal is -z.
      for (std::size_t j = 0; j < 3; ++j) back = std::max(back, std::abs(s[p][j == 2 ? 2 : 4 + j] + f[j]) / largest);
      jump = std::max(jump, inside::stress_difference(s[p], near[p]) / largest);
    }
  }
  expect_error("tractions on the surface, accuracy 1e-6", back, 1e-6);
  // Stresses have slopes like log z at kinks of the tractions.
  expect_error("change of stresses from z = 0 to 1e-6", jump, 3.6e-5);
}

TEST(inside_surface, displacements_are_those_of_the_surface) {
  for (const ElementType type : types) {
    const Frame frame = frame_of(type);
    const std::vector<double> t = inside::random_load(frame, 4);
    const HalfspaceConstants c = halfspace_constants(2 * solid.shear * (1 + solid.poisson), solid.poisson, 1);
    const auto compliance = make_halfspace_compliance(frame, c, 1e-8, 1);
    // A mirrored body has n = -z.
    std::vector<double> mirrored = t, u(3 * frame.x.size());
    for (std::size_t k = 2; k < mirrored.size(); k += 3) mirrored[k] = -mirrored[k];
    compliance->apply({frame.x, frame.y}, mirrored.data(), u.data());
    std::vector<std::array<double, 3>> points;
    for (std::size_t k = 0; k < frame.x.size(); ++k) points.push_back({frame.x[k], frame.y[k], 0});
    const std::vector<Values> s = inside::from_library(frame, t, solid, points, 1e-6);
    double worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      worst = std::max(
          {worst, std::abs(s[k][6] - u[3 * k]), std::abs(s[k][7] - u[3 * k + 1]), std::abs(s[k][8] + u[3 * k + 2])});
    expect_error("type " + std::to_string(static_cast<int>(type)) + ", displacements at the nodes", worst, 4.5e-8);
  }
}

}  // namespace
}  // namespace rollcon
