// Results of both modules.
#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "calculate.hpp"
#include "checks.hpp"
#include "handles.hpp"

namespace cntc {
namespace {

/// The grid of a patch: that of its solution, or before one what was given.
Grid grid_of(Call& c, const ContactResult& r) {
  if (r.solved || c.p.module == 1) return r.grid;
  if (!c.in().hertz.ipotcn) return c.in().grid;
  Grid g = r.grid;
  try {
    std::vector<double> gap;
    fill_gap(c.p, g, gap);
  } catch (const Failure&) {
    g.mx = c.in().hertz.mx;
    g.my = c.in().hertz.my;
  }
  return g;
}

/// Fills an array with a field times a factor; slots beyond stay as they are.
void put_field(Call& c, int n, double* to, const std::vector<double>& from, double factor) {
  if (!to) return;
  if (from.empty()) return say(c, "this field was not computed");
  for (size_t k = 0; k < std::min(size_t(std::max(n, 0)), from.size()); ++k) to[k] = factor * from[k];
}

}  // namespace

void get_grid_steps(Call& c, double& dx, double& dy) {
  const double length = c.units().length;
  if (c.icp < 0) {
    dx = c.in().plane.dx / length;
    dy = c.in().plane.ds / length;
  } else if (const ContactResult* r = c.elements()) {
    const Grid g = grid_of(c, *r);
    dx = g.dx / length;
    dy = g.dy / length;
  }
}

void get_parameters(Call& c, int task, int n, double* values) {
  const ContactResult* r = c.result();
  if (!r || (n > 0 && !values)) return;
  const Inputs& in = c.in();
  const double length = c.units().length, stress = c.units().stress(), area = c.units().area();
  const Material& m = in.material;
  const auto& more = m.more;
  const bool layer = in.digits.mater == 4;
  if (task == 1) {
    const double v[6] = {(r->solved ? r->veloc : in.veloc) / length,
                         in.chi,
                         r->solved ? r->dq / length : in.dq / (c.p.module == 3 ? length : 1),
                         in.spinxo / length,
                         in.spinyo / length,
                         layer ? more[2] / stress : 0};
    return put(n, values, v, 6, true);
  }
  if (task == 2) {
    const double g = 2 / (1 / m.g[0] + 1 / m.g[1]), nu = g * (m.nu[0] / m.g[0] + m.nu[1] / m.g[1]) / 2;
    const double k = g * ((1 - 2 * m.nu[0]) / m.g[0] - (1 - 2 * m.nu[1]) / m.g[1]) / 4;
    const int M = in.digits.mater;
    double v[22] = {};
    for (size_t i = 0; i < 2; ++i) {
      v[i] = m.g[i] / stress;
      v[3 + i] = m.nu[i];
    }
    v[2] = g / stress;
    v[5] = nu;
    v[6] = k;
    std::fill_n(v + 7, 3, (M == 2 ? more[0] : layer ? more[1] / more[0] : 0) / (length * area));
    if (M == 2 || M == 3 || M == 5) std::copy_n(&more[M == 2 ? 1 : 0], 3, v + 10);
    const double layers[4] = {more[0] / stress, more[1] / length, more[2] / stress, more[3] / stress * length};
    if (layer) std::copy_n(layers, 4, v + 14);
    const double damping[4] = {m.cdampn, m.cdampt, m.dfnmax, m.dftmax};
    std::copy_n(damping, 4, v + 18);
    return put(n, values, v, 22, true);
  }
  if (task != 3) return void(no_method(c, task));
  std::vector<double> v{double(in.friction.law), double(in.friction.rows.size()), in.friction.memdst,
                        in.friction.mem_s0};
  for (const FrictionRow& row : in.friction.rows) {
    const int law = in.friction.law;
    const double first = law == 0 || law == 6 ? row.p[0] : row.p[0] + row.p[1] + row.p[3],
                 last = law == 0   ? row.p[1]
                        : law == 6 ? row.p[0] + row.p[2]
                                   : row.p[0];
    v.insert(v.end(), {row.place / (in.friction.variation == 2 ? length : 1), first, last});
  }
  put(n, values, v.data(), int(v.size()), true);
}

void get_reference_velocity(Call& c, double& veloc) {
  if (const ContactResult* r = c.result())
    veloc = (r->solved || c.p.module == 1 ? r->veloc : c.in().veloc) / c.units().length;
}

void get_element_numbers(Call& c, int& mx, int& my) {
  if (const ContactResult* r = c.elements()) {
    const Grid g = grid_of(c, *r);
    mx = g.mx;
    my = g.my;
  }
}

void get_potential_contact(Call& c, int n, double* values) {
  const ContactResult* r = c.elements();
  if (!r) return;
  const Grid g = grid_of(c, *r);
  const double length = c.units().length;
  const double v[6] = {double(g.mx), double(g.my), g.xc / length, g.yc / length, g.dx / length, g.dy / length};
  put(n, values, v, 6, true);
}

void get_penetration(Call& c, double& pen) {
  if (const ContactResult* r = c.result()) pen = (r->solved ? r->pen : c.in().pen) / c.units().length;
}

void get_creepages(Call& c, double& vx, double& vy, double& phi) {
  const ContactResult* r = c.result();
  if (!r) return;
  const double length = c.units().length, sign = c.units().sign;
  const bool shift = c.in().digits.tang == 1;
  vx = sign * (r->solved ? r->cksi : c.in().cksi) / (shift ? length : 1);
  vy = sign * (r->solved ? r->ceta : c.in().ceta) / (shift ? length : 1);
  phi = sign * (r->solved ? r->cphi : c.in().cphi) * (shift ? 1 : length);
}

void get_contact_forces(Call& c, double& fn, double& tx, double& ty, double& mz) {
  const ContactResult* r = c.result();
  if (!r) return;
  const double sign = c.units().sign;
  fn = r->fn;
  tx = sign * r->tx;
  ty = sign * r->ty;
  mz = sign * r->mz / c.units().length;
}

void get_areas(Call& c, double& contact, double& stick, double& slip) {
  const ContactResult* r = c.elements();
  if (!r) return;
  const double cell = r->grid.dx * r->grid.dy / c.units().area();
  stick = cell * double(r->count(1));
  slip = cell * double(r->count(2));
  contact = stick + slip + cell * double(r->count(3));
}

void get_element_division(Call& c, int n, int* division) {
  const ContactResult* r = c.elements();
  if (!r || !division) return;
  for (size_t k = 0; k < std::min(size_t(std::max(n, 0)), r->division.size()); ++k) division[k] = r->division[k];
}

namespace {

double largest(const std::vector<double>& v) {
  double most = 0;
  for (const double x : v) most = std::max(most, x);
  return most;
}

}  // namespace

void get_max_pressure(Call& c, double& value) {
  if (const ContactResult* r = c.result()) value = (r->pmax > 0 ? r->pmax : largest(r->pn)) / c.units().stress();
}

void get_max_traction(Call& c, double& value) {
  const ContactResult* r = c.elements();
  if (!r) return;
  value = 0;
  for (size_t k = 0; k < r->px.size(); ++k) value = std::max(value, std::hypot(r->px[k], r->py[k]));
  value /= c.units().stress();
}

void get_max_temperature(Call& c, double& t1, double& t2) {
  const ContactResult* r = c.elements();
  if (!r) return;
  t1 = largest(r->temp1);
  t2 = largest(r->temp2);
}

void get_field(Call& c, int field, int n, double* values) {
  const ContactResult* r = c.elements();
  if (!r) return;
  if (n > 0 && !values) return say(c, "an array is NULL");
  const double length = 1 / c.units().length, stress = 1 / c.units().stress(), sign = c.units().sign;
  struct Row {
    int code;
    const std::vector<double>& field;
    double factor;
  };
  const Row rows[] = {
      {CNTC_fld_h, r->h, length},          {CNTC_fld_mu, r->mu, 1},       {CNTC_fld_px, r->px, sign * stress},
      {CNTC_fld_py, r->py, sign * stress}, {CNTC_fld_pn, r->pn, stress},  {CNTC_fld_ux, r->ux, length},
      {CNTC_fld_uy, r->uy, length},        {CNTC_fld_un, r->un, length},  {CNTC_fld_sx, r->sx, sign},
      {CNTC_fld_sy, r->sy, sign},          {CNTC_fld_temp1, r->temp1, 1}, {CNTC_fld_temp2, r->temp2, 1},
      {CNTC_fld_wx, r->wx, sign},          {CNTC_fld_wy, r->wy, sign}};
  for (const Row& row : rows)
    if (row.code == field) return put_field(c, n, values, row.field, row.factor);
  if (field == CNTC_fld_taucrt || field == CNTC_fld_uplsx || field == CNTC_fld_uplsy)
    return say(c,
               "field %d (%s) is not available: the flow of layers is not known by elements; allowed: 1 to 5, 7 to 9, "
               "15, 16, 20 to 23",
               field, field == CNTC_fld_taucrt ? "TAUCRT" : "UPLS");
  say(c, "there is no field %d", field);
}

void get_tractions(Call& c, int n, double* pn, double* px, double* py) {
  const ContactResult* r = c.elements();
  if (!r) return;
  const double stress = 1 / c.units().stress(), sign = c.units().sign;
  put_field(c, n, pn, r->pn, stress);
  put_field(c, n, px, r->px, sign * stress);
  put_field(c, n, py, r->py, sign * stress);
}

void get_slip(Call& c, int n, double* sx, double* sy) {
  const ContactResult* r = c.elements();
  if (!r) return;
  put_field(c, n, sx, r->sx, c.units().sign);
  put_field(c, n, sy, r->sy, c.units().sign);
}

void get_displacements(Call& c, int n, double* un, double* ux, double* uy) {
  const ContactResult* r = c.elements();
  if (!r) return;
  const double length = 1 / c.units().length;
  put_field(c, n, un, r->un, length);
  put_field(c, n, ux, r->ux, length);
  put_field(c, n, uy, r->uy, length);
}

void get_sensitivities(Call& c, int rows, int columns, double* values) {
  const ContactResult* r = c.result();
  if (!r || !values) return;
  const double length = c.units().length;
  for (int j = 0; j < std::min(columns, 4); ++j)
    for (int i = 0; i < std::min(rows, 4); ++i) {
      double v = r->sensitivities[size_t(i + 4 * j)];
      if (i == 3) v /= length;
      if (j == 0) v *= length;
      if (j == 3) v /= length;
      values[size_t(i) + size_t(rows) * size_t(j)] = v;
    }
}

void get_calculation_time(Call& c, double& cpu, double& wall) {
  cpu = c.p.cpu;
  wall = c.p.wall;
}

void reset_calculation_time(Call& c) {
  c.p.cpu = c.p.wall = 0;
}

}  // namespace cntc
