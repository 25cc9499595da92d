#include "procedures/monolithic_krylov.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/index.hpp"

namespace rollcon {
namespace {

// Tractions of all nodes from the core's unknowns.
void take_tractions(const MonolithicCore& core, const double* contact, std::vector<double>& t) {
  t.assign(at(3 * core.matrix().bodies().nodes()), 0.0);
  const auto unknowns = core.unknowns();
  for (std::size_t a = 0; a < unknowns.size(); ++a)
    for (std::size_t c = 0; c < 3; ++c)
      t[3 * at(unknowns[a].node) + c] += unknowns[a].traction[c] * contact[a];
}

}  // namespace

void CoreProduct::apply(const double* x, double* y) {
  const MonolithicCore& core = *core_;
  const MonolithicBodies& bodies = core.matrix().bodies();
  const auto unknowns = core.unknowns();
  const double* contact = x + core.first();
  const double* motions = contact + unknowns.size();
  take_tractions(core, contact, t_);
  u_.resize(at(bodies.places()));
  bodies.displacements(x, t_.data(), u_.data());
  bodies.balance(x, t_.data(), y);
  double* out = y + core.first();
  for (std::size_t a = 0; a < unknowns.size(); ++a) {
    double sum = 0;
    core.row(a, [&](std::int64_t place, double w) { sum += w * u_[at(place)]; });
    for (std::size_t b = core.of_node(unknowns[a].node); b < core.of_node(unknowns[a].node + 1);
         ++b)
      sum += core.own(a, b) * contact[b];
    for (std::size_t b = 0; b < core.borders(); ++b) sum += core.border(a, b) * motions[b];
    out[a] = sum;
  }
  for (std::size_t b = 0; b < core.borders(); ++b) {
    double sum = 0;
    for (std::size_t a = 0; a < unknowns.size(); ++a) sum += core.load(b, a) * contact[a];
    out[unknowns.size() + b] = sum;
  }
}

void CoreDiagonal::take(const MonolithicCore& core, bool divide) {
  const MonolithicBodies& bodies = core.matrix().bodies();
  factor_.assign(at(core.size()), 1.0);
  row_ = bodies.own_rows();
  for (std::int64_t i = core.first(); i < core.size(); ++i) row_.push_back(i);
  const auto factor = [divide](double entry) {
    if (entry == 0) return 1.0;
    return divide ? 1 / entry : std::copysign(1.0, entry);
  };
  for (const MonolithicBodies::Body& body : bodies.bodies()) {
    const BodyEquations& e = *body.equations;
    for (std::int64_t j = 0; j < e.unknowns; ++j) {
      const std::int64_t own = row_[at(body.first + j)] - body.first;
      double entry = 0;
      if (!e.dense.empty()) {
        entry = e.dense[at(own + j * e.unknowns)];
      } else {
        for (std::int64_t i = e.matrix.start[at(j)]; i < e.matrix.start[at(j + 1)]; ++i)
          if (e.matrix.row[at(i)] == own) entry = e.matrix.value[at(i)];
      }
      entry *= body.row[at(own)] * body.column[at(j)];
      factor_[at(body.first + j)] = factor(entry);
    }
  }
  const auto unknowns = core.unknowns();
  for (std::size_t a = 0; a < unknowns.size(); ++a) {
    double entry = core.own(a, a);
    if (const double* direct = bodies.direct())
      for (int c = 0; c < 3; ++c)
        core.row(a, [&](std::int64_t place, double w) {
          entry += w * unknowns[a].traction[at(c)] *
                   direct[place + (3 * unknowns[a].node + c) * bodies.places()];
        });
    factor_[at(core.first()) + a] = factor(entry);
  }
}

void CoreDiagonal::apply(const double* x, double* y) {
  for (std::size_t i = 0; i < factor_.size(); ++i) y[i] = factor_[i] * x[row_[i]];
}

// Displacements at places by normal and tangential tractions at a node: of a disc of the node's
// area near it, of a point force far from it (Johnson, Contact mechanics, 3.2). Tangential ones
// without their coupling, for a Poisson's ratio of about 0.3.
void CoreBodies::fill(const Frame& frame) {
  const MonolithicCore& core = *core_;
  const Problem& p = core.matrix().problem();
  const auto unknowns = core.unknowns();
  const std::int64_t n = bodies_.nodes(), size = core.size() - core.first();
  const bool ahead = bodies_.ahead();
  constexpr double tangential = 1.2;
  matrix_.assign(at(size * size), 0.0);
  std::vector<double> kernel(at(ahead ? 2 * n : n));
  for (std::size_t b = 0; b < unknowns.size(); ++b) {
    const std::size_t j = at(unknowns[b].node);
    if (b == 0 || unknowns[b - 1].node != unknowns[b].node) {
      const double area = p.cell_area[j], radius = std::sqrt(area / std::numbers::pi);
      for (std::size_t i = 0; i < kernel.size(); ++i) {
        const std::size_t k = i % at(n);
        const double x = frame.x[k] + (i < at(n) ? 0 : p.op.upstream[k]);
        const double r = std::hypot(x - frame.x[j], frame.y[k] - frame.y[j]);
        kernel[i] = area / (std::numbers::pi * p.stiffness * std::max(r, radius / 2));
      }
    }
    for (std::size_t a = 0; a < unknowns.size(); ++a) {
      double sum = core.own(a, b);
      core.row(a, [&](std::int64_t place, double w) {
        const bool upstream = place >= 3 * n;
        const std::int64_t c = upstream ? (place - 3 * n) % 2 : place % 3;
        const std::int64_t i = upstream ? n + (place - 3 * n) / 2 : place / 3;
        const double t = unknowns[b].traction[at(c)];
        sum += w * t * kernel[at(i)] * (c == 2 ? 1 : tangential);
      });
      matrix_[a * at(size) + b] = sum;
    }
  }
  for (std::size_t b = 0; b < core.borders(); ++b)
    for (std::size_t a = 0; a < unknowns.size(); ++a) {
      const std::size_t m = unknowns.size() + b;
      matrix_[a * at(size) + m] = core.border(a, b);
      matrix_[m * at(size) + a] = core.load(b, a);
    }
}

bool CoreBodies::take(const MonolithicCore& core, const Frame& frame, bool fresh) {
  core_ = &core;
  key_.clear();
  for (const MonolithicCore::Unknown& unknown : core.unknowns())
    key_.push_back(3 * unknown.node + unknown.component);
  for (const auto& border : core.matrix().borders()) key_.push_back(-1 - border.motion);
  still_.assign(at(core.first()), 0.0);
  forces_.resize(at(core.first()));
  if (fresh || !contact_.valid()) {
    fill(frame);
    if (!contact_.factor(key_, matrix_.data())) return false;
  }
  contact_.match(key_);
  return true;
}

void CoreBodies::apply(const double* x, double* y) {
  const MonolithicCore& core = *core_;
  const std::int64_t nd = core.first();
  contact_.apply(x + nd, y + nd);
  if (nd == 0) return;
  take_tractions(core, y + nd, t_);
  bodies_.balance(still_.data(), t_.data(), forces_.data());
  for (std::int64_t i = 0; i < nd; ++i) y[i] = x[i] - forces_[at(i)];
  bodies_.solve(y);
}

}  // namespace rollcon
