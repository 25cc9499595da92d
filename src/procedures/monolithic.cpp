#include "procedures/monolithic.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/dense.hpp"
#include "procedures/held_nodes.hpp"
#include "support/clock.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int krylov_space = 60, plain_krylov_space = 200, plain_iterations = 2000;
constexpr int good_iterations = 5;    // with fresh factors
constexpr int price_of_factors = 30;  // in iterations beyond good ones
constexpr double refined = 1e-13;     // residual of a direct solution that is good enough
constexpr int refinements = 3;
constexpr double unusable = 1e-6;  // ... beyond which the matrix counts as singular

bool all_zero(const Point& z) {
  return std::all_of(std::begin(z.lambda), std::end(z.lambda), [](const auto& component) {
    return std::all_of(component.begin(), component.end(), [](double v) { return v == 0; });
  });
}

}  // namespace

MonolithicSystem::MonolithicSystem(const Problem& problem, const Frame& frame,
                                   const Compliance& compliance, const MonolithicOptions& options)
    : problem_(problem),
      frame_(frame),
      options_(options),
      bodies_(problem, frame, compliance),
      body_factors_(bodies_) {
  refuse_held_nodes(bodies_, frame);
}

MonolithicSystem::Form& MonolithicSystem::form(const Step& step) {
  const MonolithicForm kind = !step.tangential ? MonolithicForm::frictionless
                              : step.estimated ? MonolithicForm::reduced
                                               : MonolithicForm::full;
  Form& form = form_[static_cast<std::size_t>(kind)];
  if (!form.matrix) {
    for (Form& other : form_) other.lu.release();
    form.matrix = std::make_unique<MonolithicMatrix>(problem_, bodies_, kind);
  }
  form.matrix->set(step);
  return form;
}

bool MonolithicSystem::solve(const Step& step, const Point& z, double eta, Point& next) {
  const Stopwatch watch(counters_.seconds);
  Form& form = this->form(step);
  MonolithicMatrix& matrix = *form.matrix;
  const bool touches = std::any_of(step.state.begin(), step.state.end(),
                                   [](PairState s) { return s >= PairState::stick; });
  if (!touches && !matrix.borders().empty()) return false;  // nothing carries the loads
  next = z;
  if (step.estimated)
    for (auto& shift : next.shift) shift.resize(at(bodies_.nodes()));
  if (next.inner.empty()) update(next);
  matrix.right_side(b_);
  matrix.start(next, x_);
  const std::int64_t n = matrix.size();
  product_.resize(at(n));
  matrix.apply(x_.data(), product_.data());
  for (std::size_t i = 0; i < b_.size(); ++i) b_[i] -= product_[i];
  counters_.unknowns = n;
  counters_.nonzeros = matrix.nonzeros();
  if (const double norm = norm2(b_.data(), n); norm > 0) {
    const bool iterates = options_.solver == StepSolver::gmres;
    if (!(iterates && solve_iteratively(form, b_, eta * norm)) && !solve_directly(form, b_))
      return false;
    axpy(1, correction_.data(), x_.data(), n);
  }
  matrix.scatter(x_, next);
  return true;
}

bool MonolithicSystem::solve_directly(Form& form, const std::vector<double>& residual) {
  MonolithicMatrix& matrix = *form.matrix;
  const std::int64_t n = matrix.size();
  if (!factor(form)) return false;
  const double norm = norm2(residual.data(), n);
  correction_.assign(at(n), 0.0);
  rest_ = residual;
  double left = norm;
  for (int i = 0; i <= refinements && left > refined * norm; ++i) {
    form.lu.solve(rest_.data(), rest_.data());
    axpy(1, rest_.data(), correction_.data(), n);
    matrix.apply(correction_.data(), product_.data());
    for (std::size_t k = 0; k < rest_.size(); ++k) rest_[k] = residual[k] - product_[k];
    const double now = norm2(rest_.data(), n);
    if (!std::isfinite(now)) return false;
    if (now > 0.5 * left) break;
    left = now;
  }
  return left < unusable * norm;
}

