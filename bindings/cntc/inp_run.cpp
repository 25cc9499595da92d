// Runs input files, and takes a wheel's inputs from one.
#include <cstdio>
#include <map>
#include <memory>
#include <tuple>

#include "bodies.hpp"
#include "files.hpp"
#include "inp_case.hpp"
#include "text.hpp"

namespace cntc {
namespace {

/// Result elements of a file are its own; they may have any number and both modules.
using Problems = std::map<std::tuple<int, int, int>, std::unique_ptr<Problem>>;

/// Solves a case, then its blocks of points; returns whether it failed.
bool run_case(Problem& p, bool check_only) {
  Call c{"rollcon-cntc", p, p.icp};
  if (check_only || p.in.digits.ret >= 2) return false;
  int code = 0;
  calculate(c, {code});
  if (code < 0) return true;
  const auto blocks = p.blocks.find(p.module == 1 ? -1 : p.icp);
  if (blocks == p.blocks.end() || blocks->second.empty()) return false;
  const auto kept = blocks->second;
  if (p.module == 1) {
    p.blocks.clear();
    p.blocks[-1] = kept;
  }
  calculate_subsurface(c, {code});
  return code < 0;
}

}  // namespace

int run_inp(const std::string& path, bool check_only) {
  Problems problems;
  int failed = 0, cases = 0;
  try {
    InpReader reader(path);
    while (!reader.at_end()) {
      const auto head = reader.reals(1, 2, "the module");
      const int module = int(head[0]);
      if (module == 0) break;
      if (module != 1 && module != 3) reader.fail(print("module %d is not available; allowed: 0, 1, 3", module));
      const double ire = head.size() > 1 ? head[1] : 1, icp = head.size() > 2 ? head[2] : 1;
      if (!(ire >= 0 && ire <= most_ire) || !(icp >= -1 && icp <= most_icp))
        reader.fail(
            print("result element %g, contact problem %g; allowed: 1 to %d, 1 to %d", ire, icp, most_ire, most_icp));
      auto& problem = problems[{module, int(ire), module == 1 ? -1 : int(icp)}];
      const bool fresh = !problem;
      if (fresh) problem = std::make_unique<Problem>(int(ire), module == 1 ? -1 : int(icp), module);
      for (bool first = fresh, more = true; more; first = false) {
        InpCase next(reader, *problem, folder_of(path), first);
        if (module == 1) {
          next.read_wheel();
        } else {
          next.read_gap();
        }
        failed += run_case(*problem, check_only);
        if (++cases % 100 == 0) std::fprintf(stderr, "%s: %d cases\n", path.c_str(), cases);
        more = problem->in.digits.ret == 0 || problem->in.digits.ret == 2;
      }
    }
  } catch (const InpError& error) {
    log_line("rollcon-cntc", 0, 0, "%s", error.what());
    std::fprintf(stderr, "%s\n", error.what());
    return -1;
  }
  log_write(print("\n %d cases, %d of them failed\n", cases, failed));
  return failed;
}

void read_inp_file(Call& c, int type, const char* fname, int length, ErrorCode error_code) {
  const std::string name = text_of(fname, length);
  const std::string path = in_folder(session().wrkdir, name);
  error_code.value = CNTC_err_input;
  if (type != CNTC_inp_modul1 && type != CNTC_inp_spck) {
    return say(c, "input files of type %d are not available; allowed: %d, %d", type, CNTC_inp_modul1, CNTC_inp_spck);
  }
  Problem copy(c.p.ire, c.p.icp, 1);
  copy.in = c.in();
  copy.in.units = {};
  try {
    InpReader reader(path);
    const int module = reader.integer("the module");
    InpCase next(reader, copy, folder_of(path), type == CNTC_inp_modul1);
    if (type == CNTC_inp_modul1) {
      if (module != 1) reader.fail("the first case is not of module 1");
      next.read_wheel();
    } else {
      if (module != 0 && module != 1 && module != 11) reader.fail("the module is 0 or 11");
      next.read_simpack();
    }
  } catch (const InpError& error) {
    return say(c, "%s", error.what());
  }
  const Digits old = c.in().digits;
  copy.in.units = c.in().units;
  copy.in.digits.ncase = old.ncase;
  copy.in.digits.idebug = old.idebug;
  c.in() = std::move(copy.in);
  c.p.blocks = std::move(copy.blocks);
  error_code.value = 0;
}

}  // namespace cntc
