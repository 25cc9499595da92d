/// Tests that neither order nor threads change a bit of lists of load cases; callbacks, cancelling.

#include <csignal>
#include <filesystem>
#include <fstream>

#include "solve_many_fixture.hpp"

using namespace capi_test;

class solve_many_threads : public CaseLists {};

TEST_F(solve_many_threads, threads_and_order_change_no_bit) {
  for (const std::vector<double>& values : {grid(), scattered(150)}) {
    const std::size_t cases = values.size() / 3;
    const Table one = table(three, values, 1);
    for (const std::int32_t threads : {2, 3, 5})
      EXPECT_EQ(differences(table(three, values, threads), one, in_order(cases)), 0) << threads;
    std::vector<std::size_t> at = in_order(cases);
    std::shuffle(at.begin(), at.end(), std::mt19937(3));
    std::vector<double> shuffled;
    for (const std::size_t i : at)
      shuffled.insert(shuffled.end(), values.begin() + 3 * static_cast<std::ptrdiff_t>(i),
                      values.begin() + 3 * static_cast<std::ptrdiff_t>(i + 1));
    EXPECT_EQ(differences(table(three, shuffled, 3), one, at), 0);
    // An earlier solve does not matter, either.
    ASSERT_OK(rollcon_contact_set_creep(contact, -1e-3, 1e-3, 1e-3));
    ASSERT_GE(rollcon_contact_solve(contact), 0);
    ASSERT_OK(rollcon_contact_set_creep(contact, 1e-3, 0, 0));
    EXPECT_EQ(differences(table(three, values, 2), one, in_order(cases)), 0);
    // The order of the parameters is the caller's.
    const std::vector<std::int32_t> turned{ROLLCON_SPIN, ROLLCON_LATERAL, ROLLCON_NORMAL};
    std::vector<double> rows;
    for (std::size_t i = 0; i < cases; ++i)
      rows.insert(rows.end(), {values[3 * i + 2], values[3 * i], values[3 * i + 1]});
    const Table other = table(turned, rows, 2);
    EXPECT_TRUE(same(other.force.data(), one.force.data(), 3 * cases));
    double iterations = 0;
    for (std::size_t i = 0; i < cases; ++i) iterations += one.statistics[name_count * i];
    std::printf("%zu cases: the same bits with 1, 2, 3, 5 threads and shuffled; %.2f iterations per case\n", cases,
                iterations / static_cast<double>(cases));
  }
}

TEST_F(solve_many_threads, workers_share_the_operators) {
  // The frame is large enough for its operators to count: 41 x 41 nodes.
  const SquareFrame wide(40, 4.5);
  ASSERT_OK(set_nodes(wide));
  ASSERT_OK(add_elements(wide));
  ASSERT_OK(rollcon_contact_set_str(contact, "operators", "dense"));
  const auto peak = [&](std::int32_t threads) {
    double bytes = 0;
    std::vector<double> force;
    EXPECT_OK(rollcon_context_set_threads(context, threads));
    EXPECT_OK(forces(three, 60, grid(), force));
    EXPECT_OK(rollcon_contact_solve(contact));
    EXPECT_OK(rollcon_contact_get_stat(contact, "peak_bytes", &bytes));
    return bytes;
  };
  const double one = peak(1), four = peak(4);
  const double blocks = 5.0 * 8 * std::pow(41.0, 4);  // dense blocks of one copy
  std::printf("41 x 41 nodes: %.1f MB with 1 thread, %.1f MB with 4 (one copy of the operators: at most %.1f MB)\n",
              one / 1e6, four / 1e6, blocks / 1e6);
  EXPECT_GT(four, one);
  EXPECT_LT(four - one, 0.3 * one);
}

TEST_F(solve_many_threads, threads_with_operators_that_are_not_formed_give_the_same) {
  if (!rollcon_has_feature("fftw")) GTEST_SKIP() << "this build has no FFT";
  const std::vector<double> values = scattered(24);
  const Table dense = table(three, values, 2);
  ASSERT_OK(rollcon_contact_set_str(contact, "operators", "fft"));
  const Table one = table(three, values, 1);
  EXPECT_EQ(differences(table(three, values, 3), one, in_order(24)), 0);
  double worst = 0;
  for (std::size_t i = 0; i < one.force.size(); ++i)
    worst = std::max(worst, std::abs(one.force[i] - dense.force[i]) / load);
  std::printf("by FFT: off dense operators by %.1e (bound 1e-5, their accuracy is 1e-6)\n", worst);
  EXPECT_LT(worst, 1e-5);
}

