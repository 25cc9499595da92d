// Compares the five integrals over single elements of every type, for observers on, near and far from them, with
// adaptive brute force.

#include "bodies/halfspace/brute_force.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using brute_force::Element;
using brute_force::Reference;

Element straight_triangle() {
  return {ElementType::tri3, {0.1, 1.2, 0.3}, {-0.2, 0.1, 0.9}};
}
Element stretched_triangle() {
  return {ElementType::tri3, {0, 1, 0.3}, {0, 0.002, 0.01}};
}
Element straight_quadratic_triangle() {
  return {ElementType::tri6, {0.1, 1.2, 0.3, 0.65, 0.75, 0.2}, {-0.2, 0.1, 0.9, -0.05, 0.5, 0.35}};
}
Element curved_triangle() {
  return {ElementType::tri6, {0.1, 1.2, 0.3, 0.64, 0.84, 0.15}, {-0.2, 0.1, 0.9, -0.12, 0.58, 0.37}};
}
Element square() {
  return {ElementType::quad4, {0, 1, 1, 0}, {0, 0, 1, 1}};
}
Element skewed_quad() {
  return {ElementType::quad4, {0, 1.1, 0.8, 0.1}, {0, 0.1, 0.7, 1.0}};
}
Element stretched_quad() {
  return {ElementType::quad4, {0, 1, 1.02, 0.01}, {0, 0, 0.011, 0.010}};
}
Element curved_quad8() {
  return {ElementType::quad8, {0, 1.1, 0.9, 0.1, 0.55, 1.06, 0.5, 0.0}, {0, 0.1, 0.9, 1.0, -0.04, 0.5, 1.02, 0.52}};
}
Element curved_quad9() {
  Element e = curved_quad8();
  e.type = ElementType::quad9;
  e.x.push_back(0.53);
  e.y.push_back(0.49);
  return e;
}
Element ring_quad8() {  // a sixth of a ring, such as at the rim of a disc
  Element e{ElementType::quad8, {}, {}};
  const double r[8] = {0.8, 1, 1, 0.8, 0.9, 1, 0.9, 0.8};
  const double a[8] = {0, 0, 1, 1, 0, 0.5, 1, 0.5};
  for (std::size_t i = 0; i < 8; ++i) {
    e.x.push_back(r[i] * std::cos(a[i] * 0.4));
    e.y.push_back(r[i] * std::sin(a[i] * 0.4));
  }
  return e;
}

struct Case {
  const char* name;
  Element (*element)();
};

class ElementIntegrals : public ::testing::TestWithParam<Case> {
 protected:
  /// Holds the worst errors at the two tolerances over the observers added.
  struct Worst {
    double loose = 0, tight = 0;
  };
  void compare(Worst& worst, double px, double py, std::optional<Reference> on = {}) {
    const Element element = GetParam().element();
    const auto reference = brute_force::integrate(element, px, py, on);
    const auto loose = brute_force::from_library(element, px, py, 1e-6);
    const auto tight = brute_force::from_library(element, px, py, 1e-9);
    worst.loose = std::max(worst.loose, brute_force::relative_error(loose, reference));
    worst.tight = std::max(worst.tight, brute_force::relative_error(tight, reference));
  }
  void report(const char* where, const Worst& worst) {
    std::printf("%s, %s: error %.1e (bound 1e-6), %.1e (bound 1e-9)\n", GetParam().name, where, worst.loose,
                worst.tight);
    EXPECT_LE(worst.loose, 1e-6);
    EXPECT_LE(worst.tight, 1e-9);
  }
};

TEST_P(ElementIntegrals, observer_on_nodes_edges_and_inside) {
  const Element element = GetParam().element();
  const bool triangle = corner_count(element.type) == 3;
  std::vector<Reference> at;
  if (triangle)
    at = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.3}, {1.0 / 3, 1.0 / 3}, {0.7, 0.2}};
  else
    at = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {-1, 0.37}, {0, 0}, {0.6, -0.3}};
  Worst worst;
  for (const Reference on : at) {
    const auto p = brute_force::position(element, on);
    compare(worst, p[0], p[1], on);
  }
  report("nodes, edges, inside", worst);
}

TEST_P(ElementIntegrals, observer_inside_near_an_edge) {
  const Element element = GetParam().element();
  const bool triangle = corner_count(element.type) == 3;
  Worst worst;
  for (const double d : {1e-8, 1e-5, 1e-3, 1e-2, 1e-1}) {
    const Reference on = triangle ? Reference{0.37, d} : Reference{-0.26, -1 + d};
    const auto p = brute_force::position(element, on);
    compare(worst, p[0], p[1], on);
    const Reference corner = triangle ? Reference{1 - 3 * d, d} : Reference{1 - d, -1 + 2 * d};
    const auto q = brute_force::position(element, corner);
    compare(worst, q[0], q[1], corner);
  }
  report("inside near an edge", worst);
}

TEST_P(ElementIntegrals, observer_just_outside_and_near) {
  const Element element = GetParam().element();
  const bool triangle = corner_count(element.type) == 3;
  Worst worst;
  const Reference edge = triangle ? Reference{0.37, 0} : Reference{-0.26, -1};
  const Reference in = triangle ? Reference{0.37, 0.1} : Reference{-0.26, -0.8};
  const auto p = brute_force::position(element, edge), q = brute_force::position(element, in);
  const double length = std::hypot(p[0] - q[0], p[1] - q[1]);
  const double nx = (p[0] - q[0]) / length, ny = (p[1] - q[1]) / length;
  for (const double d : {1e-8, 1e-4, 1e-2, 0.1, 0.3, 0.6, 1.0, 1.7}) compare(worst, p[0] + d * nx, p[1] + d * ny);
  const double cx = element.x[1], cy = element.y[1];  // past a corner
  for (const double d : {1e-6, 1e-2, 0.2, 0.9}) compare(worst, cx + d, cy - 0.3 * d);
  report("just outside and near", worst);
}

TEST_P(ElementIntegrals, observer_far_away) {
  Worst worst;
  for (const double d : {2.5, 4.0, 7.0, 12.0, 30.0, 100.0, 1e4})
    for (const double angle : {0.1, 1.3, 2.9, 4.4})
      compare(worst, 0.5 + d * std::cos(angle), 0.4 + d * std::sin(angle));
  report("far", worst);
}

INSTANTIATE_TEST_SUITE_P(shapes, ElementIntegrals,
                         ::testing::Values(Case{"tri3", straight_triangle}, Case{"tri3_1_to_100", stretched_triangle},
                                           Case{"tri6", straight_quadratic_triangle},
                                           Case{"tri6_curved", curved_triangle}, Case{"quad4_square", square},
                                           Case{"quad4_skewed", skewed_quad}, Case{"quad4_1_to_100", stretched_quad},
                                           Case{"quad8_curved", curved_quad8}, Case{"quad9_curved", curved_quad9},
                                           Case{"quad8_ring", ring_quad8}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rollcon
