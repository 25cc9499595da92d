/// Compares profiles as surfaces with closed forms of cylinders, cones, spheres and tori, in any direction.

#include "geometry/profile_surface.hpp"

#include <random>

#include "geometry/profile_shapes.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr Vec3 any{0, 0, 0};

std::shared_ptr<const ProfileCurve> shape(const char* name, std::vector<double> parameter) {
  return std::make_shared<const ProfileCurve>(profile_of_shape(name, parameter));
}

struct Draw {
  std::mt19937 random{11};
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return normalized({normal(random), normal(random), normal(random)});
  }
  Vec3 across(const Vec3& a) { return normalized(cross(a, direction())); }
};

/// Returns the least |t| at which from + t direction is at distance radius from the centre, among those that `allowed`
/// takes.
template <class Allowed>
std::optional<double> least_root(double a, double b, double c, Allowed allowed) {
  const double d = b * b - a * c;
  std::optional<double> best;
  if (d < 0) return best;
  // The formula avoids cancellation.
  const double q = -(b + (b > 0 ? 1 : -1) * std::sqrt(d));
  for (const double t : {q / a, c / q})
    if (allowed(t) && (!best || std::abs(t) < std::abs(*best))) best = t;
  return best;
}

struct Tally {
  double distance = 0, normal = 0, nearest = 0;
  int hits = 0, misses = 0;

  void print(const std::string& name, int least_hits, int least_misses) const {
    expect_error(name + ": distance over size", distance, 1e-10);
    expect_error(name + ": normal", normal, 1e-9);
    expect_error(name + ": nearest point over size", nearest, 1e-10);
    EXPECT_GE(hits, least_hits);
    EXPECT_GE(misses, least_misses);
  }
};

/// Compares lines, except those whose distance from the surface changes by more than 1000 times what they are moved.
void compare(Tally& tally, const Surface& surface, const Vec3& from, const Vec3& direction, std::optional<double> due,
             double size, const Vec3& outward_there) {
  const auto t = surface.distance(from, direction, any);
  EXPECT_EQ(t.has_value(), due.has_value());
  if (!t || !due) {
    ++tally.misses;
    return;
  }
  ++tally.hits;
  const double steep = std::abs(dot(direction, outward_there));
  tally.distance = std::max(tally.distance, std::abs(*t - *due) * steep / size);
  const auto n = surface.normal(from, direction, outward_there);
  ASSERT_TRUE(n);
  tally.normal = std::max(tally.normal, length(*n - outward_there) * steep);
}

TEST(profile_surface, revolved_half_circle_is_a_sphere) {
  Draw draw;
  for (const double radius : {1e-3, 1.0, 460.0}) {
    Tally tally;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 centre = 3 * radius * draw.direction(), axis = draw.direction();
      const RevolvedProfile sphere(shape("arc", {radius, radius}), centre, axis, radius);
      const Vec3 from = centre + draw.between(0.1, 2) * radius * draw.direction(), direction = draw.direction();
      const Vec3 r = from - centre;
      const auto due = least_root(1, dot(r, direction), dot(r, r) - radius * radius, [](double) { return true; });
      const Vec3 hit = due ? r + *due * direction : r;
      compare(tally, sphere, from, direction, due, radius, (1 / length(hit)) * hit);
      const Vec3 x = centre + (radius / length(r)) * r;
      tally.nearest = std::max(tally.nearest, length(sphere.nearest(from) - x) / radius);
    }
    tally.print("sphere of radius " + std::to_string(radius), 1000, 300);
  }
}

