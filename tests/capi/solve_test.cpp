/// Tests statuses of a solve, the order of calls, and what remains after a failure.

#include "fixture.hpp"

using namespace capi_test;

class solve : public Api {};

TEST_F(solve, six_steps_give_a_contact_in_equilibrium) {
  set_scene();
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 300));
  ASSERT_OK(rollcon_contact_solve(contact));
  double force[3], approach = 0;
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
  ASSERT_OK(rollcon_contact_get_motion(contact, &approach, nullptr));
  const double imbalance = std::abs(force[2] + 300) / 300;
  std::printf("prescribed load missed by %.1e (bound 1e-8), approach %.5f\n", imbalance, approach);
  EXPECT_LT(imbalance, 1e-8);
  EXPECT_GT(approach, 0);
  EXPECT_LT(force[0], 0) << "friction on body 1 opposes its slip";
}

TEST_F(solve, results_before_a_solve_are_a_state_error) {
  double v[3];
  std::int32_t s = 0;
  std::int64_t n = 0;
  const double point[3] = {0, 0, 0};
  for (int round = 0; round < 3; ++round) {
    EXPECT_FAILS(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, 1000, v), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_get_field(contact, ROLLCON_FIELD_GAP, ROLLCON_LOCAL, 0, nullptr, &n), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_get_node_states(contact, 1000, &s), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, v, nullptr), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_get_motion(contact, v, nullptr), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_get_displacements_at(contact, 1, 1, point, v), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, 1, point, ROLLCON_IN_CONTACT, nullptr, v), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_get_plan(contact, 0, nullptr, &n), STATE, "solve");
    EXPECT_FAILS(rollcon_contact_write(contact, "never_written.vtu"), STATE, "solve");
    if (round == 0) set_scene();
    if (round == 1) {
      ASSERT_OK(rollcon_contact_solve(contact));
      ASSERT_OK(rollcon_contact_reset(contact));
    }
  }
}

TEST_F(solve, what_is_missing_is_named) {
  const double mu = 0.1;
  EXPECT_FAILS(rollcon_contact_solve(contact), STATE, "nodes");
  ASSERT_OK(set_nodes(frame));
  EXPECT_FAILS(rollcon_contact_solve(contact), STATE, "elements");
  ASSERT_OK(add_elements(frame));
  EXPECT_FAILS(rollcon_contact_solve(contact), STATE, "gap");
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
  EXPECT_FAILS(rollcon_contact_solve(contact), STATE, "friction");
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  EXPECT_GE(rollcon_contact_solve(contact), ROLLCON_OK) << error();
}

TEST_F(solve, body_without_material_is_named) {
  rollcon_body* bare = nullptr;
  rollcon_contact* made = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &bare));
  ASSERT_OK(rollcon_contact_create(context, bare, plane, &made));
  std::swap(contact, made);
  set_scene();
  EXPECT_FAILS(rollcon_contact_solve(contact), STATE, "elastic");
  rollcon_contact_release(made);
  rollcon_body_release(bare);
}

TEST_F(solve, bodies_apart_have_no_tractions) {
  set_scene();
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -0.01));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  double force[3] = {1, 1, 1};
  EXPECT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
  for (const double f : force) EXPECT_EQ(f, 0);
}

TEST_F(solve, a_contact_of_a_few_nodes_is_coarse) {
  set_scene();
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 1e-4));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_COARSE);
  double touching = 0, inside = -1, estimate = 0;
  ASSERT_OK(rollcon_contact_get_stat(contact, "nodes_contact", &touching));
  ASSERT_OK(rollcon_contact_get_stat(contact, "nodes_inside", &inside));
  ASSERT_OK(rollcon_contact_get_stat(contact, "error_estimate", &estimate));
  EXPECT_GE(touching, 1);
  EXPECT_EQ(inside, 0);
  EXPECT_EQ(estimate, 1);
}

TEST_F(solve, too_few_iterations_are_reported_and_the_iterate_kept) {
  set_scene();
  ASSERT_OK(rollcon_contact_set_int(contact, "max_iterations", 1));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NOT_CONVERGED);
  double force[3];
  EXPECT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
}

