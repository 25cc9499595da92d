#include "contact/newton/friction_limit.hpp"

#include <algorithm>
#include <cmath>

#include "contact/laws/friction_law.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double settled = 1e-3;  // normal residual below which pressures are judged
// Kinks have corners: a node at the very centre about which all others turn. They are rounded off by so much of the
// mean, which raises h by less than that over the number of nodes.
constexpr double rounded = 1e-5;
constexpr double at_limit = 1 - 1e-12;
constexpr int most_steps = 60;
constexpr double small_step = 1e-12;  // relative decrease of h
constexpr std::array<int, 3> motions{xi1, xi2, spin};

using Three = std::array<double, 3>;

double dot3(const Three& a, const Three& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool takes_away(const Problem& p, std::size_t k) {
  return p.weight[k] < -1e-9 * std::abs(p.cell_area[k]);
}

/// Holds a loaded node: its load rows of both components and its slip by unit motions, where what it carries is the
/// unit disk.
struct Node {
  Three row[2];
  Three slip[2];
  double sign;  ///< sign of its power
};

/// Searches the limit; spin and moment count by the frame's length.
class Limit {
 public:
  Limit(const Problem& p, const Prescribed& given, const std::vector<double> (&lambda)[3])
      : problem_(p), given_(given) {
    for (std::size_t i = 0; i < 3; ++i) unit_[i] = motions[i] == spin ? 1 / p.length : 1;
    double scale = 1;
    if (given.by_force[approach]) {  // scaled to the load that will be carried in the end
      const double carried = load_on_body1(p, approach, lambda).value;
      if (carried > 0) scale = given.value[approach] / carried;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto m = at(motions[i]);
      if (!given.by_force[m]) continue;
      const double by_pressures = load_of_pressures(p, motions[i], lambda[2]);
      loads_[i] = (given.value[m] - scale * by_pressures) * unit_[i];
    }
    for (std::size_t k = 0; k < at(p.nodes); ++k) {
      const double bound = -scale * given.coefficient(p.mu, k) * lambda[2][k];
      if (bound > 0) add(k, -scale * lambda[2][k]);
    }
  }

  const Three& loads() const { return loads_; }

  /// Returns h(a) of a direction, exactly.
  double power(const Three& a) const {
    double sum = 0;
    for (const Node& n : nodes_) sum += n.sign * std::hypot(dot3(n.row[0], a), dot3(n.row[1], a));
    return sum;
  }
  /// Returns the power of the tractions of nodes that slide with a.
  double power_of_sliding(const Three& a) const {
    double sum = 0;
    for (const Node& n : nodes_) {
      const double s1 = dot3(n.slip[0], a), s2 = dot3(n.slip[1], a), speed = std::hypot(s1, s2);
      if (speed > 0) sum += (dot3(n.row[0], a) * s1 + dot3(n.row[1], a) * s2) / speed;
    }
    return sum;
  }
  /// Finds the direction a with a.to = |to| and the least h(a); to is not zero. It stays among the motions whose loads
  /// are prescribed and `wanted`.
  Three least(const Three& to, const std::array<bool, 3>& wanted) const;

 private:
  void add(std::size_t k, double pressure) {
    Node n{};
    const auto most = problem_.law->capacity(given_.coefficient(problem_.mu, k), pressure);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!given_.by_force[at(motions[i])]) continue;
      const auto row = problem_.load_row(motions[i], k);
      const auto column = problem_.slip_column(motions[i], k);
      for (std::size_t c = 0; c < 2; ++c) {
        n.row[c][i] = (most[0][c] * row[0] + most[1][c] * row[1]) * unit_[i];
        n.slip[c][i] = (most[0][c] * column[0] + most[1][c] * column[1]) * unit_[i];
      }
    }
    // Where shape functions are negative on the whole (corners of quad8) a node's pressure takes away from the load:
    // friction there takes away from what friction carries, too. Tractions of such a node alone might add to it, but
    // then the traction between the nodes is far beyond mu p: |Ft| <= mu Fn is to hold for the pressure that is
    // integrated.
    n.sign = takes_away(problem_, k) ? -1 : 1;
    nodes_.push_back(n);
  }

  /// Holds h and its derivatives along two directions, kinks rounded off by `round`.
  struct Value {
    double h = 0, slope[2] = {}, curve[2][2] = {};
  };
  Value value(const Three& a, const Three (&along)[2], std::size_t count, double round) const;

  const Problem& problem_;
  const Prescribed& given_;
  std::vector<Node> nodes_;
  Three loads_{}, unit_{};
};

