#include "support/parallel.hpp"

#include <pthread.h>
#include <signal.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

#include "support/fpenv.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

// A host that limits its stacks (ulimit -s) would limit those of its threads by that, so the size is given. Only the
// touched part of it becomes memory.
constexpr std::size_t stack_bytes = std::size_t{8} << 20U;

thread_local bool inside = false;

struct Team {
  void (*work)(void*, int);
  void* data;
  std::mutex mutex{};
  std::condition_variable ended{};
  int others = 0;  ///< threads at work beside the caller
  std::exception_ptr failure{};

  template <class Do>
  void attempt(const Do& what) noexcept {
    try {
      what();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  }
  /// Waits for the others; the host hears that they work, and may stop them.
  void wait() {
    Interrupt* host = Interrupt::current();
    std::unique_lock lock(mutex);
    while (host && !ended.wait_for(lock, std::chrono::milliseconds(50), [this] { return others == 0; })) {
      lock.unlock();
      attempt([host] { host->check(); });
      lock.lock();
    }
  }
};

struct Member {
  Team* team;
  int number;
  pthread_t handle;
};

void* start(void* member) {
  const QuietFloatingPoint quiet;
  const auto& m = *static_cast<const Member*>(member);
  inside = true;
  m.team->attempt([&] { m.team->work(m.team->data, m.number); });
  const std::lock_guard lock(m.team->mutex);
  --m.team->others;
  m.team->ended.notify_one();
  return nullptr;
}

/// Leaves signals to the host: while it lives, threads that this one makes take none but those of their own faults.
class SignalsForTheHost {
 public:
  SignalsForTheHost() {
    sigset_t all;
    sigfillset(&all);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) sigdelset(&all, fault);
    pthread_sigmask(SIG_SETMASK, &all, &former_);
  }
  ~SignalsForTheHost() { pthread_sigmask(SIG_SETMASK, &former_, nullptr); }
  SignalsForTheHost(const SignalsForTheHost&) = delete;
  SignalsForTheHost& operator=(const SignalsForTheHost&) = delete;

 private:
  sigset_t former_;
};

/// Returns false if no thread can be had.
bool make_thread(Member& member) {
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return false;
  pthread_attr_setstacksize(&attributes, stack_bytes);
  const bool made = pthread_create(&member.handle, &attributes, start, &member) == 0;
  pthread_attr_destroy(&attributes);
  return made;
}

}  // namespace

bool in_threads() {
  return inside;
}

void run_threads(int threads, void (*work)(void*, int), void* data) {
  Team team{.work = work, .data = data};
  std::vector<Member> member;
  if (threads > 1) member.reserve(static_cast<std::size_t>(threads) - 1);
  {
    const SignalsForTheHost blocked;
    for (int t = 1; t < threads; ++t) {
      member.push_back({&team, t, {}});
      const std::lock_guard lock(team.mutex);
      if (make_thread(member.back())) {
        ++team.others;
        continue;
      }
      member.pop_back();
      break;
    }
  }
  const bool before = std::exchange(inside, inside || !member.empty());
  team.attempt([&] { work(data, 0); });
  inside = before;
  team.wait();
  for (const Member& m : member) pthread_join(m.handle, nullptr);
  if (team.failure) std::rethrow_exception(team.failure);
}

}  // namespace rollcon
