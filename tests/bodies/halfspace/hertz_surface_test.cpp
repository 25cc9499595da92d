// Tests that Hertz's pressure, interpolated on rings graded to the contact's edge, leaves a paraboloid.

#include "bodies/halfspace/halfspace.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Returns the largest error of u_n inside the contact circle, relative to its centre value.
double surface_error(ElementType type, int rings) {
  const auto radius = frames::contact_radii(1, rings, 1);
  const auto count = frames::ring_counts(radius);
  const Frame frame = build_frame(frames::ring_disc(type, radius, count), Axes{});
  const double nu = 0.3, p0 = 1, g = 1;
  const auto compliance = make_halfspace_compliance(frame, halfspace_constants(2 * (1 + nu) * g, nu, 1), 1e-8, 1);
  std::vector<double> t(3 * frame.x.size(), 0.0), x, y, exact;
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    const double r2 = frame.x[k] * frame.x[k] + frame.y[k] * frame.y[k];
    t[3 * k + 2] = -p0 * std::sqrt(std::max(0.0, 1 - r2));
  }
  for (int i = 0; i < 40; ++i) {
    const double r = 0.95 * i / 39, a = 0.4 + 1.7 * i;
    x.push_back(r * std::cos(a));
    y.push_back(r * std::sin(a));
    // The exact displacement is u_n = -(1 - nu) pi p0 (2 a^2 - r^2) / (8 G a).
    exact.push_back(-(1 - nu) * std::numbers::pi * p0 * (2 - r * r) / (8 * g));
  }
  std::vector<double> u(3 * x.size());
  compliance->apply({x, y}, t.data(), u.data());
  double error = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    error = std::max(error, std::abs(u[3 * i + 2] - exact[i]) / std::abs(exact[0]));
  return error;
}

TEST(hertz_surface, is_a_paraboloid_to_second_order_or_better) {
  for (const auto& [type, bound] : {std::pair{ElementType::tri3, 4e-3}, {ElementType::tri6, 2e-4}}) {
    const double coarse = surface_error(type, 8), fine = surface_error(type, 16);
    const double order = std::log2(coarse / fine);
    std::printf("%d nodes: error %.1e, %.1e (bound %.0e), order %.2f (at least 1.7)\n", node_count(type), coarse, fine,
                bound, order);
    EXPECT_LE(fine, bound);
    EXPECT_GE(order, 1.7);
  }
}

}  // namespace
}  // namespace rollcon
