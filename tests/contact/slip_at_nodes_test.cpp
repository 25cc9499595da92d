/// Tests slip at the nodes by the characteristic scheme on frames that end at the contact's edge.

#include <cmath>

#include "contact/convection/convection.hpp"
#include "framing/makers.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

Frame strips(std::int64_t along, std::int64_t across) {
  return build_frame(strips_mesh({}, strips_of_ellipse(2, 1, 0, across), along), {});
}

/// Holds D w of w = x^2 in both components, less the derivative against the flow at the nodes, and rows that take slip
/// there.
struct Defect {
  double at_nodes = 0, elsewhere = 0;
  int nodes = 0;
};

Defect defect(const Frame& frame, const Convection& c) {
  const std::size_t n = frame.x.size();
  std::vector<double> w(3 * n, 0.0), ahead(3 * n, 0.0), slip[2];
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < 2; ++i) {
      w[3 * k + i] = frame.x[k] * frame.x[k];
      ahead[3 * k + i] = std::pow(frame.x[k] + c.ahead[k], 2);
    }
  convect(c, w.data(), ahead.data(), slip);
  Defect d;
  for (std::size_t k = 0; k < n; ++k) {
    const double off = std::abs(slip[1][k] + 2 * c.slip_x[k]);
    const bool at_node = c.slip_x[k] == frame.x[k];
    d.nodes += at_node;
    double& worst = at_node ? d.at_nodes : d.elsewhere;
    worst = std::max(worst, off);
  }
  return d;
}

TEST(slip_at_nodes, is_exact_for_quadratic_displacements) {
  const Frame frame = strips(16, 12);
  const Defect d = defect(frame, make_convection(frame, Scheme::characteristic, true));
  expect_error("slip at nodes", d.at_nodes, 1e-12);
  expect_error("slip half a step upstream of the others", d.elsewhere, 1e-12);
  // The two nodes next to the upstream end of each of 11 strips, and that end, have no next node, or one too near it.
  EXPECT_EQ(d.nodes, 11 * 14);
}

TEST(slip_at_nodes, frames_larger_than_the_contact_have_none) {
  const Frame frame = strips(8, 6);
  EXPECT_EQ(defect(frame, make_convection(frame, Scheme::characteristic, false)).nodes, 0);
}

}  // namespace
}  // namespace rollcon
