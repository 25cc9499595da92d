/// Compares points on surfaces with closed forms and with a sweep over all elements, through edges and nodes, near and
/// far.

#include "geometry/surface_search.hpp"

#include <chrono>
#include <random>
#include <thread>

#include "mesh/surface_geometry.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using surfaces::all_types;
using surfaces::name_of;
constexpr Vec3 any{0, 0, 0};

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return normalized({normal(random), normal(random), normal(random)});
}

/// Returns where a line meets the surface, which it must.
SurfacePoint met(const SurfaceSearch& search, const Vec3& from, const Vec3& direction, const Vec3& facing = any) {
  const auto hit = search.along(from, direction, facing);
  EXPECT_TRUE(hit);
  return hit.value_or(SurfacePoint{});
}

bool within(const SurfaceMesh& mesh, const SurfacePoint& p) {
  if (corner_count(mesh.type[static_cast<std::size_t>(p.element)]) == 3)
    return p.xi >= 0 && p.eta >= 0 && p.xi + p.eta <= 1 + 1e-15;
  return std::abs(p.xi) <= 1 && std::abs(p.eta) <= 1;
}

/// Checks what every answer must satisfy of itself: point and normal are those of the element there, on the line at
/// that distance. Returns the largest error over the element's size.
double own_error(const SurfaceMesh& mesh, const SurfacePoint& p, const Vec3& from, const Vec3& direction) {
  EXPECT_TRUE(within(mesh, p));
  const SurfaceFrame f = evaluate_surface(mesh, p.element, p.xi, p.eta);
  const double size = element_diameter(mesh, p.element);
  return std::max({length(f.x - p.x) / size, length(from + p.distance * direction - p.x) / size,
                   length(normalized(f.normal) - p.normal)});
}

/// Returns a sphere with every node moved at random, midside nodes too.
SurfaceMesh rough_ball(ElementType type, int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> bump(-0.15, 0.15);
  SurfaceMesh mesh = surfaces::cube_sphere(type, n, 1);
  for (Vec3& x : mesh.node)
    for (double& c : x) c += bump(random) / n;
  return mesh;
}

/// Cuts elements finely into facets, and finds where a line meets those, without Newton's method and tree.
class Facets {
 public:
  Facets(const SurfaceMesh& mesh, int n) {
    for (std::int64_t e = 0; e < mesh.elements(); ++e) {
      const bool triangle = corner_count(mesh.type[static_cast<std::size_t>(e)]) == 3;
      auto point = [&](int i, int j) {
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        return triangle ? evaluate_surface(mesh, e, u, v).x : evaluate_surface(mesh, e, 2 * u - 1, 2 * v - 1).x;
      };
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < (triangle ? n - i : n); ++j) {
          facet_.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
          if (!triangle || i + j + 1 < n) facet_.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
        }
    }
  }

  /// Returns the cuts in ascending order.
  std::vector<double> cuts(const Vec3& from, const Vec3& direction) const {
    std::vector<double> found;
    for (const auto& [a, b, c] : facet_) {
      const Vec3 p = b - a, q = c - a, h = cross(direction, q);
      const double det = dot(p, h);
      if (det == 0) continue;
      const Vec3 s = from - a, k = cross(s, p);
      const double u = dot(s, h) / det, v = dot(direction, k) / det;
      if (u >= 0 && v >= 0 && u + v <= 1) found.push_back(dot(q, k) / det);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  std::vector<std::array<Vec3, 3>> facet_;
};

TEST(SurfaceSearch, LinesMeetWhatASweepOverAllFacetsMeets) {
  for (ElementType type : all_types) {
    double own = 0, sagitta = 0;
    int hits = 0, lines = 0, near_misses = 0;
    const int n = type == ElementType::tri3 ? 1 : 24;
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const SurfaceMesh mesh = rough_ball(type, 3, seed);
      const SurfaceSearch search(mesh, {});
      const Facets facets(mesh, n);
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> place(-1.3, 1.3);
      for (int i = 0; i < 60; ++i) {
        const Vec3 from{place(random), place(random), place(random)};
        const Vec3 d = random_direction(random);
        const Vec3 facing = i % 2 == 0 ? any : i % 4 == 1 ? d : -1.0 * d;
        // Entering and leaving cuts alternate along the line.
        const std::vector<double> all = facets.cuts(from, d);
        double least = std::numeric_limits<double>::infinity(), closest_pair = least;
        for (std::size_t k = 0; k < all.size(); ++k) {
          if (k > 0) closest_pair = std::min(closest_pair, all[k] - all[k - 1]);
          const bool leaving = k % 2 == 1;
          if (i % 2 == 1 && leaving != (i % 4 == 1)) continue;
          if (std::abs(all[k]) < std::abs(least)) least = all[k];
        }
        // Facets and surface may differ in what they meet where a line grazes the surface.
        if (all.size() % 2 != 0 || closest_pair < 0.02) {
          ++near_misses;
          continue;
        }
        ++lines;
        const auto hit = search.along(from, d, facing);
        ASSERT_EQ(hit.has_value(), !all.empty()) << name_of(type) << " seed " << seed << " " << i;
        if (!hit) continue;
        ++hits;
        own = std::max(own, own_error(mesh, *hit, from, d));
        sagitta = std::max(sagitta, std::abs(std::abs(hit->distance) - std::abs(least)));
        if (i % 2 == 1) {
          EXPECT_GT(dot(hit->normal, facing), 0);
        }
      }
    }
    EXPECT_GT(hits, 60);
    EXPECT_LT(near_misses, lines / 4);
    expect_error("rough ball " + name_of(type) + ", own error of " + std::to_string(hits) + " hits / element", own,
                 1e-12);
    expect_error("distance against the facets'", sagitta, type == ElementType::tri3 ? 1e-13 : 2e-3);
  }
}

