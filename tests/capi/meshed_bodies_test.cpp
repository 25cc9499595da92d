/// Tests what bodies of boundary elements and of finite elements must do alike: a cube under its own loads, a frozen
/// body, one body in many contacts.

#include "body_fixture.hpp"
#include "fem_fixture.hpp"

using namespace capi_test;

/// Makes the unit cube, its top with tag 6, its bottom with tag 5, not held.
class meshed_bodies : public Api, public ::testing::WithParamInterface<std::int32_t> {
 protected:
  void SetUp() override {
    if (!rollcon_has_feature(bem() ? "bem" : "fem")) GTEST_SKIP() << "not in this build";
    Api::SetUp();
    give_cube(2);
  }

  void TearDown() override {
    rollcon_body_release(body);
    Api::TearDown();
  }

  bool bem() const { return GetParam() == ROLLCON_BODY_BEM; }

  void give_cube(int per_edge) {
    rollcon_body_release(body);
    ASSERT_OK(rollcon_body_create(context, GetParam(), &body));
    ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
    const CubeSurface cube(per_edge);
    const BoxVolume box(per_edge);
    if (bem())
      give_mesh(body, cube);
    else
      give_mesh(body, box);
    x = bem() ? cube.x : box.x;
    bottom = bem() ? cube.nodes_at(2, 0) : box.nodes_at(2, 0);
    top = bem() ? cube.nodes_at(2, 1) : box.nodes_at(2, 1);
    ASSERT_OK(rollcon_body_tag_faces_of_nodes(body, static_cast<std::int64_t>(bottom.size()), bottom.data(), 0, 5));
  }

  std::int64_t nodes() const { return static_cast<std::int64_t>(x.size()) / 3; }

  /// Holds the bottom along z, its corner at the origin along x and y, the one on the x axis along y.
  void hold_freely() {
    ASSERT_OK(hold(body, bottom, ROLLCON_DOF_Z));
    for (const std::int32_t i : bottom) {
      const double* at = &x[3 * static_cast<std::size_t>(i)];
      if (at[0] == 0 && at[1] == 0) {
        ASSERT_OK(hold(body, {i}, ROLLCON_DOF_X + ROLLCON_DOF_Y));
      }
      if (at[0] == 1 && at[1] == 0) {
        ASSERT_OK(hold(body, {i}, ROLLCON_DOF_Y));
      }
    }
  }

  /// Expects u = stress / E (-nu x, -nu y, z), and the forces of the supports.
  void expect_uniaxial(double stress, const double (&force)[3], const double (&moment)[3]) {
    std::vector<double> u(x.size());
    double f[3], m[3], error = 0, reaction = 0;
    ASSERT_OK(rollcon_body_get_displacements(body, nodes(), u.data()));
    ASSERT_OK(rollcon_body_get_reaction(body, f, m));
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double exact = stress / young * (i % 3 == 2 ? x[i] : -poisson * x[i]);
      error = std::max(error, std::abs(u[i] - exact));
    }
    for (int c = 0; c < 3; ++c) reaction = std::max({reaction, std::abs(f[c] - force[c]), std::abs(m[c] - moment[c])});
    // Boundary integrals are as accurate as their rules, finite elements exact.
    const double bound = (bem() ? 1e-6 : 1e-11) * stress / young, least = bem() ? 1e-6 : 1e-10;
    std::printf("uniaxial stress: error %.2e, bound %.2e; reaction: error %.2e, bound %.2e\n", error, bound, reaction,
                least);
    EXPECT_LE(error, bound);
    EXPECT_LE(reaction, least);
  }

  rollcon_contact* roll(rollcon_context* own) { return roll_on_top(own, body, plane); }

  static constexpr double young = 200, poisson = 0.3;
  rollcon_body* body = nullptr;
  std::vector<double> x;
  std::vector<std::int32_t> bottom, top;
};

