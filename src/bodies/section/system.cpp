#include "bodies/section/system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/model/archive.hpp"
#include "bodies/model/mesh_models.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_order.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::section {
namespace {

double largest_modulus(const std::map<std::int32_t, Elastic>& material) {
  double most = 0;
  for (const auto& [tag, m] : material) most = std::max(most, m.young);
  return most;
}

std::vector<Elastic> by_element(const BodyMesh& mesh, const std::map<std::int32_t, Elastic>& material,
                                double reference) {
  std::vector<Elastic> result;
  for (const std::int32_t tag : mesh.section.plane().tag)
    result.push_back({material.at(tag).young / reference, material.at(tag).poisson});
  return result;
}

}  // namespace

System::System(const BodyMesh& mesh, const TractionNodes& fans, const std::map<std::int32_t, Elastic>& material,
               const BodyOptions& options, int threads, SectionReader* saved)
    : ResponseCache(mesh.surface, options.cache_bytes),
      mesh_(mesh),
      section_(mesh.section),
      fans_(fans),
      reference_(largest_modulus(material)),
      stiffness_(mesh, by_element(mesh, material, reference_), reference_),
      harmonics_(section_.stations()) {
  statistics_.unknowns = stiffness_.unknowns();
  statistics_.condensed = static_cast<std::int64_t>(profile_unknowns().size());
  if (saved) {
    restore(*saved, 3 * at(surface_.nodes()), stiffness_.numbers().size());
    return;
  }
  ++statistics_.assemblies;
  solve_harmonics(threads);
  own_ = solve_own_load(mesh_);
}

std::vector<std::int64_t> System::profile_unknowns() const {
  std::vector<std::int64_t> unknown;
  for (const std::int32_t k : section_.profile())
    for (std::size_t c = 0; c < 3; ++c)
      if (const std::int64_t u = stiffness_.unknown(k, c); u >= 0) unknown.push_back(u);
  return unknown;
}

std::unique_ptr<SparseFactor> System::factor_of(double n, std::span<const std::int64_t> condensed,
                                                std::span<const std::int64_t> order) const {
  try {
    return factor_definite(stiffness_.matrix(n), condensed, order);
  } catch (const ZeroPivot& pivot) {
    const auto& of = stiffness_.numbers();
    const auto place = std::find(of.begin(), of.end(), pivot.unknown()) - of.begin();
    constexpr const char* component[] = {"across the way", "along the way", "along the section's second axis"};
    fail(Status::err_singular,
         "the stiffness of harmonic n = %.4g of the section is singular at node %lld (counting from %d), %s: check its "
         "supports, its mesh and the ratio of its moduli",
         n, static_cast<long long>(place / 3) + surface_.index_base, surface_.index_base, component[place % 3]);
  }
}

