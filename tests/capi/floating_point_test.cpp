/// Tests hosts with a floating-point environment of their own: trapping, rounding, flushing.

#include <cfenv>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "capi/every_call.hpp"
#include "fixture.hpp"

using namespace capi_test;

namespace {

constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

/// Traps while it lives: a quiet NaN made anywhere kills the program.
struct Trapping {
  Trapping() {
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(trapped);
  }
  ~Trapping() { fedisableexcept(FE_ALL_EXCEPT); }
};

std::int32_t expect_traps(const rollcon_event*, void* user) {
  EXPECT_EQ(fegetexcept(), trapped) << "callbacks run in the environment of the host";
  ++*static_cast<int*>(user);
  return 0;
}

void expect_traps_in_log(std::int32_t, const char*, void* user) {
  EXPECT_EQ(fegetexcept(), trapped);
  ++*static_cast<int*>(user);
}

}  // namespace

class floating_point : public Api {};

#define EXPECT_SURVIVES(call)            \
  do {                                   \
    {                                    \
      const Trapping trapping;           \
      (void)(call);                      \
      EXPECT_EQ(fegetexcept(), trapped); \
    }                                    \
  } while (0)

TEST_F(floating_point, hosts_that_trap_survive_every_call) {
  const double nan = std::numeric_limits<double>::signaling_NaN();
  const double origin[3] = {0, 0, 0};
  const double bad[3] = {nan, nan, nan};
  const auto n = frame.nodes;
  std::vector<double> gap, slip(static_cast<std::size_t>(2 * n), 0.0), field(static_cast<std::size_t>(n), 0.1),
      v(static_cast<std::size_t>(3 * n));
  std::vector<std::int32_t> status(static_cast<std::size_t>(n));
  for (std::int64_t i = 0; i < n; ++i)
    gap.push_back(0.01 * (frame.x[3 * i] * frame.x[3 * i] + frame.x[3 * i + 1] * frame.x[3 * i + 1]));
  const double points[6] = {0, 0, frame.x[0], frame.x[1], 40, -3};
  std::int32_t i32 = 0;
  std::int64_t i64 = 0;
  char text[4096];
  rollcon_context* context2 = nullptr;
  rollcon_body* body2 = nullptr;
  rollcon_contact* contact2 = nullptr;
  int logged = 0, progressed = 0;

  EXPECT_SURVIVES(rollcon_version());
  EXPECT_SURVIVES(rollcon_abi());
  EXPECT_SURVIVES(rollcon_version_string());
  EXPECT_SURVIVES(rollcon_build_info());
  EXPECT_SURVIVES(rollcon_has_feature("fem"));
  EXPECT_SURVIVES(rollcon_status_string(0));
  EXPECT_SURVIVES(rollcon_context_create(ROLLCON_ABI, &context2));
  EXPECT_SURVIVES(rollcon_context_set_log(context, ROLLCON_LOG_DEBUG, expect_traps_in_log, &logged));
  EXPECT_SURVIVES(rollcon_context_set_threads(context, 2));
  EXPECT_SURVIVES(rollcon_context_set_latch(context, 0));
  EXPECT_SURVIVES(rollcon_context_check(context));
  EXPECT_SURVIVES(rollcon_report(context, -1, "a failure"));
  EXPECT_SURVIVES(rollcon_last_error());
  EXPECT_SURVIVES(rollcon_body_create(context2, ROLLCON_BODY_HALFSPACE, &body2));
  EXPECT_SURVIVES(rollcon_contact_create(context2, body2, sphere, &contact2));
  {
    const Trapping trapping;
    const auto check = [](const char* name, bool, std::int32_t) { EXPECT_EQ(fegetexcept(), trapped) << name; };
    with_each_body_call(body2, check);
    with_each_contact_call(contact2, check);
    rollcon_body_release(body2);  // once for each time it was retained
    rollcon_contact_release(contact2);
  }
  EXPECT_SURVIVES(set_scene());
  EXPECT_SURVIVES(rollcon_body_set_elastic(body2, 0, nan, nan));
  EXPECT_SURVIVES(rollcon_contact_frame_nodes(contact2, 1, bad, 3, 1));
  EXPECT_SURVIVES(rollcon_contact_set_axes(contact, origin, bad, origin));
  EXPECT_SURVIVES(rollcon_contact_set_gap_quadratic(contact, nan, 0.01, 0));
  EXPECT_SURVIVES(rollcon_contact_set_gap(contact, n, gap.data()));
  EXPECT_SURVIVES(rollcon_contact_set_rolling(contact, nan));
  EXPECT_SURVIVES(rollcon_contact_set_creep(contact, 1e-3, 1e-4, 1e-4));
  EXPECT_SURVIVES(rollcon_contact_set_creep(contact, nan, nan, nan));
  EXPECT_SURVIVES(rollcon_contact_set_creep_field(contact, n, slip.data()));
  EXPECT_SURVIVES(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 300));
  EXPECT_SURVIVES(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, nan));
  EXPECT_SURVIVES(rollcon_contact_set_friction(contact, "coulomb", 1, bad));
  EXPECT_SURVIVES(rollcon_contact_set_friction_field(contact, n, field.data()));
  EXPECT_SURVIVES(rollcon_contact_set_real(contact, "tolerance", nan));
  EXPECT_SURVIVES(rollcon_option_count(ROLLCON_OF_CONTACT));
  EXPECT_SURVIVES(rollcon_option_info(ROLLCON_OF_CONTACT, 0, 4096, text, nullptr, &i64, &i32, v.data(), v.data() + 1,
                                      v.data() + 2));
  EXPECT_SURVIVES(rollcon_contact_set_progress(contact, expect_traps, &progressed));
  for (const char* scheme : {"godunov", "least_squares"}) {
    ASSERT_OK(rollcon_contact_set_str(contact, "convection", scheme));
    for (const char* solver : {"lu", "gmres"}) {
      ASSERT_OK(rollcon_contact_set_str(contact, "linear_solver", solver));
      EXPECT_SURVIVES(i32 = rollcon_contact_solve(contact));
      EXPECT_OK(i32);
      EXPECT_SURVIVES(rollcon_contact_reset(contact));
    }
  }
  EXPECT_SURVIVES(i32 = rollcon_contact_solve(contact));
  EXPECT_OK(i32);
  EXPECT_SURVIVES(rollcon_contact_get_size(contact, &i64, &i64));
  EXPECT_SURVIVES(rollcon_contact_get_tractions(contact, ROLLCON_GLOBAL, n, v.data()));
  for (std::int32_t f = ROLLCON_FIELD_POINT; f <= ROLLCON_FIELD_WEIGHT; ++f)
    EXPECT_SURVIVES(rollcon_contact_get_field(contact, f, ROLLCON_GLOBAL, 3 * n, v.data(), &i64));
  EXPECT_SURVIVES(rollcon_contact_get_node_states(contact, n, status.data()));
  EXPECT_SURVIVES(rollcon_contact_get_resultant(contact, ROLLCON_GLOBAL, v.data(), v.data() + 3));
  EXPECT_SURVIVES(rollcon_contact_get_motion(contact, v.data(), v.data() + 1));
  for (std::int32_t p = ROLLCON_LONGITUDINAL; p <= ROLLCON_FRICTION; ++p)
    EXPECT_SURVIVES(rollcon_contact_get_sensitivity(contact, p, v.data(), v.data() + 3, v.data() + 6, v.data() + 7));
  EXPECT_SURVIVES(rollcon_contact_get_displacements_at(contact, 1, 3, points, v.data()));
  EXPECT_SURVIVES(rollcon_contact_get_displacements_at(contact, 1, 1, bad, v.data()));
  const double inside[6] = {0, 0, 0, 0.3, 0.1, -0.2};
  EXPECT_SURVIVES(rollcon_contact_get_fields_at(contact, 1, 2, inside, ROLLCON_IN_CONTACT, v.data() + 12, v.data()));
  EXPECT_SURVIVES(rollcon_contact_get_fatigue_index(contact, 1, v.data()));
  EXPECT_SURVIVES(rollcon_stress_invariants(1, v.data(), v.data() + 6, v.data() + 9, v.data() + 10));
  for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_CONTACT); ++i) {
    EXPECT_SURVIVES(rollcon_stat_info(ROLLCON_OF_CONTACT, i, 4096, text, nullptr, &i64, &i32));
    EXPECT_SURVIVES(rollcon_contact_get_stat(contact, text, v.data()));
  }
  EXPECT_SURVIVES(rollcon_stat_count(ROLLCON_OF_CONTACT));
  EXPECT_SURVIVES(rollcon_contact_get_history(contact, "step", 1, v.data(), &i64));
  EXPECT_SURVIVES(rollcon_contact_get_plan(contact, 4096, text, &i64));
  EXPECT_SURVIVES(rollcon_contact_write(contact, "no/such/folder/out.vtu"));
  EXPECT_SURVIVES(rollcon_event_get_int(nullptr, ROLLCON_EVENT_PHASE, &i64));
  EXPECT_SURVIVES(rollcon_event_get_real(nullptr, ROLLCON_EVENT_SECONDS, v.data()));
  EXPECT_SURVIVES(rollcon_contact_request_cancel(contact));
  EXPECT_SURVIVES(i32 = rollcon_contact_solve(contact));
  EXPECT_OK(i32) << "nothing was running when the cancel was asked for";
  EXPECT_SURVIVES(rollcon_contact_from_id(rollcon_id_of(contact)));
  EXPECT_SURVIVES(rollcon_body_from_id(rollcon_id_of(sphere)));
  EXPECT_SURVIVES(rollcon_context_from_id(rollcon_id_of(context)));
  EXPECT_SURVIVES(rollcon_contact_release(contact2));
  EXPECT_SURVIVES(rollcon_body_release(body2));
  EXPECT_SURVIVES(rollcon_context_release(context2));
  EXPECT_GT(logged, 0);
  EXPECT_GT(progressed, 0);
}

