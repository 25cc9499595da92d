/// Settings of bodies by name.

#include <cmath>

#include "body_fixture.hpp"

using namespace capi_test;

class body_options : public BodyApi {};

TEST_F(body_options, table_lists_what_new_bodies_have_and_every_number_keeps_its_range) {
  const std::int32_t count = rollcon_body_option_count();
  ASSERT_EQ(count, 8);
  for (std::int32_t i = 0; i < count; ++i) {
    char name[32];
    std::int32_t type = 0;
    double low = 0, high = 0, standard = 0, real = 0;
    std::int64_t integer = 0, needed = 0;
    ASSERT_EQ(rollcon_body_option_info(i, sizeof name, name, &type, &low, &high, &standard),
              ROLLCON_OK);
    ASSERT_EQ(rollcon_body_option_doc(i, 0, nullptr, &needed), ROLLCON_OK);
    EXPECT_GT(needed, 10) << name;
    EXPECT_LE(low, standard) << name;
    EXPECT_LE(standard, high) << name;
    if (type == ROLLCON_TYPE_INT) {
      ASSERT_EQ(rollcon_body_get_int(body, name, &integer), ROLLCON_OK) << name;
      EXPECT_EQ(static_cast<double>(integer), standard) << name;
      const auto least = static_cast<std::int64_t>(low), most = static_cast<std::int64_t>(high);
      EXPECT_EQ(rollcon_body_set_int(body, name, most), ROLLCON_OK) << name;
      EXPECT_EQ(rollcon_body_set_int(body, name, least), ROLLCON_OK) << name;
      EXPECT_FAILS(rollcon_body_set_int(body, name, least - 1), ROLLCON_ERR_OPTION, name);
      EXPECT_FAILS(rollcon_body_set_int(body, name, most + 1), ROLLCON_ERR_OPTION, name);
      ASSERT_EQ(rollcon_body_get_int(body, name, &integer), ROLLCON_OK);
      EXPECT_EQ(integer, least) << name << " changed by a refused value";
    } else {
      ASSERT_EQ(type, ROLLCON_TYPE_REAL) << name;
      ASSERT_EQ(rollcon_body_get_real(body, name, &real), ROLLCON_OK) << name;
      EXPECT_EQ(real, standard) << name;
      EXPECT_EQ(rollcon_body_set_real(body, name, high), ROLLCON_OK) << name;
      EXPECT_EQ(rollcon_body_set_real(body, name, low), ROLLCON_OK) << name;
      EXPECT_FAILS(rollcon_body_set_real(body, name, std::nextafter(low, -1e9)), ROLLCON_ERR_OPTION,
                   name, "allowed");
      EXPECT_FAILS(rollcon_body_set_real(body, name, std::nextafter(high, 1e9)), ROLLCON_ERR_OPTION,
                   name, "allowed");
      EXPECT_FAILS(rollcon_body_set_real(body, name, std::nan("")), ROLLCON_ERR_NONFINITE, name);
      ASSERT_EQ(rollcon_body_get_real(body, name, &real), ROLLCON_OK);
      EXPECT_EQ(real, low) << name << " changed by a refused value";
    }
  }
}

TEST_F(body_options, unknown_names_and_wrong_types_are_refused) {
  std::int64_t integer = 0;
  double real = 0;
  EXPECT_FAILS(rollcon_body_set_int(body, "keep_factor", 1), ROLLCON_ERR_OPTION, "'keep_factor'",
               "keep_factors");
  EXPECT_FAILS(rollcon_body_set_real(body, "", 5), ROLLCON_ERR_OPTION, "unknown");
  EXPECT_FAILS(rollcon_body_set_int(body, "accuracy", 1), ROLLCON_ERR_OPTION,
               "is a real number, not an integer");
  EXPECT_FAILS(rollcon_body_set_real(body, "keep_factors", 1), ROLLCON_ERR_OPTION,
               "is an integer, not a real number");
  EXPECT_FAILS(rollcon_body_get_int(body, "edge_angle", &integer), ROLLCON_ERR_OPTION,
               "not an integer");
  EXPECT_FAILS(rollcon_body_get_real(body, "tolerance", &real), ROLLCON_ERR_OPTION, "tolerance",
               "accuracy, edge_angle, keep_factors, between_nodes, factorization, hex8, prepare");
  EXPECT_FAILS(rollcon_body_set_int(body, nullptr, 5), ROLLCON_ERR_ARGUMENT, "name is NULL");
  EXPECT_FAILS(rollcon_body_get_int(body, "keep_factors", nullptr), ROLLCON_ERR_ARGUMENT,
               "value is NULL");
  EXPECT_FAILS(rollcon_body_get_real(body, "accuracy", nullptr), ROLLCON_ERR_ARGUMENT,
               "value is NULL");
}

TEST_F(body_options, bodies_without_equations_have_them_too) {
  EXPECT_EQ(rollcon_body_set_real(sphere, "accuracy", 1e-4), ROLLCON_OK);
  EXPECT_EQ(rollcon_body_set_int(plane, "keep_factors", 0), ROLLCON_OK);
}

TEST(body_option_table, rows_outside_are_refused) {
  char text[256];
  for (const std::int32_t i : {-1, rollcon_body_option_count(), INT32_MIN, INT32_MAX}) {
    EXPECT_EQ(rollcon_body_option_info(i, sizeof text, text, nullptr, nullptr, nullptr, nullptr),
              ROLLCON_ERR_ARGUMENT);
    EXPECT_EQ(rollcon_body_option_doc(i, sizeof text, text, nullptr), ROLLCON_ERR_ARGUMENT);
  }
  EXPECT_EQ(rollcon_body_option_info(0, 2, text, nullptr, nullptr, nullptr, nullptr),
            ROLLCON_ERR_CAPACITY);
}
