#include "calculate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "bodies.hpp"
#include "contact_solver.hpp"
#include "files.hpp"
#include "wheel_solver.hpp"

namespace cntc {

namespace {

/// A value of a digit that is refused, with the values that are not.
struct Absence {
  bool is;
  int code;
  const char *digit, *what, *allowed;
  int value;
};

}  // namespace

void refuse_absent(const Problem& p) {
  const Digits& d = p.in.digits;
  const bool hertz = p.module == 3 && p.in.hertz.ipotcn != 0, wheel = p.module == 1;
  const Absence all[] = {
      {d.mater == 1 && wheel, CNTC_err_other, "M", "viscoelastic bodies", "0, 4; in module 3 also 1", d.mater},
      {d.mater == 1 && d.tang != 3, CNTC_err_other, "T", "viscoelastic bodies (M = 1) in motions", "3", d.tang},
      {d.mater > 1 && d.mater != 4, CNTC_err_other, "M", "FASTSIM or FaStrip", wheel ? "0, 4" : "0, 1, 4", d.mater},
      {d.bound != 0 && !(d.bound == 2 && hertz), CNTC_err_other, "B", "bounds of traction by a given pressure",
       "0; on grids of Hertz 2, which is solved in full", d.bound},
      {wheel && d.config > 1 && d.config < 4, CNTC_err_search, "C1", "sides", "0, 1, 4, 5", d.config},
      {wheel && d.force == 2, CNTC_err_other, "F", "forces", "0, 1, 3", d.force},
      {wheel && d.force == 1 && d.norm != 1, CNTC_err_other, "N", "a given FX (F = 1) at a given height", "1", d.norm},
      {!wheel && d.force == 3, CNTC_err_other, "F", "a massless rail in module 3", "0, 1, 2", d.force},
      {wheel && d.discns >= 6, CNTC_err_discr, "D", "contact search", "0 to 5", d.discns},
      {!wheel && d.exrhs >= 2, CNTC_err_other, "E", "rigid slip without parts of the spin", "0, 1, 9", d.exrhs},
      {d.inflcf == 9, CNTC_err_input, "C3", "influence coefficients from a file", "0 to 4", d.inflcf}};
  for (const Absence& r : all)
    if (r.is)
      throw Failure(r.code, std::string(r.what) + " (" + r.digit + " = " + std::to_string(r.value) +
                                ") are not available; allowed: " + r.digit + " = " + r.allowed);
}

namespace {

double plane_gap(const Inputs& in, double x, double y) {
  const auto& b = in.gap;
  if (in.ibase == 1) return b[0] * x * x + b[1] * x * y + b[2] * y * y + b[3] * x + b[4] * y + b[5];
  if (in.ibase == 2) {
    const double at = (y - b[3]) / b[4];
    const size_t last = b.size() - 6;  // number of the last height, from 0
    const size_t k = at <= 0 ? 0 : std::min(size_t(at), last - 1);
    const double t = at - double(k);
    return (x - b[1]) * (x - b[1]) / (2 * b[2]) + (1 - t) * b[5 + k] + t * b[6 + k];
  }
  const auto part = [](double v, double r) { return r != 0 ? v * v / r : 0; };
  return b[0] * std::sin(b[1] * (x - b[2])) - b[3] * std::sin(b[4] * (x - b[5])) + part(x, b[6]) + part(y, b[7]);
}

/// Places outside of the planform do not touch (IPLAN 2 and 3 of input files).
bool outside(const Inputs& in, double x, double y) {
  const auto& q = in.plan;
  if (in.iplan == 2) return q[0] * x * x + q[1] * x * y + q[2] * y * y + q[3] * x + q[4] * y + q[5] >= 0;
  if (in.iplan != 3) return false;
  const auto inside = [&](size_t k) { return x >= q[k] && x <= q[k + 1] && y >= q[k + 2] && y <= q[k + 3]; };
  return !inside(0) && !inside(4);
}

}  // namespace

void fill_gap(Problem& p, Grid& grid, std::vector<double>& gap) {
  const Inputs& in = p.in;
  const bool hertz = in.hertz.ipotcn != 0;
  if (hertz) {
    p.hertz = hertz_contact(in);
    grid = hertz_grid(in.hertz, p.hertz);
  } else {
    grid = in.grid;
  }
  if (grid.size() < 1)
    throw Failure(CNTC_err_discr, "there is no grid: call cntc_setpotcontact or cntc_sethertzcontact");
  const bool listed = in.ibase == 9 && !hertz;
  if (listed && in.gap.size() != size_t(grid.size()))
    throw Failure(CNTC_err_discr, "the undeformed distance has another number of values than the grid has elements");
  gap.resize(size_t(grid.size()));
  const double far = 1e3 * (std::abs(in.pen) + std::max(grid.dx * grid.mx, grid.dy * grid.my));
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      const size_t k = size_t(j) * size_t(grid.mx) + size_t(i);
      gap[k] = hertz ? p.hertz.a1 * x * x + p.hertz.b1 * y * y : listed ? in.gap[k] : plane_gap(in, x, y);
      if (outside(in, x, y)) gap[k] += far;
    }
  if (hertz && grid.size() == 1) gap[0] = 0;
}

