#include "bodies/fem/system.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <new>
#include <utility>

#include "bodies/model/mesh_models.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/shared_factor.hpp"
#include "linalg/sparse_checks.hpp"
#include "mesh/box.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon::fem {
namespace {

/// Contact faces with more unknowns wait for the frame, which mostly covers a part of them (above all when the caller
/// did not name them): the condensed matrix is dense.
constexpr std::int64_t most_condensed_at_once = 6000, most_unnamed_at_once = 1500;

double largest_modulus(const std::map<std::int32_t, Elastic>& material) {
  double most = 0;
  for (const auto& [tag, m] : material) most = std::max(most, m.young);
  return most;
}

Hex8 hex8_of(const BodyOptions& options) {
  return options.hex8 == 0 ? Hex8::enhanced : Hex8::b_bar;
}

std::vector<Material> by_element(const BodyMesh& mesh, const std::map<std::int32_t, Elastic>& material,
                                 double reference) {
  std::vector<Material> result;
  for (const std::int32_t tag : mesh.volume.tag) {
    const Elastic& m = material.at(tag);
    result.push_back({m.young / reference, m.poisson});
  }
  return result;
}

/// Diagonal of the box around a body over the thickness that it has on the average.
double length_over_thickness(const SurfaceMesh& surface) {
  Box box;
  double area = 0;
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    area += element_area(surface, e);
    box.add(box_of(surface.node, surface.element(e)));
  }
  return length(box.size()) * area / (2 * enclosed_volume(surface));
}

}  // namespace

System::System(const BodyMesh& mesh, const TractionNodes& fans, const std::map<std::int32_t, Elastic>& material,
               const BodyOptions& options, int threads, SectionReader* saved)
    : ResponseCache(mesh.surface, options.cache_bytes),
      mesh_(mesh),
      fans_(fans),
      reference_(largest_modulus(material)),
      options_(options),
      assembly_(mesh, by_element(mesh, material, reference_), hex8_of(options), reference_),
      interior_(mesh, assembly_, hex8_of(options), reference_),
      unknowns_(number_unknowns(mesh)) {
  statistics_.unknowns = unknowns_.count;
  contact_ = unknowns_at(nodes_around(surface_, contact_elements(mesh)));
  const bool shared = options.factor_ranks != 0 && SharedWork::ranks().size() > 1;
  const bool few = shared || static_cast<std::int64_t>(contact_.size()) <=
                                 (mesh.contact_tag.empty() ? most_unnamed_at_once : most_condensed_at_once);
  if (saved) {
    restore(*saved, unknowns_.of.size(), 0);
    statistics_.peak_bytes = kept_bytes() + factor_bytes();
  } else if ((few && options.prepare != 0) || mesh.loaded() || shared) {
    factorize(few ? contact_ : std::vector<std::int64_t>{}, threads);
  }
}

std::vector<std::int64_t> System::unknowns_at(const std::vector<std::int32_t>& node) const {
  std::vector<std::int64_t> unknown;
  for (const std::int32_t k : node)
    for (std::size_t c = 0; c < 3; ++c)
      if (const std::int64_t u = unknowns_.of[3 * at(k) + c]; u >= 0) unknown.push_back(u);
  return unknown;
}

void System::require_matrix(int threads) {
  if (matrix_.columns > 0) return;
  const Stopwatch watch(statistics_.seconds_assembly);
  matrix_ = assembly_.stiffness(unknowns_, threads);
  ++statistics_.assemblies;
}

std::unique_ptr<SparseFactor> System::factor_of(std::span<const std::int64_t> condensed, int threads,
                                                const Ranks& ranks) {
  const BlasThreads blas(threads);
  double seconds = 0;
  std::unique_ptr<SparseFactor> factor;
  try {
    require_matrix(threads);
    check_interrupt();
    const Stopwatch watch(seconds);
    factor = ranks.size() > 1 ? factor_over_ranks(matrix_, condensed, ranks) : factor_definite(matrix_, condensed);
  } catch (const ZeroPivot& pivot) {
    const auto found = std::find(unknowns_.of.begin(), unknowns_.of.end(), pivot.unknown());
    const auto place = found - unknowns_.of.begin();
    fail(Status::err_singular,
         "the stiffness of the finite-element body is singular at component %c of node %lld "
         "(counting from %d): check its supports, its mesh and the ratio of its moduli%s",
         "xyz"[place % 3], static_cast<long long>(place / 3) + surface_.index_base, surface_.index_base,
         bending_hint().c_str());
  } catch (const std::bad_alloc&) {
    out_of_memory(unknowns_.count, 0);  // how much it needs is known once the unknowns are ordered
  }
  ++statistics_.factorizations;
  const SparseStatistics s = factor->statistics();
  statistics_.seconds_order += s.seconds_order;
  statistics_.seconds_factor += seconds - s.seconds_order;
  count_peak(matrix_.bytes() + s.peak_bytes);
  return factor;
}

