// Settings of both modules.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "checks.hpp"

namespace cntc {

void set_metadata(Call& c, int n, const int* params, const double* values) {
  if (n > 0 && (!params || !values)) return say(c, "an argument is NULL");
  static const int codes[] = {CNTC_mt_tim, CNTC_mt_xr,  CNTC_mt_yr,   CNTC_mt_xw,  CNTC_mt_yw,
                              CNTC_mt_sw,  CNTC_mt_run, CNTC_mt_axle, CNTC_mt_side};
  for (int k = 0; k < std::min(n, 1000); ++k) {
    if (params[k] == 0) continue;
    const auto found = std::find(std::begin(codes), std::end(codes), params[k]);
    if (found == std::end(codes)) {
      say(c, "unknown parameter code=%d is ignored", params[k]);
    } else if (std::isfinite(values[k])) {
      const auto at = size_t(found - codes);
      c.in().metadata[at] = values[k] * (at >= 1 && at <= 5 ? c.units().length : 1);
    }
  }
}

void set_solver_flags(Call& c, int g, int nints, const int* ints, int nreals, const double* reals) {
  static const int n_ints[] = {4, 0, 5, 5, 5, 5, 1}, n_reals[] = {1, 0, 4, 4, 2, 8, 1};
  if (g < 0 || g > 6) return void(no_method(c, g));
  if (nints < n_ints[g]) return say(c, "method %d needs %d integers, not %d", g, n_ints[g], nints);
  if (n_ints[g] > 0 && !ints) return say(c, "an array is NULL");
  if (nreals < n_reals[g]) return say(c, "method %d needs %d reals, not %d", g, n_reals[g], nreals);
  if (!all_finite(c, n_reals[g], reals)) return;
  if (g == 1 || g == 6) return;  // settings stay; sensitivities are exact
  SolverSettings& s = c.in().solver;
  c.in().digits.gausei = g;
  s.maxgs = ints[0];
  s.maxin = ints[1];
  s.maxnr = ints[2];
  s.maxout = ints[3];
  if (n_ints[g] > 4) s.extra = ints[4];
  std::copy_n(reals, n_reals[g], s.reals.begin());
}

void set_material(Call& c, int method, int n, const double* params) {
  Inputs& in = c.in();
  if ((method == 0 || method == 1) && n <= 1) method += 10;
  if (method == 10 || method == 11) {
    if (method == 10) in.digits.damping = 0;
    return;
  }
  if (method == 12) {
    if (lacks(c, method, n, 4, params)) return;
    in.digits.damping = 2;
    in.material.cdampn = params[0];
    in.material.cdampt = params[1];
    in.material.dfnmax = params[2];
    in.material.dftmax = params[3];
    return;
  }
  if (method < 0 || method > 7) return void(no_method(c, method));
  if (lacks(c, method, n, material_parameters[method], params)) return;
  for (int k = 0; k < 2; ++k)
    if (!(params[k] > -1 && params[k] <= .5) || !(params[2 + k] > 0))
      return say(c, "body %d has Poisson's ratio %g and shear modulus %g; allowed: -1 to 0.5, above 0", k + 1,
                 params[k], params[2 + k]);
  const double area = c.units().area(), length = c.units().length;
  in.digits.mater = method;
  in.material.nu = {params[0], params[1]};
  in.material.g = {params[2] / area, params[3] / area};
  in.material.more = {};
  for (int k = 4; k < n; ++k) in.material.more[size_t(k - 4)] = params[k];
  auto& more = in.material.more;
  if (method == 2) more[0] *= length * area;
  if (method == 4) more = {more[0] / area, more[1] * length, more[2] / area, more[3] / (area * length)};
  const bool like = params[0] == params[1] && params[2] == params[3];
  if (in.solver.maxout == 1 || like) in.solver.maxout = like ? 1 : 10;
}

void set_temperature_data(Call& c, int method, int n, const double* params) {
  Inputs& in = c.in();
  if (method == 1) return;
  if (method == 0) {
    in.digits.heat = 0;
    return;
  }
  if (method != 3) return void(no_method(c, method));
  const bool layer = in.digits.mater == 4;
  if (lacks(c, method, n, 8, layer ? 9 : 8, params)) return;
  const double length = c.units().length;
  for (size_t k = 0; k < 2; ++k) {
    const double* q = params + 4 * k;
    in.heat[k] = {q[0], q[1], q[2] / length, q[3] / (length * length * length)};
  }
  in.betapl = n > 8 ? params[8] : 0;
  in.digits.heat = 3;
}

void set_time_step(Call& c, double dt) {
  if (!(dt > 0)) return say(c, "the time step is %g; allowed: above 0", dt);
  c.in().dt = dt;
}

void set_rolling_step(Call& c, double chi, double dq) {
  if (!(dq > 0)) return say(c, "the step DQ is %g; allowed: above 0", dq);
  if (c.p.module == 3) c.in().chi = chi;
  c.in().dq = c.p.module == 3 ? dq * c.units().length : dq;
}

namespace {

/// Turns the parameters of one place to mm; memory is kept apart.
void take_row(Friction& f, int law, const double* q, double length, double place) {
  FrictionRow row;
  row.place = place;
  if (law == 0) {
    row.p = {q[0], q[1]};
  } else if (law <= 4) {
    row.p = {q[0], q[1], q[2] * length, q[3], q[4] * length};
    f.memdst = q[5] * length;
    f.mem_s0 = q[6] * length;
  } else if (law == 5) {
    const double rest = q[0], share = q[1], rate = q[2] / length;
    row.p = {share * rest, (1 - share) * rest, rate > 0 ? std::log(2.) / rate : 0};
    f.memdst = .001;
    f.mem_s0 = 10;
  } else {
    row.p = {q[0], q[1], q[2], q[3]};
    f.memdst = q[4] * length;
    f.mem_s0 = q[5] * length;
  }
  f.rows.push_back(row);
}

}  // namespace

void set_friction(Call& c, int method, int n, const double* params) {
  const int v = method / 10, law = method % 10;
  if (method < 0 || v > 2 || law > 6 || (v && c.p.module == 3)) return void(no_method(c, method));
  if (law == 1) return;
  const int needed = friction_parameters[law] + (law >= 2 && law != 5 ? 2 : 0);
  Friction f;
  f.rows.clear();
  f.variation = v;
  f.law = law == 5 ? 4 : law;
  const double length = c.units().length;
  if (v == 0) {
    if (lacks(c, method, n, needed, params)) return;
    take_row(f, law, params, length, 0);
  } else {
    const int rows = n > 0 && params ? whole(params[0]) : 0;
    if (rows < 1 || rows > 10000) return say(c, "the number of places is %d; allowed: 1 to 10000", rows);
    if (lacks(c, method, n, 1 + rows * (1 + needed), params)) return;
    for (int k = 0; k < rows; ++k) {
      const double* q = params + 1 + k * (1 + needed);
      if (k > 0 && q[0] * (v == 2 ? length : 1) <= f.rows.back().place)
        return say(c, "places must increase: number %d does not", k + 1);
      take_row(f, law, q + 1, length, q[0] * (v == 2 ? length : 1));
    }
  }
  c.in().friction = f;
  c.in().digits.frclaw = f.law;
}

void set_potential_contact(Call& c, int ipotcn, int n, const double* params) {
  const double length = c.units().length;
  if (c.p.module == 1) {
    if (ipotcn != 0 && ipotcn != -1) return void(no_method(c, ipotcn));
    if (lacks(c, ipotcn, n, ipotcn ? 5 : 2, ipotcn ? 7 : 3, params)) return;
    if (!(params[0] > 0) || !(params[1] > 0))
      return say(c, "steps are %g and %g; allowed: above 0", params[0], params[1]);
    PlaneGrid& g = c.in().plane;
    g = PlaneGrid{};
    g.ipotcn = ipotcn;
    g.dx = params[0] * length;
    g.ds = params[1] * length;
    if (ipotcn == 0) return;
    g.a_sep = params[2];
    g.d_sep = params[3] * length;
    g.d_comb = params[4] * length;
    g.d_turn = n > 5 ? params[5] * length : 2 * g.d_sep - g.d_comb;
    if (n > 6) g.g_miss = params[6] * length;
    return;
  }
  if (ipotcn < 1 || ipotcn > 4) return void(no_method(c, ipotcn));
  if (lacks(c, ipotcn, n, 6, params)) return;
  Grid g;
  g.mx = whole(params[0]);
  g.my = whole(params[1]);
  if (g.mx < 1 || g.my < 1 || g.size() > 1000000)
    return say(c, "the grid has %d x %d elements; allowed: 1 to 1000000 in all", g.mx, g.my);
  const double a = params[2] * length, b = params[3] * length, p = params[4] * length, q = params[5] * length;
  g.dx = ipotcn == 2 ? (p - a) / g.mx : ipotcn == 4 && g.mx > 1 ? (p - a) / (g.mx - 1) : p;
  g.dy = ipotcn == 2 ? (q - b) / g.my : ipotcn == 4 && g.my > 1 ? (q - b) / (g.my - 1) : q;
  if (ipotcn == 4 && g.mx == 1) g.dx = g.dy;
  if (ipotcn == 4 && g.my == 1) g.dy = g.dx;
  g.xc = ipotcn <= 2 ? a + g.dx / 2 : a;
  g.yc = ipotcn <= 2 ? b + g.dy / 2 : b;
  if (!(g.dx > 0) || !(g.dy > 0)) return say(c, "elements are %g by %g; allowed: above 0", g.dx, g.dy);
  c.in().grid = g;
  c.in().hertz.ipotcn = 0;
}

void set_tangential_forces(Call& c, double fx, double fy) {
  const double size = std::hypot(fx, fy);
  if (c.p.module == 3 && size > 1) {
    fx /= size;
    fy /= size;
  }
  c.in().fx = fx;
  c.in().fy = fy;
}

}  // namespace cntc
