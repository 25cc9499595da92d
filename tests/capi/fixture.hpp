#pragma once
/// Puts a sphere on a rigid plane through the public interface: the scene of the tests in this room.

#include <gtest/gtest.h>
#include <rollcon_layers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#define ASSERT_OK(call) ASSERT_EQ(call, ROLLCON_OK) << rollcon_last_error()
#define EXPECT_OK(call) EXPECT_EQ(call, ROLLCON_OK) << rollcon_last_error()

namespace capi_test {

/// Holds a square frame of n x n bilinear quadrilaterals, ids from 0.
struct SquareFrame {
  std::vector<double> x;
  std::vector<std::int32_t> connectivity;
  std::int64_t nodes, elements;

  SquareFrame(int n, double half_width) : nodes(std::int64_t{n + 1} * (n + 1)), elements(std::int64_t{n} * n) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        x.insert(x.end(), {half_width * (2.0 * i / n - 1), half_width * (2.0 * j / n - 1), 0.0});
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const int corner = j * (n + 1) + i;
        connectivity.insert(connectivity.end(), {corner, corner + 1, corner + n + 2, corner + n + 1});
      }
    }
  }
};

inline SquareFrame moved(SquareFrame f, double x, double y, double z) {
  const double by[3] = {x, y, z};
  for (std::size_t i = 0; i < f.x.size(); ++i) f.x[i] += by[i % 3];
  return f;
}

inline void give_frame(rollcon_contact* c, const SquareFrame& f) {
  ASSERT_OK(rollcon_contact_frame_nodes(c, f.nodes, f.x.data(), 3, 1));
  ASSERT_OK(rollcon_contact_frame_add_elements(c, ROLLCON_QUAD4, f.elements, f.connectivity.data(), 0, 0));
}

/// Gives everything that a solve needs; gross sliding is far.
inline void give_scene(rollcon_contact* c, const SquareFrame& f) {
  const double mu = 0.1;
  give_frame(c, f);
  ASSERT_OK(rollcon_contact_set_gap_quadratic(c, 0.01, 0.01, 0));
  ASSERT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
  ASSERT_OK(rollcon_contact_set_rolling(c, 10));
  ASSERT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
  ASSERT_OK(rollcon_contact_set_creep(c, 1e-3, 0, 0));
}

inline std::int32_t hold(rollcon_body* body, const std::vector<std::int32_t>& nodes, std::int32_t dof_mask) {
  return rollcon_body_set_support(body, static_cast<std::int64_t>(nodes.size()), nodes.data(), 0, dof_mask, nullptr);
}

/// Describes a rigid sphere that rolls on the top of a body, the plane z = 1 over the unit square; with tag 0 the frame
/// is still to come.
struct OnTop {
  double x = 0.5, y = 0.5, curvature = 1, approach = 0.06, mu = 0.3, creep = 1e-2;
  std::int32_t tag = 6;
};
inline rollcon_contact* roll_on_top(rollcon_context* context, rollcon_body* body, rollcon_body* plane,
                                    const OnTop& at = {}) {
  const double origin[3] = {at.x, at.y, 1}, rolling[3] = {1, 0, 0}, normal[3] = {0, 0, 1};
  rollcon_contact* c = nullptr;
  EXPECT_OK(rollcon_contact_create(context, body, plane, &c));
  EXPECT_OK(rollcon_contact_set_axes(c, origin, rolling, normal));
  if (at.tag > 0) {
    EXPECT_OK(rollcon_contact_frame_from_body(c, 1, at.tag));
  }
  EXPECT_OK(rollcon_contact_set_gap_quadratic(c, 0.5 * at.curvature, 0.5 * at.curvature, 0));
  EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &at.mu));
  EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, at.approach));
  EXPECT_OK(rollcon_contact_set_creep(c, at.creep, 0, 0));
  return c;
}

