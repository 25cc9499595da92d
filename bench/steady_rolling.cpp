// Measures cases (a) and (b): errors of force vector and spin moment, and time per solve, beside CONTACT's on grids of
// N x N, and on frames fitted to the contact.

#include "support/steady_rolling.hpp"

#include <cmath>

#include "meshes.hpp"
#include "study.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::bench {
namespace {

namespace steady_rolling = scenes::steady_rolling;
using scenes::RollingPair;

/// Makes CONTACT's elements, or their corners for elements with midside nodes.
SurfaceMesh grid(ElementType type, int n) {
  if (type == ElementType::quad4) return steady_rolling::grid(n);
  const double half = steady_rolling::radius / 0.9;
  if (is_quadratic(type)) {
    const auto lines = frames::uniform_lines(-half, half, n / 2);
    return frames::rectangle(type, lines, lines);
  }
  const auto lines = frames::uniform_lines(-half * (1 - 1.0 / n), half * (1 - 1.0 / n), n - 1);
  return frames::rectangle(type, lines, lines);
}

void add_marks(Record& record, const std::string& which, int n) {
  record.extra.emplace_back("n", n);
  record.extra.emplace_back("contact_error", steady_rolling::contact_error(which, n));
  record.extra.emplace_back("error_over_contact", record.error / steady_rolling::contact_error(which, n));
  if (!closed_forms::steady_rolling_by_size(which, "error").contains(n))
    record.extra.emplace_back("contact_interpolated", 1);
  const auto timed = closed_forms::steady_rolling_by_size(which, "seconds");
  const auto mark = timed.find(n);
  if (mark == timed.end()) return;
  record.extra.emplace_back("contact_seconds", mark->second);
  record.extra.emplace_back("warm_seconds_over_contact", record.extra.front().second / mark->second);
}

/// Emits CONTACT's own runs where its time is known.
void emit_contact(Runner& runner, const std::string& which) {
  for (const auto& [n, seconds] : closed_forms::steady_rolling_by_size(which, "seconds")) {
    Record record{.case_name = "case_" + which + "_contact", .method = "CONTACT", .model = "half-spaces"};
    record.mesh = "grid " + std::to_string(n);
    record.quantity = "error of the force vector";
    record.against = "its own limit";
    record.value = record.error = steady_rolling::contact_error(which, n);
    record.seconds = seconds;
    record.extra = {{"n", n}};
    runner.write(record);
  }
}

/// Solves cold, then warm after 1 % more creepage and back, like CONTACT's warm times.
void roll(Runner& runner, const std::string& which, const FrameKind& kind, int n) {
  // A ring's nodes lie within the contact, nine tenths of a grid's.
  const SurfaceMesh mesh =
      kind.rings ? frame_over(kind, n, steady_rolling::radius, steady_rolling::radius, 0) : grid(kind.type, n);
  Record blank{.case_name = "case_" + which, .model = "half-spaces"};
  blank.mesh = (kind.rings ? "rings " + std::to_string(n / 2) : "grid " + std::to_string(n));
  blank.element = kind.name;
  blank.threads = runner.threads;
  blank.quantity = "tangential force over mu Fn";
  blank.against = "CONTACT extrapolated";
  const auto limit = steady_rolling::limit(which).force;
  // The uncertainty is that of the data.
  const double uncertain = which == "a" ? 0.0004 : std::hypot(0.0001, 0.0002);
  const double spin = which == "b" ? steady_rolling::spin : 0;
  for (const char* scheme : scenes::schemes) {
    Record record = blank;
    record.method = scheme;
    const Solved solved = cold_solve(runner, record, [&] {
      auto pair = std::make_unique<RollingPair>(steady_rolling::steel, steady_rolling::steel, runner.threads);
      steady_rolling::prepare(*pair, mesh, which);
      pair->option("convection", scheme);
      return pair;
    });
    const scenes::RollingAnswer found = steady_rolling::found(solved.solution);
    record.judge(steady_rolling::errors(solved.solution, which));
    record.value = found.force[0];
    RollingPair& pair = *solved.pair;
    record.extra = {{"warm_seconds", warm_solve(runner, pair, {steady_rolling::creepage, 0, spin})},
                    {"warm_iterations", pair.stat("iterations")},
                    {"lateral", found.force[1]},
                    {"moment", found.moment}};
    if (!kind.rings) add_marks(record, which, n);
    record.extra.emplace_back("uncertainty_moment", which == "a" ? 0 : 0.0002);
    add_size(record, kind.rings ? n : 0.9 * n, uncertain / std::hypot(limit[0], limit[1]));
    runner.emit(record);
  }
}

void run(Runner& runner, const std::string& which) {
  for (const FrameKind& kind : frame_kinds) {
    const std::vector<int> sizes = kind.rings ? std::vector{12, 16, 24, 32, 40} : std::vector{12, 16, 24, 32, 48, 64};
    for (const int n : sizes) {
      if (runner.quick && n > 24) continue;
      if (n > 48 && kind.type != ElementType::quad4) continue;
      roll(runner, which, kind, n);
    }
  }
  emit_contact(runner, which);
}

}  // namespace

std::vector<Case> steady_rolling_cases() {
  return {{"case_a", "circle, longitudinal creepage: beside CONTACT", [](Runner& runner) { run(runner, "a"); }},
          {"case_b", "circle, creepage and spin: beside CONTACT", [](Runner& runner) { run(runner, "b"); }}};
}

}  // namespace rollcon::bench
