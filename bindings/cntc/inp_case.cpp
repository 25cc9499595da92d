// Reads what cases of both modules have in common.
#include "inp_case.hpp"

#include <algorithm>
#include <cmath>

#include "log.hpp"
#include "text.hpp"

namespace cntc {

void InpCase::read_last_control() {
  const std::vector<int> d = in_.control(8, "X-H-G-I-A-O-W-R");
  Digits& q = v_.digits;
  q.xflow = d[0];
  q.heat = d[1] == 1 ? q.heat : d[1];
  in_.in_range(d[0], 0, 1, "X");
  if (d[1] == 2 || d[1] > 3) in_.fail(print("H is %d; allowed: 0, 1, 3", d[1]));
  in_.in_range(d[2], 0, 6, "G");
  in_.in_range(d[3], 0, 3, "I");
  in_.in_range(d[4], 0, 2, "A");
  in_.in_range(d[5], 0, 6, "O");
  in_.in_range(d[7], 0, 3, "R");
  q.gausei = d[2];
  q.iestim = first_ ? 0 : d[3];
  q.matfil = d[4];
  q.output = d[5];
  q.flow = d[6];
  q.ret = d[7];
  if (d[0] == 1) in_.control(8, "P-S-F-L-C-I-N");
  if (q.gausei != 1) read_solver();
}

void InpCase::read_solver() {
  const int g = v_.digits.gausei;
  SolverSettings& s = v_.solver;
  const auto head = in_.reals(5, 1, "MAXGS, MAXIN, MAXNR, MAXOUT, EPS");
  const auto count = [](double x) { return int(std::clamp(x, -1e9, 1e9)); };
  s.maxgs = count(head[0]);
  s.maxin = count(head[1]);
  s.maxnr = count(head[2]);
  s.maxout = count(head[3]);
  s.reals[0] = head[4];
  if (head.size() > 5 && p_.module == 1) v_.digits.npomax = std::clamp(count(head[5]), 100, 1000000);
  static const int more[] = {0, 0, 4, 4, 2, 8, 0};
  if (more[g]) {
    const auto values = in_.reals(more[g], "settings of the solver");
    std::copy_n(values.begin(), std::min<size_t>(values.size(), 7), s.reals.begin() + 1);
  }
}

void InpCase::read_friction_line(int law, bool with_place) {
  static const int counts[] = {2, 0, 5, 5, 5, 0, 4};
  const auto q = in_.reals(counts[law] + with_place, "parameters of friction");
  FrictionRow row;
  if (with_place) row.place = q[0];
  std::copy(q.begin() + with_place, q.end(), row.p.begin());
  v_.friction.rows.push_back(row);
}

/// Lines of friction; V = 3 has one for each row of elements, of which rollcon takes the coefficients of rest.
void InpCase::read_friction() {
  const int law = v_.digits.frclaw;
  v_.friction.law = law;
  v_.friction.variation = v_digit_;
  v_.friction.rows.clear();
  v_.friction.memdst = v_.friction.mem_s0 = 0;
  if (v_digit_ == 0) {
    read_friction_line(law, false);
  } else {
    const int n = in_.integer("NVF");
    in_.in_range(n, 1, 10000, "NVF");
    for (int k = 0; k < n; ++k) {
      read_friction_line(law, true);
      const auto& rows = v_.friction.rows;
      if (k > 0 && !(rows[size_t(k)].place > rows[size_t(k - 1)].place)) in_.fail("places of friction must increase");
    }
  }
  if (law >= 2) {
    const auto q = in_.reals(2, "MEMDST, MEM_S0");
    v_.friction.memdst = q[0];
    v_.friction.mem_s0 = q[1];
  }
}

/// Material lines; what only belongs to bodies that rollcon does not have is read over.
void InpCase::read_material(bool wheel) {
  Digits& d = v_.digits;
  Material& m = v_.material;
  if (d.inflcf >= 2) {
    if (d.inflcf == 4) {
      const auto q = in_.reals(wheel ? 2 : 3, "IF_METH, VARIANT");
      d.ifmeth = std::clamp(int(std::clamp(q[0], 0., 1.)), 0, 1);
      d.ifvari = int(std::clamp(q[1], 1., 4.));
      const int n = wheel ? 0 : int(std::clamp(q[2], 0., 1e5));
      if (n > 0) in_.reals(2 * n, "Y, ALPHA");
    }
    if (d.inflcf == 9) in_.fail("influence coefficients from a file (C3 = 9) are not available");
    const auto q = in_.reals(4, "POISS, GG");
    for (const size_t k : {0u, 1u})
      if (!(q[k] > -1 && q[k] <= .5) || !(q[2 + k] > 0))
        in_.fail("Poisson's ratios are above -1 and at most 0.5, shear moduli above 0");
    m.nu = {q[0], q[1]};
    m.g = {q[2], q[3]};
    if (d.bound == 1) in_.reals(1, "FLXZ");
    static const int more[] = {0, 4, 4, 3, 4, 3, 0, 0};
    m.more = {};
    if (more[d.mater]) {
      const auto values = in_.reals(more[d.mater], "parameters of the material");
      std::copy(values.begin(), values.end(), m.more.begin());
    }
  }
  if (d.damping == 2) {
    const auto q = in_.reals(4, "CDAMPN, CDAMPT, DFNMAX, DFTMAX");
    m.cdampn = q[0];
    m.cdampt = q[1];
    m.dfnmax = q[2];
    m.dftmax = q[3];
  }
}

void InpCase::check_digits(int heat_step) {
  const Digits& d = v_.digits;
  in_.in_range(d.tang, 0, 3, "T");
  in_.in_range(d.norm, 0, 1, "N");
  in_.in_range(subs_, 0, 3, "S");
  in_.in_range(d.mater, 0, 7, "M");
  const int law = d.frclaw;
  if (law > 6 || law == 5) in_.fail(print("L is %d; allowed: 0 to 4, 6", law));
  if (d.mater == 1 && d.tang != 3) in_.fail("M = 1 needs T = 3");
  if (heat_step && d.tang != 3) in_.fail("H >= 1 needs T = 3");
  if (first_ && (subs_ == 1 || subs_ == 2)) in_.fail("S is 1 or 2 in the first case: there are no blocks to keep");
}

void InpCase::read_profile(ProfileInput& profile, bool wheel) {
  std::vector<double> q;
  ProfileInput next;
  next.path = in_folder(folder_, in_.text(q, wheel ? "the wheel's profile" : "the rail's profile"));
  next.given = true;
  next.wheel = wheel;
  next.number = profile.number + 1;
  const auto value = [&](size_t k, double standard) { return q.size() > k ? q[k] : standard; };
  next.mirror_y = int(std::clamp(value(0, 0), -9., 9.));
  next.scale = value(1, 1);
  next.smoothing = value(2, 0);
  next.mirror_z = int(std::clamp(value(3, 0), -9., 9.));
  const int options = int(std::clamp(value(4, 0), 0., 9.));
  if (options >= 1)
    next.smoothing_kind = int(std::clamp(in_.reals(5, "ISMOOTH, ZIGTHRS, KINKHIGH, KINKLOW, KINKWID")[0], 0., 9.));
  if (options >= 2) in_.reals(2, "ERRHND, MAXOMIT");
  profile = std::move(next);
}

/// Blocks of points inside the bodies; S = 2 keeps those of the case before.
void InpCase::read_subsurface() {
  if (subs_ < 2) return;
  const auto head = in_.reals(2, "MATFIL, OUTPUT");
  v_.digits.sbsfil = int(std::clamp(head[0], 0., 2.));
  v_.digits.sbsout = int(std::clamp(head[1], 0., 4.));
  if (subs_ != 3) return;
  p_.blocks.clear();
  auto& to = p_.blocks[p_.module == 1 ? -1 : p_.icp];
  for (;;) {
    const int isubs = in_.integer("ISUBS");
    if (isubs == 0) return;
    if (isubs < 1 || isubs == 4 || isubs == 8 || isubs > 9)
      in_.fail(print("ISUBS is %d; allowed: 1 to 3, 5 to 7, 9", isubs));
    if (to.size() >= 10) in_.fail("there are more than 10 blocks");
    SubsurfaceBlock block;
    BlockInput& b = block.input;
    b.isubs = isubs;
    const int kind = isubs == 9 ? 9 : (isubs - 1) % 4 + 1;
    const auto count = [&](double n) {
      if (!(n >= 1 && n <= 9999)) in_.fail("lists have 1 to 9999 numbers");
      return int(n);
    };
    int nz = 0;
    if (kind == 2) {
      b.x = in_.reals(3, "IXL, IXINC, IXH");
      b.y = in_.reals(3, "IYL, IYINC, IYH");
    } else if (kind != 1) {
      const auto n = in_.reals(kind == 9 ? 3 : 2, "NX, NY");
      b.x = in_.reals(count(n[0]), "the list of x");
      b.y = in_.reals(count(n[1]), "the list of y");
      if (kind == 9) nz = count(n[2]);
    }
    if (isubs <= 3) {
      b.z = in_.reals(3, "NZ, ZL, DZ");
      count(b.z[0]);
    } else {
      if (!nz) nz = count(in_.integer("NZ"));
      b.z = in_.reals(nz, "the list of z");
    }
    to.push_back(std::move(block));
  }
}

}  // namespace cntc
