/// Implements the calls for the geometry of wheelsets on rails, both sides together.

#include <iterator>

#include "capi/columns.hpp"
#include "capi/guard.hpp"
#include "support/input_checks.hpp"
#include "wheelrail/wheelset_geometry.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

/// Calls f(geometry) while both wheels are held for this call alone.
template <class F>
rollcon_status with_wheelset(const char* function, rollcon_wheelrail* left, rollcon_wheelrail* right, F&& f) {
  return with_wheelrail(function, left, [&](WheelRail& one) {
    require_pointer(right, "right");
    if (one.side() > 0) fail(Status::err_argument, "left is a wheel on the right; allowed: one made with ROLLCON_LEFT");
    if (right == left) fail(Status::err_argument, "right is a wheel on the left; allowed: one made with ROLLCON_RIGHT");
    const std::shared_ptr<Object> other = handles().find(Kind::wheelrail, right);
    if (!other) fail(Status::err_handle, "right is not a live wheel on its rail");
    const InUse use(*other, "wheel on the right");
    WheelsetGeometry geometry(one, *other->wheelrail);
    f(geometry);
  });
}

/// Calls f for each of the caller's values in turn; error texts say which one failed.
template <class F>
void for_each_entry(std::int64_t n, const double* value, const char* name, F&& f) {
  require_count(n, "n");
  if (n == 0) return;
  require_list(n, value, name);
  for (std::int64_t i = 0; i < n; ++i) {
    try {
      f(i);
    } catch (const Error& error) {
      fail(error.status(), "entry %lld of %s (counting from 0): %s", static_cast<long long>(i), name, error.what());
    }
  }
}

}  // namespace

rollcon_status rollcon_wheelrail_find_contact_points(rollcon_wheelrail* left, rollcon_wheelrail* right, int64_t n,
                                                     const double* shift, const char* columns, double* points) {
  return with_wheelset(__func__, left, right, [&](WheelsetGeometry& geometry) {
    static constexpr const char* known[] = {"z",           "roll",          "radius_difference", "left_y",  "left_z",
                                            "left_angle",  "left_wheel_y",  "left_radius",       "right_y", "right_z",
                                            "right_angle", "right_wheel_y", "right_radius"};
    const std::vector<std::size_t> wanted = read_names(columns, "columns", known);
    if (n > 0) require_pointer(points, "points");
    for_each_entry(n, shift, "shift", [&](std::int64_t i) {
      const WheelsetGeometry::Standing stand = geometry.at(shift[i], WheelsetGeometry::Height::axle);
      double row[std::size(known)], *to = row;
      for (const double v : {stand.z, stand.roll, stand.difference()}) *to++ = v;
      for (const WheelRail::Touch& touch : stand.touch)
        for (const double v : {touch.y, touch.z, touch.angle, touch.wheel_y, touch.rolling_radius}) *to++ = v;
      points = copy_columns(wanted, row, points);
    });
  });
}

rollcon_status rollcon_wheelrail_find_conicity(rollcon_wheelrail* left, rollcon_wheelrail* right, int64_t n,
                                               const double* amplitude, double* conicity, double* wavelength) {
  return with_wheelset(__func__, left, right, [&](WheelsetGeometry& geometry) {
    if (n > 0) require_pointer(conicity, "conicity");
    for_each_entry(n, amplitude, "amplitude", [&](std::int64_t i) {
      double length = 0;
      conicity[i] = geometry.motion(amplitude[i], length).conicity;
      if (wavelength) wavelength[i] = length;
    });
  });
}
