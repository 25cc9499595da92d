#include "bodies/section/fields.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

#include "bodies/section/plane_point.hpp"
#include "linalg/blas_threads.hpp"
#include "mesh/shape.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::section {
namespace {

/// Says whether a point is as near to the middle of an element's nodes as one of the element can be.
bool may_have(const SweptSection& section, std::int64_t e, double p, double q) {
  const auto nodes = section.plane().element(e);
  double sum[2] = {0, 0}, farthest = 0;
  for (const std::int32_t k : nodes)
    for (std::size_t c = 0; c < 2; ++c) sum[c] += section.place(k)[c] / static_cast<double>(nodes.size());
  for (const std::int32_t k : nodes)
    farthest = std::max(farthest, std::hypot(section.place(k)[0] - sum[0], section.place(k)[1] - sum[1]));
  return std::hypot(p - sum[0], q - sum[1]) <= 1.5 * farthest;
}

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
  constexpr double digits = 1e12;  // points of one station have one angle
  angle = std::round(angle * digits) / digits;
  Place place;
  for (; place.element < s.plane().elements(); ++place.element)
    if (may_have(s, place.element, p, q) && find_reference(s, place.element, p, q, place.xi, place.eta)) return place;
  fail(Status::err_argument, "the point (%.9g, %.9g, %.9g) is outside the body", x[0], x[1], x[2]);
}

SectionFields::Stations SectionFields::by_angle(const std::vector<double>& angle,
                                                const std::vector<Place>& place) const {
  std::map<double, std::vector<std::int64_t>> found;
  Stations all;
  for (std::size_t k = 0; k < angle.size(); ++k) {
    found[angle[k]].push_back(static_cast<std::int64_t>(k));
    const auto nodes = system_.section().plane().element(place[k].element);
    all.node.insert(all.node.end(), nodes.begin(), nodes.end());
  }
  std::sort(all.node.begin(), all.node.end());
  all.node.erase(std::unique(all.node.begin(), all.node.end()), all.node.end());
  for (auto& [key, points] : found) all.angle.push_back(key), all.point.push_back(std::move(points));
  const auto rows = 2 * std::ssize(all.angle), nodes = std::ssize(all.node);
  all.moved.resize(system_.relaxations(rate_));
  for (std::size_t way = 0; way < all.moved.size(); ++way) {
    Moved& moved = all.moved[way];
    moved.across.resize(rows, 2 * nodes), moved.along.resize(rows, nodes);
    const double modulus = system_.modulus(way, 0, 0).real();
    for (std::int64_t r = 0; r < rows && !own_.empty(); r += 2)
      for (std::int64_t i = 0; i < nodes; ++i) {
        const double* own = own_.data() + 3 * at(all.node[at(i)]);
        double* across = moved.across.row(r) + 2 * i;
        across[0] = modulus * own[0], across[1] = modulus * own[2], moved.along.row(r)[i] = modulus * own[1];
      }
  }
  return all;
}

// Displacements across the way go with the cosine of forces across it and with the sine, of opposite sign, of forces
// along it; those along the way with the others. Lagging parts have the sine in place of the cosine,
// and the cosine, of opposite sign, in place of the sine.
void SectionFields::sum(Stations& all, int threads) const {
  if (force_.empty()) return;
  const BlasThreads blas(threads);
  const auto width = 3 * std::ssize(system_.section().profile()), nodes = std::ssize(all.node),
             angles = std::ssize(all.angle);
  // By angle, sample and column (profile node, component, kernel): the value, and its derivative.
  std::vector<std::vector<double>> acting(at(angles));
  parallel_for(angles, 1, threads,
               [&](std::int64_t k, int) { acting[at(k)] = system_.sampled(force_, all.angle[at(k)], true); });
  RowMatrix<double> across, along, to_across, to_along;
  across.resize(2 * angles, width), along.resize(2 * angles, width);
  to_across.resize(width, 2 * nodes), to_along.resize(width, nodes);
  for (std::size_t s = 0; s < system_.samples(); ++s) {
    const Displaced everywhere = system_.sample_everywhere(s, rate_);
    const std::int64_t rows = std::ssize(everywhere.part) / width;
    for (const bool lags : {false, true}) {
      if (lags && everywhere.lags.empty()) continue;
      for (std::int64_t b = 0; b < width; ++b)
        for (std::int64_t r = 0; r < 2 * angles; ++r) {
          const double* q = acting[at(r / 2)].data() + 4 * (width * static_cast<std::int64_t>(s) + b) + 2 * (r % 2);
          const double cosine = lags ? -q[1] : q[0], sine = lags ? q[0] : q[1];
          across.row(r)[b] = b % 3 == 1 ? -sine : cosine;
          along.row(r)[b] = b % 3 == 1 ? cosine : sine;
        }
      for (std::size_t way = 0; way < all.moved.size(); ++way) {
        const std::complex<double> modulus = system_.modulus(way, s, rate_);
        for (std::int64_t b = 0; b < width; ++b)
          for (std::int64_t i = 0; i < nodes; ++i) {
            const std::size_t here = at(b * rows + 3 * all.node[at(i)]);
            const auto u = [&](std::size_t c) {
              const double part = everywhere.part[here + c];
              if (everywhere.lags.empty()) return part;
              const std::complex<double> of = modulus * std::complex<double>(part, everywhere.lags[here + c]);
              return lags ? of.imag() : of.real();
            };
            to_across.row(b)[2 * i] = u(0), to_across.row(b)[2 * i + 1] = u(2), to_along.row(b)[i] = u(1);
          }
        add_product(across, to_across, all.moved[way].across);
        add_product(along, to_along, all.moved[way].along);
      }
    }
  }
}

