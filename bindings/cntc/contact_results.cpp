// Reads what a contact of rollcon has found, by CONTACT's signs.
#include <algorithm>
#include <cmath>

#include "contact_solver.hpp"

namespace cntc {

std::vector<double> ContactSolver::field(int which, int values) const {
  int64_t n = 0;
  check(rollcon_contact_get_field(contact_.get(), which, ROLLCON_LOCAL, 0, nullptr, &n));
  std::vector<double> v(size_t(n) + size_t(values));
  check(rollcon_contact_get_field(contact_.get(), which, ROLLCON_LOCAL, n, v.data(), &n));
  return v;
}

namespace {

/// Vectors (t1, t2) of rollcon's body 1 as components x, y of CONTACT's body 1.
struct Turn {
  double c, s, scale;
  double x(double t1, double t2) const { return -scale * (c * t1 - s * t2); }
  double y(double t1, double t2) const { return -scale * (s * t1 + c * t2); }
};

}  // namespace

Vec3 ContactSolver::row_offset() const {
  if (!one_row()) return {};
  const Vec3 f = force();
  const Turn turn{std::cos(chi_), std::sin(chi_), 1};
  const bool along_x = grid_.my == 1;
  const double part = 2 * (1 - std::log(2.)) / (along_x ? grid_.dy : grid_.dx) / 3.141592653589793;
  return {part * turn.x(f[0], f[1]) * (along_x ? compliance_ : shear_compliance_),
          part * turn.y(f[0], f[1]) * (along_x ? shear_compliance_ : compliance_), part * -f[2] * compliance_};
}

void ContactSolver::read_elements(const ContactCase& wanted, ContactResult& r) const {
  const size_t n = size_t(grid_.size());
  const Turn force{std::cos(chi_), std::sin(chi_), 1};
  const double veloc = wanted.veloc > 0 ? wanted.veloc : 1;
  const Turn slip{force.c, force.s, wanted.tang == 1 ? wanted.dt / wanted.dq : 1 / veloc};
  const auto traction = field(ROLLCON_FIELD_TRACTION, 3), velocity = field(ROLLCON_FIELD_SLIP, 2),
             rigid = field(ROLLCON_FIELD_RIGID_SLIP, 2), u1 = field(ROLLCON_FIELD_DISPLACEMENT1, 3),
             u2 = field(ROLLCON_FIELD_DISPLACEMENT2, 3), friction = field(ROLLCON_FIELD_FRICTION, 1),
             gap = field(ROLLCON_FIELD_GAP, 1);
  for (auto* v : {&r.h, &r.mu, &r.px, &r.py, &r.pn, &r.ux, &r.uy, &r.un, &r.sx, &r.sy, &r.wx, &r.wy}) v->assign(n, 0);
  r.division.assign(n, 0);
  const Vec3 more = row_offset();
  std::vector<int32_t> states(gap.size());
  check(rollcon_contact_get_node_states(contact_.get(), int64_t(states.size()), states.data()));
  r.pmax = r.rim = 0;
  for (size_t k = 0; k < n; ++k) {
    const int i = int(k % size_t(grid_.mx)), j = int(k / size_t(grid_.mx));
    const size_t at = node(i, j), a2 = 2 * at, a3 = 3 * at;
    r.px[k] = force.x(traction[a3], traction[a3 + 1]);
    r.py[k] = force.y(traction[a3], traction[a3 + 1]);
    r.pn[k] = std::max(0., -traction[a3 + 2]);
    r.pmax = std::max(r.pmax, r.pn[k]);
    r.sx[k] = slip.x(velocity[a2], velocity[a2 + 1]);
    r.sy[k] = slip.y(velocity[a2], velocity[a2 + 1]);
    r.wx[k] = -slip.x(rigid[a2], rigid[a2 + 1]);
    r.wy[k] = -slip.y(rigid[a2], rigid[a2 + 1]);
    const double d1 = u1[a3] - u2[a3], d2 = u1[a3 + 1] - u2[a3 + 1];
    r.ux[k] = force.x(d1, d2) + more[0];
    r.uy[k] = force.y(d1, d2) + more[1];
    r.un[k] = u2[a3 + 2] - u1[a3 + 2] + more[2];
    r.mu[k] = friction[at];
    r.h[k] = wanted.placement ? gap[at] - r.un[k] : wanted.gap[k];
    // Without friction all that touches counts as sticking.
    r.division[k] = states[at] == ROLLCON_OPEN ? 0 : states[at] == ROLLCON_SLIP && wanted.tang > 0 ? 2 : 1;
    const bool border =
        (grid_.mx > 1 && (i == 0 || i == grid_.mx - 1)) || (grid_.my > 1 && (j == 0 || j == grid_.my - 1));
    r.rim += border && r.division[k] > 0;
  }
}

void ContactSolver::read(const ContactCase& wanted, ContactResult& r) const {
  rollcon_contact* contact = contact_.get();
  static_cast<Motion&>(r) = wanted;
  r.solved = true;
  r.grid = grid_;
  r.fstat = fstat_;
  read_elements(wanted, r);
  Vec3 f{}, m{}, creep{};
  check(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, f.data(), m.data()));
  double approach = 0;
  check(rollcon_contact_get_motion(contact, &approach, creep.data()));
  const Turn turn{std::cos(chi_), std::sin(chi_), 1};
  r.fn = -f[2];
  r.tx = turn.x(f[0], f[1]);
  r.ty = turn.y(f[0], f[1]);
  r.mz = -m[2];
  r.mx = turn.x(m[0], m[1]);
  r.my = turn.y(m[0], m[1]);
  r.pen = approach + row_offset()[2];
  r.cphi = -creep[2];
  r.cksi = turn.x(creep[0], creep[1]) - r.cphi * wanted.spinyo;
  r.ceta = turn.y(creep[0], creep[1]) + r.cphi * wanted.spinxo;
  if (lattice_ == Lattice::point) {
    // Displacements are those of the centre; the approach and shifts that were found belong to it, too. A particle that
    // rolls steadily comes from a step ahead, where it was displaced already.
    const double x = turn.c * grid_.xc + turn.s * grid_.yc, y = turn.c * grid_.yc - turn.s * grid_.xc;
    const double places[4] = {x, y, x + wanted.dq, y};
    double u1[6], u2[6];
    check(rollcon_contact_get_displacements_at(contact, ROLLCON_BODY1, 2, places, u1));
    check(rollcon_contact_get_displacements_at(contact, ROLLCON_BODY2, 2, places, u2));
    const auto u = [&](int at, auto part) {
      return (turn.*part)(u1[3 * at] - u2[3 * at], u1[3 * at + 1] - u2[3 * at + 1]);
    };
    const double ux = u(0, &Turn::x), uy = u(0, &Turn::y);
    if (pushed(wanted)) {
      const bool steady = wanted.tang == 3;
      const double step = wanted.tang == 1 ? 1 : wanted.dq;
      r.cksi = stuck_ ? wanted.cksi : -(ux - (steady ? u(1, &Turn::x) : 0)) / step;
      r.ceta = wanted.force == 2 ? -(uy - (steady ? u(1, &Turn::y) : 0)) / step : wanted.ceta;
      r.cphi = wanted.cphi;
      r.division[0] = stuck_ || std::hypot(wanted.fx, wanted.force == 2 ? wanted.fy : 0) < 1 ? 1 : 2;
      r.sx[0] = r.sy[0] = r.wx[0] = r.wy[0] = 0;
    }
    r.ux[0] = ux;
    r.uy[0] = uy;
    r.un[0] = u2[2] - u1[2];
    r.pen = r.un[0] + r.h[0];
    r.rim = 0;
  }
  // A single element that sticks is pushed by sliding far.
  if (!pushed(wanted) || r.division[0] == 2) check(rollcon_contact_get_stat(contact, "friction_power", &r.power));
  r.temp1.clear();
  r.temp2.clear();
  if (heat_) {
    const auto temperature = field(ROLLCON_FIELD_TEMPERATURE, 2);
    for (int j = 0; j < grid_.my; ++j)
      for (int i = 0; i < grid_.mx; ++i) {
        r.temp1.push_back(temperature[2 * node(i, j) + 1]);
        r.temp2.push_back(temperature[2 * node(i, j)]);
      }
  }
  double iterations = 0;
  check(rollcon_contact_get_stat(contact, "iterations", &iterations));
  r.iterations = int(iterations);
  r.sensitivities = {};
  if (wanted.sensitivities) read_sensitivities(r);
}

