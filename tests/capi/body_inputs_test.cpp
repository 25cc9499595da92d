/// Tests mesh, supports and loads of bodies: bad ones are refused with their status and a text that names them, and
/// change nothing.

#include "body_fixture.hpp"

using namespace capi_test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

class body_inputs : public BodyApi {};

TEST_F(body_inputs, half_spaces_have_no_mesh_and_rigid_bodies_no_loads) {
  const std::int32_t tags[1] = {1}, nodes[1] = {0};
  const double t[3] = {1, 0, 0};
  EXPECT_FAILS(rollcon_body_set_nodes(sphere, 1, t, 3, 1), STATE, "half-space", "nodes");
  EXPECT_FAILS(rollcon_body_add_elements(sphere, ROLLCON_QUAD4, 0, nullptr, 0, 1), STATE, "half-space", "elements");
  EXPECT_FAILS(rollcon_body_set_contact_faces(sphere, 1, tags), STATE, "half-space", "contact faces");
  set_mesh(plane);
  EXPECT_OK(rollcon_body_set_contact_faces(plane, 1, tags));
  for (rollcon_body* b : {sphere, plane}) {
    const char* kind = b == sphere ? "half-space" : "rigid";
    EXPECT_FAILS(rollcon_body_set_support(b, 1, nodes, 0, ROLLCON_DOF_X, nullptr), STATE, kind, "supports");
    EXPECT_FAILS(rollcon_body_set_traction(b, 1, t), STATE, kind, "tractions");
    EXPECT_FAILS(rollcon_body_set_pressure(b, 1, 1), STATE, kind, "pressures");
  }
}

TEST_F(body_inputs, nodes) {
  expect_bad_nodes_refused([&](auto n, const double* x, auto stride,
                               auto component) { return rollcon_body_set_nodes(body, n, x, stride, component); },
                           "rollcon_body_set_nodes", cube.x);
  expect_size(0, 0);
}

TEST_F(body_inputs, elements) {
  const char* call = "rollcon_body_add_elements";
  const auto give = [&](auto type, std::int64_t n, const std::int32_t* ids, auto base) {
    return rollcon_body_add_elements(body, type, n, ids, base, 1);
  };
  const std::vector<std::int32_t> quads{1, 2, 3, 4, 5, 6, 7, 0};
  EXPECT_EQ(give(ROLLCON_QUAD4, 1, quads.data(), 0), ROLLCON_ERR_STATE);
  expect_text_of(call, {"no nodes", "rollcon_body_set_nodes"});
  ASSERT_OK(rollcon_body_set_nodes(body, cube.nodes(), cube.x.data(), 3, 1));
  expect_bad_elements_refused(give, call, ROLLCON_QUAD4, {0, 204, 308, -1}, {"219 (quad9)"});
  expect_ids_named([&](const auto* ids, auto base) { return give(ROLLCON_QUAD4, 2, ids, base); }, call, cube.nodes(),
                   quads, "node 3 of element 1", "node 4 of element 2");
  expect_size(cube.nodes(), 0);
}

TEST_F(body_inputs, supports) {
  const std::int32_t nodes[2] = {0, 1};
  const double values[6] = {};
  EXPECT_FAILS(rollcon_body_set_support(body, 2, nodes, 0, ROLLCON_DOF_X, nullptr), STATE, "no nodes");
  set_mesh(body);
  for (const std::int32_t mask : {0, 8, -1, INT32_MIN})
    EXPECT_FAILS(rollcon_body_set_support(body, 2, nodes, 0, mask, values), ARGUMENT,
                 "dof_mask is " + std::to_string(mask), "1 to 7");
  for (const std::int32_t base : {-1, 2})
    EXPECT_FAILS(rollcon_body_set_support(body, 2, nodes, base, ROLLCON_DOF_X, values), ARGUMENT, "index_base");
  EXPECT_FAILS(rollcon_body_set_support(body, -2, nodes, 0, ROLLCON_DOF_X, values), ARGUMENT, "n is -2");
  EXPECT_FAILS(rollcon_body_set_support(body, 2, nullptr, 0, ROLLCON_DOF_X, values), ARGUMENT, "nodes is NULL");
  EXPECT_OK(rollcon_body_set_support(body, 0, nullptr, 0, ROLLCON_DOF_X, nullptr));
}

TEST_F(body_inputs, nodes_of_supports_are_named_as_the_caller_counts) {
  set_mesh(body);
  expect_ids_named(
      [&](const auto* ids, auto base) { return rollcon_body_set_support(body, 3, ids, base, ROLLCON_DOF_X, nullptr); },
      "rollcon_body_set_support", cube.nodes(), {1, 25, 0}, "entry 2 of nodes", "entry 3 of nodes");
}

TEST_F(body_inputs, given_displacements_are_finite_where_they_are_used) {
  set_mesh(body);
  const std::int32_t nodes[2] = {1, 2};
  for (const double bad : {not_a_number, infinite}) {
    const double values[6] = {0, 0, 0, 0, bad, 0};
    EXPECT_FAILS(rollcon_body_set_support(body, 2, nodes, 1, ROLLCON_DOF_Y, values), NONFINITE,
                 "component y of entry 2 of values", "from 1");
    EXPECT_OK(rollcon_body_set_support(body, 2, nodes, 1, ROLLCON_DOF_X + ROLLCON_DOF_Z, values))
        << "components that are not held are not read";
  }
}

