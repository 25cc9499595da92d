#include "interface.hpp"

#include <rollcon.h>

namespace cntc_test {

std::vector<double> profile_points(const char* shape) {
  rollcon_context* context = nullptr;
  rollcon_body* body = nullptr;
  const double unit = 1;
  double length = 0;
  rollcon_context_create(ROLLCON_ABI, &context);
  rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body);
  rollcon_body_set_profile_shape(body, shape, 1, &unit);
  rollcon_body_get_profile_length(body, &length);
  std::vector<double> points;
  const int n = int(length / .1);
  for (int k = 0; k <= n; ++k) {
    double point[2], tangent[2], curvature;
    rollcon_body_get_profile_point(body, length * k / n, point, tangent, &curvature);
    points.insert(points.end(), {point[0], point[1]});
  }
  rollcon_body_release(body);
  rollcon_context_release(context);
  return points;
}

}  // namespace cntc_test
