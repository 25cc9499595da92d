#include "bodies/section/fields.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "bodies/section/plane_point.hpp"
#include "linalg/blas_threads.hpp"
#include "mesh/shape.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::section {
namespace {

/// Finds the reference point of an element over a point of the section's plane. False: it is outside, by more than a
/// millionth.
bool find_reference(const SweptSection& section, std::int64_t e, double p, double q, double& xi, double& eta) {
  const bool triangle = corner_count(section.plane().type[at(e)]) == 3;
  xi = eta = triangle ? 1.0 / 3 : 0;
  for (int step = 0; step < 30; ++step) {
    const PlanePoint here = plane_point(section, e, xi, eta);
    const double dx = here.xi_p * (p - here.p) + here.xi_q * (q - here.q),
                 de = here.eta_p * (p - here.p) + here.eta_q * (q - here.q);
    xi += dx, eta += de;
    if (!(std::hypot(xi, eta) < 10)) return false;
    if (std::hypot(dx, de) < 1e-12) break;
  }
  constexpr double most = 1e-6;
  return (triangle ? std::max({-xi, -eta, xi + eta - 1}) : std::max(std::abs(xi), std::abs(eta)) - 1) <= most;
}

}  // namespace

SectionFields::Place SectionFields::find(const Vec3& x, double& angle) const {
  const SweptSection& s = system_.section();
  const auto& [e1, along, e2] = s.axes_at_start();
  const Vec3 d = x - s.path().origin;
  const double q = dot(d, e2), p = s.revolved() ? std::hypot(dot(d, e1), dot(d, along)) : dot(d, e1);
  angle = s.revolved() ? std::atan2(dot(d, along), dot(d, e1)) : dot(d, along) / s.way(0);
  Place place;
  for (; place.element < s.plane().elements(); ++place.element)
    if (find_reference(s, place.element, p, q, place.xi, place.eta)) return place;
  fail(Status::err_argument, "the point (%.9g, %.9g, %.9g) is outside the body", x[0], x[1], x[2]);
}

std::vector<SectionFields::Angle> SectionFields::by_angle(std::vector<double> angle,
                                                          const std::vector<Place>& place) const {
  std::map<double, Angle> found;
  for (std::size_t k = 0; k < angle.size(); ++k) {
    Angle& a = found[angle[k]];
    a.angle = angle[k];
    a.point.push_back(static_cast<std::int64_t>(k));
    const auto nodes = system_.section().plane().element(place[k].element);
    a.node.insert(a.node.end(), nodes.begin(), nodes.end());
  }
  std::vector<Angle> all;
  for (auto& [key, a] : found) {
    std::sort(a.node.begin(), a.node.end());
    a.node.erase(std::unique(a.node.begin(), a.node.end()), a.node.end());
    a.moved.assign(6 * a.node.size(), 0.0);
    for (std::size_t i = 0; i < 3 * a.node.size() && !own_.empty(); ++i)
      a.moved[2 * i] = own_[3 * at(a.node[i / 3]) + i % 3];
    all.push_back(std::move(a));
  }
  return all;
}

void SectionFields::sum(std::vector<Angle>& angles, int threads) const {
  if (force_.empty()) return;
  const BlasThreads blas(threads);
  const std::size_t width = 3 * system_.section().profile().size();
  // By angle, sample and column (kernel, profile node, component): the value, and its derivative.
  std::vector<std::vector<double>> acting(angles.size());
  parallel_for(std::ssize(angles), 1, threads,
               [&](std::int64_t k, int) { acting[at(k)] = system_.sampled(force_, angles[at(k)].angle, true); });
  for (std::size_t s = 0; s < system_.samples(); ++s) {
    const std::vector<double> everywhere = system_.sample_everywhere(s, threads);  // [column][3 * node + c]
    const std::size_t rows = everywhere.size() / width;
    parallel_for(std::ssize(angles), 8, threads, [&](std::int64_t k, int) {
      Angle& a = angles[at(k)];
      const double* q = acting[at(k)].data() + 4 * width * s;
      for (std::size_t b = 0; b < width; ++b) {
        const double* x = everywhere.data() + b * rows;
        for (std::size_t i = 0; i < 3 * a.node.size(); ++i) {
          const double u = x[3 * at(a.node[i / 3]) + i % 3];
          const bool odd = (i % 3 == 1) != (b % 3 == 1);
          const double sign = odd && b % 3 == 1 ? -1 : 1;
          a.moved[2 * i] += sign * u * q[4 * b + (odd ? 1 : 0)];
          a.moved[2 * i + 1] += sign * u * q[4 * b + (odd ? 3 : 2)];
        }
      }
    });
  }
}