namespace {

struct Watcher {
  rollcon_contact* contact = nullptr;
  std::int64_t calls = 0, cases = 0, stop_after = 1LL << 60;
  std::thread::id thread = std::this_thread::get_id();
  bool elsewhere = false, by_request = false;
};

std::int32_t watch(const rollcon_event* event, void* user) {
  auto& w = *static_cast<Watcher*>(user);
  std::int64_t phase = 0, iteration = 0;
  EXPECT_OK(rollcon_event_get_int(event, ROLLCON_EVENT_PHASE, &phase));
  EXPECT_OK(rollcon_event_get_int(event, ROLLCON_EVENT_ITERATION, &iteration));
  w.elsewhere = w.elsewhere || std::this_thread::get_id() != w.thread;
  if (phase == ROLLCON_PHASE_CASES) {
    EXPECT_GE(iteration, w.cases);
    w.cases = iteration;
  }
  EXPECT_EQ(rollcon_contact_solve(w.contact), ROLLCON_ERR_BUSY);
  if (++w.calls < w.stop_after) return 0;
  if (!w.by_request) return 1;
  EXPECT_OK(rollcon_contact_request_cancel(w.contact));
  return 0;
}

}  // namespace

TEST_F(solve_many_threads, callbacks_and_cancelling_work_with_threads) {
  const std::vector<double> values = scattered(150);
  for (const std::int32_t threads : {1, 3}) {
    const Table whole = table(three, values, threads);
    for (const bool by_request : {false, true})
      for (const std::int64_t stop_after : {1LL, 40LL, 1LL << 60}) {
        Watcher w;
        w.contact = contact;
        w.stop_after = stop_after;
        w.by_request = by_request;
        ASSERT_OK(rollcon_contact_set_progress(contact, watch, &w));
        const bool stops = stop_after < 1000;
        const Table t = table(three, values, threads, stops ? ROLLCON_CANCELLED : ROLLCON_OK);
        ASSERT_OK(rollcon_contact_set_progress(contact, nullptr, nullptr));
        EXPECT_FALSE(w.elsewhere) << "callbacks run in the caller's thread";
        EXPECT_GE(w.calls, std::min<std::int64_t>(stop_after, 50));
        int solved = 0;
        for (std::size_t i = 0; i < 150; ++i) {
          if (t.status[i] == ROLLCON_CANCELLED) {
            EXPECT_TRUE(std::isnan(t.force[3 * i]));
            continue;
          }
          ++solved;
          EXPECT_TRUE(same(&t.force[3 * i], &whole.force[3 * i], 3));
        }
        EXPECT_EQ(solved == 150, !stops) << solved;
      }
  }
  EXPECT_OK(rollcon_contact_solve(contact));
}

namespace {

/// Counts threads of this process that would take an alarm of the host.
int threads_open_to_alarms() {
  int open = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream status(task.path() / "status");
    for (std::string line; std::getline(status, line);)
      if (line.rfind("SigBlk:", 0) == 0) open += !(std::stoull(line.substr(7), nullptr, 16) >> (SIGALRM - 1) & 1);
  }
  return open;
}

}  // namespace

TEST_F(solve_many_threads, signals_are_left_to_the_host) {
  if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "no /proc";
  const std::vector<double> values = scattered(150);
  table(three, values, 4);  // starts the threads that libraries keep
  int most = 0;
  ASSERT_OK(rollcon_contact_set_progress(
      contact,
      [](const rollcon_event*, void* user) {
        int& open = *static_cast<int*>(user);
        open = std::max(open, threads_open_to_alarms());
        return 0;
      },
      &most));
  const int before = threads_open_to_alarms();
  table(three, values, 4);
  ASSERT_OK(rollcon_contact_set_progress(contact, nullptr, nullptr));
  std::printf("threads open to alarms: %d before, at most %d during the list\n", before, most);
  EXPECT_LE(most, before);
}

TEST_F(solve_many_threads, several_contacts_at_once_in_threads_of_their_own) {
  const std::vector<double> values = grid();
  std::vector<double> right;
  ASSERT_OK(forces(three, 60, values, right));
  std::vector<std::vector<double>> force(2, std::vector<double>(180));
  std::vector<std::thread> callers;
  for (std::size_t k = 0; k < 2; ++k)
    callers.emplace_back([&, k] {
      rollcon_context* own = nullptr;
      rollcon_contact* c = nullptr;
      EXPECT_OK(rollcon_context_create(ROLLCON_ABI, &own));
      EXPECT_OK(rollcon_context_set_threads(own, 2));
      EXPECT_OK(rollcon_contact_create(own, sphere, plane, &c));
      give_scene(c, frame);
      EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
      EXPECT_OK(rollcon_contact_solve_many(c, names_of(three).c_str(), 60, values.data(), "force", 3, force[k].data(),
                                           nullptr, nullptr));
      rollcon_contact_release(c);
      rollcon_context_release(own);
    });
  for (std::thread& t : callers) t.join();
  // The number of BLAS threads belongs to the process, so rounding differs.
  double worst = 0;
  for (const auto& f : force)
    for (std::size_t i = 0; i < f.size(); ++i) worst = std::max(worst, std::abs(f[i] - right[i]) / load);
  std::printf("two callers with two threads each: off by %.1e (bound 1e-12)\n", worst);
  EXPECT_LT(worst, 1e-12);
}
