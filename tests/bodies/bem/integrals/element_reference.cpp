#include "bodies/bem/integrals/element_reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/bem/far_field.hpp"
#include "bodies/bem/near_field.hpp"
#include "bodies/bem/rule_tables.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "support/frames.hpp"

namespace rollcon::element_reference {
namespace {

struct Surface {
  Vec3 x, normal;
  Shape shape;
};

Surface evaluate(const SurfaceMesh& mesh, double xi, double eta) {
  Surface s;
  evaluate_shape(mesh.type[0], xi, eta, s.shape);
  Vec3 u{}, v{};
  s.x = {};
  for (std::size_t k = 0; k < mesh.node.size(); ++k) {
    s.x = s.x + s.shape.value[k] * mesh.node[k];
    u = u + s.shape.d_xi[k] * mesh.node[k];
    v = v + s.shape.d_eta[k] * mesh.node[k];
  }
  s.normal = cross(u, v);
  return s;
}

class Sum {
 public:
  Sum(const SurfaceMesh& mesh, const Vec3& x, double poisson) : mesh_(mesh), x_(x), nu_(poisson) {}

  void subtract(Reference at) {
    Shape s;
    evaluate_shape(mesh_.type[0], at.xi, at.eta, s);
    std::copy_n(s.value.begin(), mesh_.node.size(), less_.begin());
  }

  void add(double xi, double eta, double weight) {
    const Surface s = evaluate(mesh_, xi, eta);
    const double jacobian = length(s.normal);
    const auto f = kelvin(s.x - x_, (1 / jacobian) * s.normal, nu_);
    for (std::size_t k = 0; k < mesh_.node.size(); ++k) {
      const double n = s.shape.value[k] * weight * jacobian, m = (s.shape.value[k] - less_[k]) * weight * jacobian;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
          result.t[3 * c + i][k] += m * f[3 * i + c];
          result.u[3 * c + i][k] += n * f[9 + 3 * i + c];
        }
    }
    ++result.points;
  }

  Integrals result;

