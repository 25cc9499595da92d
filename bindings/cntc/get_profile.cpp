// Points of profiles: cntc_getprofilevalues.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "checks.hpp"
#include "sections.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

constexpr int intervals = 400;       // for sampling as the profile does
constexpr double least_step = 1e-4;  // mm
constexpr double most_points = 1e6;

/// Holds the parameters of the call, or their standards.
struct Sampling {
  int how = 0;  // 0: of the profile itself; 1: uniform; more: parts of each interval
  double step = 1, place = 0, first = 0, last = 0;

  int points(double range) const {
    const int n = how >= 2 ? how * intervals : intervals;
    return how == 1 ? int(std::clamp(range / step, 0., most_points)) + 1 : n + 1;
  }
  double at(int k, double range) const { return how == 1 ? k * step : range * k / (points(range) - 1); }
};

/// Holds the gauge point, the one at the gauge's height nearest to the track's middle, in the rail's axes turned by the
/// cant.
struct Gauge {
  double y = 1e300, z = 0, top = 1e300, y_below = 0;
};

Gauge find_gauge(const Section& section, double cant, double height) {
  Gauge g;
  const int n = 10 * intervals;
  const auto turned = [&](const Vec3& place) { return about_x(-cant) * place; };
  g.top = turned(section.at(section.least(n, [&](const Vec3& p) { return turned(p)[2]; })).place)[2];
  const double s = section.least(n, [&](const Vec3& p) { return turned(p)[2] > g.top + height ? 1e9 : turned(p)[1]; });
  const Vec3 at = turned(section.at(s).place);
  g.y = at[1];
  g.z = at[2];
  // Beyond this point the rail may go on below the height of the gauge.
  g.y_below = g.y;
  if (s > 0) {
    const Vec3 next = turned(section.at(s - section.length() / n).place);
    const double t = (g.top + height - at[2]) / (next[2] - at[2]);
    if (t > 0 && t < 1) g.y_below = at[1] + t * (next[1] - at[1]);
  }
  return g;
}

/// Returns x, y and z of a line of a surface that varies: a section at a place (6), a line along it (7), a slice at a y
/// (8).
std::vector<double> surface_line(Sections& sections, int task, const Sampling& s) {
  std::vector<double> x, y, z;
  const int n = s.points(s.last - s.first);
  const double lines = sections.lines();
  for (int k = 0; k < n; ++k) {
    const double q = s.first + k * s.step, u = task == 6 ? s.place : q, v = task == 6 ? q : s.place;
    x.push_back(u);
    if (task == 8) {
      const Section section = sections.at(u);
      y.push_back(v);
      z.push_back(section.z_at(v, no_point));
      continue;
    }
    const double share = (v - 1) / (lines - 1);
    const bool there = share > -1e-9 && share < 1 + 1e-9;
    const Vec3 at = there ? sections.point(u, std::clamp(share, 0., 1.)) : Vec3{0, no_point, no_point};
    y.push_back(at[1]);
    z.push_back(at[2]);
  }
  x.insert(x.end(), y.begin(), y.end());
  x.insert(x.end(), z.begin(), z.end());
  return x;
}

}  // namespace

void get_profile_values(Call& c, int task, int nints, const int* ints, int nreals, const double* reals, int n,
                        double* values) {
  if ((n > 0 && !values) || (nints > 0 && !ints)) return say(c, "an array is NULL");
  if (!all_finite(c, nreals, reals)) return;
  if (task < -1 || task > 8) return void(no_method(c, task));
  const bool wheel = nints > 0 && ints[0] == 1;
  const ProfileInput& input = wheel ? c.in().wheel : c.in().rail;
  Sampling s;
  s.how = nints > 1 ? std::clamp(ints[1], 0, 100) : 0;
  if (nreals > 0) s.step = reals[0];
  if (nreals > 1) s.place = reals[1];
  if (task >= 6) s.how = 1;
  if (s.how == 1 && s.step < least_step) {
    if (task >= 6) return say(c, "the step is %g; allowed: at least %g", s.step, least_step);
    s.how = 0;
  }
  Profile profile;
  ContextHandle context;
  try {
    create(context, rollcon_context_create, ROLLCON_ABI);
    profile.make(context.get(), input, c.in().material);
  } catch (const Failure& failure) {
    const double v[2] = {double(failure.code), input.given ? double(failure.code) : 1};
    if (task == -1) return put(n, values, v, 2, false);
    return say(c, "%s", failure.what());
  }
  std::vector<double> v;
  const WheelSolver* w = c.p.wheel && c.p.wheel->solved ? c.p.wheel.get() : nullptr;
  const double side = c.in().digits.left() ? -1 : 1;
  if (task == -1) {
    v = {0, 0};
  } else if (task >= 6) {
    if (!profile.varies()) return say(c, "task %d needs a profile that varies (slcs, slcw)", task);
    Sections sections(context.get(), profile, wheel);
    const auto range = slice_range(input.path);
    s.first = nreals > 2 ? reals[2] : task == 6 ? 1 : range[0];
    s.last = nreals > 3 ? reals[3] : task == 6 ? sections.lines() : range[1];
    const int points = s.points(s.last - s.first);
    if (n == 1) {
      v = {double(points)};
    } else if (n < 3 * points) {
      return say(c, "the array has %d values; needed: %d", n, 3 * points);
    } else {
      v = surface_line(sections, task, s);
    }
  } else {
    if (task == 2 && !w) return say(c, "task 2 needs a solved wheel");
    const bool here = task == 2 && !wheel;
    const Section section =
        profile.varies()
            ? Sections(context.get(), profile, wheel).at(s.place + (here ? c.in().wheelset.position[0] : 0))
            : Section(profile);
    const int points = s.points(section.length());
    const Track& t = c.in().track;
    const double length = c.units().length;
    if (task == 3 && wheel) {
      v = {CNTC_err_profil};
    } else if (task == 3) {
      if (!(t.gaught > 0)) return say(c, "task 3 needs a rail placed by its gauge (GAUGHT above 0)");
      const Gauge g = find_gauge(section, t.cant, t.gaught);
      v = {g.y, g.z, side * (t.gaugwd / 2 - g.y) + t.deviation[0], t.deviation[1] - g.top, g.y_below, t.gaught + g.top};
      for (double& q : v) q /= length;
    } else if (task == 0) {
      v = {double(points)};
    }
    for (int column = 0; column < (task == 1 || task == 2 ? 2 : task >= 4 ? 1 : 0); ++column)
      for (int k = 0; k < points && int(v.size()) < n; ++k) {
        const double at = s.at(k, section.length());
        const SectionPoint p = section.at(at);
        Vec3 place = p.place;
        if (task == 2) place = (wheel ? w->wheel : w->rail).origin + (wheel ? w->wheel : w->rail).rotation * place;
        const double y = (task == 2 ? side : 1) * place[1];
        v.push_back(task == 4 ? at - section.middle() : task == 5 ? p.slope : column == 0 ? y : place[2]);
      }
  }
  put(n, values, v.data(), int(v.size()), false);
}

}  // namespace cntc
