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

using R = ContactResult;
/// Describes a field: where it is kept, powers of the length and the stress of the caller's units that it is divided
/// by, and whether it is one of a body, with a sign.
struct Field {
  int code;
  std::vector<double> R::*values;
  int lengths, stresses;
  bool signs;
};
const Field fields[] = {
    {CNTC_fld_h, &R::h, 1, 0, false},   {CNTC_fld_mu, &R::mu, 0, 0, false},       {CNTC_fld_px, &R::px, 0, 1, true},
    {CNTC_fld_py, &R::py, 0, 1, true},  {CNTC_fld_pn, &R::pn, 0, 1, false},       {CNTC_fld_ux, &R::ux, 1, 0, false},
    {CNTC_fld_uy, &R::uy, 1, 0, false}, {CNTC_fld_un, &R::un, 1, 0, false},       {CNTC_fld_sx, &R::sx, 0, 0, true},
    {CNTC_fld_sy, &R::sy, 0, 0, true},  {CNTC_fld_temp1, &R::temp1, 0, 0, false}, {CNTC_fld_wx, &R::wx, 0, 0, true},
    {CNTC_fld_wy, &R::wy, 0, 0, true},  {CNTC_fld_temp2, &R::temp2, 0, 0, false}};

/// Fills an array with a field; slots beyond stay as they are. Returns false if there is no such field.
bool put_field(Call& c, const R& r, int code, int n, double* to) {
  const auto f = std::find_if(std::begin(fields), std::end(fields), [&](const Field& f) { return f.code == code; });
  if (f == std::end(fields)) return false;
  const auto& from = r.*f->values;
  const Units& u = c.units();
  const double factor = (f->signs ? u.sign : 1) / (f->lengths ? u.length : 1) / (f->stresses ? u.stress() : 1);
  if (to && from.empty()) say(c, "this field was not computed");
  for (size_t k = 0; to && k < std::min(size_t(std::max(n, 0)), from.size()); ++k) to[k] = factor * from[k];
  return true;
}

double largest(const std::vector<double>& v) {
  return v.empty() ? 0 : *std::max_element(v.begin(), v.end());
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

void get_parameters(Call& c, const Totals& r, int task, int n, double* values) {
  if (n > 0 && !values) return;
  const Inputs& in = c.in();
  const double length = c.units().length, stress = c.units().stress(), area = c.units().area();
  const Material& m = in.material;
  const auto& more = m.more;
  const bool layer = in.digits.mater == 4;
  if (task == 1) {
    const double v[6] = {(r.solved ? r.veloc : in.veloc) / length,
                         in.chi,
                         r.solved ? r.dq / length : in.dq / (c.p.module == 3 ? length : 1),
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

void get_reference_velocity(Call& c, const Totals& r, double& veloc) {
  veloc = (r.solved || c.p.module == 1 ? r.veloc : c.in().veloc) / c.units().length;
}

void get_element_numbers(Call& c, const ContactResult& r, int& mx, int& my) {
  const Grid g = grid_of(c, r);
  mx = g.mx;
  my = g.my;
}

void get_potential_contact(Call& c, const ContactResult& r, int n, double* values) {
  const Grid g = grid_of(c, r);
  const double length = c.units().length;
  const double v[6] = {double(g.mx), double(g.my), g.xc / length, g.yc / length, g.dx / length, g.dy / length};
  put(n, values, v, 6, true);
}

void get_penetration(Call& c, const Totals& r, double& pen) {
  pen = (r.solved ? r.pen : c.in().pen) / c.units().length;
}

void get_creepages(Call& c, const Totals& r, double& vx, double& vy, double& phi) {
  const double length = c.units().length, sign = c.units().sign;
  const bool shift = c.in().digits.tang == 1;
  vx = sign * (r.solved ? r.cksi : c.in().cksi) / (shift ? length : 1);
  vy = sign * (r.solved ? r.ceta : c.in().ceta) / (shift ? length : 1);
  phi = sign * (r.solved ? r.cphi : c.in().cphi) * (shift ? 1 : length);
}

void get_contact_forces(Call& c, const Totals& r, double& fn, double& tx, double& ty, double& mz) {
  const double sign = c.units().sign;
  fn = r.fn;
  tx = sign * r.tx;
  ty = sign * r.ty;
  mz = sign * r.mz / c.units().length;
}

void get_areas(Call& c, const ContactResult& r, double& contact, double& stick, double& slip) {
  const double cell = r.grid.dx * r.grid.dy / c.units().area();
  stick = cell * double(r.count(1));
  slip = cell * double(r.count(2));
  contact = stick + slip + cell * double(r.count(3));
}

void get_element_division(Call&, const ContactResult& r, int n, int* division) {
  if (!division) return;
  for (size_t k = 0; k < std::min(size_t(std::max(n, 0)), r.division.size()); ++k) division[k] = r.division[k];
}

void get_max_pressure(Call& c, const Totals& r, double& value) {
  value = r.pmax / c.units().stress();
}

void get_max_traction(Call& c, const ContactResult& r, double& value) {
  value = 0;
  for (size_t k = 0; k < r.px.size(); ++k) value = std::max(value, std::hypot(r.px[k], r.py[k]));
  value /= c.units().stress();
}

void get_max_temperature(Call&, const ContactResult& r, double& t1, double& t2) {
  t1 = largest(r.temp1);
  t2 = largest(r.temp2);
}

void get_field(Call& c, const ContactResult& r, int field, int n, double* values) {
  if (n > 0 && !values) return say(c, "an array is NULL");
  if (put_field(c, r, field, n, values)) return;
  if (field == CNTC_fld_taucrt || field == CNTC_fld_uplsx || field == CNTC_fld_uplsy)
    return say(c,
               "field %d (%s) is not available: the flow of layers is not known by elements; allowed: 1 to 5, 7 to 9, "
               "15, 16, 20 to 23",
               field, field == CNTC_fld_taucrt ? "TAUCRT" : "UPLS");
  say(c, "there is no field %d", field);
}

void get_tractions(Call& c, const ContactResult& r, int n, double* pn, double* px, double* py) {
  put_field(c, r, CNTC_fld_pn, n, pn);
  put_field(c, r, CNTC_fld_px, n, px);
  put_field(c, r, CNTC_fld_py, n, py);
}

void get_slip(Call& c, const ContactResult& r, int n, double* sx, double* sy) {
  put_field(c, r, CNTC_fld_sx, n, sx);
  put_field(c, r, CNTC_fld_sy, n, sy);
}

void get_displacements(Call& c, const ContactResult& r, int n, double* un, double* ux, double* uy) {
  put_field(c, r, CNTC_fld_un, n, un);
  put_field(c, r, CNTC_fld_ux, n, ux);
  put_field(c, r, CNTC_fld_uy, n, uy);
}

void get_sensitivities(Call& c, const Totals& r, int rows, int columns, double* values) {
  if (!values) return;
  const double length = c.units().length;
  for (int j = 0; j < std::min(columns, 4); ++j)
    for (int i = 0; i < std::min(rows, 4); ++i) {
      double v = r.sensitivities[size_t(i + 4 * j)];
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
