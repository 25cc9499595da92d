#pragma once
#include <map>
#include <memory>
#include <string>

#include "problem.hpp"

namespace cntc {

constexpr int most_ire = 999, most_alive = 100, most_icp = 9;
constexpr int interface_version = 2520;

/// Folders and names of the first call, and flags that hold for all.
struct Session {
  bool begun = false;
  std::string wrkdir, outdir, expnam = "contact_addon";
  int idebug = 0, openmp = 1;
  bool program = false;  // rollcon-cntc: names of files are those of its input file
};
Session session();

/// Opens the log with a box of title and version, unless it is open.
void begin_session(bool screen, const std::string& wrkdir, const std::string& outdir, const std::string& expnam);
void end_session();
void set_program();
void set_global(int Session::*flag, int value);

/// Module of a live result element, 0 for none.
int module_of(int ire);
/// Makes a result element; false where 100 are alive.
bool make_element(int ire, int module);
/// Frees one; false where there is none. With the last one the session ends.
bool free_element(int ire);

/// Finds or makes the problem; nothing where the element is not alive.
std::shared_ptr<Problem> problem_of(int ire, int icp);

}  // namespace cntc
