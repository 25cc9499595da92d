/// Tests bodies and frames from files of meshes.

#include <fstream>

#include "body_fixture.hpp"
#include "fem_fixture.hpp"

using namespace capi_test;

namespace {

std::string from_gmsh(const std::string& name) {
  return ROLLCON_TEST_DATA "/meshes/" + name;
}

}  // namespace

class mesh_file : public Api {
 protected:
  void TearDown() override {
    rollcon_body_release(bar);
    Api::TearDown();
  }
  void SetUp() override {
    Api::SetUp();
    if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  }
  void make(std::int32_t kind) {
    rollcon_body_release(bar);
    bar = nullptr;
    ASSERT_OK(rollcon_body_create(context, kind, &bar));
  }
  std::vector<std::int32_t> nodes_of(const char* group) {
    std::int64_t n = 0;
    EXPECT_OK(rollcon_body_get_group_nodes(bar, group, 0, 0, nullptr, &n));
    std::vector<std::int32_t> nodes(static_cast<std::size_t>(n));
    EXPECT_OK(rollcon_body_get_group_nodes(bar, group, 0, n, nodes.data(), nullptr));
    return nodes;
  }
  rollcon_body* bar = nullptr;
};

TEST_F(mesh_file, of_every_kind_makes_a_bar_that_stretches_as_it_should) {
  // A bar of E = 1000, length 2, stress 3 on an end of area 1, and no Poisson's ratio moves its end by 0.006 with every
  // mesh.
  for (const char* name : {"tet4_22.msh", "tet4.msh", "tet10.msh", "tet10.inp", "wedge6.msh", "wedge15.msh",
                           "wedge18_22.msh", "hex8_22.msh", "hex8.inp", "hex20.msh", "hex20.inp", "hex27.msh"}) {
    SCOPED_TRACE(name);
    make(ROLLCON_BODY_FEM);
    ASSERT_OK(rollcon_body_read_mesh(bar, from_gmsh(name).c_str(), "bar"));
    ASSERT_OK(rollcon_body_tag_group(bar, "BAR", 4));
    ASSERT_OK(rollcon_body_tag_group(bar, "high_end", 5));
    ASSERT_OK(rollcon_body_set_elastic(bar, 4, 1000, 0));
    const std::vector<std::int32_t> low = nodes_of("low_end"), high = nodes_of("High_End");
    ASSERT_OK(
        rollcon_body_set_support(bar, static_cast<std::int64_t>(low.size()), low.data(), 0, ROLLCON_DOF_XYZ, nullptr));
    ASSERT_OK(rollcon_body_set_pressure(bar, 5, -3));
    ASSERT_OK(rollcon_body_prepare(bar));
    std::int64_t nodes = 0;
    ASSERT_OK(rollcon_body_get_size(bar, &nodes, nullptr));
    std::vector<double> u(static_cast<std::size_t>(3 * nodes));
    ASSERT_OK(rollcon_body_get_displacements(bar, nodes, u.data()));
    double off = 0;
    for (const std::int32_t node : high)
      off = std::max(off, std::abs(u[3 * static_cast<std::size_t>(node) + 2] - 0.006));
    EXPECT_LT(off, 1e-12);
    std::printf("%-15s %3zu nodes at the end, off by %.1e (bound 1e-12)\n", name, high.size(), off);
  }
}

TEST_F(mesh_file, may_name_the_interface_of_two_materials) {
  const std::string path = "interface_of_a_test.msh";
  std::ofstream(path)
      << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n12\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n"
         "6 1 0 1\n7 1 1 1\n8 0 1 1\n9 0 0 2\n10 1 0 2\n11 1 1 2\n12 0 1 2\n$EndNodes\n$Elements\n5\n"
         "1 5 2 1 1 1 2 3 4 5 6 7 8\n2 5 2 2 2 5 6 7 8 9 10 11 12\n3 3 2 3 3 5 6 7 8\n"
         "4 3 2 4 4 9 10 11 12\n5 3 2 5 5 1 4 3 2\n$EndElements\n";
  make(ROLLCON_BODY_FEM);
  ASSERT_OK(rollcon_body_read_mesh(bar, path.c_str(), ""));
  std::remove(path.c_str());
  EXPECT_EQ(nodes_of("surface 3"), (std::vector<std::int32_t>{4, 5, 6, 7}));
  // A stress of 3 on a length of 1 each gives strains 0.003 and 0.006.
  ASSERT_OK(rollcon_body_set_elastic(bar, 1, 1000, 0));
  ASSERT_OK(rollcon_body_set_elastic(bar, 2, 500, 0));
  ASSERT_OK(rollcon_body_set_support(bar, 4, nodes_of("surface 5").data(), 0, ROLLCON_DOF_XYZ, nullptr));
  EXPECT_FAILS(rollcon_body_set_pressure(bar, 3, -3), ARGUMENT, "tag is 3, which no face has");
  ASSERT_OK(rollcon_body_set_pressure(bar, 4, -3));
  ASSERT_OK(rollcon_body_prepare(bar));
  double u[36];
  ASSERT_OK(rollcon_body_get_displacements(bar, 12, u));
  EXPECT_NEAR(u[35], 0.009, 1e-12);
}

