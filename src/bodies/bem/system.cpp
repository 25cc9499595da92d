#include "bodies/bem/system.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/mesh_models.hpp"
#include "linalg/blas_threads.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"

namespace rollcon::bem {
namespace {

/// Beyond it no digit of a solution can be trusted.
constexpr double worst_condition = 1e14;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

void require_memory(std::int64_t unknowns) {
  const double gigabytes = 8e-9 * static_cast<double>(unknowns) * static_cast<double>(unknowns);
  const double machine = 1e-9 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                         static_cast<double>(sysconf(_SC_PAGESIZE));
  if (gigabytes > machine)
    fail(Status::err_memory,
         "the matrix of a boundary-element body with %lld unknowns needs %.1f GB, this machine has "
         "%.1f GB",
         static_cast<long long>(unknowns), gigabytes, machine);
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
      integrals_(mesh.surface, poisson, options.accuracy),
      unknowns_(choose_unknowns(mesh, fans)) {
  require_memory(unknowns_.columns);
  fan_size_.assign(at(fans.size()), 0);
  for (std::int64_t e = 0; e < mesh.surface.elements(); ++e) {
    const double size = element_diameter(mesh.surface, e);
    for (std::int64_t k = mesh.surface.offset[at(e)]; k < mesh.surface.offset[at(e) + 1]; ++k) {
      double& of_fan = fan_size_[at(fans.of[at(k)])];
      of_fan = std::max(of_fan, size);
    }
  }
  statistics_.unknowns = unknowns_.columns;
  const auto given = [](const Vec3& v) { return v != Vec3{0, 0, 0}; };
  const bool loaded =
      !mesh.load.empty() || std::any_of(mesh.held_value.begin(), mesh.held_value.end(), given);
  if (saved)
    restore(*saved);
  else if (options.prepare != 0 || loaded)
    factorize(threads);
  own_solved_ = true;
}

void System::factorize(int threads) {
  const BlasThreads blas(threads);
  std::vector<double> own_load;
  if (!own_solved_) own_load.assign(at(unknowns_.columns), 0.0);
  double* a = matrix_.prepare(unknowns_.columns);
  if (const auto known = equations_.lock()) {
    std::copy(known->dense.begin(), known->dense.end(), a);
    statistics_.peak_bytes = std::max(statistics_.peak_bytes, 2 * matrix_.bytes());
  } else {
    const Stopwatch watch(statistics_.seconds_assembly);
    assemble(threads, a, own_load);
    ++statistics_.assemblies;
  }
  kept_equations_.reset();
  const Stopwatch watch(statistics_.seconds_factor);
  ++statistics_.factorizations;
  const bool regular = matrix_.factor();
  statistics_.condition = matrix_.condition();
  statistics_.peak_bytes =
      std::max(statistics_.peak_bytes,
               matrix_.bytes() + at(threads) * (at(mesh_.surface.nodes()) + at(fans_.size())) * 9 *
                                     lanes * sizeof(double));
  if (!regular || !(matrix_.condition() < worst_condition)) {
    matrix_.release();
    fail(Status::err_singular,
         "the equations of the boundary-element body are singular (condition %.1e): check its "
         "supports and its mesh",
         statistics_.condition);
  }
  if (!own_solved_) solve_own_load(own_load);
}

void System::solve_own_load(std::vector<double>& b) {
  const std::vector<double> given = given_tractions();
  const bool moved =
      std::any_of(mesh_.held_value.begin(), mesh_.held_value.end(), [](const Vec3& v) {
        return v != Vec3{0, 0, 0};
      });
  if (given.empty() && !moved) return;
  matrix_.solve(b.data(), 1);
  if (!std::all_of(b.begin(), b.end(), [](double v) { return std::isfinite(v); }))
    fail(Status::err_argument,
         "the body's loads are too large for its elastic constants: its displacements overflow");
  own_displacement_.resize(unknowns_.displacement.size());
  for (std::size_t k = 0; k < own_displacement_.size(); ++k) {
    const std::int32_t column = unknowns_.displacement[k];
    own_displacement_[k] = column >= 0 ? b[at(column)] : mesh_.held_value[k / 3][k % 3];
  }
  own_traction_.assign(unknowns_.traction.size(), 0.0);
  for (std::size_t k = 0; k < own_traction_.size(); ++k) {
    const std::int32_t column = unknowns_.traction[k];
    if (column >= 0)
      own_traction_[k] = shear_ * b[at(column)] / fan_size_[k / 3];
    else if (!given.empty())
      own_traction_[k] = shear_ * given[k];
  }
  for (const SpreadReaction& spread : unknowns_.spread) {
    const std::size_t own = 3 * at(spread.fan) + at(spread.component);
    const double value = shear_ * b[at(unknowns_.traction[own])] / fan_size_[at(spread.fan)];
    if (!given.empty()) own_traction_[own] += shear_ * given[own];
    for (const auto& [f, part] : spread.others)
      own_traction_[3 * at(f) + at(spread.component)] += part * value;
  }
}

void System::condense(std::vector<double> b, SurfaceRows& rows, int threads) {
  const BlasThreads blas(threads);
  ++statistics_.condensations;
  const std::int64_t n = unknowns_.columns;
  const auto columns = static_cast<std::int64_t>(rows.column.size());
  matrix_.solve(b.data(), 3 * columns);
  rows.u.resize(3 * static_cast<std::int64_t>(rows.row.size()), 3 * columns);
  for (std::size_t r = 0; r < rows.row.size(); ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::int32_t unknown = unknowns_.displacement[3 * at(rows.row[r]) + c];
      double* out = rows.u.row(static_cast<std::int64_t>(3 * r + c));
      for (std::int64_t k = 0; k < 3 * columns; ++k)
        out[k] = unknown >= 0 ? b[at(unknown + k * n)] : 0;
    }
  statistics_.peak_bytes = std::max(statistics_.peak_bytes,
                                    matrix_.bytes() + b.size() * sizeof(double) + rows.u.bytes());
  if (options_.keep_factors == 0) matrix_.release();
}

void System::respond(std::span<const std::int64_t> face, SurfaceRows& rows, int threads) {
  if (!matrix_.factored()) factorize(threads);
  const Stopwatch watch(statistics_.seconds_condense);
  condense(right_sides(integrals_, columns_of_faces(face, rows),
                       static_cast<std::int64_t>(rows.column.size()), true, threads),
           rows, threads);
}

void System::respond(const SurfaceMesh& layer, SurfaceRows& rows, int threads) {
  if (!matrix_.factored()) factorize(threads);
  const Stopwatch watch(statistics_.seconds_condense);
  const BoundaryIntegrals integrals(layer, poisson_, options_.accuracy);
  condense(right_sides(integrals, layer.connectivity, layer.nodes(), false, threads), rows,
           threads);
  statistics_.kernel_evaluations += integrals.kernel_evaluations();
}

BodyStatistics System::statistics() const {
  const std::lock_guard lock(mutex_);
  BodyStatistics s = statistics_;
  s.kernel_evaluations += integrals_.kernel_evaluations();
  s.bytes = matrix_.bytes() + integrals_.bytes() + kept_bytes();
  if (const auto equations = equations_.lock())
    s.bytes += equations->dense.capacity() * sizeof(double);
  s.nonzeros = s.unknowns * s.unknowns;
  count_kept(s);
  return s;
}

void require_support() {}

std::unique_ptr<SurfaceResponse> make_response(const BodyMesh& mesh, const TractionNodes& fans,
                                               double young, double poisson,
                                               const BodyOptions& options, int threads,
                                               SectionReader* saved) {
  return std::make_unique<System>(mesh, fans, young, poisson, options, threads, saved);
}

}  // namespace rollcon::bem
