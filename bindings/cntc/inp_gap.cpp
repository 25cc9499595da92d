// Reads cases of module 3.
#include <algorithm>

#include "checks.hpp"
#include "inp_case.hpp"
#include "log.hpp"

namespace cntc {

void InpCase::read_gap() {
  Digits& d = v_.digits;
  const auto c =
      in_.control({{"P", "0123"}, {"B", "0123456"}, {"T", "0123"}, {"N", "01"}, {"F", "012"}, {"S", "0123"}});
  d.pvtime = first_ ? 2 : c[0];
  d.bound = c[1];
  d.tang = c[2];
  d.norm = c[3];
  d.force = c[4];
  const auto l = read_second_control({"03", "012", "012349", "012", "01239"});
  if (l[0] == 3) in_.fail("friction by rows of elements (V = 3) is not available in module 3");
  read_last_control();
  check_case(l[1], l[2]);
  const auto q = in_.reals(4, 2, "PEN or FN, CKSI or FX, CETA or FY, CPHI");
  set(d.norm == 1 ? set_normal_force : set_penetration, q[0]);
  if (d.force >= 1) set(set_tangential_forces, q[1], d.force == 2 ? q[2] : 0.);
  set(set_creepages, d.force >= 1 ? v_.cksi : q[1], d.force == 2 ? v_.ceta : q[2], q[3]);
  v_.spinxo = q.size() > 4 ? q[4] : 0;
  v_.spinyo = q.size() > 5 ? q[5] : 0;
  if (l[1] != 1) read_friction(0, l[1]);
  if (l[3] >= 2 && d.tang >= 2) {
    const auto s = in_.reals(3, 1, "CHI, DQ, VELOC");
    set(set_rolling_step, s[0], s[1]);
    set(set_reference_velocity, s[2]);
  } else if (l[3] >= 2 && d.mater == 5) {
    set(set_time_step, in_.reals(1, "DT")[0]);
  }
  read_material(l[3]);
  if (l[2] == 2) {
    const int bound = d.bound;
    read_potential();
    d.bound = bound;
    if (l[5] < 1) in_.fail("a new grid (D = 2) needs Z > 0");
  }
  if ((d.bound == 2 || d.bound == 3) && !v_.hertz.ipotcn) in_.fail("B = 2, 3 need a grid of Hertz (IPOTCN < 0)");
  if (l[5] == 2 && !v_.hertz.ipotcn) read_gap_shape();
  if (l[6] != 1) d.exrhs = l[6] == 9 ? 1 : l[6];
  if (l[6] == 9) read_extra_slip();
  read_subsurface(c[5]);
}

void InpCase::read_potential() {
  const int ipotcn = in_.integer("IPOTCN");
  if (ipotcn == 0 || ipotcn < -6 || ipotcn > 4) in_.fail(print("IPOTCN is %d; allowed: -6 to -1, 1 to 4", ipotcn));
  const auto q = in_.reals(ipotcn > 0 || ipotcn == -6 ? 6 : 5, "the potential contact");
  give(ipotcn < 0 ? set_hertz_contact : set_potential_contact, ipotcn, q);
}

void InpCase::read_gap_shape() {
  const auto head = in_.reals(2, "IBASE, IPLAN");
  const int ibase = whole(head[0]), iplan = whole(head[1]);
  if (ibase != 1 && ibase != 2 && ibase != 3 && ibase != 9) in_.fail(print("IBASE is %d; allowed: 1, 2, 3, 9", ibase));
  if (iplan < 1 || iplan > 3) in_.fail(print("IPLAN is %d; allowed: 1, 2, 3", iplan));
  const int counts[] = {0, 6, 5, 8};
  auto q = in_.reals(ibase == 9 ? int(v_.grid.size()) : counts[ibase], "the undeformed distance");
  if (ibase == 2) {
    const int n = whole(q[0]);
    if (n < 2 || n > 1000000) in_.fail("NN is 2 to 1000000");
    const auto heights = in_.reals(n, "heights of the profile");
    q.insert(q.end(), heights.begin(), heights.end());
  }
  give(set_undeformed_distance, ibase, q);
  v_.iplan = iplan;
  const auto plan = iplan == 1 ? std::vector<double>() : in_.reals(iplan == 2 ? 6 : 8, "the planform");
  std::copy(plan.begin(), plan.end(), v_.plan.begin());
}

void InpCase::read_extra_slip() {
  const long n = v_.hertz.ipotcn ? long(v_.hertz.mx) * v_.hertz.my : v_.grid.size();
  const auto q = in_.reals(int(2 * n), "extra slip");
  std::vector<double> w[2];
  for (size_t k = 0; k < q.size(); ++k) w[k % 2].push_back(q[k]);
  set(set_extra_slip, int(n), w[0].data(), w[1].data());
}

}  // namespace cntc
