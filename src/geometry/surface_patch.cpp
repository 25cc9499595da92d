#include "geometry/surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollcon {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Turns values at -1, 0, 1 into coefficients of 1, t, t^2.
void power_form(Vec3& low, Vec3& middle, Vec3& high) {
  const Vec3 slope = 0.5 * (high - low), bend = 0.5 * (high + low) - middle;
  low = middle;
  middle = slope;
  high = bend;
}

/// Returns the Bezier point of a parabola from its ends and middle.
Vec3 control(const Vec3& low, const Vec3& middle, const Vec3& high) {
  return 2.0 * middle - 0.5 * (low + high);
}

}  // namespace

SurfacePatch::SurfacePatch(const SurfaceMesh& mesh, std::int64_t element) {
  const ElementType type = mesh.type[static_cast<std::size_t>(element)];
  const auto nodes = mesh.element(element);
  triangle_ = corner_count(type) == 3;
  quadratic_ = is_quadratic(type);
  origin_ = mesh.node[static_cast<std::size_t>(nodes[0])];
  std::array<Vec3, max_element_nodes> p{};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    p[i] = mesh.node[static_cast<std::size_t>(nodes[i])] - origin_;
    size_ = std::max(size_, length(p[i]));
  }
  switch (type) {
    case ElementType::tri3:
      c_[1][0] = p[1];
      c_[0][1] = p[2];
      break;
    case ElementType::tri6:
      c_[1][0] = 4.0 * p[3] - p[1];
      c_[2][0] = 2.0 * p[1] - 4.0 * p[3];
      c_[0][1] = 4.0 * p[5] - p[2];
      c_[0][2] = 2.0 * p[2] - 4.0 * p[5];
      c_[1][1] = 4.0 * (p[4] - p[3] - p[5]);
      break;
    case ElementType::quad4:
      c_[0][0] = 0.25 * (p[0] + p[1] + p[2] + p[3]);
      c_[1][0] = 0.25 * (p[1] + p[2] - p[0] - p[3]);
      c_[0][1] = 0.25 * (p[2] + p[3] - p[0] - p[1]);
      c_[1][1] = 0.25 * (p[0] + p[2] - p[1] - p[3]);
      break;
    case ElementType::quad8:
      p[8] = 0.5 * (p[4] + p[5] + p[6] + p[7]) - 0.25 * (p[0] + p[1] + p[2] + p[3]);
      [[fallthrough]];
    case ElementType::quad9: {
      const int lattice[3][3] = {{0, 7, 3}, {4, 8, 6}, {1, 5, 2}};  // lattice of nodes by xi and eta
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c_[i][j] = p[static_cast<std::size_t>(lattice[i][j])];
      for (auto& line : c_) power_form(line[0], line[1], line[2]);
      for (int j = 0; j < 3; ++j) power_form(c_[0][j], c_[1][j], c_[2][j]);
      break;
    }
  }
}

SurfacePatch::Derivatives SurfacePatch::at(double xi, double eta) const {
  // The sums follow Horner's rule in eta for each power of xi.
  Vec3 f[3], g[3];
  Derivatives d{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      f[i][k] = c_[i][0][k] + eta * (c_[i][1][k] + eta * c_[i][2][k]);
      g[i][k] = c_[i][1][k] + 2 * eta * c_[i][2][k];
    }
    d.x[k] = f[0][k] + xi * (f[1][k] + xi * f[2][k]);
    d.u[k] = f[1][k] + 2 * xi * f[2][k];
    d.uu[k] = 2 * f[2][k];
    d.v[k] = g[0][k] + xi * (g[1][k] + xi * g[2][k]);
    d.uv[k] = g[1][k] + 2 * xi * g[2][k];
    d.vv[k] = 2 * (c_[0][2][k] + xi * (c_[1][2][k] + xi * c_[2][2][k]));
  }
  return d;
}

PatchPart SurfacePatch::part(int i) const {
  if (!quadratic_) return triangle_ ? PatchPart{{0, 0}, 1} : PatchPart{{-1, -1}, 2};
  if (!triangle_) return {{i % 2 == 0 ? -1.0 : 0.0, i < 2 ? -1.0 : 0.0}, 1};
  if (i == 3) return {{0.5, 0.5}, -0.5};
  return {{i == 1 ? 0.5 : 0.0, i == 2 ? 0.5 : 0.0}, 0.5};
}

