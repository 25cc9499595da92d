#pragma once
/// Of errors and times.

#include <vector>

namespace rollcon::bench {

double rms(const std::vector<double>& v);
/// What a part of them (0 to 1) does not exceed.
double quantile(std::vector<double> v, double part);

}  // namespace rollcon::bench
