/// Tests handles: NULL, released, of another kind, garbage; reference counts.

#include <random>

#include "capi/every_call.hpp"
#include "fixture.hpp"

using namespace capi_test;

namespace {

auto expecting(std::int32_t status) {
  return [status](const char* function, bool, std::int32_t got) {
    EXPECT_EQ(got, status) << function;
    const std::string text = rollcon_last_error();
    EXPECT_EQ(text.substr(0, text.find(':')), function) << text;
  };
}

const void* as_pointer(std::uint64_t bits) {
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(bits));
}

}  // namespace

class handles : public Api {};

TEST_F(handles, null_is_an_argument_error_and_release_of_null_is_legal) {
  with_each_context_call(nullptr, expecting(ROLLCON_ERR_ARGUMENT));
  with_each_body_call(nullptr, expecting(ROLLCON_ERR_ARGUMENT));
  with_each_contact_call(nullptr, expecting(ROLLCON_ERR_ARGUMENT));
  rollcon_context_release(nullptr);
  rollcon_body_release(nullptr);
  rollcon_contact_release(nullptr);
}

TEST_F(handles, handles_of_another_kind_are_refused) {
  with_each_context_call(sphere, expecting(ROLLCON_ERR_HANDLE));
  with_each_context_call(contact, expecting(ROLLCON_ERR_HANDLE));
  with_each_body_call(context, expecting(ROLLCON_ERR_HANDLE));
  with_each_body_call(contact, expecting(ROLLCON_ERR_HANDLE));
  with_each_contact_call(context, expecting(ROLLCON_ERR_HANDLE));
  with_each_contact_call(sphere, expecting(ROLLCON_ERR_HANDLE));
  rollcon_body_release(reinterpret_cast<rollcon_body*>(contact));
  std::int64_t nodes = -1;
  EXPECT_OK(rollcon_contact_get_size(contact, &nodes, nullptr));
}

TEST_F(handles, released_handles_stay_dead_when_their_slots_are_used_again) {
  rollcon_contact* dead_contact = nullptr;
  rollcon_body* dead_body = nullptr;
  rollcon_context* dead_context = nullptr;
  ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &dead_context));
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &dead_body));
  ASSERT_OK(rollcon_contact_create(context, sphere, plane, &dead_contact));
  rollcon_contact_release(dead_contact);
  rollcon_body_release(dead_body);
  rollcon_context_release(dead_context);
  for (int round = 0; round < 2; ++round) {
    with_each_context_call(dead_context, expecting(ROLLCON_ERR_HANDLE));
    with_each_body_call(dead_body, expecting(ROLLCON_ERR_HANDLE));
    with_each_contact_call(dead_contact, expecting(ROLLCON_ERR_HANDLE));
    rollcon_contact_release(dead_contact);
    for (int i = 0; i < 20; ++i) {
      rollcon_body* body = nullptr;
      ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &body));
      EXPECT_NE(body, dead_body);
      rollcon_body_release(body);
    }
  }
}

TEST_F(handles, dead_bodies_make_no_contact) {
  rollcon_body* dead = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &dead));
  rollcon_body_release(dead);
  auto* made = reinterpret_cast<rollcon_contact*>(context);
  EXPECT_FAILS(rollcon_contact_create(context, sphere, dead, &made), HANDLE, "body2");
  EXPECT_EQ(made, nullptr);
  EXPECT_FAILS(rollcon_contact_create(context, nullptr, sphere, &made), ARGUMENT, "body1");
  EXPECT_FAILS(rollcon_contact_create(context, sphere, plane, nullptr), ARGUMENT, "contact");
}

