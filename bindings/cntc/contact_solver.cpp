#include "contact_solver.hpp"

#include <algorithm>
#include <cmath>

#include "calculate.hpp"
#include "log.hpp"
#include "vectors.hpp"

namespace cntc {

int check(rollcon_status status) {
  if (status >= 0) return status;
  int code = CNTC_err_other;
  if (status == ROLLCON_ERR_LOAD) code = CNTC_err_ftot;
  if (status == ROLLCON_ERR_SINGULAR) code = CNTC_err_tang;
  throw Failure(code, rollcon_last_error());
}

bool find_root(const std::function<double(double)>& off, double start, double step, double far, double accuracy) {
  double low = start, f_low = off(low), high = low, f_high = f_low;
  if (f_low > 0) step = -step;
  for (; f_low * f_high > 0 && std::abs(f_high) > accuracy; step *= 2) {
    if (std::abs(high - start) > far) return false;
    low = high;
    f_low = f_high;
    high += step;
    f_high = off(high);
  }
  for (int n = 0; n < 60 && std::abs(f_high) > accuracy && std::abs(high - low) > 1e-14 * std::abs(high); ++n) {
    const double next = n % 4 == 3 ? (low + high) / 2 : high - f_high * (high - low) / (f_high - f_low);
    const double f_next = off(next);
    if (f_next * f_high < 0) {
      low = high;
      f_low = f_high;
    } else {
      f_low /= 2;  // the end that stays counts less, so that it gives way
    }
    high = next;
    f_high = f_next;
  }
  return true;
}

void ContactSolver::set_material(const Inputs& in) {
  const int threads = in.digits.openmp < 0 ? 0 : std::max(1, in.digits.openmp);
  const bool relaxes = in.digits.mater == 1;
  if (contact_ && threads == threads_ && in.material.nu == material_.nu && in.material.g == material_.g &&
      relaxes == relaxes_ && (!relaxes || in.material.more == material_.more))
    return;
  contact_.reset();
  create(context_, rollcon_context_create, ROLLCON_ABI);
  check(rollcon_context_set_threads(context_.get(), threads));
  BodyHandle* const bodies[] = {&first_, &second_};
  felt_ = in.material;
  for (size_t k = 0; k < 2; ++k) {
    create(*bodies[k], rollcon_body_create, context_.get(), ROLLCON_BODY_HALFSPACE);
    rollcon_body* body = bodies[k]->get();
    // CONTACT's G is that of fast strains, FG what creep adds to its inverse, TC the time of creep: at once if 0.
    const double creep = relaxes ? in.material.more[1 - k] : 0, ratio = creep / (1 + creep),
                 time = in.material.more[3 - k] / (1 + creep);
    if (relaxes && !(time > 0)) felt_.g[1 - k] /= 1 + creep;
    const double nu = felt_.nu[1 - k], g = felt_.g[1 - k];
    check(rollcon_body_set_elastic(body, 0, 2 * g * (1 + nu), nu));
    if (time > 0 && creep != 0) check(rollcon_body_set_viscoelastic(body, 0, 1, &ratio, &time));
  }
  material_ = in.material;
  relaxes_ = relaxes;
  threads_ = threads;
  compliance_ = contact_compliance(felt_);
  shear_compliance_ = .5 / felt_.g[0] + .5 / felt_.g[1];
  set_bodies(context_.get(), first_.get(), second_.get());
}

void ContactSolver::set_bodies(rollcon_context* context, rollcon_body* first, rollcon_body* second) {
  create(contact_, rollcon_contact_create, context, first, second);
  framed_ = solved_ = stepped_ = false;
  gap_.clear();
}

namespace {

/// Falling friction: rollcon's parameters, without terms that are 0.
std::vector<double> falling(const FrictionRow& row) {
  std::vector<double> p{row.p[0]};
  const bool first = row.p[1] != 0 && row.p[2] > 0, second = row.p[3] != 0 && row.p[4] > 0;
  if (first || second) p.insert(p.end(), {first ? row.p[1] : 0, first ? row.p[2] : 1});
  if (second) p.insert(p.end(), {row.p[3], row.p[4]});
  return p;
}

}  // namespace

double rest_friction(const FrictionRow& row, int law) {
  switch (law) {
    case 0:
      return std::min(row.p[0], row.p[1]);
    case 2:
    case 3:
    case 4:
      return row.p[0] + row.p[1] + row.p[3];
    default:
      return std::max(row.p[0], row.p[0] + row.p[2]);
  }
}

void ContactSolver::set_surfaces(const Inputs& in, const FrictionRow& row, int tang) {
  static const char* const names[] = {"coulomb", "", "linear", "rational", "exponential", "exponential", "temperature"};
  rollcon_contact* contact = contact_.get();
  const int law = in.friction.law;
  fstat_ = rest_friction(row, law);
  std::vector<double> p{fstat_};
  const char* name = names[law];
  bool memory = false;
  if (tang == 0) {
    p = {0};
    name = names[0];
  } else if (law >= 2 && law <= 4) {
    p = falling(row);
    if (p.size() == 1) name = names[0];
    memory = p.size() > 1 && in.friction.memdst > 0;
  } else if (law == 6) {
    if (in.digits.heat == 0) throw Failure(CNTC_err_frclaw, "friction of temperature (L = 6) needs heat (H = 3)");
    p = {row.p[1], row.p[0], row.p[1] + row.p[3], row.p[0] + row.p[2]};
  }
  several_ = law >= 2;
  const bool layer = in.digits.mater == 4;
  const auto& more = in.material.more;
  const bool yields = in.yields();
  if ((memory || yields) && (tang == 1 || tang == 2))
    throw Failure(CNTC_err_frclaw, "memory of friction and layers that yield are for steady rolling alone: use T = 3");
  if (layer && !(more[0] > 0)) throw Failure(CNTC_err_other, "the layer's shear modulus must be above 0");
  check(rollcon_contact_set_friction(contact, name, int32_t(p.size()), p.data()));
  check(rollcon_contact_set_friction_memory(contact, memory ? in.friction.memdst : 0, memory ? in.friction.mem_s0 : 0));
  layer_ = layer ? more[1] / more[0] : 0;
  check(rollcon_contact_set_layer(contact, layer_, yields ? more[2] : 0, yields ? more[3] : 0));
  heat_ = in.digits.heat != 0;
  if (!heat_) return;
  if (tang != 3) throw Failure(CNTC_err_other, "temperatures (H = 3) are for steady rolling alone: use T = 3");
  for (size_t k = 0; k < 2; ++k) {  // a joule is 1000 N mm
    const Heat& heat = in.heat[1 - k];
    check(rollcon_contact_set_heat(contact, int32_t(k + 1), 1000 * heat.conductivity,
                                   1000 * heat.capacity * heat.density, heat.background));
  }
}

size_t ContactSolver::node(int i, int j) const {
  if (lattice_ == Lattice::point) return 0;
  const int ring = lattice_ == Lattice::ringed ? 1 : 0;
  return size_t(j + ring) * size_t(grid_.mx + 2 * ring) + size_t(i + ring);
}

/// Nodes are the elements' centres. Where the gap is given there is a ring of nodes around them that never touch, so
/// that elements at the border carry what constant tractions do. Tractions of a single row fall off linearly over one
/// width to each side. A single element has four nodes at its corners.
void ContactSolver::lay_frame(const ContactCase& wanted) {
  const Grid& g = wanted.grid;
  if (wanted.placement && (wanted.moved || !framed_)) set_poses(*wanted.placement);
  if (framed_ && g == grid_ && wanted.chi == chi_) return;
  const double zero[3] = {0, 0, 0}, e1[3] = {1, 0, 0}, e3[3] = {0, 0, 1};
  rollcon_contact* contact = contact_.get();
  // Convolutions are faster than rollcon's own choice of dense matrices from 8 x 8 elements on.
  const bool convolution =
      g.size() >= 64 && rollcon_has_feature("fftw") && !(wanted.placement && wanted.placement->conformal);
  check(rollcon_contact_set_str(contact, "operators", convolution ? "fft" : "auto"));
  check(rollcon_contact_set_axes(contact, zero, e1, e3));
  lattice_ = g.size() == 1 ? Lattice::point : wanted.placement ? Lattice::plain : Lattice::ringed;
  const int more = lattice_ == Lattice::point ? 0 : lattice_ == Lattice::plain ? -1 : 1;
  const double x0 = g.xc - (1 + more) * g.dx / 2, y0 = g.yc - (1 + more) * g.dy / 2;
  check(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, g.mx + more, g.my + more, x0, x0 + (g.mx + more) * g.dx,
                                        y0, y0 + (g.my + more) * g.dy));
  if (wanted.chi != 0) {
    const double along[3] = {std::cos(wanted.chi), std::sin(wanted.chi), 0};
    check(rollcon_contact_set_axes(contact, zero, along, e3));
  }
  grid_ = g;
  chi_ = wanted.chi;
  framed_ = true;
  solved_ = stepped_ = false;
  gap_.clear();
}

