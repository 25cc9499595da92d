// Solves the patches of a wheel on CONTACT's grids, and finds height and pitch rate.
#include <algorithm>
#include <cmath>

#include "calculate.hpp"
#include "vectors.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

constexpr double pi = 3.141592653589793;

/// Friction at a place: linear between rows, constant beyond.
FrictionRow friction_at(const Friction& f, double place) {
  const auto& rows = f.rows;
  if (f.variation == 0 || place <= rows.front().place) return rows.front();
  for (size_t k = 1; k < rows.size(); ++k) {
    if (place > rows[k].place) continue;
    const double t = (place - rows[k - 1].place) / (rows[k].place - rows[k - 1].place);
    FrictionRow row;
    for (size_t i = 0; i < row.p.size(); ++i) row.p[i] = (1 - t) * rows[k - 1].p[i] + t * rows[k].p[i];
    return row;
  }
  return rows.back();
}

}  // namespace

/// Lays elements on multiples of DX and DS from the reference, from one beyond the overlap on each side.
void WheelSolver::lay_grid(const Inputs& in, WheelPatch& patch) const {
  double dx = in.plane.dx, ds = in.plane.ds;
  const double beyond = patch.tight ? 0 : overlap_beyond, more = patch.tight ? 0 : 1;
  const double x = beyond * patch.x.length(), s = beyond * patch.s.length();
  for (;;) {
    const double i0 = std::floor((patch.x.low - x) / dx) - more, i1 = std::ceil((patch.x.high + x) / dx) + more;
    const double j0 = std::floor((patch.s.low - s) / ds) - more, j1 = std::ceil((patch.s.high + s) / ds) + more;
    if ((i1 - i0 + 1) * (j1 - j0 + 1) < in.digits.npomax) {
      // A sequence of steps keeps the grid as long as it covers the contact.
      const Grid& g = patch.wanted.grid;
      const bool steps = (in.digits.tang == 1 || in.digits.tang == 2) && in.digits.pvtime != 2;
      if (steps && g.dx == dx && g.dy == ds && g.xc <= (i0 + 1) * dx && g.x(g.mx - 1) >= (i1 - 1) * dx &&
          g.yc <= (j0 + 1) * ds && g.y(g.my - 1) >= (j1 - 1) * ds)
        return;
      patch.wanted.grid = {int(i1 - i0) + 1, int(j1 - j0) + 1, i0 * dx, j0 * ds, dx, ds};
      return;
    }
    dx *= 2;
    ds *= 2;
  }
}

/// Velocities of wheel and rail in the track that moves along with the wheelset; a curve turns the wheel against the
/// rail about the track's origin.
void WheelSolver::set_velocities(const Inputs& in, WheelPatch& patch) const {
  const auto &q = set_.position, &v = set_.velocity;
  const auto& f = set_.flexibility;
  const Vec3 axle = wheel.rotation * Vec3{0, 1, 0};
  Placement& at = patch.placement;
  const Vec3 rate = Vec3{v[3], 0, 0} + v[4] * (about_x(q[3]) * Vec3{0, 0, 1});
  at.wheel_point = wheel.origin - radius_ * (wheel.rotation * Vec3{0, 0, 1});
  at.wheel_velocity = Vec3{v[0], v[1], v[2]} + cross(rate, at.wheel_point - wheelset.origin) +
                      wheelset.rotation * Vec3{f[6], f[7], f[8]};
  at.wheel_rate = rate + pitch_rate * axle + wheelset.rotation * Vec3{f[9], f[11], f[10]};
  const Vec3 turn = {0, 0, v[0] * track_.curv};
  at.wheel_velocity = at.wheel_velocity + cross(turn, at.wheel_point);
  at.wheel_rate = at.wheel_rate + turn;
  at.rail_velocity = {0, track_.rate[0], track_.rate[1]};
  at.rail_rate = {track_.rate[2], 0, 0};
  at.rail_point = rail.origin;
  if (roller_ > 0) {
    const Vec3 turning = roller_rate_ * (rail.rotation * Vec3{0, 1, 0});
    at.rail_velocity = at.rail_velocity + cross(turning, rail.origin - at.rail_origin);
    at.rail_rate = at.rail_rate + turning;
  }
  at.by_velocity = in.digits.discns >= 3 && in.digits.discns <= 4 && in.digits.tang != 1;
  at.conformal = in.digits.discns == 4;
  patch.radius = norm(cross(patch.reference - at.wheel_point, axle));
}

