// Calls the functions of wheels on rails. Handles of the other kinds are in their place now and then.

#include "calls.hpp"

namespace fuzz {
namespace {

std::int32_t few(World& w, std::int32_t n) {
  return w.in.one_in(12) ? w.in.integer32() : w.in.below(n);
}

/// Returns values near a place at which the wheel of make_wheelrail touches; seldom anything.
std::vector<double> near(World& w, std::vector<double> values, double by) {
  for (double& v : values) {
    if (w.in.one_in(20))
      v = w.in.real();
    else
      v += by * (w.in.below(21) - 10) / 10;
  }
  return values;
}

/// Makes the profile vary, seldom.
void vary(World& w, rollcon_body* body, double spacing) {
  if (!w.in.one_in(4)) return;
  for (int i = w.in.below(5); i > 0; --i) {
    const std::vector<double> v = near(w, {(i - 2) * spacing, 0, 60, 999}, 0.2);
    const std::vector<double> feature(v.begin() + 1, v.end());
    FUZZ_CALL(w, rollcon_body_add_slice, body, v[0], w.in.one_in(3) ? 3 : 0, maybe_null(w.in, feature));
  }
  const std::vector<double> wave = near(w, {0.02, 6.283185307179586 / 20, 0}, 1e-3);
  if (w.in.one_in(3)) FUZZ_CALL(w, rollcon_body_add_wave, body, wave[0], wave[1], wave[2]);
}

void create(World& w) {
  if (w.wheelrails.size() >= 3) return;
  rollcon_context* c = w.context();
  rollcon_body* wheel = w.body();
  rollcon_body* rail = w.body();
  if (w.in.one_in(2)) {  // values of the pair below
    const double unit = 1;
    rollcon_body** const both[] = {&wheel, &rail};
    for (int i = 0; i < 2 && w.bodies.size() < 12; ++i) {
      if (rollcon_body_create(c, ROLLCON_BODY_HALFSPACE, both[i]) != ROLLCON_OK) return;
      w.add(*both[i], c);
      rollcon_body_set_elastic(*both[i], 0, 2.1e5, 0.28);
      rollcon_body_set_profile_shape(*both[i], i ? "60e1" : "s1002", 1, &unit);
      vary(w, *both[i], i ? 30 : 1);
    }
  }
  rollcon_wheelrail* made = nullptr;
  const std::int32_t side = w.in.one_in(12) ? w.in.integer32() : 2 * w.in.below(2) - 1;
  if (FUZZ_CALL(w, rollcon_wheelrail_create, c, wheel, rail, side, w.in.one_in(30) ? nullptr : &made) != ROLLCON_OK) {
    require(made == nullptr, "a handle of nothing");
    return;
  }
  w.add(made, c);
  const double position[6] = {0, 0, 0.2, 0, 0, 0}, velocity[6] = {2000, 0, 0, 0, 0, -4.348};
  rollcon_wheelrail_set_track(made, 1435, 14, 0.025);
  rollcon_wheelrail_set_wheelset(made, 1360, -70, 460);
  rollcon_wheelrail_set_position(made, position);
  rollcon_wheelrail_set_velocity(made, velocity);
  const double mu = 0.3;
  rollcon_wheelrail_set_friction(made, "coulomb", 1, &mu);
  rollcon_wheelrail_set_real(made, "accuracy", 1);
}

void retain(World& w) {
  rollcon_wheelrail* h = w.wheelrail();
  if (FUZZ_CALL(w, rollcon_wheelrail_retain, h) != ROLLCON_OK) return;
  for (auto& entry : w.wheelrails)
    if (entry.handle == h) ++entry.references;
}

void release(World& w) {
  rollcon_wheelrail* h = w.wheelrail();
  rollcon_wheelrail_release(h);
  for (auto& entry : w.wheelrails)
    if (entry.handle == h && entry.references > 0) --entry.references;
}

void set_dimensions(World& w) {
  rollcon_wheelrail* h = w.wheelrail();
  const std::vector<double> v = near(w, {1435, 14, 0.025, 1360, -70, 460}, 0.02);
  FUZZ_CALL(w, rollcon_wheelrail_set_track, h, v[0], v[1], v[2]);
  FUZZ_CALL(w, rollcon_wheelrail_set_wheelset, h, v[3], v[4], v[5]);
}

void set_state(World& w) {
  rollcon_wheelrail* h = w.wheelrail();
  const std::vector<double> at = near(w, {0, 0, 0.2, 0, 0, 0}, 0.05), rate = near(w, {2000, 0, 0, 0, 0, -4.348}, 0.1);
  FUZZ_CALL(w, rollcon_wheelrail_set_position, h, maybe_null(w.in, at));
  FUZZ_CALL(w, rollcon_wheelrail_set_velocity, h, maybe_null(w.in, rate));
  if (w.in.one_in(3))
    FUZZ_CALL(w, rollcon_wheelrail_set_rail_deviation, h, maybe_null(w.in, near(w, {0, 0, 0}, 0.01)),
              maybe_null(w.in, near(w, {0, 0, 0}, 0.01)));
}

void set_law(World& w) {
  rollcon_wheelrail* h = w.wheelrail();
  FUZZ_CALL(w, rollcon_wheelrail_prescribe_vertical, h, few(w, 3), w.in.one_in(4) ? w.in.real() : 1e4);
  const std::vector<double> parameters = w.in.reals(4);
  const double mu = w.in.positive();
  if (w.in.one_in(3))
    FUZZ_CALL(w, rollcon_wheelrail_set_friction, h, w.in.one_in(2) ? "by_angle" : "coulomb", few(w, 5),
              parameters.data());
  else
    FUZZ_CALL(w, rollcon_wheelrail_set_friction, h, "coulomb", 1, &mu);
  const std::vector<double> more = w.in.reals(12);
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_place_rail, h, w.in.real(), w.in.real(), w.in.real());
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_tape_circle, h, w.in.real());
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_flexibility, h, more.data(), more.data() + 6);
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_rail_springs, h, more.data(), more.data() + 2);
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_prescribe_longitudinal, h, few(w, 3), w.in.real());
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_real, h, "curvature", w.in.real());
  if (w.in.one_in(12)) FUZZ_CALL(w, rollcon_wheelrail_set_roller, h, w.in.real(), w.in.real());
  if (w.in.one_in(4)) FUZZ_CALL(w, rollcon_wheelrail_set_friction, h, "linear", 3, parameters.data());
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_law_by_angle, h, "linear", few(w, 2), 4, parameters.data());
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_friction_memory, h, w.in.real(), w.in.real());
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_layer, h, w.in.real(), w.in.real(), w.in.real());
  if (w.in.one_in(6)) FUZZ_CALL(w, rollcon_wheelrail_set_heat, h, few(w, 3), w.in.real(), w.in.real(), w.in.real());
  FUZZ_CALL(w, rollcon_wheelrail_set_real, h, "accuracy", w.in.one_in(6) ? w.in.real() : 0.1);
}

