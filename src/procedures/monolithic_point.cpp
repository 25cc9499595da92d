/// Between iterates and unknowns of the monolithic system. An iterate's `inner` are the unknowns of
/// the bodies, in units of traction, and then the tangential displacements.

#include <algorithm>

#include "procedures/monolithic_matrix.hpp"
#include "support/index.hpp"

namespace rollcon {

void MonolithicMatrix::start(const Point& z, std::vector<double>& x) const {
  const Problem& p = problem_;
  const std::int64_t n = bodies_.nodes(), nd = bodies_.unknowns();
  x.assign(at(size()), 0.0);
  std::array<double, 4> motions = z.motion;
  for (std::size_t m = 0; m < 4; ++m)
    if (!p.by_force[m]) motions[m] = p.value[m];
  std::copy_n(z.inner.begin(), nd, x.begin());
  for (std::int64_t k = 0; k < n; ++k) {
    const double rn = bodies_.rn()[at(k)], rt = bodies_.rt()[at(k)];
    const std::array<double, 3> g{rn * z.inner[at(nd + 2 * k)], rn * z.inner[at(nd + 2 * k + 1)],
                                  rn * (p.rigid_gap(at(k), motions[approach]) - z.depth[at(k)])};
    for (int c = first_component(); c < 3; ++c) {
      if (reduced()) {
        const PairState state = step_->state[at(k)];
        const bool own = state == PairState::stick || (state == PairState::slip && c == 2);
        x[at(traction(k, c))] = own ? z.lambda[c][at(k)] : g[at(c)];
        continue;
      }
      x[at(traction(k, c))] = z.lambda[c][at(k)];
      x[at(gap(k, c))] = g[at(c)];
    }
    if (!full()) continue;
    x[at(slip(k, 0))] = rt * (p.rigid_slip1(k, motions) + z.slip[0][at(k)]);
    x[at(slip(k, 1))] = rt * (p.rigid_slip2(k, motions) + z.slip[1][at(k)]);
  }
  for (std::size_t b = 0; b < border_.size(); ++b)
    x[at(motion(b))] = motions[at(border_[b].motion)] * border_[b].scale;
}

void MonolithicMatrix::scatter(const std::vector<double>& x, Point& next) {
  const Problem& p = problem_;
  const std::int64_t n = bodies_.nodes(), nd = bodies_.unknowns();
  for (std::size_t m = 0; m < 4; ++m)
    if (!p.by_force[m]) next.motion[m] = p.value[m];
  for (std::size_t b = 0; b < border_.size(); ++b)
    next.motion[at(border_[b].motion)] = x[at(motion(b))] / border_[b].scale;
  expand(x.data());
  for (auto& v : next.lambda) v.assign(at(n), 0.0);
  for (auto& v : next.slip) v.assign(at(n), 0.0);
  next.depth.resize(at(n));
  next.inner.resize(at(nd + 2 * n));
  std::copy_n(x.begin(), nd, next.inner.begin());
  for (std::int64_t k = 0; k < n; ++k) {
    double* t = &t_[at(3 * k)];
    double* g = &k_[at(3 * k)];
    if (form_ == MonolithicForm::frictionless) t[0] = t[1] = 0;
    if (!touching(k)) std::fill(t, t + 3, 0.0);  // exactly, however accurate the solution
    const PairState state = step_->state[at(k)];
    if (reduced() && state == PairState::slip)
      for (int c = 0; c < 2; ++c) t[c] += step_->law[at(k)].constant[c];
    if (reduced() && state == PairState::stick)
      for (int c = 0; c < 2; ++c) {
        g[c] = bodies_.rn()[at(k)] * step_->target[c][at(k)];
        for (std::size_t b = 0; b < border_.size(); ++b)
          g[c] -= gap_entry(border_[b], k, c) * x[at(motion(b))];
      }
    for (int c = 0; c < 3; ++c) next.lambda[c][at(k)] = t[c];
    const double kn = g[2] / bodies_.rn()[at(k)];
    next.depth[at(k)] = p.rigid_gap(at(k), next.motion[approach]) - kn;
  }
  const bool slides = !p.op.upstream.empty() || !p.op.convection.start.empty();
  if (form_ != MonolithicForm::full) {
    bodies_.displacements(x.data(), t_.data(), u_.data());
    if (form_ == MonolithicForm::frictionless)
      for (std::int64_t k = 0; k < n; ++k)
        for (int c = 0; c < 2; ++c) k_[at(3 * k + c)] = bodies_.rn()[at(k)] * u_[at(3 * k + c)];
  }
  for (std::int64_t k = 0; k < n; ++k)
    for (int c = 0; c < 2; ++c) {
      const double shift = k_[at(3 * k + c)] / bodies_.rn()[at(k)];
      next.inner[at(nd + 2 * k + c)] = shift;
      if (!next.shift[c].empty()) next.shift[c][at(k)] = shift;
      if (!slides) continue;
      const double rt = bodies_.rt()[at(k)];
      const double rigid = c == 0 ? p.rigid_slip1(k, next.motion) : p.rigid_slip2(k, next.motion);
      next.slip[c][at(k)] =
          full() ? x[at(slip(k, c))] / rt - rigid : convected(k_.data(), u_.data(), k, c) / rt;
    }
}

}  // namespace rollcon