TEST_F(solve, force_beyond_friction_has_no_steady_solution) {
  set_scene();
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 300));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 31));
  EXPECT_FAILS(rollcon_contact_solve(contact), LOAD, "steady");
}

TEST_F(solve, bad_elements_are_mesh_errors_that_name_the_element) {
  struct Case {
    const char* name;
    std::int32_t quad[4];
    const char* text;
  };
  // Ids count from 1; the frame has 13 nodes per row, 169 in all.
  for (const Case& c :
       {Case{"flipped", {1, 14, 15, 2}, "element 2"}, Case{"repeated node", {1, 2, 2, 14}, "element 2"},
        Case{"degenerate", {1, 2, 3, 4}, "element 2"}, Case{"same twice", {3, 4, 17, 16}, "elements 1 and 2"}}) {
    SCOPED_TRACE(c.name);
    set_scene();
    ASSERT_OK(set_nodes(frame));
    const std::int32_t good[4] = {3, 4, 17, 16};
    ASSERT_OK(rollcon_contact_frame_add_elements(contact, ROLLCON_QUAD4, 1, good, 1, 0));
    ASSERT_OK(rollcon_contact_frame_add_elements(contact, ROLLCON_QUAD4, 1, c.quad, 1, 0));
    EXPECT_FAILS(rollcon_contact_solve(contact), MESH, c.text);
  }
}

TEST_F(solve, files_that_cannot_be_written_are_io_errors) {
  if (!rollcon_has_feature("vtu")) GTEST_SKIP() << "this build writes no VTU files";
  set_scene();
  ASSERT_OK(rollcon_contact_solve(contact));
  EXPECT_FAILS(rollcon_contact_write(contact, "no/such/folder/out.vtu"), IO, "no/such/folder/out.vtu");
}

TEST_F(solve, later_gap_replaces_the_earlier_kind) {
  set_scene();
  ASSERT_OK(rollcon_contact_solve(contact));
  double by_form[3], by_array[3], again[3];
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, by_form, nullptr));
  std::vector<double> gap;
  for (std::int64_t i = 0; i < frame.nodes; ++i) {
    const double x = frame.x[3 * i], y = frame.x[3 * i + 1];
    gap.push_back(0.01 * x * x + 0.01 * y * y + 0.005);
  }
  ASSERT_OK(rollcon_contact_set_gap(contact, frame.nodes, gap.data()));
  ASSERT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, by_array, nullptr));
  EXPECT_LT(-by_array[2], -0.8 * by_form[2]) << "the array's gap is wider";
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, again, nullptr));
  const double change = std::abs(again[2] / by_form[2] - 1);
  std::printf("load of the same gap set again differs by %.1e (bound 1e-8)\n", change);
  EXPECT_LT(change, 1e-8);
}

TEST_F(solve, failed_setters_leave_the_scene_as_it_was) {
  set_scene();
  ASSERT_OK(rollcon_contact_solve(contact));
  double before[3], after[3];
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, before, nullptr));
  const double zero[3] = {0, 0, 0}, bad_mu = -1;
  EXPECT_LT(rollcon_contact_set_creep(contact, 0, 0, std::nan("")), 0);
  EXPECT_LT(rollcon_contact_set_rolling(contact, 0), 0);
  EXPECT_LT(rollcon_contact_set_friction(contact, "coulomb", 1, &bad_mu), 0);
  EXPECT_LT(rollcon_contact_set_axes(contact, zero, zero, zero), 0);
  EXPECT_LT(rollcon_contact_set_gap_quadratic(contact, 5, std::nan(""), 0), 0);
  EXPECT_LT(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, -4), 0);
  EXPECT_LT(rollcon_contact_set_real(contact, "tolerance", 1), 0);
  ASSERT_OK(rollcon_contact_reset(contact));
  ASSERT_OK(rollcon_contact_solve(contact));
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, after, nullptr));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(before[i], after[i]) << i;
}
