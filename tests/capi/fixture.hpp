#pragma once
/// A sphere on a rigid plane through the public interface: the scene of the tests in this room.

#include <gtest/gtest.h>
#include <rollcon.h>

#include <cstdint>
#include <string>
#include <vector>

namespace capi_test {

/// Square frame of n x n bilinear quadrilaterals, ids from 0.
struct SquareFrame {
  std::vector<double> x;
  std::vector<std::int32_t> connectivity;
  std::int64_t nodes, elements;

  SquareFrame(int n, double half_width)
      : nodes(std::int64_t{n + 1} * (n + 1)), elements(std::int64_t{n} * n) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        x.insert(x.end(), {half_width * (2.0 * i / n - 1), half_width * (2.0 * j / n - 1), 0.0});
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const int corner = j * (n + 1) + i;
        connectivity.insert(connectivity.end(),
                            {corner, corner + 1, corner + n + 2, corner + n + 1});
      }
    }
  }
};

/// Sphere R = 50, E = 1e4, nu = 0.3 on a rigid plane; contact radius about 1 at approach 0.02.
class Api : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(rollcon_context_create(ROLLCON_ABI, &context), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &sphere), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_create(context, ROLLCON_BODY_RIGID, &plane), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_set_elastic(sphere, 0, 1e4, 0.3), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_create(context, sphere, plane, &contact), ROLLCON_OK);
  }

  void TearDown() override {
    rollcon_contact_release(contact);
    rollcon_body_release(plane);
    rollcon_body_release(sphere);
    rollcon_context_release(context);
  }

  std::int32_t set_nodes(const SquareFrame& f) {
    return rollcon_contact_set_frame_nodes(contact, f.nodes, f.x.data(), 3, 1);
  }

  std::int32_t add_elements(const SquareFrame& f) {
    return rollcon_contact_add_frame_elements(contact, ROLLCON_QUAD4, f.elements,
                                              f.connectivity.data(), 0, 0);
  }

  void set_frame() {
    ASSERT_EQ(set_nodes(frame), ROLLCON_OK);
    ASSERT_EQ(add_elements(frame), ROLLCON_OK);
  }

  /// Everything a solve needs; gross sliding is far.
  void set_scene() {
    const double mu = 0.1;
    set_frame();
    ASSERT_EQ(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &mu), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_set_rolling(contact, 10), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02),
              ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_set_creep(contact, 1e-3, 0, 0), ROLLCON_OK);
  }

  std::string error() const { return rollcon_last_error(); }

  SquareFrame frame{12, 1.5};
  rollcon_context* context = nullptr;
  rollcon_body* sphere = nullptr;
  rollcon_body* plane = nullptr;
  rollcon_contact* contact = nullptr;
};

/// Solves. The small frames of many tests have few nodes in contact, which is told and no matter
/// there.
inline std::int32_t solve_small(rollcon_contact* contact) {
  const std::int32_t status = rollcon_contact_solve(contact);
  return status == ROLLCON_COARSE ? ROLLCON_OK : status;
}

/// The call returns the status, and the text of the failure contains every word given.
#define EXPECT_FAILS(call, expected_status, ...)                                            \
  do {                                                                                      \
    EXPECT_EQ(call, expected_status) << rollcon_status_string(expected_status);             \
    const std::string text_ = error();                                                      \
    const std::string call_ = #call;                                                        \
    EXPECT_EQ(text_.substr(0, text_.find(':')), call_.substr(0, call_.find('('))) << text_; \
    for (const std::string& word_ : std::initializer_list<std::string>{__VA_ARGS__})        \
      EXPECT_NE(text_.find(word_), std::string::npos) << "'" << word_ << "' in: " << text_; \
  } while (0)

}  // namespace capi_test
