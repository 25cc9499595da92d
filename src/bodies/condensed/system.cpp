#include "bodies/condensed/system.hpp"

#include <algorithm>

#include "bodies/condensed/matrix.hpp"
#include "bodies/model/felt_layer.hpp"
#include "bodies/model/mesh_models.hpp"
#include "bodies/model/supports.hpp"
#include "linalg/blas_threads.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon::condensed {

System::System(const BodyMesh& mesh, const TractionNodes& fans, const Elastic& contact, const BodyOptions& options,
               int threads, SectionReader* saved)
    : ResponseCache(mesh.surface, options.cache_bytes), mesh_(mesh), fans_(fans), contact_(contact) {
  const Stopwatch watch(statistics_.seconds_factor);
  const BlasThreads blas(threads);
  const std::int64_t size = 3 * surface_.nodes();
  for (std::int64_t k = 0; k < size; ++k) (mesh.held[at(k / 3)] >> k % 3 & 1 ? held_ : free_).push_back(k);
  if (mesh.matrix->form == MatrixForm::stiffness)
    invert(mesh.matrix->value);
  else
    take(mesh.matrix->value);
  local_young_ = local_young(surface_, flexibility_, contact.poisson);
  statistics_.unknowns = statistics_.condensed = std::ssize(free_);
  statistics_.assemblies = statistics_.factorizations = 1;
  if (saved)
    restore(*saved, at(size), 0);
  else
    own_ = solve_own_load(mesh);
}

void System::invert(const RowMatrix<double>& stiffness) {
  require_supports(mesh_, &stiffness);
  const auto factor = factor_of(stiffness, free_, "stiffness", surface_.index_base);
  statistics_.condition = factor->statistics().condition;
  const std::vector<double> inverted = inverse(*factor);
  const std::size_t n = free_.size();
  std::vector<double> moved;  // forces by unit displacements of what is held, then displacements
  for (const std::int64_t h : held_)
    for (const std::int64_t k : free_) moved.push_back(-stiffness.row(k)[h]);
  factor->solve(moved.data(), std::ssize(held_));
  flexibility_.resize(stiffness.rows(), stiffness.rows());
  by_held_.resize(stiffness.rows(), std::ssize(held_));
  for (std::size_t h = 0; h < held_.size(); ++h) {
    by_held_.row(held_[h])[h] = 1;
    for (std::size_t i = 0; i < n; ++i) by_held_.row(free_[i])[h] = moved[h * n + i];
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) flexibility_.row(free_[i])[free_[j]] = inverted[i * n + j];
}

void System::take(const RowMatrix<double>& flexibility) {
  if (!held_.empty())
    fail(Status::err_argument,
         "node %lld (counting from %d) has a support, but the flexibility is that of a body that is held already: give "
         "the stiffness, or hold the body where it is condensed",
         static_cast<long long>(held_[0] / 3 + surface_.index_base), surface_.index_base);
  std::vector<std::int64_t> moving;
  for (std::int64_t k = 0; k < flexibility.rows(); ++k)
    if (std::any_of(flexibility.row(k), flexibility.row(k + 1), [](double v) { return v != 0; })) moving.push_back(k);
  statistics_.condition = factor_of(flexibility, moving, "flexibility", surface_.index_base)->statistics().condition;
  flexibility_ = flexibility;
}

OwnLoads System::solve_own_load(const BodyMesh& loaded) const {
  OwnLoads own;
  if (!loaded.loaded()) return own;
  std::vector<double> force(3 * loaded.held.size(), 0.0), given;
  add_face_loads(loaded, 1, force);
  for (const std::int64_t k : held_) given.push_back(loaded.held_value[at(k / 3)][at(k % 3)]);
  own.displacement.assign(force.size(), 0.0);
  multiply(flexibility_.data(), flexibility_.rows(), flexibility_.columns(), force.data(), 0, own.displacement.data());
  if (!held_.empty())
    multiply(by_held_.data(), by_held_.rows(), by_held_.columns(), given.data(), 1, own.displacement.data());
  require_no_overflow(own.displacement);
  // Whatever holds the body, also inside the given matrix, is in balance with the loads.
  for (std::size_t k = 0; k < force.size() / 3; ++k) {
    const Vec3 back{-force[3 * k], -force[3 * k + 1], -force[3 * k + 2]};
    own.reaction.force = own.reaction.force + back;
    own.reaction.moment = own.reaction.moment + cross(surface_.node[k], back);
  }
  return own;
}