INSTANTIATE_TEST_SUITE_P(of, meshed_bodies, ::testing::Values(ROLLCON_BODY_BEM, ROLLCON_BODY_FEM),
                         [](const auto& kind) {
                           return kind.param == ROLLCON_BODY_BEM ? "boundary_elements" : "finite_elements";
                         });

TEST_P(meshed_bodies, tension_by_pressure_and_traction_together) {
  const double first[3] = {5, 5, 5}, t[3] = {0, 0, 3};
  hold_freely();
  ASSERT_OK(rollcon_body_set_pressure(body, 6, 1));
  ASSERT_OK(rollcon_body_set_traction(body, 6, first));
  ASSERT_OK(rollcon_body_set_traction(body, 6, t)) << "replaces the first";
  ASSERT_OK(rollcon_body_prepare(body));
  expect_uniaxial(2, {0, 0, -2}, {-1, 1, 0});  // at (1/2, 1/2)
}

TEST_P(meshed_bodies, tension_by_given_displacements) {
  hold_freely();
  std::vector<double> values(3 * top.size(), std::nan(""));
  for (std::size_t i = 0; i < top.size(); ++i) values[3 * i + 2] = 2 / young;
  for (std::int32_t& id : top) ++id;
  ASSERT_OK(rollcon_body_set_support(body, static_cast<std::int64_t>(top.size()), top.data(), 1, ROLLCON_DOF_Z,
                                     values.data()));
  ASSERT_OK(rollcon_body_prepare(body));
  expect_uniaxial(2, {0, 0, 0}, {0, 0, 0});  // top and bottom pull against each other
}

