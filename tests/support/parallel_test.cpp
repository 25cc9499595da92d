/// Tests loops on threads: every index once, exceptions, the environment in which they run.

#include "support/parallel.hpp"

#include <pthread.h>
#include <signal.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "support/context.hpp"
#include "support/fpenv.hpp"
#include "support/testing.hpp"

using rollcon::parallel_for;

TEST(parallel, every_index_is_worked_on_once) {
  for (const int threads : {0, 1, 2, 3, 7})
    for (const int chunk : {1, 4, 1000}) {
      for (const int count : {0, 1, 2, 5, 64, 1001}) {
        std::vector<int> times(static_cast<std::size_t>(count), 0);
        std::atomic<int> worst{0};
        parallel_for(count, chunk, threads, [&](std::int64_t i, int t) {
          ++times[static_cast<std::size_t>(i)];
          if (t >= std::max(threads, 1)) worst.store(t);
        });
        EXPECT_EQ(std::accumulate(times.begin(), times.end(), 0), count);
        for (const int n : times) EXPECT_EQ(n, 1);
        EXPECT_EQ(worst.load(), 0) << "a number of a thread that was not asked for";
      }
    }
}

TEST(parallel, threads_with_equal_numbers_do_not_meet) {
  std::array<std::atomic<int>, 4> inside{};
  std::atomic<int> met{0};
  parallel_for(2000, 1, 4, [&](std::int64_t, int t) {
    if (inside[static_cast<std::size_t>(t)].fetch_add(1) > 0) ++met;
    inside[static_cast<std::size_t>(t)].fetch_sub(1);
  });
  EXPECT_EQ(met.load(), 0);
}

TEST(parallel, loops_within_loops_start_no_threads) {
  std::atomic<int> inner{0}, elsewhere{0}, numbered{0};
  parallel_for(40, 1, 4, [&](std::int64_t, int) {
    const std::thread::id here = std::this_thread::get_id();
    EXPECT_TRUE(rollcon::in_threads());
    EXPECT_EQ(rollcon::Context().threads(), 1);
    parallel_for(20, 1, 4, [&](std::int64_t, int t) {
      std::this_thread::sleep_for(std::chrono::microseconds(50));
      ++inner;
      elsewhere += std::this_thread::get_id() != here;
      numbered += t != 0;
    });
  });
  EXPECT_EQ(inner.load(), 800);
  EXPECT_EQ(elsewhere.load(), 0) << "pieces of an inner loop by threads of its own";
  EXPECT_EQ(numbered.load(), 0);
  EXPECT_FALSE(rollcon::in_threads());
}

TEST(parallel, exceptions_come_out_of_any_thread_and_end_the_loop) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<int> calls{0};
    const auto work = [&](std::int64_t i, int) {
      ++calls;
      if (i == 10) throw std::runtime_error("at 10");
    };
    EXPECT_THROW(parallel_for(100000, 2, threads, work), std::runtime_error) << threads;
    EXPECT_LT(calls.load(), 100000) << threads;
  }
}

TEST(parallel, threads_compute_in_the_standard_environment_and_leave_signals_to_the_host) {
  std::atomic<int> wrong{0}, taken{0}, others{0};
  std::fesetround(FE_UPWARD);
  sigset_t before, after;
  pthread_sigmask(SIG_SETMASK, nullptr, &before);
  {
    const rollcon::QuietFloatingPoint quiet;
    parallel_for(100, 1, 4, [&](std::int64_t, int t) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));  // long enough for all threads to come to work
      if (std::fegetround() != FE_TONEAREST) ++wrong;
      if (t == 0) return;
      sigset_t mask;
      pthread_sigmask(SIG_SETMASK, nullptr, &mask);
      ++others;
      if (!sigismember(&mask, SIGALRM) || !sigismember(&mask, SIGINT)) ++taken;
      if (sigismember(&mask, SIGSEGV)) ++taken;
    });
  }
  pthread_sigmask(SIG_SETMASK, nullptr, &after);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(wrong.load(), 0);
  EXPECT_EQ(taken.load(), 0);
  EXPECT_EQ(sigismember(&before, SIGALRM), sigismember(&after, SIGALRM));
  std::printf("%d of 100 pieces by other threads than the caller\n", others.load());
  EXPECT_GT(others.load(), 0);
}
