/// Tests that setters of a time loop allocate nothing, and that its solves do not, either.

#include <cstdlib>
#include <new>

#include "body_fixture.hpp"
#include "counted_allocations.hpp"
#include "fem_fixture.hpp"

namespace capi_test {

thread_local std::int64_t allocations = 0;
thread_local bool failed = false;
thread_local std::int64_t until_failure = -1;

}  // namespace capi_test

using namespace capi_test;

// All forms of operator new except the aligned ones are replaced, so that no block comes from one allocator and goes to
// another. They are not inlined, because compilers that see the inside of one of a pair only take them for mismatched.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  if (until_failure == 0) {
    failed = true;
    return nullptr;
  }
  if (until_failure > 0) --until_failure;
  return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* p = ::operator new(size, std::nothrow)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new[](std::size_t size) {
  return ::operator new(size);
}
[[gnu::noinline]] void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
  return ::operator new(size, tag);
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, const std::nothrow_t&) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete[](void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete[](void* p, const std::nothrow_t&) noexcept {
  std::free(p);
}

class allocation : public Api {
 protected:
  void set_step(int step) {
    const double change = 1 + 0.01 * step;
    for (double& h : gap) h = change;
    for (double& c : slip) c = change;
    for (double& m : mu) m = 0.1 * change;
    failures += rollcon_contact_set_creep(contact, 1e-3 * change, 0, 1e-4 * step) != 0;
    failures += rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, change) != 0;
    failures += rollcon_contact_set_rolling(contact, change) != 0;
    failures += rollcon_contact_set_velocity(contact, 1, gap.data(), gap.data(), gap.data()) != 0;
    failures += rollcon_contact_set_gap(contact, frame.nodes, gap.data()) != 0;
    failures += rollcon_contact_set_gap_quadratic(contact, change, change, 0) != 0;
    failures += rollcon_contact_set_creep_field(contact, frame.nodes, slip.data()) != 0;
    failures += rollcon_contact_set_friction(contact, "coulomb", 1, mu.data()) != 0;
    failures += rollcon_contact_set_friction_field(contact, frame.nodes, mu.data()) != 0;
    failures += rollcon_contact_set_real(contact, "tolerance", 1e-8 * change) != 0;
    failures += rollcon_contact_set_int(contact, "max_iterations", 50 + step) != 0;
    failures += rollcon_contact_set_creep_field(contact, 0, nullptr) != 0;
    failures += rollcon_contact_set_friction_field(contact, 0, nullptr) != 0;
  }

  std::vector<double> gap = std::vector<double>(static_cast<std::size_t>(frame.nodes));
  std::vector<double> slip = std::vector<double>(static_cast<std::size_t>(2 * frame.nodes));
  std::vector<double> mu = std::vector<double>(static_cast<std::size_t>(frame.nodes));
  int failures = 0;
};

TEST_F(allocation, setters_of_a_time_loop_allocate_nothing) {
  set_frame();
  set_step(0);
  ASSERT_GT(allocations, 0) << "the count works";
  allocations = 0;
  for (int step = 1; step <= 10; ++step) set_step(step);
  const std::int64_t counted = allocations;
  std::printf("allocations in 130 setters: %lld (bound 0)\n", static_cast<long long>(counted));
  EXPECT_EQ(counted, 0);
  EXPECT_EQ(failures, 0);
}

TEST_F(allocation, solves_of_a_time_loop_allocate_nothing) {
  set_frame();
  const double friction = 0.3;
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &friction));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
  for (const char* solver : {"lu", "gmres"}) {
    ASSERT_OK(rollcon_contact_set_str(contact, "linear_solver", solver));
    std::int64_t counted = 0;
    double iterations = 0;
    for (int step = 0; step <= 20; ++step) {
      ASSERT_OK(rollcon_contact_set_creep(contact, 1e-3 * (1 + 0.01 * step), 0, 0));
      allocations = 0;
      const std::int32_t status = rollcon_contact_solve(contact);
      double force[3];
      std::int32_t slopes = ROLLCON_OK;
      for (std::int32_t p = ROLLCON_LONGITUDINAL; p <= ROLLCON_FRICTION; ++p)
        slopes += rollcon_contact_get_sensitivity(contact, p, force, nullptr, nullptr, nullptr);
      if (step > 0) counted += allocations;
      ASSERT_GE(status, 0);
      ASSERT_OK(slopes);
      double n = 0;
      ASSERT_OK(rollcon_contact_get_stat(contact, "iterations", &n));
      iterations += step > 0 ? n : 0;
    }
    std::printf("%s: allocations in 20 warm solves with derivatives: %lld (bound 0), %g iterations\n", solver,
                static_cast<long long>(counted), iterations);
    EXPECT_EQ(counted, 0);
    EXPECT_GT(iterations, 0) << "the solves had something to do";
  }
}

