// Wheels on frames that rollcon makes (flag CNTC_if_frames): totals at once, fields of elements when they are asked
// for.
#include <algorithm>
#include <cmath>

#include "calculate.hpp"
#include "vectors.hpp"
#include "wheel_solver.hpp"

namespace cntc {
namespace {

constexpr size_t values_of_node = 12;  // traction 3, slip 2, rigid slip 2, displacement 3, gap, friction

struct Node {
  double x = 0, y = 0;
  std::array<double, values_of_node> v{};
};
using Line = std::vector<Node>;

double mix(double a, double b, double t) {
  return (1 - t) * a + t * b;
}

/// Nodes of strips or of a lattice: lines at ascending y, along which x ascends.
std::vector<Line> lines_of(rollcon_contact* contact) {
  int64_t n = 0;
  check(rollcon_contact_get_size(contact, &n, nullptr));
  std::vector<Node> nodes(static_cast<size_t>(n));
  const auto take = [&](int field, int axes, size_t values, auto put) {
    std::vector<double> v(values * nodes.size());
    check(rollcon_contact_get_field(contact, field, axes, int64_t(v.size()), v.data(), nullptr));
    for (size_t k = 0; k < nodes.size(); ++k) put(nodes[k], &v[values * k]);
  };
  const auto copy = [](size_t at, size_t count) {
    return [=](Node& node, const double* v) { std::copy_n(v, count, node.v.begin() + long(at)); };
  };
  take(ROLLCON_FIELD_POINT, ROLLCON_GLOBAL, 3, [](Node& node, const double* v) {
    node.x = v[0];
    node.y = v[1];
  });
  take(ROLLCON_FIELD_TRACTION, ROLLCON_LOCAL, 3, copy(0, 3));
  take(ROLLCON_FIELD_SLIP, ROLLCON_LOCAL, 2, copy(3, 2));
  take(ROLLCON_FIELD_RIGID_SLIP, ROLLCON_LOCAL, 2, copy(5, 2));
  take(ROLLCON_FIELD_DISPLACEMENT1, ROLLCON_LOCAL, 3, copy(7, 3));
  take(ROLLCON_FIELD_DISPLACEMENT2, ROLLCON_LOCAL, 3, [](Node& node, const double* v) {
    for (size_t i = 0; i < 3; ++i) node.v[7 + i] -= v[i];
  });
  take(ROLLCON_FIELD_GAP, ROLLCON_LOCAL, 1, copy(10, 1));
  take(ROLLCON_FIELD_FRICTION, ROLLCON_LOCAL, 1, copy(11, 1));
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.y < b.y; });
  const double apart = nodes.empty() ? 0 : 1e-7 * (nodes.back().y - nodes.front().y);
  std::vector<Line> lines;
  for (const Node& node : nodes) {
    if (lines.empty() || node.y - lines.back().back().y > apart) lines.emplace_back();
    lines.back().push_back(node);
  }
  for (Line& line : lines) std::sort(line.begin(), line.end(), [](const Node& a, const Node& b) { return a.x < b.x; });
  return lines;
}

/// Value on a line at a share of its length.
std::array<double, values_of_node> on_line(const Line& line, double share) {
  const double x = mix(line.front().x, line.back().x, share);
  size_t k = 1;
  while (k + 1 < line.size() && line[k].x < x) ++k;
  if (line.size() < 2 || !(line[k].x > line[k - 1].x)) return line.front().v;
  const double t = std::clamp((x - line[k - 1].x) / (line[k].x - line[k - 1].x), 0., 1.);
  std::array<double, values_of_node> v{};
  for (size_t i = 0; i < v.size(); ++i) v[i] = mix(line[k - 1].v[i], line[k].v[i], t);
  return v;
}

/// Values at a point, at the same share of the length of both lines beside it; false beside all lines.
bool at_point(const std::vector<Line>& lines, double x, double y, std::array<double, values_of_node>& v) {
  size_t k = 1;
  while (k + 1 < lines.size() && lines[k].front().y < y) ++k;
  if (lines.size() < 2) return false;
  const Line &a = lines[k - 1], &b = lines[k];
  const double t = (y - a.front().y) / (b.front().y - a.front().y);
  if (t < 0 || t > 1) return false;
  const double first = mix(a.front().x, b.front().x, t), last = mix(a.back().x, b.back().x, t);
  if (x < first || x > last || !(last > first)) return false;
  const auto p = on_line(a, (x - first) / (last - first)), q = on_line(b, (x - first) / (last - first));
  for (size_t i = 0; i < v.size(); ++i) v[i] = mix(p[i], q[i], t);
  return true;
}

}  // namespace

