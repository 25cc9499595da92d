/// Tests results in the caller's arrays: asking for the need, too small capacities, exact ones.

#include <cstring>

#include "fixture.hpp"

using namespace capi_test;

namespace {

using TextGetter = std::function<std::int32_t(std::int64_t, char*, std::int64_t*)>;

void check_text_getter(const char* name, const TextGetter& get) {
  SCOPED_TRACE(name);
  std::int64_t needed = -1;
  ASSERT_OK(get(0, nullptr, &needed));
  ASSERT_GE(needed, 2);
  EXPECT_EQ(get(0, nullptr, nullptr), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(get(-1, nullptr, &needed), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(get(needed, nullptr, nullptr), ROLLCON_ERR_ARGUMENT);

  std::vector<char> text(static_cast<std::size_t>(needed) + 1, '#');
  std::int64_t again = -1;
  EXPECT_EQ(get(needed - 1, text.data(), &again), ROLLCON_ERR_CAPACITY);
  EXPECT_EQ(again, needed);
  EXPECT_EQ(std::string(text.begin(), text.end()), std::string(text.size(), '#'));
  EXPECT_EQ(get(1, text.data(), nullptr), ROLLCON_ERR_CAPACITY);

  again = -1;
  EXPECT_OK(get(needed, text.data(), &again));
  EXPECT_EQ(again, needed);
  EXPECT_EQ(std::strlen(text.data()), static_cast<std::size_t>(needed) - 1);
  EXPECT_EQ(text.back(), '#');
}

}  // namespace

class capacity : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    set_scene();
    ASSERT_OK(rollcon_contact_solve(contact));
  }
};

TEST_F(capacity, texts) {
  check_text_getter("get_str", [&](auto n, auto* text, auto* needed) {
    return rollcon_contact_get_str(contact, "convection", n, text, needed);
  });
  check_text_getter(
      "get_plan", [&](auto n, auto* text, auto* needed) { return rollcon_contact_get_plan(contact, n, text, needed); });
}

TEST_F(capacity, names_and_meanings) {
  char name[64] = "#", doc[400] = "#";
  std::int64_t both = 0, needed = 0;
  double high = 0;
  ASSERT_OK(rollcon_option_info(ROLLCON_OF_BODY, 0, 0, nullptr, nullptr, &both, nullptr, nullptr, &high, nullptr));
  EXPECT_GT(high, 0);
  ASSERT_OK(rollcon_option_info(ROLLCON_OF_BODY, 0, both, name, doc, &needed, nullptr, nullptr, nullptr, nullptr));
  EXPECT_STREQ(name, "accuracy");
  EXPECT_EQ(static_cast<std::size_t>(both), std::strlen(doc) + 1);
  EXPECT_EQ(needed, both);
  EXPECT_EQ(rollcon_stat_info(ROLLCON_OF_CONTACT, 0, 3, name, nullptr, &needed, nullptr), ROLLCON_ERR_CAPACITY);
  EXPECT_EQ(static_cast<std::size_t>(needed), std::strlen("iterations") + 1);
  EXPECT_STREQ(name, "accuracy") << "unchanged";
  ASSERT_OK(rollcon_stat_info(ROLLCON_OF_CONTACT, 0, needed, name, nullptr, nullptr, nullptr));
  EXPECT_STREQ(name, "iterations");
  EXPECT_OK(rollcon_stat_info(ROLLCON_OF_CONTACT, 0, 0, nullptr, nullptr, nullptr, nullptr));
  EXPECT_EQ(rollcon_stat_info(ROLLCON_OF_CONTACT, 0, -1, name, doc, &needed, nullptr), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_stat_info(ROLLCON_OF_CONTACT, 0, 8, nullptr, nullptr, &needed, nullptr), ROLLCON_ERR_ARGUMENT);
}