TEST(SurfaceSearch, NearestPointIsNoFartherThanAnyOther) {
  for (ElementType type : all_types) {
    double own = 0, excess = -1, normality = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const SurfaceMesh mesh = rough_ball(type, 3, seed);
      const SurfaceSearch search(mesh, {});
      std::mt19937 random(seed + 100);
      std::uniform_real_distribution<double> place(-1.6, 1.6);
      for (int i = 0; i < 60; ++i) {
        Vec3 x{place(random), place(random), place(random)};
        if (i % 4 == 0) x = (0.99 / length(x)) * x;  // close to the surface
        const SurfacePoint p = search.nearest(x);
        EXPECT_TRUE(within(mesh, p));
        const SurfaceFrame f = evaluate_surface(mesh, p.element, p.xi, p.eta);
        const double size = element_diameter(mesh, p.element);
        own = std::max({own, length(f.x - p.x) / size, std::abs(length(x - p.x) - p.distance),
                        length(normalized(f.normal) - p.normal)});
        // The way to the point is along the normal inside an element.
        const bool triangle = corner_count(mesh.type[static_cast<std::size_t>(p.element)]) == 3;
        const double edge =
            triangle ? std::min({p.xi, p.eta, 1 - p.xi - p.eta}) : 1 - std::max(std::abs(p.xi), std::abs(p.eta));
        if (edge > 1e-3)
          normality = std::max({normality, std::abs(dot(x - p.x, normalized(f.d_xi))) / size,
                                std::abs(dot(x - p.x, normalized(f.d_eta))) / size});
        double least = std::numeric_limits<double>::infinity();
        constexpr int n = 12;
        for (std::int64_t e = 0; e < mesh.elements(); ++e)
          for (int u = 0; u <= n; ++u)
            for (int v = 0; v <= (triangle ? n - u : n); ++v) {
              const double a = static_cast<double>(u) / n, b = static_cast<double>(v) / n;
              const SurfaceFrame g =
                  triangle ? evaluate_surface(mesh, e, a, b) : evaluate_surface(mesh, e, 2 * a - 1, 2 * b - 1);
              least = std::min(least, length(g.x - x));
            }
        excess = std::max(excess, p.distance - least);
      }
    }
    expect_error("rough ball " + name_of(type) + ", own error of nearest points", own, 1e-13);
    expect_error("foot of the normal / element", normality, 1e-12);
    EXPECT_LE(excess, 1e-14) << "a point of the lattice is nearer";
  }
}