/// Places the bodies of a patch: a wheel that varies has turned by its pitch, a rail that varies begins one position
/// behind the wheelset, and a roller turns about an axis below its profile.
void WheelSolver::stand_patch(WheelPatch& patch) const {
  Placement& at = patch.placement;
  const auto& q = set_.position;
  at.wheel_rotation = wheel_profile.varies() ? wheel.rotation * about_y(q[5] + set_.flexibility[5]) : wheel.rotation;
  at.wheel_origin = wheel.origin - radius_ * (wheel.rotation * Vec3{0, 0, 1});
  at.rail_rotation = rail.rotation;
  at.rail_origin = rail.origin;
  if (rail_profile.varies()) at.rail_origin[0] -= q[0];
  if (roller_ > 0) at.rail_origin = rail.origin + rail.rotation * Vec3{0, 0, depth_} - Vec3{x, 0, 0};
  at.origin = patch.reference;
  at.along = patch.along();
  at.normal = patch.normal();
}

/// Creepages at the reference; the wheel's point lies deeper by the overlap.
void WheelSolver::set_creepages(WheelPatch& patch) const {
  const Placement& at = patch.placement;
  ContactCase& w = patch.wanted;
  const double over_rail =
      roller_ > 0 ? roller_rate_ * norm(cross(patch.reference - at.rail_origin, rail.rotation * Vec3{0, 1, 0}))
                  : set_.velocity[0];
  w.veloc = w.tang == 1 ? 1 : (std::abs(over_rail) + std::abs(pitch_rate) * patch.radius) / 2;
  const Vec3 on_wheel = patch.reference + (patch.overlap + patch.approach) * patch.normal();
  const Vec3 wheel_speed = at.wheel_velocity + cross(at.wheel_rate, on_wheel - at.wheel_point);
  const Vec3 rail_speed = at.rail_velocity + cross(at.rail_rate, patch.reference - at.rail_point);
  const Vec3 off = rail_speed - wheel_speed;
  w.cksi = off[0] / w.veloc;
  w.ceta = dot(off, patch.across()) / w.veloc;
  w.cphi = dot(at.rail_rate - at.wheel_rate, patch.normal()) / w.veloc;
}

void WheelSolver::set_friction(const Inputs& in, WheelPatch& patch) {
  const double place = in.friction.variation == 2 ? in.wheelset.position[0] : patch.delta;
  patch.solver->set_surfaces(in, friction_at(in.friction, place), in.digits.tang);
}

/// Solves a patch. Where the grid reaches beyond the end of a profile it is laid on the contact alone.
int WheelSolver::solve_patch(const Inputs& in, WheelPatch& patch, std::string& why) const {
  try {
    return patch.solver->solve(patch.wanted, why);
  } catch (const Failure&) {
    if (patch.tight || !patch.wanted.moved) throw;
  }
  patch.tight = true;
  lay_grid(in, patch);
  return patch.solver->solve(patch.wanted, why);
}

/// Solves all patches with the wheel sunk by `sink` and returns the force on the rail in the track.
Vec3 WheelSolver::solve_patches(Problem& p, double sink, int& code, std::string& why) {
  Vec3 total{};
  code = 0;
  for (WheelPatch& patch : patches) {
    patch.approach = patch.wanted.pen = sink * std::cos(patch.delta);
    set_velocities(p.in, patch);
    set_creepages(patch);
    patch.wanted.placement = &patch.placement;
    const int result = solve_patch(p.in, patch, why);
    if (result) code = result;
    patch.wanted.moved = false;
    patch.wanted.pvtime = p.in.digits.tang == 1 || p.in.digits.tang == 2 ? 3 : 0;
    patch.wanted.iestim = 1;
    const Vec3 f = patch.solver->force();  // on the wheel, along t1, t2 and n
    const double back = patch.wanted.chi != 0 ? -1 : 1;
    total = total - back * f[0] * patch.along() - back * f[1] * patch.across() - f[2] * patch.normal();
  }
  return total;
}

