#pragma once
/// Computes statistics of errors and times.

#include <vector>

namespace rollcon::bench {

double rms(const std::vector<double>& v);
/// Returns what a fraction of them (0 to 1) does not exceed.
double quantile(std::vector<double> v, double part);

}  // namespace rollcon::bench
