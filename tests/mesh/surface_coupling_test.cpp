/// Tests the way from tractions on one mesh to loads on another: patch test, force and moment, curved bodies, layers
/// that match, are finer, coarser or larger than the faces under them.

#include "geometry/surface_coupling.hpp"

#include "geometry/surface_search.hpp"
#include "mesh/corner_elements.hpp"
#include "mesh/surface_geometry.hpp"
#include "mesh/surface_quadrature.hpp"
#include "support/frames.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using frames::perturb;
using frames::rectangle;
using frames::uniform_lines;
using surfaces::all_types;
using surfaces::at;
using surfaces::name_of;

std::vector<std::int64_t> all_of(const SurfaceMesh& mesh) {
  std::vector<std::int64_t> face(at(mesh.elements()));
  std::iota(face.begin(), face.end(), 0);
  return face;
}

using Field = std::function<double(const Vec3&)>;

std::vector<double> nodal(const SurfaceMesh& mesh, const Field& field) {
  std::vector<double> t;
  for (const Vec3& x : mesh.node) t.push_back(field(x));
  return t;
}

double one(const Vec3&) {
  return 1;
}

/// Computes int N_i field over the mesh.
std::vector<double> integrals(const SurfaceMesh& mesh, const Field& field) {
  std::vector<double> f(at(mesh.nodes()), 0.0);
  integrate_surface(mesh, [&](std::int64_t e, const Shape& s, const Vec3& x, double area) {
    const auto nodes = mesh.element(e);
    for (std::size_t i = 0; i < nodes.size(); ++i) f[at(nodes[i])] += area * s.value[i] * field(x);
  });
  return f;
}

