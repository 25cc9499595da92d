/// Tests that builds that go without a component say so by name, and that everything else works.

#include "fixture.hpp"

using namespace capi_test;

class components : public Api {};

TEST_F(components, bodies_of_absent_kinds_are_refused_by_name) {
  struct {
    std::int32_t kind;
    const char *feature, *option, *words;
  } const cases[] = {
      {ROLLCON_BODY_FEM, "fem", "ROLLCON_WITH_FEM", "component FEM"},
      {ROLLCON_BODY_BEM, "bem", "ROLLCON_WITH_BEM", "component BEM"},
  };
  for (const auto& c : cases) {
    rollcon_body* body = nullptr;
    if (rollcon_has_feature(c.feature)) {
      EXPECT_OK(rollcon_body_create(context, c.kind, &body)) << c.feature;
      rollcon_body_release(body);
    } else {
      EXPECT_FAILS(rollcon_body_create(context, c.kind, &body), UNSUPPORTED, c.option, c.words);
      EXPECT_EQ(body, nullptr);
    }
  }
}

TEST_F(components, absent_procedures_are_refused_by_name_and_the_standard_one_works) {
  set_scene();
  ASSERT_OK(rollcon_contact_set_str(contact, "convection", "godunov"));
  ASSERT_OK(rollcon_contact_solve(contact));
  for (const auto& [option, value] : {std::pair{"system", "monolithic"}, std::pair{"jacobian", "b_derivative"}}) {
    ASSERT_OK(rollcon_contact_set_procedure(contact, (std::string(option) + "=" + value).c_str()));
    if (rollcon_has_feature("procedures"))
      EXPECT_OK(rollcon_contact_solve(contact));
    else
      EXPECT_FAILS(rollcon_contact_solve(contact), UNSUPPORTED, option, value, "component PROCEDURES",
                   "ROLLCON_WITH_PROCEDURES");
    ASSERT_OK(rollcon_contact_set_procedure(contact, ""));
  }
  EXPECT_OK(rollcon_contact_solve(contact));
}

TEST_F(components, absent_files_are_refused_by_name) {
  if (rollcon_has_feature("vtu")) GTEST_SKIP() << "this build writes VTU files";
  set_scene();
  ASSERT_OK(rollcon_contact_solve(contact));
  EXPECT_FAILS(rollcon_contact_write(contact, "never_written.vtu"), UNSUPPORTED, "never_written.vtu", "component VTU",
               "ROLLCON_WITH_VTU");
}

TEST_F(components, rigid_bodies_have_meshes_in_every_build) {
  SquareFrame ball(16, 2);  // a ball of radius 50, above the half-space
  const double mu = 0.1;
  for (std::size_t i = 0; i < ball.x.size(); i += 3)
    ball.x[i + 2] = 0.01 * (ball.x[i] * ball.x[i] + ball.x[i + 1] * ball.x[i + 1]);
  for (std::size_t e = 0; e < ball.connectivity.size(); e += 4)  // its faces look down
    std::swap(ball.connectivity[e + 1], ball.connectivity[e + 3]);
  ASSERT_OK(rollcon_body_set_nodes(plane, ball.nodes, ball.x.data(), 3, 1));
  ASSERT_OK(rollcon_body_add_elements(plane, ROLLCON_QUAD4, ball.elements, ball.connectivity.data(), 0, 1));
  set_frame();
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  ASSERT_OK(rollcon_contact_set_rolling(contact, 10));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
  ASSERT_OK(rollcon_contact_solve(contact));
  double measured[3], given[3];
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, measured, nullptr));
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, given, nullptr));
  EXPECT_NEAR(measured[2] / given[2], 1, 1e-3) << "facets for a paraboloid";
  std::printf("normal force of facets over that of the paraboloid: %.4f (bound 1 +- 1e-3)\n", measured[2] / given[2]);
}

TEST_F(components, licences_are_those_of_what_is_linked) {
  const std::string info = rollcon_build_info();
  const auto has = [](const char* name) { return rollcon_has_feature(name) != 0; };
  EXPECT_EQ(info.find("GPL") != std::string::npos, has("cholmod") || has("umfpack") || has("fftw") || has("hmat"))
      << info;
  EXPECT_EQ(info.find("CHOLMOD") != std::string::npos, has("cholmod")) << info;
  EXPECT_EQ(info.find("MUMPS") != std::string::npos, has("mumps")) << info;
  EXPECT_EQ(info.find("UMFPACK") != std::string::npos, has("umfpack")) << info;
  EXPECT_EQ(info.find("FFTW") != std::string::npos, has("fftw")) << info;
  EXPECT_EQ(info.find("HMAT") != std::string::npos, has("hmat")) << info;
  EXPECT_EQ(info.find("OpenMP: on") != std::string::npos, has("openmp")) << info;
  EXPECT_TRUE(!has("fem") || has("cholmod") || has("mumps")) << "they need a factorisation";
}