void SectionFields::evaluate(const Stations& all, std::size_t k, const Place& place, Vec3* moved,
                             double* stress) const {
  const SweptSection& s = system_.section();
  const auto nodes = s.plane().element(place.element);
  const PlanePoint here = plane_point(s, place.element, place.xi, place.eta);
  Elastic m;
  const Moved& source = all.moved[stress ? system_.relaxation_of(place.element, rate_, m) : 0];
  double u[3] = {}, by_angle[3] = {}, g[3][3] = {};  // g: derivative of component c along axis d
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const auto i = std::lower_bound(all.node.begin(), all.node.end(), nodes[a]) - all.node.begin();
    for (std::size_t c = 0; c < 3; ++c) {
      const RowMatrix<double>& part = c == 1 ? source.along : source.across;
      const std::int64_t row = 2 * static_cast<std::int64_t>(k), column = c == 1 ? i : 2 * i + (c == 2);
      const double value = part.row(row)[column];
      u[c] += here.value[a] * value;
      by_angle[c] += here.value[a] * part.row(row + 1)[column];
      g[c][0] += here.dp[a] * value, g[c][2] += here.dq[a] * value;
    }
  }
  const auto axes = s.axes(all.angle[k]).all();
  if (moved) *moved = u[0] * axes[0] + u[1] * axes[1] + u[2] * axes[2];
  if (!stress) return;
  const double wave = 1 / s.way(std::max(here.p, 1e-12 * s.way(1))), curve = s.revolved() ? wave : 0;
  for (std::size_t c = 0; c < 3; ++c) g[c][1] = wave * by_angle[c];
  g[1][1] += curve * u[0];
  g[0][1] -= curve * u[1];
  const double shear = m.young / (2 * (1 + m.poisson)), lame = 2 * shear * m.poisson / (1 - 2 * m.poisson);
  const double trace = g[0][0] + g[1][1] + g[2][2];
  double t[3][3] = {};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      const double local = shear * (g[a][b] + g[b][a]) + (a == b ? lame * trace : 0);
      for (std::size_t x = 0; x < 3; ++x)
        for (std::size_t y = 0; y < 3; ++y) t[x][y] += axes[a][x] * local * axes[b][y];
    }
  const double found[6] = {t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]};
  std::copy(found, found + 6, stress);
}

void SectionFields::at_points(std::int64_t n, const double* xyz, double* displacement, double* stress,
                              int threads) const {
  std::vector<double> angle(at(n));
  std::vector<Place> place;
  for (std::int64_t k = 0; k < n; ++k)
    place.push_back(find({xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]}, angle[at(k)]));
  Stations all = by_angle(angle, place);
  sum(all, threads);
  for (std::size_t a = 0; a < all.angle.size(); ++a)
    for (const std::int64_t k : all.point[a]) {
      Vec3 moved;
      if (displacement) evaluate(all, a, place[at(k)], &moved, nullptr);
      if (displacement) std::copy(moved.begin(), moved.end(), displacement + 3 * k);
      if (stress) evaluate(all, a, place[at(k)], nullptr, stress + 6 * k);
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
  Stations all = by_angle(angle, place);
  sum(all, threads);
  std::fill_n(stress, 6 * width * stations, 0.0);
  for (std::size_t a = 0; a < all.angle.size(); ++a)
    for (const std::int64_t k : all.point[a]) {
      double own[6];
      evaluate(all, a, place[at(k)], nullptr, own);
      for (std::size_t c = 0; c < 6; ++c) stress[6 * target[at(k)] + c] += own[c] / count[target[at(k)] % width];
    }
}

}  // namespace rollcon::section