TEST_F(body_inputs, a_refused_support_holds_nothing) {
  set_mesh(body);
  std::vector<std::int32_t> nodes = cube.nodes_at(2, 0);
  const auto n = static_cast<std::int64_t>(nodes.size());
  std::vector<double> values(3 * nodes.size(), 0.0);
  values.back() = not_a_number;
  ASSERT_EQ(rollcon_body_set_support(body, n, nodes.data(), 0, ROLLCON_DOF_XYZ, values.data()), ROLLCON_ERR_NONFINITE);
  nodes.back() = -1;
  ASSERT_EQ(rollcon_body_set_support(body, n, nodes.data(), 0, ROLLCON_DOF_XYZ, nullptr), ROLLCON_ERR_MESH);
  EXPECT_FAILS(rollcon_body_prepare(body), SINGULAR, "no supports");
}

TEST_F(body_inputs, loads) {
  const double t[3] = {0, 0, 1};
  EXPECT_FAILS(rollcon_body_set_traction(body, 6, t), STATE, "no elements");
  EXPECT_FAILS(rollcon_body_set_pressure(body, 6, 1), STATE, "no elements");
  set_mesh(body);
  for (const std::int32_t tag : {0, 7, -1, INT32_MAX}) {
    EXPECT_FAILS(rollcon_body_set_traction(body, tag, t), ARGUMENT, "tag is " + std::to_string(tag),
                 "1, 2, 3, 4, 5, 6");
    EXPECT_FAILS(rollcon_body_set_pressure(body, tag, 1), ARGUMENT, "tag is " + std::to_string(tag),
                 "1, 2, 3, 4, 5, 6");
  }
  EXPECT_FAILS(rollcon_body_set_traction(body, 6, nullptr), ARGUMENT, "traction is NULL");
  for (const double bad : {not_a_number, infinite, -infinite}) {
    const double wrong[3] = {0, bad, 0};
    EXPECT_FAILS(rollcon_body_set_traction(body, 6, wrong), NONFINITE, "component y of traction");
    EXPECT_FAILS(rollcon_body_set_pressure(body, 6, bad), NONFINITE, "pressure is");
  }
}

// Larger values would leave the range of doubles on their way, and come out as what is not a number.
TEST_F(body_inputs, what_no_result_can_bear_is_refused) {
  set_mesh(body);
  const double wrong[3] = {0, -1e101, 0}, most[3] = {0, -1e100, 0};
  const std::int32_t node = 3;
  EXPECT_FAILS(rollcon_body_set_traction(body, 6, wrong), ARGUMENT, "component y of traction is -1e+101",
               "-1e+100 to 1e+100");
  EXPECT_FAILS(rollcon_body_set_pressure(body, 6, 1e101), ARGUMENT, "pressure is 1e+101", "-1e+100 to 1e+100");
  EXPECT_FAILS(rollcon_body_set_support(body, 1, &node, 1, ROLLCON_DOF_XYZ, wrong), ARGUMENT,
               "component y of entry 1 of values (counting from 1) is -1e+101", "-1e+100 to 1e+100");
  EXPECT_OK(rollcon_body_set_traction(body, 6, most));
  EXPECT_OK(rollcon_body_set_support(body, 1, &node, 1, ROLLCON_DOF_X, wrong))
      << "a component that is not held is not looked at";
}

TEST_F(body_inputs, contact_faces) {
  const std::int32_t tags[3] = {6, 6, 9};
  EXPECT_FAILS(rollcon_body_set_contact_faces(body, 1, tags), STATE, "no elements");
  set_mesh(body);
  EXPECT_FAILS(rollcon_body_set_contact_faces(body, 3, tags), ARGUMENT, "entry 2 of tags", "is 9", "1, 2, 3, 4, 5, 6");
  EXPECT_FAILS(rollcon_body_set_contact_faces(body, -1, tags), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_body_set_contact_faces(body, 1, nullptr), ARGUMENT, "tags is NULL");
  EXPECT_OK(rollcon_body_set_contact_faces(body, 2, tags));
  EXPECT_OK(rollcon_body_set_contact_faces(body, 0, nullptr));
}

TEST_F(body_inputs, bad_surfaces_are_refused) {
  ASSERT_OK(rollcon_body_set_nodes(body, cube.nodes(), cube.x.data(), 3, 1));
  for (std::int32_t f = 0; f < 5; ++f)
    ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_QUAD4, cube.face_elements(),
                                        cube.face[static_cast<std::size_t>(f)].data(), 0, f));
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  // One node of 26 is not used, because the lid is missing.
  EXPECT_FAILS(rollcon_body_prepare(body), MESH, "node", "25");
  std::vector<std::int32_t> lid = cube.face[5];
  for (std::size_t e = 0; e < lid.size(); e += 4) std::swap(lid[e + 1], lid[e + 3]);
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_QUAD4, cube.face_elements(), lid.data(), 0, 5));
  EXPECT_FAILS(rollcon_body_prepare(body), MESH, "flipped element", "4 such", "element 20");
}