/// Places bodies with profiles in the axes of the contact, so that its frame stays where it is while the contact moves
/// over the rail.
void ContactSolver::set_poses(const Placement& at) {
  const Mat3 to_contact = {at.along, cross(at.normal, at.along), at.normal};
  const auto pose = [&](int body, const Mat3& rotation, const Vec3& origin) {
    const Mat3 turned = to_contact * rotation;
    const Vec3 moved = to_contact * (origin - at.origin);
    double rows[9];
    for (size_t k = 0; k < 9; ++k) rows[k] = turned[k / 3][k % 3];
    check(rollcon_contact_set_pose(contact_.get(), body, rows, moved.data()));
  };
  pose(ROLLCON_BODY1, at.wheel_rotation, at.wheel_origin);
  pose(ROLLCON_BODY2, at.rail_rotation, at.rail_origin);
  check(rollcon_contact_set_int(contact_.get(), "conformal", at.conformal));
}

void ContactSolver::set_gaps(const ContactCase& wanted) {
  if (wanted.placement || wanted.gap == gap_) return;
  std::vector<double> gap = wanted.gap;
  if (lattice_ == Lattice::point) {
    gap.assign(4, wanted.gap[0]);
  } else {
    double far = 1e6 * std::max(grid_.dx, grid_.dy);
    for (double h : wanted.gap) far = std::max(far, 2 * h);
    gap.assign(size_t(grid_.mx + 2) * size_t(grid_.my + 2), far);
    for (int j = 0; j < grid_.my; ++j)
      for (int i = 0; i < grid_.mx; ++i) gap[node(i, j)] = wanted.gap[size_t(j) * size_t(grid_.mx) + size_t(i)];
  }
  check(rollcon_contact_set_gap(contact_.get(), int64_t(gap.size()), gap.data()));
  gap_ = wanted.gap;
}

