/// What a prepared body tells: statics under its own loads, statistics.

#include <cmath>
#include <cstdio>

#include "body_fixture.hpp"

using namespace capi_test;

class body_results : public BodyApi {
 protected:
  /// Bottom held along z; node at the origin held along x and y, another one on the x axis along y.
  void hold_freely() {
    ASSERT_EQ(hold_bottom(ROLLCON_DOF_Z), ROLLCON_OK);
    std::int32_t origin = -1, aside = -1;
    for (std::int32_t i = 0; i < cube.nodes(); ++i) {
      const double* x = &cube.x[3 * static_cast<std::size_t>(i)];
      if (x[0] == 0 && x[1] == 0 && x[2] == 0) origin = i;
      if (x[0] == 1 && x[1] == 0 && x[2] == 0) aside = i;
    }
    ASSERT_EQ(rollcon_body_set_support(body, 1, &origin, 0, ROLLCON_DOF_X + ROLLCON_DOF_Y, nullptr),
              ROLLCON_OK);
    ASSERT_EQ(rollcon_body_set_support(body, 1, &aside, 0, ROLLCON_DOF_Y, nullptr), ROLLCON_OK);
  }

  /// u = stress / E (-nu x, -nu y, z), to the accuracy of the integrals.
  void expect_uniaxial(double stress) {
    std::vector<double> u(cube.x.size());
    ASSERT_EQ(rollcon_body_get_displacements(body, cube.nodes(), u.data()), ROLLCON_OK);
    double error = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double exact = stress / young * (i % 3 == 2 ? cube.x[i] : -poisson * cube.x[i]);
      error = std::max(error, std::abs(u[i] - exact));
    }
    const double bound = 1e-6 * stress / young;
    std::printf("uniaxial stress: error %.2e, bound %.2e\n", error, bound);
    EXPECT_LE(error, bound);
  }

  void expect_reaction(const double (&force)[3], const double (&moment)[3]) {
    double f[3], m[3];
    ASSERT_EQ(rollcon_body_get_reaction(body, f, m), ROLLCON_OK);
    double error = 0;
    for (int c = 0; c < 3; ++c)
      error = std::max({error, std::abs(f[c] - force[c]), std::abs(m[c] - moment[c])});
    std::printf("reaction: error %.2e, bound 1e-6\n", error);
    EXPECT_LE(error, 1e-6);
  }
};

TEST_F(body_results, tension_by_traction) {
  const double t[3] = {0, 0, 2};
  set_mesh(body);
  hold_freely();
  ASSERT_EQ(rollcon_body_set_traction(body, 6, t), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_prepare(body), ROLLCON_OK);
  expect_uniaxial(2);
  expect_reaction({0, 0, -2}, {-1, 1, 0});  // at (1/2, 1/2)
}

TEST_F(body_results, tension_by_pressure_and_traction_together) {
  const double first[3] = {5, 5, 5}, t[3] = {0, 0, 3};
  set_mesh(body);
  hold_freely();
  ASSERT_EQ(rollcon_body_set_pressure(body, 6, 1), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_set_traction(body, 6, first), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_set_traction(body, 6, t), ROLLCON_OK) << "replaces the first";
  ASSERT_EQ(rollcon_body_prepare(body), ROLLCON_OK);
  expect_uniaxial(2);
  expect_reaction({0, 0, -2}, {-1, 1, 0});
}

TEST_F(body_results, tension_by_given_displacements) {
  set_mesh(body);
  hold_freely();
  const std::vector<std::int32_t> top = cube.nodes_at(2, 1);
  std::vector<double> values(3 * top.size(), std::nan(""));
  for (std::size_t i = 0; i < top.size(); ++i) values[3 * i + 2] = 2 / young;
  std::vector<std::int32_t> from_one = top;
  for (std::int32_t& id : from_one) ++id;
  ASSERT_EQ(rollcon_body_set_support(body, static_cast<std::int64_t>(top.size()), from_one.data(),
                                     1, ROLLCON_DOF_Z, values.data()),
            ROLLCON_OK);
  ASSERT_EQ(rollcon_body_prepare(body), ROLLCON_OK);
  expect_uniaxial(2);
  expect_reaction({0, 0, 0}, {0, 0, 0});  // top and bottom pull against each other
}

TEST_F(body_results, pressure_on_a_held_face_goes_into_the_support) {
  set_mesh(body);
  ASSERT_EQ(hold_bottom(ROLLCON_DOF_XYZ), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_set_pressure(body, 5, 7), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_prepare(body), ROLLCON_OK);
  expect_uniaxial(0);
  expect_reaction({0, 0, -7}, {-3.5, 3.5, 0});
}

