#include "procedures/monolithic_matrix.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {

MonolithicMatrix::MonolithicMatrix(const Problem& problem, const MonolithicBodies& bodies,
                                   MonolithicForm form)
    : problem_(problem), bodies_(bodies), form_(form) {
  const std::int64_t n = bodies.nodes();
  traction_ = bodies.unknowns();
  switch (form) {
    case MonolithicForm::frictionless:
      gap_ = traction_ + n;
      slip_ = motion_ = gap_ + n;
      break;
    case MonolithicForm::full:
      gap_ = traction_ + 3 * n;
      slip_ = gap_ + 3 * n;
      motion_ = slip_ + 2 * n;
      break;
    case MonolithicForm::reduced:
      gap_ = slip_ = motion_ = traction_ + 3 * n;
  }
  t_.resize(at(3 * n));
  k_.resize(at(3 * n));
  u_.resize(at(bodies.places()));
}

void MonolithicMatrix::set(const Step& step) {
  step_ = &step;
  take_borders();
}

void MonolithicMatrix::take_borders() {
  border_.clear();
  const Problem& p = problem_;
  double rn = 0, rt = 0, area = 0, count = 0;
  for (std::int64_t k = 0; k < bodies_.nodes(); ++k) {
    if (!p.used[at(k)]) continue;
    rn += bodies_.rn()[at(k)];
    rt += bodies_.rt()[at(k)];
    area += std::abs(p.weight[at(k)]);
    count += 1;
  }
  if (!(count > 0)) return;
  for (const int m : {xi1, xi2, spin, approach}) {
    if (!p.by_force[at(m)] || (m != approach && form_ == MonolithicForm::frictionless)) continue;
    const double unit = m == spin ? p.length : 1;
    border_.push_back({m, (m == approach ? rn : rt) / count * unit, 1 / (area * unit)});
  }
}

TangentialLaw MonolithicMatrix::law(std::int64_t k) const {
  TangentialLaw law{};
  if (!touching(k)) {
    law.own[0][0] = law.own[1][1] = 1;
    return law;
  }
  law = step_->law[at(k)];
  const double ratio = problem_.rt[at(k)] / bodies_.rt()[at(k)];
  for (auto& row : law.slip)
    for (double& v : row) v *= ratio;
  return law;
}

double MonolithicMatrix::load_entry(const Border& border, std::int64_t k, int c) const {
  return border.per_load * problem_.load_row(border.motion, at(k))[at(c)];
}

double MonolithicMatrix::gap_entry(const Border& border, std::int64_t k, int c) const {
  const double rn = bodies_.rn()[at(k)] / border.scale;
  if (c == 2) return border.motion == approach ? rn * problem_.closing(at(k)) : 0;
  if (!reduced() || step_->state[at(k)] != PairState::stick) return 0;
  return rn * step_->reach[at(k)] * problem_.slip_column(border.motion, at(k))[at(c)];
}

double MonolithicMatrix::slip_entry(const Border& border, std::int64_t k, int c) const {
  return -bodies_.rt()[at(k)] / border.scale * problem_.slip_column(border.motion, at(k))[at(c)];
}

// Tractions (t_) and gap vectors (k_) behind the unknowns, but for what does not depend on them.
void MonolithicMatrix::expand(const double* x) {
  const std::int64_t n = bodies_.nodes();
  if (!reduced()) {
    for (std::int64_t k = 0; k < n; ++k)
      for (int c = first_component(); c < 3; ++c) {
        t_[at(3 * k + c)] = x[traction(k, c)];
        k_[at(3 * k + c)] = x[gap(k, c)];
      }
    return;
  }
  for (std::int64_t k = 0; k < n; ++k) {
    double* t = &t_[at(3 * k)];
    double* g = &k_[at(3 * k)];
    const double* y = x + traction(k, 0);
    std::fill(t, t + 3, 0.0);
    std::fill(g, g + 3, 0.0);
    switch (step_->state[at(k)]) {
      case PairState::stick:
        std::copy(y, y + 3, t);
        break;
      case PairState::slip:
        for (int c = 0; c < 2; ++c) {
          t[c] = -step_->law[at(k)].own[c][2] * y[2];
          g[c] = y[c];
        }
        t[2] = y[2];
        break;
      default:
        std::copy(y, y + 3, g);
    }
  }
}

double MonolithicMatrix::convected(const double* gap, const double* u, std::int64_t k,
                                   int c) const {
  const ContactOperators& op = problem_.op;
  const double rt = bodies_.rt()[at(k)];
  if (!op.upstream.empty()) {
    if (!(op.upstream[at(k)] > 0)) return 0;
    const double ahead = u[3 * bodies_.nodes() + 2 * k + c];
    return rt / op.path(at(k)) * (gap[3 * k + c] / bodies_.rn()[at(k)] - ahead);
  }
  double sum = 0;
  if (op.convection.start.empty()) return 0;
  for (std::int64_t e = op.convection.start[at(k)]; e < op.convection.start[at(k + 1)]; ++e) {
    const std::int64_t j = op.convection.column[at(e)];
    sum += op.convection.value[at(e)] * gap[3 * j + c] / bodies_.rn()[at(j)];
  }
  return rt * sum;
}

