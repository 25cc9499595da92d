// Results of module 1.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "checks.hpp"
#include "vectors.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

/// Sign of what changes sign in a mirror.
double side_of(const Call& c) {
  return c.p.wheel ? c.p.wheel->sign : 1;
}

double roll_of(const Mat3& m) {
  return std::atan2(m[2][1], m[1][1]);
}
double yaw_of(const Mat3& m) {
  return std::asin(std::clamp(-m[0][1], -1., 1.));
}

/// Arc length of the profile at the point nearest to (y, z), from where y = 0.
double arc_length(const Profile& profile, double y, double z) {
  double best = 1e300, nearest = 0, first = 1e300, zero = 0;
  const int n = 4000;
  for (int k = 0; k <= n; ++k) {
    double py = 0, pz = 0, slope = 0;
    const double s = profile.length() * k / n;
    profile.at(s, py, pz, slope);
    const double off = std::hypot(py - y, pz - z);
    if (off < best) {
      best = off;
      nearest = s + (y - py) * std::cos(slope) + (z - pz) * std::sin(slope);
    }
    if (std::abs(py) < first) {
      first = std::abs(py);
      zero = s - py * std::cos(slope);
    }
  }
  return nearest - zero;
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

void get_location(Call& c, int n, double* values) {
  double v[38] = {};
  const WheelSolver* w = c.p.wheel.get();
  if (w && w->solved && c.icp >= 1 && size_t(c.icp) <= w->patches.size()) {
    const double s = side_of(c), length = c.units().length;
    const WheelPatch& patch = w->patches[size_t(c.icp - 1)];
    const ContactResult& r = *c.elements();
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
    if (c.in().digits.force == 3) {
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
  put(n, values, v, 38, true);
}

void get_global_forces(Call& c, int n, double* values) {
  double v[24] = {};
  const WheelSolver* w = c.p.wheel.get();
  if (w && w->solved) {
    const double s = side_of(c), length = c.units().length;
    const double sign = c.units().sign;
    for (size_t k = 0; k < w->patches.size(); ++k) {
      if (c.icp > 0 && size_t(c.icp) != k + 1) continue;
      const WheelPatch& patch = w->patches[k];
      const ContactResult& r = c.p.patches[k];
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
  put(n, values, v, 24, true);
}

namespace {

struct ProfilePoint {
  double y, z, s, slope;
};

/// Samples a profile: uniformly, or n points in each of a hundred intervals.
std::vector<ProfilePoint> sample(const Profile& profile, int how, double step) {
  const double length = profile.length();
  int n = how >= 2 ? 100 * std::min(how, 1000) : 400;
  if (how == 1 && step > 0) n = int(std::clamp(length / step, 1., 1e6));
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= n; ++k) {
    ProfilePoint p{};
    p.s = length * k / n;
    profile.at(p.s, p.y, p.z, p.slope);
    points.push_back(p);
  }
  return points;
}

}  // namespace

void get_profile_values(Call& c, int task, int nints, const int* ints, int nreals, const double* reals, int n,
                        double* values) {
  if (n > 0 && !values) return say(c, "an array is NULL");
  const bool wheel = nints > 0 && ints && ints[0] == 1;
  const int how = nints > 1 && ints ? ints[1] : 0;
  const double step = nreals > 0 && reals && std::isfinite(reals[0]) ? reals[0] : 1;
  const double length = c.units().length;
  Profile profile;
  ContextHandle context;
  int error = 0;
  try {
    rollcon_context* made = nullptr;
    check(rollcon_context_create(ROLLCON_ABI, &made));
    context.reset(made);
    profile.make(made, wheel ? c.in().wheel : c.in().rail, c.in().material);
  } catch (const Failure& failure) {
    error = failure.code;
    say(c, "%s", failure.what());
  }
  if (task == -1) {
    const double v[2] = {double(error), double(error)};
    return put(n, values, v, 2, false);
  }
  if (error) return;
  if (task >= 6 && task <= 8)
    return say(c, "task %d, lines of a variable profile, is not available; allowed: -1 to 5, of the slice nearest to 0",
               task);
  const std::vector<ProfilePoint> points = sample(profile, how, step);
  const WheelSolver* w = c.p.wheel && c.p.wheel->solved ? c.p.wheel.get() : nullptr;
  const double s = c.in().digits.left() ? -1 : 1;
  std::vector<double> v;
  if (task == 0) {
    v = {double(points.size())};
  } else if (task == 1 || task == 2) {
    if (task == 2 && !w) return say(c, "task 2 needs a solved wheel");
    for (const int coordinate : {1, 2})
      for (const ProfilePoint& p : points) {
        Vec3 at = {0, p.y, p.z};
        if (task == 2) at = (wheel ? w->wheel : w->rail).origin + (wheel ? w->wheel : w->rail).rotation * at;
        v.push_back(coordinate == 1 ? (task == 2 ? s : 1) * at[1] : at[2]);
      }
  } else if (task == 3) {
    if (!w) return say(c, "task 3 needs a solved wheel");
    double y = 1e300, z = 0;
    for (const ProfilePoint& p : points) {
      const Vec3 at = w->rail.origin + w->rail.rotation * Vec3{0, p.y, p.z};
      if (at[2] < 0 || at[2] > c.in().track.gaught || at[1] >= y) continue;
      y = at[1];
      z = at[2];
    }
    v = {s * y / length, z / length, s * w->rail.origin[1] / length, w->rail.origin[2] / length,
         s * y / length, z / length};
  } else if (task == 4 || task == 5) {
    for (const ProfilePoint& p : points) v.push_back(task == 4 ? p.s : p.slope);
  } else {
    return void(no_method(c, task));
  }
  put(n, values, v.data(), int(v.size()), false);
}

}  // namespace cntc
