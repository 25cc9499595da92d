#include "wheels.hpp"

#include <cmath>
#include <ctime>
#include <numbers>
#include <stdexcept>

namespace rollcon::bench {
namespace {

constexpr double shear = 82000, poisson = 0.28;

}  // namespace

void must(std::int32_t status) {
  if (status < 0) throw std::runtime_error(rollcon_last_error());
}

double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Wheel::Wheel(double accuracy, bool by_force, CreepForces by, std::int32_t side) {
  must(rollcon_context_create(ROLLCON_ABI, &context_));
  must(rollcon_context_set_threads(context_, 1));
  const double unit = 1;
  const char* shape[] = {"s1002", "60e1"};
  for (std::size_t b = 0; b < 2; ++b) {
    must(rollcon_body_create(context_, ROLLCON_BODY_HALFSPACE, &body_[b]));
    must(rollcon_body_set_elastic(body_[b], 0, 2 * shear * (1 + poisson), poisson));
    must(rollcon_body_set_profile_shape(body_[b], shape[b], 1, &unit));
  }
  must(rollcon_wheelrail_create(context_, body_[0], body_[1], side, &wheel_));
  must(rollcon_wheelrail_set_track(wheel_, 1435, 14, std::atan(1.0 / 40)));
  must(rollcon_wheelrail_set_wheelset(wheel_, 1360, -70, radius));
  must(rollcon_wheelrail_set_friction(wheel_, "coulomb", 1, &mu));
  must(rollcon_wheelrail_set_real(wheel_, "accuracy", accuracy));
  must(rollcon_wheelrail_prescribe_vertical(wheel_, by_force ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION, load));
  if (by == CreepForces::solved) return;
  must(rollcon_table_standard(context_, &table_));
  must(rollcon_wheelrail_set_table(wheel_, table_));
  if (by == CreepForces::table_on_ellipses) must(rollcon_wheelrail_set_int(wheel_, "hertzian", 1));
}

Wheel::~Wheel() {
  rollcon_wheelrail_release(wheel_);
  rollcon_table_release(table_);
  for (rollcon_body* body : body_) rollcon_body_release(body);
  rollcon_context_release(context_);
}

std::int32_t Wheel::step(double y, double z, double roll, double rate) {
  const double position[6] = {0, y, z, roll, 2.4e-3 * y, 0}, velocity[6] = {speed, 0, 0, 0, 0, rate};
  return solve(position, velocity);
}

std::int32_t Wheel::solve(const double (&position)[6], const double (&velocity)[6]) {
  must(rollcon_wheelrail_set_position(wheel_, position));
  must(rollcon_wheelrail_set_velocity(wheel_, velocity));
  const std::int32_t status = rollcon_wheelrail_solve(wheel_);
  must(status);
  return status;
}

Wheel::Result Wheel::result() const {
  Result found;
  std::array<double, 3> f{};
  must(rollcon_wheelrail_get_resultant(wheel_, ROLLCON_IN_TRACK, f.data(), nullptr));
  found.force = {f[0], f[1]};
  std::int64_t patches = 0;
  must(rollcon_wheelrail_get_patch_count(wheel_, &patches));
  double area = 0;
  for (std::int32_t p = 0; p < patches; ++p) {
    const double share = patch_stat(p, "share");
    found.moment += share * patch_stat(p, "spin_moment");
    area += share * patch_stat(p, "area");
  }
  found.radius = std::sqrt(area / std::numbers::pi);
  return found;
}

double Wheel::stat(const char* name) const {
  double value = 0;
  must(rollcon_wheelrail_get_stat(wheel_, name, &value));
  return value;
}

double Wheel::patch_stat(std::int32_t patch, const char* name) const {
  double value = 0;
  must(rollcon_wheelrail_get_patch_stat(wheel_, patch, name, &value));
  return value;
}

std::array<double, 2> Wheel::errors(const Result& found, const Result& expected) {
  return {std::hypot(found.force[0] - expected.force[0], found.force[1] - expected.force[1]) / (mu * load),
          std::abs(found.moment - expected.moment) / (mu * load * expected.radius)};
}

}  // namespace rollcon::bench
