/// Solver settings by name.

#include <cmath>
#include <limits>

#include "fixture.hpp"

using namespace capi_test;

class options : public Api {};

TEST_F(options, table_lists_every_option_with_a_standard_that_new_contacts_have) {
  const std::int32_t count = rollcon_option_count();
  ASSERT_GE(count, 9);
  for (std::int32_t i = 0; i < count; ++i) {
    char name[32];
    std::int32_t type = 0;
    double low = 0, high = 0, standard = 0, real = 0;
    std::int64_t integer = 0, needed = 0;
    ASSERT_EQ(rollcon_option_info(i, sizeof name, name, &type, &low, &high, &standard), ROLLCON_OK);
    ASSERT_EQ(rollcon_option_doc(i, 0, nullptr, &needed), ROLLCON_OK);
    EXPECT_GT(needed, 10) << name;
    if (type == ROLLCON_TYPE_INT) {
      ASSERT_EQ(rollcon_contact_get_int(contact, name, &integer), ROLLCON_OK) << name;
      EXPECT_EQ(static_cast<double>(integer), standard) << name;
    } else if (type == ROLLCON_TYPE_REAL) {
      ASSERT_EQ(rollcon_contact_get_real(contact, name, &real), ROLLCON_OK) << name;
      EXPECT_EQ(real, standard) << name;
    } else {
      EXPECT_EQ(type, ROLLCON_TYPE_STR) << name;
      EXPECT_EQ(rollcon_contact_get_str(contact, name, 0, nullptr, &needed), ROLLCON_OK) << name;
    }
    if (type != ROLLCON_TYPE_STR) {
      EXPECT_LE(low, standard) << name;
      EXPECT_LE(standard, high) << name;
    }
  }
}

TEST_F(options, every_number_is_held_to_its_range) {
  for (std::int32_t i = 0; i < rollcon_option_count(); ++i) {
    char name[32];
    std::int32_t type = 0;
    double low = 0, high = 0;
    ASSERT_EQ(rollcon_option_info(i, sizeof name, name, &type, &low, &high, nullptr), ROLLCON_OK);
    if (type == ROLLCON_TYPE_INT) {
      const auto least = static_cast<std::int64_t>(low), most = static_cast<std::int64_t>(high);
      EXPECT_EQ(rollcon_contact_set_int(contact, name, least), ROLLCON_OK) << name;
      EXPECT_EQ(rollcon_contact_set_int(contact, name, most), ROLLCON_OK) << name;
      EXPECT_FAILS(rollcon_contact_set_int(contact, name, least - 1), ROLLCON_ERR_OPTION, name);
      EXPECT_FAILS(rollcon_contact_set_int(contact, name, most + 1), ROLLCON_ERR_OPTION, name);
      EXPECT_FAILS(rollcon_contact_set_int(contact, name, INT64_MIN), ROLLCON_ERR_OPTION, name);
      std::int64_t held = 0;
      ASSERT_EQ(rollcon_contact_get_int(contact, name, &held), ROLLCON_OK);
      EXPECT_EQ(held, most) << name << " changed by a refused value";
    } else if (type == ROLLCON_TYPE_REAL) {
      EXPECT_EQ(rollcon_contact_set_real(contact, name, low), ROLLCON_OK) << name;
      EXPECT_EQ(rollcon_contact_set_real(contact, name, high), ROLLCON_OK) << name;
      EXPECT_FAILS(rollcon_contact_set_real(contact, name, std::nextafter(low, -1e9)),
                   ROLLCON_ERR_OPTION, name, "allowed");
      EXPECT_FAILS(rollcon_contact_set_real(contact, name, std::nextafter(high, 1e9)),
                   ROLLCON_ERR_OPTION, name, "allowed");
      EXPECT_FAILS(rollcon_contact_set_real(contact, name, std::nan("")), ROLLCON_ERR_NONFINITE,
                   name);
      double held = 0;
      ASSERT_EQ(rollcon_contact_get_real(contact, name, &held), ROLLCON_OK);
      EXPECT_EQ(held, high) << name << " changed by a refused value";
    }
  }
}

