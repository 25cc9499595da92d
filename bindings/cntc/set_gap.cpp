// Settings of module 3.
#include <cmath>

#include "bodies.hpp"
#include "checks.hpp"

namespace cntc {

void set_reference_velocity(Call& c, double veloc) {
  c.in().veloc = std::abs(veloc) * c.units().length;
}

void set_hertz_contact(Call& c, int ipotcn, int n, const double* params) {
  if (ipotcn < -6 || ipotcn > -1) return void(no_method(c, ipotcn));
  if (lacks(c, ipotcn, n, ipotcn == -6 ? 6 : 5, params)) return;
  const double length = c.units().length;
  HertzInput h;
  h.ipotcn = ipotcn;
  h.mx = whole(params[0]);
  h.my = whole(params[1]);
  h.first = params[2];
  h.second = params[3];
  h.third = ipotcn == -6 ? params[4] * length : 0;
  h.scale = params[n - 1];
  if (h.mx < 1 || h.my < 1 || long(h.mx) * h.my > 1000000)
    return say(c, "the grid has %d x %d elements; allowed: 1 to 1000000 in all", h.mx, h.my);
  if (!(h.first > 0) || !(h.second > 0) || !(h.scale > 0) || (ipotcn == -6 && !(h.third > 0)))
    return say(c, "curvatures, axes, their ratio and scale must be above 0");
  const bool curvature = ipotcn == -1 || ipotcn == -2 || ipotcn == -4;
  h.first *= curvature ? 1 / length : length;
  if (ipotcn == -1) h.second /= length;
  if (ipotcn <= -3) h.second *= length;
  c.in().hertz = h;
  if (ipotcn == -4 || ipotcn == -5) c.in().digits.bound = 2;
}

void set_penetration(Call& c, double pen) {
  c.in().pen = pen * c.units().length;
  c.in().digits.norm = 0;
}

void set_normal_force(Call& c, double fn) {
  c.in().fn = fn;
  c.in().digits.norm = 1;
}

void set_undeformed_distance(Call& c, int ibase, int n, const double* params) {
  const double length = c.units().length;
  std::vector<double> v;
  if (ibase == 1) {
    if (lacks(c, ibase, n, 6, params)) return;
    v = {params[0] / length, params[1] / length, params[2] / length, params[3], params[4], params[5] * length};
  } else if (ibase == 2) {
    const int heights = n > 0 && params ? whole(params[0]) : 0;
    if (heights < 2 || heights > 1000000) return say(c, "the profile has %d points; allowed: 2 to 1000000", heights);
    if (lacks(c, ibase, n, 5 + heights, params)) return;
    v.assign(params, params + n);
    for (size_t k = 1; k < v.size(); ++k) v[k] *= length;
    if (v[2] == 0 || !(v[4] > 0)) return say(c, "the radius is 0, or the step is not above 0");
  } else if (ibase == 3) {
    if (lacks(c, ibase, n, 8, params)) return;
    v.assign(params, params + 8);
    for (const size_t k : {0u, 2u, 3u, 5u, 6u, 7u}) v[k] *= length;
    v[1] /= length;
    v[4] /= length;
  } else if (ibase == 9) {
    const long size = c.in().hertz.ipotcn ? long(c.in().hertz.mx) * c.in().hertz.my : c.in().grid.size();
    if (size < 1) return say(c, "cntc_setpotcontact comes before method 9");
    if (lacks(c, ibase, n, int(size), params)) return;
    v.assign(params, params + n);
    for (double& h : v) h *= length;
  } else {
    return void(no_method(c, ibase));
  }
  c.in().ibase = ibase;
  c.in().iplan = 1;
  c.in().gap = std::move(v);
}

void set_creepages(Call& c, double vx, double vy, double phi) {
  const double length = c.units().length;
  const bool shift = c.in().digits.tang == 1;
  c.in().cksi = shift ? vx * length : vx;
  c.in().ceta = shift ? vy * length : vy;
  c.in().cphi = shift ? phi : phi / length;
}

void set_extra_slip(Call& c, int n, const double* wx, const double* wy) {
  if (n < 0 || n > 1000000) return say(c, "the number of elements is %d; allowed: 0 to 1000000", n);
  if (!all_finite(c, n, wx) || !all_finite(c, n, wy)) return;
  const double length = c.in().digits.tang == 1 ? c.units().length : 1;
  c.in().wx.assign(wx, wx + n);
  c.in().wy.assign(wy, wy + n);
  for (double& w : c.in().wx) w *= length;
  for (double& w : c.in().wy) w *= length;
  c.in().digits.exrhs = 1;
}

void get_hertz_contact(Call& c, int n, double* values) {
  if (n > 0 && !values) return say(c, "an array is NULL");
  const HertzContact& h = c.p.hertz;
  const double length = c.units().length;
  const double sum = h.a1 + h.b1;
  const double all[10] = {h.a1 * length,
                          h.b1 * length,
                          h.aa / length,
                          h.bb / length,
                          sum > 0 ? 2 / sum / length : 0,
                          std::sqrt(h.aa * h.bb) / length,
                          h.scale,
                          h.bneg / length,
                          h.bpos / length,
                          h.bb > 0 ? h.aa / h.bb : 0};
  put(n, values, all, 10, false);
}

}  // namespace cntc
