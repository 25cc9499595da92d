/// Tests quadrature of volume elements: exact to the degree asked for, inside, positive.

#include "mesh/volume_shape.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

using surfaces::at;
using volumes::name_of;

constexpr VolumeType shapes[] = {VolumeType::tet4, VolumeType::wedge6, VolumeType::hex8};
constexpr int highest = 10;

double factorial(int n) {
  return std::tgamma(n + 1.0);
}
double on_line(int k) {
  return k % 2 == 1 ? 0 : 2.0 / (k + 1);
}

/// Returns the integral of xi^i eta^j zeta^k over the reference element.
double exact(VolumeType type, int i, int j, int k) {
  switch (corner_count(type)) {
    case 4:
      return factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3);
    case 6:
      return factorial(i) * factorial(j) / factorial(i + j + 2) * on_line(k);
    default:
      return on_line(i) * on_line(j) * on_line(k);
  }
}

bool promised(VolumeType type, int degree, int i, int j, int k) {
  switch (corner_count(type)) {
    case 4:
      return i + j + k <= degree;
    case 6:
      return i + j <= degree && k <= degree;
    default:
      return std::max({i, j, k}) <= degree;
  }
}

double integral(const VolumeRule& rule, int i, int j, int k) {
  double sum = 0;
  for (std::size_t p = 0; p < rule.size(); ++p)
    sum += rule.w[p] * std::pow(rule.point[p][0], i) * std::pow(rule.point[p][1], j) * std::pow(rule.point[p][2], k);
  return sum;
}

TEST(VolumeRule, ExactToItsDegree) {
  for (const VolumeType type : shapes)
    for (int degree = 0; degree <= highest; ++degree) {
      const VolumeRule rule = volume_rule(type, degree);
      double error = 0;
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; j <= degree; ++j)
          for (int k = 0; k <= degree; ++k)
            if (promised(type, degree, i, j, k))
              error = std::max(error, std::abs(integral(rule, i, j, k) - exact(type, i, j, k)));
      expect_error(
          name_of(type) + ", degree " + std::to_string(degree) + ", " + std::to_string(rule.size()) + " points",
          error / exact(type, 0, 0, 0), 4e-15);
    }
}

TEST(VolumeRule, NotExactBeyond) {
  // A rule that is exact for one degree more would be a waste, or the test above blind.
  for (const VolumeType type : shapes)
    for (const int degree : {1, 3, 5, 7}) {
      const VolumeRule rule = volume_rule(type, degree);
      double error = 0;
      const int d = degree + 1;
      for (int i = 0; i <= d; ++i)
        for (int j = 0; i + j <= d; ++j) {
          const int k = d - i - j;
          error = std::max(error, std::abs(integral(rule, i, j, k) - exact(type, i, j, k)));
        }
      EXPECT_GT(error, 1e-8) << name_of(type) << " degree " << degree;
    }
}

TEST(VolumeRule, PointsInsideWeightsPositive) {
  for (const VolumeType type : shapes)
    for (int degree = 0; degree <= highest; ++degree) {
      const VolumeRule rule = volume_rule(type, degree);
      ASSERT_EQ(rule.point.size(), rule.w.size());
      double least = 1;
      for (std::size_t p = 0; p < rule.size(); ++p) {
        const auto [x, y, z] = rule.point[p];
        least = std::min(least, rule.w[p]);
        if (corner_count(type) == 4)
          least = std::min({least, x, y, z, 1 - x - y - z});
        else if (corner_count(type) == 6)
          least = std::min({least, x, y, 1 - x - y, 1 - z, 1 + z});
        else
          least = std::min({least, 1 - x, 1 + x, 1 - y, 1 + y, 1 - z, 1 + z});
      }
      EXPECT_GT(least, 0) << name_of(type) << " degree " << degree;
    }
}

TEST(VolumeRule, NumbersOfPoints) {
  // The cost of a stiffness is proportional to the number of points.
  const auto points = [](VolumeType type, int degree) { return volume_rule(type, degree).size(); };
  EXPECT_EQ(points(VolumeType::tet10, 1), 1u);
  EXPECT_EQ(points(VolumeType::tet10, 2), 4u);
  EXPECT_EQ(points(VolumeType::tet10, 3), 8u);
  EXPECT_EQ(points(VolumeType::tet10, 4), 14u);
  EXPECT_EQ(points(VolumeType::tet10, 5), 14u);
  EXPECT_EQ(points(VolumeType::wedge15, 2), 6u);
  EXPECT_EQ(points(VolumeType::wedge15, 4), 18u);
  EXPECT_EQ(points(VolumeType::hex20, 3), 8u);
  EXPECT_EQ(points(VolumeType::hex20, 5), 27u);
}

TEST(VolumeRule, VolumesOfDistortedElements) {
  // The volume of one element of each type is compared with the cones over its own faces.
  for (const VolumeType type : volumes::all_types) {
    const auto mesh = volumes::transform(
        volumes::distort(volumes::block(surfaces::brick({2, 2, 2}, {1, 1.3, 0.8}), type), 0.1, 5), [](const Vec3& x) {
          return Vec3{x[0] + 0.2 * x[1] * x[2], x[1] - 0.1 * x[0] * x[2], x[2] + 0.15 * x[0] * x[1]};
        });
    double error = 0;
    for (std::int64_t e = 0; e < mesh.volume.elements(); ++e) {
      volumes::Mesh one;
      one.surface.node = mesh.surface.node;
      const auto nodes = mesh.volume.element(e);
      volumes::add_element(one.volume, type, nodes);
      for (const VolumeFace& f : faces_of(type)) {
        std::vector<std::int32_t> own;
        for (int i = 0; i < node_count(f.type); ++i) own.push_back(nodes[at(f.node[at(i)])]);
        surfaces::add_element(one.surface, f.type, own);
      }
      const surfaces::Facts facts = surfaces::facts(one.surface);
      const volumes::Filling filling = volumes::filling(one);
      EXPECT_GT(filling.volume, 0);
      error = std::max({error, std::abs(filling.volume / facts.volume - 1), length(filling.centroid - facts.centroid)});
    }
    expect_error("volume and centroid against the faces', " + name_of(type), error, 1e-13);
  }
}

}  // namespace
}  // namespace rollcon
