#pragma once
/// Puts a wheel S1002 on its rail 60E1 by the library's handle, for cases that time and compare it. Units: mm, N, s.

#include <array>
#include <cstdint>
#include <string>

#include "rollcon.h"

namespace rollcon::bench {

enum class CreepForces { solved, table, table_on_ellipses };  ///< source of forces along the surface

class Wheel {
 public:
  static constexpr double mu = 0.3, load = 10000, speed = 2000, radius = 460;

  Wheel(double accuracy, bool by_force, CreepForces by, std::int32_t side = ROLLCON_RIGHT);
  ~Wheel();
  Wheel(const Wheel&) = delete;
  Wheel& operator=(const Wheel&) = delete;

  /// Solves at this lateral shift, with a yaw of 2.4 mrad for each millimetre, and height (or the load); returns the
  /// status.
  std::int32_t step(double y, double z, double roll = 0, double rate = -4.3459);
  std::int32_t solve(const double (&position)[6], const double (&velocity)[6]);

  struct Result {
    std::array<double, 2> force{};  ///< force on the wheel in the track, along and across
    double moment = 0;              ///< spin moments of the patches, by their weights
    double radius = 0;              ///< radius of the circle with the area of all patches
  };
  Result result() const;
  double stat(const char* name) const;
  rollcon_wheelrail* handle() const { return wheel_; }
  /// Returns |dF| / (mu Fn) and |dM| / (mu Fn radius).
  static std::array<double, 2> errors(const Result& found, const Result& expected);

 private:
  double patch_stat(std::int32_t patch, const char* name) const;

  rollcon_context* context_ = nullptr;
  rollcon_body* body_[2] = {};
  rollcon_table* table_ = nullptr;
  rollcon_wheelrail* wheel_ = nullptr;
};

double thread_seconds();  ///< processor seconds of this thread

/// Throws std::runtime_error with the library's text where a call fails.
void must(std::int32_t status);

}  // namespace rollcon::bench
