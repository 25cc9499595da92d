// Compares forces inside finite elements, a column under its weight and a rotating cylinder, with closed forms; tests
// bad inputs.

#include "block20.hpp"

namespace {

using namespace capi_test;

class body_loads : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    if (rollcon_body_create(context, ROLLCON_BODY_FEM, &body) == ROLLCON_ERR_UNSUPPORTED)
      GTEST_SKIP() << "no finite elements in this build";
  }
  void TearDown() override {
    rollcon_body_release(body);
    rollcon_context_release(context);
  }
  /// Gives the block of half-width 1 and depth 1, mapped.
  void give(const Block20& mesh, double poisson, const std::function<std::array<double, 3>(const double*)>& map) {
    nodes = mesh.nodes();
    x = mesh.x;
    for (std::size_t k = 0; k < x.size(); k += 3) {
      const std::array<double, 3> to = map(&mesh.x[k]);
      std::copy_n(to.data(), 3, &x[k]);
    }
    ASSERT_OK(rollcon_body_set_nodes(body, nodes, x.data(), 3, 1));
    ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_HEX20, static_cast<std::int64_t>(mesh.connectivity.size() / 20),
                                        mesh.connectivity.data(), 0, 4));
    ASSERT_OK(rollcon_body_set_elastic(body, 4, young, poisson));
  }
  /// Holds the nodes whose coordinate in the block is this one.
  void slide(const Block20& mesh, std::size_t axis, double value, std::int32_t mask) {
    std::vector<std::int32_t> held;
    for (std::size_t k = 0; k < mesh.x.size() / 3; ++k)
      if (std::abs(mesh.x[3 * k + axis] - value) < 1e-12) held.push_back(static_cast<std::int32_t>(k));
    ASSERT_OK(hold(body, held, mask));
  }
  void results() {
    u.resize(x.size()), s.resize(2 * x.size());
    ASSERT_OK(rollcon_body_prepare(body));
    ASSERT_OK(rollcon_body_get_displacements(body, nodes, u.data()));
    ASSERT_OK(rollcon_body_get_node_stresses(body, nodes, nullptr, s.data()));
  }

  static constexpr double young = 1000;
  rollcon_context* context = nullptr;
  rollcon_body* body = nullptr;
  std::int64_t nodes = 0;
  std::vector<double> x, u, s;
};

TEST_F(body_loads, column_under_its_weight) {
  const Block20 mesh(2, 3, 1, 1);
  give(mesh, 0, [](const double* q) { return std::array<double, 3>{q[0], q[1], 3 * (q[2] + 1)}; });
  slide(mesh, 2, -1, ROLLCON_DOF_XYZ);
  const double weight[3] = {0, 0, -7};
  ASSERT_OK(rollcon_body_set_body_force(body, 4, weight));
  results();
  double moved = 0, stressed = 0, force[3];
  for (std::size_t k = 0; k < x.size(); k += 3) {
    const double z = x[k + 2];
    moved = std::max(moved, std::abs(u[k + 2] + 7 / young * (3 * z - z * z / 2)));
    stressed = std::max(stressed, std::abs(s[2 * k + 2] + 7 * (3 - z)));
  }
  ASSERT_OK(rollcon_body_get_reaction(body, force, nullptr));
  std::printf("displacement %.1e, stress %.1e, reaction %.1e (bounds 1e-11)\n", moved, stressed, force[2] / 84 - 1);
  EXPECT_LE(moved, 1e-11);
  EXPECT_LE(stressed, 1e-11);
  EXPECT_NEAR(force[2], 7 * 4 * 3, 1e-9);
}