Limit::Value Limit::value(const Three& a, const Three (&along)[2], std::size_t count, double round) const {
  Value v;
  for (const Node& n : nodes_) {
    const double v1 = dot3(n.row[0], a), v2 = dot3(n.row[1], a);
    const double size = std::sqrt(v1 * v1 + v2 * v2 + round * round);
    if (!(size > 0)) continue;
    v.h += n.sign * size;
    double d[2][2], along_v[2];
    for (std::size_t i = 0; i < count; ++i) {
      d[i][0] = dot3(n.row[0], along[i]);
      d[i][1] = dot3(n.row[1], along[i]);
      along_v[i] = (d[i][0] * v1 + d[i][1] * v2) / size;
      v.slope[i] += n.sign * along_v[i];
    }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        v.curve[i][j] += n.sign * (d[i][0] * d[j][0] + d[i][1] * d[j][1] - along_v[i] * along_v[j]) / size;
  }
  return v;
}

// Uses Newton's method in the one or two directions that leave a.to as it is.
Three Limit::least(const Three& to, const std::array<bool, 3>& wanted) const {
  const double length = std::sqrt(dot3(to, to));
  Three a{};
  for (std::size_t i = 0; i < 3; ++i) a[i] = to[i] / length;
  const Three normal = a;
  Three along[2] = {};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3 && count < 2; ++i) {
    if (!wanted[i]) continue;
    Three e{};
    e[i] = 1;
    const auto project = [&](const Three& off) {
      const double part = dot3(e, off);
      for (std::size_t c = 0; c < 3; ++c) e[c] -= part * off[c];
    };
    for (int twice = 0; twice < 2; ++twice) {
      project(normal);
      if (count > 0) project(along[0]);
    }
    const double left = std::sqrt(dot3(e, e));
    if (!(left > 0.1)) continue;  // two of three directions are well off the loads'
    for (double& c : e) c /= left;
    along[count++] = e;
  }
  if (count == 0 || nodes_.empty()) return a;
  const double round = rounded * power(a) / static_cast<double>(nodes_.size());
  Value now = value(a, along, count, round);
  for (int step = 0; step < most_steps; ++step) {
    // The curvature gets a little more, as it vanishes where every node moves along its traction.
    const double trace = now.curve[0][0] + now.curve[1][1];
    const double more = 1e-9 * trace + 1e-14 * std::abs(now.h);
    const double c00 = now.curve[0][0] + more, c11 = now.curve[1][1] + more, c01 = now.curve[0][1];
    double move[2] = {-now.slope[0] / c00, 0};
    if (count == 2) {
      const double det = c00 * c11 - c01 * c01;
      if (!(c00 > 0 && det > 0)) {
        for (std::size_t i = 0; i < 2; ++i) move[i] = -now.slope[i] / std::abs(trace + more);
      } else {
        move[0] = (-now.slope[0] * c11 + now.slope[1] * c01) / det;
        move[1] = (-now.slope[1] * c00 + now.slope[0] * c01) / det;
      }
    }
    const double falls = now.slope[0] * move[0] + now.slope[1] * move[1];
    if (!(falls < -small_step * std::abs(now.h))) break;
    // A move is limited where h is nearly flat.
    const double far = std::hypot(move[0], move[1]), most = 4 * (1 + std::sqrt(dot3(a, a)));
    double part = far > most ? most / far : 1;
    bool better = false;
    for (int halving = 0; halving < 30 && !better; ++halving, part /= 2) {
      Three next = a;
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c) next[c] += part * move[i] * along[i][c];
      const Value there = value(next, along, count, round);
      better = there.h <= now.h + 1e-4 * part * falls;
      if (better) a = next, now = there;
    }
    if (!better) break;
  }
  return a;
}

