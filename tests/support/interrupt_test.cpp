/// Tests work that its caller may stop.

#include "support/interrupt.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/parallel.hpp"

namespace {

using namespace rollcon;

class StopAt final : public Interrupt {
 public:
  bool wanted() const override { return stop.load(); }
  std::atomic<bool> stop{false};
  int told = 0;

 private:
  void tell() override { ++told; }
};

TEST(interrupt, loops_end_before_their_next_chunk) {
  for (const int threads : {1, 2, 4}) {
    StopAt interrupt;
    std::atomic<int> done{0};
    const auto work = [&](std::int64_t i, int) {
      ++done;
      if (i == 10) interrupt.stop.store(true);
    };
    EXPECT_THROW(parallel_for(1000000, 2, threads, work), Cancelled) << threads;
    EXPECT_LT(done.load(), 1000000) << threads;
    if (threads == 1) {
      EXPECT_EQ(done.load(), 12);
    }
    EXPECT_THROW(check_interrupt(), Cancelled);
  }
  EXPECT_EQ(Interrupt::current(), nullptr);
  EXPECT_NO_THROW(check_interrupt());
}

TEST(interrupt, the_host_is_asked_while_its_thread_waits_for_others) {
  class Impatient final : public Interrupt {
   public:
    bool wanted() const override { return stop.load(); }
    std::atomic<bool> stop{false};
    int told = 0;

   private:
    void tell() override { stop.store(++told == 2); }
  } interrupt;
  std::atomic<int> others{0};
  const auto work = [&](std::int64_t, int t) {
    if (t == 0) return;
    ++others;
    while (!interrupt.stop.load()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  // The second thread may come late, so the caller leaves something for it.
  const auto patient = [&](std::int64_t i, int t) {
    while (t == 0 && others.load() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    work(i, t);
  };
  EXPECT_THROW(parallel_for(2, 1, 2, patient), Cancelled);
  EXPECT_EQ(interrupt.told, 2);
  EXPECT_EQ(others.load(), 1);
}

TEST(interrupt, the_one_before_is_asked_again) {
  StopAt outer;
  {
    const StopAt inner;
    EXPECT_EQ(Interrupt::current(), &inner);
    outer.stop.store(true);
    EXPECT_NO_THROW(check_interrupt());
  }
  EXPECT_EQ(Interrupt::current(), &outer);
  EXPECT_THROW(check_interrupt(), Cancelled);
}

TEST(interrupt, the_host_is_told_by_its_own_thread_and_not_at_every_question) {
  StopAt interrupt;
  for (int k = 0; k < 1000; ++k) interrupt.check(false);
  EXPECT_EQ(interrupt.told, 0);
  int questions = 0;
  while (interrupt.told < 2) check_interrupt(), ++questions;
  std::printf("told twice in %d questions (bound: more than 20)\n", questions);
  EXPECT_GT(questions, 20);
}

}  // namespace