TEST_F(mesh_file, has_groups_that_can_be_listed) {
  make(ROLLCON_BODY_FEM);
  std::int32_t n = -1;
  ASSERT_OK(rollcon_body_get_group_count(bar, &n));
  EXPECT_EQ(n, 0);
  EXPECT_FAILS(rollcon_body_tag_group(bar, "bar", 1), ARGUMENT, "no group 'bar'; its groups: none");
  ASSERT_OK(rollcon_body_read_mesh(bar, from_gmsh("hex8_22.msh").c_str(), ""));
  ASSERT_OK(rollcon_body_get_group_count(bar, &n));
  ASSERT_EQ(n, 4);
  std::set<std::string> names;
  for (std::int32_t i = 0; i < n; ++i) {
    char text[40];
    ASSERT_OK(rollcon_body_get_group_name(bar, i, sizeof text, text, nullptr));
    names.insert(text);
  }
  EXPECT_EQ(names, (std::set<std::string>{"bar", "low_end", "High_End", "origin"}));
  char small[2];
  EXPECT_FAILS(rollcon_body_get_group_name(bar, 0, 2, small, nullptr), CAPACITY, "capacity is 2");
  EXPECT_FAILS(rollcon_body_get_group_name(bar, 4, 2, small, nullptr), ARGUMENT, "i is 4");
  std::int32_t ids[4];
  EXPECT_FAILS(rollcon_body_get_group_nodes(bar, "side", 0, 4, ids, nullptr), ARGUMENT,
               "no group 'side'; its groups: ");
  EXPECT_FAILS(rollcon_body_get_group_nodes(bar, "bar", 0, 4, ids, nullptr), CAPACITY, "capacity is 4 ids; needed: 12");
  EXPECT_FAILS(rollcon_body_get_group_nodes(bar, "bar", 2, 4, ids, nullptr), ARGUMENT, "index_base is 2");
  ASSERT_OK(rollcon_body_get_group_nodes(bar, "origin", 1, 4, ids, nullptr));
  EXPECT_EQ(ids[0], 1);
  // A new mesh drops the groups of the old one.
  const double x[3] = {0, 0, 0};
  ASSERT_OK(rollcon_body_set_nodes(bar, 1, x, 3, 1));
  ASSERT_OK(rollcon_body_get_group_count(bar, &n));
  EXPECT_EQ(n, 0);
}

TEST_F(mesh_file, that_cannot_be_read_leaves_the_body_as_it_was) {
  make(ROLLCON_BODY_FEM);
  ASSERT_OK(rollcon_body_read_mesh(bar, from_gmsh("hex8.inp").c_str(), ""));
  std::int64_t nodes = 0, elements = 0;
  EXPECT_FAILS(rollcon_body_read_mesh(bar, "nowhere.msh", ""), IO, "nowhere.msh: there is no such file");
  EXPECT_FAILS(rollcon_body_read_mesh(bar, from_gmsh("bar.geo").c_str(), ""), IO, "ends in neither .msh");
  EXPECT_FAILS(rollcon_body_read_mesh(bar, from_gmsh("hex8.inp").c_str(), "rail"), ARGUMENT,
               "its groups: Surface1, Surface26, Volume1, low_end, High_End, bar");
  EXPECT_FAILS(rollcon_body_read_mesh(bar, from_gmsh("hex8.inp").c_str(), "low_end"), MESH, "has no volume elements");
  EXPECT_FAILS(rollcon_body_read_mesh(bar, nullptr, ""), ARGUMENT, "path is NULL");
  EXPECT_FAILS(rollcon_body_read_mesh(bar, "a.msh", nullptr), ARGUMENT, "part is NULL");
  EXPECT_FAILS(rollcon_body_read_mesh(sphere, from_gmsh("hex8.inp").c_str(), ""), STATE, "has no mesh");
  ASSERT_OK(rollcon_body_get_size(bar, &nodes, &elements));
  EXPECT_EQ(nodes, 12);
  EXPECT_EQ(elements, 2);
  EXPECT_EQ(nodes_of("low_end").size(), 4U);
}

