/// Tests that bad inputs are refused, each with its status and a text that names it, and change nothing.

#include "fixture.hpp"

using namespace capi_test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double origin[3] = {0, 0, 0}, along_x[3] = {1, 0, 0}, along_z[3] = {0, 0, 1};

}  // namespace

class inputs : public Api {};

TEST_F(inputs, body_kinds) {
  rollcon_body* body = nullptr;
  EXPECT_FAILS(rollcon_body_create(context, 0, &body), ARGUMENT, "kind is 0", "3 (half-space)");
  EXPECT_FAILS(rollcon_body_create(context, ROLLCON_BODY_RIGID, nullptr), ARGUMENT, "body is NULL");
  EXPECT_FAILS(rollcon_body_get_kind(sphere, nullptr), ARGUMENT, "kind is NULL");
}

TEST_F(inputs, elastic_constants) {
  for (const double young : {0.0, -1.0})
    EXPECT_FAILS(rollcon_body_set_elastic(sphere, 0, young, 0.3), ARGUMENT, "young", "> 0");
  for (const double poisson : {-1.0, -2.0, 0.5000001, 1.0})
    EXPECT_FAILS(rollcon_body_set_elastic(sphere, 0, 1, poisson), ARGUMENT, "poisson", "<= 0.5");
  for (const double bad : {not_a_number, infinite, -infinite}) {
    EXPECT_FAILS(rollcon_body_set_elastic(sphere, 0, bad, 0.3), NONFINITE, "young");
    EXPECT_FAILS(rollcon_body_set_elastic(sphere, 0, 1, bad), NONFINITE, "poisson");
  }
  EXPECT_OK(rollcon_body_set_elastic(sphere, 0, 1, 0.5));
  EXPECT_OK(rollcon_body_set_elastic(sphere, 0, 1, -0.999));
  EXPECT_FAILS(rollcon_body_set_elastic(plane, 0, 1, 0.3), STATE, "rigid");
}

TEST_F(inputs, prepared_bodies_are_frozen_and_incomplete_ones_cannot_be_prepared) {
  EXPECT_OK(rollcon_body_prepare(sphere));
  EXPECT_OK(rollcon_body_prepare(sphere));
  EXPECT_FAILS(rollcon_body_set_elastic(sphere, 0, 1, 0.3), STATE, "prepared");
  rollcon_body* bare = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &bare));
  EXPECT_FAILS(rollcon_body_prepare(bare), STATE, "elastic");
  rollcon_body_release(bare);
}

TEST_F(inputs, context_settings) {
  EXPECT_FAILS(rollcon_context_set_threads(context, -1), ARGUMENT, "-1", "4096");
  EXPECT_FAILS(rollcon_context_set_threads(context, 5000), ARGUMENT, "5000");
  if (rollcon_has_feature("mpi"))
    EXPECT_FAILS(rollcon_context_set_communicator(context, 0), STATE, "MPI_Init");
  else
    EXPECT_FAILS(rollcon_context_set_communicator(context, 0), UNSUPPORTED, "ROLLCON_WITH_MPI");
  EXPECT_FAILS(rollcon_context_set_log(context, 5, nullptr, nullptr), ARGUMENT, "5");
  EXPECT_FAILS(rollcon_context_set_log(context, -1, nullptr, nullptr), ARGUMENT, "-1");
  EXPECT_OK(rollcon_context_set_threads(context, 0));
}

TEST_F(inputs, frame_nodes) {
  expect_bad_nodes_refused(
      [&](auto n, const double* x, auto stride, auto component) {
        return rollcon_contact_frame_nodes(contact, n, x, stride, component);
      },
      "rollcon_contact_frame_nodes", frame.x);
}

TEST_F(inputs, refused_nodes_leave_the_frame_as_it_was) {
  set_frame();
  std::vector<double> bad = {0, 0, not_a_number};
  EXPECT_EQ(rollcon_contact_frame_nodes(contact, 1, bad.data(), 3, 1), ROLLCON_ERR_NONFINITE);
  std::int64_t nodes = 0, elements = 0;
  ASSERT_OK(rollcon_contact_get_size(contact, &nodes, &elements));
  EXPECT_EQ(nodes, frame.nodes);
  EXPECT_EQ(elements, frame.elements);
  ASSERT_OK(set_nodes(frame));
  ASSERT_OK(rollcon_contact_get_size(contact, nullptr, &elements));
  EXPECT_EQ(elements, 0) << "new nodes forget the elements";
}

