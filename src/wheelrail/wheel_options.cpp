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
      {"curvature", &WheelOptions::curvature, -1e6, 1e6,
       "Curvature of the track, above 0 where it turns to the right: the velocity of the wheelset is relative to axes "
       "that follow the track, which turn with the forward speed times this."},
      {"roll_about_origin", &WheelOptions::roll_about_origin, 0, 1,
       "1: deviations of the rail roll about the origin of its profile; 0: about the point where the gauge is "
       "measured, "
       "at the height of the rails' top (rails placed by their profile's origin: about that in any case)."},
      {"roll_outside", &WheelOptions::roll_outside, 0, 1,
       "1: positions are yawed, then rolled; 0: rolled, then yawed."},
  };
  return table;
}

}  // namespace rollcon
