#pragma once
#include "inputs.hpp"

namespace cntc {

/// Describes a flag of cntc_setflags: where it is kept, its range, and whether it can be set and read.
struct Flag {
  int code;
  int Digits::*digit;
  int low, high;
  bool settable, readable;
};
/// Finds a flag by its code; returns a null pointer if there is none.
const Flag* flag_of(int code);

/// Returns the value that a flag takes: the wanted one cut to the range, or the one that CONTACT takes instead.
int flag_value(const Flag& flag, int wanted);

}  // namespace cntc
