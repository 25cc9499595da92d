// Reads cases of module 3.
#include <algorithm>
#include <cmath>

#include "calculate.hpp"
#include "checks.hpp"
#include "handles.hpp"
#include "inp_case.hpp"
#include "log.hpp"

namespace cntc {

void InpCase::read_gap() {
  Digits& d = v_.digits;
  const auto c = in_.control(6, "P-B-T-N-F-S");
  in_.in_range(c[1], 0, 6, "B");
  in_.in_range(c[4], 0, 2, "F");
  in_.in_range(c[0], 0, 3, "P");
  d.pvtime = first_ ? 2 : c[0];
  d.bound = c[1];
  d.tang = c[2];
  d.norm = c[3];
  d.force = c[4];
  subs_ = c[5];
  int m2 = 1;
  const auto l = in_.control(7, "L-D-C-M-Z-E", &m2);
  if (l[0] != 0 && l[0] != 3) in_.fail(print("V is %d; allowed: 0, 3", l[0]));
  in_.in_range(l[2], 0, 2, "D");
  if (l[3] > 4 && l[3] != 9) in_.fail(print("C3 is %d; allowed: 0 to 4, 9", l[3]));
  in_.in_range(l[4], 0, 7, "M");
  in_.in_range(l[5], 0, 2, "Z");
  if (l[6] > 3 && l[6] != 9) in_.fail(print("E is %d; allowed: 0 to 3, 9", l[6]));
  if (first_ && l[1] == 1) in_.fail("L is 1 in the first case: there is no friction to keep");
  if (first_ && l[2] == 0) in_.fail("D is 0 in the first case: there is no grid to keep");
  if (l[0] == 3) in_.fail("friction by rows of elements (V = 3) is not available in module 3");
  v_digit_ = 0;
  if (l[1] != 1) d.frclaw = l[1];
  d.mater = l[4];
  if (m2 != 1) d.damping = m2;
  read_last_control();
  check_digits(d.heat);
  const auto q = in_.reals(4, 2, "PEN or FN, CKSI or FX, CETA or FY, CPHI");
  (d.norm == 1 ? v_.fn : v_.pen) = q[0];
  (d.force >= 1 ? v_.fx : v_.cksi) = q[1];
  (d.force == 2 ? v_.fy : v_.ceta) = q[2];
  v_.cphi = q[3];
  const double size = std::hypot(v_.fx, v_.fy);
  if (size > 1) {
    v_.fx /= size;
    v_.fy /= size;
  }
  v_.spinxo = q.size() > 4 ? q[4] : 0;
  v_.spinyo = q.size() > 5 ? q[5] : 0;
  if (l[1] != 1) read_friction();
  if (l[3] >= 2) {
    if (d.tang >= 2) {
      const auto s = in_.reals(3, 1, "CHI, DQ, VELOC");
      if (!(s[1] > 0)) in_.fail("DQ must be above 0");
      v_.chi = s[0];
      v_.dq = s[1];
      v_.veloc = std::abs(s[2]);
    } else if (d.mater == 5) {
      v_.dt = in_.reals(1, "DT")[0];
      if (!(v_.dt > 0)) in_.fail("DT must be above 0");
    }
  }
  const int kept = d.inflcf;
  d.inflcf = l[3];
  read_material(false);
  d.inflcf = l[3] >= 2 ? l[3] : kept;
  if (d.heat == 3) {
    for (Heat& heat : v_.heat) {
      const auto h = in_.reals(4, "BKTEMP, HEATCP, LAMBDA, DENS");
      heat = {h[0], h[1], h[2], h[3]};
    }
    if (d.mater == 4) v_.betapl = in_.reals(1, "BETAPL")[0];
  }
  if (l[2] == 2) {
    read_potential();
    if (l[5] < 1) in_.fail("a new grid (D = 2) needs Z > 0");
  }
  if (d.bound == 2 || d.bound == 3)
    if (!v_.hertz.ipotcn) in_.fail("B = 2, 3 need a grid of Hertz (IPOTCN < 0)");
  if (l[5] == 2 && !v_.hertz.ipotcn) read_gap_shape();
  d.exrhs = l[6] == 9 ? 1 : l[6] == 1 ? d.exrhs : 0;
  if (l[6] == 9) read_extra_slip();
  read_subsurface();
}

void InpCase::read_potential() {
  const int ipotcn = in_.integer("IPOTCN");
  if (ipotcn == 0 || ipotcn < -6 || ipotcn > 4) in_.fail(print("IPOTCN is %d; allowed: -6 to -1, 1 to 4", ipotcn));
  const auto q = in_.reals(ipotcn > 0 || ipotcn == -6 ? 6 : 5, "the potential contact");
  const int mx = whole(q[0]), my = whole(q[1]);
  if (mx < 1 || my < 1 || long(mx) * my > 1000000) in_.fail("MX and MY are at least 1, their product at most 1000000");
  if (ipotcn < 0) {
    HertzInput h;
    h.ipotcn = ipotcn;
    h.mx = mx;
    h.my = my;
    h.first = q[2];
    h.second = q[3];
    h.third = ipotcn == -6 ? q[4] : 0;
    h.scale = q.back();
    if (!(h.first > 0) || !(h.second > 0) || !(h.scale > 0)) in_.fail("curvatures, axes and scale must be above 0");
    v_.hertz = h;
    return;
  }
  Grid g;
  g.mx = mx;
  g.my = my;
  g.dx = ipotcn == 2 ? (q[4] - q[2]) / mx : ipotcn == 4 && mx > 1 ? (q[4] - q[2]) / (mx - 1) : q[4];
  g.dy = ipotcn == 2 ? (q[5] - q[3]) / my : ipotcn == 4 && my > 1 ? (q[5] - q[3]) / (my - 1) : q[5];
  if (ipotcn == 4 && mx == 1) g.dx = g.dy;
  if (ipotcn == 4 && my == 1) g.dy = g.dx;
  if (!(g.dx > 0) || !(g.dy > 0)) in_.fail("elements must be wider than 0");
  g.xc = ipotcn <= 2 ? q[2] + g.dx / 2 : q[2];
  g.yc = ipotcn <= 2 ? q[3] + g.dy / 2 : q[3];
  v_.grid = g;
  v_.hertz.ipotcn = 0;
}

void InpCase::read_gap_shape() {
  const auto head = in_.reals(2, "IBASE, IPLAN");
  const int ibase = whole(head[0]), iplan = whole(head[1]);
  if (ibase != 1 && ibase != 2 && ibase != 3 && ibase != 9) in_.fail(print("IBASE is %d; allowed: 1, 2, 3, 9", ibase));
  if (iplan < 1 || iplan > 3) in_.fail(print("IPLAN is %d; allowed: 1, 2, 3", iplan));
  if (ibase == 1) v_.gap = in_.reals(6, "B1 to B6");
  if (ibase == 2) {
    v_.gap = in_.reals(5, "NN, XM, RM, Y1, DY1");
    const int n = whole(v_.gap[0]);
    if (n < 2 || n > 1000000) in_.fail("NN is 2 to 1000000");
    if (v_.gap[2] == 0 || !(v_.gap[4] > 0)) in_.fail("RM is not 0, DY1 above 0");
    const auto heights = in_.reals(n, "heights of the profile");
    v_.gap.insert(v_.gap.end(), heights.begin(), heights.end());
  }
  if (ibase == 3) v_.gap = in_.reals(8, "B1 to B8");
  if (ibase == 9) v_.gap = in_.reals(int(v_.grid.size()), "undeformed distances");
  v_.ibase = ibase;
  v_.iplan = iplan;
  const auto plan = iplan == 1 ? std::vector<double>() : in_.reals(iplan == 2 ? 6 : 8, "the planform");
  std::copy(plan.begin(), plan.end(), v_.plan.begin());
}

void InpCase::read_extra_slip() {
  const long n = v_.hertz.ipotcn ? long(v_.hertz.mx) * v_.hertz.my : v_.grid.size();
  const auto q = in_.reals(int(2 * n), "extra slip");
  v_.wx.clear();
  v_.wy.clear();
  for (size_t k = 0; k + 1 < q.size(); k += 2) {
    v_.wx.push_back(q[k]);
    v_.wy.push_back(q[k + 1]);
  }
}

}  // namespace cntc
