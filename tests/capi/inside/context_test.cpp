/// Tests the thread budget and the log of a context.

#include "support/context.hpp"

#include "support/error.hpp"
#include "support/testing.hpp"

#ifdef _OPENMP
#include <omp.h>

TEST(context_threads, budget_counts_outside_and_one_thread_inside_parallel_regions) {
  rollcon::Context context;
  EXPECT_EQ(context.threads(), omp_get_max_threads());
  context.set_threads(3);
  EXPECT_EQ(context.threads(), 3);
  int inside[2] = {0, 0};
#pragma omp parallel num_threads(2)
  inside[omp_get_thread_num()] = context.threads();
  EXPECT_EQ(inside[0], 1);
  EXPECT_LE(inside[1], 1);
  EXPECT_THROW(context.set_threads(-1), rollcon::Error);
  EXPECT_EQ(context.threads(), 3);
}
#endif

TEST(context_log, lines_are_formatted_and_long_ones_cut) {
  rollcon::Context context;
  std::string line;
  context.set_log(
      static_cast<std::int32_t>(rollcon::LogLevel::info),
      [](std::int32_t, const char* message, void* user) { *static_cast<std::string*>(user) = message; }, &line);
  context.log(rollcon::LogLevel::info, "%d nodes", 7);
  EXPECT_EQ(line, "7 nodes");
  context.log(rollcon::LogLevel::debug, "not wanted");
  EXPECT_EQ(line, "7 nodes");
  context.log(rollcon::LogLevel::warning, "%s", std::string(5000, 'x').c_str());
  EXPECT_EQ(line, std::string(1023, 'x'));
}
