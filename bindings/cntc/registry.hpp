#pragma once
#include <map>
#include <memory>
#include <string>

#include "problem.hpp"

namespace cntc {

constexpr int most_ire = 999, most_alive = 100, most_icp = 9;
constexpr int interface_version = 2520;

/// Holds folders and names of the first call, and flags for all result elements.
struct Session {
  bool begun = false;
  std::string wrkdir, outdir, expnam = "contact_addon";
  int idebug = 0, openmp = 1;
  bool program = false;  // true in rollcon-cntc, whose files are named by its input file
};
Session session();

/// Opens the log with a box of title and version, unless the log is open.
void begin_session(bool screen, const std::string& wrkdir, const std::string& outdir, const std::string& expnam,
                   bool program = false);
void end_session();
void set_global(int Session::*flag, int value);

/// Returns the module of a live result element, or 0 if there is none.
int module_of(int ire);
/// Makes a result element; returns false if 100 are alive.
bool make_element(int ire, int module);
/// Frees a result element; returns false if there is none. The session ends with the last one.
bool free_element(int ire);

/// Finds or makes the problem; returns a null pointer if the result element is not alive.
std::shared_ptr<Problem> problem_of(int ire, int icp);

}  // namespace cntc