/// Solves. The small frames of many tests have few nodes in contact, which is reported and does not matter there.
inline std::int32_t solve_small(rollcon_contact* contact) {
  const std::int32_t status = rollcon_contact_solve(contact);
  return status == ROLLCON_COARSE ? ROLLCON_OK : status;
}

inline std::array<double, 3> solved_force(rollcon_contact* c) {
  std::array<double, 3> force{};
  EXPECT_OK(solve_small(c));
  EXPECT_OK(rollcon_contact_get_resultant(c, ROLLCON_LOCAL, force.data(), nullptr));
  return force;
}

/// Returns the force of contacts that make(context) gives, each with a context and a thread of its own; all are the
/// same.
template <class Make>
std::array<double, 3> force_in_many_threads(int contacts, Make&& make, double relative = 0) {
  std::vector<std::array<double, 3>> force(static_cast<std::size_t>(contacts));
  std::vector<std::thread> pool;
  for (auto& f : force)
    pool.emplace_back([&f, &make] {
      rollcon_context* own = nullptr;
      EXPECT_OK(rollcon_context_create(ROLLCON_ABI, &own));
      EXPECT_OK(rollcon_context_set_threads(own, 1));
      rollcon_contact* c = make(own);
      f = solved_force(c);
      rollcon_contact_release(c);
      rollcon_context_release(own);
    });
  for (std::thread& t : pool) t.join();
  EXPECT_LT(force[0][2], 0);
  for (const auto& f : force)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(f[c], force[0][c], relative * std::abs(force[0][2]));
  return force[0];
}

/// Expects the text of the last failure to name the function that `call` begins with, and to contain every word.
inline void expect_text_of(const std::string& call, std::initializer_list<std::string> words) {
  const std::string text = rollcon_last_error();
  EXPECT_EQ(text.substr(0, text.find(':')), call.substr(0, call.find('('))) << text;
  for (const std::string& word : words)
    EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' in: " << text;
}