 private:
  const SurfaceMesh& mesh_;
  const Vec3 x_;
  const double nu_;
  std::array<double, max_element_nodes> less_{};
};

const LineRule& gauss() {
  static const LineRule rule = gauss_legendre(12);
  return rule;
}

/// Is a parallelogram corner + [0,1] a + [0,1] b, or that triangle, folded.
struct Part {
  Reference corner, a, b;
  bool triangle;
  Reference at(double s, double t) const {
    if (triangle) t *= 1 - s;
    return {corner.xi + s * a.xi + t * b.xi, corner.eta + s * a.eta + t * b.eta};
  }
  double area() const { return a.xi * b.eta - a.eta * b.xi; }
};

void integrate_part(const SurfaceMesh& mesh, const Part& part, const Vec3& x, Sum& sum, int depth) {
  auto where = [&](double s, double t) {
    const Reference p = part.at(s, t);
    return evaluate(mesh, p.xi, p.eta).x;
  };
  const Vec3 centre = part.triangle ? where(1.0 / 3, 0.5) : where(0.5, 0.5);
  double radius = 0;
  for (const double s : {0.0, 0.5, 1.0})
    for (const double t : {0.0, 0.5, 1.0}) radius = std::max(radius, length(where(s, t) - centre));
  if (length(centre - x) > 2.5 * radius || depth == 60) {
    const LineRule& g = gauss();
    for (std::size_t i = 0; i < g.x.size(); ++i)
      for (std::size_t j = 0; j < g.x.size(); ++j) {
        const double s = 0.5 * (1 + g.x[i]), t = 0.5 * (1 + g.x[j]);
        const Reference p = part.at(s, t);
        sum.add(p.xi, p.eta, 0.25 * g.w[i] * g.w[j] * part.area() * (part.triangle ? 1 - s : 1));
      }
    return;
  }
  const Reference a{part.a.xi / 2, part.a.eta / 2}, b{part.b.xi / 2, part.b.eta / 2}, c = part.corner;
  auto child = [&](Reference corner, Reference u, Reference v, bool triangle) {
    integrate_part(mesh, {corner, u, v, triangle}, x, sum, depth + 1);
  };
  const Reference ca{c.xi + a.xi, c.eta + a.eta}, cb{c.xi + b.xi, c.eta + b.eta};
  if (part.triangle) {
    // The cut is across the longest side.
    const Reference v[3] = {c, {c.xi + part.a.xi, c.eta + part.a.eta}, {c.xi + part.b.xi, c.eta + part.b.eta}};
    auto place = [&](int k) { return evaluate(mesh, v[k].xi, v[k].eta).x; };
    int longest = 0;
    double most = 0;
    for (int k = 0; k < 3; ++k)
      if (const double side = length(place((k + 1) % 3) - place(k)); side > most) {
        most = side;
        longest = k;
      }
    const Reference p = v[longest], q = v[(longest + 1) % 3], r = v[(longest + 2) % 3];
    const Reference m{(p.xi + q.xi) / 2, (p.eta + q.eta) / 2};
    child(r, {p.xi - r.xi, p.eta - r.eta}, {m.xi - r.xi, m.eta - r.eta}, true);
    child(r, {m.xi - r.xi, m.eta - r.eta}, {q.xi - r.xi, q.eta - r.eta}, true);
    return;
  }
  const double first = length(where(1, 0.5) - where(0, 0.5)), second = length(where(0.5, 1) - where(0.5, 0));
  if (first > 1.5 * second) {
    child(c, a, part.b, false);
    child(ca, a, part.b, false);
  } else if (second > 1.5 * first) {
    child(c, part.a, b, false);
    child(cb, part.a, b, false);
  } else {
    child(c, a, b, false);
    child(ca, a, b, false);
    child(cb, a, b, false);
    child({ca.xi + b.xi, ca.eta + b.eta}, a, b, false);
  }
}

/// Integrates over the triangle from the point to begin..end, cut across until the edge is short against its distance.
void integrate_fan(const SurfaceMesh& mesh, Reference apex, Reference begin, Reference end, Sum& sum, int depth) {
  const double area = (begin.xi - apex.xi) * (end.eta - apex.eta) - (begin.eta - apex.eta) * (end.xi - apex.xi);
  if (!(area > 1e-20)) return;
  const Vec3 x = evaluate(mesh, apex.xi, apex.eta).x;
  const Reference middle{(begin.xi + end.xi) / 2, (begin.eta + end.eta) / 2};
  // The distance is taken in the tangent map, because the edge's middle may bend towards the point.
  auto near = [&](Reference p) {
    constexpr double h = 1e-4;
    return length(evaluate(mesh, apex.xi + h * (p.xi - apex.xi), apex.eta + h * (p.eta - apex.eta)).x - x) / h;
  };
  const double edge = near({apex.xi + end.xi - begin.xi, apex.eta + end.eta - begin.eta});
  if (edge > 0.7 * near(middle) && depth < 45) {
    integrate_fan(mesh, apex, begin, middle, sum, depth + 1);
    integrate_fan(mesh, apex, middle, end, sum, depth + 1);
    return;
  }
  const LineRule& g = gauss();
  constexpr int pieces = 4;
  for (int piece = 0; piece < pieces; ++piece)
    for (std::size_t i = 0; i < g.x.size(); ++i)
      for (std::size_t j = 0; j < g.x.size(); ++j) {
        const double s = (piece + 0.5 * (1 + g.x[i])) / pieces, t = 0.5 * (1 + g.x[j]);
        const Reference p{begin.xi + t * (end.xi - begin.xi), begin.eta + t * (end.eta - begin.eta)};
        sum.add(apex.xi + s * (p.xi - apex.xi), apex.eta + s * (p.eta - apex.eta),
                0.25 / pieces * g.w[i] * g.w[j] * area * s);
      }
}

Integrals library(const SurfaceMesh& mesh, const Vec3& point, const bem::OnElement& on, double poisson,
                  double tolerance_t, double tolerance_u) {
  const bem::ElementGeometry element = bem::element_geometry(mesh, 0, 1);
  bem::NearWorkspace workspace;
  bem::NearIntegrals found;
  bem::near_integrals(element, point, on, {tolerance_t, tolerance_u}, bem::both_layers, bem::KelvinConstants(poisson),
                      bem::kelvin_kernels(rollcon::instruction_set()), workspace, found);
  static constexpr int entry[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
  Integrals result;
  result.points = workspace.evaluations;
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t k = 0; k < mesh.node.size(); ++k) {
      result.t[i][k] = found.t[i][k];
      result.u[i][k] = found.u[entry[i]][k];
    }
  return result;
}

}  // namespace

std::array<double, 18> kelvin(const Vec3& r, const Vec3& n, double nu) {
  const double distance = length(r), pi = std::numbers::pi;
  const Vec3 e = (1 / distance) * r;
  const double dn = dot(e, n);
  std::array<double, 18> f{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double same = i == j ? 1 : 0;
      f[3 * i + j] = -(dn * ((1 - 2 * nu) * same + 3 * e[i] * e[j]) - (1 - 2 * nu) * (e[i] * n[j] - e[j] * n[i])) /
                     (8 * pi * (1 - nu) * distance * distance);
      f[9 + 3 * i + j] = ((3 - 4 * nu) * same + e[i] * e[j]) / (16 * pi * (1 - nu) * distance);
    }
  return f;
}

Integrals integrate(const SurfaceMesh& element, const Vec3& point, double poisson) {
  Sum sum(element, point, poisson);
  if (corner_count(element.type[0]) == 3)
    integrate_part(element, {{0, 0}, {1, 0}, {0, 1}, true}, point, sum, 0);
  else
    integrate_part(element, {{-1, -1}, {2, 0}, {0, 2}, false}, point, sum, 0);
  return sum.result;
}

