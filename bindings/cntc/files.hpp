#pragma once
#include <string>

#include "problem.hpp"

namespace cntc {

/// Writes what was set as a case of an input file, if the flag wrtinp asks for it.
void write_inp(Problem& p);
/// Writes the case to the out-file (O) and to mat-files (A), as far as the digits ask for them.
void write_results(Problem& p);
/// Writes blocks of a patch, from 1, to a subs-file (A_s).
void write_subsurface(Problem& p, int patch);

/// Text of the out-file for a case.
std::string out_text(const Problem& p);

}  // namespace cntc
