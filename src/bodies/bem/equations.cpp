/// Writes boundary elements out as matrix and right sides, with nothing factorised, and gives the whole surface's
/// state.

#include <algorithm>
#include <utility>

#include "bodies/bem/system.hpp"
#include "linalg/blas_threads.hpp"
#include "support/clock.hpp"
#include "support/index.hpp"

namespace rollcon::bem {

// The factors take the matrix's place: with them the body keeps no second copy of its own.
std::shared_ptr<const BodyEquations> System::equations(int threads) {
  const std::lock_guard lock(mutex_);
  if (auto known = equations_.lock()) return known;
  auto equations = std::make_shared<BodyEquations>();
  equations->unknowns = unknowns_.columns;
  {
    const Stopwatch watch(statistics_.seconds_assembly);
    require_matrix();
    equations->dense.resize(at(unknowns_.columns * unknowns_.columns));
    assemble(threads, equations->dense.data());
    ++statistics_.assemblies;
  }
  count_peak(factor_bytes() + equations->bytes());
  equations_ = equations;
  if (options_.keep_factors != 0 && !factor_) kept_equations_ = equations;
  return equations;
}

void System::write_loads(const std::vector<double>& b, SurfaceLoads& loads) const {
  loads.unknown.clear();
  for (const std::int32_t k : loads.row)
    for (std::size_t c = 0; c < 3; ++c) loads.unknown.push_back(unknowns_.displacement[3 * at(k) + c]);
  const std::int64_t n = unknowns_.columns;
  SparseMatrix& to = loads.load;
  to.begin(n);
  const auto count = static_cast<std::size_t>(std::count_if(b.begin(), b.end(), [](double v) { return v != 0; }));
  to.row.reserve(count);
  to.value.reserve(count);
  for (std::size_t k = 0; k < 3 * loads.column.size(); ++k) {
    for (std::int64_t i = 0; i < n; ++i)
      if (const double v = b[at(i) + k * at(n)]; v != 0) to.push(i, v);
    to.end_column();
  }
}

void System::load(const LoadedSurface& surface, SurfaceLoads& loads, int threads) {
  write_loads(right_sides(surface, loads, threads), loads);
}

void System::solve_everywhere(std::span<double> load, SurfaceState& state, int threads) {
  const std::lock_guard lock(mutex_);
  const BlasThreads blas(threads);
  if (!factor_) factorize(threads);
  factor_->solve(load.data(), 1);
  state.u.resize(unknowns_.displacement.size());
  for (std::size_t k = 0; k < state.u.size(); ++k)
    state.u[k] = unknowns_.displacement[k] >= 0 ? load[at(unknowns_.displacement[k])] : 0;
  std::vector<double> reaction(unknowns_.traction.size(), 0.0);
  add_reactions(load.data(), reaction);
  state.traction.resize(3 * fans_.of.size());
  for (std::size_t k = 0; k < state.traction.size(); ++k) state.traction[k] = reaction[3 * at(fans_.of[k / 3]) + k % 3];
  if (options_.keep_factors == 0) factor_.reset();
}

std::unique_ptr<const BodyFields> System::fields(SurfaceState&& state, const OwnLoads& own) {
  state.u.resize(unknowns_.displacement.size(), 0.0);
  state.traction.resize(3 * fans_.of.size(), 0.0);
  for (std::size_t k = 0; k < own.displacement.size(); ++k) state.u[k] += own.displacement[k];
  for (std::size_t k = 0; k < state.traction.size() && !own.traction.empty(); ++k)
    state.traction[k] += own.traction[3 * at(fans_.of[k / 3]) + k % 3];
  std::shared_ptr<const SomiglianaBody> inside;
  {
    const std::lock_guard lock(mutex_);
    if (!inside_)
      inside_ =
          std::make_shared<const SomiglianaBody>(lifted_, shear_, poisson_, options_.accuracy, options_.edge_angle);
    inside = inside_;
  }
  return std::make_unique<Somigliana>(std::move(inside), mesh_.surface, state);
}

}  // namespace rollcon::bem
