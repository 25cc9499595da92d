// Tests stresses of finite elements under known displacements and loads: uniform ones on bricks of all elements, and
// Lame's thick cylinder at nodes, integration points and any points.

#include <random>

#include "bodies/body_results.hpp"
#include "mesh/volume_shape.hpp"
#include "support/index.hpp"
#include "support/static_cases.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace walls = statics::walls;
using statics::StaticBody;
using Stress = std::array<double, 6>;

constexpr VolumeType types[] = {VolumeType::tet4,    VolumeType::tet10, VolumeType::wedge6,
                                VolumeType::wedge15, VolumeType::hex8,  VolumeType::hex20};

struct Fields {
  std::vector<double> u, node, point, xyz;
};

Fields fields_of(StaticBody& body) {
  Fields f;
  const std::int64_t nodes = body.mesh().nodes(), points = body_stress_points(body.body());
  f.u.resize(3 * at(nodes)), f.node.resize(6 * at(nodes)), f.point.resize(6 * at(points)), f.xyz.resize(3 * at(points));
  body_displacements(body.body(), nodes, f.u.data());
  body_node_stresses(body.body(), {nodes, nullptr}, f.node.data());
  body_point_stresses(body.body(), {nodes, f.u.data()}, f.point.data(), f.xyz.data());
  return f;
}

/// Returns the largest difference of n stresses from those at x.
template <class Exact>
double error_of(const std::vector<double>& stress, const std::vector<double>& x, Exact&& exact) {
  double most = 0;
  for (std::size_t p = 0; p < x.size() / 3; ++p) {
    const Stress s = exact({x[3 * p], x[3 * p + 1], x[3 * p + 2]});
    for (std::size_t c = 0; c < 6; ++c) most = std::max(most, std::abs(stress[6 * p + c] - s[c]));
  }
  return most;
}

std::vector<double> places(const SurfaceMesh& mesh) {
  std::vector<double> x;
  for (const Vec3& node : mesh.node) x.insert(x.end(), node.begin(), node.end());
  return x;
}

TEST(BodyStresses, uniform_ones_are_exact) {
  if (absent(VolumeType::hex8)) GTEST_SKIP() << "not in this build";
  for (const VolumeType type : types)
    for (const auto& [name, stress] : statics::uniform_stresses) {
      surfaces::Block shape = surfaces::brick({2, 3, 2}, {1, 1.5, 0.8});
      shape.map = [](const Vec3& q) {  // slanted and uneven, faces flat
        return Vec3{q[0] + 0.3 * q[0] * q[1] + 0.2 * q[2], q[1] + 0.1 * q[2], q[2]};
      };
      StaticBody body(shape, type, 1000, 0.3);
      const statics::UniformStress exact(stress, 1000, 0.3);
      statics::give(body, statics::Given::displacements, exact);
      body.solve();
      const Fields f = fields_of(body);
      const auto at = [&, s = stress](const Vec3&) {
        return Stress{s[0][0], s[1][1], s[2][2], s[0][1], s[0][2], s[1][2]};
      };
      expect_error(name_of(type) + ", " + name + ", integration points", error_of(f.point, f.xyz, at), 1e-11);
      expect_error(name_of(type) + ", " + name + ", nodes", error_of(f.node, places(body.mesh()), at), 1e-11);
    }
}

/// Returns Lame's stresses in plane strain, around the y axis.
Stress lame(const Vec3& x, double poisson) {
  const double r2 = x[0] * x[0] + x[2] * x[2], a2 = walls::inner * walls::inner, b2 = walls::outer * walls::outer;
  const double k = walls::pressure * a2 / (b2 - a2), radial = k * (1 - b2 / r2), hoop = k * (1 + b2 / r2);
  const double c = x[0] / std::sqrt(r2), s = x[2] / std::sqrt(r2);
  return {radial * c * c + hoop * s * s, 2 * poisson * k, radial * s * s + hoop * c * c, 0, (radial - hoop) * c * s, 0};
}

struct Bounds {
  VolumeType type;
  int n;
  double nodes, points, order;  ///< bounds for the finer mesh; `order` of the stresses at nodes
};

