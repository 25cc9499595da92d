#include "bodies/halfspace/brute_force.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/halfspace/halfspace.hpp"

namespace rollcon::brute_force {
namespace {

using Real = double;
struct Point {
  Real u, v;
};
using Values = std::array<std::array<Real, max_element_nodes>, 5>;

void shape(ElementType type, Point p, Real* n, Real* nu, Real* nv) {
  const Real u = p.u, v = p.v, w = 1 - u - v;
  auto line = [](int k, Real t) {  // quadratic Lagrange functions of -1, 0, 1 and slopes
    if (k == 0) return std::array<Real, 2>{t * (t - 1) / 2, t - 0.5};
    if (k == 1) return std::array<Real, 2>{1 - t * t, -2 * t};
    return std::array<Real, 2>{t * (t + 1) / 2, t + 0.5};
  };
  static constexpr int column[9] = {0, 2, 2, 0, 1, 2, 1, 0, 1}, row[9] = {0, 0, 2, 2, 0, 1, 2, 1, 1};
  switch (type) {
    case ElementType::tri3:
      n[0] = w, n[1] = u, n[2] = v;
      nu[0] = -1, nu[1] = 1, nu[2] = 0;
      nv[0] = -1, nv[1] = 0, nv[2] = 1;
      return;
    case ElementType::tri6:
      n[0] = w * (2 * w - 1), n[1] = u * (2 * u - 1), n[2] = v * (2 * v - 1);
      n[3] = 4 * w * u, n[4] = 4 * u * v, n[5] = 4 * v * w;
      nu[0] = 1 - 4 * w, nu[1] = 4 * u - 1, nu[2] = 0;
      nu[3] = 4 * (w - u), nu[4] = 4 * v, nu[5] = -4 * v;
      nv[0] = 1 - 4 * w, nv[1] = 0, nv[2] = 4 * v - 1;
      nv[3] = -4 * u, nv[4] = 4 * u, nv[5] = 4 * (w - v);
      return;
    case ElementType::quad4:
      for (int i = 0; i < 4; ++i) {
        const Real a = column[i] - 1, b = row[i] - 1;
        n[i] = (1 + a * u) * (1 + b * v) / 4;
        nu[i] = a * (1 + b * v) / 4;
        nv[i] = b * (1 + a * u) / 4;
      }
      return;
    case ElementType::quad9:
    case ElementType::quad8: {
      Real m[9], mu[9], mv[9];
      for (int i = 0; i < 9; ++i) {
        const auto f = line(column[i], u), g = line(row[i], v);
        m[i] = f[0] * g[0], mu[i] = f[1] * g[0], mv[i] = f[0] * g[1];
      }
      const int count = node_count(type);
      for (int i = 0; i < count; ++i) {
        // The serendipity functions take the centre's function to the corners by -1/4, to the middles by 1/2.
        const Real share = count == 9 ? 0 : i < 4 ? -0.25 : 0.5;
        n[i] = m[i] + share * m[8], nu[i] = mu[i] + share * mu[8], nv[i] = mv[i] + share * mv[8];
      }
      return;
    }
  }
}

/// Computes Gauss-Legendre rules on [0, 1] by Newton's method.
struct Line {
  std::vector<Real> x, w;
  explicit Line(int n) {
    const Real pi = std::acos(-1.0);
    for (int k = 1; k <= n; ++k) {
      Real t = std::cos(pi * (k - 0.25) / (n + 0.5)), slope = 1;
      for (int it = 0; it < 50; ++it) {
        Real p0 = 1, p1 = t;
        for (int j = 2; j <= n; ++j) {
          const Real p2 = ((2 * j - 1) * t * p1 - (j - 1) * p0) / j;
          p0 = p1, p1 = p2;
        }
        slope = n * (t * p1 - p0) / (t * t - 1);
        t -= p1 / slope;
      }
      x.push_back((1 + t) / 2);
      w.push_back(1 / ((1 - t * t) * slope * slope));
    }
  }
};

class Adaptive {
 public:
  Adaptive(const Element& e, Real px, Real py, std::optional<Reference> on)
      : e_(e), nodes_(node_count(e.type)), px_(px), py_(py) {
    if (on) {
      px_ = py_ = 0;
      Real n[9], nu[9], nv[9];
      shape(e.type, {on->xi, on->eta}, n, nu, nv);
      for (int i = 0; i < nodes_; ++i) {
        px_ += n[i] * e.x[static_cast<std::size_t>(i)];
        py_ += n[i] * e.y[static_cast<std::size_t>(i)];
      }
    }
    // The integrals' scale is the longer diagonal of the nodes' box, if the observer is near.
    const auto [x0, x1] = std::minmax_element(e.x.begin(), e.x.end());
    const auto [y0, y1] = std::minmax_element(e.y.begin(), e.y.end());
    const Real distance = std::hypot(px_ - (*x0 + *x1) / 2, py_ - (*y0 + *y1) / 2);
    Real area = 0;
    for (std::size_t i = 0, n = static_cast<std::size_t>(corner_count(e.type)); i < n; ++i)
      area += (e.x[i] * e.y[(i + 1) % n] - e.x[(i + 1) % n] * e.y[i]) / 2;
    size_ = area / std::max(distance, std::hypot(*x1 - *x0, *y1 - *y0) / 2);
    const bool triangle = corner_count(e.type) == 3;
    const std::vector<Point> corner =
        triangle ? std::vector<Point>{{0, 0}, {1, 0}, {0, 1}} : std::vector<Point>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    // Triangles apex, a, b have the points apex + s (a + t (b - a) - apex).
    for (std::size_t i = 0; i < corner.size(); ++i) {
      const Point apex = on ? Point{on->xi, on->eta} : corner[0];
      if (!on && (i == 0 || i + 1 == corner.size())) continue;
      apex_ = apex, a_ = corner[i], b_ = corner[(i + 1) % corner.size()];
      area_ = (a_.u - apex.u) * (b_.v - apex.v) - (a_.v - apex.v) * (b_.u - apex.u);
      if (!(area_ > 0)) continue;
      graded_ = on.has_value();
      if (graded_)
        graded();
      else
        refine(0, 1, 0, 1, rule(0, 1, 0, 1), 0);
    }
  }
  const Values& total() const { return total_; }

