#pragma once
#include <string>

namespace cntc {

/// Runs an input file, or only checks it; returns how many cases failed, or -1 where the file is wrong.
int run_inp(const std::string& path, bool check_only);

}  // namespace cntc
