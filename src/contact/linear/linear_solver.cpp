#include "contact/linear/linear_solver.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/dense.hpp"
#include "support/clock.hpp"

namespace rollcon {
namespace {

constexpr int krylov_space = 60;
// These bound GMRES with operators that are not formed: memory for its space grows with the number of nodes.
constexpr int field_krylov_space = 40, field_iterations = 400;
constexpr double useful = 0.1;         // residual of a solution that is worth a step
constexpr double exact_enough = 1e-7;  // residual of a solution that rates may be made from
constexpr double exact = 1e-9;         // residual of solve_exactly()
// Iterations for the first right side of solve_exactly(); later ones need fewer. New factors are cheaper beyond this,
// or beyond krylov_space for all together.
constexpr int exact_iterations = 25;
// Up to this many free unknowns one factorisation costs less than iterations for all right sides.
constexpr std::int64_t exact_direct_limit = 300;
constexpr double loosest = 0.1;  // loosest linear residual
// Returns how many iterations new factors cost, about: they are made when the excess over iterations with fresh ones
// has added up to that much, or as many nodes have changed their state.
int price_of_factors(std::int64_t n) {
  return static_cast<int>(2 + n / 70);
}

}  // namespace

bool LinearSolver::factor_free(Lu<double>& lu) {
  const std::int64_t n = free_.size();
  free_.dense(FreeSystem::Rows::all, lu.prepare(n, std::max(n / 5, with_room(n) - n)));
  ++factorizations;
  return lu.factor();
}

bool LinearSolver::solve_direct(const std::vector<double>& b, std::vector<double>& x) {
  forget_exact();
  if (!factor_free(lu_)) return false;
  free_.reduce(b, reduced_);
  lu_.solve(reduced_.data());
  return finish(reduced_.data(), x);
}

// Finds all unknowns from the free ones; leaves the product that the caller reads.
bool LinearSolver::finish(const double* y, std::vector<double>& x) {
  free_.apply(y, check_.data());
  free_.expand(y, x.data());
  return std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
}

bool LinearSolver::solve(ReducedSystem& system, std::int64_t node_count, const std::vector<double>& b, double tolerance,
                         std::vector<double>& x) {
  const Stopwatch watch(seconds);
  unknowns = system.size();
  ++right_sides;
  if (!system.formed()) return solve_field(system, b, tolerance, useful, x);
  take(system, x);
  const std::int64_t n = free_.size();
  if (method == LinearMethod::lu || (method == LinearMethod::automatic && n <= direct_limit)) return solve_direct(b, x);
  return solve_with_kept(node_count, b, tolerance, x) || solve_direct(b, x);
}

void LinearSolver::take(ReducedSystem& system, std::vector<double>& x) {
  free_.take(system);
  const auto n = static_cast<std::size_t>(system.size());
  x.resize(n);
  if (check_.size() < n) check_.resize(with_room(n)), found_.resize(with_room(n));
}

bool LinearSolver::solve_with_kept(std::int64_t node_count, const std::vector<double>& b, double tolerance,
                                   std::vector<double>& x) {
  const std::int64_t n = free_.size();
  const auto part = static_cast<std::size_t>(free_.system().part()) - 2;
  gmres_.reserve(with_room(n), krylov_space);
  free_.reduce(b, reduced_);
  // The tolerance is one for all rows.
  const double left = norm2(reduced_.data(), n);
  const double all = norm2(b.data(), free_.system().size());
  const double wanted = left > 0 ? std::min(tolerance * all / left, loosest) : tolerance;
  const int price = price_of_factors(n);
  for (int attempt = 0; attempt < 2; ++attempt) {
    bool fresh = attempt == 1 || excess_ > price || !kept_.usable(free_);
    if (!fresh) {
      kept_.match(free_);
      fresh = kept_.changed() > price;
    }
    if (fresh) {
      ++factorizations;
      excess_ = 0;
      if (!kept_.factor(free_, node_count)) break;
      kept_.match(free_);
    }
    const GmresReport report = gmres_.solve(n, free_, kept_, reduced_.data(), found_.data(), wanted, krylov_space);
    iterations += report.iterations;
    if (report.converged) {
      const double decades =
          report.residual > 0 && report.iterations > 0 ? -std::log10(report.residual) / report.iterations : INFINITY;
      decades_[part] = decades;
      if (fresh) fresh_decades_ = decades;
      const double good = std::ceil(-std::log10(wanted) / fresh_decades_);
      excess_ += std::max(0, report.iterations - static_cast<int>(good));
      if (left > 0)
        free_.expand(found_.data(), x.data());
      else
        finish(found_.data(), x);
      return true;
    }
    if (fresh) break;
  }
  kept_.forget();
  return false;
}

bool LinearSolver::solve_field(ReducedSystem& system, const std::vector<double>& b, double tolerance, double enough,
                               std::vector<double>& x) {
  const std::int64_t n = system.size();
  x.resize(static_cast<std::size_t>(n));
  gmres_.reserve(with_room(n), field_krylov_space);
  if (!field_blocks_) field_blocks_ = system.operators().make_preconditioner();
  field_blocks_->take(system);
  const GmresReport report = gmres_.solve(n, system, *field_blocks_, b.data(), x.data(), tolerance, field_iterations);
  iterations += report.iterations;
  return report.converged || report.residual < enough;
}

bool LinearSolver::solve_exactly(ReducedSystem& system, const std::vector<double>& b, std::vector<double>& x) {
  const Stopwatch watch(seconds);
  if (!system.formed()) return solve_field(system, b, exact, exact_enough, x);
  take(system, x);
  const std::int64_t n = free_.size();
  const auto part = static_cast<std::size_t>(system.part()) - 2;
  free_.reduce(b, reduced_);
  const bool small = method == LinearMethod::automatic && n <= exact_direct_limit;
  const bool fresh_enough = kept_.usable(free_) && decades_[part] * exact_iterations >= -std::log10(exact);
  if (!exact_[part] && method != LinearMethod::lu && !small && fresh_enough) {
    gcr_[part].reserve(n, krylov_space);
    kept_.match(free_);
    const GmresReport report =
        gcr_[part].solve(n, free_, kept_, reduced_.data(), found_.data(), exact, exact_iterations);
    iterations += report.iterations;
    if (report.converged) {
      free_.expand(found_.data(), x.data());
      return true;
    }
  }
  Lu<double>& lu = system.part() == Part::normal ? normal_lu_ : lu_;
  if (!exact_[part]) exact_[part] = factor_free(lu);
  if (!exact_[part]) return false;
  lu.solve(reduced_.data());
  free_.expand(reduced_.data(), x.data());
  return std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
}

void LinearSolver::forget_exact() {
  for (bool& held : exact_) held = false;
  for (RecyclingGcr& gcr : gcr_) gcr.forget();
}

void LinearSolver::forget() {
  forget_exact();
  field_blocks_.reset();
  kept_.forget();
}

void LinearSolver::forget_all() {
  forget();
  for (double& d : decades_) d = 0;
  fresh_decades_ = usual_decades;
  excess_ = 0;
}

std::size_t LinearSolver::bytes() const {
  std::size_t sum = lu_.bytes() + normal_lu_.bytes() + gmres_.bytes() + kept_.bytes() + free_.bytes();
  if (field_blocks_) sum += field_blocks_->bytes();
  for (const RecyclingGcr& gcr : gcr_) sum += gcr.bytes();
  return sum;
}

}  // namespace rollcon
