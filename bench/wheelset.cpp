// Measures a wheelset in SUNDIALS's integrator CVODE (examples/wheelset_motion.h), let go 3 mm from the middle of the
// track: its path beside that of the finest accuracy, steps, solves and processor time, and its hunting eigenvalue
// about the middle.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "../examples/wheelset_motion.h"
#include "bench.hpp"
#include "wheels.hpp"

extern "C" void dgeev_(const char*, const char*, const int*, double*, const int*, double*, double*, double*, const int*,
                       double*, const int*, double*, const int*, int*);

namespace rollcon::bench {
namespace {

constexpr double forward = 30000, interval = 1e-3;
constexpr int points = 500;
using Path = std::array<double, points>;

struct Mode {
  const char* name;
  double accuracy;
  int by;
};
constexpr Mode modes[] = {{"ellipses, table", 0.02, 2},
                          {"pressures at 0.02, table", 0.02, 1},
                          {"accuracy 0.02", 0.02, 0},
                          {"accuracy 0.01", 0.01, 0},
                          {"accuracy 0.005", 0.005, 0}};

struct Wheelset : wheelset {
  explicit Wheelset(const Mode& mode) { wheelset_make(this, mode.accuracy, forward, mode.by); }
  ~Wheelset() { wheelset_release(this); }
  Wheelset(const Wheelset&) = delete;
  Wheelset& operator=(const Wheelset&) = delete;
};

long run_path(Wheelset& set, double tolerance, bool own, Path& path) {
  double q[states] = {3};
  wheelset_settle(&set, q);
  set.solves = set.told[0] = set.told[1] = 0;
  return wheelset_run(&set, q, tolerance, own, interval, points, path.data());
}

/// Returns the eigenvalue of least damping that oscillates as hunting does. Derivatives are the library's, or those by
/// shift and yaw are differences over a shift, and a yaw of a thousandth of it, in rad and mm.
std::complex<double> hunting(const Mode& mode, double over) {
  Wheelset set(mode);
  double q[states] = {}, column[states * states], rate[2][states];
  wheelset_settle(&set, q);
  must(wheelset_jacobian(&set, q, column));
  for (const int by : {int{shift_y}, int{yaw}}) {
    if (over == 0) break;
    const double step = by == yaw ? 1e-3 * over : over;
    for (int side = 0; side < 2; ++side) {
      double near[states];
      std::copy(q, q + states, near);
      near[by] += (side - 0.5) * step;
      must(wheelset_solve(&set, near));
      wheelset_rate(&set, near, rate[side]);
    }
    for (int i = 0; i < states; ++i) column[by * states + i] = (rate[1][i] - rate[0][i]) / step;
  }
  const int n = states, room = 8 * states;
  double real[states], imaginary[states], work[8 * states];
  int info = 0;
  dgeev_("N", "N", &n, column, &n, real, imaginary, nullptr, &n, nullptr, &n, work, &room, &info);
  std::complex<double> found{-1e9, 0};
  for (int i = 0; i < n; ++i)
    if (imaginary[i] > 1 && imaginary[i] < 100 && real[i] > found.real()) found = {real[i], imaginary[i]};
  return found;
}

void run(Runner& runner) {
  Path finest;
  {
    Wheelset set(modes[std::size(modes) - 1]);
    if (run_path(set, runner.quick ? 1e-5 : 1e-7, true, finest) < 0) throw std::runtime_error("CVODE gave up");
  }
  for (const Mode& mode : modes) {
    const std::array values{hunting(mode, 0), hunting(mode, 0.5), hunting(mode, 0.1)};
    for (const double tolerance : {1e-4, 1e-6})
      for (const bool own : {true, false}) {
        if (runner.quick && (tolerance < 1e-5 || !own)) continue;
        Wheelset set(mode);
        Path path{};
        const double began = thread_seconds();
        const long steps = run_path(set, tolerance, own, path);
        const double seconds = thread_seconds() - began;
        double square = 0;
        for (int i = 0; i < points; ++i) square += (path[i] - finest[i]) * (path[i] - finest[i]) / points;
        char text[40];
        std::snprintf(text, sizeof text, "tolerance %g", tolerance);
        Record record{.case_name = "wheelset", .method = mode.name, .model = own ? "own" : "differences", .mesh = text};
        record.quantity = "rms of the path beside the finest accuracy, mm";
        record.against = "accuracy 0.005, tolerance 1e-7";
        record.error = std::sqrt(square);
        record.status = steps < 0 ? -1 : 0;
        record.seconds = seconds;
        record.extra = {{"steps", static_cast<double>(steps)},
                        {"solves", static_cast<double>(set.solves)},
                        {"with_a_warning", static_cast<double>(set.told[0])},
                        {"without_an_answer", static_cast<double>(set.told[1])},
                        {"growth", values[0].real()},
                        {"frequency", values[0].imag()},
                        {"growth_over_half", values[1].real()},
                        {"frequency_over_half", values[1].imag()},
                        {"growth_over_tenth", values[2].real()},
                        {"frequency_over_tenth", values[2].imag()}};
        runner.emit(record);
      }
  }
}

}  // namespace

std::vector<Case> wheelset_cases() {
  return {{"wheelset", "a wheelset in an integrator: path, steps and time of every mode", run}};
}

}  // namespace rollcon::bench