void SectionFields::evaluate(const Angle& angle, const Place& place, Vec3* moved, double* stress) const {
  const SweptSection& s = system_.section();
  const auto nodes = s.plane().element(place.element);
  const PlanePoint here = plane_point(s, place.element, place.xi, place.eta);
  double u[3] = {}, by_angle[3] = {}, g[3][3] = {};  // g: derivative of component c along axis d
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto i = at(std::lower_bound(angle.node.begin(), angle.node.end(), nodes[a]) - angle.node.begin());
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = angle.moved[2 * (3 * i + c)];
      u[c] += here.value[a] * value;
      by_angle[c] += here.value[a] * angle.moved[2 * (3 * i + c) + 1];
      g[c][0] += here.dp[a] * value, g[c][2] += here.dq[a] * value;
    }
  }
  const auto axes = s.axes(angle.angle).all();
  if (moved) *moved = u[0] * axes[0] + u[1] * axes[1] + u[2] * axes[2];
  if (!stress) return;
  const double wave = 1 / s.way(std::max(here.p, 1e-12 * s.way(1))), curve = s.revolved() ? wave : 0;
  for (std::size_t c = 0; c < 3; ++c) g[c][1] = wave * by_angle[c];
  g[1][1] += curve * u[0];
  g[0][1] -= curve * u[1];
  const Elastic m = system_.material(place.element);
  const double shear = m.young / (2 * (1 + m.poisson)), lame = 2 * shear * m.poisson / (1 - 2 * m.poisson);
  const double trace = g[0][0] + g[1][1] + g[2][2];
  double t[3][3] = {};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      const double local = shear * (g[a][b] + g[b][a]) + (a == b ? lame * trace : 0);
      for (std::size_t x = 0; x < 3; ++x)
        for (std::size_t y = 0; y < 3; ++y) t[x][y] += axes[a][x] * local * axes[b][y];
    }
  const double all[6] = {t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]};
  std::copy(all, all + 6, stress);
}

void SectionFields::at_points(std::int64_t n, const double* xyz, double* displacement, double* stress,
                              int threads) const {
  std::vector<double> angle(at(n));
  std::vector<Place> place;
  for (std::int64_t k = 0; k < n; ++k)
    place.push_back(find({xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]}, angle[at(k)]));
  std::vector<Angle> angles = by_angle(std::move(angle), place);
  sum(angles, threads);
  for (const Angle& a : angles)
    for (const std::int64_t k : a.point) {
      Vec3 moved;
      evaluate(a, place[at(k)], &moved, stress ? stress + 6 * k : nullptr);
      if (displacement) std::copy(moved.begin(), moved.end(), displacement + 3 * k);
    }
}

// Stresses at nodes of the surface are means over the elements behind the faces around.
void SectionFields::at_nodes(double* stress, int threads) const {
  const SweptSection& s = system_.section();
  const std::size_t width = s.profile().size(), stations = at(s.surface_stations());
  std::vector<double> angle;
  std::vector<Place> place;
  std::vector<std::size_t> target;
  std::vector<double> count(width, 0.0);
  for (std::size_t e = 0; e < s.swept_edges().size(); ++e) {
    const std::int64_t element = s.edges()[s.swept_edges()[e]].element;
    const auto nodes = s.plane().element(element);
    const auto reference = reference_nodes(s.plane().type[at(element)]);
    for (const std::int32_t i : s.of_edge(e)) {
      if (i < 0) continue;
      const auto a = at(std::find(nodes.begin(), nodes.end(), s.profile()[at(i)]) - nodes.begin());
      count[at(i)] += 1;
      for (std::size_t k = 0; k < stations; ++k) {
        angle.push_back(static_cast<double>(s.station(static_cast<std::int64_t>(k))) * s.step());
        place.push_back({element, reference[a].xi, reference[a].eta});
        target.push_back(k * width + at(i));
      }
    }
  }
  std::vector<Angle> angles = by_angle(std::move(angle), place);
  sum(angles, threads);
  std::fill_n(stress, 6 * width * stations, 0.0);
  for (const Angle& a : angles)
    for (const std::int64_t k : a.point) {
      double own[6];
      evaluate(a, place[at(k)], nullptr, own);
      for (std::size_t c = 0; c < 6; ++c) stress[6 * target[at(k)] + c] += own[c] / count[target[at(k)] % width];
    }
}

}  // namespace rollcon::section
