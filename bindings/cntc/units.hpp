#pragma once
#include "rollcon_cntc.h"

namespace cntc {

/// Holds factors from the caller's units to mm, s and N, and the sign of forces (SIMPACK takes those on body 2).
struct Units {
  int code = CNTC_un_cntc;
  double length = 1;
  double sign = 1;

  double area() const { return length * length; }
  double stress() const { return 1 / area(); }
};

inline Units units_of(int code) {
  const double length = code == CNTC_un_cntc ? 1 : 1000;
  return {code, length, code == CNTC_un_spck ? -1.0 : 1.0};
}

}  // namespace cntc
