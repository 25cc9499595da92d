/// Tests that long preparations tell the host that they are at work, and stop when it wants them to.

#include "capi/body_fixture.hpp"
#include "capi/fem_fixture.hpp"

namespace capi_test {
namespace {

struct Watcher {
  bool stop = true;
  int at_work = 0;
};

std::int32_t stop_at_work(const rollcon_event* event, void* user) {
  auto& watcher = *static_cast<Watcher*>(user);
  std::int64_t phase = 0, iteration = 0;
  rollcon_event_get_int(event, ROLLCON_EVENT_PHASE, &phase);
  rollcon_event_get_int(event, ROLLCON_EVENT_ITERATION, &iteration);
  if (phase != ROLLCON_PHASE_COMPLIANCE || iteration == 0) return 0;
  EXPECT_EQ(iteration, ++watcher.at_work);
  return watcher.stop;
}

}  // namespace

/// Makes a frame whose dense rows take a second: irregular, and integrated to many digits.
class cancel_preparation : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    frame = SquareFrame(44, 1.5);
    for (std::size_t k = 0; k < frame.x.size(); k += 3) frame.x[k] += 0.004 * std::sin(40 * frame.x[k + 1]);
    set_scene();
    ASSERT_OK(rollcon_contact_set_real(contact, "accuracy", 1e-9));
    ASSERT_OK(rollcon_contact_set_progress(contact, stop_at_work, &watcher));
  }
  Watcher watcher;
};

TEST_F(cancel_preparation, stops_a_solve_and_leaves_the_contact_usable) {
  for (const std::int32_t threads : {1, 2}) {
    ASSERT_OK(rollcon_context_set_threads(context, threads));
    watcher = {};
    EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_CANCELLED);
    EXPECT_EQ(watcher.at_work, 1) << "of the calls of one that was told to stop";
    double force[3];
    EXPECT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr), ROLLCON_ERR_STATE);
  }
  watcher = {false, 0};
  EXPECT_OK(rollcon_contact_solve(contact));
  std::printf("told %d times (bound: at least once)\n", watcher.at_work);
  EXPECT_GE(watcher.at_work, 1);
}

TEST_F(cancel_preparation, stops_a_list_of_cases) {
  const double value[] = {1e-4, 1e-3};
  std::int32_t status[2] = {-1, -1};
  double force[6] = {};
  EXPECT_EQ(rollcon_contact_solve_many(contact, "longitudinal", 2, value, "force", 3, force, nullptr, status),
            ROLLCON_CANCELLED);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(status[k], ROLLCON_CANCELLED);
  for (const double f : force) EXPECT_TRUE(std::isnan(f));
}

/// Makes a regular frame by FFT, whose tables of one node's influence take some tenths of a second.
class cancel_lattice : public Api {};

TEST_F(cancel_lattice, stops_the_tables_of_influence) {
  if (!rollcon_has_feature("fftw")) GTEST_SKIP() << "this build is without FFTW";
  Watcher watcher;
  frame = SquareFrame(400, 1.5);
  set_scene();
  ASSERT_OK(rollcon_contact_set_progress(contact, stop_at_work, &watcher));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_CANCELLED);
  EXPECT_EQ(watcher.at_work, 1);
  double force[3];
  EXPECT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr), ROLLCON_ERR_STATE);
}

/// Makes a body that takes longer to assemble than the host waits to be told.
template <class Fixture>
class CancelBody : public Fixture {
 protected:
  /// Takes the body's faces of a tag as the frame; 0: none is given.
  void expect_cancelled(std::int32_t tag) {
    const double origin[3] = {0.5, 0.5, 1}, rolling[3] = {1, 0, 0}, normal[3] = {0, 0, 1}, mu = 0.3;
    rollcon_contact* c = nullptr;
    ASSERT_OK(rollcon_contact_create(this->context, this->body, this->plane, &c));
    EXPECT_OK(rollcon_contact_set_axes(c, origin, rolling, normal));
    EXPECT_OK(tag != 0 ? rollcon_contact_frame_from_body(c, 1, tag) : rollcon_contact_frame_automatic(c))
        << this->error();
    EXPECT_OK(rollcon_contact_set_gap_quadratic(c, 1, 1, 0));
    EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
    EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.06));
    Watcher watcher;
    EXPECT_OK(rollcon_contact_set_progress(c, stop_at_work, &watcher));
    EXPECT_EQ(rollcon_contact_solve(c), ROLLCON_CANCELLED) << this->error();
    EXPECT_EQ(watcher.at_work, 1);
    // A body that was not finished is not there; one that was is reported once it is factorised.
    double factorizations = 0;
    const std::int32_t there = rollcon_body_get_stat(this->body, "factorizations", &factorizations);
    EXPECT_TRUE(there == ROLLCON_OK || there == ROLLCON_ERR_STATE);
    std::printf("%s, %g factorisation(s) (bound 1)\n", there == ROLLCON_OK ? "whole" : "unfinished", factorizations);
    EXPECT_LE(factorizations, 1);
    rollcon_contact_release(c);
  }
};

using cancel_boundary_elements = CancelBody<BodyApi>;
using cancel_finite_elements = CancelBody<FemApi>;

TEST_F(cancel_boundary_elements, stops_the_assembly) {
  cube = CubeSurface(16);
  set_mesh(body);
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  for (const std::int32_t tag : {6, 0}) expect_cancelled(tag);
}

TEST_F(cancel_finite_elements, stops_between_the_parts_of_the_work) {
  box = BoxVolume(28);
  set_mesh();
  ASSERT_OK(tag_top(6));
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  expect_cancelled(6);
}

}  // namespace capi_test
