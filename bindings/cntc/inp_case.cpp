// Reads what cases of both modules have in common.
#include "inp_case.hpp"

#include <algorithm>

#include "log.hpp"
#include "text.hpp"

namespace cntc {

std::vector<int> InpCase::read_second_control(std::array<const char*, 5> allowed) {
  int m2 = 1;
  const auto l = in_.control({{"V", allowed[0]},
                              {"L", "012346"},
                              {"D", allowed[1]},
                              {"C3", allowed[2]},
                              {"M", "01234567"},
                              {"Z", allowed[3]},
                              {"E", allowed[4]}},
                             &m2);
  v_.digits.mater = l[4];
  if (m2 != 1) v_.digits.damping = m2;
  return l;
}

void InpCase::read_last_control() {
  const auto d = in_.control({{"X", "01"},
                              {"H", "013"},
                              {"G", "0123456"},
                              {"I", "0123"},
                              {"A", "012"},
                              {"O", "0123456"},
                              {"W", "0123456789"},
                              {"R", "0123"}});
  Digits& q = v_.digits;
  q.xflow = d[0];
  heat_ = d[1];
  if (heat_ != 1) q.heat = heat_;
  q.gausei = d[2];
  q.iestim = first_ ? 0 : d[3];
  q.matfil = d[4];
  q.output = d[5];
  q.flow = d[6];
  q.ret = d[7];
  if (q.mater == 1 && q.tang != 3) in_.fail("M = 1 needs T = 3");
  if (d[0] == 1) in_.reals(1, "P-S-F-L-C-I-N");
  if (q.gausei != 1) read_solver();
}

void InpCase::check_case(int law, int grid) const {
  if (v_.digits.heat && v_.digits.tang != 3) in_.fail("H >= 1 needs T = 3");
  if (first_ && law == 1) in_.fail("L is 1 in the first case: there is no friction to keep");
  if (first_ && grid == 0) in_.fail("D is 0 in the first case: there is no grid to keep");
}

void InpCase::read_solver() {
  const int g = v_.digits.gausei;
  const auto head = in_.reals(5, 1, "MAXGS, MAXIN, MAXNR, MAXOUT, EPS");
  const auto count = [](double x) { return int(std::clamp(x, -1e9, 1e9)); };
  std::vector<int> ints;
  for (size_t k = 0; k < 4; ++k) ints.push_back(count(head[k]));
  std::vector<double> reals{head[4]};
  if (head.size() > 5 && p_.module == 1) v_.digits.npomax = std::clamp(count(head[5]), 100, 1000000);
  const SolverLine& line = solver_lines[g];
  if (line.numbers > 0) {
    const auto more = in_.reals(line.numbers, "settings of the solver");
    for (int k = 0; k < line.numbers; ++k)
      k == line.whole ? ints.push_back(count(more[size_t(k)])) : reals.push_back(more[size_t(k)]);
  }
  set(set_solver_flags, g == 1 || g == 6 ? 0 : g, int(ints.size()), ints.data(), int(reals.size()), reals.data());
  v_.digits.gausei = g;
}

void InpCase::read_friction(int variation, int law) {
  const int rows = variation ? in_.integer("NVF") : 1;
  if (rows < 1 || rows > 10000) in_.fail(print("NVF is %d; allowed: 1 to 10000", rows));
  std::vector<std::vector<double>> row;
  for (int k = 0; k < rows; ++k)
    row.push_back(in_.reals(friction_parameters[law] + (variation > 0), "parameters of friction"));
  const auto memory = law >= 2 ? in_.reals(2, "MEMDST, MEM_S0") : std::vector<double>();
  std::vector<double> q;
  if (variation) q.push_back(rows);
  for (const auto& r : row) {
    q.insert(q.end(), r.begin(), r.end());
    q.insert(q.end(), memory.begin(), memory.end());
  }
  give(set_friction, 10 * variation + law, q);
}

/// Reads lines of material, damping and heat.
void InpCase::read_material(int coefficients) {
  Digits& d = v_.digits;
  if (coefficients >= 2) {
    d.inflcf = coefficients;
    if (coefficients == 4) {
      const bool wheel = p_.module == 1;
      const auto q = in_.reals(wheel ? 2 : 3, "IF_METH, VARIANT");
      d.ifmeth = int(std::clamp(q[0], 0., 1.));
      d.ifvari = int(std::clamp(q[1], 1., 4.));
      const int n = wheel ? 0 : int(std::clamp(q[2], 0., 1e5));
      if (n > 0) in_.reals(2 * n, "Y, ALPHA");
    }
    if (coefficients == 9) in_.fail("influence coefficients from a file (C3 = 9) are not available");
    auto q = in_.reals(4, "POISS, GG");
    if (d.bound == 1) in_.reals(1, "FLXZ");
    if (const int more = material_parameters[d.mater] - 4) {
      const auto values = in_.reals(more, "parameters of the material");
      q.insert(q.end(), values.begin(), values.end());
    }
    const int outer = v_.solver.maxout;
    give(set_material, d.mater, q);
    v_.solver.maxout = outer;
  }
  if (d.damping == 2) give(set_material, 12, in_.reals(4, "CDAMPN, CDAMPT, DFNMAX, DFTMAX"));
  if (heat_ != 3) return;
  std::vector<double> q;
  for (int n : {4, 4, d.mater == 4 ? 1 : 0}) {
    const auto values = in_.reals(n, n == 1 ? "BETAPL" : "BKTEMP, HEATCP, LAMBDA, DENS");
    q.insert(q.end(), values.begin(), values.end());
  }
  give(set_temperature_data, 3, q);
}

void InpCase::read_profile(bool wheel) {
  std::vector<double> q;
  const std::string name = in_.text(q, wheel ? "the wheel's profile" : "the rail's profile");
  const double standard[] = {0, 1, 0, 0, 0};  // MIRRORY, SCALE, SMOOTH, MIRRORZ, PRFOPT
  while (q.size() < 5) q.push_back(standard[q.size()]);
  ProfileOptions o;
  const auto whole_of = [](double x) { return int(std::clamp(x, -9., 9.)); };
  o.ints = {wheel, 0, whole_of(q[0]), whole_of(q[3]), 1, 0};
  o.reals[0] = q[1];
  o.reals[1] = q[2];
  if (q[4] >= 1) {
    const auto r = in_.reals(5, "ISMOOTH, ZIGTHRS, KINKHIGH, KINKLOW, KINKWID");
    o.ints[5] = whole_of(r[0]);
    std::copy(r.begin() + 1, r.end(), o.reals.begin() + 3);
  }
  if (q[4] >= 2) {
    const auto r = in_.reals(2, "ERRHND, MAXOMIT");
    o.ints[4] = whole_of(r[0]);
    o.reals[2] = r[1];
  }
  set(keep_profile_file, in_folder(folder_, name), wheel, o);
}

/// Reads blocks of points inside the bodies; S = 2 keeps those of the case before.
void InpCase::read_subsurface(int stresses) {
  if (first_ && (stresses == 1 || stresses == 2))
    in_.fail("S is 1 or 2 in the first case: there are no blocks to keep");
  if (stresses < 2) return;
  const auto head = in_.reals(2, "MATFIL, OUTPUT");
  v_.digits.sbsfil = int(std::clamp(head[0], 0., 2.));
  v_.digits.sbsout = int(std::clamp(head[1], 0., 4.));
  if (stresses != 3) return;
  p_.blocks.clear();
  for (int block = 1;; ++block) {
    const int isubs = in_.integer("ISUBS");
    if (isubs == 0) return;
    if (isubs < 1 || isubs == 4 || isubs == 8 || isubs > 9)
      in_.fail(print("ISUBS is %d; allowed: 1 to 3, 5 to 7, 9", isubs));
    const int kind = BlockInput{isubs, {}}.kind();
    const auto count = [&](double n) {
      if (!(n >= 1 && n <= 9999)) in_.fail("lists have 1 to 9999 numbers");
      return int(n);
    };
    int nz = 0;
    std::vector<double> x, y;
    if (kind == 2) {
      x = in_.reals(3, "IXL, IXINC, IXH");
      y = in_.reals(3, "IYL, IYINC, IYH");
    } else if (kind != 1) {
      const auto n = in_.reals(kind == 9 ? 3 : 2, "NX, NY");
      x = in_.reals(count(n[0]), "the list of x");
      y = in_.reals(count(n[1]), "the list of y");
      if (kind == 9) nz = count(n[2]);
    }
    if (isubs > 3 && !nz) nz = count(in_.integer("NZ"));
    const auto z = isubs <= 3 ? in_.reals(3, "NZ, ZL, DZ") : in_.reals(nz, "the list of z");
    set(add_block, block, isubs, int(x.size()), int(y.size()), int(z.size()), x.data(), y.data(), z.data());
  }
}

}  // namespace cntc
