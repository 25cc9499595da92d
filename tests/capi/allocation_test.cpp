/// Setters of a time loop allocate nothing, and neither do its solves; an allocation that fails
/// leaves a contact that can be solved again.

#include <cmath>
#include <cstdlib>
#include <new>

#include "body_fixture.hpp"

namespace {

thread_local std::int64_t allocations = 0;
thread_local bool failed = false;
thread_local std::int64_t until_failure = -1;  ///< allocations that still succeed; < 0: all

}  // namespace

// All forms but the aligned ones, so that no block comes from one allocator and goes to another.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  if (until_failure == 0) {
    failed = true;
    return nullptr;
  }
  if (until_failure > 0) --until_failure;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* p = ::operator new(size, std::nothrow)) return p;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) {
  return ::operator new(size);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
  return ::operator new(size, tag);
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, const std::nothrow_t&) noexcept {
  std::free(p);
}
void operator delete[](void* p) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, const std::nothrow_t&) noexcept {
  std::free(p);
}

using namespace capi_test;

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
  std::printf("allocations in 120 setters: %lld (bound 0)\n", static_cast<long long>(counted));
  EXPECT_EQ(counted, 0);
  EXPECT_EQ(failures, 0);
}

TEST_F(allocation, solves_of_a_time_loop_allocate_nothing) {
  set_frame();
  const double friction = 0.3;
  ASSERT_EQ(rollcon_context_set_threads(context, 1), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &friction), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02),
            ROLLCON_OK);
  for (const char* solver : {"lu", "gmres"}) {
    ASSERT_EQ(rollcon_contact_set_str(contact, "linear_solver", solver), ROLLCON_OK);
    std::int64_t counted = 0;
    double iterations = 0;
    for (int step = 0; step <= 20; ++step) {
      ASSERT_EQ(rollcon_contact_set_creep(contact, 1e-3 * (1 + 0.01 * step), 0, 0), ROLLCON_OK);
      allocations = 0;
      const std::int32_t status = rollcon_contact_solve(contact);
      if (step > 0) counted += allocations;
      ASSERT_GE(status, 0);
      double n = 0;
      ASSERT_EQ(rollcon_contact_get_stat(contact, "iterations", &n), ROLLCON_OK);
      iterations += step > 0 ? n : 0;
    }
    std::printf("%s: allocations in 20 warm solves: %lld (bound 0), %g iterations\n", solver,
                static_cast<long long>(counted), iterations);
    EXPECT_EQ(counted, 0);
    EXPECT_GT(iterations, 0) << "the solves had something to do";
  }
}

TEST_F(allocation, solves_with_a_meshed_body_allocate_nothing) {
  const CubeSurface cube(6);
  rollcon_body* body = nullptr;
  rollcon_contact* c = nullptr;
  ASSERT_EQ(rollcon_context_set_threads(context, 1), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_create(context, ROLLCON_BODY_BEM, &body), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_set_elastic(body, 0, 200, 0.3), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_set_nodes(body, cube.nodes(), cube.x.data(), 3, 1), ROLLCON_OK);
  for (std::int32_t f = 0; f < 6; ++f)
    ASSERT_EQ(rollcon_body_add_elements(body, ROLLCON_QUAD4, cube.face_elements(),
                                        cube.face[static_cast<std::size_t>(f)].data(), 0, f + 1),
              ROLLCON_OK);
  const std::vector<std::int32_t> bottom = cube.nodes_at(2, 0);
  ASSERT_EQ(rollcon_body_set_support(body, static_cast<std::int64_t>(bottom.size()), bottom.data(),
                                     0, ROLLCON_DOF_XYZ, nullptr),
            ROLLCON_OK);
  const double origin[3] = {0.5, 0.5, 1}, rolling[3] = {1, 0, 0}, normal[3] = {0, 0, 1}, mu = 0.3;
  ASSERT_EQ(rollcon_contact_create(context, body, plane, &c), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_set_axes(c, origin, rolling, normal), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_frame_from_body(c, 1, 6), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_set_gap_quadratic(c, 0.5, 0.5, 0), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_set_friction(c, "coulomb", 1, &mu), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.06), ROLLCON_OK);
  std::int64_t counted = 0;
  for (int step = 0; step <= 10; ++step) {
    ASSERT_EQ(rollcon_contact_set_creep(c, 1e-2 * (1 + 0.02 * step), 0, 0), ROLLCON_OK);
    allocations = 0;
    ASSERT_EQ(rollcon_contact_solve(c), ROLLCON_OK);
    if (step > 0) counted += allocations;
  }
  std::printf("boundary elements: allocations in 10 warm solves: %lld (bound 0)\n",
              static_cast<long long>(counted));
  EXPECT_EQ(counted, 0);
  rollcon_contact_release(c);
  rollcon_body_release(body);
}

TEST_F(allocation, a_solve_that_ran_out_of_memory_can_be_repeated) {
  const double friction = 0.3;
  const auto scene = [&] {
    set_frame();
    ASSERT_EQ(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &friction), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02),
              ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_set_creep(contact, 1e-3, 0, 0), ROLLCON_OK);
  };
  ASSERT_EQ(rollcon_context_set_threads(context, 1), ROLLCON_OK);
  scene();
  const std::int32_t right_status = rollcon_contact_solve(contact);
  double right[3];
  ASSERT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, right, nullptr), ROLLCON_OK);
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
    ASSERT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr), ROLLCON_OK);
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(force[c], right[c], 1e-9 * std::abs(right[2])) << k;
  }
  std::printf("failed allocations: %d, each followed by the right solution\n", injected);
  EXPECT_GT(injected, 50);
}
