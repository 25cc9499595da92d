// Settings of module 1.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "checks.hpp"
#include "text.hpp"

namespace cntc {

void set_vertical_force(Call& c, double fz) {
  c.in().fz = fz;
  c.in().digits.norm = 1;
}

namespace {

bool take_options(const Call& c, ProfileOptions& o, int nints, const int* ints, int nreals, const double* reals) {
  if (nints > 0 && !ints) {
    say(c, "an array is NULL");
    return false;
  }
  nreals = std::clamp(nreals, 0, int(o.reals.size()));
  if (!all_finite(c, nreals, reals)) return false;
  std::copy_n(ints, std::clamp(nints, 0, int(o.ints.size())), o.ints.begin());
  std::copy_n(reals, nreals, o.reals.begin());
  if (nreals > 6) o.reals[6] *= c.units().length;
  if (o.reals[0] <= 0) o.reals[0] = c.units().length;
  return true;
}

void keep(Call& c, ProfileInput p) {
  ProfileInput& place = p.wheel ? c.in().wheel : c.in().rail;
  p.given = true;
  p.number = place.number + 1;
  place = std::move(p);
}

}  // namespace

void keep_profile_file(Call& c, std::string path, bool wheel, ProfileOptions options) {
  ProfileInput p;
  p.wheel = wheel;
  p.path = std::move(path);
  p.options = options;
  keep(c, std::move(p));
}

void set_profile_file(Call& c, const char* fname, int length, int nints, const int* ints, int nreals,
                      const double* reals) {
  const std::string name = text_of(fname, length);
  if (name.empty()) return say(c, "the name of the file is missing");
  ProfileOptions options;
  options.ints[0] = -1;
  if (!take_options(c, options, nints, ints, nreals, reals)) return;
  const bool by_name = ends_with(name, ".prw") || ends_with(name, ".whl") || ends_with(name, ".slcw");
  keep_profile_file(c, in_folder(session().wrkdir, name), options.ints[0] == 1 || (options.ints[0] == -1 && by_name),
                    options);
}

void set_profile_values(Call& c, int npoint, const double* values, int nints, const int* ints, int nreals,
                        const double* reals) {
  if (npoint < 2 || npoint > 10000000) return say(c, "the profile has %d points; allowed: 2 to 10000000", npoint);
  if (!all_finite(c, 2 * npoint, values)) return;
  ProfileInput p;
  p.options.ints[0] = 1;
  if (!take_options(c, p.options, nints, ints, nreals, reals)) return;
  p.wheel = p.options.ints[0] == 1;
  p.points.assign(values, values + 2 * size_t(npoint));
  keep(c, std::move(p));
}

void set_track(Call& c, int kind, int n, const double* q) {
  const double length = c.units().length;
  Track t = c.in().track;
  if (kind == 0) {
    if (lacks(c, kind, n, 0, 1, q)) return;
    return;
  }
  if (kind != 1 && kind != 2 && kind != 3 && kind != 32 && kind != 33) return void(no_method(c, kind));
  if (kind == 1 && lacks(c, kind, n, 5, 6, q)) return;
  if (kind == 2 && lacks(c, kind, n, 6, q)) return;
  if (kind == 3 && lacks(c, kind, n, 11, 12, q)) return;
  if (kind >= 32 && lacks(c, kind, n, 4, 5, q)) return;
  if (kind == 1 || kind == 3) {
    t.gaught = q[0] * length;
    if (q[0] > 0) {
      t.gaugsq = q[1];
      t.gaugwd = q[2] * length;
    } else {
      t.raily0 = q[1] * length;
      t.railz0 = q[2] * length;
    }
    t.cant = q[3];
    t.nomrad = q[4] * length;
    t.curv = (kind == 1 ? n > 5 : n > 11) ? q[5] / length : 0;
  }
  if (kind == 2 || kind == 3) {
    const double* d = kind == 2 ? q : q + (n - 6);
    t.deviation = {d[0] * length, d[1] * length, d[2]};
    t.rate = {d[3] * length, d[4] * length, d[5]};
  }
  if (kind >= 32) {
    t.ky = q[0] / length;
    t.fy = q[1];
    t.kz = q[2] / length;
    t.fz = q[3];
    t.dystep = n > 4 ? q[4] * length : 1;
  }
  t.kind = kind;
  c.in().track = t;
}

void set_wheelset_dimensions(Call& c, int kind, int n, const double* q) {
  if (kind < 0 || kind > 5) return void(no_method(c, kind));
  if (kind != 3 && kind != 5) return;
  if (lacks(c, kind, n, 3, 4, q)) return;
  const double length = c.units().length;
  Wheelset& w = c.in().wheelset;
  w.fbdist = q[0] * length;
  w.fbpos = q[1] * length;
  w.nomrad = q[2] * length;
  w.ytape = n > 3 ? q[3] * length : 1000;
}

namespace {

void take_six(std::array<double, 6>& to, const double* q, double length) {
  for (size_t k = 0; k < 6; ++k) to[k] = q[k] * (k < 3 ? length : 1);
}

}  // namespace

void set_wheelset_position(Call& c, int kind, int n, const double* q) {
  if (kind < 1 || kind > 5) return void(no_method(c, kind));
  if (!lacks(c, kind, n, 6, q)) take_six(c.in().wheelset.position, q, c.units().length);
}

void set_wheelset_velocity(Call& c, int kind, int n, const double* q) {
  if (kind == 1 && n == 6) kind = 2;
  if (kind < 1 || kind > 5) return void(no_method(c, kind));
  if (kind == 1) return;
  if (lacks(c, kind, n, 6, q)) return;
  take_six(c.in().wheelset.velocity, q, c.units().length);
  if (c.in().digits.roller()) c.in().wheelset.velocity[0] = q[0];  // the rate of the roller
}

void set_wheelset_flexibility(Call& c, int kind, int n, const double* q) {
  if (kind < 0 || kind > 5) return void(no_method(c, kind));
  if (kind <= 3) {
    c.in().wheelset.flexibility = {};
    return;
  }
  if (lacks(c, kind, n, 12, q)) return;
  for (size_t k = 0; k < 12; ++k) c.in().wheelset.flexibility[k] = q[k] * (k % 6 < 3 ? c.units().length : 1);
}

}  // namespace cntc