TEST_F(handles, any_64_bits_are_told_from_live_handles) {
  const auto live = [&](const void* handle) {
    return handle == context || handle == sphere || handle == plane || handle == contact;
  };
  std::mt19937_64 random(20100330);
  const int patterns = 100000;
  int refused = 0;
  std::int64_t n = 0;
  for (int i = 0; i < patterns; ++i) {
    // Half of the random numbers are in the range of true handles.
    std::uint64_t bits = random();
    if (i % 2) bits &= 0x7fffffffU;
    const void* handle = as_pointer(bits);
    if (!handle || live(handle)) continue;
    auto* as_contact = static_cast<rollcon_contact*>(const_cast<void*>(handle));
    ASSERT_EQ(rollcon_contact_get_size(as_contact, &n, nullptr), ROLLCON_ERR_HANDLE) << handle;
    ASSERT_EQ(rollcon_id_of(handle), 0) << handle;
    ++refused;
  }
  std::printf("garbage handles refused: %d of %d (bound: all but live ones and NULL)\n", refused, patterns);
  for (const std::uint64_t bits :
       {1ULL, 7ULL, 0x20000000ULL, 0x7fffffffULL, 0x80000000ULL, 0xffffffffULL, 0x7fff00000000ULL, ~0ULL}) {
    with_each_context_call(as_pointer(bits), expecting(ROLLCON_ERR_HANDLE));
    with_each_body_call(as_pointer(bits), expecting(ROLLCON_ERR_HANDLE));
    with_each_contact_call(as_pointer(bits), expecting(ROLLCON_ERR_HANDLE));
    rollcon_contact_release(static_cast<rollcon_contact*>(const_cast<void*>(as_pointer(bits))));
  }
  // A live handle with one bit changed is never another live object of the kind.
  for (int bit = 0; bit < 64; ++bit) {
    const auto value = reinterpret_cast<std::uintptr_t>(contact) ^ (std::uint64_t{1} << bit);
    auto* changed = reinterpret_cast<rollcon_contact*>(value);
    EXPECT_EQ(rollcon_contact_get_size(changed, &n, nullptr), ROLLCON_ERR_HANDLE) << bit;
  }
}

TEST_F(handles, integers_stand_for_handles) {
  const std::int32_t id = rollcon_id_of(contact);
  EXPECT_GT(id, 0);
  EXPECT_EQ(rollcon_contact_from_id(id), contact);
  EXPECT_EQ(rollcon_context_from_id(rollcon_id_of(context)), context);
  EXPECT_EQ(rollcon_body_from_id(rollcon_id_of(plane)), plane);
  EXPECT_EQ(rollcon_id_of(nullptr), 0);
  EXPECT_EQ(rollcon_contact_from_id(0), nullptr);
  for (const std::int32_t garbage : {-1, 1, 12345, INT32_MIN, INT32_MAX, rollcon_id_of(sphere)})
    EXPECT_EQ(rollcon_contact_reset(rollcon_contact_from_id(garbage)), ROLLCON_ERR_HANDLE);
}

TEST_F(handles, objects_live_as_long_as_their_references) {
  ASSERT_OK(rollcon_body_retain(plane));
  rollcon_body_release(plane);
  std::int32_t kind = 0;
  EXPECT_OK(rollcon_body_get_kind(plane, &kind));
  EXPECT_EQ(kind, ROLLCON_BODY_RIGID);
  rollcon_body_release(plane);
  EXPECT_EQ(rollcon_body_get_kind(plane, &kind), ROLLCON_ERR_HANDLE);
}

TEST_F(handles, contact_outlives_handles_of_bodies_and_context) {
  set_scene();
  rollcon_context_release(context);
  rollcon_body_release(sphere);
  rollcon_body_release(plane);
  EXPECT_OK(rollcon_contact_solve(contact));
  double force[3] = {0, 0, 0};
  EXPECT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
  EXPECT_LT(force[2], 0);
  EXPECT_EQ(rollcon_contact_set_rolling(contact, -1), ROLLCON_ERR_ARGUMENT);
}

TEST_F(handles, body_may_be_of_another_context) {
  rollcon_context* other = nullptr;
  rollcon_contact* made = nullptr;
  ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &other));
  EXPECT_OK(rollcon_contact_create(other, sphere, plane, &made));
  rollcon_contact_release(made);
  rollcon_context_release(other);
}

TEST_F(handles, running_out_of_them_is_a_memory_error) {
  std::vector<rollcon_body*> bodies;
  std::int32_t status = ROLLCON_OK;
  while (status == ROLLCON_OK && bodies.size() < 70000) {
    rollcon_body* body = nullptr;
    status = rollcon_body_create(context, ROLLCON_BODY_RIGID, &body);
    if (status == ROLLCON_OK) bodies.push_back(body);
  }
  EXPECT_EQ(status, ROLLCON_ERR_MEMORY);
  EXPECT_NE(error().find("65536"), std::string::npos) << error();
  std::printf("live handles: %zu, bound 65536\n", bodies.size() + 4);
  EXPECT_GT(bodies.size(), 65000U);
  for (rollcon_body* body : bodies) rollcon_body_release(body);
  rollcon_body* body = nullptr;
  EXPECT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &body));
  rollcon_body_release(body);
}

TEST(context, header_of_another_abi_is_refused) {
  auto* context = reinterpret_cast<rollcon_context*>(std::uintptr_t{1});
  EXPECT_EQ(rollcon_context_create(ROLLCON_ABI + 1, &context), ROLLCON_ERR_UNSUPPORTED);
  EXPECT_EQ(context, nullptr);
  EXPECT_EQ(rollcon_context_create(ROLLCON_ABI, nullptr), ROLLCON_ERR_ARGUMENT);
}
