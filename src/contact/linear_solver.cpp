#include "contact/linear_solver.hpp"

#include <algorithm>
#include <cmath>

#include "support/clock.hpp"

namespace rollcon {
namespace {

constexpr int krylov_space = 60;
// Without factors.
constexpr int plain_krylov_space = 200, plain_iterations = 1000;
constexpr double exact = 1e-9;  // residual of solve_exactly()
// For the first right side of solve_exactly(); those after it need fewer. New factors are cheaper
// beyond this, or beyond krylov_space for all together.
constexpr int exact_iterations = 25;
constexpr int good_iterations = 5;  // with fresh factors
// New factors cost about as much as this many iterations (40 at 1290 unknowns, 70 at 5163): they
// are made when the excess over good iterations has added up to that much.
int price_of_factors(std::int64_t n) {
  return static_cast<int>(30 + n / 130);
}

}  // namespace

void LinearSolver::Kept::factor(ReducedSystem& system, std::int64_t node_count, bool& good) {
  const std::int64_t n = system.size();
  system.dense(lu_.prepare(n, n / 10));
  good = valid_ = lu_.factor();
  part_ = system.part();
  nodes_ = system.active();
  components_ = system.components();
  borders_ = n - components_ * nodes_;
  place_.assign(static_cast<std::size_t>(node_count), -1);
  for (std::int64_t a = 0; a < nodes_; ++a)
    place_[static_cast<std::size_t>(system.nodes()[static_cast<std::size_t>(a)])] =
        static_cast<std::int32_t>(a);
  if (work_.size() < static_cast<std::size_t>(n))
    work_.resize(static_cast<std::size_t>(n + n / 10));
}

bool LinearSolver::Kept::usable(const ReducedSystem& system) const {
  return valid_ && part_ == system.part() &&
         borders_ == system.size() - system.components() * system.active();
}

void LinearSolver::Kept::match(const ReducedSystem& system) {
  const auto n = static_cast<std::size_t>(system.size());
  if (index_.size() < n) index_.resize(n + n / 10);
  const std::int64_t na = system.active();
  for (std::int64_t a = 0; a < na; ++a) {
    const std::int32_t place =
        place_[static_cast<std::size_t>(system.nodes()[static_cast<std::size_t>(a)])];
    for (int c = 0; c < components_; ++c)
      index_[static_cast<std::size_t>(c * na + a)] = place < 0 ? -1 : c * nodes_ + place;
  }
  for (std::int64_t k = 0; k < borders_; ++k)
    index_[static_cast<std::size_t>(components_ * na + k)] = components_ * nodes_ + k;
  index_size_ = system.size();
}

void LinearSolver::Kept::apply(const double* x, double* y) {
  const std::int64_t n = components_ * nodes_ + borders_;
  std::fill(work_.begin(), work_.begin() + n, 0.0f);
  // Single precision has a narrow range: scale the residual to order one.
  double largest = 0;
  for (std::int64_t i = 0; i < index_size_; ++i) largest = std::max(largest, std::abs(x[i]));
  if (!(largest > 0) || !std::isfinite(largest)) {
    std::copy(x, x + index_size_, y);
    return;
  }
  for (std::int64_t i = 0; i < index_size_; ++i)
    if (const std::int64_t k = index_[static_cast<std::size_t>(i)]; k >= 0)
      work_[static_cast<std::size_t>(k)] = static_cast<float>(x[i] / largest);
  lu_.solve(work_.data());
  for (std::int64_t i = 0; i < index_size_; ++i) {
    const std::int64_t k = index_[static_cast<std::size_t>(i)];
    y[i] = k >= 0 ? largest * static_cast<double>(work_[static_cast<std::size_t>(k)]) : x[i];
  }
}

bool LinearSolver::solve_direct(ReducedSystem& system, const std::vector<double>& b,
                                std::vector<double>& x) {
  const std::int64_t n = system.size();
  forget_exact();
  system.dense(lu_.prepare(n, n / 10));
  ++factorizations;
  if (!lu_.factor()) return false;
  x.resize(static_cast<std::size_t>(n));
  std::copy(b.begin(), b.begin() + n, x.begin());
  lu_.solve(x.data());
  check_.resize(static_cast<std::size_t>(n));
  system.apply(x.data(), check_.data());  // leaves the product that the caller reads
  return std::all_of(x.begin(), x.begin() + n, [](double v) { return std::isfinite(v); });
}

bool LinearSolver::solve(ReducedSystem& system, std::int64_t node_count,
                         const std::vector<double>& b, double tolerance, std::vector<double>& x) {
  const Stopwatch watch(seconds);
  const std::int64_t n = system.size();
  unknowns = n;
  if (method == LinearMethod::lu || (method == LinearMethod::automatic && n <= direct_limit))
    return solve_direct(system, b, x);
  if (preconditioner == Preconditioner::none || preconditioner == Preconditioner::diagonal)
    return solve_plainly(system, b, tolerance, x);
  const auto part = static_cast<std::size_t>(system.part()) - 2;
  Kept& kept = kept_[part];
  x.resize(static_cast<std::size_t>(n));
  gmres_.reserve(n + n / 10, krylov_space);
  for (int attempt = 0; attempt < 2; ++attempt) {
    const bool fresh = attempt == 1 || excess_[part] > price_of_factors(n) || !kept.usable(system);
    if (fresh) {
      bool good = false;
      kept.factor(system, node_count, good);
      ++factorizations;
      excess_[part] = 0;
      if (!good) break;
    }
    kept.match(system);
    const int limit = krylov_space;
    const GmresReport report = gmres_.solve(n, system, kept, b.data(), x.data(), tolerance, limit);
    iterations += report.iterations;
    if (report.converged) {
      decades_[part] = report.residual > 0 && report.iterations > 0
                           ? -std::log10(report.residual) / report.iterations
                           : INFINITY;
      excess_[part] += std::max(0, report.iterations - good_iterations);
      return true;
    }
    if (fresh) break;
  }
  kept.forget();
  return solve_direct(system, b, x);
}

bool LinearSolver::solve_plainly(ReducedSystem& system, const std::vector<double>& b,
                                 double tolerance, std::vector<double>& x) {
  const std::int64_t n = system.size();
  x.resize(static_cast<std::size_t>(n));
  const int space = static_cast<int>(std::min<std::int64_t>(n, plain_krylov_space));
  gmres_.reserve(n + n / 10, space);
  pair_blocks_.take(system, preconditioner == Preconditioner::diagonal);
  const GmresReport report =
      gmres_.solve(n, system, pair_blocks_, b.data(), x.data(), tolerance, plain_iterations);
  iterations += report.iterations;
  return report.converged || solve_direct(system, b, x);
}

bool LinearSolver::solve_exactly(ReducedSystem& system, const std::vector<double>& b,
                                 std::vector<double>& x) {
  const Stopwatch watch(seconds);
  const std::int64_t n = system.size();
  const auto part = static_cast<std::size_t>(system.part()) - 2;
  Kept& kept = kept_[part];
  x.resize(static_cast<std::size_t>(n));
  const bool small = method == LinearMethod::automatic && n <= direct_limit;
  const bool fresh_enough =
      kept.usable(system) && decades_[part] * exact_iterations >= -std::log10(exact);
  if (!exact_[part] && method != LinearMethod::lu && !small && fresh_enough) {
    gcr_[part].reserve(n, krylov_space);
    kept.match(system);
    const GmresReport report =
        gcr_[part].solve(n, system, kept, b.data(), x.data(), exact, exact_iterations);
    iterations += report.iterations;
    if (report.converged) return true;
  }
  Lu<double>& lu = system.part() == Part::normal ? normal_lu_ : lu_;
  if (!exact_[part]) {
    system.dense(lu.prepare(n, n / 10));
    ++factorizations;
    exact_[part] = lu.factor();
    if (!exact_[part]) return false;
  }
  std::copy(b.begin(), b.begin() + n, x.begin());
  lu.solve(x.data());
  return std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
}

void LinearSolver::forget_exact() {
  for (bool& held : exact_) held = false;
  for (RecyclingGcr& gcr : gcr_) gcr.forget();
}

void LinearSolver::forget() {
  forget_exact();
  for (Kept& kept : kept_) kept.forget();
}

std::size_t LinearSolver::bytes() const {
  std::size_t sum = lu_.bytes() + normal_lu_.bytes() + gmres_.bytes();
  for (const Kept& kept : kept_) sum += kept.bytes();
  for (const RecyclingGcr& gcr : gcr_) sum += gcr.bytes();
  return sum;
}

}  // namespace rollcon