TEST_F(floating_point, flags_and_rounding_of_the_host_come_back) {
  set_scene();
  std::feclearexcept(FE_ALL_EXCEPT);
  std::feraiseexcept(FE_UNDERFLOW);
  std::fesetround(FE_UPWARD);
  const std::int32_t status = rollcon_contact_solve(contact);
  const int rounding = std::fegetround(), flags = std::fetestexcept(FE_ALL_EXCEPT);
  double rounded_up[3], nearest[3];
  rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, rounded_up, nullptr);
  std::fesetround(FE_TONEAREST);
  std::feclearexcept(FE_ALL_EXCEPT);
  EXPECT_OK(status);
  EXPECT_EQ(rounding, FE_UPWARD);
  EXPECT_EQ(flags & ~FE_INEXACT, FE_UNDERFLOW);
  ASSERT_OK(rollcon_contact_reset(contact));
  ASSERT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, nearest, nullptr));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(rounded_up[i], nearest[i]) << "the host's rounding leaks in";
}

#ifdef __SSE2__
TEST_F(floating_point, flushing_of_subnormals_is_off_inside_and_back_outside) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040U);  // flush to zero, denormals are zero
  // The speed is positive, so legal; a library that flushed would see zero.
  const std::int32_t status = rollcon_contact_set_rolling(contact, tiny);
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_OK(status);
  EXPECT_EQ(after & 0x8040U, 0x8040U);
}
#endif