TEST_P(meshed_bodies, pressure_on_a_held_face_goes_into_the_support) {
  ASSERT_OK(hold(body, bottom, ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_set_pressure(body, 5, 7));
  ASSERT_OK(rollcon_body_prepare(body));
  expect_uniaxial(0, {0, 0, -7}, {-3.5, 3.5, 0});
}

TEST_P(meshed_bodies, zero_without_loads) {
  ASSERT_OK(hold(body, bottom, ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_prepare(body));
  std::vector<double> u(x.size() + 1, 99.0), zero(x.size(), 0.0);
  zero.push_back(99.0);
  ASSERT_OK(rollcon_body_get_displacements(body, nodes(), u.data()));
  EXPECT_EQ(u, zero) << "and nothing is written beyond the nodes";
  expect_uniaxial(0, {0, 0, 0}, {0, 0, 0});
  EXPECT_OK(rollcon_body_get_reaction(body, nullptr, nullptr));
}

TEST_P(meshed_bodies, prepared_ones_are_frozen) {
  const std::int32_t tag = 6, one = 1, quad[8] = {};
  const double t[3] = {0, 0, 1};
  ASSERT_OK(hold(body, bottom, ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_prepare(body));
  const auto type = bem() ? ROLLCON_QUAD4 : ROLLCON_HEX8;
  EXPECT_FAILS(rollcon_body_set_elastic(body, 0, 1, 0.3), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_set_nodes(body, 1, t, 3, 1), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_add_elements(body, type, 1, quad, 0, 1), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(body, 1, &one, 0, 9), STATE, "prepared");
  if (!bem()) {
    EXPECT_FAILS(rollcon_body_tag_faces(body, 1, &one, &one, 0, 9), STATE, "prepared");
    EXPECT_FAILS(rollcon_body_set_int(body, "hex8", 1), STATE, "prepared");
    EXPECT_FAILS(rollcon_body_set_int(body, "between_nodes", 1), STATE, "prepared");
  }
  EXPECT_FAILS(rollcon_body_set_support(body, 1, &one, 0, ROLLCON_DOF_X, nullptr), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_set_traction(body, 6, t), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_set_pressure(body, 6, 1), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_set_contact_faces(body, 1, &tag), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_set_real(body, "accuracy", 1e-5), STATE, "prepared");
  EXPECT_FAILS(rollcon_body_set_int(body, "keep_factors", 0), STATE, "prepared");
  double accuracy = 0;
  EXPECT_OK(rollcon_body_get_real(body, "accuracy", &accuracy));
  EXPECT_EQ(accuracy, 1e-6);
  std::int64_t n = 0, elements = 0;
  ASSERT_OK(rollcon_body_get_size(body, &n, &elements));
  EXPECT_EQ(n, nodes());
  EXPECT_EQ(elements, bem() ? 24 : 8);
  rollcon_contact* c = roll(context);
  ASSERT_OK(rollcon_contact_get_size(c, &n, &elements));
  EXPECT_EQ(std::pair(n, elements), std::pair(std::int64_t{9}, std::int64_t{4}));
  rollcon_contact_release(c);
}

TEST_P(meshed_bodies, one_is_assembled_once_for_contacts_in_many_threads) {
  give_cube(5);
  ASSERT_OK(hold(body, bottom, ROLLCON_DOF_XYZ));
  force_in_many_threads(3, [&](rollcon_context* own) { return roll(own); });
  for (const char* name : {"assemblies", "factorizations", "condensations"}) {
    double count = -1;
    EXPECT_OK(rollcon_body_get_stat(body, name, &count));
    EXPECT_EQ(count, 1) << name;
  }
}

TEST_P(meshed_bodies, one_held_all_over_carries_no_frame) {
  ASSERT_OK(hold(body, counting(nodes()), ROLLCON_DOF_XYZ));
  rollcon_contact* c = roll(context);
  EXPECT_FAILS(rollcon_contact_solve(c), STATE, "body 1");
  rollcon_contact_release(c);
}

TEST_P(meshed_bodies, incomplete_ones_are_refused_and_can_be_mended) {
  rollcon_body* bare = nullptr;
  ASSERT_OK(rollcon_body_create(context, GetParam(), &bare));
  EXPECT_FAILS(rollcon_body_prepare(bare), STATE, "rollcon_body_set_elastic");
  ASSERT_OK(rollcon_body_set_elastic(bare, 0, young, poisson));
  EXPECT_FAILS(rollcon_body_prepare(bare), STATE, bem() ? "mesh" : "volume elements");
  rollcon_body_release(bare);
  EXPECT_FAILS(rollcon_body_prepare(body), SINGULAR, "no supports", "rollcon_body_set_support");
  ASSERT_OK(hold(body, bottom, ROLLCON_DOF_Z));
  EXPECT_FAILS(rollcon_body_prepare(body), SINGULAR, "3 rigid motion(s)");
  ASSERT_OK(hold(body, {bottom[0]}, ROLLCON_DOF_X + ROLLCON_DOF_Y));
  EXPECT_FAILS(rollcon_body_prepare(body), SINGULAR, "1 rigid motion(s)", "rotation (0, 0, 1)");
  ASSERT_OK(hold(body, {bottom.back()}, ROLLCON_DOF_X + ROLLCON_DOF_Y));
  EXPECT_OK(rollcon_body_prepare(body));
  EXPECT_OK(rollcon_body_prepare(body));
}

TEST_P(meshed_bodies, refused_nodes_leave_the_mesh_as_it_was_and_new_ones_forget_it) {
  const double bad[3] = {0, std::nan(""), 0}, t[3] = {0, 0, 1};
  std::int64_t elements = 0, of_all = 0;
  ASSERT_OK(rollcon_body_get_size(body, nullptr, &of_all));
  ASSERT_EQ(rollcon_body_set_nodes(body, 1, bad, 3, 1), ROLLCON_ERR_NONFINITE);
  ASSERT_OK(rollcon_body_get_size(body, nullptr, &elements));
  EXPECT_EQ(elements, of_all);
  ASSERT_OK(rollcon_body_set_traction(body, 6, t));
  ASSERT_OK(hold(body, bottom, ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_set_nodes(body, nodes(), x.data(), 3, 1));
  ASSERT_OK(rollcon_body_get_size(body, nullptr, &elements));
  EXPECT_EQ(elements, 0);
  EXPECT_FAILS(rollcon_body_set_traction(body, 6, t), STATE, "elements: call rollcon_body_add_elements");
}