// The cylinder has radii 1 and 2, in plane strain; a quarter of it is meshed.
TEST_F(body_loads, rotating_cylinder) {
  const Block20 mesh(6, 6, 1, 1);
  const double nu = 0.3, density = 3, omega = 2, pi = std::numbers::pi;
  give(mesh, nu, [pi](const double* q) {
    const double angle = pi / 4 * (q[0] + 1), r = q[2] + 2;
    return std::array<double, 3>{r * std::cos(angle), 5 + q[1], -r * std::sin(angle)};
  });
  slide(mesh, 0, -1, ROLLCON_DOF_Z);
  slide(mesh, 0, 1, ROLLCON_DOF_X);
  for (const double side : {-1.0, 1.0}) slide(mesh, 1, side, ROLLCON_DOF_Y);
  const double origin[3] = {0, -2, 0}, rate[3] = {0, omega, 0};
  ASSERT_OK(rollcon_body_set_rotation(body, 4, density, origin, rate));
  results();
  const double k = density * omega * omega * (3 - 2 * nu) / (8 * (1 - nu));
  double moved = 0, stressed = 0, most_u = 0, most_s = 0;
  for (std::size_t i = 0; i < x.size(); i += 3) {
    const double r = std::hypot(x[i], x[i + 2]), c = x[i] / r, z = x[i + 2] / r;
    const double radial = k * (5 - 4 / (r * r) - r * r),
                 hoop = k * (5 + 4 / (r * r) - (1 + 2 * nu) / (3 - 2 * nu) * r * r);
    const double out = r / young * ((1 - nu * nu) * hoop - nu * (1 + nu) * radial);
    moved = std::max({moved, std::abs(u[i] - out * c), std::abs(u[i + 2] - out * z), std::abs(u[i + 1])});
    stressed =
        std::max({stressed, std::abs(s[2 * i] - (radial * c * c + hoop * z * z)),
                  std::abs(s[2 * i + 4] - (radial - hoop) * c * z), std::abs(s[2 * i + 1] - nu * (radial + hoop))});
    most_u = std::max(most_u, out);
    most_s = std::max(most_s, hoop);
  }
  std::printf("rotating cylinder: displacement %.1e (bound 3e-4), stress %.1e (bound 4e-2)\n", moved / most_u,
              stressed / most_s);
  EXPECT_LE(moved / most_u, 3e-4);
  EXPECT_LE(stressed / most_s, 4e-2);
}

TEST_F(body_loads, saved_and_shared_with_their_forces) {
  const Block20 mesh(1, 1, 1, 1);
  give(mesh, 0.2, [](const double* q) { return std::array<double, 3>{q[0], q[1], q[2]}; });
  slide(mesh, 2, -1, ROLLCON_DOF_XYZ);
  const double force[3] = {1, 2, 3}, origin[3] = {0, 0, 0}, rate[3] = {0, 0, 1};
  ASSERT_OK(rollcon_body_set_body_force(body, 4, force));
  ASSERT_OK(rollcon_body_set_rotation(body, 4, 2, origin, rate));
  results();
  const std::string path = ::testing::TempDir() + "rollcon_body_loads";
  ASSERT_OK(rollcon_body_save(body, path.c_str()));
  rollcon_body* loaded = nullptr;
  ASSERT_OK(rollcon_body_load(context, path.c_str(), &loaded));
  std::vector<double> again(u.size());
  ASSERT_OK(rollcon_body_get_displacements(loaded, nodes, again.data()));
  EXPECT_EQ(again, u);
  // A body with the same mesh under no force is another one.
  rollcon_body* other = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &other));
  std::swap(other, body);
  give(mesh, 0.2, [](const double* q) { return std::array<double, 3>{q[0], q[1], q[2]}; });
  slide(mesh, 2, -1, ROLLCON_DOF_XYZ);
  ASSERT_OK(rollcon_body_prepare(body));
  double shared = 1;
  ASSERT_OK(rollcon_body_get_stat(body, "shared", &shared));
  EXPECT_EQ(shared, 0);
  rollcon_body_release(other);
  rollcon_body_release(loaded);
  std::remove(path.c_str());
}

TEST_F(body_loads, bad_ones_are_refused) {
  const double force[3] = {1, 2, std::numeric_limits<double>::infinity()}, good[3] = {0, 0, 1};
  rollcon_body* rigid = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &rigid));
  EXPECT_FAILS(rollcon_body_set_body_force(rigid, 4, good), STATE, "rigid", "no volume elements");
  EXPECT_FAILS(rollcon_body_set_body_force(body, 4, force), NONFINITE, "component z of force");
  EXPECT_FAILS(rollcon_body_set_rotation(body, 4, -1, good, good), ARGUMENT, "density is -1");
  const Block20 mesh(1, 1, 1, 1);
  give(mesh, 0.2, [](const double* q) { return std::array<double, 3>{q[0], q[1], q[2]}; });
  slide(mesh, 2, -1, ROLLCON_DOF_XYZ);
  ASSERT_OK(rollcon_body_set_body_force(body, 5, good));
  EXPECT_FAILS(rollcon_body_prepare(body), STATE, "tag 5");
  rollcon_body_release(rigid);
}

}  // namespace
