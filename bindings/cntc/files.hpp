#pragma once
#include <string>

#include "problem.hpp"

namespace cntc {

/// Writes the inputs as a case of an input file, if the flag wrtinp asks for it.
void write_inp(Problem& p);
/// Writes the case to the out-file and to mat-files, as far as the digits O and A ask for them.
void write_results(Problem& p);
/// Writes blocks of a patch, counted from 1, to a subs-file (digit A_s).
void write_subsurface(Problem& p, int patch);

/// Returns the text of the out-file for a case.
std::string out_text(const Problem& p);

}  // namespace cntc
