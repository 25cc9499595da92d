/// Tests what a prepared body tells: statics under its own loads, statistics.

#include "body_fixture.hpp"

using namespace capi_test;

class body_results : public BodyApi {};

TEST_F(body_results, before_preparation_there_are_none) {
  set_mesh(body);
  double v[3];
  std::vector<double> u(cube.x.size());
  EXPECT_FAILS(rollcon_body_get_displacements(body, cube.nodes(), u.data()), STATE, "rollcon_body_prepare");
  EXPECT_FAILS(rollcon_body_get_reaction(body, v, v), STATE, "rollcon_body_prepare");
  EXPECT_FAILS(rollcon_body_get_stat(body, "unknowns", v), STATE, "rollcon_body_prepare");
  EXPECT_FAILS(rollcon_body_get_reaction(sphere, v, v), STATE, "half-space");
  EXPECT_FAILS(rollcon_body_get_displacements(sphere, 1, v), STATE, "half-space");
}

TEST_F(body_results, arguments) {
  set_mesh(body);
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_prepare(body));
  std::vector<double> u(cube.x.size(), 5.0);
  const std::vector<double> kept = u;
  double v = 0;
  EXPECT_FAILS(rollcon_body_get_displacements(body, cube.nodes() - 1, u.data()), CAPACITY, "25", "26");
  EXPECT_FAILS(rollcon_body_get_displacements(body, -1, u.data()), ARGUMENT, "capacity is -1");
  EXPECT_FAILS(rollcon_body_get_displacements(body, cube.nodes(), nullptr), ARGUMENT, "u is NULL");
  EXPECT_EQ(u, kept);
  EXPECT_FAILS(rollcon_body_get_stat(body, "iterations", &v), OPTION, "'iterations'", "rollcon_stat_info");
  EXPECT_FAILS(rollcon_body_get_stat(body, nullptr, &v), ARGUMENT, "name is NULL");
  EXPECT_FAILS(rollcon_body_get_stat(body, "bytes", nullptr), ARGUMENT, "value is NULL");
  EXPECT_OK(rollcon_body_get_size(body, nullptr, nullptr));
}

TEST_F(body_results, every_statistic_has_a_name_and_a_value) {
  set_mesh(body);
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  for (rollcon_body* b : {body, sphere, plane}) ASSERT_OK(rollcon_body_prepare(b));
  ASSERT_EQ(rollcon_stat_count(ROLLCON_OF_BODY), 31);
  for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_BODY); ++i) {
    char name[32];
    double value = -1;
    ASSERT_OK(rollcon_stat_info(ROLLCON_OF_BODY, i, sizeof name, name, nullptr, nullptr, nullptr));
    ASSERT_OK(rollcon_body_get_stat(body, name, &value)) << name;
    EXPECT_GE(value, 0) << name;
    EXPECT_TRUE(std::isfinite(value)) << name;
    for (const rollcon_body* simple : {sphere, plane}) {
      ASSERT_OK(rollcon_body_get_stat(simple, name, &value)) << name;
      EXPECT_EQ(value, 0) << name;
    }
  }
  for (const char* counted : {"unknowns", "bytes", "condition", "kernel_evaluations"}) {
    double value = 0;
    ASSERT_OK(rollcon_body_get_stat(body, counted, &value));
    EXPECT_GT(value, 0) << counted;
  }
  double assemblies = 0;
  ASSERT_OK(rollcon_body_prepare(body));
  ASSERT_OK(rollcon_body_get_stat(body, "assemblies", &assemblies));
  EXPECT_EQ(assemblies, 1);
  char text[64];
  for (const std::int32_t i : {-1, rollcon_stat_count(ROLLCON_OF_BODY), INT32_MIN})
    EXPECT_EQ(rollcon_stat_info(ROLLCON_OF_BODY, i, sizeof text, text, nullptr, nullptr, nullptr),
              ROLLCON_ERR_ARGUMENT);
}

TEST_F(body_results, rigid_bodies_do_not_move) {
  set_mesh(plane);
  ASSERT_OK(rollcon_body_prepare(plane));
  std::vector<double> u(cube.x.size(), 5.0);
  ASSERT_OK(rollcon_body_get_displacements(plane, cube.nodes(), u.data()));
  EXPECT_EQ(u, std::vector<double>(cube.x.size(), 0.0));
}
