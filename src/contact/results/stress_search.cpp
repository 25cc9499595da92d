#include "contact/results/stress_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/error.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"
#include "support/stress_invariants.hpp"

namespace rollcon {
namespace {

using Stress = std::array<double, 6>;  // 11, 22, nn, 12, 1n, 2n
using Points = std::vector<Vec3>;

/// Holds half the extents of what touches, its middle, and the lesser of both extents.
struct Extent {
  double x = 0, y = 0, half_x = 0, half_y = 0, width = 0;

  explicit Extent(const Solution& s) {
    double low[2]{INFINITY, INFINITY}, high[2]{-INFINITY, -INFINITY};
    const Frame& frame = s.prepared->frame;
    for (std::size_t k = 0; k < frame.x.size(); ++k) {
      if (!(s.iterate.lambda[2][k] < 0)) continue;
      const double size = std::sqrt(frame.cell_area[k]), p[2]{frame.x[k], frame.y[k]};
      for (std::size_t c = 0; c < 2; ++c)
        low[c] = std::min(low[c], p[c] - size / 2), high[c] = std::max(high[c], p[c] + size / 2);
    }
    if (!(low[0] < high[0])) fail(Status::err_state, "the bodies do not touch: there are no stresses to search");
    x = (low[0] + high[0]) / 2, y = (low[1] + high[1]) / 2;
    half_x = (high[0] - low[0]) / 2, half_y = (high[1] - low[1]) / 2;
    width = std::min(half_x, half_y);
  }
};

/// Knows stresses at points whose third coordinate is a depth.
class Inside {
 public:
  Inside(const Solution& s, std::int32_t body, StressesInside& stresses)
      : extent(s), solution(s), side_(body == 1 ? -1 : 1), stresses_(stresses) {}

  std::vector<Stress> at(Points points) const {
    for (Vec3& p : points) p[2] *= side_;
    std::vector<Stress> found(points.size());
    check_interrupt();
    stresses_.find({std::ssize(points), points.front().data()}, found.front().data(), nullptr);
    return found;
  }
  /// Returns depths as coordinates along n.
  Vec3 place(const Vec3& p) const { return {p[0], p[1], side_ * p[2]}; }

  const Extent extent;
  const Solution& solution;

