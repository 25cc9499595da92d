// Measures a wheel on its rail in a vehicle's time loop, S1002 on 60E1, and at the positions of the Manchester
// benchmark: time of a step (processor time of one thread), errors beside the finest lattice at the same
// positions, allocations.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bench.hpp"
#include "memory.hpp"
#include "wheels.hpp"

namespace rollcon::bench {
namespace {

constexpr double finest = 0.005;

struct Method {
  CreepForces by;
  double accuracy;
  const char* name;
};
constexpr Method methods[] = {{CreepForces::solved, 0.02, "strips, accuracy 0.02"},
                              {CreepForces::solved, 0.01, "strips, accuracy 0.01"},
                              {CreepForces::table, 0.02, "pressures of accuracy 0.02, table"},
                              {CreepForces::table_on_ellipses, 0.02, "ellipses of overlaps, table"}};

/// Describes the wheelset's lateral shift over a run.
struct Course {
  const char* name;
  double middle, swing;
};
constexpr Course courses[] = {{"tread, 1 to 4 mm", 2.5, 1.5}, {"one and two patches, 4.6 to 5.6 mm", 5.1, 0.5}};

double shift(const Course& course, std::int64_t i, std::int64_t period) {
  return course.middle +
         course.swing * std::sin(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(period));
}

/// Holds means and greatest of pairs of errors, force and moment.
struct Errors {
  std::array<double, 2> sum{}, worst{};
  double count = 0, above = 0;  ///< number of all, and of those with an error of more than a percent
  void add(const std::array<double, 2>& e) {
    for (std::size_t k = 0; k < 2; ++k) sum[k] += e[k], worst[k] = std::max(worst[k], e[k]);
    count += 1;
    above += std::max(e[0], e[1]) > 0.01 ? 1 : 0;
  }
  double mean(std::size_t k) const { return sum[k] / count; }
};

/// Holds what the finest strips find along a course.
struct Expected {
  const Course& course;
  std::vector<double> at, height;
  std::vector<Wheel::Result> result;
  explicit Expected(const Course& c) : course(c) {
    constexpr int checked = 40;
    Wheel fine(finest, true, CreepForces::solved);
    for (int k = 0; k <= checked; ++k) {
      at.push_back(c.middle + c.swing * (2.0 * k / checked - 1));
      fine.step(at.back(), 0);
      height.push_back(fine.stat("z"));
      result.push_back(fine.result());
    }
  }
  /// Returns the height that carries the load, between the positions that were solved.
  double z(double y) const {
    const double last = static_cast<double>(at.size() - 1), t = (y - at.front()) / (at.back() - at.front()) * last;
    const auto k = static_cast<std::size_t>(std::clamp(std::floor(t), 0.0, last - 1));
    return height[k] + (t - static_cast<double>(k)) * (height[k + 1] - height[k]);
  }
};

Record record_of(const Method& method, bool by_force, const char* model, const Errors& errors) {
  Record record{.case_name = "wheel_rail", .method = method.name, .model = model};
  record.mesh = by_force ? "vertical force" : "height";
  record.quantity = "mean error of the force over mu N";
  record.against = "strips, accuracy 0.005";
  record.error = errors.mean(0);
  record.moment_error = errors.mean(1);
  record.extra = {{"worst_error", errors.worst[0]},
                  {"worst_moment_error", errors.worst[1]},
                  {"cases", errors.count},
                  {"above_one_percent", errors.above}};
  return record;
}

/// Returns the errors under the load; at the heights that carry it the errors are the same.
Errors errors_of(const Method& method, const Expected& expected) {
  Errors errors;
  Wheel wheel(method.accuracy, true, method.by);
  for (std::size_t k = 0; k < expected.at.size(); ++k) {
    wheel.step(expected.at[k], 0);
    errors.add(Wheel::errors(wheel.result(), expected.result[k]));
  }
  return errors;
}

void run_course(Runner& runner, const Expected& expected, const Method& method, const Errors& errors, bool by_force) {
  const std::int64_t period = 1000, steps = runner.quick ? 1000 : 10000;
  const auto step = [&](Wheel& wheel, std::int64_t i) {
    const double y = shift(expected.course, i, period);
    return wheel.step(y, expected.z(y));
  };
  Wheel wheel(method.accuracy, by_force, method.by);
  const double cold_began = thread_seconds();
  step(wheel, 0);
  const double cold = thread_seconds() - cold_began;
  for (std::int64_t i = 0; i < period; ++i) step(wheel, i);
  std::vector<double> seconds;
  std::int64_t allocations = 0, worst = 0;
  double solves = wheel.stat("solves");
  for (std::int64_t i = 0; i < steps; ++i) {
    const std::int64_t before = heap_allocations();
    const double began = thread_seconds();
    worst = std::max<std::int64_t>(worst, step(wheel, i));
    seconds.push_back(thread_seconds() - began);
    allocations += heap_allocations() - before;
  }
  solves = (wheel.stat("solves") - solves) / static_cast<double>(steps);
  std::sort(seconds.begin(), seconds.end());
  double sum = 0;
  for (const double s : seconds) sum += s;
  Record record = record_of(method, by_force, expected.course.name, errors);
  record.status = static_cast<std::int32_t>(worst);
  record.seconds = sum / static_cast<double>(steps);
  record.extra.insert(record.extra.end(), {{"seconds_median", seconds[seconds.size() / 2]},
                                           {"seconds_99", seconds[seconds.size() * 99 / 100]},
                                           {"seconds_cold", cold},
                                           {"solves", solves},
                                           {"steps", static_cast<double>(steps)},
                                           {"allocations", static_cast<double>(allocations)}});
  runner.emit(record);
}

void run(Runner& runner) {
  for (const Course& course : courses) {
    const Expected expected(course);
    for (const Method& method : methods) {
      const Errors errors = errors_of(method, expected);
      for (const bool by_force : {false, true}) run_course(runner, expected, method, errors, by_force);
    }
  }
}

/// Holds rolls and rates of rotation at shifts of 0, 0.5 .. 10 mm, found as in examples/manchester.c.
struct Motion {
  double roll, rate;
};
constexpr Motion manchester[] = {{0, -4.3479979},         {-2.354e-5, -4.3473094}, {-5.052e-5, -4.3465799},
                                 {-8.112e-5, -4.3462486}, {-1.129e-4, -4.3459267}, {-1.459e-4, -4.3455688},
                                 {-1.805e-4, -4.3451561}, {-2.170e-4, -4.3446725}, {-2.560e-4, -4.3440936},
                                 {-2.981e-4, -4.3433645}, {-3.550e-4, -4.3344847}, {-4.776e-4, -4.3318879},
                                 {-6.273e-4, -4.3293523}, {-4.379e-3, -4.2748377}, {-6.393e-3, -4.2634903},
                                 {-7.642e-3, -4.2575031}, {-8.606e-3, -4.2533941}, {-9.407e-3, -4.2502672},
                                 {-1.010e-2, -4.2477074}, {-1.071e-2, -4.2455145}, {-1.126e-2, -4.2435887}};

/// Runs from no handle to the forces of 21 positions, one after the other.
void run_manchester(Runner& runner) {
  constexpr std::int32_t sides[] = {ROLLCON_RIGHT, ROLLCON_LEFT};
  const auto pass = [](Wheel& wheel, std::vector<Wheel::Result>& results) {
    double y = 0;
    for (const Motion& m : manchester) {
      wheel.step(y, 0, m.roll, m.rate);
      results.push_back(wheel.result());
      y += 0.5;
    }
  };
  std::vector<Wheel::Result> expected;
  for (const std::int32_t side : sides) {
    Wheel fine(finest, true, CreepForces::solved, side);
    pass(fine, expected);
  }
  for (const Method& method : methods) {
    Errors errors;
    std::vector<Wheel::Result> found;
    double best = 0;
    for (int k = 0; k < (runner.quick ? 1 : 5); ++k) {
      found.clear();
      const double began = thread_seconds();
      for (const std::int32_t side : sides) {
        Wheel wheel(method.accuracy, true, method.by, side);
        pass(wheel, found);
      }
      const double seconds = thread_seconds() - began;
      best = k == 0 ? seconds : std::min(best, seconds);
    }
    for (std::size_t i = 0; i < found.size(); ++i) errors.add(Wheel::errors(found[i], expected[i]));
    Record record = record_of(method, true, "Manchester A-2.2, 21 positions, both wheels", errors);
    record.case_name = "manchester";
    record.seconds = best;
    runner.emit(record);
  }
}

}  // namespace

std::vector<Case> wheel_rail_cases() {
  return {{"wheel_rail", "a wheel on its rail in a vehicle's time loop, from profiles to forces", run},
          {"manchester", "both wheels of a wheelset at 21 lateral shifts, from nothing", run_manchester}};
}

}  // namespace rollcon::bench