void ContactSolver::set_motion(const ContactCase& wanted) {
  rollcon_contact* contact = contact_.get();
  const double c = std::cos(wanted.chi), s = std::sin(wanted.chi);
  const double x = wanted.cksi + wanted.cphi * wanted.spinyo, y = wanted.ceta - wanted.cphi * wanted.spinxo;
  const double veloc = wanted.veloc > 0 ? wanted.veloc : 1;
  check(rollcon_contact_set_rolling(contact, veloc));
  const Placement* at = wanted.placement;
  if (at && at->by_velocity) {
    const Mat3 to_contact = {at->along, cross(at->normal, at->along), at->normal};
    const auto move = [&](int body, const Vec3& velocity, const Vec3& rate, const Vec3& point) {
      const Vec3 v = to_contact * velocity, w = to_contact * rate, x = to_contact * (point - at->origin);
      check(rollcon_contact_set_velocity(contact, body, v.data(), w.data(), x.data()));
    };
    move(ROLLCON_BODY1, at->wheel_velocity, at->wheel_rate, at->wheel_point);
    move(ROLLCON_BODY2, at->rail_velocity, at->rail_rate, at->rail_point);
  } else {
    check(rollcon_contact_set_creep(contact, -(c * x + s * y), -(c * y - s * x), -wanted.cphi));
  }
  check(rollcon_contact_prescribe(contact, ROLLCON_NORMAL,
                                  wanted.normal_by_force ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION,
                                  wanted.normal_by_force ? wanted.fn : wanted.pen));
  if (wanted.force >= 1 && wanted.tang > 0) {
    if (wanted.force == 1 && std::abs(s) > 1e-9)
      throw Failure(CNTC_err_ftot, "FX alone (F = 1) needs rolling along x: give FX and FY (F = 2)");
    if (!wanted.normal_by_force)
      throw Failure(CNTC_err_ftot, "tangential forces are relative to the normal force: prescribe that, too (N = 1)");
    const double unit = -fstat_ * wanted.fn, most = .99995;
    const double size = wanted.force == 1 ? std::abs(wanted.fx) : std::hypot(wanted.fx, wanted.fy);
    const double cut = size > most ? most / size : 1;
    const double fx = cut * wanted.fx, fy = wanted.force == 1 ? 0 : cut * wanted.fy;
    check(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, unit * (c * fx + s * fy)));
    if (wanted.force == 2)
      check(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_FORCE, unit * (c * fy - s * fx)));
  }
  const size_t n = std::min(wanted.wx.size(), wanted.wy.size());
  int64_t nodes = 0;
  check(rollcon_contact_get_size(contact, &nodes, nullptr));
  std::vector<double> slip;
  if (n > 0) {
    const double scale = wanted.tang == 1 ? 1 / wanted.dt : veloc;
    slip.assign(2 * size_t(nodes), 0);
    for (size_t k = 0; k < std::min(n, size_t(grid_.size())); ++k) {
      const size_t at = node(int(k) % grid_.mx, int(k) / grid_.mx);
      slip[2 * at] = -scale * (c * wanted.wx[k] + s * wanted.wy[k]);
      slip[2 * at + 1] = -scale * (c * wanted.wy[k] - s * wanted.wx[k]);
    }
  }
  check(rollcon_contact_set_creep_field(contact, n > 0 ? nodes : 0, n > 0 ? slip.data() : nullptr));
}

