#pragma once
#include <string>

namespace cntc {

/// Runs an input file, or only checks it; returns the number of cases that failed, or -1 if the file is wrong.
int run_inp(const std::string& path, bool check_only);

}  // namespace cntc
