// Results of module 1.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "checks.hpp"
#include "files.hpp"
#include "sections.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

double roll_of(const Mat3& m) {
  return std::atan2(m[2][1], m[1][1]);
}
double yaw_of(const Mat3& m) {
  return std::asin(std::clamp(-m[0][1], -1., 1.));
}

/// Arc length of the profile at the point nearest to (y, z), from where y = 0.
double arc_length(const Profile& profile, double y, double z) {
  const Section section(profile);
  const double s = section.least(4000, [&](const Vec3& at) { return std::hypot(at[1] - y, at[2] - z); });
  const SectionPoint p = section.at(s);
  return s + (y - p.place[1]) * std::cos(p.slope) + (z - p.place[2]) * std::sin(p.slope) - section.middle();
}

}  // namespace

void get_wheelset_position(Call& c, int n, double* values) {
  const double length = c.units().length;
  const WheelSolver* w = c.p.wheel.get();
  const auto& q = c.in().wheelset.position;
  const double z = w && w->solved ? w->z : q[2];
  const double v[6] = {q[0] / length, q[1] / length, z / length, q[3], q[4], q[5]};
  put(n, values, v, 6, true);
}

void get_wheelset_velocity(Call& c, int n, double* values) {
  const double length = c.units().length;
  const WheelSolver* w = c.p.wheel.get();
  const auto& q = c.in().wheelset.velocity;
  const double rate = w && w->solved && c.in().digits.force == 1 ? w->pitch_rate : q[5];
  const double first = q[0] / (c.in().digits.roller() ? 1 : length);  // a rate, if the rail is a roller
  const double v[6] = {first, q[1] / length, q[2] / length, q[3], q[4], rate};
  put(n, values, v, 6, true);
}

void get_patch_count(Call& c, int& patches) {
  patches = int(c.p.patches.size());
}

std::array<double, 38> location(Problem& p, int number, double length) {
  std::array<double, 38> values{};
  double* v = values.data();
  const WheelSolver* w = p.wheel.get();
  if (w && w->solved && number >= 1 && size_t(number) <= w->patches.size()) {
    const double s = w->sign;
    const WheelPatch& patch = w->patches[size_t(number - 1)];
    const ContactResult& r = *Call{"", p, number}.elements();
    const auto place = [&](int from, const Vec3& x) {
      v[from] = x[0] / length;
      v[from + 1] = s * x[1] / length;
      v[from + 2] = x[2] / length;
    };
    const Vec3 off{w->x, 0, 0};
    place(0, patch.reference + off);
    v[3] = s * patch.delta;
    const Vec3 in_rail = transposed(w->rail.rotation) * (patch.reference + off - w->rail.origin);
    place(4, in_rail);
    v[7] = s * arc_length(w->rail_profile, in_rail[1], in_rail[2]) / length;
    v[8] = s * (patch.delta - roll_of(w->rail.rotation));
    const Vec3 in_wheel = transposed(w->wheel.rotation) * (patch.reference - w->wheel.origin);
    place(9, in_wheel);
    v[12] = s * arc_length(w->wheel_profile, in_wheel[1], in_wheel[2]) / length;
    v[13] = s * (patch.delta - roll_of(w->wheel.rotation));
    double sum = 0, x = 0, y = 0;
    for (size_t k = 0; k < r.pn.size(); ++k) {
      sum += r.pn[k];
      x += r.pn[k] * r.grid.x(int(k % size_t(r.grid.mx)));
      y += r.pn[k] * r.grid.y(int(k / size_t(r.grid.mx)));
    }
    if (sum > 0) {
      v[14] = (patch.reference[0] + w->x + x / sum) / length;
      v[15] = (s * patch.reference[1] + y / sum * std::cos(patch.delta)) / length;
    }
    if (p.in.digits.force == 3) {
      v[17] = s * w->deflection[0] / length;
      v[18] = w->deflection[1] / length;
    }
    place(20, w->wheel.origin + off);
    v[23] = s * roll_of(w->wheel.rotation);
    v[24] = s * yaw_of(w->wheel.rotation);
    v[25] = s * w->rail.origin[1] / length;
    v[26] = w->rail.origin[2] / length;
    v[27] = s * roll_of(w->rail.rotation);
    const Mat3 to_set = transposed(w->wheelset.rotation);
    place(29, to_set * (patch.reference - w->wheelset.origin));
    v[32] = s * (patch.delta - roll_of(w->wheelset.rotation));
    place(33, to_set * (w->wheel.origin - w->wheelset.origin));
    v[36] = s * roll_of(to_set * w->wheel.rotation);
    v[37] = s * yaw_of(to_set * w->wheel.rotation);
  }
  return values;
}

void get_location(Call& c, int n, double* values) {
  put(n, values, location(c.p, c.icp, c.units().length).data(), 38, true);
}

std::array<double, 24> global_forces(const Problem& p, int number, const Units& units) {
  std::array<double, 24> v{};
  const WheelSolver* w = p.wheel.get();
  if (w && w->solved) {
    const double s = w->sign, length = units.length, sign = units.sign;
    for (size_t k = 0; k < w->patches.size(); ++k) {
      if (number > 0 && size_t(number) != k + 1) continue;
      const WheelPatch& patch = w->patches[k];
      const ContactResult& r = p.patches[k];
      // The sums are those of the mirror image, whose lateral components have the other sign.
      const Vec3 f = r.tx * patch.along() + s * r.ty * patch.across() + r.fn * patch.normal();
      const Vec3 m = s * r.mx * patch.along() + r.my * patch.across() + s * r.mz * patch.normal();
      const Vec3 about_rail = m + cross(patch.reference - w->rail.origin, f);
      const Vec3 about_wheel = m + cross(patch.reference - w->wheel.origin, f);
      const auto add = [&](int from, const Vec3& force, const Vec3& moment) {
        for (size_t d = 0; d < 3; ++d) {
          v[size_t(from) + d] += sign * (d == 1 ? s : 1) * force[d];
          v[size_t(from) + 3 + d] += sign * (d == 1 ? 1 : s) * moment[d] / length;
        }
      };
      const Mat3 set = transposed(w->wheelset.rotation), rail = transposed(w->rail.rotation),
                 wheel = transposed(w->wheel.rotation);
      add(0, f, about_rail);
      add(6, set * f, set * about_wheel);
      add(12, rail * f, rail * about_rail);
      add(18, wheel * f, wheel * about_wheel);
    }
  }
  return v;
}

void get_global_forces(Call& c, int n, double* values) {
  put(n, values, global_forces(c.p, c.icp, c.units()).data(), 24, true);
}

}  // namespace cntc