TEST_F(options, texts_are_held_to_their_choices) {
  for (const char* value : {"least_squares", "godunov", "characteristic"})
    EXPECT_EQ(rollcon_contact_set_str(contact, "convection", value), ROLLCON_OK);
  for (const char* value : {"", "least", "godunov|characteristic", "Godunov", "|"})
    EXPECT_FAILS(rollcon_contact_set_str(contact, "convection", value), ROLLCON_ERR_OPTION,
                 "convection", "characteristic|least_squares|godunov");
  char text[32];
  ASSERT_EQ(rollcon_contact_get_str(contact, "convection", sizeof text, text, nullptr), ROLLCON_OK);
  EXPECT_STREQ(text, "characteristic");
  EXPECT_FAILS(rollcon_contact_set_str(contact, "convection", nullptr), ROLLCON_ERR_ARGUMENT,
               "value is NULL");
}

TEST_F(options, unknown_names_and_wrong_types_are_refused) {
  std::int64_t integer = 0;
  double real = 0;
  EXPECT_FAILS(rollcon_contact_set_int(contact, "max_iteration", 5), ROLLCON_ERR_OPTION,
               "'max_iteration'", "max_iterations");
  EXPECT_FAILS(rollcon_contact_set_real(contact, "", 5), ROLLCON_ERR_OPTION, "unknown");
  EXPECT_FAILS(rollcon_contact_set_int(contact, "tolerance", 1), ROLLCON_ERR_OPTION,
               "is a real number, not an integer");
  EXPECT_FAILS(rollcon_contact_set_real(contact, "max_iterations", 5), ROLLCON_ERR_OPTION,
               "is an integer, not a real number");
  EXPECT_FAILS(rollcon_contact_set_str(contact, "tolerance", "1e-6"), ROLLCON_ERR_OPTION,
               "is a real number, not text");
  EXPECT_FAILS(rollcon_contact_get_int(contact, "tolerance", &integer), ROLLCON_ERR_OPTION,
               "not an integer");
  EXPECT_FAILS(rollcon_contact_get_real(contact, "nothing", &real), ROLLCON_ERR_OPTION, "nothing");
  EXPECT_FAILS(rollcon_contact_get_str(contact, "tolerance", 0, nullptr, &integer),
               ROLLCON_ERR_OPTION, "text");
  EXPECT_FAILS(rollcon_contact_set_int(contact, nullptr, 5), ROLLCON_ERR_ARGUMENT, "name is NULL");
  EXPECT_FAILS(rollcon_contact_get_int(contact, "max_iterations", nullptr), ROLLCON_ERR_ARGUMENT,
               "value is NULL");
  EXPECT_FAILS(rollcon_contact_get_real(contact, "tolerance", nullptr), ROLLCON_ERR_ARGUMENT,
               "value is NULL");
}

TEST_F(options, very_long_names_give_a_short_text) {
  const std::string name(100000, 'x');
  EXPECT_EQ(rollcon_contact_set_int(contact, name.c_str(), 1), ROLLCON_ERR_OPTION);
  EXPECT_LT(error().size(), 1000U);
}

TEST(option_table, rows_outside_are_refused) {
  char text[256];
  for (const std::int32_t i : {-1, rollcon_option_count(), INT32_MIN, INT32_MAX}) {
    EXPECT_EQ(rollcon_option_info(i, sizeof text, text, nullptr, nullptr, nullptr, nullptr),
              ROLLCON_ERR_ARGUMENT);
    EXPECT_EQ(rollcon_option_doc(i, sizeof text, text, nullptr), ROLLCON_ERR_ARGUMENT);
  }
  EXPECT_EQ(rollcon_option_info(0, 2, text, nullptr, nullptr, nullptr, nullptr),
            ROLLCON_ERR_CAPACITY);
}