TEST_F(capacity, every_statistic_says_what_it_is) {
  for (const std::int32_t kind : {ROLLCON_OF_BODY, ROLLCON_OF_CONTACT, ROLLCON_OF_WHEELRAIL, ROLLCON_OF_PATCH}) {
    std::int32_t inside = 0, counters = 0;
    char name[32], doc[256];
    const std::int32_t count = rollcon_stat_count(kind);
    ASSERT_GT(count, 0) << kind;
    for (std::int32_t i = 0; i < count; ++i) {
      ASSERT_OK(rollcon_stat_info(kind, i, sizeof doc, doc, nullptr, nullptr, nullptr));
      ASSERT_OK(rollcon_stat_info(kind, i, sizeof name, name, nullptr, nullptr, &inside));
      EXPECT_STREQ(name, doc);
      ASSERT_OK(rollcon_stat_info(kind, i, sizeof doc, nullptr, doc, nullptr, nullptr));
      EXPECT_GE(std::strlen(doc), 5U) << name;
      counters += inside;
    }
    EXPECT_LT(2 * counters, count) << kind;
  }
  EXPECT_EQ(rollcon_stat_count(99), 0);
  EXPECT_EQ(rollcon_option_count(ROLLCON_OF_PATCH), 0);
  EXPECT_FAILS(rollcon_stat_info(99, 0, 0, nullptr, nullptr, nullptr, nullptr), ARGUMENT, "kind is 99");
  EXPECT_FAILS(
      rollcon_option_info(ROLLCON_OF_PATCH, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
      ARGUMENT, "no options");
}

TEST_F(capacity, fields) {
  for (std::int32_t field = ROLLCON_FIELD_POINT; field <= ROLLCON_FIELD_WEIGHT; ++field) {
    for (const std::int32_t axes : {ROLLCON_LOCAL, ROLLCON_GLOBAL}) {
      SCOPED_TRACE(field);
      const bool slip = field == ROLLCON_FIELD_SLIP || field == ROLLCON_FIELD_RIGID_SLIP;
      const bool vector = field == ROLLCON_FIELD_POINT || field == ROLLCON_FIELD_TRACTION ||
                          field == ROLLCON_FIELD_DISPLACEMENT1 || field == ROLLCON_FIELD_DISPLACEMENT2;
      const std::int64_t values = vector ? 3 : slip ? (axes == ROLLCON_LOCAL ? 2 : 3) : 1;
      std::int64_t n = 0;
      ASSERT_OK(rollcon_contact_get_field(contact, field, axes, 0, nullptr, &n));
      EXPECT_EQ(n, values * frame.nodes);
      std::vector<double> v(static_cast<std::size_t>(n) + 1, -777);
      std::int64_t again = 0;
      EXPECT_EQ(rollcon_contact_get_field(contact, field, axes, n - 1, v.data(), &again), ROLLCON_ERR_CAPACITY);
      EXPECT_EQ(again, n);
      EXPECT_EQ(v, std::vector<double>(v.size(), -777));
      EXPECT_OK(rollcon_contact_get_field(contact, field, axes, n, v.data(), nullptr));
      EXPECT_EQ(v.back(), -777);
      EXPECT_EQ(rollcon_contact_get_field(contact, field, axes, n, nullptr, nullptr), ROLLCON_ERR_ARGUMENT);
    }
  }
}

TEST_F(capacity, tractions_status_and_history) {
  std::vector<double> t(static_cast<std::size_t>(3 * frame.nodes) + 1, -777);
  EXPECT_FAILS(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes - 1, t.data()), CAPACITY, "169");
  EXPECT_EQ(t, std::vector<double>(t.size(), -777));
  EXPECT_OK(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes, t.data()));
  EXPECT_EQ(t.back(), -777);
  std::vector<std::int32_t> s(static_cast<std::size_t>(frame.nodes) + 1, -777);
  EXPECT_FAILS(rollcon_contact_get_node_states(contact, frame.nodes - 1, s.data()), CAPACITY, "169");
  EXPECT_OK(rollcon_contact_get_node_states(contact, frame.nodes, s.data()));
  EXPECT_EQ(s.back(), -777);

  std::int64_t rows = 0, again = 0;
  constexpr const char* columns = "seconds step";
  ASSERT_OK(rollcon_contact_get_history(contact, columns, 0, nullptr, &rows));
  ASSERT_GE(rows, 2);
  std::vector<double> history(static_cast<std::size_t>(2 * rows) + 1, -777);
  EXPECT_EQ(rollcon_contact_get_history(contact, columns, rows - 1, history.data(), &again), ROLLCON_ERR_CAPACITY);
  EXPECT_EQ(again, rows);
  EXPECT_OK(rollcon_contact_get_history(contact, columns, rows, history.data(), nullptr));
  EXPECT_EQ(history.back(), -777);
  EXPECT_FAILS(rollcon_contact_get_history(contact, "seconds stap", rows, history.data(), nullptr), OPTION,
               "columns has 'stap'", "error_function");
}

TEST_F(capacity, outputs_that_are_not_wanted_may_be_null) {
  EXPECT_OK(rollcon_contact_get_size(contact, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_get_motion(contact, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_get_resultant(contact, ROLLCON_GLOBAL, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_get_sensitivity(contact, ROLLCON_NORMAL, nullptr, nullptr, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_get_displacements_at(contact, 1, 0, nullptr, nullptr));
  const double inside[3] = {0, 0, -1}, stress[6] = {1, 2, 3, 4, 5, 6};
  EXPECT_OK(rollcon_contact_get_fields_at(contact, 1, 0, nullptr, ROLLCON_IN_CONTACT, nullptr, nullptr));
  EXPECT_OK(rollcon_contact_get_fields_at(contact, 1, 1, inside, ROLLCON_IN_CONTACT, nullptr, nullptr));
  EXPECT_OK(rollcon_stress_invariants(0, nullptr, nullptr, nullptr, nullptr));
  EXPECT_OK(rollcon_stress_invariants(1, stress, nullptr, nullptr, nullptr));
}

TEST_F(capacity, every_statistic_has_a_value) {
  for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_CONTACT); ++i) {
    char name[64];
    double value = 0;
    ASSERT_OK(rollcon_stat_info(ROLLCON_OF_CONTACT, i, sizeof name, name, nullptr, nullptr, nullptr));
    EXPECT_OK(rollcon_contact_get_stat(contact, name, &value)) << name;
  }
  char name[64];
  for (const std::int32_t i : {-1, rollcon_stat_count(ROLLCON_OF_CONTACT)})
    EXPECT_EQ(rollcon_stat_info(ROLLCON_OF_CONTACT, i, sizeof name, name, nullptr, nullptr, nullptr),
              ROLLCON_ERR_ARGUMENT);
}
