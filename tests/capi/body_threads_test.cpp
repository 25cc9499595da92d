/// Tests a boundary-element body used by contacts in many threads, and new creepages on it.

#include "body_fixture.hpp"

using namespace capi_test;

class body_threads : public BodyApi {
 protected:
  void SetUp() override {
    BodyApi::SetUp();
    if (IsSkipped()) return;
    cube = CubeSurface(6);
    set_mesh(body);
    ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  }

  rollcon_contact* roll(rollcon_context* own) { return roll_on_top(own, body, plane); }

  double count(const char* name) {
    double value = -1;
    EXPECT_OK(rollcon_body_get_stat(body, name, &value));
    return value;
  }

  std::array<double, 3> solve_in_many_threads() {
    const auto force = force_in_many_threads(3, [&](rollcon_context* own) { return roll(own); });
    for (const char* name : {"assemblies", "factorizations", "condensations"}) EXPECT_EQ(count(name), 1) << name;
    return force;
  }
};

TEST_F(body_threads, one_that_is_checked_only_is_factorised_by_the_first_contact) {
  const std::array<double, 3> at_once = solve_in_many_threads();
  rollcon_body_release(body);
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_BEM, &body));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  set_mesh(body);
  ASSERT_OK(rollcon_body_set_int(body, "prepare", 0));
  EXPECT_FAILS(rollcon_body_prepare(body), SINGULAR, "no supports");
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_prepare(body));
  EXPECT_GT(count("unknowns"), 0);
  for (const char* name : {"assemblies", "factorizations", "condensations", "condition"})
    EXPECT_EQ(count(name), 0) << name;
  const std::array<double, 3> later = solve_in_many_threads();
  EXPECT_GT(count("condition"), 1);
  for (std::size_t c = 0; c < 3; ++c)  // sums by other numbers of threads
    EXPECT_NEAR(later[c], at_once[c], 1e-9 * std::abs(at_once[2]));
}

TEST_F(body_threads, without_factors_another_frame_assembles_again) {
  ASSERT_OK(rollcon_body_set_int(body, "keep_factors", 0));
  rollcon_contact* c = roll(context);
  ASSERT_OK(solve_small(c));
  ASSERT_OK(rollcon_contact_set_creep(c, 2e-2, 0, 0));
  ASSERT_OK(solve_small(c));
  EXPECT_EQ(count("assemblies"), 1) << "new creepages need none";
  const double first = count("bytes");
  const double origin[3] = {0.5, 1, 0.5}, rolling[3] = {1, 0, 0}, normal[3] = {0, 1, 0};
  const double mu = 0.3;
  ASSERT_OK(rollcon_contact_set_axes(c, origin, rolling, normal));
  ASSERT_OK(rollcon_contact_frame_from_body(c, 1, 4));
  ASSERT_OK(rollcon_contact_set_gap_quadratic(c, 0.5, 0.5, 0));
  ASSERT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
  // The side reaches down to the held bottom, whose nodes cannot be part of a frame.
  EXPECT_FAILS(rollcon_contact_solve(c), STATE, "support");
  EXPECT_EQ(count("assemblies"), 2) << "the factors were not kept";
  EXPECT_GE(count("bytes"), first) << "the compliance of both frames is";
  rollcon_contact_release(c);
}

TEST_F(body_threads, the_log_sink_may_ask_the_body_that_is_prepared) {
  struct Seen {
    rollcon_body* body;
    int messages = 0;
    std::int32_t status = 1;
  } seen{body};
  const auto sink = [](std::int32_t, const char*, void* user) {
    auto& s = *static_cast<Seen*>(user);
    if (s.messages++ == 0) s.status = rollcon_body_set_int(s.body, "keep_factors", 1);
  };
  ASSERT_OK(rollcon_context_set_log(context, ROLLCON_LOG_INFO, sink, &seen));
  rollcon_contact* c = roll(context);
  ASSERT_OK(solve_small(c));
  EXPECT_GT(seen.messages, 0);
  EXPECT_EQ(seen.status, ROLLCON_ERR_STATE) << "prepared: refused, but answered";
  ASSERT_OK(rollcon_context_set_log(context, 0, nullptr, nullptr));
  rollcon_contact_release(c);
}
