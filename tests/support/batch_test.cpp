/// Tests that an answer of a list that throws leaves the others alone, and that one order holds for all statuses.

#include "support/batch.hpp"

#include <stdexcept>

#include "support/parallel.hpp"
#include "support/testing.hpp"

using namespace rollcon;

TEST(batch, what_an_answer_throws_is_its_own) {
  Context context;
  std::vector<std::string> told;
  context.set_log(
      2,
      [](std::int32_t, const char* text, void* user) { static_cast<std::vector<std::string>*>(user)->push_back(text); },
      &told);
  for (const int threads : {1, 3}) {
    told.clear();
    Batch batch(8, context);
    std::atomic<int> whole{0};
    parallel_for(7, 1, threads, [&](std::int64_t i, int) {
      whole += batch.take(i, [i] {
        if (i == 1) fail(Status::err_load, "too much");
        if (i == 2) throw std::bad_alloc();
        if (i == 3) throw std::runtime_error("odd");
        if (i == 4) throw 4;
        if (i == 5) throw Cancelled{};
        return i == 6 ? Status::coarse : Status::ok;
      });
    });
    EXPECT_EQ(whole.load(), 2);
    batch.repeat(7, 6);
    std::int32_t status[8];
    EXPECT_EQ(batch.finish("case", status), Status::cancelled);
    const std::int32_t expected[] = {0, -12, -9, -99, -99, 3, 5, 5};
    for (int i = 0; i < 8; ++i) EXPECT_EQ(status[i], expected[i]) << i;
    ASSERT_EQ(told.size(), 4U) << threads;
    EXPECT_EQ(told[0], "case 1 (counting from 0): too much");
    EXPECT_EQ(told[1].find("case 2 (counting from 0): out of memory"), 0U) << told[1];
    EXPECT_EQ(told[2], "case 3 (counting from 0): odd");
  }
}

TEST(batch, the_worse_status_goes_before) {
  const Status order[] = {Status::cancelled,  Status::not_converged, Status::derailed,
                          Status::too_deep,   Status::coarse,        Status::rim_contact,
                          Status::inaccurate, Status::no_contact,    Status::ok};
  for (std::size_t i = 0; i < std::size(order); ++i)
    for (std::size_t j = 0; j < std::size(order); ++j) EXPECT_EQ(worse(order[i], order[j]), order[std::min(i, j)]);
  EXPECT_EQ(worse(Status::err_load, Status::coarse), Status::not_converged);
  EXPECT_EQ(worse(Status::cancelled, Status::err_memory), Status::cancelled);
  EXPECT_EQ(Batch(0, Context()).finish("case", nullptr), Status::ok);
}
