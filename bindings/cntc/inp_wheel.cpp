// Reads cases of module 1.
#include "inp_case.hpp"

namespace cntc {

void InpCase::read_wheel() {
  Digits& d = v_.digits;
  const auto c = in_.control(
      {{"C1", "0145"}, {"P", "0123"}, {"B", "0156"}, {"T", "0123"}, {"N", "01"}, {"F", "013"}, {"S", "0123"}});
  if (c[5] == 1 && c[4] != 1) in_.fail("F = 1 needs N = 1");
  d.config = c[0];
  d.pvtime = first_ ? 2 : c[1];
  d.bound = c[2];
  d.tang = c[3];
  d.norm = c[4];
  d.force = c[5];
  const auto l = read_second_control({"012", "0123456789", "01234", "0123", "012345"});
  if (l[1] == 1 && l[0] != v_.friction.variation) in_.fail("V must not change while L is 1");
  read_last_control();
  check_case(l[1], l[2]);
  read_wheel_data(l, true);
  read_subsurface(c[6]);
}

void InpCase::read_wheel_data(const std::vector<int>& control, bool motion) {
  if (control[2] >= 2) v_.digits.discns = control[2];
  if (control[1] != 1) read_friction(control[0], control[1]);
  read_material(control[3]);
  if (control[2] >= 2) read_plane_grid();
  read_track(control[5]);
  read_wheelset(control[6], motion);
}

void InpCase::read_plane_grid() {
  auto q = in_.reals(6, 2, "DX, DS, DQREL, A_SEP, D_SEP, D_COMB");
  set(set_rolling_step, 0., q[2]);
  q.erase(q.begin() + 2);
  give(set_potential_contact, -1, q);
}

void InpCase::read_track(int z) {
  const bool roller = v_.digits.roller();
  if (z == 1 || z == 3) {
    const auto q = in_.reals(4, 1, "GAUGHT, GAUGSQ, GAUGWD, CANT");
    give(set_track, 1, {q[0], q[1], q[2], roller ? 0 : q[3], roller ? q[3] : v_.track.nomrad, q.size() > 4 ? q[4] : 0});
  }
  if (z == 3) read_profile(false);
  if (z >= 2) give(set_track, 2, in_.reals(6, "DYRAIL, DZRAIL, DROLLR, VYRAIL, VZRAIL, VROLLR"));
  if (z >= 2 && v_.digits.force == 3) give(set_track, 32, in_.reals(4, 1, "KYRAIL, FYRAIL, KZRAIL, FZRAIL"));
}

void InpCase::read_wheelset(int e, bool motion) {
  const Wheelset& w = v_.wheelset;
  const Digits digits = v_.digits;
  if (e == 3 || e == 5) {
    give(set_wheelset_dimensions, e, in_.reals(3, 1, "FBDIST, FBPOS, NOMRADW"));
    read_profile(true);
  }
  if (!motion) return;
  if (e >= 1) {
    auto q = in_.reals(6, "S, Y, Z or FZ, ROLL, YAW, PITCH");
    if (digits.norm == 1) {
      set(set_vertical_force, q[2]);
      q[2] = w.position[2];
    }
    give(set_wheelset_position, e, q);
  }
  if (e >= 2) {
    auto q = in_.reals(6, "VS, VY, VZ, VROLL, VYAW, VPITCH or FX");
    if (digits.force == 1) {
      set(set_tangential_forces, q[5], 0.);
      q[5] = w.velocity[5];
    }
    give(set_wheelset_velocity, e, q);
  }
  if (e >= 4) give(set_wheelset_flexibility, e, in_.reals(12, "the wheel's deflection and its rates"));
}

void InpCase::read_simpack() {
  Digits& d = v_.digits;
  const Digits kept = d;
  const auto c = in_.control({{"C1", "0123456789"},
                              {"P", "0123456789"},
                              {"B", "0123456789"},
                              {"T", "0123"},
                              {"N", "0123456789"},
                              {"F", "0123456789"},
                              {"S", "0123456789"}});
  d.bound = c[2];
  d.tang = c[3];
  const auto l = read_second_control({"012", "0123456789", "01234", "03", "03"});
  read_last_control();
  heat_ = 0;
  for (int Digits::*digit : {&Digits::config, &Digits::pvtime, &Digits::norm, &Digits::force, &Digits::heat,
                             &Digits::sens, &Digits::iestim, &Digits::xflow, &Digits::flow, &Digits::ret})
    d.*digit = kept.*digit;
  read_wheel_data(l, false);
}

}  // namespace cntc