TEST_F(inputs, strided_nodes_are_those_of_packed_ones) {
  set_scene();
  const std::int64_t n = frame.nodes;
  std::vector<double> packed(3 * n), by_columns(3 * n), padded(5 * n, not_a_number), found(3 * n);
  for (std::int64_t i = 0; i < n; ++i) {
    for (int j = 0; j < 3; ++j) {
      by_columns[j * n + i] = frame.x[3 * i + j];
      padded[5 * i + j] = frame.x[3 * i + j];
    }
  }
  struct Layout {
    const double* x;
    std::int64_t node, component;
  };
  for (const Layout& layout :
       {Layout{frame.x.data(), 3, 1}, Layout{by_columns.data(), 1, n}, Layout{padded.data(), 5, 1}}) {
    ASSERT_OK(rollcon_contact_frame_nodes(contact, n, layout.x, layout.node, layout.component));
    ASSERT_OK(add_elements(frame));
    ASSERT_OK(rollcon_contact_solve(contact));
    ASSERT_OK(rollcon_contact_get_field(contact, ROLLCON_FIELD_POINT, ROLLCON_GLOBAL, 3 * n, found.data(), nullptr));
    EXPECT_EQ(found, frame.x);
  }
}

TEST_F(inputs, frame_elements) {
  const char* call = "rollcon_contact_frame_add_elements";
  const auto give = [&](auto type, std::int64_t n, const std::int32_t* ids, auto base) {
    return rollcon_contact_frame_add_elements(contact, type, n, ids, base, 0);
  };
  const std::vector<std::int32_t> quads{0, 1, 14, 13, 1, 2, 15, 14};
  EXPECT_EQ(give(ROLLCON_QUAD4, 1, quads.data(), 0), ROLLCON_ERR_STATE);
  expect_text_of(call, {"no nodes"});
  ASSERT_OK(set_nodes(frame));  // 169 nodes
  expect_bad_elements_refused(give, call, ROLLCON_QUAD4, {0, 204, 308, -1}, {"219 (quad9)"});
  expect_ids_named([&](const auto* ids, auto base) { return give(ROLLCON_QUAD4, 2, ids, base); }, call, frame.nodes,
                   {1, 2, 15, 14, 2, 3, 16, 0}, "node 3 of element 1", "node 4 of element 2");
  std::int64_t elements = -1;
  ASSERT_OK(rollcon_contact_get_size(contact, nullptr, &elements));
  EXPECT_EQ(elements, 0);
}

TEST_F(inputs, axes) {
  const double zero[3] = {0, 0, 0}, tilted[3] = {1, 0, 1e-9}, bad[3] = {0, not_a_number, 0};
  EXPECT_FAILS(rollcon_contact_set_axes(contact, nullptr, along_x, along_z), ARGUMENT, "origin");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, nullptr, along_z), ARGUMENT, "rolling");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, along_x, nullptr), ARGUMENT, "normal");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, zero, along_z), ARGUMENT, "rolling is the zero vector");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, along_x, zero), ARGUMENT, "normal is the zero vector");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, along_x, along_x), ARGUMENT, "parallel");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, tilted, along_x), ARGUMENT, "parallel");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, bad, along_x, along_z), NONFINITE, "component y of origin");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, bad, along_z), NONFINITE, "component y of rolling");
  EXPECT_FAILS(rollcon_contact_set_axes(contact, origin, along_x, bad), NONFINITE, "component y of normal");
}

TEST_F(inputs, gap) {
  std::vector<double> gap(static_cast<std::size_t>(frame.nodes), 1.0);
  EXPECT_FAILS(rollcon_contact_set_gap(contact, frame.nodes, gap.data()), STATE, "no nodes");
  ASSERT_OK(set_nodes(frame));
  EXPECT_FAILS(rollcon_contact_set_gap(contact, frame.nodes - 1, gap.data()), ARGUMENT, "169 nodes");
  EXPECT_FAILS(rollcon_contact_set_gap(contact, -5, gap.data()), ARGUMENT, "n is -5");
  EXPECT_FAILS(rollcon_contact_set_gap(contact, frame.nodes, nullptr), ARGUMENT, "gap is NULL");
  for (const double bad : {not_a_number, infinite}) {
    gap[168] = bad;
    EXPECT_FAILS(rollcon_contact_set_gap(contact, frame.nodes, gap.data()), NONFINITE, "gap of node 168");
    EXPECT_FAILS(rollcon_contact_set_gap_quadratic(contact, bad, 0, 0), NONFINITE, "a is");
    EXPECT_FAILS(rollcon_contact_set_gap_quadratic(contact, 0, bad, 0), NONFINITE, "b is");
    EXPECT_FAILS(rollcon_contact_set_gap_quadratic(contact, 0, 0, bad), NONFINITE, "c is");
  }
}

