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
      {"slip_by_creepages", &WheelOptions::slip_by_creepages, 0, 1,
       "1: slip is that of longitudinal and lateral creepage and spin at the reference of each patch, for comparison "
       "with programs that know no more; 0: that of the surfaces, whose rolling radius varies over the patch."},
      {"merge_distance", &WheelOptions::merge_distance, 1e-3, 1e3,
       "Distance of two overlaps, over the sum of their radii of contact, from which they are two patches; from 0.3 of "
       "it down they are one."},
      {"merge_angle", &WheelOptions::merge_angle, 1e-3, 1.6,
       "Angle between the normals of two overlaps, radian, from which they are two patches; up to 0.636 of it they may "
       "be one."},
      {"spacing_along", &WheelOptions::spacing_along, 0, 1e30,
       "Steady patches are solved on lattices with about this spacing along the rolling direction, and on no strips; "
       "0: accuracy says how finely."},
      {"spacing_across", &WheelOptions::spacing_across, 0, 1e30, "The same across the rolling direction."},
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
