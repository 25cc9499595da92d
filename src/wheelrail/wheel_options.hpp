#pragma once
/// Settings of a wheel on its rail by name.

#include <cstdint>

#include "support/setting_table.hpp"

namespace rollcon {

struct WheelOptions {
  double accuracy = 0.01, curvature = 0;
  double merge_distance = 1, merge_angle = 0.55, spacing_along = 0, spacing_across = 0;
  std::int64_t hertzian = 0, conformal = 0, roll_outside = 0, roll_about_origin = 0, slip_by_creepages = 0;
};

const SettingTable<WheelOptions>& wheel_option_table();

}  // namespace rollcon