double over(double loads, double friction) {
  if (!(loads > 0)) return 0;
  return friction > 0 ? loads / friction : INFINITY;
}

double share_of(const Limit& limit, Three loads, const std::array<bool, 3>& wanted, Three* direction = nullptr) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!wanted[i]) loads[i] = 0;
  const double length = std::sqrt(dot3(loads, loads));
  if (!(length > 0)) return 0;
  const Three a = limit.least(loads, wanted);
  if (direction) *direction = a;
  return over(length, limit.power(a));
}

}  // namespace

FrictionShare share_of_friction(const Problem& p, const Prescribed& given, const std::vector<double> (&lambda)[3]) {
  FrictionShare share;
  const bool f1 = given.by_force[xi1], f2 = given.by_force[xi2], m = given.by_force[spin];
  share.by_force = f1 || f2;
  share.by_moment = m;
  if (!f1 && !f2 && !m) return share;
  const Limit limit(p, given, lambda);
  share.together = share_of(limit, limit.loads(), {f1, f2, m}, &share.direction);
  if (share.by_force) share.force = m ? share_of(limit, limit.loads(), {f1, f2, false}) : share.together;
  if (m) share.moment = share.by_force ? share_of(limit, limit.loads(), {false, false, true}) : share.together;
  const double loads = dot3(limit.loads(), share.direction);
  share.sliding = over(loads, limit.power_of_sliding(share.direction));
  return share;
}

// Sums friction, which acts along the force on a flat frame if it is the same in all directions.
double share_of_forces(const Problem& p, const Prescribed& given, const std::vector<double> (&lambda)[3]) {
  const bool f1 = given.by_force[xi1], f2 = given.by_force[xi2];
  if (!f1 && !f2) return 0;
  if (!p.turn.empty() || !p.law->isotropic()) {
    const Limit limit(p, given, lambda);
    return share_of(limit, limit.loads(), {f1, f2, false});
  }
  double friction = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k)
    friction -= std::min(lambda[2][k], 0.0) * given.coefficient(p.mu, k) * p.weight[k];
  if (given.by_force[approach]) {
    const double carried = load_on_body1(p, approach, lambda).value;
    if (carried > 0) friction *= given.value[approach] / carried;
  }
  return over(std::hypot(f1 ? given.value[xi1] : 0, f2 ? given.value[xi2] : 0), friction);
}

bool friction_overdrawn(const Problem& p, const Prescribed& given, const std::vector<double> (&lambda)[3]) {
  if (!given.by_force[xi1] && !given.by_force[xi2] && !given.by_force[spin]) return false;
  for (std::size_t k = 0; k < at(p.nodes); ++k)
    if (lambda[2][k] < 0 && takes_away(p, k)) return share_of_friction(p, given, lambda).together >= at_limit;
  return false;
}

bool pressures_settled(const Problem& p, const Prescribed& given, const std::vector<double> (&lambda)[3],
                       double residual) {
  if (!(residual < settled)) return false;
  if (!given.by_force[approach]) return true;
  const double load = given.value[approach];
  return std::abs(load_on_body1(p, approach, lambda).value - load) <= settled * load;
}

bool friction_sum_known(const Problem& p, const Prescribed& given, const std::vector<double>& normal) {
  if (!p.turn.empty() || !given.by_force[approach]) return false;
  double mu = -1;
  for (std::size_t k = 0; k < p.mu.size(); ++k) {
    if (!(normal[k] < 0)) continue;
    const double own = given.coefficient(p.mu, k);
    if (mu >= 0 && own != mu) return false;
    mu = own;
  }
  return true;
}

}  // namespace rollcon
