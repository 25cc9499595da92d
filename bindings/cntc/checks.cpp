#include "checks.hpp"

#include <cmath>

namespace cntc {

bool no_method(const Call& c, int method) {
  say(c, "method %d does not exist", method);
  return false;
}

bool lacks(const Call& c, int method, int n, int needed, const double* params) {
  return lacks(c, method, n, needed, needed, params);
}

bool lacks(const Call& c, int method, int n, int least, int most, const double* params) {
  if (n < least || n > most) {
    if (least == most) {
      say(c, "method %d needs %d parameters, not %d", method, least, n);
    } else {
      say(c, "method %d needs %d to %d parameters, not %d", method, least, most, n);
    }
    return true;
  }
  return !all_finite(c, n, params);
}

bool all_finite(const Call& c, int n, const double* params) {
  if (n > 0 && !params) {
    say(c, "an array is NULL");
    return false;
  }
  for (int k = 0; k < n; ++k)
    if (!std::isfinite(params[k])) {
      say(c, "number %d is not finite", k + 1);
      return false;
    }
  return true;
}

int whole(double value) {
  return value > -2e9 && value < 2e9 ? int(std::lround(value)) : 0;
}

void put(int n, double* values, const double* from, int available, bool zero_beyond) {
  if (!values) return;
  for (int k = 0; k < n; ++k) {
    if (k < available) {
      values[k] = from[k];
    } else if (zero_beyond) {
      values[k] = 0;
    } else {
      break;
    }
  }
}

}  // namespace cntc