struct LameError {
  double nodes, points, anywhere;
};
LameError lame_error(VolumeType type, int n, double poisson) {
  StaticBody body(walls::quarter_cylinder(n), type, walls::young, poisson);
  walls::press_cylinder(body);
  body.solve();
  const Fields f = fields_of(body);
  const auto exact = [poisson](const Vec3& x) { return lame(x, poisson); };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.02, 0.98);
  std::vector<double> x, u, s;
  for (int p = 0; p < 200; ++p) {
    const double angle = unit(random) * std::numbers::pi / 2, r = 1 + unit(random);
    x.insert(x.end(), {r * std::sin(angle), unit(random), r * std::cos(angle)});
  }
  if (!is_quadratic(type)) x.clear();  // the cylinder is not the polygon
  u.resize(x.size()), s.resize(2 * x.size());
  body_fields_at(body.body(), {body.mesh().nodes(), nullptr}, std::ssize(x) / 3, x.data(), u.data(), s.data());
  return {error_of(f.node, places(body.mesh()), exact) / walls::pressure,
          error_of(f.point, f.xyz, exact) / walls::pressure, error_of(s, x, exact) / walls::pressure};
}

class LameStresses : public ::testing::TestWithParam<Bounds> {};

TEST_P(LameStresses, converge) {
  const Bounds& b = GetParam();
  if (absent(b.type)) GTEST_SKIP() << "not in this build";
  const LameError coarse = lame_error(b.type, b.n, 0.3), fine = lame_error(b.type, 2 * b.n, 0.3);
  expect_error(name_of(b.type) + ", nodes, over the pressure", fine.nodes, b.nodes);
  expect_error(name_of(b.type) + ", integration points", fine.points, b.points);
  expect_error(name_of(b.type) + ", any points", fine.anywhere, b.nodes);
  expect_order(name_of(b.type) + ", nodes", observed_order(coarse.nodes, fine.nodes, 2, 1), b.order);
  const LameError soft =
      lame_error(b.type, 2 * b.n, b.type == VolumeType::wedge6 || b.type == VolumeType::tet4 ? 0.4 : 0.4999);
  expect_error(name_of(b.type) + ", nodes, nearly incompressible", soft.nodes, 1.5 * b.nodes);
}

constexpr auto type_name = [](const auto& param) { return name_of(param.param.type); };
INSTANTIATE_TEST_SUITE_P(Bodies, LameStresses,
                         ::testing::Values(Bounds{VolumeType::hex8, 4, 0.09, 0.2, 1.4},
                                           Bounds{VolumeType::hex20, 2, 0.027, 0.012, 2}),
                         type_name);
INSTANTIATE_TEST_SUITE_P(Bodies_long, LameStresses,
                         ::testing::Values(Bounds{VolumeType::tet10, 2, 0.055, 0.05, 1.5},
                                           Bounds{VolumeType::wedge15, 2, 0.027, 0.012, 2},
                                           Bounds{VolumeType::wedge6, 4, 0.1, 0.15, 1.4},
                                           Bounds{VolumeType::tet4, 4, 0.32, 0.35, 0.7}),
                         type_name);

TEST(BodyStresses, points_outside_and_other_bodies_are_refused) {
  if (absent(VolumeType::hex8)) GTEST_SKIP() << "not in this build";
  StaticBody body(walls::quarter_cylinder(1), VolumeType::hex20, walls::young, 0.3);
  walls::press_cylinder(body);
  body.solve();
  const std::int64_t nodes = body.mesh().nodes();
  const auto status = [&](auto&& call) {
    try {
      call();
    } catch (const Error& e) {
      return e.status();
    }
    return Status::ok;
  };
  std::vector<double> s(6 * at(nodes)), u(3 * at(nodes), 0.0);
  const double outside[] = {1.2, 0.5, 0.5, 0.5, 0.5, 0.5}, rim[] = {0, 0, 1, 0, 1, 2};
  EXPECT_EQ(status([&] {
              body_fields_at(body.body(), {nodes, nullptr}, 2, outside, nullptr, s.data());
            }),
            Status::err_argument);
  EXPECT_EQ(status([&] { body_fields_at(body.body(), {nodes, nullptr}, 2, rim, u.data(), s.data()); }), Status::ok);
  EXPECT_EQ(status([&] { body_node_stresses(body.body(), {nodes - 1, nullptr}, s.data()); }), Status::err_argument);
  u[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(status([&] { body_node_stresses(body.body(), {nodes, u.data()}, s.data()); }), Status::err_nonfinite);
  u[4] = 1e308;
  EXPECT_EQ(status([&] { body_node_stresses(body.body(), {nodes, u.data()}, s.data()); }), Status::err_argument);
}

}  // namespace
}  // namespace rollcon