// Entries that may differ from zero.
std::int64_t MonolithicMatrix::nonzeros() const {
  const std::int64_t n = bodies_.nodes(), touching_pairs = std::count_if(
                                              step_->state.begin(), step_->state.end(),
                                              [](PairState s) { return s >= PairState::stick; });
  const int components = 3 - first_component();
  const std::int64_t loaded = reduced() ? components * touching_pairs : components * n;
  std::size_t sum = 0;
  for (const MonolithicBodies::Body& body : bodies_.bodies()) {
    sum += body.equations->dense.size() + body.equations->matrix.value.size();
    sum += (body.load.value.size() + body.place.value.size()) * at(components) / 3;
  }
  if (bodies_.direct()) sum += at(loaded * (full() ? bodies_.places() : components * n));
  sum += at((reduced() ? 3 : 2 * components) * n);
  if (full()) sum += 2 * problem_.op.convection.value.size() + at(15 * n);
  return static_cast<std::int64_t>(sum) + 2 * loaded * static_cast<std::int64_t>(border_.size());
}

void MonolithicMatrix::apply(const double* x, double* y) {
  const std::int64_t n = bodies_.nodes();
  const double* d = x;
  expand(x);
  const double* motions = x + motion_;
  if (form_ == MonolithicForm::frictionless) {
    for (std::int64_t k = 0; k < n; ++k) t_[at(3 * k)] = t_[at(3 * k + 1)] = 0;
    bodies_.normal_displacements(d, x + traction_, u_.data());
  } else {
    bodies_.displacements(d, t_.data(), u_.data());
  }
  bodies_.balance(d, t_.data(), y);
  for (std::int64_t k = 0; k < n; ++k) {
    for (int c = first_component(); c < 3; ++c) {
      const double u = u_[at(form_ == MonolithicForm::frictionless ? k : 3 * k + c)];
      double sum = bodies_.rn()[at(k)] * u + sign(c) * k_[at(3 * k + c)];
      for (std::size_t b = 0; b < border_.size(); ++b)
        sum += gap_entry(border_[b], k, c) * motions[b];
      y[traction(k, c)] = sum;
    }
    if (reduced()) continue;
    y[gap(k, 2)] = touching(k) ? k_[at(3 * k + 2)] : t_[at(3 * k + 2)];
    if (!full()) continue;
    const double* s = x + slip(k, 0);
    for (int c = 0; c < 2; ++c) {
      double sum = s[c] - convected(k_.data(), u_.data(), k, c);
      for (std::size_t b = 0; b < border_.size(); ++b)
        sum += slip_entry(border_[b], k, c) * motions[b];
      y[gap(k, c)] = sum;
    }
    const TangentialLaw law = this->law(k);
    const double* t = &t_[at(3 * k)];
    for (int c = 0; c < 2; ++c)
      y[slip(k, c)] = law.own[c][0] * t[0] + law.own[c][1] * t[1] + law.own[c][2] * t[2] +
                      law.slip[c][0] * s[0] + law.slip[c][1] * s[1];
  }
  for (std::size_t b = 0; b < border_.size(); ++b) {
    double sum = 0;
    for (std::int64_t k = 0; k < n; ++k)
      for (int c = first_component(); c < 3; ++c)
        sum += load_entry(border_[b], k, c) * t_[at(3 * k + c)];
    y[motion(b)] = sum;
  }
}

void MonolithicMatrix::right_side(std::vector<double>& b) {
  const Problem& p = problem_;
  const std::int64_t n = bodies_.nodes();
  b.assign(at(size()), 0.0);
  std::array<double, 4> known{};
  for (std::size_t m = 0; m < 4; ++m) known[m] = p.by_force[m] ? 0 : p.value[m];
  bool constants = false;  // of laws whose tractions are not unknown
  for (std::int64_t k = 0; k < n; ++k) {
    const double rn = bodies_.rn()[at(k)], rt = bodies_.rt()[at(k)];
    b[at(traction(k, 2))] = rn * p.rigid_gap(at(k), known[approach]);
    if (form_ == MonolithicForm::frictionless) continue;
    if (reduced()) {
      const PairState state = step_->state[at(k)];
      for (int c = 0; c < 2; ++c) {
        if (state == PairState::stick) b[at(traction(k, c))] = rn * step_->target[c][at(k)];
        constants = constants || (state == PairState::slip && step_->law[at(k)].constant[c] != 0);
      }
      continue;
    }
    b[at(gap(k, 0))] = rt * p.rigid_slip1(k, known);
    b[at(gap(k, 1))] = rt * p.rigid_slip2(k, known);
    const TangentialLaw law = this->law(k);
    for (int c = 0; c < 2; ++c) b[at(slip(k, c))] = law.constant[c];
  }
  for (std::size_t i = 0; i < border_.size(); ++i)
    b[at(motion(i))] = border_[i].per_load * p.value[at(border_[i].motion)];
  if (!constants) return;
  std::fill(t_.begin(), t_.end(), 0.0);
  for (std::int64_t k = 0; k < n; ++k)
    if (step_->state[at(k)] == PairState::slip)
      for (int c = 0; c < 2; ++c) t_[at(3 * k + c)] = step_->law[at(k)].constant[c];
  const std::vector<double> still(at(bodies_.unknowns()));
  std::vector<double> forces(still.size());
  bodies_.balance(still.data(), t_.data(), forces.data());
  bodies_.displacements(still.data(), t_.data(), u_.data());
  for (std::size_t i = 0; i < forces.size(); ++i) b[i] -= forces[i];
  for (std::int64_t k = 0; k < n; ++k)
    for (int c = 0; c < 3; ++c) b[at(traction(k, c))] -= bodies_.rn()[at(k)] * u_[at(3 * k + c)];
  for (std::size_t i = 0; i < border_.size(); ++i)
    for (std::int64_t k = 0; k < n; ++k)
      for (int c = 0; c < 2; ++c)
        b[at(motion(i))] -= load_entry(border_[i], k, c) * t_[at(3 * k + c)];
}

std::size_t MonolithicMatrix::bytes() const {
  return sizeof(double) * (t_.capacity() + k_.capacity() + u_.capacity());
}

}  // namespace rollcon