TEST_F(inputs, motion_and_loads) {
  for (const double speed : {0.0, -1.0})
    EXPECT_FAILS(rollcon_contact_set_rolling(contact, speed), ARGUMENT, "speed", "> 0");
  for (const double bad : {not_a_number, infinite, -infinite}) {
    EXPECT_FAILS(rollcon_contact_set_rolling(contact, bad), NONFINITE, "speed");
    EXPECT_FAILS(rollcon_contact_set_creep(contact, bad, 0, 0), NONFINITE, "longitudinal");
    EXPECT_FAILS(rollcon_contact_set_creep(contact, 0, bad, 0), NONFINITE, "lateral");
    EXPECT_FAILS(rollcon_contact_set_creep(contact, 0, 0, bad), NONFINITE, "spin");
    EXPECT_FAILS(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, bad), NONFINITE, "value");
  }
  for (const std::int32_t direction : {0, 5, -1})
    EXPECT_FAILS(rollcon_contact_prescribe(contact, direction, ROLLCON_BY_FORCE, 1), ARGUMENT, "direction",
                 "3 (normal)");
  for (const std::int32_t how : {0, 3})
    EXPECT_FAILS(rollcon_contact_prescribe(contact, ROLLCON_SPIN, how, 1), ARGUMENT, "how", "2 (by force)");
  EXPECT_FAILS(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, -1), ARGUMENT, "load", "0 or more");
  EXPECT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -1));
}

TEST_F(inputs, creep_field) {
  std::vector<double> slip(static_cast<std::size_t>(2 * frame.nodes), 0.0);
  EXPECT_FAILS(rollcon_contact_set_creep_field(contact, frame.nodes, slip.data()), STATE, "no nodes");
  ASSERT_OK(set_nodes(frame));
  EXPECT_FAILS(rollcon_contact_set_creep_field(contact, 3, slip.data()), ARGUMENT, "n is 3");
  EXPECT_FAILS(rollcon_contact_set_creep_field(contact, -1, slip.data()), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_contact_set_creep_field(contact, frame.nodes, nullptr), ARGUMENT, "slip is NULL");
  slip[11] = not_a_number;
  EXPECT_FAILS(rollcon_contact_set_creep_field(contact, frame.nodes, slip.data()), NONFINITE,
               "component 1 of slip of node 5");
  EXPECT_OK(rollcon_contact_set_creep_field(contact, 0, nullptr));
}

TEST_F(inputs, friction) {
  const double good = 0.3, negative = -0.1;
  EXPECT_FAILS(rollcon_contact_set_friction(contact, nullptr, 1, &good), ARGUMENT, "law is NULL");
  EXPECT_FAILS(rollcon_contact_set_friction(contact, "Coulomb", 1, &good), ARGUMENT, "'Coulomb'", "'coulomb'");
  EXPECT_FAILS(rollcon_contact_set_friction(contact, "coulomb", 2, &good), ARGUMENT, "n is 2");
  EXPECT_FAILS(rollcon_contact_set_friction(contact, "coulomb", -1, &good), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_contact_set_friction(contact, "coulomb", 1, nullptr), ARGUMENT, "parameters is NULL");
  EXPECT_FAILS(rollcon_contact_set_friction(contact, "coulomb", 1, &negative), ARGUMENT, "mu is -0.1");
  EXPECT_FAILS(rollcon_contact_set_friction(contact, "coulomb", 1, &not_a_number), NONFINITE, "mu");
  std::vector<double> mu(static_cast<std::size_t>(frame.nodes), 0.2);
  EXPECT_FAILS(rollcon_contact_set_friction_field(contact, frame.nodes, mu.data()), STATE, "no nodes");
  set_frame();
  EXPECT_FAILS(rollcon_contact_set_friction_field(contact, 1, mu.data()), ARGUMENT, "n is 1");
  EXPECT_FAILS(rollcon_contact_set_friction_field(contact, frame.nodes, nullptr), ARGUMENT, "mu is NULL");
  mu[9] = -1;
  EXPECT_FAILS(rollcon_contact_set_friction_field(contact, frame.nodes, mu.data()), ARGUMENT, "mu of node 9");
  mu[9] = infinite;
  EXPECT_FAILS(rollcon_contact_set_friction_field(contact, frame.nodes, mu.data()), NONFINITE, "mu of node 9");
}