 private:
  double side_;
  StressesInside& stresses_;
};

// Stresses over places along t1 that a particle passes, from far before the contact to far behind it.
constexpr std::size_t passed = 97;

Points line_through(const Extent& e, const Vec3& p) {
  Points line;
  const double half = e.half_x + 2 * e.width;
  for (std::size_t i = 0; i < passed; ++i)
    line.push_back({e.x + half * (2 * static_cast<double>(i) / (passed - 1) - 1), p[1], p[2]});
  return line;
}

double hydrostatic(const Stress& s) {
  return (s[0] + s[1] + s[2]) / 3;
}

/// Finds the least ball around deviators, a and b apart by sqrt((a - b):(a - b)), by moving weight between the farthest
/// and the nearest one that has some. Returns its radius.
double least_ball(std::span<const Stress> path, Stress& centre) {
  const double weight[] = {1, 1, 1, 2, 2, 2};
  std::vector<Stress> p(path.begin(), path.end());
  for (Stress& s : p) {
    const double mean = hydrostatic(s);
    for (std::size_t c = 0; c < 3; ++c) s[c] -= mean;
  }
  const auto square = [&](const Stress& a, const Stress& b) {
    double sum = 0;
    for (std::size_t c = 0; c < 6; ++c) sum += weight[c] * (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
  };
  std::vector<double> share(p.size(), 0), distance(p.size());
  share[0] = 1;
  centre = p[0];
  constexpr int most = 20000;
  constexpr double enough = 1e-7;
  for (int round = 0;; ++round) {
    std::size_t far = 0, near = p.size();
    for (std::size_t i = 0; i < p.size(); ++i) {
      distance[i] = square(p[i], centre);
      if (distance[i] > distance[far]) far = i;
      if (share[i] > 0 && (near == p.size() || distance[i] < distance[near])) near = i;
    }
    const double differ = distance[far] - distance[near];
    if (!(differ > enough * distance[far]) || round == most) return std::sqrt(distance[far]);
    const double step = std::min(share[near], differ / (2 * square(p[far], p[near])));
    share[far] += step, share[near] -= step;
    for (std::size_t c = 0; c < 6; ++c) centre[c] += step * (p[far][c] - p[near][c]);
  }
}

/// Returns the amplitude of the orthogonal shear, half its range, and where it is greatest.
double amplitude(std::span<const Stress> path, std::size_t& where) {
  double low = 0, high = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (std::abs(path[i][4]) > std::max(-low, high)) where = i;
    low = std::min(low, path[i][4]), high = std::max(high, path[i][4]);
  }
  return (high - low) / 2;
}

/// Dang Van: the largest shear of deviators about their ball's centre, with the hydrostatic stress of the moment.
double dang_van(std::span<const Stress> path, double weight, std::size_t& where) {
  Stress centre;
  least_ball(path, centre);
  double most = -INFINITY;
  for (std::size_t i = 0; i < path.size(); ++i) {
    Stress s = path[i];
    for (std::size_t c = 0; c < 6; ++c) s[c] -= centre[c];
    const double value = stress_invariants(s.data()).shear + weight * hydrostatic(path[i]);
    if (value > most) most = value, where = i;
  }
  return most;
}

/// Crossland: the amplitude of the root of the deviators' second invariant, with the largest hydrostatic stress.
double crossland(std::span<const Stress> path, double weight, std::size_t& where) {
  Stress centre;
  const double radius = least_ball(path, centre);
  for (std::size_t i = 0; i < path.size(); ++i)
    if (hydrostatic(path[i]) > hydrostatic(path[where])) where = i;
  return radius / std::sqrt(2.0) + weight * hydrostatic(path[where]);
}

struct Measure {
  const char* name;
  std::size_t parameters;
  const char* meaning;
  double (*of_stress)(const double* s);
  double (*of_history)(std::span<const Stress> path, double weight, std::size_t& where);
};

constexpr Measure measures[] = {
    {"von_mises", 0, "none", [](const double* s) { return stress_invariants(s).von_mises; }, nullptr},
    {"shear", 0, "none", [](const double* s) { return stress_invariants(s).shear; }, nullptr},
    {"orthogonal_shear", 0, "none", [](const double* s) { return std::abs(s[4]); }, nullptr},
    {"dang_van", 1, "the weight of the hydrostatic stress", nullptr, dang_van},
    {"crossland", 1, "the weight of the hydrostatic stress", nullptr, crossland},
    {"lundberg_palmgren", 3, "the exponents of stress and depth, and the least depth", nullptr, nullptr},
};

/// Returns values of a measure at points; of histories, whose points get the place along t1.
std::vector<double> values(const Inside& inside, const Measure& measure, double weight, Points& points) {
  std::vector<double> value;
  if (measure.of_stress) {
    for (const Stress& s : inside.at(points)) value.push_back(measure.of_stress(s.data()));
    return value;
  }
  Points lines;
  for (const Vec3& p : points)
    for (const Vec3& on : line_through(inside.extent, p)) lines.push_back(on);
  const std::vector<Stress> all = inside.at(lines);
  for (std::size_t i = 0; i < points.size(); ++i) {
    // A particle that is far away has no stress.
    std::vector<Stress> path(all.begin() + std::ptrdiff_t(i * passed), all.begin() + std::ptrdiff_t((i + 1) * passed));
    path.push_back({});
    std::size_t where = 0;
    value.push_back(measure.of_history(path, weight, where));
    points[i][0] = lines[i * passed + std::min(where, passed - 1)][0];
  }
  return value;
}

/// Returns places over the contact, those of the largest pressures among them, and depths below.
Points first_places(const Inside& inside, bool of_history) {
  constexpr int along = 8, across = 16;
  constexpr std::size_t highest = 24;
  constexpr double depth[] = {0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.65, 0.8, 1, 1.4};
  const Extent& e = inside.extent;
  Points all, over;
  for (int j = 0; j <= across; ++j)
    for (int i = of_history ? along / 2 : 0; i <= (of_history ? along / 2 : along); ++i)
      over.push_back({e.x + e.half_x * (2.0 * i / along - 1), e.y + e.half_y * (2.0 * j / across - 1), 0});
  const std::vector<double>& normal = inside.solution.iterate.lambda[2];
  std::vector<std::size_t> node(normal.size());
  std::iota(node.begin(), node.end(), std::size_t{0});
  const std::size_t some = std::min(highest, node.size());
  std::partial_sort(node.begin(), node.begin() + std::ptrdiff_t(some), node.end(),
                    [&](std::size_t a, std::size_t b) { return normal[a] < normal[b]; });
  const Frame& frame = inside.solution.prepared->frame;
  for (std::size_t i = 0; i < some; ++i) over.push_back({frame.x[node[i]], frame.y[node[i]], 0});
  for (const double z : depth)
    for (const Vec3& p : over) all.push_back({p[0], p[1], z * e.width});
  return all;
}

/// Goes from a place uphill, by steps that are halved where no neighbour is higher.
double climb(const Inside& inside, const Measure& measure, double weight, Vec3& place, double value) {
  const Extent& e = inside.extent;
  const bool along = measure.of_stress != nullptr;
  constexpr double enough = 1e-4;
  for (double step = 0.1; step > enough;) {
    Points near;
    for (int i = along ? -1 : 0; i <= (along ? 1 : 0); ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const double z = place[2] + k * step * e.width;
          if ((i != 0 || j != 0 || k != 0) && z >= 0)
            near.push_back({place[0] + i * step * e.width, place[1] + j * step * e.width, z});
        }
    const std::vector<double> found = values(inside, measure, weight, near);
    const auto best = std::max_element(found.begin(), found.end());
    if (*best > value)
      value = *best, place = near[at(best - found.begin())];
    else
      step /= 2;
  }
  return value;
}

double search(const Inside& inside, const Measure& measure, double weight, Vec3& place) {
  Points first = first_places(inside, !measure.of_stress);
  const std::vector<double> value = values(inside, measure, weight, first);
  std::vector<std::size_t> order(value.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value[a] > value[b]; });
  // Climbs from the highest places that are not beside each other.
  constexpr std::size_t climbs = 3;
  Points from;
  double most = -INFINITY;
  for (const std::size_t i : order) {
    const auto beside = [&](const Vec3& p) { return length(p - first[i]) < 0.5 * inside.extent.width; };
    if (std::any_of(from.begin(), from.end(), beside)) continue;
    from.push_back(first[i]);
    Vec3 top = first[i];
    if (const double found = climb(inside, measure, weight, top, value[i]); found > most) most = found, place = top;
    if (from.size() == climbs) break;
  }
  return most;
}

/// Integrates amplitude^c / depth^h over y and depth.
double lundberg_palmgren(const Inside& inside, std::span<const double> parameter, Vec3& place) {
  const auto [c, h, least] = std::tuple{parameter[0], parameter[1], parameter[2]};
  if (!(c > 0 && h >= 0 && least >= 0))
    fail(Status::err_argument,
         "exponents and least depth of \"lundberg_palmgren\" are %g, %g, %g; allowed: > 0, >= 0, "
         ">= 0",
         c, h, least);
  if (least == 0 && !inside.solution.frictionless)
    fail(Status::err_argument,
         "least depth of \"lundberg_palmgren\" is 0; allowed under friction, whose shear reaches the surface: above 0");
  constexpr int across = 48, down = 40;
  const Extent& e = inside.extent;
  const double deepest = 3 * e.width, top = std::sqrt(least / deepest);
  double sum = 0, most = -1;
  for (int j = 0; j < across; ++j) {
    Points lines;
    for (int k = 0; k < down; ++k) {
      const double u = top + (1 - top) * (k + 0.5) / down;
      for (const Vec3& on : line_through(e, {0, e.y + e.half_y * (2 * (j + 0.5) / across - 1), deepest * u * u}))
        lines.push_back(on);
    }
    const std::vector<Stress> all = inside.at(lines);
    for (int k = 0; k < down; ++k) {
      const std::size_t first = at(k) * passed;
      std::size_t where = 0;
      const double shear = amplitude(std::span(all).subspan(first, passed), where), z = lines[first][2];
      sum += std::pow(shear, c) * std::pow(z, -h) * 2 * std::sqrt(z * deepest);
      if (shear > most) most = shear, place = lines[first + where];
    }
  }
  return sum * (2 * e.half_y / across) * (1 - top) / down;
}

}  // namespace