bool MonolithicSystem::factor(Form& form) {
  ++counters_.factorizations;
  form.excess = 0;
  return form.lu.factor(*form.matrix);
}

bool MonolithicSystem::solve_iteratively(Form& form, const std::vector<double>& residual,
                                         double target) {
  const std::int64_t n = form.matrix->size();
  if (options_.preconditioner == Preconditioner::kept_lu)
    return solve_with_kept_factors(form, residual, target / norm2(residual.data(), n));
  // What the trivial pivots leave over is the whole residual: their equations hold exactly.
  core_.take(*form.matrix);
  core_product_.take(core_);
  core_.reduce(residual.data(), right_);
  solution_.assign(right_.size(), 0.0);
  const double norm = norm2(right_.data(), core_.size());
  if (norm > target && !solve_core(target / norm)) return false;
  correction_.resize(residual.size());
  core_.recover(residual.data(), solution_, correction_.data());
  return true;
}

bool MonolithicSystem::solve_core(double target) {
  const Preconditioner kind = options_.preconditioner;
  if (kind != Preconditioner::none && kind != Preconditioner::diagonal)
    return solve_with_body_factors(target);
  diagonal_.take(core_, kind == Preconditioner::diagonal);
  return run(core_product_, diagonal_, right_, solution_, target, plain_krylov_space,
             plain_iterations)
      .converged;
}

bool MonolithicSystem::solve_with_body_factors(double target) {
  const std::int64_t before = bodies_.factorizations();
  const int price = 10 + static_cast<int>(core_.unknowns().size() / 400);
  bool solved = false;
  for (int attempt = 0; attempt < 2 && !solved; ++attempt) {
    const bool fresh = attempt == 1 || excess_ > price;
    const bool first = fresh || !body_factors_.valid();
    if (!body_factors_.take(core_, frame_, fresh)) break;
    const GmresReport report =
        run(core_product_, body_factors_, right_, solution_, target, krylov_space, krylov_space);
    solved = report.converged;
    if (first) {
      fresh_iterations_ = report.iterations;
      excess_ = 0;
      break;
    }
    excess_ += std::max(0, report.iterations - fresh_iterations_);
  }
  counters_.factorizations += bodies_.factorizations() - before;
  return solved;
}

bool MonolithicSystem::solve_with_kept_factors(Form& form, const std::vector<double>& residual,
                                               double target) {
  KeptFactors kept(form.lu);
  for (int attempt = 0; attempt < 2; ++attempt) {
    const bool usable = attempt == 0 && form.lu.valid() && form.excess <= price_of_factors &&
                        form.lu.core().borders() == form.matrix->borders().size();
    if (!usable && !factor(form)) return false;
    correction_.resize(residual.size());
    const GmresReport report =
        run(*form.matrix, kept, residual, correction_, target, krylov_space, krylov_space);
    form.excess += std::max(0, report.iterations - good_iterations);
    if (report.converged) return true;
    if (!usable) return false;
  }
  return false;
}

GmresReport MonolithicSystem::run(LinearOperator& system, LinearOperator& preconditioner,
                                  const std::vector<double>& right, std::vector<double>& x,
                                  double target, int space, int limit) {
  const auto n = static_cast<std::int64_t>(right.size());
  gmres_.reserve(n, static_cast<int>(std::min<std::int64_t>(space, n)));
  const GmresReport report =
      gmres_.solve(n, system, preconditioner, right.data(), x.data(), target, limit);
  counters_.iterations += report.iterations;
  return report;
}

