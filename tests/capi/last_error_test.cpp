/// Tests the text of the last failure, and the latch of programs that check once.

#include "capi/every_call.hpp"
#include "fixture.hpp"

using namespace capi_test;

class last_error : public Api {};
class latch : public Api {};

TEST_F(last_error, is_that_of_a_call_without_a_live_handle) {
  ASSERT_EQ(rollcon_body_set_elastic(sphere, 0, -1, 0.3), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_body_set_elastic", {"young is -1"});
  EXPECT_EQ(rollcon_body_set_elastic(nullptr, 0, 1, 0.3), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_body_set_elastic", {"body is NULL"});
  EXPECT_EQ(rollcon_contact_solve(reinterpret_cast<rollcon_contact*>(sphere)), ROLLCON_ERR_HANDLE);
  expect_text_of("rollcon_contact_solve", {"contact is no live contact"});
  EXPECT_EQ(rollcon_contact_retain(nullptr), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_contact_retain", {"contact is NULL"});
  rollcon_body* body = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &body));
  rollcon_body_release(body);
  std::int32_t kind = 0;
  EXPECT_EQ(rollcon_body_get_kind(body, &kind), ROLLCON_ERR_HANDLE);
  expect_text_of("rollcon_body_get_kind", {"body is no live body"});
}

TEST_F(last_error, is_that_of_a_call_without_an_object) {
  rollcon_context* other = nullptr;
  EXPECT_EQ(rollcon_context_create(ROLLCON_ABI + 6, &other), ROLLCON_ERR_UNSUPPORTED);
  expect_text_of("rollcon_context_create", {("header_abi is " + std::to_string(ROLLCON_ABI + 6)).c_str()});
  expect_text_of("rollcon_context_create", {("binary interface " + std::to_string(ROLLCON_ABI)).c_str()});
  EXPECT_EQ(rollcon_context_create(ROLLCON_ABI, nullptr), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_context_create", {"context is NULL"});
  EXPECT_EQ(rollcon_stat_info(ROLLCON_OF_CONTACT, -3, 0, nullptr, nullptr, nullptr, nullptr), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_stat_info", {"i is -3"});
  EXPECT_EQ(
      rollcon_option_info(ROLLCON_OF_CONTACT, 100000, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
      ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_option_info", {"i is 100000"});
  std::int64_t value = 0;
  EXPECT_EQ(rollcon_event_get_int(nullptr, ROLLCON_EVENT_PHASE, &value), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_event_get_int", {"event is NULL"});
  EXPECT_EQ(rollcon_event_get_int(reinterpret_cast<const rollcon_event*>(&value), ROLLCON_EVENT_PHASE, &value),
            ROLLCON_ERR_HANDLE);
  expect_text_of("rollcon_event_get_int", {"event is no live event"});
}

TEST_F(last_error, belongs_to_the_thread_and_survives_successes) {
  ASSERT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
  std::string elsewhere = "unasked";
  std::thread([&] {
    elsewhere = rollcon_last_error();
    EXPECT_EQ(rollcon_contact_set_rolling(contact, -2), ROLLCON_ERR_ARGUMENT);
    expect_text_of("rollcon_contact_set_rolling", {"speed is -2"});
  }).join();
  EXPECT_EQ(elsewhere, "");
  EXPECT_OK(rollcon_contact_set_rolling(contact, 1));
  expect_text_of("rollcon_contact_set_rolling", {"speed is -1"});
}

namespace {

std::string said;
void fails_too(std::int32_t, const char* message, void*) {
  said = message;
  EXPECT_EQ(rollcon_contact_solve(nullptr), ROLLCON_ERR_ARGUMENT);
}

}  // namespace

TEST_F(last_error, is_that_of_the_call_though_its_log_sink_fails) {
  ASSERT_OK(rollcon_context_set_log(context, ROLLCON_LOG_ERROR, fails_too, nullptr));
  EXPECT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_contact_set_rolling", {"speed is -1"});
  EXPECT_EQ(said, rollcon_last_error());
}

TEST_F(last_error, of_layers_over_the_interface) {
  ASSERT_OK(rollcon_context_set_log(context, ROLLCON_LOG_ERROR, fails_too, nullptr));
  EXPECT_EQ(rollcon_report(contact, ROLLCON_ERR_MESH, "RCNODE: LDX is 2"), ROLLCON_ERR_MESH);
  EXPECT_STREQ(rollcon_last_error(), "RCNODE: LDX is 2");
  EXPECT_EQ(said, "RCNODE: LDX is 2");
  EXPECT_EQ(rollcon_report(nullptr, 1, "no failure"), ROLLCON_ERR_ARGUMENT);
  EXPECT_STREQ(rollcon_last_error(), "no failure");
  EXPECT_EQ(rollcon_report(nullptr, -1, nullptr), ROLLCON_ERR_ARGUMENT);
  EXPECT_STREQ(rollcon_last_error(), "");
  // A text is cut beyond its room.
  const std::string length(5000, 'x');
  EXPECT_EQ(rollcon_report(nullptr, -1, length.c_str()), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_last_error(), length.substr(0, 2047));
}

TEST_F(latch, returns_the_first_failure_at_once_and_at_the_end) {
  set_scene();
  EXPECT_OK(rollcon_context_check(context));
  ASSERT_OK(rollcon_context_set_latch(context, 1));
  EXPECT_OK(rollcon_contact_solve(contact));
  EXPECT_OK(rollcon_context_check(context));
  double before = 0, number = -7;
  ASSERT_OK(rollcon_contact_get_stat(contact, "max_pressure", &before));

  EXPECT_EQ(rollcon_contact_set_friction(contact, "static", 1, &before), ROLLCON_ERR_ARGUMENT);
  const std::string first = error();
  // Calls do nothing any more, in no object of the context.
  const auto check = [&](const char* name, bool at_any_time, std::int32_t status) {
    if (at_any_time) return;
    EXPECT_EQ(status, ROLLCON_ERR_ARGUMENT) << name;
    EXPECT_EQ(error(), first) << name;
  };
  with_each_body_call(sphere, check);
  with_each_contact_call(contact, check);
  rollcon_body_release(sphere);  // once for each time it was retained
  rollcon_contact_release(contact);
  EXPECT_EQ(rollcon_contact_get_stat(contact, "no such thing", &number), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(number, -7);
  rollcon_body* body = sphere;
  EXPECT_EQ(rollcon_body_create(context, ROLLCON_BODY_RIGID, &body), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(body, nullptr);
  // Failures without an object belong to no context.
  EXPECT_EQ(rollcon_body_prepare(body), ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(error(), first);
  // These calls still work.
  std::int32_t kind = 0;
  EXPECT_OK(rollcon_body_get_kind(plane, &kind));
  EXPECT_OK(rollcon_contact_request_cancel(contact));
  EXPECT_OK(rollcon_body_retain(plane));
  rollcon_body_release(plane);

  EXPECT_EQ(rollcon_context_check(context), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(error(), first);
  ASSERT_OK(rollcon_context_set_latch(context, 1));
  EXPECT_OK(rollcon_context_check(context));
  ASSERT_OK(rollcon_contact_get_stat(contact, "max_pressure", &number));
  EXPECT_EQ(number, before) << "nothing was set in between";
}

TEST_F(latch, is_off_until_it_is_set) {
  EXPECT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
  EXPECT_OK(rollcon_context_check(context));
  EXPECT_OK(rollcon_contact_set_rolling(contact, 1));
  EXPECT_FAILS(rollcon_context_set_latch(context, 2), ARGUMENT, "on is 2");
  ASSERT_OK(rollcon_context_set_latch(context, 1));
  EXPECT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
  ASSERT_OK(rollcon_context_set_latch(context, 0));
  EXPECT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
  EXPECT_OK(rollcon_contact_set_rolling(contact, 1));
  EXPECT_OK(rollcon_context_check(context));
  EXPECT_FAILS(rollcon_context_check(nullptr), ARGUMENT, "context is NULL");
}

TEST_F(latch, tells_of_the_first_caveat_without_stopping) {
  set_scene();
  ASSERT_OK(rollcon_context_set_latch(context, 1));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -1));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
  EXPECT_OK(rollcon_contact_solve(contact));
  EXPECT_EQ(rollcon_context_check(context), ROLLCON_NO_CONTACT);
  expect_text_of("rollcon_contact_solve", {rollcon_status_string(ROLLCON_NO_CONTACT)});
  EXPECT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_context_check(context), ROLLCON_ERR_ARGUMENT);
  expect_text_of("rollcon_contact_set_rolling", {"speed is -1"});
}

class last_caveat : public Api {};

TEST_F(last_caveat, says_what_is_known_of_the_case_and_stays_through_successes_and_failures) {
  set_scene();
  std::thread([] { EXPECT_STREQ(rollcon_last_caveat(), ""); }).join();
  ASSERT_OK(rollcon_contact_set_int(contact, "max_iterations", 1));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NOT_CONVERGED);
  const std::string text = rollcon_last_caveat();
  EXPECT_TRUE(text.starts_with(std::string("rollcon_contact_solve: ") + rollcon_status_string(ROLLCON_NOT_CONVERGED)))
      << text;
  EXPECT_NE(text.find("not converged after 1 iterations"), std::string::npos) << text;
  ASSERT_OK(rollcon_contact_set_int(contact, "max_iterations", 100));
  EXPECT_OK(rollcon_contact_solve(contact));
  EXPECT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_last_caveat(), text);
  // A note of an earlier call is not told of a later one.
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -1));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  EXPECT_EQ(rollcon_last_caveat(), std::string("rollcon_contact_solve: ") + rollcon_status_string(ROLLCON_NO_CONTACT));
}

TEST_F(last_caveat, names_nodes_at_the_rim) {
  set_scene();
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 1));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_RIM_CONTACT);
  EXPECT_NE(std::string(rollcon_last_caveat()).find("reaches the rim of the frame at "), std::string::npos)
      << rollcon_last_caveat();
}

TEST_F(latch, holds_failures_that_layers_report) {
  ASSERT_OK(rollcon_context_set_latch(context, 1));
  EXPECT_EQ(rollcon_report(contact, ROLLCON_ERR_ARGUMENT, "RCNODE: LDX is 2"), ROLLCON_ERR_ARGUMENT);
  EXPECT_EQ(rollcon_contact_set_rolling(contact, 1), ROLLCON_ERR_ARGUMENT);
  EXPECT_STREQ(rollcon_last_error(), "RCNODE: LDX is 2");
}
