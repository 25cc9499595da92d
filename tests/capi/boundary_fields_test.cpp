// Tests fields inside a body of boundary elements under a solved contact: against a half-space under the same contact,
// on the surface, written as a VTU file, and what is refused.

#include <fstream>
#include <sstream>

#include "block20.hpp"

namespace {

using namespace capi_test;

class boundary_fields : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &ball));
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &halfspace));
    ASSERT_OK(rollcon_body_set_elastic(halfspace, 0, 1000, 0.3));
    if (rollcon_body_create(context, ROLLCON_BODY_BEM, &block) == ROLLCON_ERR_UNSUPPORTED)
      GTEST_SKIP() << "no boundary elements in this build";
  }
  void TearDown() override {
    for (rollcon_contact* c : {contact, on_halfspace}) rollcon_contact_release(c);
    for (rollcon_body* b : {block, ball, halfspace}) rollcon_body_release(b);
    rollcon_context_release(context);
  }

  /// Gives the block; its sides and its bottom are moved like the half-space moves there.
  void give_block(const Surface8& mesh) {
    std::vector<double> edge, moved;
    for (const std::int32_t k : mesh.rim) edge.insert(edge.end(), mesh.x.begin() + 3 * k, mesh.x.begin() + 3 * k + 3);
    moved.resize(edge.size());
    on_halfspace = press_ball(context, halfspace, ball, frame);
    ASSERT_OK(rollcon_contact_get_fields_at(on_halfspace, 1, static_cast<std::int64_t>(mesh.rim.size()), edge.data(),
                                            ROLLCON_IN_CONTACT, moved.data(), nullptr));
    ASSERT_OK(rollcon_body_set_nodes(block, mesh.nodes(), mesh.x.data(), 3, 1));
    ASSERT_OK(rollcon_body_add_elements(block, ROLLCON_QUAD8, static_cast<std::int64_t>(mesh.connectivity.size() / 8),
                                        mesh.connectivity.data(), 0, 5));
    ASSERT_OK(rollcon_body_set_elastic(block, 0, 1000, 0.3));
    ASSERT_OK(rollcon_body_set_support(block, static_cast<std::int64_t>(mesh.rim.size()), mesh.rim.data(), 0,
                                       ROLLCON_DOF_XYZ, moved.data()));
    ASSERT_OK(
        rollcon_body_tag_faces_of_nodes(block, static_cast<std::int64_t>(mesh.top.size()), mesh.top.data(), 0, 6));
    const std::int32_t tag = 6;
    ASSERT_OK(rollcon_body_set_contact_faces(block, 1, &tag));
  }
  struct Error {
    double stress = 0, displacement = 0;  ///< errors over the pressure, and over the largest displacement
  };
  Error beside_halfspace(std::initializer_list<double> depths) {
    std::vector<double> x;
    for (const double depth : depths)
      for (const double along : {-1.0, -0.4, 0.0, 0.3, 0.9})
        for (const double across : {0.0, 0.45}) x.insert(x.end(), {along, across, -depth});
    const auto n = static_cast<std::int64_t>(x.size() / 3);
    std::vector<double> s(2 * x.size()), v(x.size()), exact_s(2 * x.size()), exact_v(x.size());
    EXPECT_OK(rollcon_contact_get_fields_at(on_halfspace, 1, n, x.data(), ROLLCON_IN_CONTACT, exact_v.data(),
                                            exact_s.data()));
    EXPECT_OK(rollcon_contact_get_fields_at(contact, 1, n, x.data(), ROLLCON_IN_BODY, v.data(), s.data()));
    double pressure = 0, largest = 0;
    Error error;
    EXPECT_OK(rollcon_contact_get_stat(on_halfspace, "max_pressure", &pressure));
    for (std::size_t k = 0; k < s.size(); ++k)
      error.stress = std::max(error.stress, std::abs(s[k] - exact_s[k]) / pressure);
    for (std::size_t k = 0; k < v.size(); ++k) {
      error.displacement = std::max(error.displacement, std::abs(v[k] - exact_v[k]));
      largest = std::max(largest, std::abs(exact_v[k]));
    }
    error.displacement /= largest;
    return error;
  }

  SquareFrame frame{16, 1.3};
  rollcon_context* context = nullptr;
  rollcon_body *block = nullptr, *ball = nullptr, *halfspace = nullptr;
  rollcon_contact *contact = nullptr, *on_halfspace = nullptr;
};

using boundary_fields_long = boundary_fields;