TEST(SurfaceSearch, PointsOfTheSurfaceFindThemselves) {
  for (ElementType type : all_types) {
    const SurfaceMesh mesh = rough_ball(type, 4, 9);
    const SurfaceSearch search(mesh, {});
    double at = 0, beside = 0;
    for (std::int64_t e = 0; e < mesh.elements(); ++e) {
      const SurfaceFrame f = evaluate_surface(mesh, e, 0.31, 0.17);
      const double size = element_diameter(mesh, e);
      const Vec3 n = normalized(f.normal);
      const SurfacePoint p = search.nearest(f.x);
      EXPECT_EQ(p.element, e);
      at = std::max({at, p.distance / size, std::abs(p.xi - 0.31), std::abs(p.eta - 0.17)});
      const SurfacePoint q = search.nearest(f.x + 1e-3 * size * n);
      beside = std::max({beside, std::abs(q.distance / size - 1e-3), std::abs(q.xi - 0.31), std::abs(q.eta - 0.17)});
      const SurfacePoint hit = met(search, f.x, n);
      at = std::max({at, std::abs(hit.distance) / size, std::abs(hit.xi - 0.31)});
    }
    expect_error("points on a rough ball, " + name_of(type), at, 1e-13);
    expect_error("points beside it", beside, 1e-12);
  }
}

TEST(SurfaceSearch, NothingSlipsThroughEdgesAndNodes) {
  // Lines from within go through every node, and through points of every edge: along the axis exactly representable,
  // then turned, so that both elements miss by rounding.
  for (ElementType type : all_types)
    for (double turn : {0.0, 0.7}) {
      SurfaceMesh mesh = surfaces::transform(surfaces::cube_sphere(type, 4, 1), [turn](const Vec3& x) {
        return Vec3{std::cos(turn) * x[0] - std::sin(turn) * x[1], std::sin(turn) * x[0] + std::cos(turn) * x[1], x[2]};
      });
      const SurfaceSearch search(mesh, {});
      double error = 0;
      int lines = 0;
      auto shoot = [&](const Vec3& target, double size) {
        for (const Vec3& from : {Vec3{0, 0, 0}, Vec3{0.1, -0.2, 0.05}, 3.0 * target}) {
          const Vec3 d = normalized(target - from);
          // The hit is the target, outwards from within and inwards from outside.
          error = std::max(error, length(met(search, from, d, target).x - target) / size);
          ++lines;
        }
      };
      for (std::int64_t e = 0; e < mesh.elements(); ++e) {
        const double size = element_diameter(mesh, e);
        const auto at = reference_nodes(mesh.type[static_cast<std::size_t>(e)]);
        const auto corners = static_cast<std::size_t>(corner_count(mesh.type[static_cast<std::size_t>(e)]));
        for (std::int32_t k : mesh.element(e)) shoot(mesh.node[static_cast<std::size_t>(k)], size);
        for (std::size_t i = 0; i < corners; ++i) {
          const ReferencePoint p = at[i], q = at[(i + 1) % corners];
          const double s = 0.37;
          shoot(evaluate_surface(mesh, e, p.xi + s * (q.xi - p.xi), p.eta + s * (q.eta - p.eta)).x, size);
        }
      }
      expect_error(std::to_string(lines) + " lines through edges and nodes, " + name_of(type) + ", miss / element",
                   error, 1e-12);
    }
}

TEST(SurfaceSearch, ToleranceBeyondAnEdgeIsThatOfTheHeader) {
  // A line 1e-10 beyond the edge of a single square meets it, one 1e-8 beyond does not.
  for (double unit : {1e-9, 1.0, 1e9})
    for (ElementType type : all_types) {
      const bool triangle = corner_count(type) == 3;
      const auto mesh = surfaces::one_element(type, [unit](const Vec3& r) { return unit * r; });
      const double edge = triangle ? 0 : -1;
      const SurfaceSearch search(mesh, {});
      for (const auto& [beyond, met] : {std::pair{0.0, true}, {5e-10, true}, {1e-8, false}}) {
        const auto hit = search.along({unit * (edge - beyond), unit * 0.25, unit * 5}, {0, 0, 1}, {0, 0, 1});
        EXPECT_EQ(hit.has_value(), met) << name_of(type) << " " << beyond;
        if (!hit) continue;
        EXPECT_NEAR(hit->distance / unit, -5, 1e-9);
        EXPECT_EQ(hit->xi, edge);
      }
      EXPECT_FALSE(search.along({unit * 0.2, unit * 0.2, unit * 5}, {0, 0, 1}, {0, 0, -1})) << "it looks the other way";
      EXPECT_FALSE(search.along({unit * 0.2, unit * 0.2, unit * 5}, {0, 0, 1}, {1, 0, 0}))
          << "its normal has no component there";
    }
}

