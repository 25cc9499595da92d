/// Tests settings by name, of contacts and of bodies.

#include <type_traits>

#include "fixture.hpp"

using namespace capi_test;

/// Lists the functions of one kind of object, and settings of each type; `listed` are names that a refusal of an
/// unknown one tells.
struct OfContact {
  static constexpr std::int32_t listing = ROLLCON_OF_CONTACT;
  static constexpr auto set_int = rollcon_contact_set_int;
  static constexpr auto set_real = rollcon_contact_set_real;
  static constexpr auto get_int = rollcon_contact_get_int;
  static constexpr auto get_real = rollcon_contact_get_real;
  static constexpr const char *kind = "rollcon_contact_", *integer = "max_iterations", *real = "tolerance",
                              *listed = "max_iterations";
};
struct OfBody {
  static constexpr std::int32_t listing = ROLLCON_OF_BODY;
  static constexpr auto set_int = rollcon_body_set_int;
  static constexpr auto set_real = rollcon_body_set_real;
  static constexpr auto get_int = rollcon_body_get_int;
  static constexpr auto get_real = rollcon_body_get_real;
  static constexpr const char *kind = "rollcon_body_", *integer = "keep_factors", *real = "accuracy",
                              *listed = "accuracy, edge_angle, keep_factors, between_nodes, hex8, prepare";
};

template <class Of>
class options : public Api {
 protected:
  /// Returns a contact, or a body without equations, which has settings too.
  auto* object() {
    if constexpr (std::is_same_v<Of, OfBody>)
      return sphere;
    else
      return contact;
  }
  void refused(std::int32_t status, const char* function, std::int32_t expected,
               std::initializer_list<const char*> words) {
    EXPECT_EQ(status, expected);
    EXPECT_EQ(error().find(std::string(Of::kind) + function + ":"), 0U) << error();
    for (const char* word : words) EXPECT_NE(error().find(word), std::string::npos) << error();
  }
  static constexpr std::int32_t option = ROLLCON_ERR_OPTION, argument = ROLLCON_ERR_ARGUMENT;
};
using Kinds = ::testing::Types<OfContact, OfBody>;
TYPED_TEST_SUITE(options, Kinds);

TYPED_TEST(options, are_listed_with_the_standard_that_new_objects_have) {
  using Of = TypeParam;
  ASSERT_GE(rollcon_option_count(Of::listing), 7);
  for (std::int32_t i = 0; i < rollcon_option_count(Of::listing); ++i) {
    char name[32];
    std::int32_t type = 0;
    double low = 0, high = 0, standard = 0, real = 0;
    std::int64_t integer = 0, needed = 0;
    ASSERT_OK(rollcon_option_info(Of::listing, i, sizeof name, name, nullptr, nullptr, &type, &low, &high, &standard));
    ASSERT_OK(rollcon_option_info(Of::listing, i, 0, nullptr, nullptr, &needed, nullptr, nullptr, nullptr, nullptr));
    EXPECT_GT(needed, 10) << name;
    if (type == ROLLCON_TYPE_STR) {
      EXPECT_OK(rollcon_contact_get_str(this->contact, name, 0, nullptr, &needed));
      continue;
    }
    if (type == ROLLCON_TYPE_INT) {
      ASSERT_OK(Of::get_int(this->object(), name, &integer)) << name;
      real = static_cast<double>(integer);
    } else {
      ASSERT_EQ(type, ROLLCON_TYPE_REAL) << name;
      ASSERT_OK(Of::get_real(this->object(), name, &real)) << name;
    }
    EXPECT_EQ(real, standard) << name;
    EXPECT_LE(low, standard) << name;
    EXPECT_LE(standard, high) << name;
  }
}

