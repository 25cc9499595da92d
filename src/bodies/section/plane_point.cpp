#include "bodies/section/plane_point.hpp"

#include <cmath>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "support/index.hpp"

namespace rollcon::section {

PlanePoint plane_point(const SweptSection& section, std::int64_t element, double xi, double eta) {
  Shape shape;
  evaluate_shape(section.plane().type[at(element)], xi, eta, shape);
  const auto nodes = section.plane().element(element);
  double j[4] = {0, 0, 0, 0};
  PlanePoint here;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto& [p, q] = section.place(nodes[a]);
    here.p += shape.value[a] * p, here.q += shape.value[a] * q;
    j[0] += shape.d_xi[a] * p, j[1] += shape.d_xi[a] * q, j[2] += shape.d_eta[a] * p, j[3] += shape.d_eta[a] * q;
  }
  here.jacobian = j[0] * j[3] - j[1] * j[2];
  here.xi_p = j[3] / here.jacobian, here.xi_q = -j[2] / here.jacobian;
  here.eta_p = -j[1] / here.jacobian, here.eta_q = j[0] / here.jacobian;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    here.value[a] = shape.value[a];
    here.dp[a] = here.xi_p * shape.d_xi[a] + here.eta_p * shape.d_eta[a];
    here.dq[a] = here.xi_q * shape.d_xi[a] + here.eta_q * shape.d_eta[a];
  }
  return here;
}

std::vector<EdgePoint> edge_points(const SweptSection& section, const SectionEdge& edge) {
  const LineRule line = gauss_legendre(6);
  const bool middle = edge.nodes() == 3;
  std::vector<EdgePoint> points;
  for (std::size_t g = 0; g < line.x.size(); ++g) {
    const double x = line.x[g], bubble = middle ? 1 - x * x : 0, turn = middle ? x : 0;
    EdgePoint here{.value = {0.5 * (1 - x - bubble), 0.5 * (1 + x - bubble), bubble}};
    const double slope[3] = {-0.5 + turn, 0.5 + turn, -2 * x};
    double p = 0;
    for (std::size_t a = 0; a < edge.nodes(); ++a) {
      const auto& [own_p, own_q] = section.place(edge.node[a]);
      p += here.value[a] * own_p, here.dp += slope[a] * own_p, here.dq += slope[a] * own_q;
    }
    here.weight = line.w[g] * section.way(p);
    points.push_back(here);
  }
  return points;
}

EdgeMass edge_mass(const SweptSection& section, const SectionEdge& edge) {
  EdgeMass mass{};
  for (const EdgePoint& here : edge_points(section, edge))
    for (std::size_t a = 0; a < edge.nodes(); ++a)
      for (std::size_t b = 0; b < edge.nodes(); ++b)
        mass[a][b] += here.weight * std::hypot(here.dp, here.dq) * here.value[a] * here.value[b];
  return mass;
}

}  // namespace rollcon::section