TEST(profile_surface, revolved_lines_are_cylinders_and_cones) {
  Draw draw;
  constexpr double radius = 20, half = 15;
  for (const double slope : {0.0, 0.2, -1.0}) {
    Tally tally;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 origin = 30.0 * draw.direction(), axis = draw.direction();
      const RevolvedProfile cone(shape("line", {half, slope}), origin, axis, radius);
      const Vec3 from = origin + draw.between(1, 40) * draw.direction();
      const Vec3 direction = i % 3 == 0 ? normalized(axis + 0.3 * draw.direction()) : draw.direction();
      const Vec3 r = from - origin;
      const double y0 = dot(r, axis), y1 = dot(direction, axis), at0 = radius + slope * y0, at1 = slope * y1;
      const auto due =
          least_root(1 - y1 * y1 - at1 * at1, dot(r, direction) - y0 * y1 - at0 * at1, dot(r, r) - y0 * y0 - at0 * at0,
                     [&](double t) { return std::abs(y0 + t * y1) <= half && at0 + t * at1 > 0; });
      Vec3 out = axis;
      if (due) {
        const Vec3 hit = r + *due * direction, off = hit - dot(hit, axis) * axis;
        out = normalized((1 / length(off)) * off - slope * axis);
      }
      compare(tally, cone, from, direction, due, radius, out);
      const Vec3 off = normalized(r - y0 * axis);
      const double away = dot(r, off),
                   y = std::clamp((y0 + slope * (away - radius)) / (1 + slope * slope), -half, half);
      const Vec3 x = origin + y * axis + (radius + slope * y) * off;
      tally.nearest = std::max(tally.nearest, length(cone.nearest(from) - x) / radius);
    }
    tally.print("cone of slope " + std::to_string(slope), 500, 300);
  }
}

// Every hit is on the torus, and no nearer point of the line is; the line is sampled, because the closed form is a
// quartic.
TEST(profile_surface, revolved_arc_is_a_torus) {
  Draw draw;
  constexpr double radius = 10, small = 3;
  double on = 0, normal = 0, nearest = 0;
  int hits = 0, missed = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 origin = draw.direction(), axis = draw.direction();
    const RevolvedProfile torus(shape("arc", {small, small}), origin, axis, radius);
    const double tube = radius - small;
    // The outer half of the tube alone counts.
    const auto value = [&](const Vec3& x) {
      const Vec3 r = x - origin;
      const double y = dot(r, axis), away = length(r - y * axis);
      return away < tube ? 1 : std::hypot(y, away - tube) - small;
    };
    const Vec3 from = origin + draw.between(tube, 1.3 * radius) * draw.across(axis) + draw.between(-4, 4) * axis;
    const Vec3 direction = draw.direction();
    const auto t = torus.distance(from, direction, any);
    double sampled = INFINITY;
    constexpr double step = 1e-3, reach = 6;
    for (double k = 0; k < reach && !std::isfinite(sampled); k += step)
      for (const double sign : {-1.0, 1.0}) {
        const double a = value(from + sign * k * direction), b = value(from + sign * (k + step) * direction);
        if (a * b <= 0 && std::abs(a) < 0.1 && std::abs(b) < 0.1) sampled = std::min(sampled, k + step / 2);
      }
    if (!t || std::abs(*t) > reach - 1) {
      missed += std::isfinite(sampled) && sampled < reach - 1;
      continue;
    }
    ++hits;
    EXPECT_LT(std::abs(std::abs(*t) - sampled), 0.2) << "grazing lines apart the sampled hit is the same";
    const Vec3 x = from + *t * direction;
    on = std::max(on, std::abs(value(x)));
    const Vec3 r = x - origin, off = normalized(r - dot(r, axis) * axis);
    const Vec3 due = (1 / small) * (r - tube * off);
    normal = std::max(normal, length(torus.normal(from, direction, due).value_or(any) - due));
    if (value(from) < 1) {
      const Vec3 p = from - origin, q = tube * normalized(p - dot(p, axis) * axis);
      nearest = std::max(nearest, length(torus.nearest(from) - (origin + q + small * normalized(p - q))));
    }
  }
  expect_error("torus: hits over size", on / radius, 1e-12);
  expect_error("torus: normals", normal, 1e-9);
  expect_error("torus: nearest over size", nearest / radius, 1e-9);
  EXPECT_GT(hits, 500);
  EXPECT_LE(missed, 3) << "lines that graze it";
}

