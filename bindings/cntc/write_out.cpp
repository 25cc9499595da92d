// Writes what the out-file says of a case.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "files.hpp"
#include "log.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

std::string numbers(std::initializer_list<double> values) {
  std::string text = " ";
  for (const double v : values) text += print(" %12.4e", v);
  return text + "\n";
}

std::string contact_text(const Problem& p, const ContactResult& r) {
  const Inputs& in = p.in;
  double pmax = 0;
  for (const double v : r.pn) pmax = std::max(pmax, v);
  const double g = 2 / (1 / in.material.g[0] + 1 / in.material.g[1]);
  const double limit = r.fstat * r.fn > 0 ? r.fstat * r.fn : 1;
  std::string text = "\n KINEMATIC CONSTANTS\n";
  text += "      CHI          DQ           VELOC        CKSI         CETA         CPHI\n";
  text += numbers({r.chi, r.dq, r.veloc, r.cksi, r.ceta, r.cphi});
  text += "\n TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER\n";
  text += "      FN           FX           FY           MZ           ELAST.EN.    FRIC.POWER\n";
  double energy = 0;
  for (size_t k = 0; k < r.pn.size(); ++k)
    energy += .5 * r.grid.dx * r.grid.dy * (r.pn[k] * r.un[k] + r.px[k] * r.ux[k] + r.py[k] * r.uy[k]);
  text += numbers({r.fn, r.tx, r.ty, r.mz, energy, -r.power / 1000});
  text += "\n      FN/G         FX/FSTAT/FN  FY/FSTAT/FN  APPROACH     PMAX\n";
  text += numbers({r.fn / g, r.tx / limit, r.ty / limit, r.pen, pmax});
  if (!r.temp1.empty())
    text += "\n      TEMP1        TEMP2\n" + numbers({*std::max_element(r.temp1.begin(), r.temp1.end()),
                                                      *std::max_element(r.temp2.begin(), r.temp2.end())});
  text += "\n CONTACT STATISTICS\n";
  text += print("   ELEMENTS %ld, CONTACT %ld, STICK %ld, SLIP %ld, GRID %d x %d\n", r.grid.size(),
                r.count(1) + r.count(2) + r.count(3), r.count(1), r.count(2), r.grid.mx, r.grid.my);
  if (in.digits.output < 5) return text;
  text += "\n      X            Y            H            PN           PX           PY           SX           SY\n";
  for (size_t k = 0; k < r.pn.size(); ++k) {
    if (r.division[k] == 0) continue;
    const int i = int(k % size_t(r.grid.mx)), j = int(k / size_t(r.grid.mx));
    text += numbers({r.grid.x(i), r.grid.y(j), r.h[k], r.pn[k], r.px[k], r.py[k], r.sx[k], r.sy[k]});
  }
  return text;
}

std::string wheel_text(const Problem& p) {
  // Getters look results up by a call; they read alone.
  Problem& problem = const_cast<Problem&>(p);
  Call all{"out-file", problem, -1};
  const Units kept = problem.in.units;
  problem.in.units = units_of(CNTC_un_cntc);
  double f[24], ws[6];
  get_global_forces(all, 24, f);
  get_wheelset_position(all, 6, ws);
  std::string text = "\n WHEEL-RAIL CONTACT, LEFT OR RIGHT (C1 = " + std::to_string(p.in.digits.config) + ")\n";
  text +=
      print("\n WHEEL-SET POSITION\n      %s            Y            Z            ROLL         YAW          PITCH\n",
            p.in.digits.roller() ? "X" : "S");
  text += numbers({ws[0], ws[1], ws[2], ws[3], ws[4], ws[5]});
  text += "\n TOTAL FORCES AND MOMENTS ON RAIL, TRACK AND WHEEL-SET AXES\n";
  text += "      FX(TR)       FY(TR)       FZ(TR)       MX@R(TR)     MY@R(TR)     MZ@R(TR)\n";
  text += numbers({f[0], f[1], f[2], f[3], f[4], f[5]});
  text += "      FX(WS)       FY(WS)       FZ(WS)       MX@W(WS)     MY@W(WS)     MZ@W(WS)\n";
  text += numbers({f[6], f[7], f[8], f[9], f[10], f[11]});
  for (size_t k = 0; k < p.patches.size(); ++k) {
    Call one{"out-file", problem, int(k + 1)};
    double l[38];
    get_location(one, 38, l);
    text += print("\n DATA FOR CONTACT PATCH %zu\n", k + 1);
    text += "\n CONTACT REFERENCE LOCATION\n";
    text += "      XCP(TR)      YCP(TR)      ZCP(TR)      DELTCP(TR)   YCP(R)       ZCP(R)\n";
    text += numbers({l[0], l[1], l[2], l[3], l[5], l[6]});
    text += "      XCP(W)       YCP(W)       ZCP(W)       DELTCP(W)\n" + numbers({l[9], l[10], l[11], l[13]});
    text += contact_text(p, p.patches[k]);
  }
  problem.in.units = kept;
  return text;
}

}  // namespace

std::string out_text(const Problem& p) {
  std::string text = print("\n Case %5d\n ----------\n", p.in.digits.ncase);
  if (p.module == 1) return text + wheel_text(p);
  return p.patches[0].solved ? text + contact_text(p, p.patches[0]) : text;
}

}  // namespace cntc
