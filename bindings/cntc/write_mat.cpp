// Writes mat-files and subs-files, tables in columns of 14 places.
#include <cmath>
#include <cstdio>

#include "files.hpp"
#include "log.hpp"
#include "registry.hpp"
#include "text.hpp"
#include "vectors.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

void cells(std::FILE* file, std::initializer_list<double> values) {
  for (const double v : values) std::fprintf(file, "%14.6e", v);
}

/// Writes two whole numbers in the places of one.
void whole_pair(std::FILE* file, size_t first, int second) {
  std::fprintf(file, "%7zu%4d   ", first, second);
}

/// A row of numbers; the table has 11 columns, unused ones are 0.
void row(std::FILE* file, std::initializer_list<double> values, size_t columns = 11) {
  cells(file, values);
  for (size_t n = values.size(); n < columns; ++n) cells(file, {0});
  std::fputc('\n', file);
}

std::string file_name(const Problem& p, int patch, const char* ending) {
  const Session s = session();
  std::string base = s.expnam;
  if (!s.program) base = p.module == 1 ? print("caddon_re%03d", p.ire) : print("caddon_re%03d_cp%d", p.ire, p.icp);
  base += print(".%04d", p.in.digits.ncase);
  if (p.module == 1) base += char('a' + patch - 1);
  return in_folder(s.outdir.empty() ? s.wrkdir : s.outdir, base + ending);
}

void heading(std::FILE* file, const char* names) {
  std::string text = "%";
  std::string word;
  for (const char* c = names;; ++c) {
    if (*c && *c != ' ') {
      word += *c;
    } else if (!word.empty()) {
      text += std::string(word.size() < 13 ? 13 - word.size() : 1, ' ') + word + " ";
      word.clear();
    }
    if (!*c) break;
  }
  std::fprintf(file, "%s\n", text.c_str());
}

void write_elements(std::FILE* file, const Problem& p, const ContactResult& r) {
  const bool heat = !r.temp1.empty();
  heading(file, heat ? "I IGS H MU PN PX PY UN UX UY SREL TEMP1 TEMP2" : "I IGS H MU PN PX PY UN UX UY SREL");
  for (size_t k = 0; k < r.pn.size(); ++k) {
    if (p.in.digits.matfil == 1 && r.division[k] == 0) continue;
    whole_pair(file, k + 1, r.division[k]);
    for (const double v :
         {r.h[k], r.mu[k], r.pn[k], r.px[k], r.py[k], r.un[k], r.ux[k], r.uy[k], std::hypot(r.sx[k], r.sy[k])})
      std::fprintf(file, "%14.6e", v);
    if (heat) cells(file, {r.temp1[k], r.temp2[k]});
    std::fputc('\n', file);
  }
}