TEST(SurfaceSearch, CubesAreMetExactly) {
  for (ElementType type : all_types) {
    const SurfaceMesh mesh = surfaces::block(surfaces::brick({4, 4, 4}, {1, 1, 1}), type);
    const SurfaceSearch search(mesh, {});
    constexpr Vec3 up{0, 0, 1}, low{0.3, 0.4, 0.2}, along{1, 0, 0}, against{-1, 0, 0};
    expect_error("cube " + name_of(type) + ", up to the top", met(search, {0.3, 0.4, 0.8}, up).distance - 0.2, 1e-15);
    // The least |t| may lie behind; facing asks for the one in front or the one behind.
    expect_error("down to the bottom", met(search, low, up).distance + 0.2, 1e-15);
    expect_error("the one that looks up", met(search, low, up, up).distance - 0.8, 1e-15);
    // A line within the top face, and one along an edge of the cube, are met at the ends.
    expect_error("in the plane of a face", length(met(search, {-1, 0.3, 1}, along, against).x - Vec3{0, 0.3, 1}),
                 1e-15);
    expect_error("along an edge", length(met(search, {-1, 0, 1}, along, against).x - Vec3{0, 0, 1}), 1e-15);
    EXPECT_FALSE(search.along({-1, 0.3, 1.001}, along, any));
    // The face that looks best towards `facing` is taken at an edge between faces.
    const Vec3 down = normalized({0, 1, -1});
    EXPECT_NEAR(met(search, {0.5, -1, 2}, down, {0, -0.1, 1}).normal[2], 1, 1e-12);
    EXPECT_NEAR(met(search, {0.5, -1, 2}, down, {0, -1, 0.1}).normal[1], -1, 1e-12);
    // The nearest point lies on a face, an edge, or a corner.
    expect_error("nearest on a face", search.nearest({0.3, 0.4, 1.5}).distance - 0.5, 1e-15);
    expect_error("nearest on an edge", length(search.nearest({0.3, 2, 2}).x - Vec3{0.3, 1, 1}), 1e-14);
    expect_error("nearest at a corner", length(search.nearest({2, 2, 2}).x - Vec3{1, 1, 1}), 1e-15);
  }
}

TEST(SurfaceSearch, ABulgeIsMetOnBothItsSides) {
  // One strongly curved element is met twice by lines across it: all intersections are known.
  const auto mesh = surfaces::one_element(ElementType::quad9, [](const Vec3& r) {
    return Vec3{r[0], r[1], 2 * (1 - r[0] * r[0])};
  });
  const SurfaceSearch search(mesh, {});
  double error = 0;
  for (double z : {1e-6, 0.1, 0.5, 1.0, 1.9, 1.99, 1.9999, 1.999999}) {
    const double x = std::sqrt(1 - z / 2);
    for (double sign : {-1.0, 1.0}) {
      const auto hit = met(search, {0.001, 0.2, z}, {1, 0, 0}, {sign, 0, 0});
      error = std::max(error, std::abs(hit.distance + 0.001 - sign * x));
    }
  }
  expect_error("both sides of a parabola", error, 1e-12);
  // The line touches at the top, or passes just above it.
  expect_error("touching, square of the error", std::pow(met(search, {-3, 0.2, 2}, {1, 0, 0}).x[0], 2), 1e-12);
  EXPECT_FALSE(search.along({-3, 0.2, 2.00001}, {1, 0, 0}, any));
}