int WheelSolver::solve_on_frames(Problem& p, std::string& why) {
  const Inputs& in = p.in;
  if (in.friction.law != 0 || in.friction.variation == 2 || in.digits.tang == 2 || in.digits.mater != 0 ||
      in.digits.heat != 0 || in.digits.sens >= 2)
    throw Failure(CNTC_err_other,
                  "frames of rollcon (flag 2901) are for Coulomb friction in steady rolling, without layer, heat and "
                  "sensitivities: set it to 0");
  rollcon_wheelrail* search = search_.get();
  check(rollcon_wheelrail_set_real(search, "accuracy", .01));
  check(rollcon_wheelrail_set_int(search, "conformal", in.digits.discns == 4));
  const int status = this->search(p);
  if (status > ROLLCON_OK) why = rollcon_last_caveat();
  int64_t n = 0;
  check(rollcon_wheelrail_get_patch_count(search, &n));
  patches.clear();
  for (int32_t k = 0; k < n; ++k) {
    const auto stat = [&](const char* name) {
      double v = 0;
      check(rollcon_wheelrail_get_patch_stat(search, k, name, &v));
      return v;
    };
    const double share = stat("share");
    if (!(share * stat("normal_force") > 0)) continue;
    WheelPatch patch;
    patch.reference = {stat("x") - set_.position[0], stat("y"), stat("z")};
    patch.delta = stat("angle");
    patch.overlap = stat("overlap");
    patch.number = k;
    double origin[3], axes[9];
    check(rollcon_wheelrail_get_patch_axes(search, k, origin, axes));
    if (roller_ > 0) patch.tilt = std::asin(axes[6]);
    stand_patch(patch);
    set_velocities(in, patch);
    set_creepages(patch);
    ContactResult r;
    r.solved = r.deferred = true;
    r.veloc = patch.wanted.veloc;
    r.fstat = in.digits.tang == 0 ? 0 : rest_friction(in.friction.rows[0], 0);
    r.pen = patch.overlap;
    r.cksi = -stat("longitudinal_creepage");
    r.ceta = -stat("lateral_creepage");
    r.cphi = -stat("spin");
    r.fn = share * stat("normal_force");
    r.tx = -share * stat("longitudinal_force");
    r.ty = -share * stat("lateral_force");
    r.mz = -share * stat("spin_moment");
    r.pmax = stat("max_pressure");
    r.power = share * stat("friction_power");
    patches.push_back(std::move(patch));
    p.patches.push_back(std::move(r));
    ContactResult& last = p.patches.back();
    if (sign < 0)
      for (double* v : {&last.ty, &last.mz, &last.ceta, &last.cphi}) *v = -*v;
  }
  solved = true;
  return status == ROLLCON_NOT_CONVERGED ? CNTC_err_tang : 0;
}

void WheelSolver::fill_elements(Problem& p, size_t patch_number) {
  WheelPatch& patch = patches[patch_number];
  ContactResult& r = p.patches[patch_number];
  r.deferred = false;
  double origin[3], axes[9];
  rollcon_contact* contact = nullptr;
  check(rollcon_wheelrail_get_patch_axes(search_.get(), patch.number, origin, axes));
  origin[0] -= set_.position[0];
  check(rollcon_wheelrail_get_contact(search_.get(), patch.number, &contact));
  const ContactHandle holder(contact);
  read_extents(contact, origin, axes, patch);
  lay_grid(p.in, patch);
  const Grid& g = r.grid = patch.wanted.grid;
  r.dq = g.dx;
  const std::vector<Line> lines = lines_of(contact);
  const size_t n = size_t(g.size());
  for (auto* v : {&r.h, &r.mu, &r.px, &r.py, &r.pn, &r.ux, &r.uy, &r.un, &r.sx, &r.sy, &r.wx, &r.wy}) v->assign(n, 0);
  r.division.assign(n, 0);
  const Vec3 t1 = {axes[0], axes[1], axes[2]}, t2 = {axes[3], axes[4], axes[5]};
  for (size_t k = 0; k < n; ++k) {
    const Vec3 at = patch.reference + g.x(int(k % size_t(g.mx))) * patch.along() +
                    g.y(int(k / size_t(g.mx))) * patch.across() - Vec3{origin[0], origin[1], origin[2]};
    std::array<double, values_of_node> v{};
    if (!at_point(lines, dot(at, t1), dot(at, t2), v) || !(v[2] < 0)) continue;
    r.px[k] = -v[0];
    r.py[k] = -v[1];
    r.pn[k] = -v[2];
    r.sx[k] = -v[3] / r.veloc;
    r.sy[k] = -v[4] / r.veloc;
    r.wx[k] = v[5] / r.veloc;
    r.wy[k] = v[6] / r.veloc;
    r.ux[k] = -v[7];
    r.uy[k] = -v[8];
    r.un[k] = -v[9];
    r.h[k] = v[10] - r.un[k] + r.pen;
    r.mu[k] = v[11];
    r.division[k] = std::hypot(v[0], v[1]) < .999 * v[11] * r.pn[k] ? 1 : 2;
  }
  if (sign < 0) mirror_elements(r);
}

}  // namespace cntc
