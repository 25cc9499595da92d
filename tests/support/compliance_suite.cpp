#include "support/compliance_suite.hpp"

#include <ostream>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "support/frame_extent.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Gives tractions (t1, t2, n) at a node from its place in the frame, in [-1, 1] across it.
using Field = std::function<Vec3(double x, double y)>;

double bump(double x, double y) {
  return std::max(0.0, 1 - x * x) * std::max(0.0, 1 - y * y);
}

/// Returns smooth loads that vanish at the frame's rim: each component alone and mixtures.
std::vector<Field> smooth_fields() {
  std::vector<Field> fields;
  for (std::size_t c = 0; c < 3; ++c)
    for (int kind = 0; kind < 4; ++kind)
      fields.push_back([c, kind](double x, double y) {
        const double shape[4] = {1, x, y, x * y};
        Vec3 t{0, 0, 0};
        t[c] = bump(x, y) * shape[kind];
        return t;
      });
  return fields;
}

std::vector<double> nodal(const Frame& frame, const Field& field) {
  const Extent e(frame);
  std::vector<double> t;
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    const Vec3 v = field((frame.x[k] - e.x0) / e.half_x, (frame.y[k] - e.y0) / e.half_y);
    t.insert(t.end(), v.begin(), v.end());
  }
  return t;
}

std::vector<double> random_tractions(const Frame& frame, std::uint32_t seed) {
  frames::Random random(seed);
  std::vector<double> t(3 * frame.x.size());
  for (double& v : t) v = random();
  return t;
}

std::vector<double> displacements(const PlacedCompliance& p, const std::vector<double>& t) {
  std::vector<double> u(3 * p.frame->x.size());
  p.compliance->apply({p.frame->x, p.frame->y}, t.data(), u.data());
  return u;
}

double largest(const std::vector<double>& v) {
  double m = 0;
  for (const double x : v) m = std::max(m, std::abs(x));
  return m;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double m = 0;
  for (std::size_t k = 0; k < a.size(); ++k) m = std::max(m, std::abs(a[k] - b[k]));
  return m;
}

/// Computes the work of tractions on displacements over the frame.
class Work {
 public:
  explicit Work(const PlacedCompliance& p) : p_(p) {
    const Frame& f = *p.frame;
    const PlaneRule triangle = triangle_rule(8), square = square_rule(9);
    for (std::int64_t e = 0; e < f.elements(); ++e) {
      const ElementType type = f.mesh.type[static_cast<std::size_t>(e)];
      const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
      const auto n = f.mesh.element(e);
      for (std::size_t q = 0; q < rule.size(); ++q) {
        Point point;
        Shape s;
        evaluate_shape(type, rule.xi[q], rule.eta[q], s);
        double x = 0, y = 0;
        Vec3 u{0, 0, 0}, v{0, 0, 0};
        for (std::size_t a = 0; a < n.size(); ++a) {
          const auto k = static_cast<std::size_t>(n[a]);
          x += s.value[a] * f.x[k];
          y += s.value[a] * f.y[k];
          u = u + s.d_xi[a] * f.mesh.node[k];
          v = v + s.d_eta[a] * f.mesh.node[k];
          point.share.emplace_back(k, s.value[a]);
        }
        point.weight = rule.w[q] * length(cross(u, v));
        x_.push_back(x);
        y_.push_back(y);
        point_.push_back(std::move(point));
      }
    }
  }

  /// Says where displacements between nodes come from: the compliance itself, or those of the nodes by the frame's
  /// shape functions. The entry work[i][j] is that of load i on the displacements of load j.
  enum class Between { compliance, shape_functions };
  std::vector<std::vector<double>> matrix(const std::vector<std::vector<double>>& loads,
                                          Between between = Between::compliance) const {
    std::vector<std::vector<double>> work(loads.size(), std::vector<double>(loads.size(), 0.0));
    std::vector<double> u(3 * x_.size());
    for (std::size_t j = 0; j < loads.size(); ++j) {
      if (between == Between::compliance)
        p_.compliance->apply({x_, y_}, loads[j].data(), u.data());
      else
        interpolate(displacements(p_, loads[j]), u);
      for (std::size_t i = 0; i < loads.size(); ++i)
        for (std::size_t q = 0; q < point_.size(); ++q)
          for (const auto& [k, share] : point_[q].share)
            for (std::size_t c = 0; c < 3; ++c)
              work[i][j] += point_[q].weight * share * loads[i][3 * k + c] * u[3 * q + c];
    }
    return work;
  }

 private:
  struct Point {
    double weight = 0;
    std::vector<std::pair<std::size_t, double>> share;
  };

  void interpolate(const std::vector<double>& at_nodes, std::vector<double>& u) const {
    for (std::size_t q = 0; q < point_.size(); ++q)
      for (std::size_t c = 0; c < 3; ++c) {
        u[3 * q + c] = 0;
        for (const auto& [k, share] : point_[q].share) u[3 * q + c] += share * at_nodes[3 * k + c];
      }
  }