/// Meets the vertical force by the secant method for its power 2/3, which is nearly linear in the height.
Vec3 WheelSolver::find_height(Problem& p, int& code, std::string& why) {
  const double wanted = std::pow(std::max(p.in.fz, 0.), 2. / 3);
  const double accuracy = p.in.fz * std::clamp(p.in.solver.reals[0], 1e-9, 1e-4) / 2;
  double before = sink_ - 1e-3, at = sink_, slope = slope_, off_before = 0;
  for (int n = 0; n < 25; ++n) {
    const Vec3 force = solve_patches(p, at, code, why);
    const double off = std::pow(std::max(force[2], 0.), 2. / 3) - wanted;
    sink_ = at;
    if (std::abs(force[2] - p.in.fz) <= accuracy || std::abs(at - before) < 1e-13) return force;
    if (n > 0 && off != off_before) slope = (off - off_before) / (at - before);
    if (!(slope > 0)) {
      double depth = 0;
      for (const WheelPatch& patch : patches) depth = std::max(depth, patch.overlap);
      slope = wanted / std::max(depth, 1e-9);
    }
    slope_ = slope;
    before = at;
    off_before = off;
    at -= off / slope;
  }
  code = CNTC_err_ftot;
  why = "the vertical force was not found";
  return {};
}

/// Meets the longitudinal force on the rail along the wheelset's x by the pitch rate (F = 1), from the search's rate.
void WheelSolver::find_pitch_rate(Problem& p, int& code, std::string& why) {
  const Vec3 x = wheelset.rotation * Vec3{1, 0, 0};
  double limit = 0;
  for (const WheelPatch& patch : patches) limit = std::max(limit, patch.solver->fstat());
  limit *= std::max(1., std::abs(p.in.fz));
  const auto off = [&](double rate) {
    pitch_rate = rate;
    const Vec3 force = p.in.digits.norm == 1 ? find_height(p, code, why) : solve_patches(p, 0, code, why);
    return dot(force, x) - p.in.fx;
  };
  const double start = std::abs(pitch_rate), accuracy = limit * std::clamp(p.in.solver.reals[0], 1e-9, 1e-4);
  if (!find_root(off, pitch_rate, 1e-4 * start, .5 * start, accuracy))
    throw Failure(CNTC_err_ftot, "no pitch rate gives the longitudinal force FX: it is above the limit of friction");
}

/// Finds the deflections at which the springs of the rail carry its forces (F = 3), by Newton's method from those of
/// the search; its matrix stays.
void WheelSolver::find_deflection(Problem& p, int& code, std::string& why) {
  const Track& t = track_;
  const double k[2] = {t.ky, t.kz}, given[2] = {t.fy, t.fz}, step = 1e-3;
  const auto stand = [&](size_t axis, double more) {
    deflection[axis] += more;
    rail.origin[1 + axis] += more;
    for (WheelPatch& patch : patches) {
      patch.placement.rail_origin[1 + axis] += more;
      patch.wanted.moved = true;
    }
  };
  // A rigid axis has no unknown.
  const auto off = [&] {
    const Vec3 force = p.in.digits.norm == 1 ? find_height(p, code, why) : solve_patches(p, 0, code, why);
    std::array<double, 2> r{};
    for (size_t i = 0; i < 2; ++i) r[i] = k[i] > 0 ? k[i] * deflection[i] - force[1 + i] - given[i] : 0;
    return r;
  };
  double m[2][2] = {{1, 0}, {0, 1}};
  std::array<double, 2> r = off();
  for (size_t j = 0; j < 2; ++j) {
    if (!(k[j] > 0)) continue;
    stand(j, step);
    const auto moved = off();
    stand(j, -step);
    for (size_t i = 0; i < 2; ++i) m[i][j] = k[i] > 0 ? (moved[i] - r[i]) / step : m[i][j];
  }
  const double det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const double accuracy = std::max(1., std::abs(p.in.fz)) * std::clamp(p.in.solver.reals[0], 1e-9, 1e-4);
  r = off();
  for (int n = 0; n < 20; ++n) {
    if (std::max(std::abs(r[0]), std::abs(r[1])) <= accuracy) return;
    stand(0, (m[0][1] * r[1] - m[1][1] * r[0]) / det);
    stand(1, (m[1][0] * r[0] - m[0][0] * r[1]) / det);
    r = off();
  }
  code = CNTC_err_ftot;
  why = "the deflection of the rail (F = 3) was not found";
}

