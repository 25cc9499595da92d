/// Tests threads, callbacks, cancelling.

#include <atomic>
#include <stdexcept>

#include "capi/every_call.hpp"
#include "fixture.hpp"

using namespace capi_test;

namespace {

struct Watcher {
  rollcon_context* context = nullptr;
  rollcon_contact* contact = nullptr;
  const rollcon_event* kept = nullptr;
  std::atomic<bool> inside{false}, leave{false};
  int calls = 0;
  int stop_after = 1 << 30;
  std::vector<std::int32_t> statuses;
};

std::int32_t read_event(const rollcon_event* event, void* user) {
  auto& watcher = *static_cast<Watcher*>(user);
  std::int64_t phase = 0, iteration = -1;
  double residual = -1, seconds = -1;
  EXPECT_OK(rollcon_event_get_int(event, ROLLCON_EVENT_PHASE, &phase));
  EXPECT_OK(rollcon_event_get_int(event, ROLLCON_EVENT_ITERATION, &iteration));
  EXPECT_OK(rollcon_event_get_real(event, ROLLCON_EVENT_RESIDUAL, &residual));
  EXPECT_OK(rollcon_event_get_real(event, ROLLCON_EVENT_SECONDS, &seconds));
  EXPECT_GE(phase, ROLLCON_PHASE_COMPLIANCE);
  EXPECT_LE(phase, ROLLCON_PHASE_FULL);
  EXPECT_GE(iteration, 0);
  EXPECT_GE(residual, 0);
  EXPECT_GE(seconds, 0);
  EXPECT_EQ(rollcon_event_get_int(event, ROLLCON_EVENT_SECONDS, &phase), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_event_get_real(event, ROLLCON_EVENT_PHASE, &residual), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_event_get_int(event, ROLLCON_EVENT_PHASE, nullptr), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_event_get_real(event, ROLLCON_EVENT_RESIDUAL, nullptr), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_event_get_int(nullptr, ROLLCON_EVENT_PHASE, &phase), ROLLCON_ERR_ARGUMENT);
  watcher.kept = event;
  return ++watcher.calls >= watcher.stop_after;
}

std::int32_t call_back_into_the_library(const rollcon_event*, void* user) {
  auto& watcher = *static_cast<Watcher*>(user);
  rollcon_contact* c = watcher.contact;
  double v[3];
  if (watcher.calls++ > 0) return 0;
  watcher.statuses = {rollcon_contact_solve(c), rollcon_contact_set_rolling(c, 1),
                      rollcon_contact_get_motion(c, v, nullptr), rollcon_contact_set_progress(c, nullptr, nullptr),
                      rollcon_contact_reset(c)};
  EXPECT_OK(rollcon_contact_retain(c));
  rollcon_contact_release(c);
  EXPECT_OK(rollcon_context_check(watcher.context));
  return 0;
}

std::int32_t wait_inside(const rollcon_event*, void* user) {
  auto& watcher = *static_cast<Watcher*>(user);
  watcher.inside.store(true);
  while (!watcher.leave.load()) std::this_thread::yield();
  return 0;
}

std::int32_t request_cancel_from_inside(const rollcon_event*, void* user) {
  auto& watcher = *static_cast<Watcher*>(user);
  EXPECT_OK(rollcon_contact_request_cancel(watcher.contact));
  ++watcher.calls;
  return 0;
}

std::int32_t throw_from_inside(const rollcon_event*, void*) {
  throw std::runtime_error("a host in C++ that throws");
}

std::int32_t release_from_inside(const rollcon_event*, void* user) {
  auto& watcher = *static_cast<Watcher*>(user);
  if (watcher.calls++ == 0) rollcon_contact_release(watcher.contact);
  return 0;
}

struct Log {
  std::vector<std::string> lines;
  std::vector<std::int32_t> levels;
};

void keep_line(std::int32_t level, const char* message, void* user) {
  static_cast<Log*>(user)->lines.emplace_back(message);
  static_cast<Log*>(user)->levels.push_back(level);
}

}  // namespace

class callbacks : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    set_scene();
    watcher.context = context;
    watcher.contact = contact;
  }

  Watcher watcher;
};

TEST_F(callbacks, events_tell_phase_iteration_residual_and_time) {
  ASSERT_OK(rollcon_contact_set_progress(contact, read_event, &watcher));
  EXPECT_OK(rollcon_contact_solve(contact));
  EXPECT_GE(watcher.calls, 2);
  const int calls = watcher.calls;
  ASSERT_OK(rollcon_contact_set_progress(contact, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_solve(contact));
  EXPECT_EQ(watcher.calls, calls);
}

TEST_F(callbacks, events_are_dead_outside_of_their_callback) {
  ASSERT_OK(rollcon_contact_set_progress(contact, read_event, &watcher));
  ASSERT_OK(rollcon_contact_solve(contact));
  std::int64_t v = 0;
  double r = 0;
  EXPECT_EQ(rollcon_event_get_int(watcher.kept, ROLLCON_EVENT_PHASE, &v), ROLLCON_ERR_HANDLE);
  EXPECT_EQ(rollcon_event_get_real(watcher.kept, ROLLCON_EVENT_SECONDS, &r), ROLLCON_ERR_HANDLE);
}

TEST_F(callbacks, non_zero_return_cancels_and_the_contact_stays_usable) {
  for (const int stop_after : {1, 2, 3}) {
    watcher.calls = 0;
    watcher.stop_after = stop_after;
    ASSERT_OK(rollcon_contact_reset(contact));
    ASSERT_OK(rollcon_contact_set_progress(contact, read_event, &watcher));
    EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_CANCELLED);
    EXPECT_EQ(watcher.calls, stop_after);
    ASSERT_OK(rollcon_contact_set_progress(contact, nullptr, nullptr));
    EXPECT_OK(rollcon_contact_solve(contact));
  }
}

