#pragma once
#include <array>
#include <string>

#include "problem.hpp"

namespace cntc {

/// Runs an input file, or only checks it; returns the number of cases that failed, or -1 if the file is wrong.
int run_inp(const std::string& path, bool check_only);

/// Writes the inputs as a case of an input file, if the flag wrtinp asks for it.
void write_inp(Problem& p);
/// Writes the case to the out-file and to mat-files, as far as the digits O and A ask for them.
void write_results(Problem& p);
/// Writes blocks of a patch, counted from 1, to a subs-file (digit A_s).
void write_subsurface(Problem& p, int patch);

/// Returns what cntc_getcontactlocation and cntc_getglobalforces have of a patch, counted from 1; -1: all of them.
std::array<double, 38> location(Problem& p, int patch, double length);
std::array<double, 24> global_forces(const Problem& p, int patch, const Units& units);

/// Returns the text of the out-file for a case.
std::string out_text(Problem& p);
/// Returns the text of the out-file for blocks of points: the extremes of their stresses.
std::string subsurface_text(const std::vector<SubsurfaceBlock>& blocks);

}  // namespace cntc