void solve(World& w) {
  rollcon_wheelrail* h = w.wheelrail();
  if (w.in.one_in(8)) FUZZ_CALL(w, rollcon_wheelrail_reset, h);
  if (w.in.one_in(8)) FUZZ_CALL(w, rollcon_wheelrail_set_step, h, few(w, 3), w.in.real());
  if (w.in.one_in(8)) FUZZ_CALL(w, rollcon_wheelrail_repeat_step, h);
  if (w.solves_left-- > 0) FUZZ_CALL(w, rollcon_wheelrail_solve, h);
}

void results(World& w) {
  const rollcon_wheelrail* h = w.wheelrail();
  Output<std::int64_t> patches(1);
  Output<double> force(3), moment(3), value(1);
  const std::string name = w.in.text(known_names());
  bool good = FUZZ_CALL(w, rollcon_wheelrail_get_patch_count, h, patches.data()) == ROLLCON_OK;
  require(good || patches.untouched(), "a failed call wrote into its output");
  good = FUZZ_CALL(w, rollcon_wheelrail_get_resultant, h, few(w, 2), force.data(),
                   w.in.one_in(4) ? nullptr : moment.data()) == ROLLCON_OK;
  require(good || (force.untouched() && moment.untouched()), "a failed call wrote into its output");
  good =
      FUZZ_CALL(w, rollcon_wheelrail_get_stat, h, w.in.one_in(40) ? nullptr : name.c_str(), value.data()) == ROLLCON_OK;
  require(good || value.untouched(), "a failed call wrote into its output");
  FUZZ_CALL(w, rollcon_wheelrail_get_patch_stat, h, few(w, 2), name.c_str(), value.data());
}

void get_contact(World& w) {
  if (w.contacts.size() >= 6) return;
  rollcon_wheelrail* h = w.wheelrail();
  rollcon_contact* made = nullptr;
  if (FUZZ_CALL(w, rollcon_wheelrail_get_contact, h, few(w, 2), &made) != ROLLCON_OK) {
    require(made == nullptr, "a handle of nothing");
    return;
  }
  w.add(made, const_cast<rollcon_context*>(w.context_of(h)));
}

}  // namespace

std::span<const Call> wheelrail_calls() {
  static const Call calls[] = {create,  retain, release, set_dimensions, set_state,
                               set_law, solve,  solve,   results,        get_contact};
  return calls;
}

}  // namespace fuzz