TEST_F(callbacks, cancel_request_from_inside_stops_the_solve) {
  ASSERT_OK(rollcon_contact_set_progress(contact, request_cancel_from_inside, &watcher));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_CANCELLED);
  EXPECT_EQ(watcher.calls, 1);
  ASSERT_OK(rollcon_contact_set_progress(contact, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_solve(contact));
}

TEST_F(callbacks, the_contact_is_busy_for_its_own_callback) {
  ASSERT_OK(rollcon_contact_set_progress(contact, call_back_into_the_library, &watcher));
  EXPECT_OK(rollcon_contact_solve(contact));
  ASSERT_EQ(watcher.statuses.size(), 5U);
  for (const std::int32_t status : watcher.statuses) EXPECT_EQ(status, ROLLCON_ERR_BUSY);
  EXPECT_NE(error().find("in use"), std::string::npos) << error();
}

TEST_F(callbacks, exceptions_do_not_leave_the_library) {
  ASSERT_OK(rollcon_contact_set_progress(contact, throw_from_inside, nullptr));
  EXPECT_FAILS(rollcon_contact_solve(contact), INTERNAL, "a host in C++ that throws");
  ASSERT_OK(rollcon_contact_set_progress(contact, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_solve(contact));
}

TEST_F(callbacks, release_inside_a_solve_waits_for_its_end) {
  ASSERT_OK(rollcon_contact_set_progress(contact, release_from_inside, &watcher));
  EXPECT_OK(rollcon_contact_solve(contact));
  EXPECT_GT(watcher.calls, 1);
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_ERR_HANDLE);
}

TEST_F(callbacks, log_gets_failures_and_obeys_its_level) {
  Log log;
  ASSERT_OK(rollcon_context_set_log(context, ROLLCON_LOG_ERROR, keep_line, &log));
  EXPECT_LT(rollcon_contact_set_rolling(contact, -1), 0);
  ASSERT_EQ(log.lines.size(), 1U);
  EXPECT_EQ(log.levels[0], ROLLCON_LOG_ERROR);
  EXPECT_EQ(log.lines[0], error());
  ASSERT_OK(rollcon_context_set_log(context, 0, keep_line, &log));
  EXPECT_LT(rollcon_contact_set_rolling(contact, -1), 0);
  ASSERT_OK(rollcon_context_set_log(context, ROLLCON_LOG_DEBUG, nullptr, nullptr));
  EXPECT_LT(rollcon_contact_set_rolling(contact, -1), 0);
  EXPECT_EQ(log.lines.size(), 1U);
}

class threads : public callbacks {};

TEST_F(threads, second_thread_gets_busy_and_may_cancel) {
  ASSERT_OK(rollcon_contact_set_progress(contact, wait_inside, &watcher));
  std::int32_t solved = -1000;
  std::thread solver([&] { solved = rollcon_contact_solve(contact); });
  while (!watcher.inside.load()) std::this_thread::yield();
  with_each_contact_call(contact, [](const char* name, bool at_any_time, std::int32_t status) {
    if (!at_any_time) {
      EXPECT_EQ(status, ROLLCON_ERR_BUSY) << name;
    }
  });
  rollcon_contact_release(contact);
  EXPECT_OK(rollcon_contact_request_cancel(contact));
  watcher.leave.store(true);
  solver.join();
  EXPECT_EQ(solved, ROLLCON_CANCELLED);
  ASSERT_OK(rollcon_contact_set_progress(contact, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_solve(contact));
}

TEST_F(threads, one_prepared_body_serves_contacts_in_many_threads) {
  const auto make = [&](rollcon_context* own) {
    rollcon_contact* c = nullptr;
    EXPECT_OK(rollcon_contact_create(own, sphere, plane, &c));
    give_scene(c, frame);
    return c;
  };
  force_in_many_threads(4, make, 1e-9);
}

TEST_F(threads, handles_may_come_and_go_in_many_threads) {
  std::vector<std::thread> pool;
  std::atomic<int> failures{0};
  for (int i = 0; i < 4; ++i) {
    pool.emplace_back([&] {
      for (int k = 0; k < 300; ++k) {
        rollcon_context* own = nullptr;
        rollcon_body* body = nullptr;
        rollcon_contact* c = nullptr;
        if (rollcon_context_create(ROLLCON_ABI, &own) || rollcon_body_create(own, ROLLCON_BODY_RIGID, &body) ||
            rollcon_body_retain(sphere) || rollcon_contact_create(own, sphere, body, &c))
          ++failures;
        rollcon_context_release(own);
        rollcon_body_release(body);
        rollcon_body_release(sphere);
        rollcon_contact_release(c);
        if (rollcon_contact_reset(c) != ROLLCON_ERR_HANDLE) ++failures;
      }
    });
  }
  for (std::thread& t : pool) t.join();
  EXPECT_EQ(failures.load(), 0);
}