std::array<Vec3, 2> SurfacePatch::box(const PatchPart& part) const {
  // The part in Bezier form lies in the hull of its control points.
  Vec3 p[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const ReferencePoint r = inside(part, 0.5 * i, 0.5 * j);
      p[i][j] = at(r.xi, r.eta).x;
    }
  if (triangle_) {
    const Vec3 low = p[0][0], right = p[2][0], top = p[0][2];
    p[1][0] = control(low, p[1][0], right);
    p[0][1] = control(low, p[0][1], top);
    p[1][1] = control(right, p[1][1], top);
  } else {
    for (auto& line : p) line[1] = control(line[0], line[1], line[2]);
    for (int j = 0; j < 3; ++j) p[1][j] = control(p[0][j], p[1][j], p[2][j]);
  }
  std::array<Vec3, 2> box{p[0][0], p[0][0]};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < (triangle_ ? 3 - i : 3); ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        box[0][k] = std::min(box[0][k], p[i][j][k]);
        box[1][k] = std::max(box[1][k], p[i][j][k]);
      }
  return box;
}

ReferencePoint SurfacePatch::clamp(ReferencePoint p) const {
  if (!triangle_) return {std::clamp(p.xi, -1.0, 1.0), std::clamp(p.eta, -1.0, 1.0)};
  if (p.xi + p.eta > 1) {
    const double s = std::clamp(0.5 * (1 + p.xi - p.eta), 0.0, 1.0);
    return {s, 1 - s};
  }
  return {std::clamp(p.xi, 0.0, 1.0), std::clamp(p.eta, 0.0, 1.0)};
}

std::optional<ReferencePoint> SurfacePatch::newton(ReferencePoint p, const Vec3& from, const Vec3& a,
                                                   const Vec3& b) const {
  const double noise = 8 * epsilon * (length(from) + size_);
  bool last = false;
  for (int iteration = 0; iteration < 40; ++iteration) {
    const Derivatives d = at(p.xi, p.eta);
    const Vec3 r = d.x - from;
    const double f = dot(a, r), g = dot(b, r);
    if (last && std::hypot(f, g) <= 1e-12 * size_ + noise) return p;
    const double au = dot(a, d.u), av = dot(a, d.v), bu = dot(b, d.u), bv = dot(b, d.v);
    const double det = au * bv - av * bu;
    if (det == 0) return std::nullopt;
    double du = (av * g - bv * f) / det, dv = (bu * f - au * g) / det;
    const double step = std::hypot(du, dv);
    if (!(step < std::numeric_limits<double>::infinity())) return std::nullopt;
    if (step > 1) du /= step, dv /= step;
    p = {p.xi + du, p.eta + dv};
    if (std::abs(p.xi) > 4 || std::abs(p.eta) > 4) return std::nullopt;
    // The next step near a simple root is the square of this one, hence below rounding; where the line touches the
    // surface, steps halve.
    last = step < 1e-8;
  }
  return std::nullopt;
}

bool SurfacePatch::turns_over(const PatchPart& part, const Vec3& direction) const {
  if (!quadratic_ && triangle_) return false;
  bool positive = false, negative = false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < (triangle_ ? 3 - i : 3); ++j) {
      const ReferencePoint p = inside(part, 0.5 * i, 0.5 * j);
      const Derivatives d = at(p.xi, p.eta);
      (dot(direction, cross(d.u, d.v)) > 0 ? positive : negative) = true;
    }
  return positive && negative;
}

void SurfacePatch::meet(const PatchPart& part, const Vec3& from, const Vec3& a, const Vec3& b, double beyond,
                        std::vector<ReferencePoint>& found) const {
  // A plane has one root, which any start finds. A part of another surface that looks to one side of the line only has
  // one root at most; where it turns over there may be one on each side.
  int tries = 1;
  bool several = false;
  if (quadratic_ || !triangle_) tries = 9, several = turns_over(part, cross(a, b));
  for (int i = 0; i < tries; ++i) {
    static constexpr double start[9][2] = {{0.5, 0.5},   {0, 0},       {1, 0},       {0, 1},      {1, 1},
                                           {0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
    if (i >= 5 && !several) return;
    if (triangle_ && start[i][0] + start[i][1] > 1) continue;
    const auto root = newton(i == 0 ? middle(part) : inside(part, start[i][0], start[i][1]), from, a, b);
    if (!root) continue;
    const ReferencePoint p = clamp(*root);
    const bool moved = p.xi != root->xi || p.eta != root->eta;
    if (moved && length(at(p.xi, p.eta).x - at(root->xi, root->eta).x) > beyond) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const ReferencePoint& q) {
      return std::hypot(p.xi - q.xi, p.eta - q.eta) < 1e-7;
    });
    if (!known) found.push_back(p);
    if (!several && holds(part, p)) return;
  }
}