void System::factorize(std::vector<std::int64_t> condensed, int threads) {
  const BlasThreads blas(threads);
  factor_.reset();
  factor_ = factor_of(condensed, threads, options_.factor_ranks != 0 ? SharedWork::ranks() : Ranks());
  const SparseStatistics s = factor_->statistics();
  statistics_.nonzeros = s.nonzeros;
  statistics_.condition = s.condition;
  statistics_.condensed = static_cast<std::int64_t>(condensed.size());
  place_condensed(std::move(condensed));
  if (own_.displacement.empty()) own_ = solve_own_load(mesh_, assembly_, *factor_);
  factor_->keep_condensed();
  const bool all_of_contact =
      std::all_of(contact_.begin(), contact_.end(), [&](std::int64_t u) { return condensed_at_[at(u)] >= 0; });
  if (options_.keep_factors == 0 || all_of_contact) matrix_ = {};
}

// Says what a thin body's singular stiffness may come from.
std::string System::bending_hint() const {
  constexpr double suspect = 1e12;  // seen to fail from 1e13, held at one edge
  const double ratio = length_over_thickness(surface_);
  double poisson = 0;
  for (std::int64_t e = 0; e < mesh_.volume.elements(); ++e) poisson = std::max(poisson, assembly_.material(e).poisson);
  if (!(std::pow(ratio, 4) > suspect * (1 - 2 * poisson))) return "";
  char text[400];
  std::snprintf(text, sizeof text,
                ". It is some %.0f times as long as thick, with poisson up to %.7g: held at an "
                "edge alone it bends so easily beside its own elements that no digit is left where "
                "(length/thickness)^4/(1 - 2 poisson) exceeds 1e13; hold it along its length, make "
                "it thicker, or take poisson further from 0.5",
                ratio, poisson);
  return text;
}

void System::place_condensed(std::vector<std::int64_t> condensed) {
  condensed_ = std::move(condensed);
  condensed_at_.assign(at(unknowns_.count), -1);
  for (std::size_t k = 0; k < condensed_.size(); ++k) condensed_at_[at(condensed_[k])] = static_cast<std::int64_t>(k);
}

OwnLoads System::solve_own_load(const BodyMesh& loaded, const Assembly& assembly, SparseFactor& factor) const {
  OwnLoads own;
  if (!loaded.loaded()) return own;
  const bool moved = loaded.moved();
  const std::vector<double> load = assembly.loads(reference_);
  std::vector<double> u(load.size(), 0.0), b(at(unknowns_.count));
  for (std::size_t k = 0; k < u.size(); ++k)
    if (unknowns_.of[k] < 0) u[k] = loaded.held_value[k / 3][k % 3];
  const std::vector<double> moved_force = moved ? assembly.forces_at_supports(u) : std::vector<double>(u.size(), 0.0);
  for (std::size_t k = 0; k < u.size(); ++k)
    if (unknowns_.of[k] >= 0) b[at(unknowns_.of[k])] = load[k] - moved_force[k];
  factor.solve(b.data(), 1);
  require_no_overflow(b);
  for (std::size_t k = 0; k < u.size(); ++k)
    if (unknowns_.of[k] >= 0) u[k] = b[at(unknowns_.of[k])];
  const std::vector<double> force = assembly.forces_at_supports(u);
  for (std::size_t k = 0; k < u.size(); ++k) {
    if (unknowns_.of[k] >= 0) continue;
    Vec3 part{0, 0, 0};
    part[k % 3] = reference_ * (force[k] - load[k]);
    own.reaction.force = own.reaction.force + part;
    own.reaction.moment = own.reaction.moment + cross(surface_.node[k / 3], part);
  }
  own.displacement = std::move(u);
  return own;
}

OwnLoads System::solve_loads(const BodyMesh& loaded, int threads) {
  const std::lock_guard lock(mutex_);
  const BlasThreads blas(threads);
  require_whole(threads);
  std::vector<Material> material;
  for (std::int64_t e = 0; e < mesh_.volume.elements(); ++e) material.push_back(assembly_.material(e));
  const Assembly assembly(loaded, std::move(material), hex8_of(options_), reference_);
  OwnLoads own = solve_own_load(loaded, assembly, *whole_);
  if (options_.keep_factors == 0) whole_.reset();
  return own;
}

void System::require_condensed(const std::vector<std::int32_t>& node, int threads) {
  std::vector<std::int64_t> unknown = unknowns_at(node);
  const bool there =
      factor_ && std::all_of(unknown.begin(), unknown.end(), [&](std::int64_t u) { return condensed_at_[at(u)] >= 0; });
  if (there) return;
  // What earlier frames needed stays, so that going back to them costs nothing.
  std::vector<std::int64_t> all;
  std::set_union(unknown.begin(), unknown.end(), condensed_.begin(), condensed_.end(), std::back_inserter(all));
  const bool few = static_cast<std::int64_t>(all.size()) <= most_condensed_at_once;
  factorize(few ? std::move(all) : std::move(unknown), threads);
}

