// A wheel on its rail in a vehicle's time loop: S1002 on 60E1, the wheelset hunting. Time of a step (processor time of
// one thread), errors beside the finest lattice at the same positions, allocations.

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench.hpp"
#include "memory.hpp"
#include "rollcon.h"

namespace rollcon::bench {
namespace {

constexpr double mu = 0.3, load = 10000, shear = 82000, poisson = 0.28;

void must(std::int32_t status) {
  if (status < 0) throw std::runtime_error(rollcon_last_error());
}

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

class Wheel {
 public:
  Wheel(double accuracy, bool by_force) {
    must(rollcon_context_create(ROLLCON_ABI, &context_));
    must(rollcon_context_set_threads(context_, 1));
    const double unit = 1;
    const char* shape[] = {"s1002", "60e1"};
    for (std::size_t b = 0; b < 2; ++b) {
      must(rollcon_body_create(context_, ROLLCON_BODY_HALFSPACE, &body_[b]));
      must(rollcon_body_set_elastic(body_[b], 0, 2 * shear * (1 + poisson), poisson));
      must(rollcon_body_set_profile_shape(body_[b], shape[b], 1, &unit));
    }
    must(rollcon_wheelrail_create(context_, body_[0], body_[1], ROLLCON_RIGHT, &wheel_));
    must(rollcon_wheelrail_set_track(wheel_, 1435, 14, std::atan(1.0 / 40)));
    must(rollcon_wheelrail_set_wheelset(wheel_, 1360, -70, 460));
    must(rollcon_wheelrail_set_friction(wheel_, mu));
    must(rollcon_wheelrail_set_accuracy(wheel_, accuracy));
    must(rollcon_wheelrail_prescribe_vertical(wheel_, by_force ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION, load));
  }
  ~Wheel() {
    rollcon_wheelrail_release(wheel_);
    for (rollcon_body* body : body_) rollcon_body_release(body);
    rollcon_context_release(context_);
  }
  Wheel(const Wheel&) = delete;
  Wheel& operator=(const Wheel&) = delete;

  std::int32_t step(double y, double z) {
    const double position[6] = {0, y, z, 0, 2.4e-3 * y, 0}, velocity[6] = {2000, 0, 0, 0, 0, -4.3459};
    must(rollcon_wheelrail_set_position(wheel_, position));
    must(rollcon_wheelrail_set_velocity(wheel_, velocity));
    const std::int32_t status = rollcon_wheelrail_solve(wheel_);
    must(status);
    return status;
  }
  std::array<double, 3> force() const {
    std::array<double, 3> f{};
    must(rollcon_wheelrail_get_resultant(wheel_, ROLLCON_IN_TRACK, f.data(), nullptr));
    return f;
  }
  double stat(const char* name) const {
    double value = 0;
    must(rollcon_wheelrail_get_stat(wheel_, name, &value));
    return value;
  }

 private:
  rollcon_context* context_ = nullptr;
  rollcon_body* body_[2] = {};
  rollcon_wheelrail* wheel_ = nullptr;
};

/// The wheelset's lateral shift over a run.
struct Course {
  const char* name;
  double middle, swing;
};
constexpr Course courses[] = {{"tread, 1 to 4 mm", 2.5, 1.5}, {"one and two patches, 4.6 to 5.6 mm", 5.1, 0.5}};

double shift(const Course& course, std::int64_t i, std::int64_t period) {
  return course.middle +
         course.swing * std::sin(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(period));
}

void run_course(Runner& runner, const Course& course, double accuracy, bool by_force) {
  const std::int64_t period = 1000, steps = runner.quick ? 1000 : 10000, checked = 40;
  Wheel wheel(accuracy, by_force), fine(0.005, true);
  // Heights that carry the load, from the finest lattice.
  std::vector<double> at, height;
  std::vector<std::array<double, 3>> expected;
  for (std::int64_t k = 0; k <= checked; ++k) {
    const double y = course.middle + course.swing * (2 * static_cast<double>(k) / checked - 1);
    fine.step(y, 0);
    at.push_back(y);
    height.push_back(fine.stat("z"));
    expected.push_back(fine.force());
  }
  const auto z_at = [&](double y) {
    const double t = (y - at.front()) / (at.back() - at.front()) * checked;
    const auto k = static_cast<std::size_t>(std::clamp(std::floor(t), 0.0, checked - 1.0));
    return height[k] + (t - static_cast<double>(k)) * (height[k + 1] - height[k]);
  };
  const double cold_began = cpu_seconds();
  wheel.step(shift(course, 0, period), z_at(shift(course, 0, period)));
  const double cold = cpu_seconds() - cold_began;
  for (std::int64_t i = 0; i < period; ++i) wheel.step(shift(course, i, period), z_at(shift(course, i, period)));
  std::vector<double> seconds;
  std::int64_t allocations = 0, worst = 0;
  double solves = wheel.stat("solves");
  for (std::int64_t i = 0; i < steps; ++i) {
    const double y = shift(course, i, period), z = z_at(y);
    const std::int64_t before = heap_allocations();
    const double began = cpu_seconds();
    worst = std::max<std::int64_t>(worst, wheel.step(y, z));
    seconds.push_back(cpu_seconds() - began);
    allocations += heap_allocations() - before;
  }
  solves = (wheel.stat("solves") - solves) / static_cast<double>(steps);
  double mean_error = 0, worst_error = 0;
  Wheel other(accuracy, true);
  for (std::size_t k = 0; k < at.size(); ++k) {
    other.step(at[k], 0);
    const auto f = other.force();
    const double error = std::hypot(f[0] - expected[k][0], f[1] - expected[k][1]) / (mu * load);
    mean_error += error / static_cast<double>(at.size());
    worst_error = std::max(worst_error, error);
  }
  std::sort(seconds.begin(), seconds.end());
  double sum = 0;
  for (const double s : seconds) sum += s;
  Record record{.case_name = "wheel_rail", .method = by_force ? "vertical force" : "height", .model = course.name};
  record.quantity = "mean error of the force over mu N";
  record.against = "24 x 48";
  record.error = mean_error;
  record.status = static_cast<std::int32_t>(worst);
  record.seconds = sum / static_cast<double>(steps);
  record.extra = {{"accuracy", accuracy},
                  {"worst_error", worst_error},
                  {"seconds_median", seconds[seconds.size() / 2]},
                  {"seconds_99", seconds[seconds.size() * 99 / 100]},
                  {"seconds_cold", cold},
                  {"solves", solves},
                  {"allocations", static_cast<double>(allocations)}};
  runner.emit(record);
}

void run(Runner& runner) {
  for (const Course& course : courses)
    for (const double accuracy : {0.02, 0.01})
      for (const bool by_force : {false, true}) run_course(runner, course, accuracy, by_force);
}

}  // namespace

std::vector<Case> wheel_rail_cases() {
  return {{"wheel_rail", "a wheel on its rail in a vehicle's time loop, from profiles to forces", run}};
}

}  // namespace rollcon::bench