int ContactSolver::solve_once(const ContactCase& wanted, std::string& why) {
  rollcon_contact* contact = contact_.get();
  const int kind = wanted.tang == 1 ? ROLLCON_SHIFT_STEP : wanted.tang == 2 ? ROLLCON_ROLLING_STEP : ROLLCON_STEADY;
  const double veloc = wanted.veloc > 0 ? wanted.veloc : 1;
  check(rollcon_contact_set_step(contact, kind, wanted.tang == 1 ? wanted.dt : wanted.dq / veloc));
  return run_solver(why);
}

int ContactSolver::run_solver(std::string& why) {
  rollcon_contact* contact = contact_.get();
  const int status = check(rollcon_contact_solve(contact));
  if (status != ROLLCON_OK && !(status == ROLLCON_COARSE && (one_row() || lattice_ == Lattice::point)))
    why = rollcon_last_caveat();
  if (status != ROLLCON_NOT_CONVERGED) return 0;
  double normal = 0, tolerance = 0;
  check(rollcon_contact_get_stat(contact, "residual_normal", &normal));
  check(rollcon_contact_get_real(contact, "tolerance", &tolerance));
  return normal > tolerance ? CNTC_err_norm : CNTC_err_tang;
}

int ContactSolver::solve(const ContactCase& wanted, std::string& why) {
  lay_frame(wanted);
  set_gaps(wanted);
  set_motion(wanted);
  rollcon_contact* contact = contact_.get();
  const bool steps = wanted.tang == 1 || wanted.tang == 2;
  // A steady solution does not depend on where it starts from, unless friction falls with slip.
  if (wanted.pvtime == 2 && (steps || (several_ && wanted.iestim == 0))) {
    check(rollcon_contact_reset(contact));
  } else if (steps && wanted.pvtime == 3 && stepped_) {
    rollcon_contact_repeat_step(contact);
  }
  const bool goes_on = wanted.tang == 1 && wanted.pvtime == 0 && solved_;
  const Vec3 before = goes_on ? force() : Vec3{};
  stuck_ = false;
  const bool given = pushed(wanted);
  int code = given ? solve_point(wanted, why) : solve_once(wanted, why);
  if (!given && code != 0 && wanted.force == 1 && wanted.tang == 3) code = search_creepage(wanted, why);
  solved_ = true;
  stepped_ = steps;
  if (!given && lattice_ == Lattice::point && code == 0 && sticks(wanted, before)) {
    stuck_ = true;
    return solve_point(wanted, why);
  }
  if (one_row() && !wanted.normal_by_force) {
    // The approach of a row differs from that of constant tractions in proportion to the force.
    for (int n = 0; n < 12; ++n) {
      double approach = 0;
      check(rollcon_contact_get_motion(contact, &approach, nullptr));
      const double next = wanted.pen - row_offset()[2];
      if (std::abs(next - approach) < 1e-9 * std::abs(wanted.pen)) break;
      check(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, next));
      if (steps) rollcon_contact_repeat_step(contact);
      code = solve_once(wanted, why);
    }
  }
  return code;
}