  const PlacedCompliance& p_;
  std::vector<double> x_, y_;
  std::vector<Point> point_;
};

std::vector<std::vector<double>> smooth_loads(const Frame& frame) {
  std::vector<std::vector<double>> loads;
  for (const Field& field : smooth_fields()) loads.push_back(nodal(frame, field));
  return loads;
}

/// Returns the largest difference of work[i][j] and work[j][i], over the geometric mean of the loads' own work.
double asymmetry(const std::vector<std::vector<double>>& work) {
  double error = 0;
  for (std::size_t i = 0; i < work.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      error = std::max(error, std::abs(work[i][j] - work[j][i]) / std::sqrt(work[i][i] * work[j][j]));
  return error;
}

Pose turned_and_shifted() {
  const double c = std::cos(0.8), s = std::sin(0.8), d = std::cos(0.5), e = std::sin(0.5);
  Pose pose;
  pose.rotation = {{{c, -s * d, s * e}, {s, c * d, -c * e}, {0, e, d}}};
  pose.translation = {30, -20, 50};
  return pose;
}

}  // namespace

void PrintTo(const ComplianceCase& c, std::ostream* out) {
  *out << c.name;
}

void check_superposition(const ComplianceCase& c) {
  const PlacedCompliance p = c.make(0, {});
  const auto a = random_tractions(*p.frame, 1), b = random_tractions(*p.frame, 2);
  std::vector<double> sum(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) sum[k] = 3 * a[k] - 0.5 * b[k];
  const auto ua = displacements(p, a), ub = displacements(p, b), us = displacements(p, sum);
  std::vector<double> expected(ua.size());
  for (std::size_t k = 0; k < ua.size(); ++k) expected[k] = 3 * ua[k] - 0.5 * ub[k];
  expect_error(c.name + ": superposition", difference(us, expected) / largest(us), c.superposition);

  // The points are the nodes, and points between them.
  std::vector<double> x = p.frame->x, y = p.frame->y;
  const auto nodes = p.frame->mesh.element(0);
  double mx = 0, my = 0;
  for (const std::int32_t k : nodes) {
    mx += p.frame->x[static_cast<std::size_t>(k)] / static_cast<double>(nodes.size());
    my += p.frame->y[static_cast<std::size_t>(k)] / static_cast<double>(nodes.size());
  }
  x.push_back(mx);
  y.push_back(my);
  const std::size_t n = p.frame->x.size();
  std::vector<double> dense[3][3], direct(3 * x.size()), by_block(3 * x.size(), 0.0);
  ComplianceBlock block;
  block.stride = static_cast<std::ptrdiff_t>(n);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      dense[i][j].assign(x.size() * n, 0.0);
      const bool wanted = p.compliance->couples() || (i == 2) == (j == 2);
      block.a[i][j] = wanted ? dense[i][j].data() : nullptr;
    }
  p.compliance->block({x, y}, block);
  p.compliance->apply({x, y}, a.data(), direct.data());
  for (std::size_t q = 0; q < x.size(); ++q)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < n; ++k) by_block[3 * q + i] += dense[i][j][q * n + k] * a[3 * k + j];
  expect_error(c.name + ": block against apply", difference(direct, by_block) / largest(direct), c.block);
}

void check_expansion(const ComplianceCase& c) {
  const PlacedCompliance here = c.make(0, {}), there = c.make(0, {turned_and_shifted(), 1, 1});
  expect_error(c.name + ": written out", expansion_error(*here.frame, *here.compliance), c.expansion);
  expect_error(c.name + ": written out, turned", expansion_error(*there.frame, *there.compliance), c.expansion);
}

void check_reciprocity(const ComplianceCase& c) {
  std::vector<double> errors;
  for (std::size_t level = 0; level < c.reciprocity.size(); ++level) {
    const PlacedCompliance p = c.make(static_cast<int>(level), {});
    const auto work = Work(p).matrix(smooth_loads(*p.frame));
    const double error = asymmetry(work);
    errors.push_back(error);
    expect_error(c.name + ": reciprocity, " + std::to_string(p.frame->nodes()) + " nodes", error, c.reciprocity[level]);
  }
  if (c.least_order > 0)
    expect_order(
        c.name + ": reciprocity",
        observed_order(errors.front(), errors.back(), std::pow(2.0, static_cast<double>(errors.size() - 1)), 1),
        c.least_order);
}

void check_nodal_reciprocity(const ComplianceCase& c) {
  if (c.nodal_reciprocity <= 0) GTEST_SKIP() << "asymmetric by its method";
  const PlacedCompliance p = c.make(0, {});
  auto loads = smooth_loads(*p.frame);
  for (const std::uint32_t seed : {7U, 8U, 9U}) loads.push_back(random_tractions(*p.frame, seed));
  const auto work = Work(p).matrix(loads, Work::Between::shape_functions);
  expect_error(c.name + ": reciprocity, nodal work", asymmetry(work), c.nodal_reciprocity);
}

