#pragma once
/// A solution of a contact, to go back to.

#include "contact/newton/report.hpp"
#include "contact/problem/problem.hpp"
#include "contact/problem/settled_friction.hpp"

namespace rollcon {

struct KeptSolution {
  Iterate iterate;
  bool solved = false, warm_usable = false, images_known = false;
  std::int64_t number = 0;
  NewtonReport report;
  SettledFriction settled_friction;
};

}  // namespace rollcon