namespace {

void flip_rows(const Grid& g, std::vector<double>& v, double factor) {
  if (v.empty()) return;
  for (int j = 0; j < g.my / 2; ++j)
    std::swap_ranges(v.begin() + long(j) * g.mx, v.begin() + long(j + 1) * g.mx, v.begin() + long(g.my - 1 - j) * g.mx);
  for (double& x : v) x *= factor;
}

/// Turns a mirror image back.
void mirror(ContactResult& r) {
  for (auto* v : {&r.h, &r.mu, &r.pn, &r.px, &r.un, &r.ux, &r.sx, &r.wx, &r.temp1, &r.temp2}) flip_rows(r.grid, *v, 1);
  for (auto* v : {&r.py, &r.uy, &r.sy, &r.wy}) flip_rows(r.grid, *v, -1);
  std::vector<double> states(r.division.begin(), r.division.end());
  flip_rows(r.grid, states, 1);
  r.division.assign(states.begin(), states.end());
  r.grid.yc = -r.grid.y(r.grid.my - 1);
  for (double* v : {&r.ty, &r.mz, &r.ceta, &r.cphi, &r.mx}) *v = -*v;
  for (size_t i = 0; i < 4; ++i)
    for (size_t j = 0; j < 4; ++j)
      if ((i >= 2) != (j >= 2)) r.sensitivities[i + 4 * j] *= -1;
}

}  // namespace

/// Gives a patch its contact on the caller's grid.
void WheelSolver::ready_patch(const Inputs& in, WheelPatch& patch) {
  if (!patch.solver) {
    patch.solver = std::make_shared<ContactSolver>();
    patch.solver->set_bodies(context_.get(), wheel_profile.body(),
                             (roller_ > 0 ? roller_profile_ : rail_profile).body());
  }
  lay_grid(in, patch);
  stand_patch(patch);
  ContactCase& w = patch.wanted;
  w.tang = in.digits.tang;
  w.pvtime = in.digits.pvtime;
  w.iestim = in.digits.iestim;
  w.chi = onward_ < 0 ? pi : 0;
  w.dq = (in.digits.tang == 3 ? 1 : in.dq) * w.grid.dx;
  w.dt = in.dt;
  set_friction(in, patch);
}

void WheelSolver::read_patch(const Inputs& in, WheelPatch& patch, ContactResult& r) const {
  patch.wanted.sensitivities = in.digits.sens >= 2;
  patch.solver->read(patch.wanted, r);
  double least = 0;
  for (const double h : r.h) least = std::min(least, h);
  for (double& h : r.h) h -= least;
  r.pen = -least;
  if (!patch.placement.by_velocity) {
    r.cksi = patch.wanted.cksi;
    r.ceta = patch.wanted.ceta;
    r.cphi = patch.wanted.cphi;
  }
  if (sign < 0) mirror(r);
}

int WheelSolver::solve(Problem& p, std::string& why) {
  const Inputs& in = p.in;
  solved = false;
  p.patches.clear();
  if (in.digits.tang == 1 && in.digits.force == 1)
    throw Failure(CNTC_err_other, "a given longitudinal force (F = 1) needs rolling: T = 2 or 3");
  prepare(p);
  mirror_inputs(in);
  pitch_rate = set_.velocity[5];
  sink_ = slope_ = 0;
  if (in.digits.frames) return solve_on_frames(p, why);
  check(rollcon_wheelrail_set_real(search_.get(), "accuracy", .01));
  check(rollcon_wheelrail_set_int(search_.get(), "conformal", 0));
  search(p);
  join_patches(in.plane);
  int code = 0;
  for (WheelPatch& patch : patches) ready_patch(in, patch);
  if (!patches.empty()) {
    if (in.digits.force == 1) {
      find_pitch_rate(p, code, why);
    } else if (in.digits.force == 3) {
      find_deflection(p, code, why);
    } else if (in.digits.norm == 1) {
      find_height(p, code, why);
    } else {
      solve_patches(p, 0, code, why);
    }
  } else if (in.digits.norm == 1 && in.fz > 0) {
    throw Failure(CNTC_err_ftot, "no height carries the vertical force");
  }
  place_wheel(z + sink_);
  p.patches.assign(patches.size(), ContactResult{});
  for (size_t k = 0; k < patches.size(); ++k) read_patch(in, patches[k], p.patches[k]);
  solved = true;
  return code;
}

int solve_wheel(Problem& p, std::string& why) {
  refuse_absent(p);
  if (!p.wheel) p.wheel = std::make_unique<WheelSolver>();
  return p.wheel->solve(p, why);
}

}  // namespace cntc