OwnLoads System::solve_loads(const BodyMesh& loaded, int threads) {
  const std::lock_guard lock(mutex_);
  const BlasThreads blas(threads);
  return solve_own_load(loaded);
}

System::Acting System::act(const LoadedSurface& surface, SurfaceOutline& outline) const {
  if (surface.of_faces()) {
    const SurfaceCoupling mass = couple_faces(surface_, surface.face);
    return {mass.node, columns_of(mass, outline.column)};
  }
  FeltTractions felt = feel({mesh_, fans_, [this](std::int64_t) { return contact_; }}, surface.layer, outline, false);
  Acting acting{felt.node, std::move(felt.load)};
  felt.tell(outline);
  return acting;
}

void System::respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) {
  const Stopwatch watch(statistics_.seconds_condense);
  const BlasThreads blas(threads);
  ++statistics_.condensations;
  const Acting acting = act(surface, rows);
  const auto columns = static_cast<std::int64_t>(rows.column.size());
  rows.u.resize(3 * std::ssize(rows.row), 3 * columns);
  RowMatrix<double> part, moved;
  part.resize(3 * std::ssize(rows.row), std::ssize(acting.node));
  for (std::size_t b = 0; b < 3; ++b) {
    for (std::int64_t r = 0; r < part.rows(); ++r) {
      const double* from = flexibility_.row(3 * rows.row[at(r / 3)] + r % 3);
      for (std::size_t k = 0; k < acting.node.size(); ++k) part.row(r)[k] = from[3 * at(acting.node[k]) + b];
    }
    moved.release();
    moved.resize(part.rows(), columns);
    add_product(part, acting.force, moved);
    for (std::int64_t r = 0; r < part.rows(); ++r)
      for (std::int64_t k = 0; k < columns; ++k) rows.u.row(r)[3 * k + static_cast<std::int64_t>(b)] = moved.row(r)[k];
  }
  count_peak(flexibility_.bytes() + part.bytes() + moved.bytes() + rows.u.bytes());
}

void System::load(const LoadedSurface& surface, SurfaceLoads& loads, int /*threads*/) {
  const Acting acting = act(surface, loads);
  SparseMatrix& b = loads.load;
  b.begin(flexibility_.rows());
  for (std::int64_t k = 0; k < acting.force.columns(); ++k)
    for (std::int64_t c = 0; c < 3; ++c) {
      for (std::int64_t i = 0; i < acting.force.rows(); ++i)
        if (const double v = acting.force.row(i)[k]; v != 0) b.push(3 * acting.node[at(i)] + c, v);
      b.end_column();
    }
  loads.unknown.assign(3 * loads.row.size(), -1);
}

void System::solve_everywhere(std::span<double> load, SurfaceState& state, int threads) {
  const BlasThreads blas(threads);
  state.u.resize(load.size());
  multiply(flexibility_.data(), flexibility_.rows(), flexibility_.columns(), load.data(), 0, state.u.data());
}

std::unique_ptr<const BodyFields> System::fields(SurfaceState&& /*state*/, const OwnLoads& /*own*/) {
  fail(Status::err_unsupported,
       "the body is a condensed body: its inside is known to the program that condensed it alone, which takes the "
       "contact's forces from rollcon_contact_write_loads");
}

BodyStatistics System::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_with(flexibility_.bytes() + by_held_.bytes());
}

Imbalances System::imbalances() const {
  Imbalances found;
  found.local_young = local_young_;
  return found;
}

void require_support() {}

std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans, const Elastic& contact,
                                         const BodyOptions& options, int threads, SectionReader* saved) {
  return std::make_unique<System>(mesh, fans, contact, options, threads, saved);
}

}  // namespace rollcon::condensed
