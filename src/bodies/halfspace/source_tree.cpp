#include "bodies/halfspace/source_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/shape.hpp"
#include "quadrature/rules.hpp"
#include "support/index.hpp"

namespace rollcon::halfspace {
namespace {

constexpr int leaf_elements = 16;
constexpr int most_line = 16;  ///< Chebyshev points along a side, at most
/// Error of a box over error rho^-q times integral of |t|/R^2; tests/bodies/halfspace/inside/boxes_test.cpp.
constexpr double box_constant = 0.8;
/// The largest grid serves from here at the latest.
constexpr double nearest_axis = 2.2;

/// Computes Lagrange functions of q Chebyshev points: L_k(x) = (1 + 2 sum over m of T_m(x) T_m(x_k)) / q.
class Chebyshev {
 public:
  explicit Chebyshev(int q) : q_(q) {
    for (int k = 0; k < q; ++k)
      for (int m = 0; m < q; ++m) t_[k][m] = std::cos(m * (2 * k + 1) * std::numbers::pi / (2 * q));
  }
  double point(int k) const { return t_[k][1]; }
  void values(double x, double* value) const {
    double t[most_line];
    t[0] = 1;
    t[1] = x;
    for (int m = 2; m < q_; ++m) t[m] = 2 * x * t[m - 1] - t[m - 2];
    for (int k = 0; k < q_; ++k) {
      double sum = 0;
      for (int m = 1; m < q_; ++m) sum += t[m] * t_[k][m];
      value[k] = (1 + 2 * sum) / q_;
    }
  }

 private:
  int q_;
  double t_[most_line][most_line];
};

const Chebyshev& chebyshev(int q) {
  static const std::vector<Chebyshev> all = [] {
    std::vector<Chebyshev> tables;
    for (int k = 2; k <= most_line; ++k) tables.emplace_back(k);
    return tables;
  }();
  return all[at(q - 2)];
}

int padded(int n) {
  return (n + point_padding - 1) / point_padding * point_padding;
}

/// Adds forces at one point to a grid.
void spread(const double* lx, const double* ly, int q, const double* f, double* const* grid) {
  for (int c = 0; c < 3; ++c)
    for (int j = 0; j < q; ++j) {
      const double weight = ly[j] * f[c];
      double* row = grid[c] + j * q;
      for (int i = 0; i < q; ++i) row[i] += weight * lx[i];
    }
}

/// Holds Lagrange functions of a grid at the Chebyshev points of another: value[from][to].
struct Passage {
  double value[most_line][most_line];

