// Tests that whatever floating-point environment a host has, calls compute in the ordinary one and leave the host's
// behind, flags included.

#include "support/fpenv.hpp"

#include <fenv.h>

#include "support/testing.hpp"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace rollcon {
namespace {

struct Host {
  const char* name;
  std::function<void()> set;
};

volatile double zero = 0, one = 1, three = 3;
volatile long double long_zero = 0, long_one = 1, long_three = 3;

std::vector<Host> hosts() {
  std::vector<Host> all{
      {"plain", [] {}},
      {"upward", [] { fesetround(FE_UPWARD); }},
      {"towards zero", [] { fesetround(FE_TOWARDZERO); }},
      {"flags", [] { feraiseexcept(FE_INEXACT | FE_OVERFLOW); }},
      {"a flag of long double", [] { long_zero = long_one / long_three - long_one / long_three; }},
      {"upward and flags",
       [] {
         fesetround(FE_UPWARD);
         feraiseexcept(FE_UNDERFLOW);
       }},
  };
#ifdef __GLIBC__
  all.push_back({"traps", [] { feenableexcept(FE_DIVBYZERO | FE_INVALID); }});
#endif
#ifdef __SSE__
  all.push_back({"subnormals flushed", [] { _mm_setcsr(_mm_getcsr() | 0x8040); }});
#endif
  return all;
}

/// Reads modes and flags that can be asked for.
struct Seen {
  int round = fegetround(), flags = fetestexcept(FE_ALL_EXCEPT), traps = 0;
  unsigned control = 0;
  Seen() {
#ifdef __GLIBC__
    traps = fegetexcept();
#endif
#ifdef __SSE__
    control = _mm_getcsr();
#endif
  }
  bool operator==(const Seen&) const = default;
};

/// Raises every flag, in both units.
void compute() {
  volatile double x = one / zero;
  x = zero / zero;
  x = std::numeric_limits<double>::max() * three;
  volatile long double y = long_one / long_three;
  y = long_one / (long_zero * 0);
  (void)x;
  (void)y;
}

void expect_ordinary(const char* host) {
  EXPECT_EQ(fegetround(), FE_TONEAREST) << host;
#ifdef __GLIBC__
  EXPECT_EQ(fegetexcept(), 0) << host;
#endif
  volatile double least = std::numeric_limits<double>::denorm_min();
  EXPECT_GT(least * three, 0) << host;
  compute();  // this would trap
}

TEST(QuietFloatingPoint, computes_in_the_ordinary_environment_and_leaves_the_hosts) {
  for (const Host& host : hosts()) {
    fenv_t mine;
    fegetenv(&mine);
    fesetenv(FE_DFL_ENV);
    host.set();
    const Seen before;
    {
      const QuietFloatingPoint quiet;
      expect_ordinary(host.name);
      {
        const QuietFloatingPoint again;
        expect_ordinary(host.name);
      }
      expect_ordinary(host.name);
    }
    const Seen after;
    fesetenv(&mine);
    EXPECT_TRUE(after == before) << host.name << ": rounding " << before.round << " " << after.round << ", flags "
                                 << before.flags << " " << after.flags << ", traps " << before.traps << " "
                                 << after.traps;
  }
}

TEST(HostFloatingPoint, has_what_the_host_had_and_forgets_what_it_does_there) {
  for (const Host& host : hosts()) {
    fenv_t mine;
    fegetenv(&mine);
    fesetenv(FE_DFL_ENV);
    host.set();
    const Seen before;
    Seen within;
    {
      const QuietFloatingPoint quiet;
      compute();
      {
        const HostFloatingPoint callback;
        within = Seen();
        fesetround(FE_DOWNWARD);
      }
      expect_ordinary(host.name);
    }
    const Seen after;
    fesetenv(&mine);
    EXPECT_TRUE(within == before) << host.name << ": rounding " << before.round << " " << within.round << ", flags "
                                  << before.flags << " " << within.flags;
    EXPECT_TRUE(after == before) << host.name;
  }
}

}  // namespace
}  // namespace rollcon
