#pragma once
#include "dispatch.hpp"

namespace cntc {

/// Writes to the log that a method does not exist; returns false.
bool no_method(const Call& c, int method);
/// Tells whether the parameters of a method are too few, too many or not finite; writes a line to the log if so.
bool lacks(const Call& c, int method, int n, int needed, const double* params);
bool lacks(const Call& c, int method, int n, int least, int most, const double* params);

/// Tells whether numbers are finite; writes a line to the log if not.
bool all_finite(const Call& c, int n, const double* params);

/// Rounds a number of elements or points; returns 0 where the value is no such number.
int whole(double value);

/// Copies the available values to an array of n, and leaves the rest of the array or sets it to 0.
void put(int n, double* values, const double* from, int available, bool zero_beyond);

}  // namespace cntc
