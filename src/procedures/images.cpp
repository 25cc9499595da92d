#include "procedures/images.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/index.hpp"

namespace rollcon {
namespace {

bool vanishes(const RowMatrix<double>& a) {
  const double* first = a.data();
  return std::all_of(first, first + a.rows() * a.columns(), [](double v) { return v == 0; });
}

}  // namespace

// Calls visit(point, weight) for image r of a node in displacements at the nodes and the points upstream.
template <class Visit>
void Images::stencil(std::int64_t k, int r, Visit visit) const {
  const SparseRows& d = problem_.convection.rows;
  if (r == 2 || kind_ == Tangential::shift) return visit(k, 1.0);
  for (auto e = at(d.start[at(k)]); e < at(d.start[at(k + 1)]); ++e)
    visit(std::int64_t{d.column[e]}, problem_.convection.factor[at(k)] * d.value[e]);
}

Images::Images(const Problem& problem, const Frame& frame, const Compliance& compliance, Tangential kind)
    : problem_(problem), kind_(kind) {
  ComplianceBlock out;
  out.stride = problem.nodes;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      if (!wanted(r, c)) continue;
      block_[at(r)][at(c)] = problem.op->row(r, c, 0);
      if (kind != Tangential::shift || r == 2 || (c == 2 && !problem.op->coupled)) continue;
      own_[r][c].resize(problem.nodes, problem.nodes);
      out.a[r][c] = own_[r][c].data();
      block_[at(r)][at(c)] = own_[r][c].data();
    }
  if (kind == Tangential::shift) compliance.block({frame.x, frame.y}, out);
}

Images::Images(const Problem& problem, const ExpandedCompliance& expanded, const BodiesEquations& bodies,
               Tangential kind)
    : problem_(problem), kind_(kind) {
  const std::int64_t n = problem.nodes;
  const RowMatrix<double>& direct = expanded.direct;
  for (int r = 0; r < 3 && !direct.empty(); ++r)
    for (int c = 0; c < 3; ++c) {
      if (!wanted(r, c)) continue;
      RowMatrix<double>& made = own_[r][c];
      made.resize(n, n);
      for (std::int64_t k = 0; k < n; ++k)
        stencil(k, r, [&](std::int64_t point, double weight) {
          const double* from = direct.row(3 * point + r) + c;
          for (std::int64_t j = 0; j < n; ++j) made.row(k)[j] += weight * from[3 * j];
        });
      if (vanishes(made))
        made.release();
      else
        block_[at(r)][at(c)] = made.data();
    }
  unknown_.begin(bodies.unknowns());
  for (std::int64_t k = 0; k < n; ++k)
    for (int r = 0; r < 3; ++r) {
      for (std::size_t b = 0; b < expanded.body.size() && wanted(r, 2); ++b)
        stencil(k, r, [&](std::int64_t point, double weight) {
          const BodiesEquations::Body& body = bodies.bodies()[b];
          entries(expanded.body[b].displacement, 3 * point + r,
                  [&](std::int64_t i, double v) { unknown_.push(body.first + i, weight * v * body.column[at(i)]); });
        });
      unknown_.end_column();
    }
}

void Images::apply(Point& z) const {
  const std::int64_t n = problem_.nodes;
  const bool shift = kind_ == Tangential::shift;
  std::vector<double>* const to[3] = {shift ? &z.shift[0] : &z.slip[0], shift ? &z.shift[1] : &z.slip[1], &z.depth};
  for (int r = 0; r < 3; ++r) {
    std::vector<double>& image = *to[r];
    image.assign(at(n), 0.0);
    for (std::size_t c = 0; c < 3; ++c)
      if (const double* block = block_[at(r)][c]) multiply(block, n, n, z.lambda[c].data(), 1, image.data());
    for (std::int64_t k = 0; k < n; ++k)
      per_unknown(k, r, [&](std::int64_t i, double v) { image[at(k)] += v * z.inner[at(i)]; });
  }
  if (!shift) return;
  std::vector<double> w(at(3 * n));
  for (std::size_t k = 0; k < at(n); ++k)
    for (std::size_t c = 0; c < 2; ++c) w[3 * k + c] = z.shift[c][k];
  convect(problem_.convection, w.data(), nullptr, z.slip);
}

// Estimates displacements by normal and tangential tractions at a node: of a disc of the node's area near it, of a
// point force far from it (Johnson, Contact mechanics, 3.2). Tangential ones come without their coupling, for a
// Poisson's ratio of about 0.3.
Blocks Images::rough(const Frame& frame) {
  constexpr double softer = 1.2;
  const Problem& p = problem_;
  const std::int64_t n = p.nodes;
  const auto displacement = [&](std::int64_t point, std::size_t j) {
    const std::size_t k = at(point % n);
    const double x = frame.x[k] + (point < n ? 0 : p.convection.ahead[k]);
    const double radius = std::sqrt(p.cell_area[j] / std::numbers::pi);
    const double r = std::max(std::hypot(x - frame.x[j], frame.y[k] - frame.y[j]), radius / 2);
    return p.cell_area[j] / (std::numbers::pi * p.stiffness * r);
  };
  const bool tangential = kind_ != Tangential::none;
  RowMatrix<double>&normal = rough_[0], &along = rough_[1];
  if (normal.empty()) {
    normal.resize(n, n);
    if (tangential) along.resize(n, n);
    for (std::int64_t k = 0; k < n; ++k)
      for (std::int64_t j = 0; j < n; ++j) normal.row(k)[j] = displacement(k, at(j));
    for (std::int64_t k = 0; k < n && tangential; ++k)
      stencil(k, 0, [&](std::int64_t point, double weight) {
        for (std::int64_t j = 0; j < n; ++j)
          along.row(k)[j] += weight * softer * (point < n ? normal.row(point)[j] : displacement(point, at(j)));
      });
  }
  Blocks made{};
  made[2][2] = normal.data();
  if (tangential) made[0][0] = made[1][1] = along.data();
  return made;
}

std::size_t Images::bytes() const {
  std::size_t sum = unknown_.bytes() + rough_[0].bytes() + rough_[1].bytes();
  for (const auto& row : own_)
    for (const auto& block : row) sum += block.bytes();
  return sum;
}

}  // namespace rollcon
