/// Implements the calls for wear of contacts and of profiles.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "capi/guard.hpp"
#include "contact/laws/wear_law.hpp"
#include "geometry/profile_wear.hpp"
#include "support/input_checks.hpp"
#include "wheelrail/solve_positions.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

constexpr int64_t most_points = 1'000'000;

WearLaw law_of(const char* law, int32_t n, const double* parameters) {
  require_pointer(law, "law");
  require_count(n, "n");
  if (n > 0) require_pointer(parameters, "parameters");
  return {law, {parameters, static_cast<std::size_t>(n)}};
}

void require_point_count(int64_t points, int64_t least) {
  if (points < least || points > most_points)
    fail(Status::err_argument, "points is %lld; allowed: %lld to %lld", static_cast<long long>(points),
         static_cast<long long>(least), static_cast<long long>(most_points));
}

}  // namespace

rollcon_status rollcon_contact_get_wear(const rollcon_contact* contact, const char* law, int32_t n,
                                        const double* parameters, int64_t points, const double* y, double* depth,
                                        double* volume) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    const WearLaw taken = law_of(law, n, parameters);
    require_point_count(points, 2);
    require_list(points, y, "y");
    for (int64_t j = 1; j < points; ++j)
      if (!(y[j] > y[j - 1]))
        fail(Status::err_argument, "entry %lld of y (counting from 0) is %g; allowed: above that before it, %g",
             static_cast<long long>(j), y[j], y[j - 1]);
    const std::array<double, 2> across = c.contact_across();
    if (across[0] <= across[1] && (across[0] < y[0] || across[1] > y[points - 1]))
      fail(Status::err_argument, "y goes from %g to %g; allowed: from %g to %g, where nodes are in contact, or farther",
           y[0], y[points - 1], across[0], across[1]);
    const std::span<const double> places(y, static_cast<std::size_t>(points));
    std::vector<double> found(places.size(), 0.0);
    const double whole = c.wear(taken, places, 1, found.data());
    if (!std::isfinite(whole)) fail(Status::err_argument, "the parameters of the law are too large: wear overflows");
    const std::vector<double> share = shares_of_length(places);
    for (std::size_t j = 0; j < found.size(); ++j) {
      found[j] /= share[j];
      if (!std::isfinite(found[j]))
        fail(Status::err_argument, "entries %lld of y and beside it are too close together: depth overflows",
             static_cast<long long>(j));
    }
    if (depth) std::copy(found.begin(), found.end(), depth);
    if (volume) *volume = whole;
  });
}

rollcon_status rollcon_wheelrail_find_wear(rollcon_wheelrail* wheelrail, int64_t n_cases, const double* positions,
                                           const double* velocities, const double* weights, const char* law, int32_t n,
                                           const double* parameters, int64_t points, double* wheel, double* rail,
                                           double* volumes, int32_t* status) {
  return with_wheelrail(
      __func__, wheelrail, together([&](WheelRail& w) {
        constexpr int64_t most = 100'000;
        if (n_cases < 1 || n_cases > most)
          fail(Status::err_argument, "n_cases is %lld; allowed: 1 to %lld", static_cast<long long>(n_cases),
               static_cast<long long>(most));
        require_pointer(positions, "positions");
        require_pointer(velocities, "velocities");
        if (weights) require_list(n_cases, weights, "weights");
        for (int64_t i = 0; weights && i < n_cases; ++i)
          if (weights[i] < 0)
            fail(Status::err_argument, "entry %lld of weights (counting from 0) is %g; allowed: 0 or more",
                 static_cast<long long>(i), weights[i]);
        const WearLaw taken = law_of(law, n, parameters);
        require_point_count(points, 2);
        constexpr int64_t together = 20'000'000;
        if (points > together / n_cases)
          fail(Status::err_argument, "n_cases is %lld and points is %lld; allowed: a product up to %lld",
               static_cast<long long>(n_cases), static_cast<long long>(points), static_cast<long long>(together));
        return find_wear(w, {n_cases, positions, velocities}, {taken, weights, points, wheel, rail, volumes}, status);
      }));
}

rollcon_status rollcon_wear_profile(int64_t points, const double* yz, const double* rate, int32_t side, double distance,
                                    double most_depth, double smoothing, double* worn, double* taken) {
  return guarded(__func__, nullptr, [&] {
    require_point_count(points, 2);
    require_list(2 * points, yz, "yz");
    require_list(points, rate, "rate");
    if (side != 1 && side != -1)
      fail(Status::err_argument, "side is %d; allowed: 1 (the body is at greater z), -1 (at lesser z)", side);
    require_finite(distance, "distance");
    require_finite(most_depth, "most_depth");
    require_finite(smoothing, "smoothing");
    if (distance < 0) fail(Status::err_argument, "distance is %g; allowed: 0 or more", distance);
    if (!(most_depth > 0)) fail(Status::err_argument, "most_depth is %g; allowed: above 0", most_depth);
    if (smoothing < 0) fail(Status::err_argument, "smoothing is %g; allowed: 0 or more", smoothing);
    require_pointer(worn, "worn");
    std::vector<Vec2> point;
    for (int64_t j = 0; j < points; ++j) point.push_back({yz[2 * j], yz[2 * j + 1]});
    for (std::size_t j = 1; j < point.size(); ++j)
      if (point[j] == point[j - 1])
        fail(Status::err_argument, "point %lld (counting from 0) is where the one before it is",
             static_cast<long long>(j));
    for (int64_t j = 0; j < points; ++j)
      if (rate[j] < 0)
        fail(Status::err_argument, "entry %lld of rate (counting from 0) is %g; allowed: 0 or more",
             static_cast<long long>(j), rate[j]);
    const WornProfile result = wear_profile(point, {rate, rate + points}, side, distance, most_depth, smoothing);
    for (const Vec2& x : result.point)
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]))
        fail(Status::err_argument, "rate and distance are too large: the profile overflows");
    for (std::size_t j = 0; j < point.size(); ++j) std::copy_n(result.point[j].data(), 2, worn + 2 * j);
    if (taken) *taken = result.taken;
  });
}
