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

/// Returns constants of the elements, relaxed; alone not null: at once, of those alone that relax so.
std::vector<Elastic> by_element(const BodyMesh& mesh, const Materials& material, double reference,
                                const Relaxation* alone = nullptr) {
  std::vector<Elastic> result;
  for (const std::int32_t tag : mesh.section.plane().tag) {
    const auto found = material.relaxation.find(tag);
    const bool relaxes = found != material.relaxation.end();
    double part = relaxes ? found->second.modulus(0).real() : 1;
    if (alone) part = relaxes && found->second == *alone ? 1 : 0;
    const Elastic& m = material.elastic.at(tag);
    result.push_back({part * m.young / reference, m.poisson});
  }
  return result;
}

}  // namespace

System::System(const BodyMesh& mesh, const TractionNodes& fans, const Materials& material, const BodyOptions& options,
               int threads, SectionReader* saved)
    : ResponseCache(mesh.surface, options.cache_bytes),
      mesh_(mesh),
      section_(mesh.section),
      fans_(fans),
      reference_(largest_modulus(material.elastic)),
      stiffness_(mesh, by_element(mesh, material, reference_), reference_),
      harmonics_(section_.stations()) {
  statistics_.unknowns = stiffness_.unknowns();
  statistics_.condensed = static_cast<std::int64_t>(profile_unknowns().size());
  for (const auto& of_tag : material.relaxation) {
    const auto& relaxation = of_tag.second;
    const bool known =
        std::any_of(creeping_.begin(), creeping_.end(), [&](const Creeping& c) { return c.relaxation == relaxation; });
    // Springs over an infinite reference are none.
    if (!known)
      creeping_.push_back(
          {relaxation, HarmonicStiffness(mesh, by_element(mesh, material, reference_, &relaxation), HUGE_VAL)});
  }
  if (saved) {
    restore(*saved, 3 * at(surface_.nodes()), stiffness_.numbers().size());
    return;
  }
  ++statistics_.assemblies;
  if (creeping_.empty()) response(0, threads);
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
    refuse_singular(n, pivot.unknown());
  }
}

void System::refuse_singular(double n, std::int64_t unknown) const {
  const auto& of = stiffness_.numbers();
  const auto place = std::find(of.begin(), of.end(), unknown) - of.begin();
  constexpr const char* component[] = {"across the way", "along the way", "along the section's second axis"};
  fail(Status::err_singular,
       "the stiffness of harmonic n = %.4g of the section is singular at node %lld (counting from %d), %s: check its "
       "supports, its mesh and the ratio of its moduli",
       n, static_cast<long long>(place / 3) + surface_.index_base, surface_.index_base, component[place % 3]);
}

const Response& System::response(double rate, int threads) {
  constexpr std::size_t most = 4;
  if (creeping_.empty()) rate = 0;
  const auto found =
      std::find_if(response_.begin(), response_.end(), [&](const Response& r) { return r.rate == rate; });
  if (found != response_.end()) {
    response_.splice(response_.begin(), response_, found);
    return response_.front();
  }
  Response made{rate, {}, {}};
  const Stopwatch watch(statistics_.seconds_factor);
  const BlasThreads blas(1);
  creeping_.empty() ? solve_harmonics(made, threads) : solve_creeping(made, threads);
  statistics_.factorizations += made.part.rows();
  response_.push_front(std::move(made));
  if (response_.size() > most) response_.pop_back();
  return response_.front();
}