void write_mat(const Problem& p, int patch) {
  const ContactResult& r = p.patches[size_t(patch - 1)];
  const Inputs& in = p.in;
  std::FILE* file = std::fopen(file_name(p, patch, ".mat").c_str(), "w");
  if (!file) return log_line("mat-file", p.ire, p.icp, "%s cannot be written", file_name(p, patch, ".mat").c_str());
  const auto& meta = in.metadata;
  const WheelSolver* w = p.module == 1 ? p.wheel.get() : nullptr;
  const double s = w ? w->sign : 1;
  const auto roll = [](const Mat3& m) { return std::atan2(m[2][1], m[1][1]); };
  heading(file, "TIM S_WS TH_WS Y_R Z_R ROLL_R RNOM_ROL");
  row(file, {meta[0], w ? in.wheelset.position[0] : meta[5], w ? in.wheelset.position[5] : 0,
             w ? s * w->rail.origin[1] : meta[2], w ? w->rail.origin[2] : 0, w ? s * roll(w->rail.rotation) : 0,
             w && in.digits.roller() ? in.track.nomrad : 0, 0, 0, 0, 2410});
  heading(file, "X_W Y_W Z_W ROLL_W YAW_W RNOM_WHL");
  row(file, {w ? w->wheel.origin[0] + w->x : meta[3], w ? s * w->wheel.origin[1] : meta[4], w ? w->wheel.origin[2] : 0,
             w ? s * roll(w->wheel.rotation) : 0, w ? s * std::asin(-w->wheel.rotation[0][1]) : 0,
             w ? in.wheelset.nomrad : 0});
  heading(file, "X_CP Y_CP Z_CP DELT_CP X_CP_W Y_CP_W Z_CP_W NPATCH SPINXO SPINYO");
  Vec3 rail{}, wheel{};
  double delta = 0;
  if (w) {
    const WheelPatch& at = w->patches[size_t(patch - 1)];
    rail = transposed(w->rail.rotation) * (at.reference + Vec3{w->x, 0, 0} - w->rail.origin);
    wheel = transposed(w->wheel.rotation) * (at.reference - w->wheel.origin);
    delta = s * (at.delta - roll(w->rail.rotation));
  }
  cells(file, {rail[0], s * rail[1], rail[2], delta, wheel[0], s * wheel[1], wheel[2]});
  whole_pair(file, p.patches.size(), patch);
  row(file, {r.spinxo, r.spinyo}, 3);
  heading(file, "MX XL YL DX DY CHI DQ C1 YNOM_WHL");
  whole_pair(file, size_t(r.grid.mx), r.grid.my);
  cells(file, {r.grid.xc - r.grid.dx / 2, r.grid.yc - r.grid.dy / 2, r.grid.dx, r.grid.dy, r.chi, r.dq});
  whole_pair(file, size_t(in.digits.config), w ? in.digits.discns : 0);
  row(file, {w ? in.wheelset.fbdist / 2 - in.wheelset.fbpos : 0, 0, 0}, 3);
  const auto& m = in.material;
  heading(file, "TM GG1 GG2 POISS1 POISS2");
  whole_pair(file, size_t(in.digits.tang), in.digits.mater);
  row(file, {m.g[0], m.g[1], m.nu[0], m.nu[1], m.more[0], m.more[1], m.more[2], m.more[3]}, 10);
  heading(file, "LH VELOC FRICTION");
  whole_pair(file, size_t(in.digits.frclaw), in.digits.heat);
  const auto& f = in.friction.rows[0].p;
  row(file, {r.veloc, f[0], f[1], f[2], f[3], f[4], in.friction.memdst, in.friction.mem_s0}, 10);
  write_elements(file, p, r);
  std::fclose(file);
}

}  // namespace

void write_results(Problem& p) {
  const Digits& d = p.in.digits;
  if (d.output >= 1) log_write(out_text(p));
  if (d.matfil < 1) return;
  for (size_t k = 0; k < p.patches.size() && k < 26; ++k)
    if (p.patches[k].solved) write_mat(p, int(k + 1));
}

void write_subsurface(Problem& p, int patch) {
  if (p.in.digits.sbsfil < 1) return;
  const auto found = p.blocks.find(p.module == 1 ? patch : p.icp);
  if (found == p.blocks.end() || patch > 26) return;
  std::FILE* file = std::fopen(file_name(p, patch, ".subs").c_str(), "w");
  if (!file) return log_line("subs-file", p.ire, p.icp, "%s cannot be written", file_name(p, patch, ".subs").c_str());
  const bool tensor = p.in.digits.sbsfil >= 2;
  for (const SubsurfaceBlock& block : found->second) {
    heading(file, "NX NY NZ");
    std::fprintf(file, "%14d%14d%14d\n", block.nx, block.ny, block.nz);
    heading(file,
            tensor ? "X Y Z UX UY UZ SIGHYD SIGVM SIGXX SIGXY SIGXZ SIGYY SIGYZ SIGZZ" : "X Y Z UX UY UZ SIGHYD SIGVM");
    for (size_t k = 0; k + 21 <= block.columns.size(); k += 21) {
      const double* q = &block.columns[k];
      for (int i = 0; i < 8; ++i) std::fprintf(file, "%12.4e", q[i]);
      if (tensor)
        for (const int i : {12, 13, 14, 16, 17, 20}) std::fprintf(file, "%12.4e", q[i]);
      std::fputc('\n', file);
    }
  }
  std::fclose(file);
}

}  // namespace cntc