  /// The other grid's points are at centre + half x in units of this one's side.
  Passage(int from, int to, double centre, double half) {
    for (int i = 0; i < from; ++i) chebyshev(to).values(centre + half * chebyshev(from).point(i), value[i]);
  }
};

/// Adds the forces of one grid to another, direction by direction.
void pass(const double* from, int q_from, const Passage& x, const Passage& y, double* to, int q_to) {
  for (int j = 0; j < q_from; ++j) {
    double row[most_line] = {};
    for (int i = 0; i < q_from; ++i)
      for (int k = 0; k < q_to; ++k) row[k] += from[j * q_from + i] * x.value[i][k];
    for (int m = 0; m < q_to; ++m)
      for (int k = 0; k < q_to; ++k) to[m * q_to + k] += y.value[j][m] * row[k];
  }
}

}  // namespace

void plain_rule(ElementType type, int degree, NearPoints& points) {
  const bool triangle = corner_count(type) == 3;
  const int along = degree / 2 + 1;
  quadrature::fill_rule(triangle, triangle ? degree : along, along, points);
}

SourceTree::SourceTree(std::span<const LoadedElement> elements, double error) : elements_(elements) {
  const double digits = std::log(box_constant / error);
  const double nearest = nearest_axis + std::sqrt(nearest_axis * nearest_axis - 1);
  const int most = static_cast<int>(to_index(std::clamp(std::ceil(digits / std::log(nearest)), 6.0, 1.0 * most_line)));
  for (int g = 0; g < grids; ++g) {
    q_[g] = std::max(3, most * (g + 2) / (grids + 1));
    padded_[g] = padded(q_[g] * q_[g]);
    const double rho = std::exp(digits / q_[g]), axis = 0.5 * (rho + 1 / rho);
    least_axis2_[g] = axis * axis;
  }
  order_.resize(elements.size());
  for (std::size_t e = 0; e < order_.size(); ++e) order_[e] = static_cast<std::int32_t>(e);
  boxes_.push_back({.first = 0, .last = static_cast<std::int32_t>(order_.size())});
  for (std::size_t b = 0; b < boxes_.size(); ++b) divide(static_cast<std::int32_t>(b));
  for (int g = 0; g < grids; ++g) data_[g].assign(boxes_.size() * 5 * at(padded_[g]), 0.0);
  for (std::size_t b = boxes_.size(); b-- > 0;) collect(static_cast<std::int32_t>(b));
}

void SourceTree::divide(std::int32_t number) {
  Box box = boxes_[at(number)];
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (std::int32_t i = box.first; i < box.last; ++i) {
    const InteriorElement& e = elements_[at(order_[at(i)])].element;
    for (int k = 0; k < node_count(e.type); ++k) {
      low[0] = std::min(low[0], e.x[k]), high[0] = std::max(high[0], e.x[k]);
      low[1] = std::min(low[1], e.y[k]), high[1] = std::max(high[1], e.y[k]);
    }
  }
  box.x = 0.5 * (low[0] + high[0]), box.y = 0.5 * (low[1] + high[1]);
  box.half_x = 0.5 * (high[0] - low[0]), box.half_y = 0.5 * (high[1] - low[1]);
  if (box.last - box.first > leaf_elements) {
    const std::size_t side = box.half_x >= box.half_y ? 0 : 1;
    const std::int32_t middle = box.first + (box.last - box.first) / 2;
    const auto centre = [&](std::int32_t e) { return elements_[at(e)].geometry.shape.centre[side]; };
    std::nth_element(order_.begin() + box.first, order_.begin() + middle, order_.begin() + box.last,
                     [&](std::int32_t a, std::int32_t b) { return centre(a) < centre(b); });
    box.child = static_cast<std::int32_t>(boxes_.size());
    boxes_.push_back({.first = box.first, .last = middle});
    boxes_.push_back({.first = middle, .last = box.last});
  }
  boxes_[at(number)] = box;
}

/// Fills the largest grid of a box from its elements or its two halves, then the smaller grids from that.
void SourceTree::collect(std::int32_t number) {
  constexpr int top = grids - 1;
  const Box& box = boxes_[at(number)];
  for (int g = 0; g < grids; ++g) {
    double* x = data(number, g);
    for (int k = 0; k < padded_[g]; ++k) {
      const int used = std::min(k, q_[g] * q_[g] - 1);
      x[k] = box.x + box.half_x * chebyshev(q_[g]).point(used % q_[g]);
      x[padded_[g] + k] = box.y + box.half_y * chebyshev(q_[g]).point(used / q_[g]);
    }
  }
  const auto take = [&](const Box& from, std::int32_t from_number, int g) {
    const Passage x(q_[top], q_[g], (from.x - box.x) / box.half_x, from.half_x / box.half_x);
    const Passage y(q_[top], q_[g], (from.y - box.y) / box.half_y, from.half_y / box.half_y);
    for (int c = 2; c < 5; ++c)
      pass(data(from_number, top) + c * padded_[top], q_[top], x, y, data(number, g) + c * padded_[g], q_[g]);
  };
  if (box.child >= 0)
    for (const std::int32_t half : {box.child, box.child + 1}) take(boxes_[at(half)], half, top);
  else
    for (std::int32_t i = box.first; i < box.last; ++i) add_element(elements_[at(order_[at(i)])], number);
  for (int g = 0; g < top; ++g) take(box, number, g);
}

void SourceTree::add_element(const LoadedElement& e, std::int32_t number) {
  constexpr int top = grids - 1;
  const Box& box = boxes_[at(number)];
  const Chebyshev& chebyshev_points = chebyshev(q_[top]);
  const InteriorElement& element = e.element;
  double* grid[3];
  for (int c = 0; c < 3; ++c) grid[c] = data(number, top) + (2 + c) * padded_[top];
  NearPoints points;
  plain_rule(element.type, q_[top] - 1 + quadrature::direction_degree(element.type, e.geometry.map), points);
  for (int q = 0; q < points.n; ++q) {
    Shape s;
    evaluate_shape(element.type, points.xi[q], points.eta[q], s);
    double x = 0, y = 0, xu = 0, xv = 0, yu = 0, yv = 0, f[3] = {0, 0, 0};
    for (int k = 0; k < node_count(element.type); ++k) {
      const double n = s.value[at(k)], u = s.d_xi[at(k)], v = s.d_eta[at(k)];
      x += n * element.x[k], xu += u * element.x[k], xv += v * element.x[k];
      y += n * element.y[k], yu += u * element.y[k], yv += v * element.y[k];
      for (int c = 0; c < 3; ++c) f[c] += n * element.traction[c][k];
    }
    for (double& component : f) component *= points.w[q] * (xu * yv - xv * yu);
    double lx[most_line], ly[most_line];
    chebyshev_points.values((x - box.x) / box.half_x, lx);
    chebyshev_points.values((y - box.y) / box.half_y, ly);
    spread(lx, ly, q_[top], f, grid);
  }
}

double ellipse_axis2(double along, double beside, double z, double half_along, double half_beside) {
  const double x = std::abs(along) / half_along, away = std::max(std::abs(beside) - half_beside, 0.0);
  const double sum = x * x + 1 + (away * away + z * z) / (half_along * half_along);
  return 0.5 * (sum + std::sqrt(std::max(sum * sum - 4 * x * x, 0.0)));
}

int SourceTree::grid(const Box& box, const InteriorPoint& at) const {
  const double x = at.x - box.x, y = at.y - box.y;
  const double least =
      std::min(ellipse_axis2(x, y, at.z, box.half_x, box.half_y), ellipse_axis2(y, x, at.z, box.half_y, box.half_x));
  for (int g = 0; g < grids; ++g)
    if (least >= least_axis2_[g]) return g;
  return -1;
}

InteriorForces SourceTree::forces(std::int64_t box, int grid) const {
  const double* x = data_[grid].data() + box * 5 * padded_[grid];
  const std::ptrdiff_t p = padded_[grid];
  return {q_[grid] * q_[grid], x, x + p, {x + 2 * p, x + 3 * p, x + 4 * p}};
}

}  // namespace rollcon::halfspace
