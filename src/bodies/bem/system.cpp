#include "bodies/bem/system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "bodies/model/mesh_models.hpp"
#include "linalg/blas_threads.hpp"
#include "mesh/box.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/memory_limit.hpp"

namespace rollcon::bem {
namespace {

/// Condition beyond which no digit of a solution can be trusted.
constexpr double worst_condition = 1e14;

Vec3 middle_of_held(const BodyMesh& mesh) {
  Vec3 sum{0, 0, 0};
  double count = 0;
  for (std::size_t k = 0; k < mesh.held.size(); ++k)
    if (mesh.held[k] != 0) {
      sum = sum + mesh.surface.node[k];
      ++count;
    }
  return (1 / std::max(count, 1.0)) * sum;
}

}  // namespace

System::System(const BodyMesh& mesh, const TractionNodes& fans, double young, double poisson,
               const BodyOptions& options, int threads, SectionReader* saved)
    : ResponseCache(mesh.surface, options.cache_bytes),
      mesh_(mesh),
      fans_(fans),
      shear_(young / (2 * (1 + poisson))),
      poisson_(poisson),
      options_(options),
      lifted_(lift(mesh, options.edge_angle)),
      integrals_(lifted_.mesh, poisson, options.accuracy),
      unknowns_(choose_unknowns(mesh, fans)) {
  require_factor();
  for (CollocationPoint& p : unknowns_.point)
    if (p.element >= 0) p.x = evaluate_surface(lifted_.mesh, p.element, p.xi, p.eta).x;
  fan_size_.assign(at(fans.size()), 0);
  for (std::int64_t e = 0; e < mesh.surface.elements(); ++e) {
    const double size = element_diameter(mesh.surface, e);
    for (std::int64_t k = mesh.surface.offset[at(e)]; k < mesh.surface.offset[at(e) + 1]; ++k) {
      double& of_fan = fan_size_[at(fans.of[at(k)])];
      of_fan = std::max(of_fan, size);
    }
  }
  reach_ = 0.5 * length(box_of(mesh.surface.node).size());
  held_at_ = middle_of_held(mesh);
  statistics_.unknowns = unknowns_.columns;
  if (saved) {
    restore(*saved, unknowns_.displacement.size(), unknowns_.traction.size());
    statistics_.peak_bytes = factor_bytes() + kept_bytes();
  } else if (options.prepare != 0 || mesh.loaded()) {
    factorize(threads);
  }
  own_solved_ = true;
}

void System::factorize(int threads) {
  const BlasThreads blas(threads);
  const CollocationBlocks blocks(mesh_, fans_, lifted_, integrals_, unknowns_, fan_size_, threads);
  if (hierarchical())
    factorize_hierarchically(blocks);
  else
    factorize_dense(threads);
  kept_equations_.reset();
  statistics_.nonzeros = static_cast<std::int64_t>(factor_bytes() / sizeof(double));
  statistics_.condition = factor_->condition();
  if (!(statistics_.condition < worst_condition)) {
    factor_.reset();
    fail(Status::err_singular,
         "the equations of the boundary-element body are singular (condition %.1e): check its "
         "supports and its mesh",
         statistics_.condition);
  }
  if (hierarchical()) check_rigid_motion(blocks);
  if (!own_solved_) own_ = solve_own_load(mesh_, blocks);
}

void System::factorize_dense(int threads) {
  auto matrix = std::make_unique<FactoredMatrix>();
  double* a = matrix->prepare(unknowns_.columns);
  if (const auto known = equations_.lock()) {
    std::copy(known->dense.begin(), known->dense.end(), a);
    count_peak(2 * matrix->bytes());
  } else {
    const Stopwatch watch(statistics_.seconds_assembly);
    assemble(threads, a);
    ++statistics_.assemblies;
  }
  const Stopwatch watch(statistics_.seconds_factor);
  ++statistics_.factorizations;
  matrix->factor();
  count_peak(matrix->bytes() +
             at(threads) * (at(lifted_.mesh.nodes()) + at(fans_.size())) * 9 * lanes * sizeof(double));
  factor_ = std::move(matrix);
}

OwnLoads System::solve_own_load(const BodyMesh& loaded, const CollocationBlocks& blocks) const {
  OwnLoads own;
  const std::vector<double> given = given_tractions(loaded);
  const bool moved = loaded.moved();
  if (given.empty() && !moved) return own;
  std::vector<double> b = own_load(loaded, given, blocks);
  factor_->solve(b.data(), 1);
  require_no_overflow(b);
  own.displacement.resize(unknowns_.displacement.size());
  for (std::size_t k = 0; k < own.displacement.size(); ++k) {
    const std::int32_t column = unknowns_.displacement[k];
    own.displacement[k] = column >= 0 ? b[at(column)] : loaded.held_value[k / 3][k % 3];
  }
  own.traction.assign(unknowns_.traction.size(), 0.0);
  for (std::size_t k = 0; k < given.size(); ++k)
    if (unknowns_.traction[k] < 0) own.traction[k] = shear_ * given[k];
  for (const SpreadReaction& spread : unknowns_.spread)
    if (const std::size_t k = 3 * at(spread.fan) + at(spread.component); !given.empty())
      own.traction[k] = shear_ * given[k];
  const std::vector<double> load = own.traction;
  add_reactions(b.data(), own.traction);
  if (!moved) own.missed = missed(load, own.traction);
  own.reaction = support_reaction(own.traction, given);
  return own;
}

OwnLoads System::solve_loads(const BodyMesh& loaded, int threads) {
  const std::lock_guard lock(mutex_);
  const BlasThreads blas(threads);
  if (!factor_) factorize(threads);
  const Stopwatch watch(statistics_.seconds_assembly);
  return solve_own_load(loaded, {mesh_, fans_, lifted_, integrals_, unknowns_, fan_size_, threads});
}

void System::condense(std::vector<double> b, const LoadedSurface& surface, SurfaceRows& rows, int threads) {
  const BlasThreads blas(threads);
  ++statistics_.condensations;
  const std::int64_t n = unknowns_.columns;
  const auto columns = static_cast<std::int64_t>(rows.column.size());
  factor_->eliminate(b.data(), 3 * columns);
  check_balance(b, surface);
  std::int64_t first = n;  // least unknown asked for
  for (const std::int32_t k : rows.row)
    for (std::size_t c = 0; c < 3; ++c)
      if (const std::int32_t unknown = unknowns_.displacement[3 * at(k) + c]; unknown >= 0)
        first = std::min<std::int64_t>(first, unknown);
  factor_->substitute(b.data(), 3 * columns, first);
  rows.u.resize(3 * static_cast<std::int64_t>(rows.row.size()), 3 * columns);
  for (std::size_t r = 0; r < rows.row.size(); ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::int32_t unknown = unknowns_.displacement[3 * at(rows.row[r]) + c];
      double* out = rows.u.row(static_cast<std::int64_t>(3 * r + c));
      for (std::int64_t k = 0; k < 3 * columns; ++k) out[k] = unknown >= 0 ? b[at(unknown + k * n)] : 0;
    }
  count_peak(factor_bytes() + b.size() * sizeof(double) + rows.u.bytes());
  if (options_.keep_factors == 0) factor_.reset();
}

void System::respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) {
  if (!factor_) factorize(threads);
  const Stopwatch watch(statistics_.seconds_condense);
  condense(right_sides(surface, rows, threads), surface, rows, threads);
}

Imbalances System::imbalances() const {
  const std::lock_guard lock(mutex_);
  return imbalances_;
}

BodyStatistics System::statistics() const {
  const std::lock_guard lock(mutex_);
  BodyStatistics s = statistics_with(factor_bytes() + integrals_.bytes());
  s.kernel_evaluations += integrals_.kernel_evaluations();
  const Imbalances& i = imbalances_;
  s.imbalance = std::max({i.along[0], i.along[1], i.along[2], i.pressure, own_.missed});
  return s;
}

void require_support() {}

std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans, double young, double poisson,
                                         const BodyOptions& options, int threads, SectionReader* saved) {
  return std::make_unique<System>(mesh, fans, young, poisson, options, threads, saved);
}

}  // namespace rollcon::bem