double largest_stress(const Solution& s, std::int32_t body, StressesInside& stresses, const char* name,
                      std::span<const double> parameter, Vec3& place) {
  const Measure* const found = std::find_if(std::begin(measures), std::end(measures),
                                            [&](const Measure& m) { return std::string(name) == m.name; });
  if (found == std::end(measures)) {
    std::string known;
    for (const Measure& m : measures) known += (known.empty() ? "" : ", ") + std::string(m.name);
    fail(Status::err_option, "measure is \"%.60s\"; allowed: %s", name, known.c_str());
  }
  if (parameter.size() != found->parameters)
    fail(Status::err_argument, "measure \"%s\" was given %d parameter(s); allowed: %s", name,
         static_cast<int>(parameter.size()), found->meaning);
  const Inside inside(s, body, stresses);
  const double value = found->of_stress || found->of_history
                           ? search(inside, *found, parameter.empty() ? 0 : parameter[0], place)
                           : lundberg_palmgren(inside, parameter, place);
  place = inside.place(place);
  return value;
}

BlockInside::BlockInside(const Solution& s, std::int32_t body) {
  constexpr std::int32_t along = 24, down = 16;
  const Extent e(s);
  const double side = body == 1 ? -1 : 1;
  const auto part = [](std::int32_t i, std::int32_t n) { return static_cast<double>(i) / n; };
  for (std::int32_t k = 0; k <= down; ++k)
    for (std::int32_t j = 0; j <= along; ++j)
      for (std::int32_t i = 0; i <= along; ++i)
        surface.node.push_back({e.x + 3 * e.half_x * (2 * part(i, along) - 1),
                                e.y + 3 * e.half_y * (2 * part(j, along) - 1),
                                side * 4 * e.width * part(k, down) * part(k, down)});
  const auto number = [](std::int32_t i, std::int32_t j, std::int32_t k) {
    return (k * (along + 1) + j) * (along + 1) + i;
  };
  for (std::int32_t k = 0; k < down; ++k)
    for (std::int32_t j = 0; j < along; ++j)
      for (std::int32_t i = 0; i < along; ++i) {
        // The first four nodes are those of the lower face.
        for (const std::int32_t level : {side < 0 ? k + 1 : k, side < 0 ? k : k + 1})
          for (const auto& [a, b] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}})
            volume.connectivity.push_back(number(a, b, level));
        volume.type.push_back(VolumeType::hex8);
        volume.tag.push_back(0);
        volume.offset.push_back(std::ssize(volume.connectivity));
      }
}

}  // namespace rollcon