Integrals integrate_on(const SurfaceMesh& element, Reference at, double poisson) {
  Sum sum(element, position(element, at), poisson);
  sum.subtract(at);
  const bool triangle = corner_count(element.type[0]) == 3;
  const std::vector<Reference> corner = triangle ? std::vector<Reference>{{0, 0}, {1, 0}, {0, 1}}
                                                 : std::vector<Reference>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t i = 0; i < corner.size(); ++i)
    integrate_fan(element, at, corner[i], corner[(i + 1) % corner.size()], sum, 0);
  return sum.result;
}

Integrals from_library(const SurfaceMesh& element, const Vec3& point, double poisson, double tolerance_t,
                       double tolerance_u) {
  return library(element, point, {}, poisson, tolerance_t, tolerance_u);
}

Integrals from_library_on(const SurfaceMesh& element, Reference at, double poisson, double tolerance_t,
                          double tolerance_u) {
  Integrals result =
      library(element, position(element, at), {true, {at.xi, at.eta}}, poisson, tolerance_t, tolerance_u);
  Shape s;
  evaluate_shape(element.type[0], at.xi, at.eta, s);
  for (auto& row : result.t) {
    double sum = 0;
    for (std::size_t k = 0; k < element.node.size(); ++k) sum += row[k];
    for (std::size_t k = 0; k < element.node.size(); ++k) row[k] -= s.value[k] * sum;
  }
  return result;
}

Integrals from_far_field(const SurfaceMesh& mesh, const Vec3& point, double poisson, int terms, double tolerance) {
  const bem::ElementGeometry element = bem::element_geometry(mesh, 0, 1);
  const bem::FarField field({element}, tolerance);
  Integrals result;
  const bem::FarRule rule =
      field.rule(0, length(point - element.shape.centre), terms, bem::FarField::PackFactors(tolerance));
  if (rule.first == 0) return result;
  const bem::RuleTable& table = bem::rule_table(element.type, rule.first, rule.second);
  result.points = table.n;
  bem::PointPack pack;
  for (std::size_t p = 0; p < bem::pack_points; ++p) {
    for (std::size_t j = 0; j < 3; ++j) pack.x[j][p] = point[j];
    pack.mask[p] = p == 0 ? 1 : 0;
  }
  bem::FarPoints points;
  double blocks[2][max_element_nodes][9 * bem::pack_points] = {};
  double *h[max_element_nodes], *g[max_element_nodes];
  for (std::size_t k = 0; k < max_element_nodes; ++k) {
    h[k] = blocks[0][k];
    g[k] = blocks[1][k];
  }
  const bem::Kernels& kernels = bem::kelvin_kernels(rollcon::instruction_set());
  kernels.place(table, element.nodes, element.node, points);
  kernels.far(points, table, element.nodes, pack, bem::KelvinConstants(poisson), terms, h, g);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t k = 0; k < mesh.node.size(); ++k) {
      result.t[i][k] = h[k][i * bem::pack_points];
      result.u[i][k] = g[k][i * bem::pack_points];
    }
  return result;
}

double largest(const double (&a)[9][max_element_nodes]) {
  double worst = 0;
  for (const auto& row : a)
    for (const double v : row) worst = std::max(worst, std::abs(v));
  return worst;
}

double difference(const double (&a)[9][max_element_nodes], const double (&b)[9][max_element_nodes]) {
  double worst = 0;
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t k = 0; k < max_element_nodes; ++k) {
      const double d = std::abs(a[i][k] - b[i][k]);
      worst = d <= worst ? worst : d;  // a NaN stays
    }
  return worst;
}

SurfaceMesh one_element(ElementType type, double aspect, double distortion, double curvature, std::uint32_t seed) {
  frames::Random random(seed);
  SurfaceMesh mesh;
  mesh.type = {type};
  mesh.tag = {0};
  const bool triangle = corner_count(type) == 3;
  const double spacing = is_quadratic(type) ? 1 : 2;
  int k = 0;
  for (const ReferencePoint& at : reference_nodes(type)) {
    double x = triangle ? 2 * at.xi - 1 + 0.4 * at.eta : at.xi;
    double y = triangle ? 1.7 * at.eta - 0.6 : at.eta;
    x += distortion * spacing * std::min(1.0, 3 / aspect) * random();
    y += distortion * spacing * random();
    const double z = curvature * ((1 - x * x) + 0.5 * x * y / aspect + 0.3 * (1 - y * y) / aspect);
    y /= aspect;
    mesh.node.push_back({0.48 * x - 0.8 * y + 0.36 * z, 0.64 * x + 0.6 * y + 0.48 * z, -0.6 * x + 0.8 * z});
    mesh.connectivity.push_back(k++);
  }
  mesh.offset = {0, k};
  return mesh;
}

Vec3 position(const SurfaceMesh& element, Reference at) {
  return evaluate(element, at.xi, at.eta).x;
}

Vec3 normal(const SurfaceMesh& element, Reference at) {
  return evaluate(element, at.xi, at.eta).normal;
}

}  // namespace rollcon::element_reference
