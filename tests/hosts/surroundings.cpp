/// Tests hosts that changed what a process or a thread can change: floating-point traps, flushed denormals, rounding,
/// interrupting signals. Flows end with the same bits, and the host's settings are unchanged.

#include <fenv.h>
#include <signal.h>
#include <sys/time.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "flows.hpp"

namespace {

using namespace hosts;

constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW;

volatile sig_atomic_t interruptions = 0;

void interrupt(int) {
  interruptions = interruptions + 1;
}

/// Sends a signal every half millisecond, which interrupts system calls.
void set_timer(bool on) {
  struct sigaction action {};
  action.sa_handler = interrupt;
  sigaction(SIGALRM, &action, nullptr);
  const itimerval every{{0, on ? 500 : 0}, {0, on ? 500 : 0}};
  setitimer(ITIMER_REAL, &every, nullptr);
}

struct Surrounding {
  const char* name;
  std::function<void()> enter;
  std::function<bool()> intact;
  std::function<void()> leave;
};

std::vector<Surrounding> surroundings() {
  std::vector<Surrounding> all;
  all.push_back({"traps", [] { feenableexcept(trapped); }, [] { return fegetexcept() == trapped; },
                 [] { fedisableexcept(FE_ALL_EXCEPT); }});
  for (const auto& [name, mode] : {std::pair{"rounding up", FE_UPWARD},
                                   {"rounding down", FE_DOWNWARD},
                                   {"rounding to zero", FE_TOWARDZERO},
                                   {"rounding to nearest", FE_TONEAREST}})
    all.push_back({name, [m = mode] { fesetround(m); }, [m = mode] { return fegetround() == m; },
                   [] { fesetround(FE_TONEAREST); }});
#ifdef __SSE2__
  constexpr unsigned flush = 0x8040;  // flushes to zero, and denormals are zero
  all.push_back({"flushed denormals", [] { _mm_setcsr(_mm_getcsr() | flush); },
                 [] { return (_mm_getcsr() & flush) == flush; }, [] { _mm_setcsr(_mm_getcsr() & ~flush); }});
#endif
  all.push_back({"signals", [] { set_timer(true); }, [] { return true; }, [] { set_timer(false); }});
  return all;
}

/// Makes each call in the surrounding and looks at it afterwards. The host's own arithmetic is done outside, because it
/// prepares the same inputs.
class Checking final : public Caller {
 public:
  explicit Checking(const Surrounding& s) : surrounding_(s) {}
  std::string changed_by;

 private:
  std::int32_t make(const char* name, const std::function<std::int32_t()>& function) override {
    constexpr int hosts_errno = 4321;
    surrounding_.enter();
    errno = hosts_errno;
    const std::int32_t status = function();
    const int now = errno;
    if (!surrounding_.intact()) changed_by = name;
    surrounding_.leave();
    if (now != hosts_errno) changed_by = std::string(name) + " (errno)";
    return status;
  }
  const Surrounding& surrounding_;
};

struct Handlers {
  std::array<struct sigaction, 32> action{};
  Handlers() {
    for (int s = 1; s < 32; ++s) sigaction(s, nullptr, &action[static_cast<std::size_t>(s)]);
  }
  static constexpr int restorer = 0x04000000;  // flag that glibc adds whenever one is set
  bool same(const Handlers& o, std::size_t s) const {
    return action[s].sa_handler == o.action[s].sa_handler &&
           ((action[s].sa_flags ^ o.action[s].sa_flags) & ~restorer) == 0;
  }
};

}  // namespace

int main() {
  Verdict verdict;
  set_timer(false);
  struct sigaction terminate {};
  terminate.sa_sigaction = [](int, siginfo_t*, void*) {};
  terminate.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGTERM, &terminate, nullptr);
  const Handlers before;
  for (const int threads : {1, 2})
    for (const Flow& flow : flows()) {
      Caller plain;
      plain.threads = threads;
      const std::vector<double> right = flow.run(plain);
      for (const Surrounding& s : surroundings()) {
        Checking call(s);
        call.threads = threads;
        std::vector<double> results;
        std::string thrown;
        try {
          results = flow.run(call);
        } catch (const std::exception& error) {
          thrown = error.what();
        }
        verdict.expect(thrown.empty(), "%s, %s: %s", flow.name, s.name, thrown.c_str());
        verdict.expect(call.changed_by.empty(), "%s: %s changed by %s", flow.name, s.name, call.changed_by.c_str());
        verdict.expect(same_bits(results, right), "%s, %d threads: other results with %s (by %.1e)", flow.name, threads,
                       s.name, difference(results, right));
      }
      std::printf("%s, %d threads: same bits in %zu surroundings\n", flow.name, threads, surroundings().size());
    }
  const Handlers after;
  for (std::size_t s = 1; s < 32; ++s) verdict.expect(after.same(before, s), "handler of signal %zu has changed", s);
  std::printf("interrupted %d times\n", static_cast<int>(interruptions));
  verdict.expect(interruptions > 0, "no signal came");
  return verdict.exit_code();
}
