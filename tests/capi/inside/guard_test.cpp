/// Tests that every failure inside becomes a status and a text, and that handles run out late.

#include "capi/guard.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "support/last_error.hpp"

using namespace rollcon;
using namespace rollcon::capi;

TEST(guard, every_status_thrown_inside_comes_out_with_its_text) {
  for (const Status status :
       {Status::err_argument, Status::err_handle, Status::err_nonfinite, Status::err_mesh, Status::err_state,
        Status::err_option, Status::err_capacity, Status::err_singular, Status::err_memory, Status::err_unsupported,
        Status::err_busy, Status::err_load, Status::err_io, Status::err_internal}) {
    Context context;
    EXPECT_EQ(guarded("rollcon_some_call", &context, [&] { fail(status, "entry %d", 7); }),
              static_cast<std::int32_t>(status));
    EXPECT_STREQ(last_error(), "rollcon_some_call: entry 7");
  }
}

TEST(guard, positive_statuses_pass_without_a_text) {
  for (const Status status : {Status::ok, Status::not_converged, Status::no_contact, Status::cancelled,
                              Status::rim_contact, Status::coarse}) {
    Context context;
    set_last_error(nullptr, "an older one");
    context.set_latch(true);
    EXPECT_EQ(guarded("rollcon_some_call", &context, [&] { return status; }), static_cast<std::int32_t>(status));
    EXPECT_STREQ(last_error(), "an older one");
    EXPECT_EQ(context.tell_kept(), status) << "the latch keeps what is no failure, too";
  }
}

TEST(guard, foreign_exceptions_are_mapped) {
  Context context;
  EXPECT_EQ(guarded("f", &context, [] { throw std::bad_alloc(); }), ROLLCON_ERR_MEMORY);
  EXPECT_EQ(guarded("f", &context, [] { throw std::out_of_range("x"); }), ROLLCON_ERR_INTERNAL);
  EXPECT_STREQ(last_error(), "f: x");
  EXPECT_EQ(guarded("f", &context, [] { throw 1; }), ROLLCON_ERR_INTERNAL);
  EXPECT_EQ(guarded("f", nullptr, [] { throw 1; }), ROLLCON_ERR_INTERNAL);
}

TEST(guard, log_sinks_that_throw_are_contained) {
  Context context;
  context.set_log(
      4, [](std::int32_t, const char*, void*) { throw 1; }, nullptr);
  EXPECT_EQ(guarded("f", &context, [] { fail(Status::err_io, "disk"); }), ROLLCON_ERR_IO);
  EXPECT_STREQ(last_error(), "f: disk");
}

TEST(handle_table, slots_come_back_in_turn_and_never_with_an_old_number) {
  HandleTable table;
  const auto object = std::make_shared<Object>();
  const void* first = table.insert(Kind::body, object);
  const void* second = table.insert(Kind::body, object);
  table.release(Kind::body, second);
  table.release(Kind::body, first);
  const void* third = table.insert(Kind::contact, object);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(third) & 0xffff, reinterpret_cast<std::uintptr_t>(second) & 0xffff);
  EXPECT_EQ(table.find(Kind::body, second), nullptr);
  EXPECT_EQ(table.find(Kind::body, third), nullptr);
  EXPECT_EQ(table.find(Kind::contact, third), object);
}

TEST(handle_table, slots_retire_when_their_generations_are_used_up) {
  HandleTable table;
  const auto object = std::make_shared<Object>();
  const void* first = table.insert(Kind::body, object);
  const void* handle = first;
  const auto slot_of = [](const void* h) { return reinterpret_cast<std::uintptr_t>(h) & 0xffff; };
  std::int64_t lives = 0;
  for (; slot_of(handle) == slot_of(first); ++lives) {
    ASSERT_TRUE(lives == 0 || handle != first) << "number given out twice after " << lives;
    ASSERT_NE(table.release(Kind::body, handle), nullptr);
    handle = table.insert(Kind::body, object);
  }
  std::printf("lives of a slot: %lld (expected 4095)\n", static_cast<long long>(lives));
  EXPECT_EQ(lives, 4095);
  EXPECT_EQ(table.find(Kind::body, first), nullptr);
}

TEST(handle_table, reference_counts) {
  HandleTable table;
  const void* handle = table.insert(Kind::body, std::make_shared<Object>());
  EXPECT_TRUE(table.retain(Kind::body, handle));
  EXPECT_FALSE(table.retain(Kind::contact, handle));
  EXPECT_EQ(table.release(Kind::body, handle), nullptr);
  EXPECT_NE(table.find(Kind::body, handle), nullptr);
  EXPECT_NE(table.release(Kind::body, handle), nullptr);
  EXPECT_EQ(table.release(Kind::body, handle), nullptr);
  EXPECT_FALSE(table.retain(Kind::body, handle));
}