/// Searches the creepage of a given FX from the last one found. FX falls as the creepage grows, almost in a jump where
/// friction is small and all slides, in directions that the coupling of dissimilar materials gives.
int ContactSolver::search_creepage(const ContactCase& wanted, std::string& why) {
  const double most = fstat_ * wanted.fn, along = std::cos(wanted.chi) > 0 ? 1 : -1;
  double creep[3] = {}, approach = 0;
  check(rollcon_contact_get_motion(contact_.get(), &approach, creep));
  ContactCase given = wanted;
  given.force = 0;
  int code = 0;
  double off = 0;
  const auto above = [&](double ksi) {
    given.cksi = ksi;
    set_motion(given);
    why.clear();
    code = solve_once(given, why);
    return off = -along * force()[0] / most - wanted.fx;
  };
  const double start = -along * creep[0] - wanted.cphi * wanted.spinyo, accuracy = 1e-6;
  find_root(above, start, -std::max(1e-3 * std::abs(start), 1e-9), 1e3, accuracy);
  if (code == 0 && !(std::abs(off) <= accuracy)) {
    code = CNTC_err_tang;
    why = "no creepage was found that gives FX";
  }
  return code;
}

/// Finds the force that a single element takes where its centre sticks, as parts of the largest; tells whether it is
/// within the bound. Steady rolling is followed along x alone.
bool ContactSolver::sticks(const ContactCase& wanted, const Vec3& before) {
  const bool steady = wanted.tang == 3;
  if ((wanted.tang != 1 && !steady) || wanted.pvtime == 3) return false;
  const double c = std::cos(wanted.chi), s = std::sin(wanted.chi);
  if (steady && std::abs(s) > 1e-9) return false;
  // Integrals of 1 / r and x^2 / r^3 over the element at its centre, less those at the place a step ahead.
  double all = 0, along = 0;
  for (double ahead : {0., steady ? wanted.dq : 1e9 * grid_.dx})
    for (double side : {1., -1.}) {
      const double h = ahead + side * grid_.dx / 2, k = grid_.dy / 2, sign = (ahead > 0 ? -2 : 2) * side;
      const double x = sign * k * std::asinh(h / k);
      along += x;
      all += x + (h != 0 ? sign * h * std::asinh(k / std::abs(h)) : 0);
    }
  double by_x = layer_, by_y = layer_;
  for (size_t k = 0; k < 2; ++k) {
    const double nu = felt_.nu[k], part = 1 / (2 * 3.141592653589793 * felt_.g[k]);
    by_x += part * ((1 - nu) * all + nu * along);
    by_y += part * (all - nu * along);
  }
  const double step = wanted.tang == 1 ? 1 : wanted.dq, area = grid_.dx * grid_.dy, most = fstat_ * -force()[2];
  const double wx = wanted.wx.empty() ? 0 : wanted.wx[0], wy = wanted.wy.empty() ? 0 : wanted.wy[0];
  push_[0] = -(wanted.cksi - wanted.cphi * (grid_.yc - wanted.spinyo) + wx) * step / by_x * area -
             (c * before[0] - s * before[1]);
  push_[1] = -(wanted.ceta + wanted.cphi * (grid_.xc - wanted.spinxo) + wy) * step / by_y * area -
             (s * before[0] + c * before[1]);
  for (double& f : push_) f /= std::max(most, 1e-300);
  return std::hypot(push_[0], push_[1]) < 1;
}

/// Gives a single element constant tractions: its corners slide in one direction, under a friction that is the force.
int ContactSolver::solve_point(const ContactCase& wanted, std::string& why) {
  rollcon_contact* contact = contact_.get();
  const double fx = stuck_ ? push_[0] : wanted.fx, fy = stuck_ ? push_[1] : wanted.force == 2 ? wanted.fy : 0;
  const double size = std::min(1., std::hypot(fx, fy));
  const double far = 1e6 * (grid_.dx + grid_.dy) / std::max(size, 1e-300), mu = size * fstat_;
  const double c = std::cos(wanted.chi), s = std::sin(wanted.chi);
  check(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  check(rollcon_contact_set_step(contact, ROLLCON_SHIFT_STEP, 1));
  check(rollcon_contact_set_creep(contact, far * (c * fx + s * fy), far * (c * fy - s * fx), 0));
  return run_solver(why);
}

Vec3 ContactSolver::force() const {
  Vec3 f{};
  check(rollcon_contact_get_resultant(contact_.get(), ROLLCON_LOCAL, f.data(), nullptr));
  return f;
}

}  // namespace cntc