 private:
  Values rule(Real s0, Real s1, Real t0, Real t1) const {
    static const Line coarse(10), fine(14);
    const Line& line = graded_ ? fine : coarse;
    Values sum{};
    for (std::size_t i = 0; i < line.x.size(); ++i)
      for (std::size_t j = 0; j < line.x.size(); ++j) {
        const Real s = s0 + (s1 - s0) * line.x[i], t = t0 + (t1 - t0) * line.x[j];
        const Point at{apex_.u + s * (a_.u - apex_.u + t * (b_.u - a_.u)),
                       apex_.v + s * (a_.v - apex_.v + t * (b_.v - a_.v))};
        Real n[9], nu[9], nv[9], x = 0, y = 0, xu = 0, xv = 0, yu = 0, yv = 0;
        shape(e_.type, at, n, nu, nv);
        for (int k = 0; k < nodes_; ++k) {
          const Real ax = e_.x[static_cast<std::size_t>(k)], ay = e_.y[static_cast<std::size_t>(k)];
          x += n[k] * ax, y += n[k] * ay;
          xu += nu[k] * ax, xv += nv[k] * ax, yu += nu[k] * ay, yv += nv[k] * ay;
        }
        const Real dx = px_ - x, dy = py_ - y, r = std::sqrt(dx * dx + dy * dy);
        const Real w = line.w[i] * line.w[j] * (s1 - s0) * (t1 - t0) * s * area_ * (xu * yv - xv * yu);
        const Real kernel[5] = {1 / r, dx * dx / (r * r * r), dx * dy / (r * r * r), dx / (r * r), dy / (r * r)};
        for (std::size_t k = 0; k < 5; ++k)
          for (std::size_t m = 0; m < static_cast<std::size_t>(nodes_); ++m) sum[k][m] += w * kernel[k] * n[m];
      }
    return sum;
  }

  /// Integrates along rays from the observer to an edge that may be very close: the edge is cut at the foot of the
  /// observer, and towards it into halves; everything is smooth along the rays.
  void graded() {
    Real n[9], nu[9], nv[9], xu = 0, xv = 0, yu = 0, yv = 0;
    shape(e_.type, apex_, n, nu, nv);
    for (std::size_t k = 0; k < static_cast<std::size_t>(nodes_); ++k) {
      xu += nu[k] * e_.x[k], xv += nv[k] * e_.x[k];
      yu += nu[k] * e_.y[k], yv += nv[k] * e_.y[k];
    }
    auto tangent = [&](Real u, Real v) { return Point{xu * u + xv * v, yu * u + yv * v}; };
    const Point edge = tangent(b_.u - a_.u, b_.v - a_.v), out = tangent(apex_.u - a_.u, apex_.v - a_.v);
    const Real foot =
        std::clamp((out.u * edge.u + out.v * edge.v) / (edge.u * edge.u + edge.v * edge.v), Real(0), Real(1));
    for (const Real end : {Real(0), Real(1)}) {
      Real far = 1;
      for (int k = 0; k < 48 && end != foot; ++k) {
        const Real near = k == 47 ? 0 : far / 2;
        const Real t0 = foot + (end - foot) * near, t1 = foot + (end - foot) * far;
        const Values part = rule(0, 1, std::min(t0, t1), std::max(t0, t1));
        for (std::size_t i = 0; i < 5; ++i)
          for (std::size_t m = 0; m < max_element_nodes; ++m) total_[i][m] += part[i][m];
        far = near;
      }
    }
  }

