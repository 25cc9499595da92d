#pragma once
/// Settings of a wheel on its rail by name.

#include <cstdint>

#include "support/setting_table.hpp"

namespace rollcon {

struct WheelOptions {
  double accuracy = 0.01, curvature = 0;
  std::int64_t hertzian = 0, conformal = 0, roll_outside = 0, roll_about_origin = 0;
};

const SettingTable<WheelOptions>& wheel_option_table();

}  // namespace rollcon