TEST_F(boundary_fields_long, under_a_contact_are_those_of_a_half_space) {
  give_block(Surface8(Block20(8, 5, 4, 4)));
  contact = press_ball(context, block, ball, frame);
  for (const double depth : {1e-4, 0.05, 0.2, 0.5, 1.2, 2.0}) {
    const Error error = beside_halfspace({depth});
    std::printf("boundary elements beside a half-space, %g deep: stress %.1e of the pressure, displacement %.1e\n",
                depth, error.stress, error.displacement);
    EXPECT_LE(error.stress, depth > 1 ? 4e-3 : depth > 0.1 ? 0.06 : 0.25);
    EXPECT_LE(error.displacement, depth > 1 ? 6e-3 : 0.02);
  }
}

TEST_F(boundary_fields, under_a_contact_are_near_those_of_a_half_space) {
  give_block(Surface8(Block20(4, 3, 4, 4)));
  contact = press_ball(context, block, ball, frame);
  const Error error = beside_halfspace({1.2, 1.5, 2.0, 2.5});
  std::printf(
      "boundary elements beside a half-space: stress %.1e of the pressure, displacement %.1e (bounds .015, .03)\n",
      error.stress, error.displacement);
  EXPECT_LE(error.stress, 0.015);
  EXPECT_LE(error.displacement, 0.03);
  // Stresses on its surface contain the tractions of the contact; they are written to a file.
  const double place[] = {0.1, 0.05, 0};
  double s[6], t[3];
  ASSERT_OK(rollcon_contact_get_fields_at(contact, 1, 1, place, ROLLCON_IN_BODY, nullptr, s));
  ASSERT_OK(rollcon_contact_write_body(contact, 1, "boundary_fields.vtu"));
  std::ifstream file("boundary_fields.vtu");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const char* part : {"von_mises", "stress", "displacement"}) EXPECT_NE(text.find(part), std::string::npos);
  std::remove("boundary_fields.vtu");
  std::int64_t nodes = 0;
  ASSERT_OK(rollcon_contact_get_size(contact, &nodes, nullptr));
  std::vector<double> tractions(static_cast<std::size_t>(3 * nodes));
  ASSERT_OK(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, nodes, tractions.data()));
  double nearest = 1e30;
  for (std::int64_t k = 0; k < nodes; ++k) {
    const double away = std::hypot(frame.x[static_cast<std::size_t>(3 * k)] - place[0],
                                   frame.x[static_cast<std::size_t>(3 * k + 1)] - place[1]);
    if (away >= nearest) continue;
    nearest = away;
    std::copy_n(tractions.data() + 3 * k, 3, t);
  }
  std::printf("s33 on the surface %.4g, pressure of the nearest node %.4g\n", s[2], -t[2]);
  EXPECT_NEAR(s[2], t[2], 0.05 * std::abs(t[2]));

  // In axes of the contact the block stands turned: its x, y and z are the contact's t2, n and t1.
  const double rotation[9] = {0, 0, 1, 1, 0, 0, 0, 1, 0}, origin[3] = {3, 4, 5}, deep[3] = {0.1, 0.05, -1.5};
  const double there[3] = {deep[2] + 3, deep[0] + 4, deep[1] + 5};
  double u[3], stress[6], turned_u[3], turned[6];
  ASSERT_OK(rollcon_contact_get_fields_at(contact, 1, 1, deep, ROLLCON_IN_BODY, u, stress));
  ASSERT_OK(rollcon_contact_set_pose(contact, ROLLCON_BODY1, rotation, origin));
  ASSERT_OK(rollcon_contact_get_fields_at(contact, 1, 1, there, ROLLCON_IN_CONTACT, turned_u, turned));
  const double expected_u[3] = {u[2], u[0], u[1]};
  const double expected[6] = {stress[2], stress[0], stress[1], stress[4], stress[5], stress[3]};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(turned_u[i], expected_u[i], 1e-9 * std::abs(u[2])) << i;
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(turned[i], expected[i], 1e-9 * std::abs(stress[2])) << i;

  // The body refuses these, and stays usable.
  const double outside[] = {0, 0, -1, 0, 0, 0.5};
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 1, 2, outside, ROLLCON_IN_BODY, nullptr, s), ARGUMENT, "point 1");
  EXPECT_FAILS(rollcon_contact_get_fields_at(contact, 2, 1, place, ROLLCON_IN_BODY, nullptr, s), UNSUPPORTED, "rigid");
  EXPECT_FAILS(rollcon_contact_write_body(contact, 1, "/nowhere/at/all.vtu"), IO, "/nowhere");
  ASSERT_OK(rollcon_contact_get_fields_at(contact, 1, 1, place, ROLLCON_IN_BODY, nullptr, s));
}

}  // namespace
