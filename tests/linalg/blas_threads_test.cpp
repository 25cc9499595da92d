/// Tests that each of the scopes of BLAS threads within each other has its own number, and that the host's comes back.

#include "linalg/blas_threads.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "linalg/dense.hpp"
#include "support/error.hpp"
#include "support/testing.hpp"

extern "C" {
__attribute__((weak)) void openblas_set_num_threads(int threads);
__attribute__((weak)) int openblas_get_num_threads(void);
}

using rollcon::BlasThreads;

TEST(blas_threads, scopes_within_scopes_have_their_own_number) {
  if (!openblas_get_num_threads || !openblas_set_num_threads) GTEST_SKIP() << "another BLAS";
  const int hosts = openblas_get_num_threads();
  openblas_set_num_threads(1);
  {
    const BlasThreads two(2);
    EXPECT_EQ(openblas_get_num_threads(), 2);
    {
      const BlasThreads one(1);
      EXPECT_EQ(openblas_get_num_threads(), 1);
      const BlasThreads again(2);
      EXPECT_EQ(openblas_get_num_threads(), 2);
    }
    EXPECT_EQ(openblas_get_num_threads(), 2);
  }
  EXPECT_EQ(openblas_get_num_threads(), 1);
  openblas_set_num_threads(hosts);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

void leave_room(double megabytes) {
  double pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const auto most = static_cast<rlim_t>(pages * static_cast<double>(sysconf(_SC_PAGESIZE)) + 1e6 * megabytes);
  const rlimit limit{most, RLIM_INFINITY};
  setrlimit(RLIMIT_AS, &limit);
}

}  // namespace

// A child has its parent's buffers but not the threads that OpenBLAS keeps: made anew, they left none to the caller.
TEST(blas_threads, children_find_room_for_threads_and_callers_or_say_so) {
  if (!openblas_get_num_threads || !openblas_set_num_threads) GTEST_SKIP() << "another BLAS";
  constexpr std::int64_t size = 2000;
  const std::vector<double> matrix(static_cast<std::size_t>(size * size), 1.0), x(static_cast<std::size_t>(size), 1.0);
  std::vector<double> y(static_cast<std::size_t>(size));
  const int hosts = openblas_get_num_threads();
  openblas_set_num_threads(2);
  constexpr int solved = 0, refused = 1;
  int count[2] = {};
  for (const double megabytes : {50, 150, 200, 300, 400}) {
    const pid_t child = fork();
    if (child == 0) {
      alarm(30);
      leave_room(megabytes);
      try {
        const BlasThreads two(2);
        leave_room(1);
        rollcon::multiply(matrix.data(), size, size, x.data(), 0, y.data());
      } catch (const rollcon::Error& error) {
        _exit(refused);
      }
      _exit(y.back() == size ? solved : 2);
    }
    int status = -1;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) <= refused) << megabytes << " MB: status " << status;
    ++count[WEXITSTATUS(status)];
  }
  openblas_set_num_threads(hosts);
  EXPECT_GT(count[solved], 0);
}

#endif
