// Tests the stiffness of one element: rigid motions, rank, symmetry, invariance, units.

#include "bodies/fem/element_cases.hpp"
#include "bodies/model/mesh_models.hpp"
#include "linalg/lapack.hpp"
#include "support/testing.hpp"

namespace rollcon::fem {
namespace {

using elements::Formulation;
using elements::Nodes;
using elements::Stiffness;

const std::vector<double> ratios{-0.9, 0, 0.3, 0.499, 0.4999999};

std::vector<double> eigenvalues(Stiffness k) {
  const int n = static_cast<int>(k.n), length = 64 * n;
  std::vector<double> value(k.n), work(static_cast<std::size_t>(length));
  int info = 0;
  dsyev_("N", "L", &n, k.k.data(), &n, value.data(), work.data(), &length, &info);
  EXPECT_EQ(info, 0);
  return value;
}

class Element : public ::testing::TestWithParam<Formulation> {
 protected:
  std::vector<Nodes> shapes() const {
    const VolumeType type = GetParam().type;
    return {elements::box(type, {1, 1, 1}), elements::slanted(type), elements::distorted(type), elements::curved(type)};
  }
};

TEST_P(Element, resists_no_rigid_motion) {
  double worst = 0;
  for (const Nodes& x : shapes())
    for (double poisson : ratios) {
      const Stiffness k = elements::stiffness(GetParam(), x, poisson);
      for (std::size_t motion = 0; motion < 6; ++motion) {
        Vec3 axis{};
        axis[motion % 3] = 1;
        const auto u = elements::at_nodes(x, [&](const Vec3& p) { return motion < 3 ? axis : cross(axis, p); });
        for (double force : k.times(u)) worst = std::max(worst, std::abs(force) / k.largest());
      }
    }
  expect_error(GetParam().name() + ", force of rigid motions", worst, 1e-13);
}

TEST_P(Element, has_six_zero_eigenvalues_and_no_more) {
  double zero = 0, least = 1;
  for (const Nodes& x : shapes())
    for (double poisson : ratios) {
      const std::vector<double> value = eigenvalues(elements::stiffness(GetParam(), x, poisson));
      for (std::size_t i = 0; i < 6; ++i) zero = std::max(zero, std::abs(value[i]) / value.back());
      // The softest mode is one of shear, the stiffest one of compression.
      const double hardness = 2 * (1 + poisson) / (3 * (1 - 2 * poisson));
      least = std::min(least, value[6] / value.back() * std::max(1.0, hardness));
    }
  expect_error(GetParam().name() + ", largest of six eigenvalues", zero, 1e-14);
  report(GetParam().name() + ", the seventh, times bulk over shear modulus", least);
  EXPECT_GT(least, 2e-5);
}

// Eigenvalues of bricks of aspect a spread over a^4; a further zero one would be as large as the sixth.
TEST_P(Element, keeps_its_rank_when_flat_or_slender) {
  const double thin = 1e-3;
  double worst = 0;
  for (const Vec3& edge : {Vec3{thin, 1, 1}, Vec3{1, thin, 1}, Vec3{1, 1, thin}, Vec3{1, thin, thin},
                           Vec3{thin, 1, thin}, Vec3{thin, thin, 1}, Vec3{1, 0.03, thin}}) {
    const Nodes x = elements::box(GetParam().type, edge);
    const std::vector<double> value = eigenvalues(elements::stiffness(GetParam(), x, 0.3));
    worst = std::max(worst, std::abs(value[5]) / value[6]);
  }
  expect_error(GetParam().name() + " of aspect 1000, sixth over seventh eigenvalue", worst, 0.1);
}

TEST_P(Element, is_symmetric_to_the_last_bit) {
  for (const Nodes& x : shapes())
    for (double poisson : ratios) {
      const Stiffness k = elements::stiffness(GetParam(), x, poisson);
      for (std::size_t r = 0; r < k.n; ++r)
        for (std::size_t c = 0; c < r; ++c) ASSERT_EQ(k(r, c), k(c, r)) << r << ' ' << c;
    }
}

TEST_P(Element, turns_with_its_nodes) {
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.9), t = std::sin(1.9);
  const double turn[3][3] = {{c, -s * d, s * t}, {s, c * d, -c * t}, {0, t, d}};
  const auto turned = [&](const Vec3& p) {
    Vec3 q{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) q[a] += turn[a][b] * p[b];
    return q;
  };
  for (double poisson : {0.3, 0.4999}) {
    const Nodes x = elements::curved(GetParam().type);
    Nodes y;
    for (const Vec3& node : x) y.push_back(turned(node));
    const Stiffness k = elements::stiffness(GetParam(), x, poisson);
    std::vector<double> expected(k.k.size(), 0.0);
    for (std::size_t i = 0; i < k.n; i += 3)
      for (std::size_t j = 0; j < k.n; j += 3)
        for (std::size_t a = 0; a < 9; ++a)
          for (std::size_t b = 0; b < 9; ++b)
            expected[(i + a / 3) * k.n + j + b / 3] +=
                turn[a / 3][a % 3] * k(i + a % 3, j + b % 3) * turn[b / 3][b % 3];
    expect_error(GetParam().name() + " turned" + elements::with(poisson),
                 elements::difference(elements::stiffness(GetParam(), y, poisson).k, expected), 1e-12);
  }
}

/// Returns numberings of the corners that describe the same element: those of two rotations of it.
std::vector<std::vector<int>> renumberings(VolumeType type) {
  switch (corner_count(type)) {
    case 4:
      return {{1, 2, 0, 3}, {1, 0, 3, 2}};
    case 6:
      return {{1, 2, 0, 4, 5, 3}, {3, 5, 4, 0, 2, 1}};
    default:
      return {{1, 2, 3, 0, 5, 6, 7, 4}, {1, 5, 6, 2, 0, 4, 7, 3}};
  }
}

/// Returns all nodes; midside nodes follow their edges.
std::vector<std::size_t> all_nodes(VolumeType type, const std::vector<int>& corner) {
  std::vector<std::size_t> node(corner.begin(), corner.end());
  if (!is_quadratic(type)) return node;
  const auto edges = edges_of(type);
  for (const auto& edge : edges) {
    const int p = corner[static_cast<std::size_t>(edge[0])];
    const int q = corner[static_cast<std::size_t>(edge[1])];
    const auto same = std::find_if(edges.begin(), edges.end(), [&](const auto& other) {
      return (other[0] == p && other[1] == q) || (other[0] == q && other[1] == p);
    });
    node.push_back(corner.size() + static_cast<std::size_t>(same - edges.begin()));
  }
  return node;
}

TEST_P(Element, does_not_care_where_numbering_starts) {
  const VolumeType type = GetParam().type;
  const Nodes x = elements::curved(type);
  double worst = 0;
  for (const auto& corner : renumberings(type)) {
    const std::vector<std::size_t> from = all_nodes(type, corner);
    Nodes y;
    for (std::size_t i : from) y.push_back(x[i]);
    for (double poisson : {0.3, 0.4999}) {
      const Stiffness k = elements::stiffness(GetParam(), x, poisson);
      std::vector<double> expected;
      for (std::size_t r = 0; r < k.n; ++r)
        for (std::size_t c = 0; c < k.n; ++c) expected.push_back(k(3 * from[r / 3] + r % 3, 3 * from[c / 3] + c % 3));
      const Stiffness renumbered = elements::stiffness(GetParam(), y, poisson);
      worst = std::max(worst, elements::difference(renumbered.k, expected));
    }
  }
  expect_error(GetParam().name() + " renumbered", worst, 1e-13);
}

TEST_P(Element, is_as_stiff_in_any_unit_and_place) {
  const Nodes x = elements::curved(GetParam().type);
  const Stiffness k = elements::stiffness(GetParam(), x, 0.3);
  double worst = 0;
  for (double unit : {1e-120, 1e-25, 25.4, 1e25, 1e120}) {
    Nodes y;
    for (const Vec3& node : x) y.push_back(unit * node);
    Stiffness scaled = elements::stiffness(GetParam(), y, 0.3);
    for (double& entry : scaled.k) entry /= unit;
    worst = std::max(worst, elements::difference(scaled.k, k.k));
  }
  expect_error(GetParam().name() + " in other units", worst, 1e-13);
  Nodes far;
  for (const Vec3& node : x) far.push_back(node + Vec3{4096, -2048, 1024});  // this costs 12 bits
  expect_error(GetParam().name() + " far from the origin",
               elements::difference(elements::stiffness(GetParam(), far, 0.3).k, k.k), 1e-11);
}

TEST_P(Element, stays_finite_when_flattened) {
  double worst = 0;
  for (double thin : {1e-6, 1e-9})
    for (std::size_t a = 0; a < 3; ++a) {
      Nodes x = elements::distorted(GetParam().type);
      for (Vec3& node : x) node[a] *= thin;
      const Stiffness k = elements::stiffness(GetParam(), x, 0.3);
      for (std::size_t motion = 0; motion < 3; ++motion) {
        Vec3 step{};
        step[motion] = 1;
        for (double force : k.times(elements::at_nodes(x, [&](const Vec3&) { return step; }))) {
          const double error = std::abs(force) / k.largest();
          if (!(error <= worst)) worst = error;
        }
      }
    }
  expect_error(GetParam().name() + " of aspect 1e9, force of a translation", worst, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Fem, Element, ::testing::ValuesIn(elements::all),
                         [](const auto& param) { return param.param.name(); });

TEST(ElementLimits, refuse_what_locks) {
  for (const Formulation& f : elements::all) {
    const bool locks = f.type == VolumeType::tet4 || f.type == VolumeType::wedge6;
    EXPECT_EQ(largest_poisson(f.type), locks ? 0.45 : 0.4999999) << f.name();
  }
}

}  // namespace
}  // namespace rollcon::fem