TEST(profile_surface, extruded_circle_and_line_are_cylinder_and_plane) {
  Draw draw;
  constexpr double radius = 12;
  for (const bool plane : {false, true}) {
    Tally tally;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 origin = 5.0 * draw.direction(), along = draw.direction(), z = draw.across(along);
      const Vec3 y = cross(z, along);
      const ExtrudedProfile body(shape(plane ? "line" : "arc", {radius, plane ? 0 : radius}), origin, along, z);
      const Vec3 from = origin + draw.between(0, 20) * draw.direction(), direction = draw.direction();
      const Vec3 r = from - origin;
      std::optional<double> due;
      Vec3 out = z;
      if (plane) {
        const double t = -dot(r, z) / dot(direction, z);
        if (std::abs(dot(r + t * direction, y)) <= radius) due = t;
      } else {
        const Vec3 c = r + radius * z, off = c - dot(c, along) * along;
        const Vec3 across = direction - dot(direction, along) * along;
        due = least_root(dot(across, across), dot(off, across), dot(off, off) - radius * radius,
                         [&](double t) { return dot(off + t * across, z) >= 0; });
        if (due) out = (1 / radius) * (off + *due * across);
      }
      compare(tally, body, from, direction, due, radius, out);
      if (plane) {
        const Vec3 x = origin + dot(r, along) * along + std::clamp(dot(r, y), -radius, radius) * y;
        tally.nearest = std::max(tally.nearest, length(body.nearest(from) - x) / radius);
      }
    }
    tally.print(plane ? "extruded line" : "extruded half circle", 300, 100);
  }
}

// A roller of radius 6 that ends at y = 5 and the bore of a ring are touched where they reach z = 0 when they are
// level.
TEST(profile_surface, normals_of_a_contact_meet_no_far_side) {
  constexpr double radius = 6, half = 5;
  for (const double tilt : {-1e-2, -5e-4, 5e-4, 1e-2})
    for (const double inside : {-1.0, 1.0})
      for (const double direction : {-1.0, 1.0}) {
        const RevolvedProfile body(shape("line", {half, 0}), {0, 0, -inside * radius},
                                   {0, std::cos(tilt), std::sin(tilt)}, radius);
        const Vec3 along{0, 0, direction}, facing{0, 0, inside};
        // One side of the roller is shorter at this height, the other is longer.
        const double end = half * std::cos(tilt), off = inside * radius * std::sin(tilt);
        for (const double side : {-1.0, 1.0}) {
          const double last = side * end - off;
          SurfaceHint hint;
          for (const double y : {last - side * 1e-6, last + side * 1e-6}) {
            const Vec3 from{0, y, 1e-4};
            const bool there = y != last + side * 1e-6;
            EXPECT_EQ(body.distance(from, along, facing).has_value(), there) << tilt << " " << inside << " " << y;
            EXPECT_EQ(body.distance_near(from, along, facing, hint).has_value(), there);
            EXPECT_EQ(body.normal(from, along, facing).has_value(), there);
            if (there) {
              EXPECT_LT(std::abs(*body.distance(from, along, facing)), 0.1);
            }
          }
        }
      }
}

TEST(profile_surface, lines_along_the_extrusion_miss) {
  const ExtrudedProfile body(shape("line", {1, 0}), {0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_FALSE(body.distance({0, 0, 1}, {1, 0, 0}, any));
  EXPECT_FALSE(body.normal({0, 2, 1}, {0, 0, 1}, any));
  EXPECT_EQ(body.normal({0, 0, 1}, {0, 0, 1}, {0, 0, -1}), (Vec3{0, 0, -1}));
}

}  // namespace
}  // namespace rollcon
