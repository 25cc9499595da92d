/// Tests that an allocation that fails leaves handles whose calls can be made again.

#include <iterator>

#include "body_fixture.hpp"
#include "counted_allocations.hpp"
#include "fem_fixture.hpp"

using namespace capi_test;

using out_of_memory = Api;

/// The test repeats everything from the nodes of a finite-element body to the solve: a call that runs out of memory
/// changes nothing and can be repeated.
TEST_F(out_of_memory, calls_with_finite_elements_can_be_repeated) {
  if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  const BoxVolume box(2);
  const std::vector<std::int32_t> bottom = box.nodes_at(2, 0), top = box.nodes_at(2, 1);
  const auto faces = box.top_faces();
  const std::int32_t quad[4] = {0, 3, 4, 1};
  const double friction = 0.3, pressure = 1e-3;
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  int repeated = 0;
  const auto twice = [&](auto call) {
    std::int32_t status = call();
    if (status == ROLLCON_ERR_MEMORY) {
      until_failure = -1;
      ++repeated;
      status = call();
    }
    return status;
  };
  std::array<double, 3> right{};
  for (std::int64_t k = -1;; k += 1 + k / 25) {
    rollcon_body* body = nullptr;
    rollcon_contact* c = nullptr;
    std::array<double, 3> force{};
    failed = false;
    until_failure = k;
    const std::int32_t statuses[] = {
        twice([&] { return rollcon_body_create(context, ROLLCON_BODY_FEM, &body); }),
        twice([&] { return rollcon_body_set_elastic(body, 4, 200, 0.3); }),
        twice([&] { return rollcon_body_set_nodes(body, box.nodes(), box.x.data(), 3, 1); }),
        twice([&] { return rollcon_body_add_elements(body, ROLLCON_QUAD4, 1, quad, 0, 5); }),
        twice([&] {
          return rollcon_body_add_elements(body, ROLLCON_HEX8, box.elements(), box.connectivity.data(), 0, 4);
        }),
        twice([&] { return rollcon_body_tag_faces_of_nodes(body, 9, top.data(), 0, 3); }),
        twice([&] { return rollcon_body_tag_faces(body, 4, faces.first.data(), faces.second.data(), 0, 6); }),
        twice([&] { return rollcon_body_set_support(body, 9, bottom.data(), 0, 7, nullptr); }),
        twice([&] { return rollcon_body_set_pressure(body, 0, pressure); }),
        twice([&] { return rollcon_contact_create(context, body, plane, &c); }),
        twice([&] { return rollcon_contact_frame_from_body(c, 1, 6); }),
        twice([&] { return rollcon_contact_set_gap_quadratic(c, 0.5, 0.5, 0); }),
        twice([&] { return rollcon_contact_set_friction(c, "coulomb", 1, &friction); }),
        twice([&] { return rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.06); }),
        twice([&] { return rollcon_body_prepare(body); }),
        twice([&] { return rollcon_contact_solve(c); }),
        rollcon_contact_get_resultant(c, ROLLCON_LOCAL, force.data(), nullptr)};
    until_failure = -1;
    for (std::size_t i = 0; i < std::size(statuses); ++i)
      ASSERT_GE(statuses[i], 0) << "call " << i << " after " << k << " allocations";
    rollcon_contact_release(c);
    rollcon_body_release(body);
    if (k < 0) {
      right = force;
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(force[i], right[i], 1e-12 * std::abs(right[2])) << k;
    if (!failed) break;
  }
  std::printf("finite elements: %d calls repeated after a failed allocation\n", repeated);
  EXPECT_GT(repeated, 100);
  EXPECT_LT(right[2], 0);
}

TEST_F(out_of_memory, derivatives_can_be_asked_for_again) {
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  double right[3], force[3];
  int injected = 0;
  for (std::int64_t k = -1;; ++k) {
    rollcon_contact_release(contact);  // a new one has no storage
    ASSERT_OK(rollcon_contact_create(context, sphere, plane, &contact));
    set_scene();
    ASSERT_OK(rollcon_contact_set_str(contact, "linear_solver", "lu"));
    ASSERT_OK(solve_small(contact));
    const auto ask = [&] {
      return rollcon_contact_get_sensitivity(contact, ROLLCON_SPIN, force, nullptr, nullptr, nullptr);
    };
    failed = false;
    until_failure = k;
    const std::int32_t status = ask();
    until_failure = -1;
    if (k < 0) {
      ASSERT_OK(status);
      std::copy_n(force, 3, right);
      continue;
    }
    if (!failed) break;
    ++injected;
    ASSERT_EQ(status, ROLLCON_ERR_MEMORY) << k;
    ASSERT_OK(ask()) << k;
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(force[i], right[i], 1e-9 * std::abs(right[2])) << k;
  }
  std::printf("failed allocations: %d, each followed by the right derivative\n", injected);
  EXPECT_GT(injected, 5);
}

TEST_F(out_of_memory, a_solve_can_be_repeated) {
  const double friction = 0.3;
  const auto scene = [&] {
    set_frame();
    ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
    ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &friction));
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
    ASSERT_OK(rollcon_contact_set_creep(contact, 1e-3, 0, 0));
  };
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  scene();
  const std::int32_t right_status = rollcon_contact_solve(contact);
  double right[3];
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, right, nullptr));
  int injected = 0;
  for (std::int64_t k = 0;; k += k < 60 ? 1 : 7) {
    scene();  // new nodes: everything is built again
    failed = false;
    until_failure = k;
    const std::int32_t status = rollcon_contact_solve(contact);
    until_failure = -1;
    if (!failed) break;
    ++injected;
    ASSERT_EQ(status, ROLLCON_ERR_MEMORY) << k;
    ASSERT_EQ(rollcon_contact_solve(contact), right_status) << k;
    double force[3];
    ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(force[c], right[c], 1e-9 * std::abs(right[2])) << k;
  }
  std::printf("failed allocations: %d, each followed by the right solution\n", injected);
  EXPECT_GT(injected, 50);
}
