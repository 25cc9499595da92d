/// Tests elements and tags of finite-element bodies: bad ones are refused with their status and a text that names them,
/// and change nothing.

#include "fem_fixture.hpp"

using namespace capi_test;

using Size = std::pair<std::int64_t, std::int64_t>;

class fem_inputs : public FemApi {};

TEST_F(fem_inputs, kind_and_first_steps) {
  std::int32_t kind = 0;
  ASSERT_OK(rollcon_body_get_kind(body, &kind));
  EXPECT_EQ(kind, ROLLCON_BODY_FEM);
  EXPECT_FAILS(rollcon_body_prepare(body), STATE, "rollcon_body_set_elastic");
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  EXPECT_FAILS(rollcon_body_prepare(body), STATE, "volume elements", "rollcon_body_set_nodes",
               "rollcon_body_add_elements");
  const std::vector<std::int32_t> ids = counting(20);
  for (const std::int32_t type : volume_types)
    EXPECT_FAILS(rollcon_body_add_elements(body, type, 1, ids.data(), 0, 0), STATE, "no nodes",
                 "rollcon_body_set_nodes");
  expect_size(0, 0);
}

TEST_F(fem_inputs, every_volume_type_takes_its_number_of_nodes) {
  const std::array<std::int64_t, 6> width{4, 10, 6, 15, 8, 20}, faces{4, 4, 5, 5, 6, 6},
      frame_nodes{4, 4, 6, 6, 8, 20};  // faces with tri6 give their corners
  for (std::size_t t = 0; t < width.size(); ++t) {
    const std::int32_t type = volume_types[t];
    const std::vector<double> x = unit_element(type);
    ASSERT_EQ(static_cast<std::int64_t>(x.size()), 3 * width[t]);
    ASSERT_OK(rollcon_body_set_nodes(body, width[t], x.data(), 3, 1));
    std::vector<std::int32_t> ids = counting(width[t]);
    ids.back() = static_cast<std::int32_t>(width[t]);
    EXPECT_FAILS(rollcon_body_add_elements(body, type, 1, ids.data(), 0, 0), MESH,
                 "node " + std::to_string(width[t] - 1) + " of element 0", "counting from 0",
                 "id " + std::to_string(width[t]), "0 to " + std::to_string(width[t] - 1));
    expect_size(width[t], 0);
    for (std::int32_t& id : ids) id = std::min(id + 1, static_cast<std::int32_t>(width[t]));
    ASSERT_OK(rollcon_body_add_elements(body, type, 1, ids.data(), 1, 0));
    expect_size(width[t], 1);
    EXPECT_EQ(frame_size(0), Size(frame_nodes[t], faces[t])) << "all faces of one element have tag 0";
    const auto last = static_cast<std::int32_t>(faces[t]), none = last + 1;
    const std::int32_t one = 1;
    EXPECT_FAILS(rollcon_body_tag_faces(body, 1, &one, &none, 1, 5), MESH, "entry 1 of faces",
                 "is " + std::to_string(none), "1 to " + std::to_string(last));
    EXPECT_OK(rollcon_body_tag_faces(body, 1, &one, &last, 1, 5));
    EXPECT_EQ(frame_size(5).second, 1);
    EXPECT_EQ(frame_size(0).second, faces[t] - 1);
  }
}

TEST_F(fem_inputs, elements) {
  ASSERT_OK(set_nodes_of_box());
  expect_bad_elements_refused([&](auto type, std::int64_t n, const std::int32_t* ids,
                                  auto base) { return rollcon_body_add_elements(body, type, n, ids, base, 0); },
                              "rollcon_body_add_elements", ROLLCON_HEX8, {0, 204, 303, 308, 351, -1},
                              {"304 (tet4)", "350 (hex20)", "214 (quad4)"});
  expect_size(box.nodes(), 0);
}

TEST_F(fem_inputs, other_bodies_take_no_volume_elements) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  rollcon_body* bem = nullptr;
  const std::vector<std::int32_t> ids = counting(8);
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_BEM, &bem));
  for (rollcon_body* b : {bem, plane}) {
    ASSERT_OK(rollcon_body_set_nodes(b, 8, box.x.data(), 3, 1));
    for (const std::int32_t type : volume_types)
      EXPECT_FAILS(rollcon_body_add_elements(b, type, 1, ids.data(), 0, 0), ARGUMENT, "type is " + std::to_string(type),
                   "219 (quad9)");
  }
  for (rollcon_body* b : {bem, plane, sphere})
    EXPECT_FAILS(rollcon_body_tag_faces(b, 1, ids.data(), ids.data(), 0, 1), STATE, "finite-element");
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(sphere, 4, ids.data(), 0, 1), STATE, "half-space");
  rollcon_body_release(bem);
}