// Loads, motions, friction and gap change from step to step.
void expect_no_allocations(rollcon_context* context, rollcon_contact* contact, std::initializer_list<const char*> of,
                           int steps) {
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  for (const char* operators : of) {
    ASSERT_OK(rollcon_contact_set_str(contact, "operators", operators));
    for (const std::int32_t kind : {ROLLCON_ROLLING_STEP, ROLLCON_SHIFT_STEP}) {
      ASSERT_OK(rollcon_contact_reset(contact));
      std::int64_t counted = 0, last = 0;
      int failed_solves = 0;
      for (int step = 0; step <= steps; ++step) {
        const double phase = 0.1 * step, friction = 0.3 + 0.05 * std::sin(phase);
        allocations = 0;
        std::int32_t status = rollcon_contact_set_gap_quadratic(contact, 0.01 + 0.001 * std::sin(phase), 0.01, 0);
        status += rollcon_contact_set_friction(contact, "coulomb", 1, &friction);
        status += rollcon_contact_set_step(contact, kind, 0.1);
        status += rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02 + 0.003 * std::cos(phase));
        status += rollcon_contact_set_creep(contact, 1e-3 * std::cos(phase), 3e-4 * std::sin(phase), 0);
        failed_solves += rollcon_contact_solve(contact) < 0;
        ASSERT_OK(status);
        // One period is over.
        if (step > 70 && allocations > 0) last = step, counted += allocations;
      }
      std::printf("%s, %s: allocations in %d steps: %lld (bound 0), the last in step %lld\n", operators,
                  kind == ROLLCON_SHIFT_STEP ? "shift" : "rolling", steps - 70, static_cast<long long>(counted),
                  static_cast<long long>(last));
      EXPECT_EQ(counted, 0);
      EXPECT_EQ(failed_solves, 0);
    }
  }
}

TEST_F(allocation, steps_in_time_allocate_nothing) {
  set_frame();
  expect_no_allocations(context, contact, {"table", "dense", "fft"}, 400);
}

class allocation_nightly : public allocation {};
TEST_F(allocation_nightly, steps_in_time_allocate_nothing) {
  set_frame();
  expect_no_allocations(context, contact, {"table"}, 100070);
}

// A crowned roller on a plane has slip that varies from node to node.
TEST_F(allocation, solves_with_new_velocities_allocate_nothing) {
  const double friction = 0.3, crown[2] = {200, 5}, centre[3] = {0, 0, -50}, axis[3] = {0, 1, 0},
               ahead[3] = {0.5, 0, 0};
  const double none[3] = {0, 0, 0};
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  rollcon_contact* c = nullptr;
  ASSERT_OK(rollcon_body_set_profile_shape(sphere, "arc", 2, crown));
  ASSERT_OK(rollcon_body_revolve_profile(sphere, centre, axis, 50));
  ASSERT_OK(rollcon_contact_create(context, sphere, plane, &c));
  ASSERT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &friction));
  ASSERT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.006));
  ASSERT_OK(rollcon_contact_set_velocity(c, 0, ahead, none, none));
  for (const bool given : {true, false}) {
    if (given) {
      ASSERT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, 16, 16, -2, 2, -2, 2));
    } else {
      ASSERT_OK(rollcon_contact_frame_automatic(c));
    }
    std::int64_t counted = 0;
    double iterations = 0;
    for (int step = 0; step <= 20; ++step) {
      const double change = 0.01 * step;
      const double v[3] = {-10, 0.01, 0}, omega[3] = {0.001 * change, 0.2 * (1 + 1e-3 * (1 + change)), 0};
      const double field[3] = {0.1 + change, 0, 0};
      allocations = 0;
      std::int32_t status = rollcon_contact_set_velocity(c, 1, v, omega, centre);
      status += rollcon_contact_set_velocity(c, 2, field, none, none);
      ASSERT_OK(status);
      ASSERT_GE(rollcon_contact_solve(c), 0) << error();
      // The first warm solve makes what predictions start from.
      if (step > 1) counted += allocations;
      double n = 0;
      ASSERT_OK(rollcon_contact_get_stat(c, "iterations", &n));
      iterations += step > 1 ? n : 0;
    }
    std::printf("velocities, %s: allocations in 19 warm solves: %lld (bound 0), %g iterations\n",
                given ? "frame given" : "no frame", static_cast<long long>(counted), iterations);
    EXPECT_EQ(counted, 0);
    EXPECT_TRUE(iterations > 0 || !given);  // strips have been solved before
  }
  rollcon_contact_release(c);
}

