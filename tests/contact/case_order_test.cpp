/// Tests the order in which lists of cases are solved.

#include "contact/cases/case_order.hpp"

#include <random>

#include "support/testing.hpp"

using namespace rollcon;

namespace {

double distance(const std::vector<double>& value, std::int64_t columns, std::int64_t a, std::int64_t b) {
  double sum = 0;
  for (std::int64_t c = 0; c < columns; ++c) {
    const double d =
        value[static_cast<std::size_t>(a * columns + c)] - value[static_cast<std::size_t>(b * columns + c)];
    sum += d * d;
  }
  return std::sqrt(sum);
}

double mean_step(const CaseOrder& order, const std::vector<double>& value, std::int64_t columns) {
  double sum = 0;
  for (std::size_t i = 1; i < order.solved.size(); ++i)
    sum += distance(value, columns, order.solved[i - 1], order.solved[i]);
  return sum / static_cast<double>(order.solved.size() - 1);
}

std::vector<double> row(const std::vector<double>& value, std::int64_t columns, std::int64_t i) {
  const auto first = value.begin() + i * columns;
  return {first, first + columns};
}

}  // namespace

TEST(case_order, tables_are_walked_one_step_at_a_time) {
  std::vector<double> value;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 7; ++j)
      for (int k = 0; k < 4; ++k) value.insert(value.end(), {double(k), double(i), 3.0, double(j)});
  const std::int64_t priority[4] = {1, 2, 3, 0};
  const CaseOrder order = order_cases(140, 4, value.data(), priority);
  ASSERT_EQ(order.solved.size(), 140U);
  for (std::size_t i = 1; i < 140; ++i) EXPECT_EQ(distance(value, 4, order.solved[i - 1], order.solved[i]), 1) << i;
  // The first column changes least often.
  int changes = 0;
  for (std::size_t i = 1; i < 140; ++i)
    changes += row(value, 4, order.solved[i])[1] != row(value, 4, order.solved[i - 1])[1];
  EXPECT_EQ(changes, 4);
}

TEST(case_order, neighbours_of_scattered_cases_are_near) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr std::int64_t cases = 1000;
  for (const std::int64_t columns : {1, 2, 3, 4}) {
    std::vector<double> value(static_cast<std::size_t>(cases * columns));
    for (double& v : value) v = unit(generator);
    std::vector<std::int64_t> priority(static_cast<std::size_t>(columns));
    std::iota(priority.begin(), priority.end(), 0);
    const CaseOrder order = order_cases(cases, columns, value.data(), priority);
    CaseOrder as_listed = order;
    std::iota(as_listed.solved.begin(), as_listed.solved.end(), 0);
    const double step = mean_step(order, value, columns);
    const double spacing = std::pow(1.0 / cases, 1.0 / static_cast<double>(columns));
    std::printf("%lld columns: mean step %.4f, spacing %.4f, as listed %.4f\n", static_cast<long long>(columns), step,
                spacing, mean_step(as_listed, value, columns));
    EXPECT_LT(step, 2 * spacing);
  }
}

TEST(case_order, does_not_depend_on_the_list) {
  std::mt19937 generator(6);
  std::uniform_int_distribution<int> few(-2, 2);
  constexpr std::int64_t cases = 300, columns = 3;
  std::vector<double> value(cases * columns);
  for (double& v : value) v = few(generator);
  value[4] = -0.0;
  std::vector<std::int64_t> at(cases);
  std::iota(at.begin(), at.end(), 0);
  std::shuffle(at.begin(), at.end(), generator);
  std::vector<double> shuffled;
  for (const std::int64_t i : at)
    for (const double v : row(value, columns, i)) shuffled.push_back(v);
  const std::int64_t priority[3] = {2, 0, 1};
  const CaseOrder a = order_cases(cases, columns, value.data(), priority);
  const CaseOrder b = order_cases(cases, columns, shuffled.data(), priority);
  ASSERT_LT(a.solved.size(), 126U) << "five values in three columns";
  ASSERT_EQ(a.solved.size(), b.solved.size());
  EXPECT_EQ(a.chain_begin, b.chain_begin);
  for (std::size_t i = 0; i < a.solved.size(); ++i)
    EXPECT_EQ(row(value, columns, a.solved[i]), row(shuffled, columns, b.solved[i]));
  for (std::int64_t i = 0; i < cases; ++i)
    EXPECT_EQ(row(value, columns, a.solved_as[static_cast<std::size_t>(i)]), row(value, columns, i));
}

TEST(case_order, chains_cover_the_cases) {
  for (const std::int64_t cases : {0, 1, 3, 4, 5, 64, 65, 100, 1000}) {
    std::vector<double> value(static_cast<std::size_t>(cases));
    std::iota(value.begin(), value.end(), 0.0);
    const std::int64_t priority[1] = {0};
    const CaseOrder order = order_cases(cases, 1, value.data(), priority);
    EXPECT_EQ(order.chain_begin.front(), 0);
    EXPECT_EQ(order.chain_begin.back(), cases);
    EXPECT_TRUE(std::is_sorted(order.chain_begin.begin(), order.chain_begin.end()));
    EXPECT_GE(order.chains(), std::min<std::int64_t>(cases / 4, 8)) << cases;
    EXPECT_LE(order.chains(), std::max<std::int64_t>(16, cases / 32 + 1)) << cases;
  }
  // All cases are alike, so one is solved.
  const std::vector<double> same(20, 1.0);
  const std::int64_t priority[1] = {0};
  EXPECT_EQ(order_cases(20, 1, same.data(), priority).solved.size(), 1U);
}
