// Cases (a) and (b): error of Fx and time per solve beside CONTACT's on grids of N x N, and on
// frames fitted to the contact.

#include "support/steady_rolling.hpp"

#include <cmath>

#include "bench.hpp"
#include "support/graded_disc.hpp"

namespace rollcon::bench {
namespace {

namespace steady_rolling = scenes::steady_rolling;
using scenes::RollingPair;

/// Cold, then warm after 1 % more creepage and back, as CONTACT's times are warm.
void roll(Runner& runner, const std::string& which, const SurfaceMesh& mesh,
          const std::string& name, const char* scheme, int n) {
  Record record{.case_name = "case_" + which, .method = scheme, .model = "half-spaces"};
  record.mesh = name;
  record.threads = runner.threads;
  record.quantity = "Fx/(mu Fn)";
  record.against = "CONTACT extrapolated";
  const double began = now();
  RollingPair pair(steady_rolling::steel, steady_rolling::steel, runner.threads);
  steady_rolling::prepare(pair, mesh, which);
  pair.option("convection", scheme);
  const auto s = timed_solve(pair, record, began);
  record.error = steady_rolling::force_error(s, which);
  record.value = (1 + record.error) * closed_forms::steady_rolling(which, "fx");

  const double spin = which == "b" ? steady_rolling::spin : 0;
  pair.creep(1.01 * steady_rolling::creepage, 0, spin);
  pair.solve();
  pair.creep(steady_rolling::creepage, 0, spin);
  const double warm = now();
  pair.solve();
  record.extra = {{"warm_seconds", now() - warm},
                  {"warm_iterations", pair.stat("iterations")},
                  {"fy", s.force[1] / (steady_rolling::mu * steady_rolling::hertz.load)},
                  {"mz", s.moment[2] / (steady_rolling::mu * steady_rolling::hertz.load *
                                        steady_rolling::radius)}};
  if (n > 0) {
    record.extra.emplace_back("n", n);
    record.extra.emplace_back("contact_error", steady_rolling::contact_error(which, n));
    record.extra.emplace_back("error_over_contact",
                              std::abs(record.error) / steady_rolling::contact_error(which, n));
    if (n == 16 || n == 32 || n == 64 || n == 128 || n == 256) {
      const double mark = closed_forms::steady_rolling(which, "seconds_" + std::to_string(n));
      record.extra.emplace_back("contact_seconds", mark);
      record.extra.emplace_back("warm_seconds_over_contact", record.extra.front().second / mark);
    }
  }
  runner.emit(record);
}

void run(Runner& runner, const std::string& which) {
  for (int n : {16, 24, 32, 48, 64, 96}) {
    if (runner.quick && n > 32) continue;
    for (const std::string scheme : {"least_squares", "characteristic"}) {
      if (n > 64 && scheme == "characteristic") continue;  // minutes, at dense operators
      roll(runner, which, steady_rolling::grid(n), "grid " + std::to_string(n), scheme.c_str(), n);
    }
  }
  for (int rings : {6, 8, 12, 16, 20}) {
    if (runner.quick && rings > 8) continue;
    roll(runner, which, scenes::graded_disc(steady_rolling::radius, steady_rolling::radius, rings),
         "rings " + std::to_string(rings), "characteristic", 0);
  }
}

}  // namespace

std::vector<Case> steady_rolling_cases() {
  return {{"case_a", "circle, longitudinal creepage: beside CONTACT",
           [](Runner& runner) { run(runner, "a"); }},
          {"case_b", "circle, creepage and spin: beside CONTACT",
           [](Runner& runner) { run(runner, "b"); }}};
}

}  // namespace rollcon::bench