// Frames that the library makes follow load and curvature.
TEST_F(allocation, solves_without_a_frame_allocate_nothing) {
  const double friction = 0.3;
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &friction));
  ASSERT_OK(rollcon_contact_set_real(contact, "frame_accuracy", 0.1));
  std::int64_t counted = 0;
  for (int step = 0; step <= 100; ++step) {
    const double phase = 0.1 * step, change = std::sin(phase);
    allocations = 0;
    std::int32_t status = rollcon_contact_set_gap_quadratic(contact, 0.01, 0.02 * (1 + 0.3 * change), 0);
    status += rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 0.05 * (1 + 0.2 * change));
    status += rollcon_contact_set_creep(contact, 1e-3 * (1 + 0.5 * change), 1e-3 * std::cos(phase), 0);
    status += rollcon_contact_solve(contact);
    const std::int64_t here = allocations;
    ASSERT_OK(status);
    if (step >= 64) counted += here;  // one period of the curvature is over
  }
  std::printf("no frame: allocations in 37 solves with new load and curvature: %lld (bound 0)\n",
              static_cast<long long>(counted));
  EXPECT_EQ(counted, 0);
}

class allocation_meshed : public allocation {
 protected:
  /// Presses a rigid sphere on the top of a unit cube held at its bottom, with growing creepage.
  void expect_none_in_warm_solves(rollcon_body* body, const std::vector<std::int32_t>& bottom, const char* what) {
    ASSERT_OK(rollcon_context_set_threads(context, 1));
    ASSERT_OK(hold(body, bottom, ROLLCON_DOF_XYZ));
    rollcon_contact* c = roll_on_top(context, body, plane);
    std::int64_t counted = 0;
    for (int step = 0; step <= 10; ++step) {
      ASSERT_OK(rollcon_contact_set_creep(c, 1e-2 * (1 + 0.02 * step), 0, 0));
      allocations = 0;
      ASSERT_OK(solve_small(c));
      if (step > 0) counted += allocations;
    }
    std::printf("%s: allocations in 10 warm solves: %lld (bound 0)\n", what, static_cast<long long>(counted));
    EXPECT_EQ(counted, 0);
    rollcon_contact_release(c);
  }
};

TEST_F(allocation_meshed, solves_with_boundary_elements_allocate_nothing) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  const CubeSurface cube(6);
  rollcon_body* body = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_BEM, &body));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, 200, 0.3));
  give_mesh(body, cube);
  expect_none_in_warm_solves(body, cube.nodes_at(2, 0), "boundary elements");
  rollcon_body_release(body);
}

TEST_F(allocation_meshed, solves_with_finite_elements_allocate_nothing) {
  if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  const BoxVolume box(6);
  for (const std::int64_t between_nodes : {0, 1}) {
    rollcon_body* body = nullptr;
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
    ASSERT_OK(rollcon_body_set_elastic(body, 0, 200, 0.3));
    give_mesh(body, box);
    ASSERT_OK(rollcon_body_set_int(body, "between_nodes", between_nodes));
    expect_none_in_warm_solves(body, box.nodes_at(2, 0),
                               between_nodes ? "finite elements, by shape functions" : "finite elements");
    rollcon_body_release(body);
  }
}
