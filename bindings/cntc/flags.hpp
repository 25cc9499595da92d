#pragma once
#include "inputs.hpp"

namespace cntc {

/// A flag of cntc_setflags: where it is kept, its range, whether it can be set and read.
struct Flag {
  int code;
  int Digits::*digit;
  int low, high;
  bool settable, readable;
};
/// Finds a flag, or nothing.
const Flag* flag_of(int code);

/// Value that a flag gets: cut to its range, or what CONTACT takes for it.
int flag_value(const Flag& flag, int wanted);

}  // namespace cntc
