// Reads cases of module 1.
#include <algorithm>
#include <cmath>

#include "inp_case.hpp"
#include "log.hpp"

namespace cntc {

void InpCase::read_wheel() {
  Digits& d = v_.digits;
  const auto c = in_.control(7, "C-P-B-T-N-F-S");
  if (c[0] != 0 && c[0] != 1 && c[0] != 4 && c[0] != 5) in_.fail(print("C1 is %d; allowed: 0, 1, 4, 5", c[0]));
  if (c[2] != 0 && c[2] != 1 && c[2] != 5 && c[2] != 6) in_.fail(print("B is %d; allowed: 0, 1, 5, 6", c[2]));
  if (c[5] != 0 && c[5] != 1 && c[5] != 3) in_.fail(print("F is %d; allowed: 0, 1, 3", c[5]));
  if (c[5] == 1 && c[4] != 1) in_.fail("F = 1 needs N = 1");
  in_.in_range(c[1], 0, 3, "P");
  d.config = c[0];
  d.pvtime = first_ ? 2 : c[1];
  d.bound = c[2];
  d.tang = c[3];
  d.norm = c[4];
  d.force = c[5];
  subs_ = c[6];
  int m2 = 1;
  const auto l = in_.control(7, "V-L-D-C-M-Z-E", &m2);
  in_.in_range(l[0], 0, 2, "V");
  in_.in_range(l[2], 0, 9, "D");
  in_.in_range(l[3], 0, 4, "C3");
  in_.in_range(l[4], 0, 7, "M");
  in_.in_range(l[5], 0, 3, "Z");
  in_.in_range(l[6], 0, 5, "E");
  if (first_ && l[1] == 1) in_.fail("L is 1 in the first case: there is no friction to keep");
  if (first_ && l[2] == 0) in_.fail("D is 0 in the first case: there is no grid to keep");
  const bool keep_friction = l[1] == 1;
  if (keep_friction && l[0] != v_.friction.variation) in_.fail("V must not change while L is 1");
  v_digit_ = l[0];
  if (!keep_friction) d.frclaw = l[1];
  if (l[2] >= 2) d.discns = l[2];
  d.inflcf = l[3] >= 2 ? l[3] : d.inflcf;
  d.mater = l[4];
  if (m2 != 1) d.damping = m2;
  read_last_control();
  check_digits(d.heat);
  if (!keep_friction) read_friction();
  const int kept = d.inflcf;
  d.inflcf = l[3];
  read_material(true);
  d.inflcf = l[3] >= 2 ? l[3] : kept;
  if (d.heat == 3) {
    for (Heat& heat : v_.heat) {
      const auto q = in_.reals(4, "BKTEMP, HEATCP, LAMBDA, DENS");
      heat = {q[0], q[1], q[2], q[3]};
    }
    if (d.mater == 4) v_.betapl = in_.reals(1, "BETAPL")[0];
  }
  if (l[2] >= 2) read_plane_grid();
  read_track(l[5]);
  read_wheelset(l[6], true);
  read_subsurface();
}

void InpCase::read_plane_grid() {
  const auto q = in_.reals(6, 2, "DX, DS, DQREL, A_SEP, D_SEP, D_COMB");
  if (!(q[0] > 0) || !(q[1] > 0) || !(q[2] > 0)) in_.fail("DX, DS and DQREL must be above 0");
  PlaneGrid& g = v_.plane;
  g.dx = q[0];
  g.ds = q[1];
  v_.dq = q[2];
  g.a_sep = q[3];
  g.d_sep = q[4];
  g.d_comb = q[5];
  g.d_turn = q.size() > 6 ? q[6] : 2 * g.d_sep - g.d_comb;
  g.g_miss = q.size() > 7 ? q[7] : -1;
}

void InpCase::read_track(int z) {
  Track& t = v_.track;
  if (z == 1 || z == 3) {
    const auto q = in_.reals(4, 1, "GAUGHT, GAUGSQ, GAUGWD, CANT");
    t.gaught = q[0];
    if (q[0] > 0) {
      t.gaugsq = q[1];
      t.gaugwd = q[2];
    } else {
      t.raily0 = q[1];
      t.railz0 = q[2];
    }
    const bool roller = v_.digits.roller();
    (roller ? t.nomrad : t.cant) = q[3];
    if (roller) t.cant = 0;
    t.curv = q.size() > 4 ? q[4] : 0;
  }
  if (z == 3) read_profile(v_.rail, false);
  if (z >= 2) {
    const auto q = in_.reals(6, "DYRAIL, DZRAIL, DROLLR, VYRAIL, VZRAIL, VROLLR");
    t.deviation = {q[0], q[1], q[2]};
    t.rate = {q[3], q[4], q[5]};
  }
  if (z >= 1 && v_.digits.force == 3) {
    const auto q = in_.reals(4, 1, "KYRAIL, FYRAIL, KZRAIL, FZRAIL");
    t.ky = q[0];
    t.fy = q[1];
    t.kz = q[2];
    t.fz = q[3];
    t.dystep = q.size() > 4 ? q[4] : 1;
  }
}

void InpCase::read_wheelset(int e, bool motion) {
  Wheelset& w = v_.wheelset;
  if (e == 3 || e == 5) {
    const auto q = in_.reals(3, 1, "FBDIST, FBPOS, NOMRADW");
    w.fbdist = q[0];
    w.fbpos = q[1];
    w.nomrad = q[2];
    w.ytape = q.size() > 3 ? q[3] : 1000;
    read_profile(v_.wheel, true);
  }
  if (!motion) return;
  if (e >= 1) {
    const auto q = in_.reals(6, "S, Y, Z or FZ, ROLL, YAW, PITCH");
    const double z = w.position[2];
    std::copy(q.begin(), q.end(), w.position.begin());
    if (v_.digits.norm == 1) {
      w.position[2] = z;
      v_.fz = q[2];
    }
  }
  if (e >= 2) {
    const auto q = in_.reals(6, "VS, VY, VZ, VROLL, VYAW, VPITCH or FX");
    const double pitch = w.velocity[5];
    std::copy(q.begin(), q.end(), w.velocity.begin());
    if (v_.digits.force == 1) {
      w.velocity[5] = pitch;
      v_.fx = q[5];
    }
  }
  w.flexibility = {};
  if (e >= 4) {
    const auto q = in_.reals(12, "the wheel's deflection and its rates");
    std::copy(q.begin(), q.end(), w.flexibility.begin());
  }
}

void InpCase::read_simpack() {
  Digits& d = v_.digits;
  const Digits kept = d;
  const auto c = in_.control(7, "C-P-B-T-N-F-S");
  d.bound = c[2];
  d.tang = c[3];
  int m2 = 1;
  const auto l = in_.control(7, "V-L-D-C-M-Z-E", &m2);
  in_.in_range(l[0], 0, 2, "V");
  in_.in_range(l[4], 0, 7, "M");
  if (l[5] != 0 && l[5] != 3) in_.fail("Z is 0 or 3");
  if (l[6] != 0 && l[6] != 3) in_.fail("E is 0 or 3");
  v_digit_ = l[0];
  const bool keep_friction = l[1] == 1;
  if (!keep_friction) d.frclaw = l[1];
  if (l[2] >= 2) d.discns = l[2];
  d.inflcf = l[3];
  d.mater = l[4];
  if (m2 != 1) d.damping = m2;
  read_last_control();
  const int g = d.gausei, output = d.output, matfil = d.matfil;
  d.heat = kept.heat;
  subs_ = 0;
  check_digits(0);
  if (!keep_friction) read_friction();
  read_material(true);
  if (l[2] >= 2) read_plane_grid();
  const int bound = d.bound, tang = d.tang, law = d.frclaw, grid = d.discns, mater = d.mater, damping = d.damping;
  d = kept;
  d.bound = bound;
  d.tang = tang;
  d.frclaw = law;
  d.discns = grid;
  d.mater = mater;
  d.damping = damping;
  d.gausei = g;
  d.output = output;
  d.matfil = matfil;
  if (l[3] >= 2) d.inflcf = l[3];
  read_track(l[5]);
  read_wheelset(l[6], false);
}

}  // namespace cntc