// What the file has beyond the body's elements is missing in every answer.
TEST_F(mesh_file, is_told_with_answers_where_parts_of_it_were_passed_over) {
  const std::string path = "beam_of_a_test.inp";
  const std::string column =
      "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,3\n6,1,0,3\n7,1,1,3\n8,0,1,3\n"
      "*ELEMENT, TYPE=C3D8\n1, 1,2,3,4,5,6,7,8\n";
  for (const std::string more : {"", "*ELEMENT, TYPE=B31\n2, 1,7\n3, 2,8\n"}) {
    std::ofstream(path) << column << more;
    make(ROLLCON_BODY_FEM);
    ASSERT_OK(rollcon_body_read_mesh(bar, path.c_str(), ""));
    std::remove(path.c_str());
    ASSERT_OK(rollcon_body_set_elastic(bar, 0, 200, 0.3));
    const std::int32_t bottom[] = {0, 1, 2, 3}, element = 0, top = BoxVolume::top, tag = 6;
    ASSERT_OK(rollcon_body_tag_faces(bar, 1, &element, &top, 0, tag));
    ASSERT_OK(rollcon_body_set_contact_faces(bar, 1, &tag));
    ASSERT_OK(rollcon_body_set_support(bar, 4, bottom, 0, ROLLCON_DOF_XYZ, nullptr));
    const double origin[] = {0.5, 0.5, 3}, rolling[] = {1, 0, 0}, normal[] = {0, 0, 1}, mu = 0;
    rollcon_contact* c = nullptr;
    ASSERT_OK(rollcon_contact_create(context, bar, plane, &c));
    EXPECT_OK(rollcon_contact_set_axes(c, origin, rolling, normal));
    EXPECT_OK(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, 8, 8, -0.5, 0.5, -0.5, 0.5));
    EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
    EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.01));
    EXPECT_EQ(rollcon_contact_solve(c), more.empty() ? ROLLCON_OK : ROLLCON_INACCURATE) << error();
    const std::string told = "body 1: its mesh is not all of its file, passed over: elements of type B31 (2)";
    EXPECT_EQ(std::string(rollcon_last_caveat()).find(told) == std::string::npos, more.empty())
        << rollcon_last_caveat();
    rollcon_contact_release(c);
  }
}

TEST_F(mesh_file, gives_rigid_bodies_their_surface) {
  make(ROLLCON_BODY_RIGID);
  ASSERT_OK(rollcon_body_read_mesh(bar, from_gmsh("hex27.msh").c_str(), "High_End"));
  ASSERT_OK(rollcon_body_tag_group(bar, "High_End", 3));
  ASSERT_OK(rollcon_body_set_contact_faces(bar, 1, std::array<std::int32_t, 1>{3}.data()));
  ASSERT_OK(rollcon_body_prepare(bar));
  std::int64_t nodes = 0, elements = 0;
  ASSERT_OK(rollcon_body_get_size(bar, &nodes, &elements));
  EXPECT_EQ(nodes, 9);
  EXPECT_EQ(elements, 1);
  EXPECT_FAILS(rollcon_body_read_mesh(bar, from_gmsh("hex27.msh").c_str(), ""), STATE, "the body is prepared");
}

TEST_F(mesh_file, makes_a_frame_that_solves_as_one_that_was_given) {
  // The frame of the scene is written in Gmsh's way and read again.
  const std::string path = "frame_of_a_test.msh";
  const int n = 9;
  const double half = 0.5;
  std::vector<double> x;
  std::vector<std::int32_t> quads;
  std::ofstream file(path);
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << n * n << "\n";
  file.precision(17);
  for (int k = 0; k < n * n; ++k) {
    x.insert(x.end(), {half * (2.0 * (k % n) / (n - 1) - 1), half * (2.0 * (k / n) / (n - 1) - 1), 0});
    const double* const p = &x[x.size() - 3];
    file << k + 1 << " " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  file << "$EndNodes\n$Elements\n" << (n - 1) * (n - 1) << "\n";
  for (int j = 0, e = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const std::int32_t a = j * n + i;
      quads.insert(quads.end(), {a, a + 1, a + n + 1, a + n});
      file << ++e << " 3 2 1 1 " << a + 1 << " " << a + 2 << " " << a + n + 2 << " " << a + n + 1 << "\n";
    }
  file << "$EndElements\n";
  file.close();
  set_scene();
  double force[2][3];
  for (int from_file = 0; from_file < 2; ++from_file) {
    if (from_file == 1) {
      ASSERT_OK(rollcon_contact_frame_from_file(contact, path.c_str(), "SURFACE 1"));
    } else {
      ASSERT_OK(rollcon_contact_frame_nodes(contact, n * n, x.data(), 3, 1));
      ASSERT_OK(rollcon_contact_frame_add_elements(contact, ROLLCON_QUAD4, (n - 1) * (n - 1), quads.data(), 0, 0));
    }
    ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.5, 0.5, 0));
    ASSERT_GE(rollcon_contact_solve(contact), 0) << rollcon_last_error();
    ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force[from_file], nullptr));
  }
  EXPECT_EQ(force[0][2], force[1][2]);
  EXPECT_NE(force[0][2], 0);
  EXPECT_FAILS(rollcon_contact_frame_from_file(contact, from_gmsh("tet4.msh").c_str(), "bar"), MESH,
               "group bar has no surface elements");
  std::remove(path.c_str());
}
