// Kalker's coefficients and the creep-force curve over element size, kind of frame and scheme.

#include <algorithm>
#include <array>
#include <cmath>

#include "meshes.hpp"
#include "study.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Hertz;
using scenes::RollingPair;

constexpr double mu = 0.3, reach = 1.15;

std::vector<int> sizes(const FrameKind& kind, bool quick) {
  if (quick) return {12, 16};
  return kind.rings ? std::vector{12, 16, 20, 24, 32} : std::vector{10, 16, 20, 24, 32};
}

/// On rings graded to the contact's edge the characteristic scheme comes nearest to what is known (cases a and b).
bool trusted(const FrameKind& kind, const std::string& scheme) {
  return kind.rings && scheme == "characteristic";
}

std::string mesh_name(const FrameKind& kind, int across) {
  return std::string(kind.name) + ", " + std::to_string(across) + " nodes across";
}

/// All four coefficients of a circle at nu = 1/4: three solves on one frame; worst error.
void coefficients(Runner& runner) {
  const closed_forms::Elastic body{.shear = 82000, .poisson = 0.25};
  const Hertz hertz = closed_forms::hertz_from_axes(1, 1, 1000, closed_forms::effective_modulus(body, body));
  const auto table = closed_forms::kalker_table(1, body.poisson);
  const double unit = 0.0006 * mu * hertz.load / body.shear;  // 0.06 % of mu P without slip
  constexpr const char* name[] = {"C11", "C22", "C23", "C33"};
  const std::array<double, 4> listed{table.c11, table.c22, table.c23, table.c33};
  Study study;
  for (const FrameKind& kind : frame_kinds)
    for (const int across : sizes(kind, runner.quick))
      for (const char* scheme : scenes::schemes) {
        const SurfaceMesh mesh = frame_over(kind, across, 1, 1, reach);
        Record record{.case_name = "kalker_meshes", .method = scheme, .model = "half-spaces"};
        record.element = kind.name;
        record.mesh = mesh_name(kind, across);
        record.threads = runner.threads;
        record.quantity = "C11";
        const Solved solved = cold_solve(runner, record, [&] {
          auto pair = std::make_unique<RollingPair>(body, body, runner.threads);
          pair->frame(mesh).gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(mu);
          pair->option("convection", scheme).creep(unit / table.c11, 0, 0);
          return pair;
        });
        std::array<double, 4> found{-solved.solution.force[0] / unit * table.c11 / body.shear, 0, 0, 0};
        const double began = now();
        const auto next = [&](double eta, double phi) {
          solved.pair->creep(0, eta, phi).solve();
          return solved.pair->solution();
        };
        found[1] = -next(unit / table.c22, 0).force[1] / unit * table.c22 / body.shear;
        const double phi = unit / std::max(table.c23, table.c33);
        const scenes::Solution s = next(0, phi);
        found[2] = -s.force[1] / (body.shear * phi);
        found[3] = -s.moment[2] / (body.shear * phi);
        record.seconds += now() - began;
        record.value = found[0];
        for (std::size_t k = 0; k < 4; ++k) {
          record.extra.emplace_back(name[k], found[k]);
          record.extra.emplace_back(std::string("table_") + name[k], found[k] / listed[k] - 1);
        }
        study.add(record, across, trusted(kind, scheme));
      }
  for (const char* k : name) study.compare(k, study.limit(k));
  study.emit(runner, study.limit(), "own extrapolation of graded rings, characteristic");
}

/// Largest deviation of F/(mu P) over eleven creepages from the curve's own limit.
void curve(Runner& runner) {
  const closed_forms::Elastic steel{.shear = 82000, .poisson = 0.28};
  constexpr double friction = 0.33;
  const Hertz hertz =
      closed_forms::hertz_from_load(.0008, .0002814173138, closed_forms::effective_modulus(steel, steel), 106700);
  const auto points = closed_forms::creep_curve();
  struct Entry {
    Record record;
    int across;
    bool trusted;
    std::vector<double> ratio;
  };
  std::vector<Entry> entries;
  for (const FrameKind& kind : frame_kinds)
    for (const int across : sizes(kind, runner.quick))
      for (const char* scheme : scenes::schemes) {
        const SurfaceMesh mesh = frame_over(kind, across, hertz.a, hertz.b, reach);
        Entry entry{
            {.case_name = "creep_curve_meshes", .method = scheme, .model = "half-spaces"}, across, kind.rings, {}};
        entry.record.element = kind.name;
        entry.record.mesh = mesh_name(kind, across);
        entry.record.threads = runner.threads;
        entry.record.quantity = "F/(mu P) of eleven creepages, largest deviation in mu P";
        double began = now(), spent = 0;
        RollingPair pair(steel, steel, runner.threads);
        pair.frame(mesh).gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(friction);
        pair.option("convection", scheme);
        std::int64_t iterations = 0;
        for (const auto& point : points) {
          pair.creep(-point.xi, 0, 0);
          Record one;
          const auto s = timed_solve(pair, one, began);
          spent += one.seconds, iterations += one.iterations;
          began = now();
          entry.ratio.push_back(s.force[0] / (friction * hertz.load));
          entry.record.nodes = one.nodes, entry.record.elements = one.elements;
          entry.record.pairs = one.pairs, entry.record.unknowns = one.unknowns;
          entry.record.status = std::max(entry.record.status, one.status);
          entry.record.peak_bytes = one.peak_bytes;
          entry.record.resident_bytes = std::max(entry.record.resident_bytes, one.resident_bytes);
        }
        entry.record.seconds = spent;
        entry.record.iterations = iterations;
        entry.record.phase_seconds = {{"compliance", pair.stat("seconds_compliance")}};
        entries.push_back(std::move(entry));
      }
  std::vector<Limit> limits;
  double uncertainty = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    Study study;  // of one creepage
    for (const Entry& e : entries) {
      Record record = e.record;
      record.value = e.ratio[p];
      study.add(std::move(record), e.across, e.trusted);
    }
    limits.push_back(study.limit());
    uncertainty = std::max(uncertainty, limits.back().uncertainty);
  }
  for (Entry& e : entries) {
    double contact = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      e.record.error = std::max(e.record.error, std::abs(e.ratio[p] - limits[p].value));
      contact = std::max(contact, std::abs(points[p].force_ratio - limits[p].value));
    }
    e.record.value = e.record.error;
    e.record.against = "own extrapolation of graded rings, characteristic";
    e.record.extra = {{"contact_44_48", contact}};
    add_size(e.record, e.across, uncertainty);
    runner.emit(e.record);
  }
}

}  // namespace

std::vector<Case> kalker_mesh_cases() {
  return {{"kalker_meshes", "creepage coefficients of a circle: elements, sizes, schemes", coefficients},
          {"creep_curve_meshes", "creep-force curve: elements, sizes, schemes", curve}};
}

}  // namespace rollcon::bench
