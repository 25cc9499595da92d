/// Tests creep-force tables through the C interface.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "rollcon.h"

namespace {

struct Table {
  rollcon_context* context = nullptr;
  rollcon_table* table = nullptr;
  Table() { EXPECT_EQ(rollcon_context_create(ROLLCON_ABI, &context), ROLLCON_OK); }
  ~Table() {
    rollcon_table_release(table);
    rollcon_context_release(context);
  }
  void standard() { ASSERT_EQ(rollcon_table_standard(context, &table), ROLLCON_OK) << rollcon_last_error(); }
};

constexpr double usual[9] = {82000, 0.28, 0.3, 6, 4, 1e5, 1e-3, -5e-4, 1e-4};

TEST(creep_force_table, bad_entries_are_named) {
  Table t;
  t.standard();
  const auto refused = [&](int k, double value) {
    double in[18], f[6];
    for (int i = 0; i < 18; ++i) in[i] = usual[i % 9];
    in[9 + k] = value;
    const int32_t status = rollcon_table_evaluate(t.table, 2, in, f);
    return std::to_string(status) + " " + rollcon_last_error();
  };
  EXPECT_EQ(refused(2, -1), "-1 rollcon_table_evaluate: friction of entry 1 is -1; allowed: 0 to 10");
  EXPECT_EQ(refused(0, NAN), "-3 rollcon_table_evaluate: shear of entry 1 is nan");
  EXPECT_NE(refused(1, 0.23).find("poisson of entry 1 is 0.23; the table has 0.24 to 0.34"), std::string::npos);
  EXPECT_NE(refused(3, 400).find("a / b of entry 1 is 100; the table has 0.04 to 25"), std::string::npos);
  double f[3];
  EXPECT_EQ(rollcon_table_evaluate(t.table, 1, nullptr, f), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_table_evaluate(t.table, -1, usual, f), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_table_evaluate_derivatives(t.table, 1, usual, f, nullptr), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_table_make(t.table, 0, 1), ROLLCON_ERR_STATE);
  EXPECT_EQ(rollcon_table_set_frame(t.table, 8, 6), ROLLCON_ERR_STATE);
}

TEST(creep_force_table, tables_without_samples_say_so) {
  Table t;
  ASSERT_EQ(rollcon_table_create(t.context, &t.table), ROLLCON_OK);
  double f[3];
  EXPECT_EQ(rollcon_table_evaluate(t.table, 1, usual, f), ROLLCON_ERR_STATE);
  EXPECT_EQ(rollcon_table_save(t.table, "never.rct"), ROLLCON_ERR_STATE);
  EXPECT_EQ(rollcon_table_set_ratios(t.table, 4, 2, 0.5), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_table_set_resolution(t.table, 8, 6, 5), ROLLCON_ERR_ARGUMENT);
  const double falling[2] = {0.3, 0.28};
  EXPECT_EQ(rollcon_table_set_poissons(t.table, 2, falling), ROLLCON_ERR_ARGUMENT);
  int64_t count = -1;
  EXPECT_EQ(rollcon_table_get_samples(t.table, 0, nullptr, &count), ROLLCON_OK);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(rollcon_table_make(t.table, 1, 1), ROLLCON_ERR_ARGUMENT);
}

int32_t cancel(const rollcon_event*, void* user) {
  return ++*static_cast<int*>(user);
}

TEST(creep_force_table, made_in_parts_after_a_cancel) {
  Table whole, part;
  const double poisson = 0.3;
  for (Table* t : {&whole, &part}) {
    ASSERT_EQ(rollcon_table_create(t->context, &t->table), ROLLCON_OK);
    ASSERT_EQ(rollcon_table_set_ratios(t->table, 4, 0.5, 2), ROLLCON_OK);
    ASSERT_EQ(rollcon_table_set_resolution(t->table, 8, 4, 4), ROLLCON_OK);
    ASSERT_EQ(rollcon_table_set_frame(t->table, 6, 4), ROLLCON_OK);
    ASSERT_EQ(rollcon_table_set_poissons(t->table, 1, &poisson), ROLLCON_OK);
  }
  int calls = 0;
  ASSERT_EQ(rollcon_table_set_progress(whole.table, cancel, &calls), ROLLCON_OK);
  EXPECT_EQ(rollcon_table_make(whole.table, 0, 1), ROLLCON_CANCELLED);
  EXPECT_EQ(calls, 1);
  ASSERT_EQ(rollcon_table_set_progress(whole.table, nullptr, nullptr), ROLLCON_OK);
  EXPECT_EQ(rollcon_table_make(whole.table, 0, 1), ROLLCON_OK);
  EXPECT_EQ(rollcon_table_make(part.table, 1, 2), ROLLCON_OK);
  double f[3], g[3];
  const double in[9] = {82000, 0.3, 0.3, 5, 4, 1e5, 1e-3, -5e-4, 1e-4};
  EXPECT_EQ(rollcon_table_evaluate(part.table, 1, in, g), ROLLCON_ERR_STATE);
  int64_t count = 0;
  ASSERT_EQ(rollcon_table_get_samples(whole.table, 0, nullptr, &count), ROLLCON_OK);
  std::vector<double> samples(static_cast<std::size_t>(count));
  ASSERT_EQ(rollcon_table_get_samples(whole.table, count, samples.data(), &count), ROLLCON_OK);
  std::vector<double> huge = samples;
  huge[7] = 1e300;
  EXPECT_EQ(rollcon_table_add_samples(part.table, count, huge.data()), ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(std::string(rollcon_last_error()).find("entry 7 of samples (counting from 0) is 1e+300"), std::string::npos)
      << rollcon_last_error();
  ASSERT_EQ(rollcon_table_add_samples(part.table, count, samples.data()), ROLLCON_OK);
  ASSERT_EQ(rollcon_table_evaluate(part.table, 1, in, g), ROLLCON_OK);
  ASSERT_EQ(rollcon_table_evaluate(whole.table, 1, in, f), ROLLCON_OK);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(f[i], g[i]);
}

}  // namespace
