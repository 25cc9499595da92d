#include "wheelrail/hertzian_patch.hpp"

#include <cmath>
#include <numbers>

#include "framing/hertz.hpp"

namespace rollcon {

HertzianPatch hertzian_patch(const OverlapPatch& patch, double modulus, double give_way) {
  HertzianPatch h;
  const double depth = patch.fullness * patch.overlap, approach = depth - give_way;
  const double along = 0.5 * patch.curvature.along, twist = patch.curvature.twist;
  const QuadraticGap gap{along, depth / (8 * patch.spread) + twist * twist / (4 * along), twist};
  if (!(approach > 0 && along > 0) || !has_ellipse(gap)) return h;
  const HertzContact hertz = hertz_by_approach(gap, modulus, approach);
  // A turned ellipse is replaced by one without a turn that has its area and the ratio of its second moments.
  const double c = std::cos(hertz.angle), s = std::sin(hertz.angle);
  const double wide_x = std::hypot(hertz.larger * c, hertz.smaller * s),
               wide_y = std::hypot(hertz.larger * s, hertz.smaller * c),
               scale = std::sqrt(hertz.larger * hertz.smaller / (wide_x * wide_y));
  h.a = scale * wide_x;
  h.b = scale * wide_y;
  h.load = hertz.load;
  h.max_pressure = hertz.pressure;
  return h;
}

}  // namespace rollcon
