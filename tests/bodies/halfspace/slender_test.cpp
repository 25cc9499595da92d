// Tests slender elements: their integrals hold the tolerance, and cost grows with the logarithm of the sides' ratio.

#include <array>

#include "bodies/halfspace/brute_force.hpp"
#include "bodies/halfspace/halfspace.hpp"
#include "mesh/shape.hpp"
#include "quadrature/near_field.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using brute_force::Element;
using brute_force::Integrals;

constexpr std::size_t kernels = 5;  ///< number of brute_force::Integrals

/// Returns a square, or half of one, moved at its corners by up to `distortion` of its side, then pressed flat and
/// turned.
Element flat_element(ElementType type, double aspect, double distortion, std::uint32_t seed) {
  frames::Random random(seed);
  const double square_x[] = {-1, 1, 1, -1}, square_y[] = {-1, -1, 1, 1};
  const auto corners = static_cast<std::size_t>(corner_count(type));
  Element e{type, {}, {}};
  for (std::size_t i = 0; i < corners; ++i) {
    const double x = square_x[i] + 2 * distortion * random(), y = (square_y[i] + 2 * distortion * random()) / aspect;
    e.x.push_back(0.8 * x - 0.6 * y);
    e.y.push_back(0.6 * x + 0.8 * y);
  }
  for (std::size_t i = 0; is_quadratic(type) && i < corners; ++i) {
    e.x.push_back(0.5 * (e.x[i] + e.x[(i + 1) % corners]));
    e.y.push_back(0.5 * (e.y[i] + e.y[(i + 1) % corners]));
  }
  return e;
}

/// Returns points on the element, on its sides, and around it up to a few times its width away.
std::vector<std::array<double, 2>> observers(const Element& e, std::uint32_t seed) {
  frames::Random random(seed);
  const auto at = [&](double xi, double eta) { return brute_force::position(e, {xi, eta}); };
  std::vector<std::array<double, 2>> points = {{e.x[0], e.y[0]}, {e.x[2], e.y[2]}, at(-0.3, 1), at(1, 0.2), at(0, 0)};
  for (const double reach : {1.0, 1.1, 2.0, 6.0})
    for (int i = 0; i < 3; ++i) {
      const double xi = 1.2 * random();
      points.push_back(at(xi, reach * random()));
    }
  return points;
}

/// Returns the integrals from the element cut into `parts` along its length: its shape functions are interpolated
/// exactly on the parts, if they are bilinear there.
Integrals from_parts(const Element& e, double px, double py, int parts, double tolerance) {
  Integrals sum{};
  for (int m = 0; m < parts; ++m) {
    const double begin = -1 + 2.0 * m / parts, end = -1 + 2.0 * (m + 1) / parts;
    const double xi[] = {begin, end, end, begin}, eta[] = {-1, -1, 1, 1};
    Element part{ElementType::quad4, {}, {}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto x = brute_force::position(e, {xi[i], eta[i]});
      part.x.push_back(x[0]);
      part.y.push_back(x[1]);
    }
    const Integrals value = brute_force::from_library(part, px, py, tolerance);
    for (std::size_t i = 0; i < 4; ++i) {
      Shape shape;
      evaluate_shape(e.type, xi[i], eta[i], shape);
      for (std::size_t k = 0; k < kernels; ++k)
        for (std::size_t n = 0; n < 4; ++n) sum[k][n] += shape.value[n] * value[k][i];
    }
  }
  return sum;
}

TEST(slender_quadrilaterals, agree_with_themselves_cut_into_round_ones) {
  double worst[2] = {0, 0};
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const Element e = flat_element(ElementType::quad4, 300, seed % 2 ? 0.1 : 0.2, seed);
    for (const auto& [px, py] : observers(e, seed)) {
      const Integrals reference = from_parts(e, px, py, 150, 1e-11);
      const double tolerance[] = {1e-6, 1e-9};
      for (std::size_t k = 0; k < 2; ++k)
        worst[k] = std::max(worst[k],
                            brute_force::relative_error(brute_force::from_library(e, px, py, tolerance[k]), reference));
    }
  }
  std::printf("largest error %.1e (bound 1e-6), %.1e (bound 1e-9)\n", worst[0], worst[1]);
  EXPECT_LE(worst[0], 1e-6);
  EXPECT_LE(worst[1], 1e-9);
}

/// Returns the integral of 1/r over a polygon: the sum over its sides of their distance times asinh's. It has eight
/// digits in double precision at a ratio of 1e6.
double potential(const Element& e, double px, double py) {
  using Real = long double;
  const auto corners = static_cast<std::size_t>(corner_count(e.type));
  Real sum = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t j = (i + 1) % corners;
    const Real ax = Real{e.x[i]} - px, ay = Real{e.y[i]} - py, bx = Real{e.x[j]} - px, by = Real{e.y[j]} - py;
    const Real length = std::hypot(bx - ax, by - ay), h = (ax * by - ay * bx) / length;
    if (std::abs(h) < 1e-18L * length) continue;
    const Real s = ((bx - ax) * ax + (by - ay) * ay) / length, t = ((bx - ax) * bx + (by - ay) * by) / length;
    sum += h * (std::asinh(t / std::abs(h)) - std::asinh(s / std::abs(h)));
  }
  return static_cast<double>(sum);
}

class SlenderElements : public ::testing::TestWithParam<ElementType> {};

