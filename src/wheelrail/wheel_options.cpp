#include "wheelrail/wheel_options.hpp"

namespace rollcon {

const SettingTable<WheelOptions>& wheel_option_table() {
  static const SettingTable<WheelOptions> table{
      {"accuracy", &WheelOptions::accuracy, 0.005, 1,
       "Error of tangential forces over the limit of friction: the frames of the patches are as fine as that takes."},
      {"hertzian", &WheelOptions::hertzian, 0, 1,
       "1: with a creep-force table, pressures are those of an ellipse that each patch's overlap and the table's map "
       "give, and none are solved for; 0: they are."},
      {"conformal", &WheelOptions::conformal, 0, 1,
       "1: the frame of each patch follows the profiles, with normals that turn across the rolling direction, and "
       "tables are not used; 0: it lies in a plane."},
      {"roll_outside", &WheelOptions::roll_outside, 0, 1,
       "1: positions are yawed, then rolled; 0: rolled, then yawed."},
  };
  return table;
}

}  // namespace rollcon
