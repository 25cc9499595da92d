#include "procedures/step_system.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/dense.hpp"
#include "procedures/held_nodes.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// The method `automatic` factorises every condensed system of up to this many unknowns.
constexpr std::int64_t direct_limit = 60;
constexpr int krylov_space = 60, plain_krylov_space = 200, plain_iterations = 2000;
constexpr double refined = 1e-13;  // residual of a direct solution that is good enough
constexpr int refinements = 3;
constexpr double unusable = 1e-6;  // residual beyond which the matrix counts as singular

bool all_zero(const Point& z) {
  return std::all_of(std::begin(z.lambda), std::end(z.lambda), [](const auto& component) {
    return std::all_of(component.begin(), component.end(), [](double v) { return v == 0; });
  });
}

ExpandedCompliance write_out(const Problem& problem, const Frame& frame, const Compliance& compliance) {
  std::vector<double> x(frame.x), y(frame.y);
  for (std::size_t k = 0; k < problem.convection.ahead.size(); ++k) {
    x.push_back(frame.x[k] + problem.convection.ahead[k]);
    y.push_back(frame.y[k]);
  }
  ExpandedCompliance expanded;
  if (!compliance.expand({x, y}, expanded))
    fail(Status::err_unsupported,
         "option 'system' is 'monolithic': the equations of these bodies cannot be written out (%s)",
         compliance.description().c_str());
  refuse_held_nodes(expanded, frame);
  return expanded;
}

}  // namespace

void blend(Point& z, const Point& next, double alpha) {
  const auto mix = [alpha](std::vector<double>& from, const std::vector<double>& to) {
    for (std::size_t k = 0; k < from.size(); ++k) from[k] = alpha == 1 ? to[k] : from[k] + alpha * (to[k] - from[k]);
  };
  z.inner.resize(next.inner.size(), 0.0);
  for (int c = 0; c < 3; ++c) mix(z.lambda[c], next.lambda[c]);
  for (int c = 0; c < 2; ++c) mix(z.slip[c], next.slip[c]), mix(z.shift[c], next.shift[c]);
  mix(z.depth, next.depth);
  mix(z.inner, next.inner);
  for (std::size_t m = 0; m < motion_count; ++m)
    z.motion[m] = alpha == 1 ? next.motion[m] : z.motion[m] + alpha * (next.motion[m] - z.motion[m]);
}

StepSystem::StepSystem(const Problem& problem, const Frame& frame, const Compliance& compliance,
                       const StepOptions& options)
    : options_(options) {
  if (options.monolithic) {
    ExpandedCompliance expanded = write_out(problem, frame, compliance);
    bodies_ = BodiesEquations(expanded);
    images_ = std::make_unique<Images>(problem, expanded, bodies_, options.tangential);
  } else {
    images_ = std::make_unique<Images>(problem, frame, compliance, options.tangential);
  }
  equations_ = std::make_unique<ContactEquations>(problem, bodies_, *images_);
  kept_ = std::make_unique<KeptFactors>(bodies_, options.monolithic ? images_.get() : nullptr, frame);
}

bool StepSystem::iterates() const {
  const LinearMethod method = options_.linear;
  if (method != LinearMethod::automatic) return method != LinearMethod::lu;
  return !options_.monolithic && equations_->size() > direct_limit;
}

bool StepSystem::solve(const Step& step, const Point& z, double eta, Point& next) {
  const Stopwatch watch(counters_.seconds);
  ContactEquations& equations = *equations_;
  equations.take(step);
  const std::int64_t n = equations.size();
  counters_.unknowns = n;
  counters_.nonzeros = equations.nonzeros();
  if (equations.pairs() == 0 && equations.motions() > 0) return false;  // nothing carries the loads
  next = z;
  if (std::ssize(next.inner) != equations.inner()) update(next);
  equations.right_side(step, b_);
  equations.start(next, x_);
  product_.resize(at(n));
  equations.apply(x_.data(), product_.data());
  for (std::size_t i = 0; i < b_.size(); ++i) b_[i] -= product_[i];
  if (norm2(b_.data(), n) > 0) {
    correction_.resize(at(n));
    bool solved = false;
    if (iterates()) {
      const Preconditioner kind = options_.preconditioner;
      if (kind == Preconditioner::none || kind == Preconditioner::diagonal)
        solved = solve_plainly(b_, eta);
      else
        solved = solve_with_kept(b_, eta);
    }
    if (!solved && !solve_directly(b_)) return false;
    axpy(1, correction_.data(), x_.data(), n);
  }
  equations.scatter(x_, next);
  return true;
}

