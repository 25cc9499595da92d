#pragma once
#include "dispatch.hpp"

namespace cntc {

/// Says that a method does not exist, or that its parameters are not as many as it needs, or are no numbers.
bool no_method(const Call& c, int method);
bool lacks(const Call& c, int method, int n, int needed, const double* params);
bool lacks(const Call& c, int method, int n, int least, int most, const double* params);

/// Tells whether numbers are finite; else there is a line in the log.
bool all_finite(const Call& c, int n, const double* params);

/// Rounds a number of elements or points; 0 where it is none.
int whole(double value);

/// Fills as much of an array as was asked for and leaves what is beyond, or sets it to 0.
void put(int n, double* values, const double* from, int available, bool zero_beyond);

}  // namespace cntc