std::vector<double> work_of_smooth_loads(const PlacedCompliance& p) {
  const auto work = Work(p).matrix(smooth_loads(*p.frame), Work::Between::shape_functions);
  std::vector<double> own;
  for (std::size_t i = 0; i < work.size(); ++i) own.push_back(work[i][i]);
  return own;
}

// Checks that every load does work: the symmetric part of the work matrix of twelve smooth loads is positive definite,
// and loads on single nodes do work.
void check_positive_definite(const ComplianceCase& c) {
  const PlacedCompliance p = c.make(0, {});
  auto loads = smooth_loads(*p.frame);
  const auto work = Work(p).matrix(loads);
  const std::size_t n = work.size();
  // The matrix l is the Cholesky factor of the symmetric part, scaled to a unit diagonal.
  std::vector<std::vector<double>> l(n, std::vector<double>(n, 0.0));
  double least = 1;
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_GT(work[i][i], 0) << "load " << i;
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.5 * (work[i][j] + work[j][i]) / std::sqrt(work[i][i] * work[j][j]);
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      if (i == j) {
        least = std::min(least, sum);
        ASSERT_GT(sum, 0) << "not positive definite at load " << i;
        l[i][i] = std::sqrt(sum);
      } else {
        l[i][j] = sum / l[j][j];
      }
    }
  }
  report(c.name + ": least pivot of the work matrix", least);
  EXPECT_GT(least, 1e-3);
  // Shape functions of quadratic elements change sign; their loads do work all the same.
  loads.clear();
  for (std::size_t k = 0; k < 3 * p.frame->x.size(); k += 4) {
    loads.emplace_back(3 * p.frame->x.size(), 0.0);
    loads.back()[k] = 1;
  }
  const auto single = Work(p).matrix(loads);
  double least_share = 1;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    double most = 0;
    for (std::size_t j = 0; j < loads.size(); ++j) most = std::max(most, std::abs(single[i][j]));
    least_share = std::min(least_share, single[i][i] / most);
  }
  report(c.name + ": least work of a node on itself, share of its row", least_share);
  EXPECT_GT(least_share, 0);
}

void check_placement(const ComplianceCase& c) {
  const PlacedCompliance here = c.make(0, {}), there = c.make(0, {turned_and_shifted(), 1, 1});
  const auto t = random_tractions(*here.frame, 5);
  const auto u = displacements(here, t), v = displacements(there, t);
  expect_error(c.name + ": turned and shifted", difference(u, v) / largest(u), c.placement);
}

void check_units(const ComplianceCase& c) {
  const PlacedCompliance standard = c.make(0, {});
  const auto t = random_tractions(*standard.frame, 6);
  const auto u = displacements(standard, t);
  const struct {
    const char* name;
    double length, stress;
  } units[] = {{"m, Pa", 1e-3, 1e6}, {"um, GPa", 1e3, 1e-3}, {"far away units", 1e-25, 1e35}};
  for (const auto& unit : units) {
    const PlacedCompliance other = c.make(0, {{}, unit.length, unit.stress});
    auto v = displacements(other, t);  // tractions of one unit each
    for (double& x : v) x *= unit.stress / unit.length;
    expect_error(c.name + ": in " + unit.name, difference(u, v) / largest(u), c.units);
  }
}

void check_rigid_motion(const ComplianceCase& c) {
  if (!c.moved) {
    const PlacedCompliance p = c.make(0, {});
    std::vector<double> u(3 * p.frame->x.size());
    EXPECT_FALSE(p.compliance->offset({p.frame->x, p.frame->y}, u.data()));
    return;
  }
  const auto motion = [](const Vec3& x) { return Vec3{0.2, -0.1, 0.3} + cross({0.05, 0.02, -0.04}, x); };
  const PlacedCompliance p = c.moved(motion);
  const Frame& f = *p.frame;
  std::vector<double> u(3 * f.x.size());
  ASSERT_TRUE(p.compliance->offset({f.x, f.y}, u.data()));
  double error = 0, size = 0;
  for (std::size_t k = 0; k < f.x.size(); ++k) {
    const Vec3 m = motion(f.mesh.node[k]);
    const Triad t = f.triad(k);
    const Vec3 local{dot(m, t.t1), dot(m, t.t2), dot(m, t.n)};
    size = std::max(size, length(m));
    error = std::max(error, length(Vec3{u[3 * k], u[3 * k + 1], u[3 * k + 2]} - local));
  }
  expect_error(c.name + ": carried along by what is held", error / size, c.rigid_motion);
}

}  // namespace rollcon