double largest(const std::vector<double>& v) {
  double most = 0;
  for (const double x : v) most = std::max(most, std::abs(x));
  return most;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// Couples a layer with all faces of a body.
struct Coupled {
  SurfaceMesh body, layer;
  SurfaceCoupling m;
  Coupled(SurfaceMesh below, SurfaceMesh above)
      : body(std::move(below)), layer(std::move(above)), m(couple_layer(body, all_of(body), layer)) {}

  /// Returns M t, by nodes of the body.
  std::vector<double> loads(const std::vector<double>& traction) const {
    std::vector<double> f(at(body.nodes()), 0.0);
    for (std::size_t r = 0; r < m.node.size(); ++r)
      for (std::int64_t k = m.start[r]; k < m.start[r + 1]; ++k)
        f[at(m.node[r])] += m.value[at(k)] * traction[at(m.row[at(k)])];
    return f;
  }
  /// Returns the difference of a field's loads from int N_i of it over the body, over the largest.
  double load_error(const Field& field = one) const {
    const std::vector<double> own = integrals(body, field);
    return difference(loads(nodal(layer, field)), own) / largest(own);
  }
  /// Returns that error for a field of 1, where wanted(x) alone.
  template <class Wanted>
  double load_error_where(Wanted&& wanted) const {
    const std::vector<double> f = loads(nodal(layer, one)), own = integrals(body, one);
    double error = 0;
    for (std::size_t i = 0; i < f.size(); ++i)
      if (wanted(body.node[i])) error = std::max(error, std::abs(f[i] - own[i]));
    return error / largest(own);
  }
  /// Returns the difference of the sum over i of M_ij from int N_j over the layer, over the largest.
  double column_error() const {
    const std::vector<double> expected = integrals(layer, one);
    std::vector<double> sum(at(layer.nodes()), 0.0);
    for (std::size_t k = 0; k < m.value.size(); ++k) sum[at(m.row[k])] += m.value[k];
    return difference(sum, expected) / largest(expected);
  }
  /// Returns the difference of force and moment about the origin of the layer's traction, constant along (1, -2, 3),
  /// from those of the loads, over area times size.
  double moment_error() const {
    const std::vector<double> f = loads(nodal(layer, one));
    Vec3 first{0, 0, 0}, expected{0, 0, 0};
    double area = 0, size = 0;
    for (std::size_t k = 0; k < f.size(); ++k) first = first + f[k] * body.node[k];
    integrate_surface(layer, [&](std::int64_t, const Shape&, const Vec3& x, double a) {
      expected = expected + a * x;
      area += a;
      size = std::max(size, length(x));
    });
    return length(cross(first - expected, {1, -2, 3})) / (area * size * length({1, -2, 3}));
  }
};

/// Makes [-w, w]^2 in nx x ny elements.
SurfaceMesh square(ElementType type, int nx, int ny, double w = 1) {
  return rectangle(type, uniform_lines(-w, w, nx), uniform_lines(-w, w, ny));
}

template <class Check>
void for_all_pairs(Check&& check) {
  for (const ElementType below : all_types)
    for (const ElementType above : all_types) check(below, above, name_of(above) + " on " + name_of(below));
}

Vec3 turned(const Vec3& p) {
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(-1.1), e = std::sin(-1.1);
  const Vec3 q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return {q[0] + 30, d * q[1] - e * q[2] - 20, e * q[1] + d * q[2] + 10};
}

TEST(SurfaceCoupling, PatchTestOnFlatMeshesOfAllTypes) {
  for (const double fraction : {0.0, 0.1, 0.25})
    for (const bool turn : {false, true}) {
      double faces = 0, columns = 0, moments = 0;
      for_all_pairs([&](ElementType below, ElementType above, const std::string& name) {
        const auto mesh = [&](ElementType type, int nx, int ny, std::uint32_t seed) {
          const SurfaceMesh m = perturb(square(type, nx, ny), fraction, seed);
          return turn ? frames::transform(m, turned) : m;
        };
        const Coupled c(mesh(below, 7, 6, 3), mesh(above, 9, 11, 5));
        EXPECT_LE(c.load_error(), 1e-12) << name;
        faces = std::max(faces, c.load_error());
        columns = std::max(columns, c.column_error());
        moments = std::max(moments, c.moment_error());
      });
      const std::string name =
          "all types on all, distorted by " + std::to_string(fraction) + (turn ? ", turned in space" : "");
      expect_error(name + ": loads", faces, 1e-12);
      expect_error(name + ": int N_j", columns, 1e-12);
      expect_error(name + ": moment", moments, 1e-12);
    }
}

TEST(SurfaceCoupling, LinearTractionsAreExactWhereTheLayerHoldsThem) {
  // Every layer interpolates these fields exactly.
  double flat = 0, distorted = 0;
  for_all_pairs([&](ElementType below, ElementType above, const std::string&) {
    for (const double fraction : {0.0, 0.2}) {
      const Coupled c(perturb(square(below, 5, 6), fraction, 1), perturb(square(above, 8, 7), fraction, 2));
      double& worst = fraction == 0 ? flat : distorted;
      worst = std::max(worst, c.load_error([](const Vec3& x) { return 0.3 + x[0] - 2 * x[1]; }));
    }
  });
  expect_error("linear traction, rectangles", flat, 1e-13);
  expect_error("linear traction, distorted", distorted, 1e-11);
}

TEST(SurfaceCoupling, MatchingMeshesGiveTheFacesOwnMatrix) {
  for (const ElementType type : all_types) {
    // The body is curved, with its nodes numbered backwards and the elements starting at another corner.
    const SurfaceMesh body = surfaces::cube_sphere(type, 3, 1);
    SurfaceMesh layer = body;
    const auto n = static_cast<std::int32_t>(body.nodes());
    std::reverse(layer.node.begin(), layer.node.end());
    for (std::int32_t& k : layer.connectivity) k = n - 1 - k;
    for (std::int64_t e = 0; e < layer.elements(); ++e) {
      const auto corners = static_cast<std::ptrdiff_t>(corner_count(type));
      const auto first = layer.connectivity.begin() + layer.offset[at(e)];
      std::rotate(first, first + 1, first + corners);
      if (is_quadratic(type)) std::rotate(first + corners, first + corners + 1, first + 2 * corners);
    }
    const SurfaceCoupling own = couple_faces(body, all_of(body));
    Coupled c(body, layer);
    const SurfaceCoupling& m = c.m;
    ASSERT_EQ(m.node, own.node);
    ASSERT_EQ(m.start, own.start);
    double worst = 0;
    for (std::size_t r = 0; r < m.node.size(); ++r)
      for (std::int64_t k = m.start[r]; k < m.start[r + 1]; ++k) {
        const auto first = own.row.begin() + own.start[r], last = own.row.begin() + own.start[r + 1];
        const auto found = std::lower_bound(first, last, n - 1 - m.row[at(k)]);
        ASSERT_TRUE(found != last && *found == n - 1 - m.row[at(k)]);
        worst = std::max(worst, std::abs(m.value[at(k)] - own.value[at(found - own.row.begin())]));
      }
    expect_error("matching " + name_of(type) + " on a sphere", worst / largest(own.value), 1e-14);
    // The matrix is symmetric, and its rows are int N_i.
    c.m = own;
    c.layer = body;
    expect_error("its row sums", c.load_error(), 1e-14);
  }
}

TEST(SurfaceCoupling, APartThatMatchesIsCoupledLikeTheRest) {
  // Half of the layer's elements are the body's; the other half is divided otherwise.
  for (const ElementType type : all_types) {
    const std::vector<double> half = uniform_lines(-1, 0, 4), fine = uniform_lines(0, 1, 7),
                              coarse = uniform_lines(0, 1, 5);
    const auto joined = [&](const std::vector<double>& right) {
      std::vector<double> x = half;
      x.insert(x.end(), right.begin() + 1, right.end());
      return rectangle(type, x, uniform_lines(-1, 1, 6));
    };
    expect_error("half of the layer matches, " + name_of(type), Coupled(joined(coarse), joined(fine)).load_error(),
                 1e-13);
  }
}

TEST(SurfaceCoupling, LayersSmallerAndLargerThanAnElement) {
  for_all_pairs([](ElementType below, ElementType above, const std::string& name) {
    // Layer elements lie within one face, across four, and one over a hundred faces.
    const SurfaceMesh body = square(below, 10, 10);
    const auto patch = [&](double x, double y, double w) {
      return rectangle(above, uniform_lines(x - w, x + w, 1), uniform_lines(y - w, y + w, 1));
    };
    for (const SurfaceMesh& layer :
         {patch(0.1, 0.1, 0.04), patch(0, 0, 0.03), patch(0.013, -0.2, 1e-5), patch(0, 0, 1)}) {
      const Coupled c(body, layer);
      EXPECT_LE(c.column_error(), 1e-13) << name;
      EXPECT_LE(c.moment_error(), 1e-13) << name;
    }
    EXPECT_LE(Coupled(body, patch(0, 0, 1)).load_error(), 1e-12) << name;
  });
}

TEST(SurfaceCoupling, SliversLoseNothing) {
  // Lines of the layer lie next to those of the faces, down to the last bit.
  for (const double aside : {1e-16, 1e-14, 1e-12, 1e-9, 1e-6}) {
    double faces = 0, columns = 0;
    for_all_pairs([&](ElementType below, ElementType above, const std::string&) {
      std::vector<double> x = uniform_lines(-1, 1, 6);
      for (std::size_t i = 1; i + 1 < x.size(); ++i) x[i] += (i % 2 == 0 ? aside : -aside);
      const Coupled c(square(below, 6, 6), rectangle(above, x, uniform_lines(-1, 1, 6)));
      faces = std::max(faces, c.load_error());
      columns = std::max(columns, c.column_error());
    });
    // Elements that differ by less than 1e-9 of their size count as the face itself.
    char name[64];
    std::snprintf(name, sizeof name, "lines %.0e aside", aside);
    expect_error(std::string(name) + ": loads", faces, aside < 1e-9 ? 1e-13 + 10 * aside : 1e-12);
    expect_error(std::string(name) + ": int N_j", columns, aside < 1e-9 ? 1e-13 + 10 * aside : 1e-13);
  }
}

TEST(SurfaceCoupling, WhatSticksOutGoesToTheNearestFace) {
  const SurfaceMesh body = square(ElementType::quad8, 4, 4);
  for (const ElementType above : all_types) {
    const Coupled c(body, rectangle(above, uniform_lines(-0.9, 1.3, 5), uniform_lines(-0.8, 0.7, 4)));
    expect_error("beyond the edge, " + name_of(above) + ": int N_j", c.column_error(), 1e-13);
    // The loads' first moment is that of the layer with all that lies beyond moved to the edge: int min(x, 1), 1.5
    // wide.
    const std::vector<double> f = c.loads(nodal(c.layer, one));
    double first = 0;
    for (std::size_t k = 0; k < f.size(); ++k) first += f[k] * body.node[k][0];
    expect_error("first moment", first - 1.5 * (0.5 * (1 - 0.81) + 0.3), 1e-12);
  }
  // The layer lies wholly beside the body, and over nothing but walls.
  const Coupled away(body, rectangle(ElementType::quad4, uniform_lines(3, 4, 2), uniform_lines(-0.5, 0.5, 2)));
  expect_error("beside the body: int N_j", away.column_error(), 1e-13);
  const std::vector<double> f = away.loads(nodal(away.layer, one));
  for (std::size_t k = 0; k < f.size(); ++k)
    if (body.node[k][0] < 1) {
      EXPECT_EQ(f[k], 0) << "not at its edge";
    }
}

TEST(SurfaceCoupling, FacesThatLookAwayOrLieDeepAreNotCoupled) {
  // The lower side of a thin plate looks away.
  const SurfaceMesh plate = surfaces::block(surfaces::brick({4, 4, 1}, {1, 1, 0.02}), ElementType::quad4);
  const auto lines = uniform_lines(0, 1, 3);
  Coupled c(plate, frames::transform(rectangle(ElementType::tri6, lines, lines), [](const Vec3& p) {
              return Vec3{p[0], p[1], 0.02};
            }));
  for (const std::int32_t k : c.m.node) EXPECT_EQ(plate.node[at(k)][2], 0.02);
  expect_error("a layer on a plate", c.column_error(), 1e-13);
  const std::vector<double> f = c.loads(nodal(c.layer, one));
  c.m = couple_faces(plate, surfaces::elements_with_tag(plate, 6));
  const std::vector<double> top = c.loads(nodal(plate, one));
  expect_error("loads", difference(f, top) / largest(top), 1e-12);
}

/// Bends a square to a cylinder or a sphere of radius 3.
Vec3 bent(bool sphere, const Vec3& p) {
  constexpr double r = 3;
  if (!sphere) return {r * std::sin(p[0] / r), p[1], r * std::cos(p[0] / r) - r};
  const double h = std::hypot(p[0], p[1]) / r, f = h > 0 ? std::sin(h) / h : 1;
  return {f * p[0], f * p[1], r * std::cos(h) - r};
}

TEST(SurfaceCoupling_long, CurvedBodiesConverge) {
  constexpr double w = 1.6;
  for (const bool sphere : {false, true})
    for_all_pairs([&](ElementType below, ElementType above, const std::string& pair) {
      double faces[3], moments[3];
      for (int k = 0; k < 3; ++k) {
        const auto mesh = [&](ElementType type, int nx, int ny) {
          return frames::transform(square(type, nx << k, ny << k, w), [&](const Vec3& p) { return bent(sphere, p); });
        };
        const SurfaceMesh body = mesh(below, 5, 4);
        SurfaceMesh layer = mesh(above, 6, 7);
        const SurfaceSearch search(body, {});
        for (Vec3& x : layer.node) x = search.nearest(x).x;
        const Coupled c(body, layer);
        EXPECT_LE(c.column_error(), 1e-12);
        const std::vector<double> f = c.loads(nodal(layer, one)), own = integrals(body, one);
        // The error is the root of the mean square, away from the rim, where both meshes end otherwise.
        double sum = 0, reference = 0;
        for (std::size_t i = 0; i < f.size(); ++i)
          if (std::abs(body.node[i][0]) < 0.7 * w && std::abs(body.node[i][1]) < 0.7 * w) {
            sum += std::pow(f[i] - own[i], 2);
            reference += std::pow(own[i], 2);
          }
        faces[k] = std::sqrt(sum / reference);
        moments[k] = c.moment_error();
      }
      const bool quadratic = is_quadratic(below) && is_quadratic(above);
      const std::string name = (sphere ? "sphere, " : "cylinder, ") + pair;
      // Linear facets lie h^2 off the surface; quadratic ones far less, but what is projected across their bent sides
      // is of order h^2 too.
      expect_error(name + ": loads", faces[2], quadratic ? 3e-5 : 2e-3);
      expect_order(name + ": loads", std::log2(faces[0] / faces[2]) / 2, quadratic ? 1.4 : 1.7);
      expect_error(name + ": moment", moments[2], quadratic ? 1e-6 : 2e-3);
      expect_order(name + ": moment", std::log2(moments[0] / moments[2]) / 2, quadratic ? 3.0 : 1.7);
    });
}

TEST(SurfaceCoupling, DiscsWithBentSides) {
  // Quadratic sides follow the rim of the layer: its whole area reaches the faces.
  for (const ElementType below : all_types) {
    const Coupled c(square(below, 13, 12), frames::paper_disc(ElementType::tri6, 0.9));
    expect_error("disc on " + name_of(below) + ": int N_j", c.column_error(), 1e-12);
    expect_error("moment", c.moment_error(), 1e-9);
    // Faces well inside are covered wholly.
    expect_error("loads inside", c.load_error_where([](const Vec3& x) { return length(x) < 0.5; }), 1e-12);
  }
}

TEST(SurfaceCoupling, SkewLayersOnWarpedFaces) {
  // Faces of a saddle, seen by a layer turned against them.
  const auto saddle = [](const Vec3& p) {
    return Vec3{p[0], p[1], 0.08 * (p[0] * p[0] - p[1] * p[1]) + 0.05 * p[0] * p[1]};
  };
  for_all_pairs([&](ElementType below, ElementType above, const std::string& name) {
    const SurfaceMesh body = frames::transform(square(below, 12, 12, 1.5), saddle);
    SurfaceMesh layer = frames::rotate(square(above, 10, 10, 0.9), 0.5);
    const SurfaceSearch search(body, {});
    for (Vec3& x : layer.node) x = search.along(x, {0, 0, 1}, {0, 0, 1})->x;
    const Coupled c(body, layer);
    EXPECT_LE(c.column_error(), 1e-12);
    expect_error("saddle, " + name, c.load_error_where([](const Vec3& x) { return std::hypot(x[0], x[1]) < 0.5; }),
                 4e-3);
  });
}

// Linear tractions on the corners of quadratic faces are exact, wherever the midside nodes are.
TEST(SurfaceCoupling, corners_of_quadratic_faces) {
  for (const ElementType type : {ElementType::tri6, ElementType::quad8, ElementType::quad9}) {
    const auto lines = uniform_lines(0, 2, 3);
    const SurfaceMesh body = perturb(rectangle(type, lines, lines), 0.1, 5);
    const Coupled c(body, corner_elements(body));
    EXPECT_TRUE(c.m.in_faces) << name_of(type);
    EXPECT_EQ(c.layer.type[0], linear_type(type));
    // The tractions follow the face's own coordinates, like its shape functions.
    std::vector<double> traction(body.node.size(), 0.0), expected(body.node.size(), 0.0);
    for (const std::int32_t k : c.layer.connectivity) traction[at(k)] = 1 + 0.3 * k;
    integrate_surface(body, [&](std::int64_t e, const Shape& s, const Vec3&, double area) {
      const auto nodes = body.element(e);
      double t = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        Shape linear;
        const ReferencePoint there = reference_nodes(type)[i];
        evaluate_shape(linear_type(type), there.xi, there.eta, linear);
        for (std::size_t j = 0; j < at(corner_count(type)); ++j)
          t += s.value[i] * linear.value[j] * traction[at(nodes[j])];
      }
      for (std::size_t i = 0; i < nodes.size(); ++i) expected[at(nodes[i])] += area * s.value[i] * t;
    });
    expect_error(name_of(type) + ": loads of linear tractions",
                 difference(c.loads(traction), expected) / largest(expected), 1e-13);
    const auto others = uniform_lines(0, 2, 4);
    EXPECT_FALSE(couple_layer(body, all_of(body), rectangle(ElementType::tri3, others, others)).in_faces);
  }
}

}  // namespace
}  // namespace rollcon
