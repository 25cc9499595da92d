// Writes what the out-file says of a case, with the headings that CONTACT's parse_out1 and parse_out3 look for.
#include <algorithm>
#include <cmath>

#include "files.hpp"
#include "log.hpp"
#include "registry.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

using Names = std::initializer_list<const char*>;

/// A line of names over a line of numbers, in columns of 12.
std::string table(Names names, std::initializer_list<double> values) {
  std::string text = "    ";
  for (const char* name : names) text += print(" %-11s", name);
  text += "\n ";
  for (const double v : values) text += print("%12.4e", v);
  return text + "\n";
}

/// The highest temperature of both surfaces where they touch.
double hottest(const ContactResult& r) {
  double most = 0;
  for (size_t k = 0; k < r.temp1.size(); ++k)
    if (r.division[k] > 0) most = std::max({most, r.temp1[k], r.temp2[k]});
  return most;
}

std::string contact_text(const Problem& p, const ContactResult& r) {
  const Inputs& in = p.in;
  const bool wheel = p.module == 1, shift = in.digits.tang <= 1;
  const double g = 2 / (1 / in.material.g[0] + 1 / in.material.g[1]);
  const double limit = r.fstat * r.fn > 0 ? r.fstat * r.fn : 1, fx = r.tx / limit, fy = r.ty / limit;
  // What was given stands among the constants, what was found among the results.
  const bool x = !wheel && in.digits.force >= 1, y = !wheel && in.digits.force == 2;
  const char *relative[] = {"FX/FSTAT/FN", wheel ? "FS/FSTAT/FN" : "FY/FSTAT/FN"},
             *found[] = {shift ? "SHIFT X" : "CREEP X", shift ? "SHIFT Y" : "CREEP Y"};
  const char* given[] = {x ? relative[0] : "CKSI", y ? relative[1] : "CETA"};
  const double motion[] = {x ? fx : r.cksi, y ? fy : r.ceta};
  std::string text = "\n KINEMATIC CONSTANTS\n";
  text += shift && !wheel
              ? table({"DT", "VELOC", given[0], given[1], "CPHI"}, {in.dt, r.veloc, motion[0], motion[1], r.cphi})
              : table({"CHI", "DQ", "VELOC", given[0], given[1], "CPHI"},
                      {r.chi, r.dq, r.veloc, motion[0], motion[1], r.cphi});
  double energy = 0;
  for (size_t k = 0; k < r.pn.size(); ++k)
    energy += .5e-3 * r.grid.dx * r.grid.dy * (r.pn[k] * r.un[k] + r.px[k] * r.ux[k] + r.py[k] * r.uy[k]);
  text += "\n TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER\n";
  text += table({"FN", "FX", wheel ? "FS" : "FY", wheel ? "MN" : "MZ", "ELAST.EN.", shift ? "FRIC.WORK" : "FRIC.POWER"},
                {r.fn, r.tx, r.ty, r.mz, energy, -r.power / 1000});
  text += table({"FN/G", x ? found[0] : relative[0], y ? found[1] : relative[1], "APPROACH", "PMAX",
                 r.temp1.empty() ? "" : "MAX(T1,T2)"},
                {r.fn / g, x ? r.cksi : fx, y ? r.ceta : fy, r.pen, r.pmax, hottest(r)});
  text +=
      "\n CONTACT STATISTICS\n N: NUMBER OF ELEMENTS IN REGION,  I: NUMBER OF ITERATIONS,\n"
      " POT: POTENTIAL CONTACT AREA,  CON: CONTACT,  ADH: ADHESION\n";
  text += print("    NPOT   NCON   NADH  NSLIP  INORM  ITANG\n %6ld %6ld %6ld %6ld %6d %6d\n", r.grid.size(),
                r.count(1) + r.count(2) + r.count(3), r.count(1), r.count(2), r.iterations, r.iterations);
  if (in.digits.output < 5) return text;
  text += "\n      X           Y           H           PN          PX          PY          SX          SY\n";
  for (size_t k = 0; k < r.pn.size(); ++k) {
    if (r.division[k] == 0) continue;
    text += " ";
    for (const double v : {r.grid.x(int(k % size_t(r.grid.mx))), r.grid.y(int(k / size_t(r.grid.mx))), r.h[k], r.pn[k],
                           r.px[k], r.py[k], r.sx[k], r.sy[k]})
      text += print("%12.4e", v);
    text += "\n";
  }
  return text;
}