bool StepSystem::solve_directly(const std::vector<double>& residual) {
  const std::int64_t n = equations_->size();
  ++counters_.factorizations;
  if (!factors_.factor(*equations_)) return false;
  const double norm = norm2(residual.data(), n);
  std::fill(correction_.begin(), correction_.end(), 0.0);
  rest_ = residual;
  double left = norm;
  for (int i = 0; i <= refinements && left > refined * norm; ++i) {
    factors_.solve(rest_.data());
    axpy(1, rest_.data(), correction_.data(), n);
    equations_->apply(correction_.data(), product_.data());
    for (std::size_t k = 0; k < rest_.size(); ++k) rest_[k] = residual[k] - product_[k];
    const double now = norm2(rest_.data(), n);
    if (!std::isfinite(now)) return false;
    if (now > 0.5 * left) break;
    left = now;
  }
  return left < unusable * norm;
}

GmresReport StepSystem::run(LinearOperator& preconditioner, const std::vector<double>& right, double eta, int space,
                            int limit) {
  const std::int64_t n = equations_->size();
  gmres_.reserve(with_room(n), static_cast<int>(std::min<std::int64_t>(space, n)));
  const GmresReport report = gmres_.solve(n, *equations_, preconditioner, right.data(), correction_.data(), eta, limit);
  counters_.iterations += report.iterations;
  return report;
}

bool StepSystem::solve_plainly(const std::vector<double>& residual, double eta) {
  own_entries_.take(*equations_, bodies_.own_rows(), options_.preconditioner == Preconditioner::diagonal);
  return run(own_entries_, residual, eta, plain_krylov_space, plain_iterations).converged;
}

// Solves with old factors. They are made anew when the excess over iterations with fresh ones has added up to their
// price, or many unknowns have changed.
bool StepSystem::solve_with_kept(const std::vector<double>& residual, double eta) {
  kept_->take(*equations_);
  const std::int64_t before = bodies_.factorizations();
  bool solved = false;
  for (int attempt = 0; attempt < 2 && !solved; ++attempt) {
    const int price = kept_->price(*equations_);
    const bool fresh = attempt == 1 || !kept_->valid() || excess_ > price || kept_->changed(*equations_) > 2 * price;
    if (fresh) {
      excess_ = 0;
      if (!options_.monolithic) ++counters_.factorizations;
      if (!kept_->factor(*equations_)) break;
    }
    const GmresReport report = run(*kept_, residual, eta, krylov_space, krylov_space);
    solved = report.converged;
    const double decades = -std::log10(std::max(report.residual, 1e-300)) / std::max(1, report.iterations);
    if (fresh) fresh_decades_ = decades;
    const double good = std::ceil(-std::log10(eta) / fresh_decades_);
    excess_ += std::max(0, report.iterations - static_cast<int>(good));
    if (fresh) break;
  }
  counters_.factorizations += bodies_.factorizations() - before;
  return solved;
}

void StepSystem::update(Point& z) {
  const Stopwatch watch(counters_.seconds);
  const std::int64_t nd = bodies_.unknowns();
  z.inner.assign(at(nd), 0.0);
  if (nd > 0 && !all_zero(z)) {
    std::vector<double> d = imbalances(z);
    for (double& v : d) v = -v;
    const std::int64_t before = bodies_.factorizations();
    bodies_.solve(d.data());
    counters_.factorizations += bodies_.factorizations() - before;
    z.inner = std::move(d);
  }
  images_->apply(z);
}

std::vector<double> StepSystem::imbalances(const Point& z) const {
  const std::size_t n = z.lambda[0].size();
  std::vector<double> t(3 * n), force(z.inner.size());
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t c = 0; c < 3; ++c) t[3 * k + c] = z.lambda[c][k];
  bodies_.balance(z.inner.data(), t.data(), force.data());
  return force;
}

double StepSystem::imbalance(const Point& z) const {
  if (!iterates() || z.inner.empty()) return 0;
  const std::vector<double> force = imbalances(z);
  return norm2(force.data(), std::ssize(force));
}

StepCounters StepSystem::counters() const {
  StepCounters c = counters_;
  c.bytes =
      bodies_.bytes() + images_->bytes() + equations_->bytes() + factors_.bytes() + kept_->bytes() + gmres_.bytes();
  return c;
}

}  // namespace rollcon
