// Writes what was set as a case of an input file (flag wrtinp).
#include <cstdio>

#include "files.hpp"
#include "log.hpp"
#include "registry.hpp"
#include "text.hpp"

namespace cntc {
namespace {

std::string line(std::initializer_list<double> values, const char* names) {
  std::string text;
  for (const double v : values) text += print(" %.15g", v);
  return text + "   % " + names + "\n";
}

std::string tail(const Digits& d) {
  return print("  0%d%d%d%d%d%d%d   X-H-G-I-A-O-W-R\n", d.heat, d.gausei, d.iestim, d.matfil, d.output, d.flow, d.ret);
}

std::string solver_text(const Inputs& in) {
  const SolverSettings& s = in.solver;
  const int g = in.digits.gausei;
  if (g == 1) return {};
  std::string text = line({double(s.maxgs), double(s.maxin), double(s.maxnr), double(s.maxout), s.reals[0]},
                          "MAXGS MAXIN MAXNR MAXOUT EPS");
  const SolverLine& own = solver_lines[g];
  for (int k = 0, real = 1; k < own.numbers; ++k)
    text += k == own.whole ? print(" %d", s.extra) : print(" %.15g", s.reals[size_t(real++)]);
  return own.numbers > 0 ? text + "   % solver\n" : text;
}

std::string friction_text(const Inputs& in) {
  const Friction& f = in.friction;
  std::string text;
  if (f.variation) text += print(" %zu   %% NVF\n", f.rows.size());
  for (const FrictionRow& row : f.rows) {
    if (f.variation) text += print(" %.15g", row.place);
    for (int k = 0; k < friction_parameters[f.law]; ++k) text += print(" %.15g", row.p[size_t(k)]);
    text += "   % friction\n";
  }
  if (f.law >= 2) text += line({f.memdst, f.mem_s0}, "MEMDST MEM_S0");
  return text;
}

std::string material_text(const Inputs& in) {
  const Material& m = in.material;
  std::string text = line({m.nu[0], m.nu[1], m.g[0], m.g[1]}, "POISS GG");
  if (in.digits.bound == 1) text += line({0}, "FLXZ");
  for (int k = 4; k < material_parameters[in.digits.mater]; ++k) text += print(" %.15g", m.more[size_t(k - 4)]);
  if (material_parameters[in.digits.mater] > 4) text += "   % material\n";
  if (in.digits.damping == 2) text += line({m.cdampn, m.cdampt, m.dfnmax, m.dftmax}, "damping");
  if (in.digits.heat == 3) {
    for (const Heat& h : in.heat) text += line({h.background, h.capacity, h.conductivity, h.density}, "heat");
    if (in.digits.mater == 4) text += line({in.betapl}, "BETAPL");
  }
  return text;
}

std::string profile_text(const ProfileInput& p) {
  const auto& i = p.options.ints;
  const auto& r = p.options.reals;
  return print(" '%s' %d %.15g %.15g %d 2\n", p.path.c_str(), i[2], r[0], r[1], i[3]) +
         line({double(i[5]), r[3], r[4], r[5], r[6]}, "ISMOOTH ZIGTHRS KINKHIGH KINKLOW KINKWID") +
         line({double(i[4]), r[2]}, "ERRHND MAXOMIT");
}

std::string wheel_case(const Problem& p) {
  const Inputs& in = p.in;
  const Digits& d = in.digits;
  const Track& t = in.track;
  const Wheelset& w = in.wheelset;
  std::string text = print(" 1 %d   MODULE, RESULT ELEMENT\n", p.ire);
  text += print("  %d%d%d%d%d%d0   C-P-B-T-N-F-S\n", d.config, d.pvtime, d.bound, d.tang, d.norm, d.force);
  text += print("  %d%d%d2%d35 %d   V-L-D-C-M-Z-E, M2\n", in.friction.variation, in.friction.law, d.discns, d.mater,
                d.damping ? 2 : 0);
  text += tail(d) + solver_text(in) + friction_text(in) + material_text(in);
  const PlaneGrid& g = in.plane;
  text += line({g.dx, g.ds, in.dq, g.a_sep, g.d_sep, g.d_comb, g.d_turn, g.g_miss}, "grid");
  text += line({t.gaught, t.gaught > 0 ? t.gaugsq : t.raily0, t.gaught > 0 ? t.gaugwd : t.railz0,
                d.roller() ? t.nomrad : t.cant, t.curv},
               "track");
  text += profile_text(in.rail);
  text += line({t.deviation[0], t.deviation[1], t.deviation[2], t.rate[0], t.rate[1], t.rate[2]}, "rail's deviation");
  if (d.force == 3) text += line({t.ky, t.fy, t.kz, t.fz, t.dystep}, "rail's springs");
  text += line({w.fbdist, w.fbpos, w.nomrad, w.ytape}, "wheelset") + profile_text(in.wheel);
  const auto &q = w.position, &v = w.velocity;
  const auto& f = w.flexibility;
  text += line({q[0], q[1], d.norm ? in.fz : q[2], q[3], q[4], q[5]}, "position");
  text += line({v[0], v[1], v[2], v[3], v[4], d.force == 1 ? in.fx : v[5]}, "velocity");
  text += line({f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10], f[11]}, "flexibility");
  return text;
}

std::string gap_case(const Problem& p) {
  const Inputs& in = p.in;
  const Digits& d = in.digits;
  std::string text = print(" 3 %d %d   MODULE, RESULT ELEMENT, CONTACT PROBLEM\n", p.ire, p.icp);
  text += print("  %d%d%d%d%d0   P-B-T-N-F-S\n", d.pvtime, d.bound, d.tang, d.norm, d.force);
  text +=
      print("  %d22%d2%d %d   L-D-C-M-Z-E, M2\n", in.friction.law, d.mater, d.exrhs == 1 ? 9 : 0, d.damping ? 2 : 0);
  text += tail(d) + solver_text(in);
  text += line({d.norm ? in.fn : in.pen, d.force >= 1 ? in.fx : in.cksi, d.force == 2 ? in.fy : in.ceta, in.cphi,
                in.spinxo, in.spinyo},
               "PEN or FN, CKSI or FX, CETA or FY, CPHI, SPINXO, SPINYO");
  text += friction_text(in);
  if (d.tang >= 2) {
    text += line({in.chi, in.dq, in.veloc}, "CHI DQ VELOC");
  } else if (d.mater == 5) {
    text += line({in.dt}, "DT");
  }
  text += material_text(in);
  const HertzInput& h = in.hertz;
  const Grid& g = in.grid;
  text += print(" %d   %% IPOTCN\n", h.ipotcn ? h.ipotcn : 3);
  if (h.ipotcn == -6) {
    text += line({double(h.mx), double(h.my), h.first, h.second, h.third, h.scale}, "grid of Hertz");
  } else if (h.ipotcn) {
    text += line({double(h.mx), double(h.my), h.first, h.second, h.scale}, "grid of Hertz");
  } else {
    text += line({double(g.mx), double(g.my), g.xc, g.yc, g.dx, g.dy}, "grid");
    text += print(" %d %d   %% IBASE, IPLAN\n", in.ibase, in.iplan);
    for (const double b : in.gap) text += print(" %.15g\n", b);
    const auto& q = in.plan;
    if (in.iplan == 2) text += line({q[0], q[1], q[2], q[3], q[4], q[5]}, "planform");
    if (in.iplan == 3) text += line({q[0], q[1], q[2], q[3], q[4], q[5], q[6], q[7]}, "planform");
  }
  if (d.exrhs == 1)
    for (size_t k = 0; k < size_t(h.ipotcn ? long(h.mx) * h.my : g.size()); ++k)
      text += print(" %.15g %.15g\n", k < in.wx.size() ? in.wx[k] : 0, k < in.wy.size() ? in.wy[k] : 0);
  return text;
}

}  // namespace

void write_inp(Problem& p) {
  const Session s = session();
  const std::string path = in_folder(s.outdir.empty() ? s.wrkdir : s.outdir, s.expnam + ".inp");
  std::FILE* file = std::fopen(path.c_str(), p.in.digits.ncase > 1 ? "a" : "w");
  if (!file) return log_line("inp-file", p.ire, p.icp, "%s cannot be written", path.c_str());
  std::fputs((p.module == 1 ? wheel_case(p) : gap_case(p)).c_str(), file);
  std::fclose(file);
}

}  // namespace cntc
