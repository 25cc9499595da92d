// Writes mat-files and subs-files, tables in columns of 14 places.
#include <cmath>
#include <cstdio>

#include "files.hpp"
#include "log.hpp"
#include "registry.hpp"
#include "text.hpp"

namespace cntc {
namespace {

/// Writes rows of equal length, as programs that load the file need them; unused columns are 0.
class Rows {
 public:
  Rows(std::FILE* file, size_t columns) : file_(file), columns_(columns) {}
  void cells(std::initializer_list<double> values) {
    for (const double v : values) std::fprintf(file_, "%14.6e", v);
    used_ += values.size();
  }
  /// Writes two whole numbers in the places of one.
  void pair(size_t first, int second) {
    std::fprintf(file_, "%7zu%4d   ", first, second);
    used_ += 2;
  }
  /// Ends a row, whose last number may be given.
  void end(double last = 0) {
    while (used_ + 1 < columns_) cells({0});
    if (used_ < columns_) cells({last});
    std::fputc('\n', file_);
    used_ = 0;
  }

 private:
  std::FILE* file_;
  size_t columns_, used_ = 0;
};

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

void write_mat(Problem& p, int patch) {
  const ContactResult& r = p.patches[size_t(patch - 1)];
  const Inputs& in = p.in;
  std::FILE* file = std::fopen(file_name(p, patch, ".mat").c_str(), "w");
  if (!file) return log_line("mat-file", p.ire, p.icp, "%s cannot be written", file_name(p, patch, ".mat").c_str());
  const auto& m = in.material;
  const bool w = p.module == 1, heat = in.digits.heat != 0;
  const bool yields = in.yields();
  Rows rows(file, 11 + (yields ? 3 : 0) + (heat ? 2 : 0));
  const auto& meta = in.metadata;
  const auto& q = in.wheelset.position;
  const auto l = location(p, patch, 1);
  heading(file, "TIM S_WS TH_WS Y_R Z_R ROLL_R RNOM_ROL");
  rows.cells({meta[0], w ? q[0] : meta[5], w ? q[5] : 0, w ? l[25] : meta[2], l[26], l[27],
              in.digits.roller() ? in.track.nomrad : 0});
  rows.end(2410);
  heading(file, "X_W Y_W Z_W ROLL_W YAW_W RNOM_WHL");
  rows.cells({w ? l[20] : meta[3], w ? l[21] : meta[4], l[22], l[23], l[24], w ? in.wheelset.nomrad : 0});
  rows.end();
  heading(file, "X_CP Y_CP Z_CP DELT_CP X_CP_W Y_CP_W Z_CP_W NPATCH SPINXO SPINYO");
  rows.cells({l[4], l[5], l[6], l[8], l[9], l[10], l[11]});
  rows.pair(p.patches.size(), patch);
  rows.cells({r.spinxo, r.spinyo});
  rows.end();
  heading(file, "MX XL YL DX DY CHI DQ C1 YNOM_WHL");
  rows.pair(size_t(r.grid.mx), r.grid.my);
  rows.cells({r.grid.xc - r.grid.dx / 2, r.grid.yc - r.grid.dy / 2, r.grid.dx, r.grid.dy, r.chi, r.dq});
  rows.pair(size_t(in.digits.config), w ? in.digits.discns : 0);
  rows.cells({w ? in.wheelset.fbdist / 2 - in.wheelset.fbpos : 0});
  rows.end();
  heading(file, "TM GG1 GG2 POISS1 POISS2");
  rows.pair(size_t(in.digits.tang), in.digits.mater);
  rows.cells({m.g[0], m.g[1], m.nu[0], m.nu[1], m.more[0], m.more[1], m.more[2], m.more[3]});
  rows.end();
  heading(file, "LH VELOC FRICTION");
  rows.pair(size_t(in.digits.frclaw), in.digits.heat);
  rows.cells({r.veloc});
  for (int k = 0; k < friction_parameters[in.friction.law]; ++k) rows.cells({in.friction.rows[0].p[size_t(k)]});
  if (in.friction.law >= 2) rows.cells({in.friction.memdst, in.friction.mem_s0});
  rows.end();
  heading(file, (std::string("I IGS H MU PN PX PY UN UX UY SREL") + (yields ? " TAUCRT UPLSX UPLSY" : "") +
                 (heat ? " TEMP1 TEMP2" : ""))
                    .c_str());
  for (size_t k = 0; k < r.pn.size(); ++k) {
    if (in.digits.matfil == 1 && r.division[k] == 0) continue;
    rows.pair(k + 1, r.division[k]);
    rows.cells({r.h[k], r.mu[k], r.pn[k], r.px[k], r.py[k], r.un[k], r.ux[k], r.uy[k], std::hypot(r.sx[k], r.sy[k])});
    if (yields) rows.cells({m.more[2], 0, 0});  // the flow is not known by elements
    if (heat && !r.temp1.empty()) rows.cells({r.temp1[k], r.temp2[k]});
    rows.end();
  }
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
  const auto found = p.blocks.find(p.module == 1 ? patch : p.icp);
  if (found == p.blocks.end()) return;
  if (p.in.digits.sbsout >= 1) log_write(subsurface_text(found->second));
  if (p.in.digits.sbsfil < 1 || patch > 26) return;
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