TEST_F(fem_inputs, faces_by_element_and_face) {
  std::int32_t element[2] = {4, 7}, face[2] = {1, 1};
  ASSERT_OK(set_nodes_of_box());
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, face, 0, 6), STATE, "no volume elements",
               "rollcon_body_add_elements");
  set_mesh();
  for (const std::int32_t base : {-1, 2})
    EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, face, base, 6), ARGUMENT, "index_base", "0, 1");
  EXPECT_FAILS(rollcon_body_tag_faces(body, -2, element, face, 0, 6), ARGUMENT, "n is -2");
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, nullptr, face, 0, 6), ARGUMENT, "elements is NULL");
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, nullptr, 0, 6), ARGUMENT, "faces is NULL");
  EXPECT_OK(rollcon_body_tag_faces(body, 0, nullptr, nullptr, 0, 6));
  element[1] = 8;
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, face, 0, 6), MESH, "entry 1 of elements", "from 0", "is 8",
               "0 to 7");
  element[0] = 0;
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, face, 1, 6), MESH, "entry 1 of elements", "from 1", "is 0",
               "1 to 8");
  element[0] = INT32_MIN;
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, face, 1, 6), MESH, "is -2147483648");
  element[0] = element[1] = 7;
  face[1] = 6;
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, face, 0, 6), MESH, "entry 1 of faces", "from 0", "is 6",
               "0 to 5");
  face[0] = 0;
  EXPECT_FAILS(rollcon_body_tag_faces(body, 2, element, face, 1, 6), MESH, "entry 1 of faces", "from 1", "is 0",
               "1 to 6");
  EXPECT_EQ(frame_size(0), Size(26, 24)) << "refused tags change nothing";
  EXPECT_EQ(frame_size(6), Size(-1, -1));
}

TEST_F(fem_inputs, faces_of_nodes) {
  const std::int32_t nodes[2] = {0, 26};
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(body, 2, nodes, 0, 6), STATE, "no nodes");
  ASSERT_OK(set_nodes_of_box());
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(body, 2, nodes, 0, 6), STATE, "elements: call rollcon_body_add_elements",
               "rollcon_body_add_elements");
  set_mesh();
  for (const std::int32_t base : {-1, 2})
    EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(body, 2, nodes, base, 6), ARGUMENT, "index_base", "0, 1");
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(body, -1, nodes, 0, 6), ARGUMENT, "n is -1");
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(body, 1, nullptr, 0, 6), ARGUMENT, "nodes is NULL");
  expect_ids_named([&](const auto* ids, auto base) { return rollcon_body_tag_faces_of_nodes(body, 3, ids, base, 6); },
                   "rollcon_body_tag_faces_of_nodes", box.nodes(), {1, 26, 0}, "entry 2 of nodes", "entry 3 of nodes");
  EXPECT_OK(rollcon_body_tag_faces_of_nodes(body, 0, nullptr, 0, 6));
  EXPECT_OK(rollcon_body_tag_faces_of_nodes(body, 2, nodes, 0, 6)) << "two nodes make no face";
  EXPECT_EQ(frame_size(0), Size(26, 24));
  ASSERT_OK(tag_nodes_at(2, 1, 6));
  EXPECT_EQ(frame_size(6), Size(9, 4));
  EXPECT_EQ(frame_size(0), Size(25, 20));
}

TEST_F(fem_inputs, all_nodes_name_boundary_faces_only) {
  set_mesh();
  const std::vector<std::int32_t> all = counting(box.nodes());
  ASSERT_OK(rollcon_body_tag_faces_of_nodes(body, box.nodes(), all.data(), 0, 3));
  EXPECT_EQ(frame_size(3), Size(26, 24)) << "the node in the middle belongs to no boundary face";
  EXPECT_EQ(frame_size(0), Size(-1, -1));
}

TEST_F(fem_inputs, later_tags_win) {
  set_mesh();
  ASSERT_OK(tag_nodes_at(2, 1, 3));
  const std::int32_t element = 7, face = BoxVolume::top;
  ASSERT_OK(rollcon_body_tag_faces(body, 1, &element, &face, 0, 4));
  EXPECT_EQ(frame_size(3).second, 3);
  EXPECT_EQ(frame_size(4).second, 1);
  const std::int32_t quad[4] = {23, 26, 27, 24};  // that face, counted from 1 and the other way round
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_QUAD4, 1, quad, 1, 5));
  EXPECT_EQ(frame_size(3).second, 3);
  EXPECT_EQ(frame_size(4).second, -1);
  EXPECT_EQ(frame_size(5).second, 1);
  ASSERT_OK(tag_nodes_at(2, 1, 0)) << "0 is a tag too";
  EXPECT_EQ(frame_size(0).second, 24);
}

