// Tests what is told of a BLAS whose kernels factorise slowly.

#include "linalg/blas_kernels.hpp"

#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr const char* debian = "OpenBLAS 0.3.21 DYNAMIC_ARCH NO_AFFINITY Cooperlake MAX_THREADS=64";

TEST(BlasKernels, slow_ones_are_told_by_name_with_the_remedy) {
  const std::string text = slow_factorization({"Cooperlake", debian}, 4501);
  std::printf("%s\n", text.c_str());
  EXPECT_EQ(text.find("OpenBLAS 0.3.21 uses"), 0U);
  EXPECT_NE(text.find("OPENBLAS_CORETYPE=SKYLAKEX"), std::string::npos);
  EXPECT_NE(slow_factorization({"COOPERLAKE", ""}, 10000), "");
  EXPECT_NE(slow_factorization({"cooperlake", "OpenBLAS"}, 10000), "");
}

TEST(BlasKernels, others_small_systems_and_other_libraries_are_not_mentioned) {
  EXPECT_EQ(slow_factorization({"Cooperlake", debian}, 4500), "");
  for (const char* core : {"Haswell", "SkylakeX", "Zen", "neoversen1"})
    EXPECT_EQ(slow_factorization({core, debian}, 10000), "") << core;
  EXPECT_EQ(slow_factorization({}, 10000), "");
}

TEST(BlasKernels, of_this_process_are_named_or_unknown) {
  const BlasKernels own = blas_kernels();
  std::printf("core '%s', config '%s'\n", own.core.c_str(), own.config.c_str());
  EXPECT_EQ(own.core.empty(), own.config.empty());
}

}  // namespace
}  // namespace rollcon
