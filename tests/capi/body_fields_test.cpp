// Tests fields inside a body of finite elements under a solved contact: against a half-space under the same contact,
// written as a VTU file, and what they cost.

#include <fstream>
#include <sstream>

#include "block20.hpp"

namespace {

using namespace capi_test;

class body_fields : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &ball));
    if (rollcon_body_create(context, ROLLCON_BODY_FEM, &block) == ROLLCON_ERR_UNSUPPORTED)
      GTEST_SKIP() << "no finite elements in this build";
  }
  void TearDown() override {
    rollcon_contact_release(contact);
    for (rollcon_body* b : {block, ball}) rollcon_body_release(b);
    rollcon_context_release(context);
  }

  void give_block(const Block20& mesh, const std::vector<double>& moved) {
    ASSERT_OK(rollcon_body_set_nodes(block, mesh.nodes(), mesh.x.data(), 3, 1));
    ASSERT_OK(rollcon_body_add_elements(block, ROLLCON_HEX20, static_cast<std::int64_t>(mesh.connectivity.size() / 20),
                                        mesh.connectivity.data(), 0, 0));
    ASSERT_OK(rollcon_body_set_elastic(block, 0, 1000, 0.3));
    ASSERT_OK(rollcon_body_set_support(block, static_cast<std::int64_t>(mesh.rim.size()), mesh.rim.data(), 0,
                                       ROLLCON_DOF_XYZ, moved.empty() ? nullptr : moved.data()));
    ASSERT_OK(
        rollcon_body_tag_faces_of_nodes(block, static_cast<std::int64_t>(mesh.top.size()), mesh.top.data(), 0, 6));
    const std::int32_t tag = 6;
    ASSERT_OK(rollcon_body_set_contact_faces(block, 1, &tag));
  }
  std::vector<double> displacements(rollcon_contact* c) {
    std::int64_t n = 0;
    EXPECT_OK(rollcon_contact_get_body_displacements(c, 1, 0, nullptr, &n));
    std::vector<double> u(static_cast<std::size_t>(n));
    EXPECT_OK(rollcon_contact_get_body_displacements(c, 1, n, u.data(), nullptr));
    return u;
  }
  double statistic(const char* name) {
    double value = 0;
    EXPECT_OK(rollcon_body_get_stat(block, name, &value));
    return value;
  }

  SquareFrame frame{16, 1.3};
  rollcon_context* context = nullptr;
  rollcon_body *block = nullptr, *ball = nullptr;
  rollcon_contact* contact = nullptr;
};

using body_fields_long = body_fields;

// The block's sides and bottom are moved like the half-space moves there.
TEST_F(body_fields_long, under_a_contact_are_those_of_a_half_space) {
  rollcon_body* halfspace = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &halfspace));
  ASSERT_OK(rollcon_body_set_elastic(halfspace, 0, 1000, 0.3));
  rollcon_contact* on_halfspace = press_ball(context, halfspace, ball, frame);
  const Block20 mesh(14, 8, 4, 4);
  std::vector<double> edge, moved;
  for (const std::int32_t k : mesh.rim) edge.insert(edge.end(), mesh.x.begin() + 3 * k, mesh.x.begin() + 3 * k + 3);
  moved.resize(edge.size());
  ASSERT_OK(rollcon_contact_get_fields_at(on_halfspace, 1, static_cast<std::int64_t>(mesh.rim.size()), edge.data(),
                                          ROLLCON_IN_CONTACT, moved.data(), nullptr));
  give_block(mesh, moved);
  contact = press_ball(context, block, ball, frame);
  const std::vector<double> u = displacements(contact);

  std::vector<double> x;
  for (const double depth : {1.2, 1.5, 2.0, 2.5})
    for (const double along : {-1.0, -0.4, 0.0, 0.3, 0.9})
      for (const double across : {0.0, 0.45}) x.insert(x.end(), {along, across, -depth});
  const auto n = static_cast<std::int64_t>(x.size() / 3);
  std::vector<double> s(2 * x.size()), v(x.size()), exact_s(2 * x.size()), exact_v(x.size());
  ASSERT_OK(
      rollcon_contact_get_fields_at(on_halfspace, 1, n, x.data(), ROLLCON_IN_CONTACT, exact_v.data(), exact_s.data()));
  ASSERT_OK(rollcon_body_get_fields_at(block, mesh.nodes(), u.data(), n, x.data(), v.data(), s.data()));
  double pressure = 0, of_stress = 0, of_displacement = 0, largest = 0;
  EXPECT_OK(rollcon_contact_get_stat(on_halfspace, "max_pressure", &pressure));
  for (std::size_t k = 0; k < s.size(); ++k) of_stress = std::max(of_stress, std::abs(s[k] - exact_s[k]) / pressure);
  for (std::size_t k = 0; k < v.size(); ++k) {
    of_displacement = std::max(of_displacement, std::abs(v[k] - exact_v[k]));
    largest = std::max(largest, std::abs(exact_v[k]));
  }
  std::printf(
      "block of %lld nodes beside a half-space, 1.4 radii of the contact deep and more: stress %.1e of the pressure, "
      "displacement "
      "%.1e (bounds 1e-2)\n",
      static_cast<long long>(mesh.nodes()), of_stress, of_displacement / largest);
  EXPECT_LE(of_stress, 1e-2);
  EXPECT_LE(of_displacement / largest, 1e-2);
  rollcon_contact_release(on_halfspace);
  rollcon_body_release(halfspace);
}

