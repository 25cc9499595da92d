#include "procedures/monolithic_core.hpp"

#include <algorithm>

#include "support/index.hpp"

namespace rollcon {

void MonolithicCore::take(const MonolithicMatrix& matrix) {
  step_ = matrix.step();
  matrix_ = std::make_unique<MonolithicMatrix>(matrix);
  matrix_->set(step_);
  const std::int64_t n = matrix_->bodies().nodes();
  unknown_.clear();
  row_start_.assign(1, 0);
  place_.clear();
  weight_.clear();
  border_.clear();
  of_node_.assign(1, 0);
  for (std::int64_t k = 0; k < n; ++k) {
    if (matrix_->touching(k)) add_rows(k);
    of_node_.push_back(unknown_.size());
  }
  motion_ = first() + static_cast<std::int64_t>(unknown_.size());
  user_start_.assign(at(matrix_->bodies().places()) + 1, 0);
  for (const std::int64_t p : place_) ++user_start_[at(p) + 1];
  for (std::size_t p = 1; p < user_start_.size(); ++p) user_start_[p] += user_start_[p - 1];
  user_.resize(place_.size());
  std::vector<std::size_t> next(user_start_.begin(), user_start_.end() - 1);
  for (std::size_t a = 0; a < unknown_.size(); ++a)
    row(a, [&](std::int64_t p, double w) { user_[next[at(p)]++] = {a, w}; });
}

// rt D of displacements in units of traction.
void MonolithicCore::add_convected(std::int64_t k, int c, double factor) {
  if (factor == 0) return;
  const MonolithicBodies& bodies = matrix_->bodies();
  const ContactOperators& op = matrix_->problem().op;
  factor *= bodies.rt()[at(k)];
  const auto add = [&](std::int64_t place, double w) {
    place_.push_back(place);
    weight_.push_back(w);
  };
  if (!op.upstream.empty()) {
    if (!(op.upstream[at(k)] > 0)) return;
    add(3 * k + c, factor / op.path(at(k)));
    add(3 * bodies.nodes() + 2 * k + c, -factor / op.path(at(k)));
    return;
  }
  if (op.convection.start.empty()) return;
  for (std::int64_t e = op.convection.start[at(k)]; e < op.convection.start[at(k + 1)]; ++e)
    add(3 * op.convection.column[at(e)] + c, factor * op.convection.value[at(e)]);
}

void MonolithicCore::add_rows(std::int64_t k) {
  const MonolithicMatrix& m = *matrix_;
  const auto& borders = m.borders();
  const double rn = m.bodies().rn()[at(k)];
  const bool stick = step_.state[at(k)] == PairState::stick;
  const bool reduced = m.form() == MonolithicForm::reduced;
  const bool tangential = m.form() == MonolithicForm::full || (reduced && stick);
  for (int c = tangential ? 0 : 2; c < 3; ++c) {
    Unknown unknown{k, c, {0, 0, 0}};
    unknown.traction[at(c)] = 1;
    if (c == 2 && reduced && !stick)
      for (std::size_t j = 0; j < 2; ++j) unknown.traction[j] = -step_.law[at(k)].own[j][2];
    unknown_.push_back(unknown);
    if (c == 2 || reduced) {
      place_.push_back(3 * k + c);
      weight_.push_back(rn);
      for (const auto& border : borders) border_.push_back(m.gap_entry(border, k, c));
    } else {
      const TangentialLaw law = m.law(k);
      for (int j = 0; j < 2; ++j) add_convected(k, j, law.slip[c][j]);
      for (const auto& border : borders)
        border_.push_back(-law.slip[c][0] * m.slip_entry(border, k, 0) -
                          law.slip[c][1] * m.slip_entry(border, k, 1));
    }
    row_start_.push_back(place_.size());
  }
}

double MonolithicCore::own(std::size_t a, std::size_t b) const {
  const Unknown &row = unknown_[a], &column = unknown_[b];
  if (matrix_->form() != MonolithicForm::full || row.component == 2 || row.node != column.node)
    return 0;
  return step_.law[at(row.node)].own[row.component][column.component];
}

double MonolithicCore::load(std::size_t b, std::size_t a) const {
  double sum = 0;
  for (int c = 0; c < 3; ++c)
    if (const double t = unknown_[a].traction[at(c)]; t != 0)
      sum += t * matrix_->load_entry(matrix_->borders()[b], unknown_[a].node, c);
  return sum;
}

void MonolithicCore::reduce(const double* whole, std::vector<double>& core) {
  MonolithicMatrix& m = *matrix_;
  const MonolithicBodies& bodies = m.bodies();
  const std::int64_t n = bodies.nodes();
  const bool full = m.form() == MonolithicForm::full;
  const auto whole_size = at(m.size());
  product_.assign(whole, whole + whole_size);
  if (m.form() != MonolithicForm::reduced) {
    x_.assign(whole_size, 0.0);
    bool any = false;
    const auto know = [&](std::int64_t unknown, std::int64_t row) {
      x_[at(unknown)] = whole[row];
      any = any || whole[row] != 0;
    };
    for (std::int64_t k = 0; k < n; ++k) {
      if (m.touching(k)) {
        know(m.gap(k, 2), m.gap(k, 2));
        continue;
      }
      know(m.traction(k, 2), m.gap(k, 2));
      for (int c = 0; full && c < 2; ++c) know(m.traction(k, c), m.slip(k, c));
    }
    if (any) {
      m.apply(x_.data(), product_.data());
      for (std::size_t i = 0; i < whole_size; ++i) product_[i] = whole[i] - product_[i];
    }
  }
  core.resize(at(size()));
  std::copy_n(product_.begin(), first(), core.begin());
  if (full) {  // slip of displacements that only make up for the right side
    gap_.resize(at(3 * n));
    u_.assign(at(bodies.places()), 0.0);
    for (std::int64_t k = 0; k < n; ++k)
      for (int c = 0; c < 3; ++c) gap_[at(3 * k + c)] = product_[at(m.traction(k, c))];
  }
  for (std::size_t a = 0; a < unknown_.size(); ++a) {
    const auto [k, c, t] = unknown_[a];
    double& right = core[at(first()) + a];
    if (c == 2 || !full) {
      right = product_[at(m.traction(k, c))];
      continue;
    }
    const TangentialLaw law = m.law(k);
    right = product_[at(m.slip(k, c))];
    for (int j = 0; j < 2; ++j)
      if (law.slip[c][j] != 0)
        right -= law.slip[c][j] *
                 (product_[at(m.gap(k, j))] - m.convected(gap_.data(), u_.data(), k, j));
  }
  for (std::size_t b = 0; b < borders(); ++b) core[at(motion_) + b] = product_[at(m.motion(b))];
}

void MonolithicCore::recover(const double* whole, const std::vector<double>& core,
                             double* solution) {
  MonolithicMatrix& m = *matrix_;
  const MonolithicBodies& bodies = m.bodies();
  const std::int64_t n = bodies.nodes();
  const MonolithicForm form = m.form();
  std::copy_n(core.begin(), first(), solution);
  t_.assign(at(3 * n), 0.0);
  for (std::size_t a = 0; a < unknown_.size(); ++a)
    for (std::size_t c = 0; c < 3; ++c)
      t_[3 * at(unknown_[a].node) + c] += unknown_[a].traction[c] * core[at(first()) + a];
  const int least = form == MonolithicForm::frictionless ? 2 : 0;
  if (form != MonolithicForm::reduced)
    for (std::int64_t k = 0; k < n; ++k)
      for (int c = least; c < 3; ++c) {
        double& t = t_[at(3 * k + c)];
        if (!m.touching(k)) t = whole[c == 2 ? m.gap(k, 2) : m.slip(k, c)];
        solution[m.traction(k, c)] = t;
      }
  u_.resize(at(bodies.places()));
  if (form == MonolithicForm::frictionless)
    bodies.normal_displacements(solution, solution + m.traction(0, 2), u_.data());
  else
    bodies.displacements(solution, t_.data(), u_.data());
  const double* motions = core.data() + motion_;
  std::copy_n(motions, borders(), solution + m.motion(0));
  gap_.resize(at(3 * n));
  for (std::int64_t k = 0; k < n; ++k)
    for (int c = least; c < 3; ++c) {
      const double u = u_[at(form == MonolithicForm::frictionless ? k : 3 * k + c)];
      double gap = whole[m.traction(k, c)] - bodies.rn()[at(k)] * u;
      for (std::size_t b = 0; b < borders(); ++b)
        gap -= m.gap_entry(m.borders()[b], k, c) * motions[b];
      gap *= MonolithicMatrix::sign(c);
      if (form == MonolithicForm::reduced) {
        const PairState state = step_.state[at(k)];
        if (state != PairState::stick && !(state == PairState::slip && c == 2))
          solution[m.traction(k, c)] = gap;
        continue;
      }
      if (c == 2 && m.touching(k)) gap = whole[m.gap(k, 2)];
      gap_[at(3 * k + c)] = gap;
      solution[m.gap(k, c)] = gap;
    }
  if (form == MonolithicForm::reduced)
    for (std::size_t a = 0; a < unknown_.size(); ++a)
      solution[m.traction(unknown_[a].node, unknown_[a].component)] = core[at(first()) + a];
  if (form != MonolithicForm::full) return;
  for (std::int64_t k = 0; k < n; ++k)
    for (int c = 0; c < 2; ++c) {
      double s = whole[m.gap(k, c)] + m.convected(gap_.data(), u_.data(), k, c);
      for (std::size_t b = 0; b < borders(); ++b)
        s -= m.slip_entry(m.borders()[b], k, c) * motions[b];
      solution[m.slip(k, c)] = s;
    }
}

std::size_t MonolithicCore::bytes() const {
  return (matrix_ ? matrix_->bytes() : 0) +
         sizeof(double) * (weight_.capacity() + border_.capacity() + x_.capacity() +
                           product_.capacity() + t_.capacity() + gap_.capacity() + u_.capacity()) +
         sizeof(std::int64_t) * place_.capacity() + sizeof(user_[0]) * user_.capacity() +
         sizeof(Unknown) * unknown_.capacity();
}

}  // namespace rollcon
