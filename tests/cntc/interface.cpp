#include "interface.hpp"

#include <rollcon.h>

namespace cntc_test {

void set_small(Element& e, double ksi) {
  e.set(cntc_setmaterialparameters, 0, {.28, .28, 82000, 82000});
  e.set(cntc_setfrictionmethod, 0, {.3, .3});
  e.set(cntc_sethertzcontact, -1, {6, 6, 1e-3, 2e-3, 1.2});
  e.velocity(1000);
  e.normal_force(1e4);
  e.creepages(ksi, 0, 0);
}

void set_wheel(Element& e) {
  e.set(cntc_setmaterialparameters, 0, {.28, .28, 82000, 82000});
  e.set(cntc_setfrictionmethod, 0, {.3, .3});
  e.set(cntc_setpotcontact, 0, {1, 1});
  static const auto wheel = profile_points("s1002"), rail = profile_points("60e1");
  e.profile(true, wheel);
  e.profile(false, rail);
  e.set(cntc_settrackdimensions, 1, {14, 0, 1435, .025, 0});
  e.set(cntc_setwheelsetdimensions, 3, {1360, -70, 460});
  e.set(cntc_setwheelsetposition, 1, {0, 2, 0, 0, 0, 0});
  e.set(cntc_setwheelsetvelocity, 2, {2000, 0, 0, 0, 0, -4.34});
  e.vertical_force(10000);
}

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
