/// Frames much smaller than the faces of a finite-element body on which they are laid.

#include <cmath>

#include "fem_fixture.hpp"

using namespace capi_test;

class corner_frames : public FemApi {
 protected:
  /// One element of the type, held at its bottom; its top is z = 1.
  void set_element(std::int32_t type) {
    const std::vector<double> x = unit_element(type);
    const auto n = static_cast<std::int64_t>(x.size()) / 3;
    ASSERT_EQ(rollcon_body_set_nodes(body, n, x.data(), 3, 1), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_add_elements(body, type, 1, counting(n).data(), 0, 0), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_set_elastic(body, 0, young, poisson), ROLLCON_OK);
    std::vector<std::int32_t> bottom;
    for (std::int32_t i = 0; i < n; ++i)
      if (x[3 * static_cast<std::size_t>(i) + 2] == 0) bottom.push_back(i);
    ASSERT_EQ(hold(bottom, ROLLCON_DOF_XYZ), ROLLCON_OK);
  }

  /// Status of a solve on a frame of that width from (x, y) on; its tractions are finite.
  std::int32_t press(double at_x, double at_y, double width) {
    const double x = at_x + width / 2, y = at_y + width / 2;
    const SquareFrame small = moved(SquareFrame(2, width / 2), x, y, 1);
    rollcon_contact* c = roll_on_top(
        context, body, plane, {.x = x, .y = y, .curvature = 0.1, .approach = 1e-3, .mu = 0.2, .creep = 0, .tag = 0});
    give_frame(c, small);
    const std::int32_t status = rollcon_contact_solve(c);
    if (status >= 0) {
      std::vector<double> t(3 * static_cast<std::size_t>(small.nodes), none);
      EXPECT_EQ(rollcon_contact_get_tractions(c, ROLLCON_LOCAL, small.nodes, t.data()), ROLLCON_OK);
      double sum = 0;
      for (const double value : t) {
        EXPECT_TRUE(std::isfinite(value));
        sum += value;
      }
      EXPECT_LT(sum, 0) << "it is pressed";
    }
    rollcon_contact_release(c);
    return status;
  }

  static constexpr double none = 1e300;
};

TEST_F(corner_frames, are_borne_or_refused) {
  int borne = 0;
  for (const std::int32_t type : {ROLLCON_HEX8, ROLLCON_HEX20, ROLLCON_WEDGE15}) {
    rollcon_body_release(body);
    ASSERT_EQ(rollcon_body_create(context, ROLLCON_BODY_FEM, &body), ROLLCON_OK);
    set_element(type);
    for (const double width : {0.2, 1e-2, 1e-4, 1e-6, 3.8e-8}) {
      for (const double at : {0.0, 0.1}) {
        const std::int32_t status = press(at, at, width);
        EXPECT_TRUE(status >= 0 || status == ROLLCON_ERR_MESH || status == ROLLCON_ERR_SINGULAR)
            << "type " << type << ", width " << width << ": " << error();
        borne += status >= 0;
      }
    }
  }
  EXPECT_GE(borne, 15) << "of 30";
}