TEST(SurfaceSearch, ASaddleIsMetTwice) {
  // The surface z = xy over a square, cut along its diagonal at height s^2, is met at x = y = s and -s.
  for (ElementType type : {ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    const auto mesh = surfaces::one_element(type, [](const Vec3& r) { return Vec3{r[0], r[1], r[0] * r[1]}; });
    const SurfaceSearch search(mesh, {});
    const Vec3 d = normalized({1, 1, 0});
    double error = 0;
    for (double s : {1.0, 0.9, 0.5, 0.1, 1e-3})
      for (double sign : {-1.0, 1.0})
        for (double from : {-2.0, 0.01, 0.7}) {
          // The normal (-y, -x, 1) looks along -d where x = y > 0.
          const auto hit = met(search, {from, from, s * s}, d, -sign * d);
          error = std::max(error, length(hit.x - Vec3{sign * s, sign * s, s * s}));
        }
    expect_error("saddle " + name_of(type), error, 1e-12);
  }
}

TEST(SurfaceSearch, FarAwaySmallAndLarge) {
  for (double unit : {1e-9, 1e9})
    for (ElementType type : all_types) {
      const SurfaceMesh mesh =
          surfaces::transform(surfaces::cube_sphere(type, 3, 1), [unit](const Vec3& x) { return unit * x; });
      const SurfaceSearch search(mesh, {});
      std::mt19937 random(3);
      double error = 0;
      for (int i = 0; i < 50; ++i) {
        const Vec3 d = random_direction(random);
        const Vec3 far = met(search, (1e4 * unit) * d, -1.0 * d, d).x;
        error = std::max(error, length(far - met(search, 0.5 * unit * d, d, d).x) / unit);
      }
      expect_error("from 10,000 radii away, unit " + std::to_string(unit) + " " + name_of(type), error, 1e-11);
    }
}

TEST(SurfaceSearch, OnlyTheGivenElements) {
  const SurfaceMesh mesh = surfaces::block(surfaces::brick({4, 4, 4}, {1, 1, 1}), ElementType::quad8);
  const std::vector<std::int64_t> bottom = surfaces::elements_with_tag(mesh, 5);
  ASSERT_EQ(bottom.size(), 16u);
  const SurfaceSearch search(mesh, bottom);
  expect_error("the bottom alone", met(search, {0.3, 0.4, 0.9}, {0, 0, 1}).distance + 0.9, 1e-15);
  expect_error("nearest on it", search.nearest({0.3, 0.4, 0.9}).distance - 0.9, 1e-15);
}

TEST(SurfaceSearch, ThreadsAgree) {
  const SurfaceMesh mesh = rough_ball(ElementType::quad8, 5, 2);
  const SurfaceSearch search(mesh, {});
  std::vector<std::vector<double>> answer(4);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < 4; ++k)
    threads.emplace_back([&search, &answer, k] {
      std::mt19937 random(5);
      for (int i = 0; i < 300; ++i) {
        const Vec3 d = random_direction(random);
        answer[k].push_back(search.along({0, 0, 0}, d, d)->distance);
        answer[k].push_back(search.nearest(2.0 * d).distance);
      }
    });
  for (std::thread& t : threads) t.join();
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(answer[k], answer[0]);
}

TEST(SurfaceSearch_long, AHundredThousandElements) {
  // The time per query grows with the logarithm of the size: a search through all would take a hundredfold.
  double line[2], nearest[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const SurfaceMesh mesh = surfaces::cube_sphere(ElementType::quad8, k == 0 ? 13 : 130, 1);
    const SurfaceSearch search(mesh, {});
    std::mt19937 random(1);
    double worst = 0;
    const auto seconds_of = [&](auto&& error) {
      const auto before = std::chrono::steady_clock::now();
      for (int i = 0; i < 4000; ++i) worst = std::max(worst, std::abs(error(random_direction(random))));
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    };
    line[k] = seconds_of([&](const Vec3& d) { return length(met(search, {0.1, 0.2, 0.3}, d, d).x) - 1; });
    nearest[k] = seconds_of([&](const Vec3& d) { return search.nearest(1.01 * d).distance - 0.01; });
    expect_error("radius", worst, k == 0 ? 1e-4 : 1e-7);
  }
  expect_error("lines: time for a hundred times the elements", line[1] / line[0], 40);
  expect_error("nearest: time for a hundred times the elements", nearest[1] / nearest[0], 40);
}

}  // namespace
}  // namespace rollcon