TEST_F(fem_inputs, tags_do_not_depend_on_the_order_of_calls) {
  // The top is given before its elements are; it applies to those that come later, too.
  ASSERT_OK(set_nodes_of_box());
  ASSERT_OK(add_layers(0, 1, 0));
  ASSERT_OK(tag_nodes_at(2, 1, 6));
  ASSERT_OK(tag_nodes_at(2, 0.5, 7));
  EXPECT_EQ(frame_size(7).second, 4);
  EXPECT_EQ(frame_size(6).second, -1);
  ASSERT_OK(add_layers(1, 2, 0));
  EXPECT_EQ(frame_size(6), Size(9, 4));
  EXPECT_EQ(frame_size(7).second, -1) << "those faces are inside now";
  EXPECT_EQ(frame_size(0), Size(25, 20));
}

TEST_F(fem_inputs, surface_elements_may_come_before_the_volume) {
  std::vector<std::int32_t> quads;
  for (std::int32_t j = 0; j < 2; ++j)
    for (std::int32_t i = 0; i < 2; ++i)
      for (const std::int32_t k : {0, 1, 4, 3}) quads.push_back(18 + 3 * j + i + k);
  ASSERT_OK(set_nodes_of_box());
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_QUAD4, 4, quads.data(), 0, 6));
  expect_size(27, 0);
  quads[7] = 27;
  EXPECT_FAILS(rollcon_body_add_elements(body, ROLLCON_QUAD4, 4, quads.data(), 0, 6), MESH, "node 3 of element 1",
               "id 27", "0 to 26");
  ASSERT_OK(add_layers(0, 2, 0));
  expect_size(27, 8);
  EXPECT_EQ(frame_size(6), Size(9, 4));
}

TEST_F(fem_inputs, tags_of_faces_are_not_those_of_materials) {
  const double t[3] = {0, 0, 1};
  const std::int32_t both[2] = {6, 40};
  ASSERT_OK(set_nodes_of_box());
  EXPECT_FAILS(rollcon_body_set_pressure(body, 0, 1), STATE, "elements: call rollcon_body_add_elements");
  ASSERT_OK(add_layers(0, 2, 40));
  ASSERT_OK(tag_top(6));
  EXPECT_FAILS(rollcon_body_set_traction(body, 40, t), ARGUMENT, "tag is 40", "0, 6");
  EXPECT_FAILS(rollcon_body_set_pressure(body, 40, 1), ARGUMENT, "tag is 40", "0, 6");
  EXPECT_FAILS(rollcon_body_set_contact_faces(body, 2, both), ARGUMENT, "entry 1 of tags", "is 40", "0, 6");
  EXPECT_EQ(frame_size(40).second, -1);
  for (const std::int32_t tag : {0, 6}) {
    EXPECT_OK(rollcon_body_set_traction(body, tag, t));
    EXPECT_OK(rollcon_body_set_pressure(body, tag, 1));
    EXPECT_OK(rollcon_body_set_contact_faces(body, 1, &tag));
  }
}

TEST_F(fem_inputs, boundary_elements_are_tagged_by_their_nodes_too) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  rollcon_body* bem = nullptr;
  std::int64_t n = 0, m = 0;
  const std::int32_t quads[8] = {0, 1, 4, 3, 1, 2, 5, 4};
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_BEM, &bem));
  ASSERT_OK(rollcon_body_set_nodes(bem, 9, box.x.data(), 3, 1));
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(bem, 4, quads, 0, 6), STATE, "elements: call rollcon_body_add_elements");
  ASSERT_OK(rollcon_body_add_elements(bem, ROLLCON_QUAD4, 1, quads, 0, 1));
  const std::vector<std::int32_t> all = counting(9);
  ASSERT_OK(rollcon_body_tag_faces_of_nodes(bem, 9, all.data(), 0, 6));
  ASSERT_OK(rollcon_body_add_elements(bem, ROLLCON_QUAD4, 1, quads + 4, 0, 1));
  rollcon_contact* c = nullptr;
  ASSERT_OK(rollcon_contact_create(context, sphere, bem, &c));
  for (const std::int32_t tag : {6, 1}) {
    ASSERT_OK(rollcon_contact_frame_from_body(c, 2, tag)) << tag;
    ASSERT_OK(rollcon_contact_get_size(c, &n, &m));
    EXPECT_EQ(m, 1) << "elements added later keep the tag they came with";
  }
  EXPECT_FAILS(rollcon_body_tag_faces_of_nodes(bem, 4, quads, 1, 6), MESH, "entry 1 of nodes", "id 0", "1 to 9");
  rollcon_contact_release(c);
  rollcon_body_release(bem);
}