const System::Condensation& System::condensation() const {
  std::call_once(condensed_once_, [&] {
    const std::vector<std::int64_t> condensed = profile_unknowns();
    const SparseMatrix pattern = stiffness_.matrix(1);
    const SparseOrder order = order_unknowns(pattern, condensed);
    std::vector<std::int64_t> place(order.unknown.size(), -1), row;
    for (std::int64_t i = 0; i < std::ssize(section_.profile()); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        if (const std::int64_t u = stiffness_.unknown(section_.profile()[at(i)], c); u >= 0)
          place[at(u)] = 3 * i + static_cast<std::int64_t>(c);
    for (std::size_t k = order.unknown.size() - condensed.size(); k < order.unknown.size(); ++k)
      row.push_back(place[at(order.unknown[k])]);
    condensation_.emplace(Condensation{{pattern, order.unknown, std::ssize(condensed)}, std::move(row)});
  });
  return *condensation_;
}

std::vector<std::complex<double>> System::creeping_stiffness(double n, double rate) const {
  const std::vector<double> relaxed = stiffness_.matrix(n).value;
  std::vector<std::complex<double>> value(relaxed.begin(), relaxed.end());
  for (const Creeping& c : creeping_) {
    const std::complex<double> more = c.relaxation.modulus(n * rate) - c.relaxation.modulus(0).real();
    const std::vector<double> own = c.stiffness.matrix(n).value;
    for (std::size_t k = 0; k < own.size(); ++k) value[k] += more * own[k];
  }
  return value;
}

void System::solve_creeping(Response& response, int threads) {
  const auto width = static_cast<std::int64_t>(section_.profile().size());
  const std::vector<double>& sample = harmonics_.samples();
  const Condensation& condensed = condensation();
  const std::vector<std::int64_t>& row = condensed.row;
  for (RowMatrix<double>* part : {&response.part, &response.lags}) part->resize(std::ssize(sample), 9 * width * width);
  parallel_for(std::ssize(sample), 1, threads, [&](std::int64_t s, int) {
    const double n = sample[at(s)], scale = (n > 0 ? n : 1) / reference_;
    std::vector<std::complex<double>> found;
    try {
      found = condensed.of.inverse(creeping_stiffness(n, response.rate), scale);
    } catch (const ZeroPivot& pivot) {
      refuse_singular(n, pivot.unknown());
    }
    for (std::size_t k = 0; k < row.size(); ++k)
      for (std::size_t r = 0; r < row.size(); ++r) {
        const std::complex<double> u = found[k * row.size() + r];
        response.part.row(s)[row[r] * 3 * width + row[k]] = u.real();
        response.lags.row(s)[row[r] * 3 * width + row[k]] = u.imag();
      }
  });
  statistics_.nonzeros = condensed.of.nonzeros();
  count_peak(response.part.bytes() * 2);
}

void System::solve_harmonics(Response& response, int threads) {
  const std::vector<std::int64_t> condensed = profile_unknowns();
  const auto width = static_cast<std::int64_t>(section_.profile().size()),
             n = static_cast<std::int64_t>(condensed.size());
  std::vector<std::int64_t> place;  // place of each condensed unknown among 3 * profile node + c
  for (std::int64_t i = 0; i < width; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      if (stiffness_.unknown(section_.profile()[at(i)], c) >= 0) place.push_back(3 * i + static_cast<std::int64_t>(c));
  const std::vector<double>& sample = harmonics_.samples();
  response.part.resize(static_cast<std::int64_t>(sample.size()), 9 * width * width);
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
    double* row = response.part.row(s);
    for (std::int64_t k = 0; k < n; ++k)
      for (std::int64_t r = 0; r < n; ++r) row[place[at(r)] * 3 * width + place[at(k)]] = b[at(k * n + r)];
  });
  for (const SparseStatistics& s : found) {
    statistics_.nonzeros = std::max(statistics_.nonzeros, s.nonzeros);
    statistics_.condition = std::max(statistics_.condition, s.condition);
  }
  count_peak(response.part.bytes() + found[0].peak_bytes * at(std::max(threads, 1)));
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
  Response wanted = response(surface.rate, threads);
  // Rows hold n times the response of a sample n.
  for (std::int64_t s = 0; surface.slope != 0 && !wanted.lags.empty() && s < wanted.part.rows(); ++s) {
    const double by_angle = -surface.slope * harmonics_.samples()[at(s)];
    for (std::int64_t k = 0; k < wanted.part.columns(); ++k) wanted.part.row(s)[k] = by_angle * wanted.lags.row(s)[k];
  }
  if (surface.slope != 0) wanted.lags.release();
  answer(wanted, acted.face, acted.node, acted.traction, rows);
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
  // What faces do not feel has waves of about two of them: bodies that creep answer with their stiffness to these.
  const double wave = SweptSection::pi / (section_.step() * (section_.quadratic() ? 2 : 1)) * std::abs(surface.rate);
  const auto material = [&](std::int64_t face) {
    const std::int64_t e = section_.element_under(face);
    Elastic m = this->material(e);
    for (const Creeping& c : creeping_)
      if (c.stiffness.material(e).young > 0)
        m.young = c.stiffness.material(e).young * reference_ * std::abs(c.relaxation.modulus(wave));
    return m;
  };
  FeltTractions felt = feel({mesh_, fans_, material}, surface.layer, outline, true);
  acted = {outline.seen_face, felt.node, felt.traction};
  felt.tell(outline);
  return acted;
}

BodyStatistics System::statistics() const {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = 0;
  for (const Response& r : response_) bytes += r.part.bytes() + r.lags.bytes();
  return statistics_with(bytes);
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
  ar(response_.front().part);
}

void System::read_factors(SectionReader& file) {
  InArchive ar(file);
  RowMatrix<double>& read = response_.emplace_back().part;
  ar(read);
  const auto width = static_cast<std::int64_t>(section_.profile().size());
  if (read.rows() != std::ssize(harmonics_.samples()) || read.columns() != 9 * width * width)
    file.fail_here("the harmonics do not fit the section");
}

void require_support() {}

std::unique_ptr<Condensed> make_response(const BodyMesh& mesh, const TractionNodes& fans, const Materials& material,
                                         const BodyOptions& options, int threads, SectionReader* saved) {
  return std::make_unique<System>(mesh, fans, material, options, threads, saved);
}

}  // namespace rollcon::section