/// Derivatives of fn, fx, fy and mz by approach and creepages: those by what was prescribed, J = dF/dp and K = dq/dp,
/// give J K^-1.
void ContactSolver::read_sensitivities(ContactResult& r) const {
  static const int parameters[] = {ROLLCON_NORMAL, ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_SPIN};
  const double c = std::cos(chi_), s = std::sin(chi_);
  double J[4][4], K[4][8] = {};
  for (int k = 0; k < 4; ++k) {
    double f[3], m[3], approach = 0, creep[3];
    if (rollcon_contact_get_sensitivity(contact_.get(), parameters[k], f, m, &approach, creep) < 0) return;
    const double forces[4] = {-f[2], -(c * f[0] - s * f[1]), -(s * f[0] + c * f[1]), -m[2]};
    const double motions[4] = {approach, -(c * creep[0] - s * creep[1]), -(s * creep[0] + c * creep[1]), -creep[2]};
    for (int i = 0; i < 4; ++i) {
      J[i][k] = forces[i];
      K[i][k] = motions[i];
    }
  }
  for (int i = 0; i < 4; ++i) K[i][4 + i] = 1;
  for (int i = 0; i < 4; ++i) {  // Gauss and Jordan
    int pivot = i;
    for (int k = i + 1; k < 4; ++k)
      if (std::abs(K[k][i]) > std::abs(K[pivot][i])) pivot = k;
    if (!(std::abs(K[pivot][i]) > 0)) return;
    std::swap_ranges(K[i], K[i] + 8, K[pivot]);
    for (int k = 0; k < 4; ++k) {
      const double factor = k == i ? 0 : K[k][i] / K[i][i];
      for (int l = 0; l < 8; ++l) K[k][l] -= factor * K[i][l];
    }
  }
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += J[row][k] * K[k][4 + column] / K[k][k];
      const bool relative = (row == 1 || row == 2) && r.fstat * r.fn > 0;
      r.sensitivities[size_t(row + 4 * column)] = relative ? sum / (r.fstat * r.fn) : sum;
    }
}

}  // namespace cntc