// The body's own faces are the frame: the displacements at their nodes are those that the contact knows.
TEST_F(body_fields, of_further_solves_factorise_nothing) {
  const Block20 mesh(4, 3, 4, 4);
  give_block(mesh, {});
  std::vector<std::int32_t> inner;
  for (const std::int32_t k : mesh.top)
    if (std::abs(mesh.x[static_cast<std::size_t>(3 * k)]) < 2 &&
        std::abs(mesh.x[static_cast<std::size_t>(3 * k + 1)]) < 2)
      inner.push_back(k);
  ASSERT_OK(rollcon_body_tag_faces_of_nodes(block, static_cast<std::int64_t>(inner.size()), inner.data(), 0, 7));
  const std::int32_t tags[] = {6, 7};
  ASSERT_OK(rollcon_body_set_contact_faces(block, 2, tags));
  contact = press_ball(context, block, ball, frame, 20, 7);
  const std::vector<double> first = displacements(contact);
  const double factorised = statistic("factorizations");
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 25));
  ASSERT_OK(solve_small(contact));
  const std::vector<double> second = displacements(contact);
  EXPECT_NE(first, second);
  EXPECT_EQ(statistic("factorizations"), factorised);
  double worst = 0, largest = 0;
  for (const std::int32_t k : inner) {
    double there[3];
    ASSERT_OK(rollcon_contact_get_displacements_at(contact, 1, 1, &mesh.x[static_cast<std::size_t>(3 * k)], there));
    for (std::size_t c = 0; c < 3; ++c) {
      worst = std::max(worst, std::abs(there[c] - second[static_cast<std::size_t>(3 * k) + c]));
      largest = std::max(largest, std::abs(there[c]));
    }
  }
  std::printf("nodes of the frame: the body's displacements beside the contact's %.1e (bound 1e-10)\n",
              worst / largest);
  EXPECT_LE(worst / largest, 1e-10);
}

TEST_F(body_fields, are_written_for_viewers) {
  const Block20 mesh(2, 2, 4, 4);
  give_block(mesh, {});
  contact = press_ball(context, block, ball, frame, 20);
  const std::vector<double> u = displacements(contact);
  const std::string path = ::testing::TempDir() + "rollcon_body_fields.vtu";
  const std::int32_t status = rollcon_body_write(block, path.c_str(), mesh.nodes(), u.data());
  if (status == ROLLCON_ERR_UNSUPPORTED) GTEST_SKIP() << "no VTU files in this build";
  ASSERT_EQ(status, ROLLCON_OK) << rollcon_last_error();
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  for (const char* part : {"NumberOfCells=\"8\"", "Name=\"displacement\" NumberOfComponents=\"3\"",
                           "Name=\"stress\" NumberOfComponents=\"6\"", "Name=\"von_mises\"", "Name=\"tag\"", "\n25\n"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
  std::remove(path.c_str());
}

TEST_F(body_fields, refuse_what_they_cannot_give) {
  const Block20 mesh(2, 2, 4, 4);
  give_block(mesh, {});
  std::vector<double> s(static_cast<std::size_t>(6 * mesh.nodes())), u(static_cast<std::size_t>(3 * mesh.nodes()), 0.0);
  EXPECT_FAILS(rollcon_body_get_node_stresses(block, mesh.nodes(), nullptr, s.data()), STATE, "not prepared");
  contact = press_ball(context, block, ball, frame, 20);
  std::int64_t n = 0;
  EXPECT_FAILS(rollcon_contact_get_body_displacements(contact, 2, 0, nullptr, &n), UNSUPPORTED, "body 2 is a rigid");
  EXPECT_FAILS(rollcon_contact_get_body_displacements(contact, 3, 0, nullptr, &n), ARGUMENT, "which is 3");
  EXPECT_FAILS(rollcon_contact_get_body_displacements(contact, 1, 5, u.data(), &n), CAPACITY, "capacity is 5");
  EXPECT_FAILS(rollcon_body_get_node_stresses(ball, mesh.nodes(), nullptr, s.data()), UNSUPPORTED, "rigid");
  EXPECT_FAILS(rollcon_body_get_node_stresses(block, 7, nullptr, s.data()), ARGUMENT, "nodes is 7");
  EXPECT_FAILS(rollcon_body_get_node_stresses(block, mesh.nodes(), nullptr, nullptr), ARGUMENT, "stress is NULL");
  const double outside[3] = {0, 0, 1};
  EXPECT_FAILS(rollcon_body_get_fields_at(block, mesh.nodes(), nullptr, 1, outside, nullptr, s.data()), ARGUMENT,
               "point 0", "outside");
  EXPECT_FAILS(rollcon_body_get_fields_at(block, mesh.nodes(), nullptr, -1, outside, nullptr, s.data()), ARGUMENT,
               "n is -1");
  u[5] = std::numeric_limits<double>::infinity();
  EXPECT_FAILS(rollcon_body_write(block, "never_written.vtu", mesh.nodes(), u.data()), NONFINITE, "node 1");
  EXPECT_OK(rollcon_body_get_point_stresses(block, mesh.nodes(), nullptr, 0, nullptr, nullptr, &n));
  EXPECT_EQ(n, 8 * 27);
}

}  // namespace