TEST_F(body_results, zero_without_loads) {
  set_mesh(body);
  ASSERT_EQ(hold_bottom(ROLLCON_DOF_XYZ), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_prepare(body), ROLLCON_OK);
  std::vector<double> u(cube.x.size() + 1, 99.0), zero(cube.x.size(), 0.0);
  zero.push_back(99.0);
  ASSERT_EQ(rollcon_body_get_displacements(body, cube.nodes(), u.data()), ROLLCON_OK);
  EXPECT_EQ(u, zero) << "and nothing is written beyond the nodes";
  expect_reaction({0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(rollcon_body_get_reaction(body, nullptr, nullptr), ROLLCON_OK);
}

TEST_F(body_results, before_preparation_there_are_none) {
  set_mesh(body);
  double v[3];
  std::vector<double> u(cube.x.size());
  EXPECT_FAILS(rollcon_body_get_displacements(body, cube.nodes(), u.data()), ROLLCON_ERR_STATE,
               "rollcon_body_prepare");
  EXPECT_FAILS(rollcon_body_get_reaction(body, v, v), ROLLCON_ERR_STATE, "rollcon_body_prepare");
  EXPECT_FAILS(rollcon_body_get_stat(body, "unknowns", v), ROLLCON_ERR_STATE,
               "rollcon_body_prepare");
  EXPECT_FAILS(rollcon_body_get_reaction(sphere, v, v), ROLLCON_ERR_STATE, "half-space");
  EXPECT_FAILS(rollcon_body_get_displacements(sphere, 1, v), ROLLCON_ERR_STATE, "half-space");
}

TEST_F(body_results, arguments) {
  set_mesh(body);
  ASSERT_EQ(hold_bottom(ROLLCON_DOF_XYZ), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_prepare(body), ROLLCON_OK);
  std::vector<double> u(cube.x.size(), 5.0);
  const std::vector<double> kept = u;
  double v = 0;
  EXPECT_FAILS(rollcon_body_get_displacements(body, cube.nodes() - 1, u.data()),
               ROLLCON_ERR_CAPACITY, "25", "26");
  EXPECT_FAILS(rollcon_body_get_displacements(body, -1, u.data()), ROLLCON_ERR_ARGUMENT,
               "capacity is -1");
  EXPECT_FAILS(rollcon_body_get_displacements(body, cube.nodes(), nullptr), ROLLCON_ERR_ARGUMENT,
               "u is NULL");
  EXPECT_EQ(u, kept);
  EXPECT_FAILS(rollcon_body_get_stat(body, "iterations", &v), ROLLCON_ERR_OPTION, "'iterations'",
               "factorizations");
  EXPECT_FAILS(rollcon_body_get_stat(body, nullptr, &v), ROLLCON_ERR_ARGUMENT, "name is NULL");
  EXPECT_FAILS(rollcon_body_get_stat(body, "bytes", nullptr), ROLLCON_ERR_ARGUMENT,
               "value is NULL");
  EXPECT_EQ(rollcon_body_get_size(body, nullptr, nullptr), ROLLCON_OK);
}

TEST_F(body_results, every_statistic_has_a_name_and_a_value) {
  set_mesh(body);
  ASSERT_EQ(hold_bottom(ROLLCON_DOF_XYZ), ROLLCON_OK);
  for (rollcon_body* b : {body, sphere, plane}) ASSERT_EQ(rollcon_body_prepare(b), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_stat_count(), 24);
  for (std::int32_t i = 0; i < rollcon_body_stat_count(); ++i) {
    char name[32];
    double value = -1;
    ASSERT_EQ(rollcon_body_stat_name(i, sizeof name, name, nullptr), ROLLCON_OK);
    ASSERT_EQ(rollcon_body_get_stat(body, name, &value), ROLLCON_OK) << name;
    EXPECT_GE(value, 0) << name;
    EXPECT_TRUE(std::isfinite(value)) << name;
    for (const rollcon_body* simple : {sphere, plane}) {
      ASSERT_EQ(rollcon_body_get_stat(simple, name, &value), ROLLCON_OK) << name;
      EXPECT_EQ(value, 0) << name;
    }
  }
  for (const char* counted : {"unknowns", "bytes", "condition", "kernel_evaluations"}) {
    double value = 0;
    ASSERT_EQ(rollcon_body_get_stat(body, counted, &value), ROLLCON_OK);
    EXPECT_GT(value, 0) << counted;
  }
  double assemblies = 0;
  ASSERT_EQ(rollcon_body_prepare(body), ROLLCON_OK);
  ASSERT_EQ(rollcon_body_get_stat(body, "assemblies", &assemblies), ROLLCON_OK);
  EXPECT_EQ(assemblies, 1);
  char text[64];
  for (const std::int32_t i : {-1, rollcon_body_stat_count(), INT32_MIN})
    EXPECT_EQ(rollcon_body_stat_name(i, sizeof text, text, nullptr), ROLLCON_ERR_ARGUMENT);
}

TEST_F(body_results, rigid_bodies_do_not_move) {
  set_mesh(plane);
  ASSERT_EQ(rollcon_body_prepare(plane), ROLLCON_OK);
  std::vector<double> u(cube.x.size(), 5.0);
  ASSERT_EQ(rollcon_body_get_displacements(plane, cube.nodes(), u.data()), ROLLCON_OK);
  EXPECT_EQ(u, std::vector<double>(cube.x.size(), 0.0));
}