std::string wheel_text(Problem& p) {
  const Inputs& in = p.in;
  const Digits& d = in.digits;
  const auto f = global_forces(p, -1, Units{});
  const WheelSolver& w = *p.wheel;
  const auto &q = in.wheelset.position, &v = in.wheelset.velocity;
  const size_t n = p.patches.size();
  std::string text = print("\n WHEEL-%s CONTACT, %s WHEEL, %2zu CONTACT PATCH%s\n", d.roller() ? "ROLLER" : "RAIL",
                           d.left() ? "LEFT" : "RIGHT", n, n == 1 ? "" : "ES");
  text += "\n WHEEL-SET POSITION AND VELOCITY\n";
  text += table({d.roller() ? "X_WS" : "S_WS", "Y_WS", "Z_WS", "ROLL_WS", "YAW_WS", "PITCH_WS"},
                {q[0], q[1], w.z, q[3], q[4], q[5]}) +
          "\n";
  text += table({d.roller() ? "RPITCH" : "VX_WS", "VY_WS", "VZ_WS", "VROLL_WS", "VYAW_WS", "VPITCH_WS"},
                {v[0], v[1], v[2], v[3], v[4], d.force == 1 ? w.pitch_rate : v[5]});
  const auto& b = in.wheelset.flexibility;
  const Track& t = in.track;
  if (b != decltype(in.wheelset.flexibility){})
    text += "\n FLEXIBLE WHEEL-SET DEVIATIONS\n" +
            table({"DXWHL", "DYWHL", "DZWHL", "DROLLW", "DYAWW", "DPITCHW"}, {b[0], b[1], b[2], b[3], b[4], b[5]}) +
            table({"VXWHL", "VYWHL", "VZWHL", "VROLLW", "VYAWW", "VPITCHW"}, {b[6], b[7], b[8], b[9], b[10], b[11]});
  if (t.deviation != Vec3{} || t.rate != Vec3{})
    text += "\n RAIL IRREGULARITY\n" +
            table({"DYRAIL", "DZRAIL", "DROLLR", "VYRAIL", "VZRAIL", "VROLLR"},
                  {t.deviation[0], t.deviation[1], t.deviation[2], t.rate[0], t.rate[1], t.rate[2]});
  if (d.force == 3)
    text +=
        "\n MASSLESS RAIL DEFLECTION\n" + table({"KY_RAIL", "DY_DEFL", "FY_RAIL", "KZ_RAIL", "DZ_DEFL", "FZ_RAIL"},
                                                {t.ky, w.sign * w.deflection[0], t.fy, t.kz, w.deflection[1], t.fz});
  text += print("\n TOTAL FORCES AND MOMENTS ON %s\n", d.roller() ? "ROLLER" : "RAIL");
  text += table({"FX(TR)", "FY(TR)", "FZ(TR)", "FX(WS)", "FY(WS)", "FZ(WS)"}, {f[0], f[1], f[2], f[6], f[7], f[8]});
  text += "\n" +
          table({"MX(TR)", "MY(TR)", "MZ(TR)", "MX(WS)", "MY(WS)", "MZ(WS)"}, {f[3], f[4], f[5], f[9], f[10], f[11]});
  for (size_t k = 0; k < n; ++k) {
    const auto l = location(p, int(k + 1), 1);
    text += print("\n ----- DATA FOR CONTACT PATCH %2zu (NEW PATCH) -----\n\n CONTACT REFERENCE LOCATION\n", k + 1);
    text += table({"XCP(TR)", "YCP(TR)", "ZCP(TR)", "DELTCP(TR)", "YCP(R)", "ZCP(R)"},
                  {l[0], l[1], l[2], l[3], l[5], l[6]});
    text += "\n" + table({"XCP(W)", "YCP(W)", "ZCP(W)", "DELTCP(W)"}, {l[9], l[10], l[11], l[13]});
    text += contact_text(p, p.patches[k]);
  }
  return text;
}

}  // namespace

std::string out_text(Problem& p) {
  std::string text = print("\n Case %5d", p.in.digits.ncase);
  if (p.module == 1 && !session().program) text += print(" for w/r contact on result element %2d", p.ire);
  text += "\n";
  if (p.module == 1) return p.wheel ? text + wheel_text(p) : text;
  return p.patches[0].solved ? text + contact_text(p, p.patches[0]) : text;
}

std::string subsurface_text(const std::vector<SubsurfaceBlock>& blocks) {
  struct Row {
    const char *kind, *name;
    size_t column;
    double (*size)(double);
  };
  static const auto absolute = [](double v) { return std::abs(v); };
  static const auto plain = [](double v) { return v; };
  static const auto least = [](double v) { return -v; };
  static const Row rows[] = {{"ABSMAX", "SIGHYD", 6, absolute}, {"MAX", "SIGVM", 7, plain},
                             {"MAX", "SIGTR", 8, plain},        {"MAX", "SIGMA1", 9, plain},
                             {"MIN", "SIGMA3", 11, least},      {"ABSMAX", "SIGXX", 12, absolute},
                             {"ABSMAX", "SIGYY", 16, absolute}, {"ABSMAX", "SIGZZ", 20, absolute}};
  std::string text;
  for (size_t k = 0; k < blocks.size(); ++k) {
    const std::vector<double>& all = blocks[k].columns;
    if (all.empty()) continue;
    text += print("\n SUBSURFACE STRESSES BLOCK %2zu:\n \n", k + 1);
    for (const Row& row : rows) {
      size_t best = 0;
      for (size_t at = 0; at < all.size(); at += 21)
        if (row.size(all[at + row.column]) > row.size(all[best + row.column])) best = at;
      text += print(" %-6s %6s =%10.3f AT (X,Y,Z) = (%8.3f,%8.3f,%8.3f)\n", row.kind, row.name, all[best + row.column],
                    all[best], all[best + 1], all[best + 2]);
    }
  }
  return text;
}

}  // namespace cntc
