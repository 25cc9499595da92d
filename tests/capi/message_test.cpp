/// Tests what messages and the plan say, so that they do not mislead.

#include "fem_fixture.hpp"

using namespace capi_test;

class message : public Api {
 protected:
  std::string plan() const { return plan_of(contact); }

  static void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' in: " << text;
  }

  /// Solves; the plan, and the warning in the log, say why.
  void expect_rim(const char* cause) {
    static std::string logged;
    logged.clear();
    const auto sink = [](std::int32_t, const char* text, void*) { logged += text; };
    ASSERT_OK(rollcon_context_set_log(context, ROLLCON_LOG_WARNING, sink, nullptr));
    // Few nodes touch at the corners of a frame, which is the status that comes first.
    const std::int32_t status = rollcon_contact_solve(contact);
    EXPECT_TRUE(status == ROLLCON_RIM_CONTACT || status == ROLLCON_COARSE) << status << error();
    expect_words(plan(), {"result: contact reaches the rim of the frame at", cause});
    expect_words(logged, {cause});
  }
};

TEST_F(message, two_rigid_bodies_names_all_elastic_kinds) {
  rollcon_contact* c = nullptr;
  EXPECT_FAILS(rollcon_contact_create(context, plane, plane, &c), ARGUMENT,
               "(finite-element, boundary-element, half-space, section or condensed)");
  EXPECT_EQ(c, nullptr);
}

TEST_F(message, rim_contact_tells_wrong_sign_wrong_units_and_small_frames_apart) {
  set_scene();
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, -0.01, -0.01, 0));
  expect_rim("has it the wrong sign?");
  // Coordinates are in metres where all else is in millimetres.
  SquareFrame metres = frame;
  for (double& x : metres.x) x *= 1e-3;
  ASSERT_OK(set_nodes(metres));
  ASSERT_OK(add_elements(metres));
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
  expect_rim("not all in the same units");
  // The patch leaves the frame along one side only.
  const double aside[3] = {1.3, 0, 0}, along[3] = {1, 0, 0}, up[3] = {0, 0, 1};
  ASSERT_OK(set_nodes(frame));
  ASSERT_OK(add_elements(frame));
  ASSERT_OK(rollcon_contact_set_axes(contact, aside, along, up));
  expect_rim("enlarge the frame");
  expect_words(rollcon_status_string(ROLLCON_RIM_CONTACT), {"rim of the frame", "end of a profile", "plan"});
}

TEST_F(message, the_plan_says_how_a_solve_ended) {
  set_scene();
  ASSERT_OK(rollcon_contact_solve(contact));
  expect_words(plan(), {"result: converged, residuals "});
  ASSERT_OK(rollcon_contact_reset(contact));
  ASSERT_OK(rollcon_contact_set_int(contact, "max_iterations", 1));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NOT_CONVERGED);
  expect_words(plan(), {"result: not converged after ", "residuals "});
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -1));
  ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  expect_words(plan(), {"result: the bodies do not touch"});
}

TEST_F(message, a_library_of_another_abi_is_not_said_to_lack_a_feature) {
  const std::string text = rollcon_status_string(ROLLCON_ERR_UNSUPPORTED);
  expect_words(text, {"not in this build", "made for another"});
}

TEST_F(message, numbers_of_elements_say_from_where_they_count) {
  set_scene();
  for (const std::int32_t base : {0, 1}) {
    std::vector<std::int32_t> twice(frame.connectivity.begin() + 8, frame.connectivity.begin() + 12);
    for (std::int32_t& id : twice) id += base;
    SquareFrame based = frame;
    for (std::int32_t& id : based.connectivity) id += base;
    ASSERT_OK(set_nodes(frame));
    for (const auto& [n, ids] : {std::pair{frame.elements, &based.connectivity}, std::pair{std::int64_t{1}, &twice}})
      ASSERT_OK(rollcon_contact_frame_add_elements(contact, ROLLCON_QUAD4, n, ids->data(), base, 0));
    const std::string pair = "elements " + std::to_string(2 + base) + " and " + std::to_string(frame.elements + base) +
                             " (counting from " + std::to_string(base) + ")";
    EXPECT_FAILS(rollcon_contact_solve(contact), MESH, pair);
  }
}

class message_of_fem : public FemApi {};

TEST_F(message_of_fem, the_plan_counts_volume_elements_and_boundary_faces_apart) {
  give_mesh(body, box);
  ASSERT_OK(rollcon_body_set_elastic(body, 0, 100, 0.3));
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  rollcon_contact* c = roll_on_top(context, body, plane, {.curvature = 0, .approach = 0.01, .mu = 0, .creep = 0});
  ASSERT_GE(rollcon_contact_solve(c), ROLLCON_OK) << error();
  const std::string said = std::to_string(box.nodes()) + " nodes, " + std::to_string(box.elements()) +
                           " volume elements, " + std::to_string(6 * box.layer_elements()) + " boundary faces";
  EXPECT_NE(plan_of(c).find(said), std::string::npos) << said << "\n" << plan_of(c);
  rollcon_contact_release(c);
}

TEST_F(message, finite_elements_without_a_volume_are_told_so) {
  if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  const BoxVolume box(2);
  rollcon_body* body = nullptr;
  rollcon_contact* c = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
  ASSERT_OK(rollcon_body_set_nodes(body, box.nodes(), box.x.data(), 3, 1));
  ASSERT_OK(rollcon_contact_create(context, body, plane, &c));
  EXPECT_FAILS(rollcon_contact_frame_from_body(c, 1, 2), STATE, "body 1 has no volume elements",
               "rollcon_body_add_elements");
  const std::int32_t face[4] = {0, 3, 4, 1};
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_QUAD4, 1, face, 0, 2));
  EXPECT_FAILS(rollcon_contact_frame_from_body(c, 1, 2), STATE, "body 1 has no volume elements");
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_HEX8, box.elements(), box.connectivity.data(), 0, 0));
  EXPECT_FAILS(rollcon_contact_frame_from_body(c, 1, 7), ARGUMENT, "tag is 7, which no face of body 1 has");
  EXPECT_OK(rollcon_contact_frame_from_body(c, 1, 2));
  rollcon_contact_release(c);
  rollcon_body_release(body);
}
