/// Tests handles of wheels and of the contacts of their patches: kinds, lives, busy ones.

#include <cstring>

#include "capi/every_call.hpp"
#include "wheelrail_fixture.hpp"

using namespace capi_test;

using wheelrail_handles = Wheel;

TEST_F(wheelrail_handles, handles_of_other_kinds_make_none_and_are_none) {
  auto* w = reinterpret_cast<rollcon_wheelrail*>(context);
  EXPECT_FAILS(rollcon_wheelrail_create(context, nullptr, rail, ROLLCON_LEFT, &w), ARGUMENT, "wheel is NULL");
  EXPECT_EQ(w, nullptr);
  EXPECT_FAILS(rollcon_wheelrail_create(context, wheel, reinterpret_cast<rollcon_body*>(right), ROLLCON_LEFT, &w),
               HANDLE, "rail");
  EXPECT_FAILS(rollcon_wheelrail_create(context, wheel, rail, 0, &w), ARGUMENT, "side is 0", "-1 (left), 1 (right)");
  EXPECT_FAILS(rollcon_wheelrail_create(context, wheel, rail, ROLLCON_LEFT, nullptr), ARGUMENT, "wheelrail is NULL");
  rollcon_body* bare = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &bare));
  EXPECT_FAILS(rollcon_wheelrail_create(context, bare, rail, ROLLCON_LEFT, &w), STATE, "profile");
  EXPECT_EQ(w, nullptr);
  rollcon_body_release(bare);
  const auto refused = [](std::int32_t status) {
    return [status](const char* name, bool, std::int32_t got) {
      EXPECT_EQ(got, status) << name;
      expect_text_of(name, {"wheelrail"});
    };
  };
  with_each_wheelrail_call(nullptr, refused(ROLLCON_ERR_ARGUMENT));
  for (const void* other : {static_cast<void*>(context), static_cast<void*>(wheel)})
    with_each_wheelrail_call(other, refused(ROLLCON_ERR_HANDLE));
  with_each_contact_call(right,
                         [](const char* name, bool, std::int32_t got) { EXPECT_EQ(got, ROLLCON_ERR_HANDLE) << name; });
  rollcon_wheelrail* dead = made(ROLLCON_LEFT);
  rollcon_wheelrail_release(dead);
  with_each_wheelrail_call(dead, refused(ROLLCON_ERR_HANDLE));
  const std::int32_t id = rollcon_id_of(right);
  EXPECT_GT(id, 0);
  EXPECT_EQ(rollcon_wheelrail_from_id(id), right);
}

TEST_F(wheelrail_handles, a_contact_shows_its_patch_and_outlives_it) {
  give(right);
  ASSERT_OK(rollcon_wheelrail_solve(right));
  rollcon_contact *contact = nullptr, *again = nullptr;
  ASSERT_OK(rollcon_wheelrail_get_contact(right, 0, &contact));
  ASSERT_OK(rollcon_wheelrail_get_contact(right, 0, &again));
  double force[3], later[3], pressure = 0;
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
  EXPECT_NEAR(-force[2], patch_stat(right, "normal_force"), 1e-9 * 9799);
  EXPECT_NEAR(force[0], patch_stat(right, "longitudinal_force"), 1e-9 * 9799);
  EXPECT_NEAR(force[1], patch_stat(right, "lateral_force"), 1e-9 * 9799);
  ASSERT_OK(rollcon_contact_get_stat(contact, "max_pressure", &pressure));
  // The contact solves the frame of the strips anew.
  EXPECT_NEAR(pressure, patch_stat(right, "max_pressure"), 1e-9 * pressure);

  ASSERT_OK(rollcon_wheelrail_prescribe_vertical(right, ROLLCON_BY_FORCE, 20000));
  ASSERT_OK(rollcon_wheelrail_solve(right));
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, later, nullptr));
  EXPECT_NEAR(-later[2], patch_stat(right, "normal_force"), 1e-9 * 19600);
  EXPECT_GT(-later[2], -1.9 * force[2]);

  rollcon_contact_release(again);
  rollcon_wheelrail_release(right);
  rollcon_body_release(wheel);
  rollcon_body_release(rail);
  right = nullptr;
  wheel = rail = nullptr;
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
  EXPECT_EQ(std::memcmp(force, later, sizeof force), 0);
  EXPECT_FAILS(rollcon_contact_solve(contact), STATE, "wheel on its rail");
  EXPECT_FAILS(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 3, 2, -1, 1, -1, 1), STATE, "wheel on its rail");
  rollcon_contact_release(contact);
  EXPECT_EQ(rollcon_contact_reset(contact), ROLLCON_ERR_HANDLE);
}

namespace {

struct Watched {
  rollcon_wheelrail* wheelrail;
  rollcon_contact* contact;
  int calls;
};

// Both owners of a patch are busy while it is solved.
std::int32_t ROLLCON_CALL ask_owners(const rollcon_event*, void* user) {
  auto& watched = *static_cast<Watched*>(user);
  ++watched.calls;
  const double mu = 0.1;
  EXPECT_EQ(rollcon_contact_set_friction(watched.contact, "coulomb", 1, &mu), ROLLCON_ERR_BUSY);
  EXPECT_EQ(rollcon_wheelrail_set_friction(watched.wheelrail, "coulomb", 1, &mu), ROLLCON_ERR_BUSY);
  return 1;
}

}  // namespace

TEST_F(wheelrail_handles, contacts_are_busy_while_it_solves_and_may_cancel) {
  give(right);
  ASSERT_OK(rollcon_wheelrail_solve(right));
  Watched watched{right, nullptr, 0};
  ASSERT_OK(rollcon_wheelrail_get_contact(right, 0, &watched.contact));
  ASSERT_OK(rollcon_contact_set_progress(watched.contact, ask_owners, &watched));
  const double mu = 0.25;
  ASSERT_OK(rollcon_wheelrail_set_friction(right, "coulomb", 1, &mu));
  EXPECT_EQ(rollcon_wheelrail_solve(right), ROLLCON_CANCELLED);
  EXPECT_GT(watched.calls, 0);
  // The callback belongs to the contact, however many handles it has.
  rollcon_contact_release(watched.contact);
  ASSERT_OK(rollcon_wheelrail_get_contact(right, 0, &watched.contact));
  ASSERT_OK(rollcon_contact_set_progress(watched.contact, nullptr, nullptr));
  rollcon_contact_release(watched.contact);
  EXPECT_OK(rollcon_wheelrail_solve(right));
}