void System::condense(const std::vector<std::int32_t>& loaded, const RowMatrix<double>& load, SurfaceRows& rows,
                      int threads) {
  std::vector<std::int32_t> node = loaded;
  node.insert(node.end(), rows.row.begin(), rows.row.end());
  std::sort(node.begin(), node.end());
  node.erase(std::unique(node.begin(), node.end()), node.end());
  require_condensed(node, threads);

  const Stopwatch watch(statistics_.seconds_condense);
  const BlasThreads blas(threads);
  ++statistics_.condensations;
  const std::size_t m = condensed_.size(), columns = rows.column.size();
  rows.u.resize(3 * static_cast<std::int64_t>(rows.row.size()), 3 * static_cast<std::int64_t>(columns));
  constexpr std::size_t slab = 128;  // columns at a time
  std::vector<double> b;
  for (std::size_t first = 0; first < columns; first += slab) {
    check_interrupt();
    const std::size_t count = std::min(slab, columns - first);
    b.assign(m * 3 * count, 0.0);
    for (std::size_t i = 0; i < loaded.size(); ++i) {
      const double* force = load.row(static_cast<std::int64_t>(i)) + first;
      for (std::size_t c = 0; c < 3; ++c)
        if (const std::int64_t u = unknowns_.of[3 * at(loaded[i]) + c]; u >= 0)
          for (std::size_t k = 0; k < count; ++k) b[(3 * k + c) * m + at(condensed_at_[at(u)])] = force[k] / reference_;
    }
    factor_->solve_condensed(b.data(), static_cast<std::int64_t>(3 * count));
    for (std::size_t r = 0; r < rows.row.size(); ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::int64_t u = unknowns_.of[3 * at(rows.row[r]) + c];
        double* out = rows.u.row(static_cast<std::int64_t>(3 * r + c)) + 3 * first;
        for (std::size_t k = 0; k < 3 * count; ++k) out[k] = u >= 0 ? b[k * m + at(condensed_at_[at(u)])] : 0;
      }
  }
  count_peak(matrix_.bytes() + factor_bytes() + b.capacity() * sizeof(double) + rows.u.bytes());
  if (options_.keep_factors == 0) factor_.reset();
}

FeltTractions System::feel(const SurfaceMesh& layer, SurfaceOutline& outline) const {
  const auto material = [this](std::int64_t face) {
    const Material& m = assembly_.material(mesh_.origin[at(face)].element);
    return Elastic{m.young * reference_, m.poisson};
  };
  return rollcon::feel({mesh_, fans_, material}, layer, outline, false);
}

void System::respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) {
  if (surface.of_faces()) {
    const SurfaceCoupling mass = couple_faces(surface_, surface.face);
    return condense(mass.node, columns_of(mass, rows.column), rows, threads);
  }
  FeltTractions felt = feel(surface.layer, rows);
  condense(felt.node, felt.load, rows, threads);
  felt.tell(rows);
}

void System::require_whole(int threads) {
  if (whole_) return;
  const bool kept = matrix_.columns > 0 && options_.keep_factors != 0;
  whole_ = factor_of({}, threads, {});
  if (!kept) matrix_ = {};
}

void System::solve_everywhere(std::span<double> load, SurfaceState& state, int threads) {
  const std::lock_guard lock(mutex_);
  const BlasThreads blas(threads);
  require_whole(threads);
  whole_->solve(load.data(), 1);
  state.u.resize(unknowns_.of.size());
  for (std::size_t k = 0; k < unknowns_.of.size(); ++k)
    state.u[k] = unknowns_.of[k] >= 0 ? load[at(unknowns_.of[k])] : 0;
  if (options_.keep_factors == 0) whole_.reset();
}

std::unique_ptr<const BodyFields> System::fields(SurfaceState&& state, const OwnLoads& own) {
  state.u.resize(unknowns_.of.size(), 0.0);
  for (std::size_t k = 0; k < own.displacement.size(); ++k) state.u[k] += own.displacement[k];
  return std::make_unique<InteriorFields>(interior_, std::move(state.u));
}

BodyStatistics System::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_with(matrix_.bytes() + factor_bytes() + (whole_ ? whole_->statistics().bytes : 0));
}

void require_support() {}

std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans,
                                         const std::map<std::int32_t, Elastic>& material, const BodyOptions& options,
                                         int threads, SectionReader* saved) {
  return std::make_unique<System>(mesh, fans, material, options, threads, saved);
}

}  // namespace rollcon::fem
