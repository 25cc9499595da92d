#include "bodies/halfspace/far_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/shape.hpp"
#include "quadrature/rules.hpp"
#include "support/index.hpp"

namespace rollcon::halfspace {
namespace {

constexpr int most_line_points = 7;       ///< points a direction of precomputed rules on quadrilaterals
constexpr int most_triangle_degree = 12;  ///< degree of precomputed rules on triangles
constexpr double nearest = 2.5;           ///< distance in half-lengths below which the near field decides

int padded(int n, int multiple) {
  return (n + multiple - 1) / multiple * multiple;
}

}  // namespace

ElementGeometry plane_geometry(const Frame& frame, std::int64_t element) {
  Vec3 node[max_element_nodes];
  const auto ids = frame.mesh.element(element);
  for (std::size_t k = 0; k < ids.size(); ++k) node[k] = {frame.x[at(ids[k])], frame.y[at(ids[k])], 0};
  return element_geometry(frame.mesh.type[at(element)], {node, ids.size()});
}

FarGroup::FarGroup(const Frame& frame, std::vector<std::int64_t> elements, ElementType type, MapKind map)
    : type_(type), map_(map), elements_(std::move(elements)) {
  for (const std::int64_t e : elements_) {
    shapes_.push_back(plane_geometry(frame, e));
    const CellShape& s = shapes_.back().shape;
    centre_x_.push_back(s.centre[0]);
    centre_y_.push_back(s.centre[1]);
    half2_.push_back(s.half_length * s.half_length);
    area_.push_back(s.area);
    for (const std::int32_t node : frame.mesh.element(e)) connectivity_.push_back(node);
  }
  const int p = direction_degree(type, map);
  if (corner_count(type) == 3) {
    for (const TriangleRule& rule : symmetric_triangle_rules())
      if (rule.degree > p && rule.degree <= most_triangle_degree)
        levels_.push_back(make_level(rule.points, rule.degree));
  } else {
    for (int n = 2; n <= most_line_points; ++n)
      if (2 * n - 1 > p) levels_.push_back(make_level(product_rule(line_rule(n), line_rule(n)), 2 * n - 1));
  }
}

FarGroup::Level FarGroup::make_level(const PlaneRule& rule, int degree) const {
  Level level;
  level.exponent = degree + 1 - direction_degree(type_, map_);
  level.n = static_cast<int>(rule.size());
  level.padded = padded(level.n, point_padding);
  const auto stride = static_cast<std::size_t>(padded(nodes(), shape_padding));
  level.shape.assign(rule.size() * stride, 0.0);
  for (std::size_t q = 0; q < rule.size(); ++q) {
    Shape s;
    evaluate_shape(type_, rule.xi[q], rule.eta[q], s);
    std::copy_n(s.value.begin(), nodes(), level.shape.begin() + static_cast<std::ptrdiff_t>(q * stride));
  }
  for (const ElementGeometry& e : shapes_) {
    for (std::size_t q = 0; q < static_cast<std::size_t>(level.padded); ++q) {
      const std::size_t k = std::min(q, rule.size() - 1);  // padding repeats the last point
      Shape s;
      evaluate_shape(type_, rule.xi[k], rule.eta[k], s);
      double x = 0, y = 0, xu = 0, xv = 0, yu = 0, yv = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(nodes()); ++i) {
        x += s.value[i] * e.node[0][i];
        y += s.value[i] * e.node[1][i];
        xu += s.d_xi[i] * e.node[0][i];
        yu += s.d_xi[i] * e.node[1][i];
        xv += s.d_eta[i] * e.node[0][i];
        yv += s.d_eta[i] * e.node[1][i];
      }
      level.x.push_back(x);
      level.y.push_back(y);
      level.w.push_back(q == k ? rule.w[k] * (xu * yv - xv * yu) : 0.0);
    }
    // R^(m+1) >= C area (a/1.9)^m / tolerance; the tolerance is the observer's.
    const int m = level.exponent;
    level.factor.push_back(
        std::pow(far_constant * e.shape.area * std::pow(e.shape.half_length / 1.9, m), 2.0 / (m + 1)));
  }
  return level;
}

