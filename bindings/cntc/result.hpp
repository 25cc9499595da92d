#pragma once
#include <array>
#include <vector>

#include "inputs.hpp"

namespace cntc {

using Vec3 = std::array<double, 3>;
using Mat3 = std::array<Vec3, 3>;  // rows

/// Holds results of a contact that need no elements, in mm, s and N, on body 1, in the axes of the contact; its motion
/// is what was found.
struct Totals : Motion {
  bool solved = false;
  bool deferred = false;  // elements are filled when a getter asks for them
  double fstat = 0, tx = 0, ty = 0, mz = 0, power = 0, pmax = 0;
  double mx = 0, my = 0;  // moments of the pressures about the axes x and y
  std::array<double, 16> sensitivities{};
};

struct ContactResult : Totals {
  Grid grid;
  std::vector<double> h, mu, px, py, pn, ux, uy, un, sx, sy, temp1, temp2;
  std::vector<int> division;
  int iterations = 0;  // Newton steps of the solve
  int rim = 0;         // elements in contact next to the border

  long count(int state) const {
    long n = 0;
    for (int s : division) n += s == state;
    return n;
  }
};

/// Holds the place of a body's profile in the track: origin, roll and yaw.
struct BodyPlace {
  Vec3 origin{};
  Mat3 rotation{};  // to the track
};

}  // namespace cntc