void MonolithicSystem::update(Point& z) {
  const Stopwatch watch(counters_.seconds);
  const std::int64_t n = bodies_.nodes(), nd = bodies_.unknowns();
  z.inner.assign(at(nd + 2 * n), 0.0);
  z.depth.assign(at(n), 0.0);
  for (auto& slip : z.slip) slip.assign(at(n), 0.0);
  for (auto& shift : z.shift)
    if (!shift.empty()) shift.assign(at(n), 0.0);
  if (all_zero(z)) return;
  std::vector<double> t(at(3 * n)), d(at(nd)), u(at(bodies_.places()));
  for (std::size_t k = 0; k < at(n); ++k)
    for (std::size_t c = 0; c < 3; ++c) t[3 * k + c] = z.lambda[c][k];
  bodies_.balance(z.inner.data(), t.data(), d.data());
  for (double& v : d) v = -v;
  const std::int64_t before = bodies_.factorizations();
  bodies_.solve(d.data());
  counters_.factorizations += bodies_.factorizations() - before;
  bodies_.displacements(d.data(), t.data(), u.data());
  std::copy(d.begin(), d.end(), z.inner.begin());
  std::vector<double> ahead(bodies_.ahead() ? at(3 * n) : 0);
  for (std::size_t k = 0; k < at(n); ++k) {
    z.depth[k] = u[3 * k + 2];
    for (std::size_t c = 0; c < 2; ++c) {
      z.inner[at(nd) + 2 * k + c] = u[3 * k + c];
      if (!z.shift[c].empty()) z.shift[c][k] = u[3 * k + c];
      if (!ahead.empty()) ahead[3 * k + c] = u[at(3 * n) + 2 * k + c];
    }
  }
  const ContactOperators& op = problem_.op;
  if (!op.upstream.empty() || !op.convection.start.empty())
    convect(op, u.data(), ahead.data(), z.slip);
}

double MonolithicSystem::imbalance(const Point& z) {
  if (options_.solver == StepSolver::lu || z.inner.empty()) return 0;
  const std::int64_t n = bodies_.nodes(), nd = bodies_.unknowns();
  const double* d = z.inner.data();
  std::vector<double> t(at(3 * n)), force(at(nd)), u(at(bodies_.places()));
  for (std::size_t k = 0; k < at(n); ++k)
    for (std::size_t c = 0; c < 3; ++c) t[3 * k + c] = z.lambda[c][k];
  bodies_.balance(d, t.data(), force.data());
  bodies_.displacements(d, t.data(), u.data());
  double sum = 0;
  const auto add = [&sum](double rest) { sum += rest * rest; };
  for (const double rest : force) add(rest);
  std::vector<double> ahead(bodies_.ahead() ? at(3 * n) : 0);
  for (std::size_t k = 0; k < at(n); ++k) {
    if (!problem_.used[k]) continue;
    add(bodies_.rn()[k] * (u[3 * k + 2] - z.depth[k]));
    for (std::size_t c = 0; c < 2; ++c) {
      if (!z.shift[c].empty()) add(bodies_.rn()[k] * (u[3 * k + c] - z.shift[c][k]));
      if (!ahead.empty()) ahead[3 * k + c] = u[at(3 * n) + 2 * k + c];
    }
  }
  const ContactOperators& op = problem_.op;
  const bool slips = std::any_of(form_, form_ + 3, [](const Form& form) {
    return form.matrix && form.matrix->form() != MonolithicForm::frictionless;
  });
  if (slips && (!op.upstream.empty() || !op.convection.start.empty())) {
    std::vector<double> slip[2];
    convect(op, u.data(), ahead.data(), slip);
    for (std::size_t k = 0; k < at(n); ++k)
      for (int c = 0; c < 2; ++c)
        if (problem_.used[k]) add(bodies_.rt()[k] * (slip[c][k] - z.slip[c][k]));
  }
  return std::sqrt(sum);
}

StepCounters MonolithicSystem::counters() const {
  StepCounters c = counters_;
  c.bytes = bodies_.bytes() + core_.bytes() + core_product_.bytes() + body_factors_.bytes() +
            gmres_.bytes();
  c.seconds_matrix = 0;
  for (const Form& form : form_) {
    c.seconds_matrix += form.lu.seconds_matrix;
    c.bytes += form.lu.bytes() + (form.matrix ? form.matrix->bytes() : 0);
  }
  return c;
}

}  // namespace rollcon