namespace {

/// Adds damping of the contact (M2 = 2) to the forces: F + c dF/dt, with the rate within bounds.
void add_damping(Problem& p, ContactResult& r) {
  const Material& m = p.in.material;
  const double fn = r.fn, fx = r.tx, fy = r.ty;
  if (p.in.digits.damping == 2 && p.has_before && p.in.digits.pvtime != 2) {
    const double dt = p.in.digits.tang >= 2 && r.veloc > 0 ? r.dq / r.veloc : p.in.dt;
    const auto cut = [](double rate, double most) { return most > 0 ? std::clamp(rate, -most, most) : rate; };
    r.fn += m.cdampn * cut((fn - p.fn_before) / dt, m.dfnmax);
    r.tx += m.cdampt * cut((fx - p.fx_before) / dt, m.dftmax);
    r.ty += m.cdampt * cut((fy - p.fy_before) / dt, m.dftmax);
  }
  p.fn_before = fn;
  p.fx_before = fx;
  p.fy_before = fy;
  p.has_before = true;
}

}  // namespace

int solve_gap(Problem& p, std::string& why) {
  const Inputs& in = p.in;
  const Digits& d = in.digits;
  refuse_absent(p);
  if (!p.contact) p.contact = std::make_unique<ContactSolver>();
  p.contact->set_material(in);
  ContactCase wanted;
  fill_gap(p, wanted.grid, wanted.gap);
  p.contact->set_surfaces(in, in.friction.rows[0], d.tang);
  static_cast<Motion&>(wanted) = in;
  wanted.tang = d.tang;
  wanted.pvtime = d.pvtime;
  wanted.iestim = d.iestim;
  wanted.force = d.force;
  wanted.normal_by_force = d.norm == 1;
  if (wanted.normal_by_force && in.fn < 0) throw Failure(CNTC_err_norm, "the normal force is below 0");
  if (d.tang == 0) wanted.cksi = wanted.ceta = wanted.cphi = 0;
  if (d.tang == 0 || d.exrhs != 1) {
    wanted.wx.clear();
    wanted.wy.clear();
  }
  wanted.dq = d.tang == 3 ? wanted.grid.dx : in.dq;
  wanted.sensitivities = d.sens >= 2;
  const int code = p.contact->solve(wanted, why);
  p.contact->read(wanted, p.patches[0]);
  add_damping(p, p.patches[0]);
  return code ? code : p.patches[0].rim;
}

void calculate(Call& c, ErrorCode error) {
  Problem& p = c.p;
  Digits& d = p.in.digits;
  ++d.ncase;
  if (d.idebug >= 1) say(c, "calculating case %d", d.ncase);
  if (d.wrtinp >= 1) write_inp(p);
  std::string why;
  int& code = error.value = 0;
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  try {
    code = p.module == 1 ? solve_wheel(p, why) : solve_gap(p, why);
  } catch (const Failure& failure) {
    code = failure.code;
    why = failure.what();
    for (ContactResult& r : p.patches) r.solved = false;
  }
  p.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  p.cpu += double(std::clock() - cpu) / CLOCKS_PER_SEC;
  if (!why.empty()) say(c, "%s", why.c_str());
  if (code > 0) say(c, "%d elements in contact are next to the border of the potential contact", code);
  if (code >= 0) write_results(p);
  if (d.idebug >= 1) say(c, "done, error code %d", code);
}

}  // namespace cntc