  void refine(Real s0, Real s1, Real t0, Real t1, const Values& whole, int depth) {
    const Real sm = (s0 + s1) / 2, tm = (t0 + t1) / 2;
    const Values part[4] = {rule(s0, sm, t0, tm), rule(sm, s1, t0, tm), rule(s0, sm, tm, t1), rule(sm, s1, tm, t1)};
    Real change = 0;
    for (std::size_t k = 0; k < 5; ++k)
      for (std::size_t m = 0; m < static_cast<std::size_t>(nodes_); ++m) {
        const Real sum = part[0][k][m] + part[1][k][m] + part[2][k][m] + part[3][k][m];
        change = std::max(change, std::abs(sum - whole[k][m]));
      }
    if (change <= 1e-11 * size_ || depth > 60) {
      for (std::size_t k = 0; k < 5; ++k)
        for (std::size_t m = 0; m < max_element_nodes; ++m)
          total_[k][m] += part[0][k][m] + part[1][k][m] + part[2][k][m] + part[3][k][m];
      return;
    }
    refine(s0, sm, t0, tm, part[0], depth + 1);
    refine(sm, s1, t0, tm, part[1], depth + 1);
    refine(s0, sm, tm, t1, part[2], depth + 1);
    refine(sm, s1, tm, t1, part[3], depth + 1);
  }

  const Element& e_;
  const int nodes_;
  Real px_, py_, area_ = 0, size_ = 0;
  bool graded_ = false;
  Point apex_{}, a_{}, b_{};
  Values total_{};
};

}  // namespace

Frame frame_of(const Element& element) {
  SurfaceMesh mesh;
  for (std::size_t i = 0; i < element.x.size(); ++i) {
    mesh.node.push_back({element.x[i], element.y[i], 0});
    mesh.connectivity.push_back(static_cast<std::int32_t>(i));
  }
  mesh.type = {element.type};
  mesh.tag = {0};
  mesh.offset = {0, static_cast<std::int64_t>(element.x.size())};
  return build_frame(std::move(mesh), Axes{});
}

std::array<double, 2> position(const Element& element, Reference at) {
  Real n[9], nu[9], nv[9], x = 0, y = 0;
  shape(element.type, {at.xi, at.eta}, n, nu, nv);
  for (std::size_t i = 0; i < element.x.size(); ++i) x += n[i] * element.x[i], y += n[i] * element.y[i];
  return {static_cast<double>(x), static_cast<double>(y)};
}

Integrals integrate(const Element& element, double px, double py, std::optional<Reference> on) {
  const Adaptive adaptive(element, px, py, on);
  Integrals result{};
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t i = 0; i < element.x.size(); ++i) result[k][i] = static_cast<double>(adaptive.total()[k][i]);
  return result;
}

Integrals from_library(const Element& element, double px, double py, double tolerance) {
  const Frame frame = frame_of(element);
  const auto compliance = make_halfspace_compliance(frame, {1, 1, 1}, tolerance, 1);
  double a[4][max_element_nodes] = {};
  ComplianceBlock block;
  block.stride = max_element_nodes;
  block.a[2][2] = a[0], block.a[0][1] = a[1], block.a[0][2] = a[2], block.a[1][2] = a[3];
  double xx[max_element_nodes] = {};
  block.a[0][0] = xx;
  const double x[1] = {px}, y[1] = {py};
  compliance->block({x, y}, block);
  Integrals result{};
  for (std::size_t i = 0; i < element.x.size(); ++i) {
    result[0][i] = a[0][i];
    result[1][i] = xx[i] - a[0][i];
    result[2][i] = a[1][i];
    result[3][i] = a[2][i];
    result[4][i] = a[3][i];
  }
  return result;
}

double relative_error(const Integrals& value, const Integrals& reference) {
  double error = 0, size = 0;
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t i = 0; i < max_element_nodes; ++i) {
      size = std::max(size, std::abs(reference[k][i]));
      error = std::max(error, std::abs(value[k][i] - reference[k][i]));
    }
  return error / size;
}

}  // namespace rollcon::brute_force