void System::solve_harmonics(int threads) {
  const Stopwatch watch(statistics_.seconds_factor);
  const BlasThreads blas(1);
  const std::vector<std::int64_t> condensed = profile_unknowns();
  const auto width = static_cast<std::int64_t>(section_.profile().size()),
             n = static_cast<std::int64_t>(condensed.size());
  std::vector<std::int64_t> place;  // place of each condensed unknown among 3 * profile node + c
  for (std::int64_t i = 0; i < width; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      if (stiffness_.unknown(section_.profile()[at(i)], c) >= 0) place.push_back(3 * i + static_cast<std::int64_t>(c));
  const std::vector<double>& sample = harmonics_.samples();
  response_.resize(static_cast<std::int64_t>(sample.size()), 9 * width * width);
  std::vector<SparseStatistics> found(sample.size());
  SparseOrder order;  // all harmonics have one pattern
  {
    const Stopwatch ordering(statistics_.seconds_order);
    order = order_unknowns(stiffness_.matrix(1), condensed);
  }
  parallel_for(static_cast<std::int64_t>(sample.size()), 1, threads, [&](std::int64_t s, int) {
    const auto factor = factor_of(sample[at(s)], condensed, order.unknown);
    found[at(s)] = factor->statistics();
    std::vector<double> b(at(n * n), 0.0);
    const double scale = std::max(sample[at(s)], sample[at(s)] > 0 ? 0 : 1.0) / reference_;
    for (std::int64_t k = 0; k < n; ++k) b[at(k * n + k)] = scale;
    factor->solve_condensed(b.data(), n);
    double* row = response_.row(s);
    for (std::int64_t k = 0; k < n; ++k)
      for (std::int64_t r = 0; r < n; ++r) row[place[at(r)] * 3 * width + place[at(k)]] = b[at(k * n + r)];
  });
  statistics_.factorizations += static_cast<std::int64_t>(sample.size());
  for (const SparseStatistics& s : found) {
    statistics_.nonzeros = std::max(statistics_.nonzeros, s.nonzeros);
    statistics_.condition = std::max(statistics_.condition, s.condition);
  }
  count_peak(response_.bytes() + found[0].peak_bytes * at(std::max(threads, 1)));
}

OwnLoads System::solve_own_load(const BodyMesh& loaded) const {
  OwnLoads own;
  if (!loaded.loaded()) return own;
  std::vector<double> load = stiffness_.loads(loaded), u = stiffness_.given(loaded);
  const std::vector<double> moved = stiffness_.forces(u);
  std::vector<double> b(at(stiffness_.unknowns()));
  const auto& of = stiffness_.numbers();
  for (std::size_t k = 0; k < u.size(); ++k)
    if (of[k] >= 0) b[at(of[k])] = load[k] - moved[k];
  factor_of(0, {}, {})->solve(b.data(), 1);
  require_no_overflow(b);
  for (std::size_t k = 0; k < u.size(); ++k)
    if (of[k] >= 0) u[k] = b[at(of[k])];
  const std::vector<double> force = stiffness_.forces(u);
  // What acts all round leaves a force along the axis and a moment about it; beside a line it is that of one period.
  for (std::size_t k = 0; k < u.size(); ++k) {
    if (of[k] >= 0) continue;
    const double part = 2 * SweptSection::pi * reference_ * (force[k] - load[k]);
    const Vec3& e = section_.axes_at_start()[k % 3];
    const Vec3& x = section_.plane().node[k / 3];
    const Vec3& a = section_.path().axis;
    const Vec3 lever = part * cross(x - section_.path().origin, e);
    if (!section_.revolved() || k % 3 == 2) own.reaction.force = own.reaction.force + part * e;
    own.reaction.moment = own.reaction.moment + (section_.revolved() ? dot(lever, a) * a : lever);
  }
  own.reaction.moment = own.reaction.moment + cross(section_.path().origin, own.reaction.force);
  for (std::int64_t k = 0; k < section_.surface_stations(); ++k) {
    const auto axes = section_.axes(static_cast<double>(section_.station(k)) * section_.step()).all();
    for (const std::int32_t node : section_.profile()) {
      Vec3 moves{0, 0, 0};
      for (std::size_t c = 0; c < 3; ++c) moves = moves + u[3 * at(node) + c] * axes[c];
      own.displacement.insert(own.displacement.end(), moves.begin(), moves.end());
    }
  }
  own.traction = std::move(u);
  return own;
}

OwnLoads System::solve_loads(const BodyMesh& loaded, int threads) {
  const std::lock_guard lock(mutex_);
  const BlasThreads blas(threads);
  return solve_own_load(loaded);
}

void System::respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) {
  const Stopwatch watch(statistics_.seconds_condense);
  const BlasThreads blas(threads);
  ++statistics_.condensations;
  const Acted acted = act(surface, rows);
  answer(acted.face, acted.node, acted.traction, rows);
}

System::Acted System::act(const LoadedSurface& surface, SurfaceOutline& outline) const {
  Acted acted;
  if (surface.of_faces()) {
    acted.face = surface.face;
    acted.node = outline.column;
    const auto n = static_cast<std::int64_t>(outline.column.size());
    acted.traction.resize(n, n);
    for (std::int64_t k = 0; k < n; ++k) acted.traction.row(k)[k] = 1;
    return acted;
  }
  const auto material = [this](std::int64_t face) {
    const Elastic& m = stiffness_.material(section_.element_under(face));
    return Elastic{m.young * reference_, m.poisson};
  };
  FeltTractions felt = feel({mesh_, fans_, material}, surface.layer, outline, true);
  acted = {outline.seen_face, felt.node, felt.traction};
  felt.tell(outline);
  return acted;
}

BodyStatistics System::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_with(response_.bytes());
}

std::uint64_t System::numbering() const {
  Checksum sum;
  sum.add(stiffness_.numbers().data(), stiffness_.numbers().size() * sizeof(std::int64_t));
  sum.add(section_.profile().data(), section_.profile().size() * sizeof(std::int32_t));
  sum.add(harmonics_.samples().data(), harmonics_.samples().size() * sizeof(double));
  return sum.value();
}

void System::write_factors(SectionWriter& file) const {
  OutArchive ar(file);
  ar(response_);
}

void System::read_factors(SectionReader& file) {
  InArchive ar(file);
  ar(response_);
  const auto width = static_cast<std::int64_t>(section_.profile().size());
  if (response_.rows() != std::ssize(harmonics_.samples()) || response_.columns() != 9 * width * width)
    file.fail_here("the harmonics do not fit the section");
}

void require_support() {}

std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans,
                                         const std::map<std::int32_t, Elastic>& material, const BodyOptions& options,
                                         int threads, SectionReader* saved) {
  return std::make_unique<System>(mesh, fans, material, options, threads, saved);
}

}  // namespace rollcon::section