/// Expects the call to return the status, and the text of the failure to contain every word given.
#define EXPECT_FAILS(call, error, ...)                                                  \
  do {                                                                                  \
    EXPECT_EQ(call, ROLLCON_ERR_##error) << rollcon_status_string(ROLLCON_ERR_##error); \
    capi_test::expect_text_of(#call, {__VA_ARGS__});                                    \
  } while (0)

inline std::string plan_of(const rollcon_contact* contact) {
  std::int64_t needed = 0;
  EXPECT_OK(rollcon_contact_get_plan(contact, 0, nullptr, &needed));
  std::string text(static_cast<std::size_t>(needed), ' ');
  EXPECT_OK(rollcon_contact_get_plan(contact, needed, text.data(), nullptr));
  return text.c_str();
}

/// Expects calls that give elements, of frames and of bodies, to refuse the same inputs: give(type, n, connectivity,
/// index_base). The last word is what a body or frame says of too many; nodes are there, and `types` are the types that
/// it names.
template <class Give>
void expect_bad_elements_refused(Give&& give, const std::string& call, std::int32_t type,
                                 std::initializer_list<std::int32_t> wrong_types,
                                 std::initializer_list<std::string> types) {
  const std::vector<std::int32_t> ids(20, 0);
  const auto refused = [&](std::int32_t status, std::initializer_list<std::string> words) {
    EXPECT_EQ(status, ROLLCON_ERR_ARGUMENT);
    expect_text_of(call, words);
  };
  for (const std::int32_t wrong : wrong_types) {
    refused(give(wrong, 1, ids.data(), 0), types);
    expect_text_of(call, {"type is " + std::to_string(wrong)});
  }
  for (const std::int32_t base : {-1, 2}) refused(give(type, 1, ids.data(), base), {"index_base", "0, 1"});
  refused(give(type, -1, ids.data(), 0), {"n is -1"});
  refused(give(type, INT64_MAX, ids.data(), 0), {"2147483647"});
  refused(give(type, 1, nullptr, 0), {"connectivity is NULL"});
  EXPECT_OK(give(type, 0, nullptr, 0));
}

/// Expects bad nodes to be refused: give(n, x, strides).
template <class Give>
void expect_bad_nodes_refused(Give&& give, const std::string& call, std::vector<double> x) {
  const auto refused = [&](std::int32_t status, std::int32_t expected, std::initializer_list<std::string> words) {
    EXPECT_EQ(status, expected);
    expect_text_of(call, words);
  };
  for (const std::int64_t n : {std::int64_t{-1}, std::int64_t{0}, INT64_MAX})
    refused(give(n, x.data(), 3, 1), ROLLCON_ERR_ARGUMENT, {"n is " + std::to_string(n), "2147483647"});
  refused(give(4, nullptr, 3, 1), ROLLCON_ERR_ARGUMENT, {"x is NULL"});
  for (const std::int64_t stride : {std::int64_t{0}, std::int64_t{-3}}) {
    refused(give(4, x.data(), stride, 1), ROLLCON_ERR_ARGUMENT, {"strides"});
    refused(give(4, x.data(), 3, stride), ROLLCON_ERR_ARGUMENT, {"strides"});
  }
  refused(give(4, x.data(), INT64_MAX / 2, 1), ROLLCON_ERR_ARGUMENT, {"address space"});
  refused(give(1, x.data(), 3, INT64_MAX / 4), ROLLCON_ERR_ARGUMENT, {"address space"});
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    x[7 * 3 + 1] = bad;
    refused(give(9, x.data(), 3, 1), ROLLCON_ERR_NONFINITE, {"coordinate y of node 7", "from 0"});
  }
}

/// Expects ids of nodes to be named in the caller's count: give(n, ids, index_base) of lists of ids, a few to an entry.
template <class Give>
void expect_ids_named(Give&& give, const std::string& call, std::int64_t nodes, std::vector<std::int32_t> ids,
                      const std::string& from_0, const std::string& from_1) {
  const auto refused = [&](std::int32_t base, std::initializer_list<std::string> words) {
    EXPECT_EQ(give(ids.data(), base), ROLLCON_ERR_MESH);
    expect_text_of(call, words);
  };
  const std::string n = std::to_string(nodes), last = std::to_string(nodes - 1);
  ids.back() = static_cast<std::int32_t>(nodes);
  refused(0, {from_0, "from 0", "id " + n, "0 to " + last});
  ids.back() = 0;
  refused(1, {from_1, "from 1", "id 0", "1 to " + n});
  ids.back() = INT32_MIN;
  refused(1, {"id -2147483648"});
}

/// Holds a sphere of R = 50, E = 1e4, nu = 0.3 on a rigid plane; the contact's radius is about 1 at approach 0.02.
class Api : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &sphere));
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &plane));
    ASSERT_OK(rollcon_body_set_elastic(sphere, 0, 1e4, 0.3));
    ASSERT_OK(rollcon_contact_create(context, sphere, plane, &contact));
  }

  void TearDown() override {
    rollcon_contact_release(contact);
    rollcon_body_release(plane);
    rollcon_body_release(sphere);
    rollcon_context_release(context);
  }

  std::int32_t set_nodes(const SquareFrame& f) {
    return rollcon_contact_frame_nodes(contact, f.nodes, f.x.data(), 3, 1);
  }

  std::int32_t add_elements(const SquareFrame& f) {
    return rollcon_contact_frame_add_elements(contact, ROLLCON_QUAD4, f.elements, f.connectivity.data(), 0, 0);
  }

  void set_frame() { give_frame(contact, frame); }
  void set_scene() { give_scene(contact, frame); }

  std::string error() const { return rollcon_last_error(); }

  SquareFrame frame{12, 1.5};
  rollcon_context* context = nullptr;
  rollcon_body* sphere = nullptr;
  rollcon_body* plane = nullptr;
  rollcon_contact* contact = nullptr;
};

}  // namespace capi_test
