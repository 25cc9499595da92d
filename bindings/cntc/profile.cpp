#include "profile.hpp"

#include <algorithm>
#include <cmath>

#include "text.hpp"

namespace cntc {
namespace {

constexpr double shortest = 5, longest = 500;

/// Filter of rollcon that keeps half of the waves that CONTACT's smoothing keeps half of.
double filter_length(const ProfileInput& input) {
  const double smoothing = input.options.reals[1];
  if (smoothing <= 0) return 0;
  return input.options.ints[5] == 0 ? 6.283185307179586 * std::pow(smoothing, .25) : smoothing;
}

}  // namespace

void Profile::read(rollcon_context* context, const ProfileInput& input, double unit, int mirror) {
  create(body_, rollcon_body_create, context, ROLLCON_BODY_HALFSPACE);
  rollcon_body* body = body_.get();
  const int kind = input.options.ints[5];  // 0: a plain spline, 1: second order, 2: third order
  check(rollcon_body_set_int(body, "filter_order", kind == 2 ? 3 : 2));
  check(rollcon_body_set_int(body, "points_alike", kind == 0 ? 1 : 0));
  const double filter = filter_length(input);
  if (varies_) {
    check(rollcon_body_read_slices(body, input.path.c_str(), 1, unit, mirror, filter));
  } else if (input.points.empty()) {
    check(rollcon_body_read_profile(body, input.path.c_str(), unit, mirror, filter));
  } else {
    std::vector<double> points = input.points;
    for (size_t k = 0; k + 1 < points.size(); k += 2) {
      points[k] *= mirror & 1 ? -1 : 1;
      points[k + 1] *= mirror & 2 ? -1 : 1;
    }
    check(rollcon_body_set_profile(body, int64_t(points.size() / 2), points.data(), filter));
  }
  check(rollcon_body_get_profile_length(body, &length_));
}

bool Profile::upside_down(bool wheel) const {
  double y = 0, z = 0, slope = 0, low = 1e300, high = -1e300;
  const int n = 200;
  std::vector<double> heights;
  for (int k = 0; k <= n; ++k) {
    at(length_ * k / n, y, z, slope);
    low = std::min(low, z);
    high = std::max(high, z);
    heights.push_back(z);
  }
  if (!wheel) return heights[n / 2] > (heights.front() + heights.back()) / 2;
  // The flange is what lies farthest from most of the wheel's profile.
  std::nth_element(heights.begin(), heights.begin() + n / 2, heights.end());
  return high - heights[n / 2] < heights[n / 2] - low;
}

void Profile::make(rollcon_context* context, const ProfileInput& input, const Material& material, bool turned_over) {
  const char* which = input.wheel ? "wheel" : "rail";
  if (!input.given) throw Failure(CNTC_err_profil, std::string("the profile of the ") + which + " is missing");
  varies_ = ends_with(input.path, ".slcs") || ends_with(input.path, ".slcw");
  try {
    const ProfileOptions& o = input.options;
    int mirror = (o.ints[2] == 1 ? 1 : 0) + (o.ints[3] == 1 ? 2 : 0);
    double unit = o.reals[0] > 0 ? o.reals[0] : 1;
    read(context, input, unit, mirror);
    if (input.points.empty() && unit != 1 && length_ > longest) {
      unit = 1;  // the file's own units were obeyed already
      read(context, input, unit, mirror);
    }
    if (o.ints[3] == 0 && upside_down(input.wheel)) mirror |= 2, read(context, input, unit, mirror);
    if (turned_over) read(context, input, unit, mirror ^ 2);
    if (!(length_ >= shortest && length_ <= longest))
      throw Failure(CNTC_err_profil, std::string("the profile of the ") + which + " is " + std::to_string(length_) +
                                         " mm long; allowed: 5 to 500");
    const size_t k = input.wheel ? 1 : 0;
    check(rollcon_body_set_elastic(body_.get(), 0, 2 * material.g[k] * (1 + material.nu[k]), material.nu[k]));
  } catch (const Failure& failure) {
    body_.reset();
    throw Failure(CNTC_err_profil, failure.what());
  }
}

void Profile::at(double s, double& y, double& z, double& slope) const {
  double point[2], tangent[2], curvature;
  check(rollcon_body_get_profile_point(body_.get(), std::clamp(s, 0., length_), point, tangent, &curvature));
  y = point[0];
  z = point[1];
  slope = std::atan2(tangent[1], tangent[0]);
}

}  // namespace cntc