TYPED_TEST(options, every_number_is_held_to_its_range) {
  using Of = TypeParam;
  auto* o = this->object();
  for (std::int32_t i = 0; i < rollcon_option_count(Of::listing); ++i) {
    char name[32];
    std::int32_t type = 0;
    double low = 0, high = 0;
    ASSERT_OK(rollcon_option_info(Of::listing, i, sizeof name, name, nullptr, nullptr, &type, &low, &high, nullptr));
    if (type == ROLLCON_TYPE_INT) {
      const auto least = static_cast<std::int64_t>(low), most = static_cast<std::int64_t>(high);
      EXPECT_OK(Of::set_int(o, name, least)) << name;
      EXPECT_OK(Of::set_int(o, name, most)) << name;
      for (const std::int64_t bad : {least - 1, most + 1, INT64_MIN})
        this->refused(Of::set_int(o, name, bad), "set_int", this->option, {name});
      std::int64_t held = 0;
      ASSERT_OK(Of::get_int(o, name, &held));
      EXPECT_EQ(held, most) << name << " changed by a refused value";
    } else if (type == ROLLCON_TYPE_REAL) {
      EXPECT_OK(Of::set_real(o, name, low)) << name;
      EXPECT_OK(Of::set_real(o, name, high)) << name;
      for (const double bad : {std::nextafter(low, -1e9), std::nextafter(high, 1e9)})
        this->refused(Of::set_real(o, name, bad), "set_real", this->option, {name, "allowed"});
      this->refused(Of::set_real(o, name, std::nan("")), "set_real", ROLLCON_ERR_NONFINITE, {name});
      double held = 0;
      ASSERT_OK(Of::get_real(o, name, &held));
      EXPECT_EQ(held, high) << name << " changed by a refused value";
    }
  }
}

TYPED_TEST(options, unknown_names_and_wrong_types_are_refused) {
  using Of = TypeParam;
  auto* o = this->object();
  const std::string nearly = std::string(Of::integer).substr(1);
  std::int64_t i = 0;
  double r = 0;
  const auto option = this->option, argument = this->argument;
  this->refused(Of::set_int(o, nearly.c_str(), 5), "set_int", option, {nearly.c_str(), Of::listed});
  this->refused(Of::set_real(o, "", 5), "set_real", option, {"unknown"});
  this->refused(Of::set_int(o, Of::real, 1), "set_int", option, {"is a real number, not an integer"});
  this->refused(Of::set_real(o, Of::integer, 1), "set_real", option, {"is an integer, not a real number"});
  this->refused(Of::get_int(o, Of::real, &i), "get_int", option, {"not an integer"});
  this->refused(Of::get_real(o, "nothing", &r), "get_real", option, {"nothing", Of::listed});
  this->refused(Of::set_int(o, nullptr, 5), "set_int", argument, {"name is NULL"});
  this->refused(Of::get_int(o, Of::integer, nullptr), "get_int", argument, {"value is NULL"});
  this->refused(Of::get_real(o, Of::real, nullptr), "get_real", argument, {"value is NULL"});
  const std::string name(100000, 'x');
  EXPECT_EQ(Of::set_int(o, name.c_str(), 1), option);
  EXPECT_LT(this->error().size(), 1000U) << "very long names give a short text";
}

TYPED_TEST(options, rows_outside_of_the_table_are_refused) {
  using Of = TypeParam;
  char text[256];
  for (const std::int32_t i : {-1, rollcon_option_count(Of::listing), INT32_MIN, INT32_MAX}) {
    EXPECT_EQ(
        rollcon_option_info(Of::listing, i, sizeof text, text, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
        this->argument);
  }
  EXPECT_EQ(rollcon_option_info(Of::listing, 0, 2, text, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
            ROLLCON_ERR_CAPACITY);
}

class text_options : public Api {};

TEST_F(text_options, are_held_to_their_choices) {
  for (const char* value : {"least_squares", "godunov", "characteristic"})
    EXPECT_OK(rollcon_contact_set_str(contact, "convection", value));
  for (const char* value : {"", "least", "godunov|characteristic", "Godunov", "|"})
    EXPECT_FAILS(rollcon_contact_set_str(contact, "convection", value), OPTION, "convection",
                 "characteristic|least_squares|godunov");
  char text[32];
  ASSERT_OK(rollcon_contact_get_str(contact, "convection", sizeof text, text, nullptr));
  EXPECT_STREQ(text, "characteristic");
  EXPECT_FAILS(rollcon_contact_set_str(contact, "convection", nullptr), ARGUMENT, "value is NULL");
  std::int64_t needed = 0;
  EXPECT_FAILS(rollcon_contact_set_str(contact, "tolerance", "1e-6"), OPTION, "is a real number, not text");
  EXPECT_FAILS(rollcon_contact_get_str(contact, "tolerance", 0, nullptr, &needed), OPTION, "text");
}
