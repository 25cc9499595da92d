// Measures Kalker's coefficients and the creep-force curve over element size, kind of frame and scheme.

#include <algorithm>
#include <array>
#include <cmath>

#include "meshes.hpp"
#include "study.hpp"
#include "support/carter_strip.hpp"
#include "support/linear_theory.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Hertz;
using scenes::RollingPair;

constexpr double reach = 1.15;

std::vector<int> sizes(const FrameKind& kind, bool quick) {
  if (quick) return {12, 16};
  return kind.rings ? std::vector{12, 16, 20, 24, 32} : std::vector{10, 16, 20, 24, 32};
}

/// Says whether a curve counts: on rings graded to the contact's edge the characteristic scheme comes nearest to what
/// is known (cases a and b).
bool trusted(const FrameKind& kind, const std::string& scheme) {
  return kind.rings && scheme == "characteristic";
}

std::string mesh_name(const FrameKind& kind, int across) {
  return std::string(kind.name) + ", " + std::to_string(across) + " nodes across";
}

/// Applies linear theory on a circle at nu = 1/4: its three motions on one frame, the worst of their errors.
void coefficients(Runner& runner) {
  namespace linear = scenes::linear_theory;
  using Answers = std::array<scenes::RollingAnswer, 3>;
  const closed_forms::Elastic body{.shear = 82000, .poisson = 0.25};
  const Hertz hertz = linear::ellipse(1, body);
  const linear::Coefficients table = linear::table(1, body.poisson);
  const linear::Motions motions(table, hertz, body, 0.0006);
  Study study;
  std::vector<Answers> answers;
  for (const FrameKind& kind : frame_kinds)
    for (const int across : sizes(kind, runner.quick))
      for (const char* scheme : scenes::schemes) {
        const SurfaceMesh mesh = frame_over(kind, across, 1, 1, reach);
        Record record{.case_name = "kalker_meshes", .method = scheme, .model = "half-spaces"};
        record.element = kind.name;
        record.mesh = mesh_name(kind, across);
        record.threads = runner.threads;
        record.quantity = "forces of vanishing creepages and spin";
        const Solved solved = cold_solve(runner, record, [&] {
          auto pair = std::make_unique<RollingPair>(body, body, runner.threads);
          pair->frame(mesh).gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(linear::mu);
          pair->option("convection", scheme).creep(motions.all[0].creep[0], 0, 0);
          return pair;
        });
        Answers found{motions.found(solved.solution)};
        const double began = now();
        for (const std::size_t k : {1, 2}) {
          const auto& creep = motions.all[k].creep;
          solved.pair->creep(creep[0], creep[1], creep[2]).solve();
          found[k] = motions.found(solved.pair->solution());
        }
        record.seconds += now() - began;
        const linear::Coefficients c = motions.coefficients(found);
        record.value = c.c11;
        record.extra = {{"C11", c.c11}, {"C22", c.c22}, {"C23", c.c23}, {"C32", c.c32}, {"C33", c.c33}};
        study.add(record, across, trusted(kind, scheme));
        answers.push_back(found);
      }
  const Limit limit[] = {study.limit("C11"), study.limit("C22"), study.limit("C23"), study.limit("C32"),
                         study.limit("C33")};
  const linear::Coefficients exact{limit[0].value, limit[1].value, limit[2].value, limit[3].value, limit[4].value};
  // The uncertainty is that of the extrapolation, or the distance from Kalker's table.
  const double listed[] = {table.c11, table.c22, table.c23, table.c32, table.c33};
  const auto uncertain = [&](std::size_t k) {
    return std::max(limit[k].uncertainty, std::abs(limit[k].value - listed[k]));
  };
  const double uncertainty = std::max({uncertain(0) / table.c11, uncertain(1) / table.c22, uncertain(2) / table.c23});
  const double moment_uncertainty = std::max(uncertain(3) / table.c22, uncertain(4) / std::max(table.c23, table.c33));
  const auto judge = [&](Record& record, std::size_t number) {
    scenes::RollingErrors errors;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto one = scenes::rolling_errors(answers[number][k], motions.exact(motions.all[k], exact));
      record.extra.emplace_back("error_" + std::to_string(k + 1), one.force);
      record.extra.emplace_back("moment_error_" + std::to_string(k + 1), one.moment);
      errors = scenes::worst(errors, one);
    }
    record.judge(errors);
    record.extra.emplace_back("uncertainty_moment", moment_uncertainty);
  };
  study.emit(runner, judge, uncertainty, "own extrapolation of graded rings, characteristic; zeros by symmetry");
}

/// Solves eleven creepages, and takes the worst of their errors against the curve's own limit.
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
    std::vector<scenes::RollingAnswer> found;
  };
  std::vector<Entry> entries;
  for (const FrameKind& kind : frame_kinds)
    for (const int across : sizes(kind, runner.quick))
      for (const char* scheme : scenes::schemes) {
        const SurfaceMesh mesh = frame_over(kind, across, hertz.a, hertz.b, reach);
        Entry entry{{.case_name = "creep_curve_meshes", .method = scheme, .model = "half-spaces"},
                    across,
                    trusted(kind, scheme),
                    {}};
        entry.record.element = kind.name;
        entry.record.mesh = mesh_name(kind, across);
        entry.record.threads = runner.threads;
        entry.record.quantity = "tangential force over mu P, the worst of eleven creepages";
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
          entry.found.push_back(scenes::found_forces(s, friction * hertz.load, std::sqrt(hertz.a * hertz.b)));
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
  std::vector<RollingLimit> limits;
  double uncertainty = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    Study study;  // study of one creepage
    for (const Entry& e : entries) study.add(e.record, e.found[p], e.across, e.trusted);
    limits.push_back(symmetric_limit(study.limit()));
    uncertainty = std::max(uncertainty, limits.back().uncertainty);
  }
  for (Entry& e : entries) {
    scenes::RollingErrors errors, contact;
    for (std::size_t p = 0; p < points.size(); ++p) {
      errors = scenes::worst(errors, scenes::rolling_errors(e.found[p], limits[p].answer));
      contact = scenes::worst(contact, scenes::rolling_errors({{points[p].force_ratio, 0}, 0}, limits[p].answer));
    }
    e.record.judge(errors);
    e.record.value = e.record.error;
    e.record.against = "own extrapolation of graded rings, characteristic; zeros by symmetry";
    e.record.extra = {{"contact_44_48", contact.force}, {"uncertainty_moment", 0}};
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
