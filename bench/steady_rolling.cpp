// Cases (a) and (b): error of Fx and time per solve beside CONTACT's on grids of N x N, and on frames fitted to the
// contact.

#include "support/steady_rolling.hpp"

#include <cmath>

#include "meshes.hpp"
#include "study.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::bench {
namespace {

namespace steady_rolling = scenes::steady_rolling;
using scenes::RollingPair;

/// CONTACT's elements, or their corners for elements with midside nodes.
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
  record.extra.emplace_back("error_over_contact", std::abs(record.error) / steady_rolling::contact_error(which, n));
  if (n == 16 || n == 32 || n == 64 || n == 128 || n == 256) {
    const double mark = closed_forms::steady_rolling(which, "seconds_" + std::to_string(n));
    record.extra.emplace_back("contact_seconds", mark);
    record.extra.emplace_back("warm_seconds_over_contact", record.extra.front().second / mark);
  }
}

/// Cold, then warm after 1 % more creepage and back, as CONTACT's times are warm.
void roll(Runner& runner, const std::string& which, const FrameKind& kind, int n) {
  // A ring's nodes lie within the contact, nine tenths of a grid's.
  const SurfaceMesh mesh =
      kind.rings ? frame_over(kind, n, steady_rolling::radius, steady_rolling::radius, 0) : grid(kind.type, n);
  Record blank{.case_name = "case_" + which, .model = "half-spaces"};
  blank.mesh = (kind.rings ? "rings " + std::to_string(n / 2) : "grid " + std::to_string(n));
  blank.element = kind.name;
  blank.threads = runner.threads;
  blank.quantity = "Fx/(mu Fn)";
  blank.against = "CONTACT extrapolated";
  const double limit = closed_forms::steady_rolling(which, "fx");
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
    const scenes::Solution& s = solved.solution;
    record.error = steady_rolling::force_error(s, which);
    record.value = (1 + record.error) * limit;
    RollingPair& pair = *solved.pair;
    record.extra = {{"warm_seconds", warm_solve(runner, pair, {steady_rolling::creepage, 0, spin})},
                    {"warm_iterations", pair.stat("iterations")},
                    {"fy", s.force[1] / (steady_rolling::mu * steady_rolling::hertz.load)},
                    {"mz", s.moment[2] / (steady_rolling::mu * steady_rolling::hertz.load * steady_rolling::radius)}};
    if (!kind.rings) add_marks(record, which, n);
    add_size(record, kind.rings ? n : 0.9 * n, (which == "a" ? 0.0004 : 0.0001) / limit);
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
}

}  // namespace

std::vector<Case> steady_rolling_cases() {
  return {{"case_a", "circle, longitudinal creepage: beside CONTACT", [](Runner& runner) { run(runner, "a"); }},
          {"case_b", "circle, creepage and spin: beside CONTACT", [](Runner& runner) { run(runner, "b"); }}};
}

}  // namespace rollcon::bench