TEST_F(inputs, arguments_of_results) {
  std::vector<double> v(static_cast<std::size_t>(3 * frame.nodes));
  std::vector<std::int32_t> s(static_cast<std::size_t>(frame.nodes));
  std::int64_t n = 0;
  set_scene();
  ASSERT_OK(rollcon_contact_solve(contact));
  EXPECT_FAILS(rollcon_contact_get_tractions(contact, 2, frame.nodes, v.data()), ARGUMENT, "axes is 2", "1 (global)");
  EXPECT_FAILS(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, -1, v.data()), ARGUMENT, "capacity is -1");
  EXPECT_FAILS(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes, nullptr), ARGUMENT, "t is NULL");
  for (const std::int32_t field : {0, 14, -1})
    EXPECT_FAILS(rollcon_contact_get_field(contact, field, ROLLCON_LOCAL, 1, v.data(), &n), ARGUMENT, "field",
                 "1 to 13");
  EXPECT_FAILS(rollcon_contact_get_node_states(contact, frame.nodes, nullptr), ARGUMENT, "status is NULL");
  EXPECT_FAILS(rollcon_contact_get_resultant(contact, 7, v.data(), nullptr), ARGUMENT, "axes is 7");
  const double points[4] = {0, 0, 0, not_a_number};
  EXPECT_FAILS(rollcon_contact_get_displacements_at(contact, 3, 1, points, v.data()), ARGUMENT, "which is 3");
  EXPECT_FAILS(rollcon_contact_get_displacements_at(contact, 1, -1, points, v.data()), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_contact_get_displacements_at(contact, 1, INT64_MAX, points, v.data()), ARGUMENT,
               "address space");
  EXPECT_FAILS(rollcon_contact_get_displacements_at(contact, 1, 1, nullptr, v.data()), ARGUMENT, "xy is NULL");
  EXPECT_FAILS(rollcon_contact_get_displacements_at(contact, 1, 1, points, nullptr), ARGUMENT, "u is NULL");
  EXPECT_FAILS(rollcon_contact_get_displacements_at(contact, 1, 2, points, v.data()), NONFINITE,
               "coordinate y of point 1");
  const double inside[6] = {0, 0, -1, 0, 0, not_a_number}, outside[6] = {0, 0, -1, 0, 0, 0.5};
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 0, 1, inside, ROLLCON_IN_CONTACT, nullptr, v.data()), ARGUMENT,
               "which is 0");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, -1, inside, ROLLCON_IN_CONTACT, nullptr, v.data()), ARGUMENT,
               "n is -1");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, INT64_MAX, inside, ROLLCON_IN_CONTACT, nullptr, v.data()),
               ARGUMENT, "address space");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, 1, nullptr, ROLLCON_IN_CONTACT, nullptr, v.data()), ARGUMENT,
               "xyz is NULL");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, 2, inside, ROLLCON_IN_CONTACT, nullptr, v.data()), NONFINITE,
               "coordinate n of point 1");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, 2, outside, ROLLCON_IN_CONTACT, nullptr, v.data()), ARGUMENT,
               "coordinate n of point 1", "0.5", "0 or less");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 2, 1, inside, ROLLCON_IN_CONTACT, nullptr, v.data()), UNSUPPORTED,
               "body 2 is a rigid body");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, 1, inside, 2, nullptr, v.data()), ARGUMENT, "in_axes is 2");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, 2, inside, ROLLCON_IN_BODY, nullptr, v.data()), NONFINITE,
               "coordinate z of point 1");
  const double stress[12] = {1, 2, 3, 4, 5, 6, 1, 2, 3, 4, not_a_number, 6};
  EXPECT_FAILS(rollcon_stress_invariants(-1, stress, v.data(), nullptr, nullptr), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_stress_invariants(1, nullptr, v.data(), nullptr, nullptr), ARGUMENT, "stress is NULL");
  EXPECT_FAILS(rollcon_stress_invariants(2, stress, v.data(), nullptr, nullptr), NONFINITE, "s13 of stress 1");
  EXPECT_FAILS(rollcon_contact_get_stat(contact, "no such number", v.data()), OPTION, "no such number");
  EXPECT_FAILS(rollcon_contact_get_stat(contact, nullptr, v.data()), ARGUMENT, "name");
  EXPECT_FAILS(rollcon_contact_get_stat(contact, "no such number", nullptr), ARGUMENT, "value");
  EXPECT_FAILS(rollcon_contact_write(contact, nullptr), ARGUMENT, "path");
  EXPECT_FAILS(rollcon_contact_write(contact, ""), ARGUMENT, "path");
}
