/// Tests preparation of finite-element bodies: what is missing or wrong is named, the handle stays usable, and the
/// mended body is prepared.

#include "fem_fixture.hpp"

using namespace capi_test;

class fem_prepare : public FemApi {
 protected:
  void set_box(double nu = poisson) {
    set_mesh();
    ASSERT_OK(rollcon_body_set_elastic(body, 0, young, nu));
    ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  }

  /// Gives the nodes once more and what else it takes, after a failure.
  void expect_mended() {
    ASSERT_NO_FATAL_FAILURE(set_box());
    EXPECT_OK(rollcon_body_prepare(body));
    EXPECT_OK(rollcon_body_prepare(body)) << "once more does nothing";
  }
};

TEST_F(fem_prepare, every_tag_of_elements_needs_a_material) {
  ASSERT_OK(set_nodes_of_box());
  ASSERT_OK(add_layers(0, 1, 3));
  ASSERT_OK(add_layers(1, 2, -8));
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  EXPECT_FAILS(rollcon_body_prepare(body), STATE, "rollcon_body_set_elastic");
  ASSERT_OK(rollcon_body_set_elastic(body, 3, young, poisson));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  EXPECT_FAILS(rollcon_body_prepare(body), STATE, "element 4", "from 0", "tag -8", "rollcon_body_set_elastic", "0, 3");
  ASSERT_OK(rollcon_body_set_elastic(body, -8, 2 * young, 0.1));
  EXPECT_OK(rollcon_body_prepare(body));
  EXPECT_FAILS(rollcon_body_set_elastic(body, 3, 1, 0.3), STATE, "prepared");
}

TEST_F(fem_prepare, elements_without_material_are_counted_as_the_caller_does) {
  std::vector<std::int32_t> from_one = box.connectivity;
  for (std::int32_t& id : from_one) ++id;
  ASSERT_OK(set_nodes_of_box());
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_HEX8, 7, from_one.data(), 1, 0));
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_HEX8, 1, &from_one[56], 1, 9));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  EXPECT_FAILS(rollcon_body_prepare(body), STATE, "element 8", "from 1", "tag 9");
}

TEST_F(fem_prepare, tagged_faces_lie_on_the_boundary) {
  set_box();
  const std::int32_t element[2] = {1, 2}, face[2] = {BoxVolume::bottom + 1, BoxVolume::top + 1};
  ASSERT_OK(rollcon_body_tag_faces(body, 2, element, face, 1, 6)) << "more elements might come";
  EXPECT_FAILS(rollcon_body_prepare(body), MESH, "face 2 of element 2", "from 1", "tag 6", "boundary");
  rollcon_contact* c = nullptr;
  ASSERT_OK(rollcon_contact_create(context, body, plane, &c));
  EXPECT_FAILS(rollcon_contact_frame_from_body(c, 1, 6), MESH, "face 2 of element 2");
  rollcon_contact_release(c);
  expect_size(box.nodes(), box.elements());
  expect_mended();
}

TEST_F(fem_prepare, surface_elements_lie_on_the_boundary) {
  set_box();
  const std::int32_t quads[8] = {19, 20, 23, 22, 10, 11, 14, 13};
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_QUAD4, 2, quads, 1, 6));
  EXPECT_FAILS(rollcon_body_prepare(body), MESH, "surface element 2", "tag 6", "from 1", "10, 11, 14, 13");
  expect_mended();
}

TEST_F(fem_prepare, surface_elements_have_the_nodes_of_the_face) {
  const std::vector<std::int32_t> ids = counting(20);
  const std::array<std::pair<std::int32_t, std::int32_t>, 4> wrong{{{ROLLCON_HEX20, ROLLCON_QUAD4},
                                                                    {ROLLCON_HEX20, ROLLCON_QUAD9},
                                                                    {ROLLCON_TET10, ROLLCON_TRI3},
                                                                    {ROLLCON_WEDGE15, ROLLCON_TRI3}}};
  for (const auto& [type, surface] : wrong) {
    set_element(type);
    ASSERT_OK(rollcon_body_add_elements(body, surface, 1, ids.data(), 0, 6));
    EXPECT_FAILS(rollcon_body_prepare(body), MESH, "surface element 0", "tag 6");
  }
  // The bottom of the hexahedron has the midpoints 8 to 11.
  const std::int32_t right[8] = {0, 3, 2, 1, 11, 10, 9, 8};
  set_element(ROLLCON_HEX20);
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_QUAD8, 1, right, 0, 6));
  EXPECT_EQ(frame_size(6), (std::pair<std::int64_t, std::int64_t>(8, 1)));
  EXPECT_OK(rollcon_body_prepare(body));
}

TEST_F(fem_prepare, every_volume_type_is_prepared) {
  for (const std::int32_t type : volume_types) {
    set_element(type);
    ASSERT_OK(rollcon_body_prepare(body)) << type << ": " << error();
    EXPECT_GE(statistic("unknowns"), 3) << type;
  }
}

TEST_F(fem_prepare, turned_elements_are_refused) {
  ASSERT_OK(set_nodes_of_box());
  ASSERT_OK(add_layers(0, 1, 0));
  std::vector<std::int32_t> turned(box.connectivity.begin() + 32, box.connectivity.end());
  for (std::size_t e = 2; e < 4; ++e) std::swap_ranges(&turned[8 * e], &turned[8 * e + 4], &turned[8 * e + 4]);
  for (std::int32_t& id : turned) ++id;
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_HEX8, 4, turned.data(), 1, 0));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  EXPECT_FAILS(rollcon_body_prepare(body), MESH, "inside out", "2 such", "element 7 (hex8)");
  expect_mended();
}

TEST_F(fem_prepare, incompressible_bodies_are_refused) {
  set_box(0.5);
  EXPECT_FAILS(rollcon_body_prepare(body), UNSUPPORTED, "element 0", "from 0", "poisson 0.5", "allowed",
               "boundary-element");
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, 0.4999));
  EXPECT_OK(rollcon_body_prepare(body));
}

TEST_F(fem_prepare, new_nodes_forget_everything_but_the_material) {
  set_box();
  ASSERT_OK(tag_top(6));
  const std::int32_t six = 6, inner = 0, top = BoxVolume::top;
  ASSERT_OK(rollcon_body_set_pressure(body, 6, 1));
  ASSERT_OK(rollcon_body_set_contact_faces(body, 1, &six));
  ASSERT_OK(rollcon_body_tag_faces(body, 1, &inner, &top, 0, 7)) << "an inner face";
  ASSERT_OK(set_nodes_of_box());
  expect_size(box.nodes(), 0);
  EXPECT_FAILS(rollcon_body_set_pressure(body, 6, 1), STATE, "elements: call rollcon_body_add_elements");
  EXPECT_FAILS(rollcon_body_prepare(body), STATE, "no volume elements");
  ASSERT_OK(add_layers(0, 2, 0));
  EXPECT_EQ(frame_size(6).second, -1);
  EXPECT_FAILS(rollcon_body_set_pressure(body, 6, 1), ARGUMENT, "tag is 6");
  EXPECT_FAILS(rollcon_body_prepare(body), SINGULAR, "no supports");
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  ASSERT_OK(rollcon_body_prepare(body));
  std::vector<double> u(box.x.size(), 1.0);
  ASSERT_OK(rollcon_body_get_displacements(body, box.nodes(), u.data()));
  EXPECT_EQ(u, std::vector<double>(u.size(), 0.0)) << "no load is left";
}