double FarGroup::scale(double px, double py) const {
  double largest = 0;
  for (std::size_t e = 0; e < shapes_.size(); ++e) {
    const double dx = px - centre_x_[e], dy = py - centre_y_[e];
    largest = std::max(largest, area_[e] * area_[e] / (dx * dx + dy * dy + half2_[e]));
  }
  return std::sqrt(largest);
}

void FarGroup::select(double px, double py, double tolerance, std::uint8_t* level) const {
  double observer[32];
  for (std::size_t l = 0; l < levels_.size(); ++l) observer[l] = std::pow(tolerance, -2.0 / (levels_[l].exponent + 1));
  for (std::size_t e = 0; e < shapes_.size(); ++e) {
    const double dx = px - centre_x_[e], dy = py - centre_y_[e], distance2 = dx * dx + dy * dy;
    std::size_t l = 0;
    if (distance2 < nearest * nearest * half2_[e])
      l = levels_.size();
    else
      while (l < levels_.size() && distance2 < levels_[l].factor[e] * observer[l]) ++l;
    level[e] = static_cast<std::uint8_t>(l);
  }
}

FarSources FarGroup::sources(int level) const {
  const Level& l = levels_[static_cast<std::size_t>(level)];
  return {l.n, l.padded, l.x.data(), l.y.data(), l.w.data(), l.shape.data(), nodes(), padded(nodes(), shape_padding)};
}

FarGroup::Forces FarGroup::forces(const double* traction) const {
  Forces forces;
  const auto stride = static_cast<std::size_t>(padded(nodes(), shape_padding));
  for (auto& component : forces.component) component.resize(levels_.size());
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const Level& level = levels_[l];
    for (std::size_t j = 0; j < 3; ++j) {
      std::vector<double>& f = forces.component[j][l];
      f.assign(level.w.size(), 0.0);
      for (std::int64_t e = 0; e < size(); ++e) {
        const std::int32_t* node = connectivity(e);
        const auto first = static_cast<std::size_t>(e * level.padded);
        for (std::size_t q = 0; q < static_cast<std::size_t>(level.n); ++q) {
          double value = 0;
          for (std::size_t i = 0; i < static_cast<std::size_t>(nodes()); ++i)
            value += level.shape[q * stride + i] * traction[3 * static_cast<std::size_t>(node[i]) + j];
          f[first + q] = value * level.w[first + q];
        }
      }
    }
  }
  return forces;
}

std::vector<std::uint8_t> FarGroup::loaded(const double* traction) const {
  std::vector<std::uint8_t> loaded(shapes_.size(), 0);
  for (std::int64_t e = 0; e < size(); ++e)
    for (int i = 0; i < nodes(); ++i) {
      const double* t = traction + 3 * static_cast<std::ptrdiff_t>(connectivity(e)[i]);
      if (t[0] != 0 || t[1] != 0 || t[2] != 0) loaded[static_cast<std::size_t>(e)] = 1;
    }
  return loaded;
}

FarForces FarGroup::sources(int level, const Forces& forces) const {
  const auto k = static_cast<std::size_t>(level);
  const Level& l = levels_[k];
  return {l.padded,
          l.n,
          l.x.data(),
          l.y.data(),
          {forces.component[0][k].data(), forces.component[1][k].data(), forces.component[2][k].data()}};
}

std::size_t FarGroup::bytes() const {
  std::size_t doubles = 4 * shapes_.size();
  for (const Level& l : levels_) doubles += l.shape.size() + 3 * l.x.size() + l.factor.size();
  return doubles * sizeof(double) + shapes_.size() * sizeof(ElementGeometry) +
         connectivity_.size() * sizeof(std::int32_t) + elements_.size() * sizeof(std::int64_t);
}

}  // namespace rollcon::halfspace
