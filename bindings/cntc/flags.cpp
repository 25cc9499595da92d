#include <algorithm>

#include "bodies.hpp"

namespace cntc {
namespace {

/// Describes a flag of cntc_setflags: where it is kept, its range, and whether it can be set and read.
struct Flag {
  int code;
  int Digits::*digit;
  int low, high;
  bool settable, readable;
};

constexpr int any = 2000000000;
const Flag table[] = {
    {CNTC_ic_config, &Digits::config, 0, 5, true, true},
    {CNTC_ic_pvtime, &Digits::pvtime, 0, 3, true, true},
    {CNTC_ic_bound, &Digits::bound, 0, 6, true, true},
    {CNTC_ic_tang, &Digits::tang, 0, 3, true, true},
    {CNTC_ic_norm, &Digits::norm, 0, 1, true, true},
    {CNTC_ic_force, &Digits::force, 0, 3, true, true},
    {CNTC_ic_frclaw, &Digits::frclaw, 0, 6, false, true},
    {CNTC_ic_discns, &Digits::discns, 0, 9, true, true},
    {CNTC_ic_inflcf, &Digits::inflcf, 0, 4, true, true},
    {CNTC_ic_mater, &Digits::mater, 0, 7, false, true},
    {CNTC_ic_exrhs, &Digits::exrhs, 0, 3, true, false},
    {CNTC_ic_xflow, &Digits::xflow, 0, any, true, true},
    {CNTC_ic_heat, &Digits::heat, 0, 3, false, true},
    {CNTC_ic_iestim, &Digits::iestim, 0, 3, true, true},
    {CNTC_ic_output, &Digits::output, 0, 5, true, true},
    {CNTC_ic_flow, &Digits::flow, 0, 9, true, true},
    {CNTC_ic_return, &Digits::ret, 0, 3, true, true},
    {CNTC_ic_matfil, &Digits::matfil, 0, 2, true, true},
    {CNTC_ic_sens, &Digits::sens, 0, 3, true, true},
    {CNTC_ic_ifmeth, &Digits::ifmeth, 0, 1, true, true},
    {CNTC_ic_ifvari, &Digits::ifvari, 1, 4, true, true},
    {CNTC_ic_sbsout, &Digits::sbsout, 0, 4, true, true},
    {CNTC_ic_sbsfil, &Digits::sbsfil, 0, 2, true, true},
    {CNTC_ic_npomax, &Digits::npomax, 100, 1000000, true, true},
    {CNTC_if_idebug, &Digits::idebug, -any, any, true, false},
    {CNTC_if_licdbg, &Digits::licdbg, -any, any, true, false},
    {CNTC_if_wrtinp, &Digits::wrtinp, 0, 1, true, true},
    {CNTC_if_openmp, &Digits::openmp, -1, 4096, true, false},
    {CNTC_if_timers, &Digits::timers, 0, 2, true, false},
    {CNTC_if_ncase, &Digits::ncase, 0, 99999999, true, true},
    {CNTC_if_frames, &Digits::frames, 0, 1, true, true},
};

/// Finds a flag by its code; returns a null pointer if there is none.
const Flag* flag_of(int code) {
  for (const Flag& flag : table)
    if (flag.code == code) return &flag;
  return nullptr;
}

/// Returns the value that a flag takes: the wanted one cut to the range, or the one that CONTACT takes instead.
int flag_value(const Flag& flag, int wanted) {
  if (flag.code == CNTC_ic_matfil && (wanted < 0 || wanted > 2)) return 0;
  if (flag.code == CNTC_ic_sbsout && wanted == 3) return 2;
  if (flag.code == CNTC_if_ncase) return std::clamp(wanted - 1, -1, flag.high);
  return std::clamp(wanted, flag.low, flag.high);
}

/// Goes through flags and their values: `units` takes the value of the units, `each` those of flags that are known.
template <class Value, class SetUnits, class Each>
void for_flags(Call& c, int n, const int* params, Value* values, SetUnits units, Each each) {
  if (n > 0 && (!params || !values)) return say(c, "an argument is NULL");
  for (int k = 0; k < std::min(n, 1000); ++k) {
    const Flag* flag = flag_of(params[k]);
    if (params[k] == CNTC_if_units) {
      units(values[k]);
    } else if (flag) {
      each(*flag, values[k]);
    } else if (params[k] != 0) {
      say(c, "unknown parameter code=%d is ignored", params[k]);
    }
  }
}

}  // namespace

void set_flags(Call& c, int n, const int* params, const int* values) {
  const auto set_units = [&](int code) {
    if (code == CNTC_un_cntc || code == CNTC_un_spck || code == CNTC_un_si) {
      c.in().units = units_of(code);
    } else {
      say(c, "units %d are not available: use %d (mm), %d (SIMPACK) or %d (SI)", code, CNTC_un_cntc, CNTC_un_spck,
          CNTC_un_si);
    }
  };
  for_flags(c, n, params, values, set_units, [&](const Flag& flag, int value) {
    if (flag.settable) {
      c.in().digits.*flag.digit = flag_value(flag, value);
    } else {
      say(c, "code=%d cannot be set by flags: it follows from the functions that set friction, material or heat",
          flag.code);
    }
  });
}

void get_flags(Call& c, int n, const int* params, int* values) {
  const auto get_units = [&](int& code) { code = c.in().units.code; };
  for_flags(c, n, params, values, get_units, [&](const Flag& flag, int& value) {
    if (!flag.readable) return say(c, "unknown parameter code=%d is ignored", flag.code);
    value = c.in().digits.*flag.digit;
    if (flag.code == CNTC_ic_xflow) value = value > 0;
  });
}

}  // namespace cntc
