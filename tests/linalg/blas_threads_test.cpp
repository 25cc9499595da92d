/// Tests that each of the scopes of BLAS threads within each other has its own number, and that the host's comes back.

#include "linalg/blas_threads.hpp"

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
