/// Long preparations tell the host that they are at work, and stop when it wants them to.

#include <cmath>
#include <cstdio>
#include <vector>

#include "capi/fixture.hpp"

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

/// A frame whose dense rows take a second: irregular, and integrated to many digits.
class cancel_preparation : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    frame = SquareFrame(44, 1.5);
    for (std::size_t k = 0; k < frame.x.size(); k += 3)
      frame.x[k] += 0.004 * std::sin(40 * frame.x[k + 1]);
    set_scene();
    ASSERT_EQ(rollcon_contact_set_real(contact, "accuracy", 1e-9), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_set_progress(contact, stop_at_work, &watcher), ROLLCON_OK);
  }
  Watcher watcher;
};

TEST_F(cancel_preparation, stops_a_solve_and_leaves_the_contact_usable) {
  for (const std::int32_t threads : {1, 2}) {
    ASSERT_EQ(rollcon_context_set_threads(context, threads), ROLLCON_OK);
    watcher = {};
    EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_CANCELLED);
    EXPECT_EQ(watcher.at_work, 1) << "of the calls of one that was told to stop";
    double force[3];
    EXPECT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr),
              ROLLCON_ERR_STATE);
  }
  watcher = {false, 0};
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
  std::printf("told %d times (bound: at least once)\n", watcher.at_work);
  EXPECT_GE(watcher.at_work, 1);
}

TEST_F(cancel_preparation, stops_a_list_of_cases) {
  const double value[] = {1e-4, 1e-3};
  std::int32_t status[2] = {-1, -1};
  double force[6] = {};
  EXPECT_EQ(rollcon_contact_solve_many(contact, "longitudinal", 2, value, "force", 3, force,
                                       nullptr, status),
            ROLLCON_CANCELLED);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(status[k], ROLLCON_CANCELLED);
  for (const double f : force) EXPECT_TRUE(std::isnan(f));
}

}  // namespace capi_test