TEST_P(SlenderElements, have_the_potential_of_polygons) {
  double worst = 0;
  for (const double aspect : {1.0, 1e2, 1e4, 1e6})
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
      const Element e = flat_element(GetParam(), aspect, seed % 2 ? 0.1 : 0.2, seed);
      for (const auto& [px, py] : observers(e, seed)) {
        const Integrals value = brute_force::from_library(e, px, py, 1e-9);
        double sum = 0;
        for (std::size_t n = 0; n < e.x.size(); ++n) sum += value[0][n];
        const double exact = potential(e, px, py);
        worst = std::max(worst, std::abs(sum - exact) / exact);
      }
    }
  std::printf("%d nodes: largest error %.1e (bound 1e-9)\n", node_count(GetParam()), worst);
  EXPECT_LE(worst, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(types, SlenderElements,
                         ::testing::Values(ElementType::tri3, ElementType::quad4, ElementType::quad8),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });

double solid_angle(const Vec3 (&c)[4]) {
  double sum = 0;
  for (const int k : {1, 2}) {
    const Vec3 &a = c[0], &b = c[k], &d = c[k + 1];
    const double la = length(a), lb = length(b), ld = length(d);
    sum += 2 * std::atan2(dot(a, cross(b, d)), la * lb * ld + dot(a, b) * ld + dot(b, d) * la + dot(d, a) * lb);
  }
  return sum;
}

// The strongly singular part is the integral of z/r^3, in a plane that is turned in space.
TEST(slender_quadrilaterals, are_seen_under_their_solid_angle) {
  constexpr double tolerance = 1e-9;
  double worst = 0;
  // The exact formula has no digits left beyond these ratios.
  for (const double aspect : {1.0, 30.0, 1e3})
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
      const Element e = flat_element(ElementType::quad4, aspect, seed % 2 ? 0.1 : 0.2, seed);
      frames::Random random(seed);
      for (const double height : {0.02, 0.5, 3.0})
        for (int i = 0; i < 3; ++i) {
          const auto [px, py] = brute_force::position(e, {1.5 * random(), 4 * random()});
          Vec3 corner[4];
          for (std::size_t k = 0; k < 4; ++k) {
            const double x = e.x[k] - px, y = e.y[k] - py, z = -height / aspect;
            corner[k] = {0.6 * x + 0.8 * z, y, -0.8 * x + 0.6 * z};
          }
          const quadrature::ElementGeometry geometry = quadrature::element_geometry(ElementType::quad4, corner);
          quadrature::NearWorkspace w;
          double sum = 0;
          quadrature::near_field(geometry, {0, 0, 0}, {}, {tolerance, tolerance}, true, w, [&] {
            for (int q = 0; q < w.points.n; ++q) {
              Vec3 x, u, v;
              geometry.tangents({w.points.xi[q], w.points.eta[q]}, x, u, v);
              const double r = length(x);
              sum += w.points.w[q] * dot(cross(u, v), x) / (r * r * r);
            }
          });
          worst = std::max(worst, std::abs(sum - solid_angle(corner)));
        }
    }
  // The kernel T has a factor 1/(4 pi), and the integral against each of the four shape functions may be off.
  const double bound = 4 * 4 * 3.14159265358979 * tolerance;
  std::printf("largest error of a solid angle %.1e (bound %.1e)\n", worst, bound);
  EXPECT_LE(worst, bound);
}

/// Counts evaluations for the half-space under a frame whose lines are off the grid, so that no element is like its
/// neighbour.
std::int64_t evaluations(ElementType type, double ratio, double distortion) {
  const double x[] = {0, 0.21, 0.4, 0.63, 0.8, 1}, y[] = {0, 0.18, 0.41, 0.6, 0.83, 1};
  SurfaceMesh mesh = frames::perturb(frames::rectangle(type, x, y), distortion, 3);
  for (Vec3& node : mesh.node) node = {node[0] + 0.1 * node[1], node[1] / ratio, 0};
  const Frame frame = build_frame(std::move(mesh), Axes{});
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-8, 1);
  std::vector<double> u(3 * frame.x.size()), t(u.size(), 1.0);
  compliance->apply({frame.x, frame.y}, t.data(), u.data());
  for (const double v : u) EXPECT_TRUE(std::isfinite(v));
  return compliance->kernel_evaluations();
}

// Elements cut into similar parts would need evaluations in proportion to the sides' ratio.
TEST(slender_elements, cost_little_more) {
  struct Case {
    ElementType type;
    double distortion, ratio, times;  ///< `times`: multiple of the round element's evaluations
  };
  for (const auto& [type, distortion, ratio, times] :
       {Case{ElementType::tri3, 0.2, 1e4, 5}, Case{ElementType::quad4, 0.2, 1e4, 25},
        Case{ElementType::quad8, 0.2, 1e4, 25}, Case{ElementType::tri3, 0.2, 1e6, 6},
        Case{ElementType::quad4, 0.2, 1e6, 50}}) {
    const auto round = evaluations(type, 1, distortion), slender = evaluations(type, ratio, distortion);
    std::printf("%d nodes, ratio %.0e: %lld evaluations, %lld of round ones, bound %.0f times\n", node_count(type),
                ratio, static_cast<long long>(slender), static_cast<long long>(round), times);
    EXPECT_LT(static_cast<double>(slender), times * static_cast<double>(round));
  }
}

}  // namespace
}  // namespace rollcon
