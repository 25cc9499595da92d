// Life cycle: functions without a contact problem.
#include <algorithm>
#include <thread>

#include "bodies.hpp"
#include "text.hpp"

namespace cntc {

void set_file_units(const char* name, const int*, const int*) {
  if (session().begun) log_line(name, 0, 0, "this function comes before all others; unit numbers have no effect");
}

void initialize_first(const char*, int* version, int* error, const int* ioutput, const char* wrkdir, const char* outdir,
                      const char* expnam, const int* len_wrkdir, const int* len_outdir, const int* len_expnam) {
  const auto text = [](const char* t, const int* n) { return n ? text_of(t, *n) : std::string(); };
  begin_session(ioutput && *ioutput == 1, text(wrkdir, len_wrkdir), text(outdir, len_outdir), text(expnam, len_expnam));
  if (version) *version = interface_version;
  if (error) *error = 0;
}

void initialize(const char* name, const int* ire, const int* module, int* version, int* error, const char* outdir,
                const int* len_outdir) {
  if (version) *version = interface_version;
  int code = 0;
  if (!ire || !module || *ire < 1 || *ire > most_ire || (*module != 1 && *module != 3)) {
    log_line(name, ire ? *ire : 0, 0, "result elements are 1 to %d, modules 1 and 3", most_ire);
    code = CNTC_err_icp;
  } else {
    begin_session(false, "", len_outdir ? text_of(outdir, *len_outdir) : std::string(), "");
    if (module_of(*ire)) {
      log_line(name, *ire, 0, "the result element is there already; nothing changes");
    } else if (!make_element(*ire, *module)) {
      log_line(name, *ire, 0, "%d result elements are alive; finalize one", most_alive);
      code = CNTC_err_icp;
    }
  }
  if (error) *error = code;
}

void set_global_flags(const char* name, const int* n, const int* params, const int* values) {
  if (!n || (*n > 0 && (!params || !values))) return log_line(name, 0, 0, "an argument is NULL");
  for (int k = 0; k < std::min(*n, 1000); ++k) {
    if (params[k] == CNTC_if_idebug) {
      set_global(&Session::idebug, values[k]);
    } else if (params[k] == CNTC_if_openmp) {
      set_global(&Session::openmp, values[k]);
    } else if (params[k] != 0 && params[k] != CNTC_if_licdbg) {
      log_line(name, 0, 0, "unknown parameter code=%d is ignored", params[k]);
    }
  }
}

void get_max_threads(const char* name, int* threads) {
  if (!threads) return log_line(name, 0, 0, "an argument is NULL");
  *threads = int(std::max(1u, std::thread::hardware_concurrency()));
}

void finalize(const char* name, const int* ire) {
  if (!ire || *ire < 1 || *ire > most_ire || !free_element(*ire))
    log_line(name, ire ? *ire : 0, 0, "there is no such result element");
}

void finalize_last() {
  end_session();
}

}  // namespace cntc