ReferencePoint SurfacePatch::descend(ReferencePoint p, const Vec3& point) const {
  Derivatives d = at(p.xi, p.eta);
  Vec3 r = d.x - point;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double gu = dot(r, d.u), gv = dot(r, d.v);
    double huu = dot(d.u, d.u) + dot(r, d.uu), huv = dot(d.u, d.v) + dot(r, d.uv), hvv = dot(d.v, d.v) + dot(r, d.vv);
    const double guu = dot(d.u, d.u), guv = dot(d.u, d.v), gvv = dot(d.v, d.v);
    // The second derivatives may point uphill far from a minimum; Gauss-Newton's replace them there.
    if (huu <= 0 || huu * hvv - huv * huv <= 1e-3 * (guu * gvv - guv * guv)) huu = guu, huv = guv, hvv = gvv;
    const double det = huu * hvv - huv * huv;
    if (det <= 0) return p;
    const double du = (huv * gv - hvv * gu) / det, dv = (huv * gu - huu * gv) / det;
    bool better = false;
    ReferencePoint q{};
    for (double factor = 1; factor > 1e-3 && !better; factor *= 0.5) {
      q = clamp({p.xi + factor * du, p.eta + factor * dv});
      const double moved = std::hypot(q.xi - p.xi, q.eta - p.eta);
      if (moved < 1e-15) return p;
      const Derivatives e = at(q.xi, q.eta);
      const Vec3 s = e.x - point;
      // The distance is flat near its minimum, where only the gradient still tells.
      better = dot(s, s) < dot(r, r) * (1 - 1e-12) ||
               (moved < 1e-3 && std::hypot(dot(s, e.u), dot(s, e.v)) < 0.5 * std::hypot(gu, gv));
      if (better) d = e, r = s;
    }
    if (!better) return p;
    p = q;
  }
  return p;
}

ReferencePoint SurfacePatch::descend_on_edge(const ReferencePoint& p, const ReferencePoint& q, double start,
                                             const Vec3& point) const {
  const double dx = q.xi - p.xi, dy = q.eta - p.eta;
  double s = start, slope = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Derivatives d = at(p.xi + s * dx, p.eta + s * dy);
    const Vec3 r = d.x - point, t = dx * d.u + dy * d.v;
    const Vec3 bend = dx * dx * d.uu + 2 * dx * dy * d.uv + dy * dy * d.vv;
    const double g = dot(r, t), tt = dot(t, t);
    if (iteration > 3 && std::abs(g) >= slope) break;
    slope = std::abs(g);
    double h = tt + dot(r, bend);
    if (h <= 1e-3 * tt) h = tt;
    if (!(h > 0)) break;
    const double next = std::clamp(s - std::clamp(g / h, -0.5, 0.5), 0.0, 1.0);
    const double moved = std::abs(next - s);
    s = next;
    if (moved < 1e-15) break;
  }
  return {p.xi + s * dx, p.eta + s * dy};
}

bool SurfacePatch::holds(const PatchPart& part, const ReferencePoint& p) const {
  const double s = (p.xi - part.corner.xi) / part.h, t = (p.eta - part.corner.eta) / part.h;
  return s >= 0 && t >= 0 && (triangle_ ? s + t <= 1 : s <= 1 && t <= 1);
}

ReferencePoint SurfacePatch::nearest(const PatchPart& part, const Vec3& point) const {
  ReferencePoint best{};
  double least = std::numeric_limits<double>::infinity();
  auto offer = [&](const ReferencePoint& p) {
    const Vec3 r = at(p.xi, p.eta).x - point;
    if (const double square = dot(r, r); square < least) least = square, best = p;
  };
  offer(descend(middle(part), point));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < (triangle_ ? 3 - i : 3); ++j) {
      const ReferencePoint p = inside(part, 0.5 * i, 0.5 * j);
      const Vec3 r = at(p.xi, p.eta).x - point;
      // The descent ended in another valley.
      if (dot(r, r) < least) offer(descend(p, point));
    }
  const auto corners = reference_nodes(triangle_ ? ElementType::tri3 : ElementType::quad4);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ReferencePoint &p = corners[i], &q = corners[(i + 1) % corners.size()];
    if (!quadratic_) offer(descend_on_edge(p, q, 0.5, point));
    // Each half of a curved edge belongs to one part.
    for (double s : {0.2, 0.8})
      if (quadratic_ && holds(part, {p.xi + s * (q.xi - p.xi), p.eta + s * (q.eta - p.eta)}))
        offer(descend_on_edge(p, q, s, point));
  }
  return best;
}

}  // namespace rollcon
