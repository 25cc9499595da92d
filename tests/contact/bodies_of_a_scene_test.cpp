/// Tests what a scene takes from its bodies: poses, frames made of faces, gaps from the geometry.

#include "build_info.hpp"
#include "contact/body_geometry.hpp"
#include "contact/contact.hpp"
#include "contact/scene_fixture.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

template <class F>
void expect_refused(F f, Status status, const char* part) {
  try {
    f();
    ADD_FAILURE() << "not refused: " << part;
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), status) << e.what();
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

TEST(pose, only_rotations_are_taken) {
  Scene scene;
  const double zero[3] = {0, 0, 0}, one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto set = [&](const double* r) { return [&scene, r, &zero] { scene.set_pose(1, r, zero); }; };
  const double mirror[9] = {1, 0, 0, 0, 1, 0, 0, 0, -1}, big[9] = {1.00001, 0, 0, 0, 1, 0, 0, 0, 1};
  const double skew[9] = {1, 1e-5, 0, 0, 1, 0, 0, 0, 1};
  double nan[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  nan[5] = NAN;
  expect_refused(set(mirror), Status::err_argument, "determinant -1");
  expect_refused(set(big), Status::err_argument, "orthonormal");
  expect_refused(set(skew), Status::err_argument, "orthonormal");
  expect_refused(set(nan), Status::err_nonfinite, "entry (1, 2) of rotation");
  expect_refused([&] { scene.set_pose(3, one, zero); }, Status::err_argument, "allowed: 1, 2");
  expect_refused([&] { scene.set_pose(1, nullptr, zero); }, Status::err_argument, "rotation");
  EXPECT_EQ(scene.revision.pose[0], 0);

  // A rotation rounded to seven digits is taken, and made orthonormal to the last bits.
  const double c = 0.9210610, s = 0.3894183;  // 0.4 rad
  const double rounded[9] = {c, -s, 0, s, c, 0, 0, 0, 1};
  const double shift[3] = {1, 2, 3};
  scene.set_pose(2, rounded, shift);
  const Pose& pose = scene.pose(1);
  double off = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      off = std::max(off, std::abs(dot(pose.rotation[i], pose.rotation[j]) - (i == j)));
  std::printf("orthonormal to %.1e (bound 1e-15), angle off by %.1e (bound 1e-7)\n", off,
              std::abs(pose.rotation[1][0] - std::sin(0.4)));
  EXPECT_LT(off, 1e-15);
  EXPECT_NEAR(pose.rotation[1][0], std::sin(0.4), 1e-7);
  EXPECT_EQ(scene.revision.pose[1], 1);
  scene.set_pose(2, rounded, shift);
  EXPECT_EQ(scene.revision.pose[1], 1) << "nothing changed";
  scene.set_pose(1, one, zero);
  EXPECT_EQ(scene.revision.pose[0], 0) << "the standard pose";
}

/// Makes a closed box [0,2] x [0,1] x [0,1] of 4 x 2 x 2 elements, tags 1 to 6.
SurfaceMesh box(ElementType type) {
  return surfaces::block(surfaces::brick({4, 2, 2}, {2, 1, 1}), type);
}

TEST(frame_from_body, faces_of_body_1_and_2) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  for (const ElementType type : surfaces::all_types)
    for (const int which : {1, 2}) {
      auto context = std::make_shared<Context>();
      auto solid = std::make_shared<Body>(context, 2);
      auto other = std::make_shared<Body>(context, 4);
      const SurfaceMesh mesh = box(type);
      set_mesh(*solid, mesh, 1);
      Contact contact(context, which == 1 ? solid : other, which == 1 ? other : solid);
      contact.frame_from_body(which, which == 1 ? 6 : 5);  // top of body 1, bottom of body 2
      const int parts = corner_count(type) == 3 ? 2 : 1;
      EXPECT_EQ(contact.elements(), 8 * parts);
      EXPECT_EQ(contact.nodes(),
                static_cast<std::int64_t>(surfaces::nodes_with_tag(mesh, std::array{which == 1 ? 6 : 5}).size()));
      EXPECT_EQ(contact.scene.mesh().index_base, 1);
      const Frame frame = build_frame(contact.scene.mesh(), contact.scene.axes());
      EXPECT_NEAR(frame.area, 2, 1e-13) << "seen from the tip of n";
      for (const Vec3& p : frame.mesh.node) EXPECT_EQ(p[2], which == 1 ? 1 : 0);
      EXPECT_EQ(contact.scene.mesh().tag[0], which == 1 ? 6 : 5);

      // The frame follows its body; the gap belongs to its nodes and stays.
      std::vector<double> gap(static_cast<std::size_t>(contact.nodes()), 0.5);
      contact.scene.set_gap(contact.nodes(), gap.data());
      const double turn[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1}, shift[3] = {5, 6, 7};
      const auto before = contact.scene.revision;
      contact.scene.set_pose(which, turn, shift);
      contact.scene.set_pose(3 - which, turn, shift);
      EXPECT_EQ(contact.scene.revision.mesh, before.mesh);
      EXPECT_TRUE(contact.scene.has_gap());
      for (std::size_t k = 0; k < frame.mesh.node.size(); ++k) {
        const Vec3 p = frame.mesh.node[k];
        EXPECT_LT(length(contact.scene.mesh().node[k] - Vec3{5 - p[1], 6 + p[0], 7 + p[2]}), 1e-14);
      }
    }
}

TEST(frame_from_body, refusals_and_replacement) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  auto context = std::make_shared<Context>();
  auto solid = std::make_shared<Body>(context, 2);
  auto plane = std::make_shared<Body>(context, 3);
  set_mesh(*solid, box(ElementType::quad4));
  Contact contact(context, solid, plane);
  Scene& scene = contact.scene;
  expect_refused([&] { contact.frame_from_body(2, 1); }, Status::err_state, "body 2 has no mesh");
  expect_refused([&] { contact.frame_from_body(1, 17); }, Status::err_argument, "tag is 17");
  expect_refused([&] { contact.frame_from_body(0, 1); }, Status::err_argument, "allowed: 1, 2");
  EXPECT_EQ(contact.nodes(), 0);
  contact.frame_from_body(1, 6);
  const std::int32_t quad[4] = {0, 1, 2, 3};
  expect_refused([&] { scene.add_frame_elements(214, 1, quad, 0, 1); }, Status::err_state,
                 "rollcon_contact_frame_nodes");
  const SurfaceMesh own =
      frames::rectangle(ElementType::quad4, frames::uniform_lines(0, 1, 1), frames::uniform_lines(0, 1, 1));
  scene.set_frame_nodes(4, own.node[0].data(), 3, 1);
  scene.add_frame_elements(214, 1, own.connectivity.data(), 0, 1);
  EXPECT_EQ(contact.nodes(), 4);
  EXPECT_EQ(scene.frame_source().body, -1);
  const double turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, shift[3] = {5, 6, 7};
  scene.set_pose(1, turn, shift);
  EXPECT_EQ(scene.mesh().node[0], own.node[0]) << "the caller's own frame stays";
  // A side face folds to a line in the standard axes.
  contact.frame_from_body(1, 2);
  try {
    build_frame(scene.mesh(), scene.axes());
    ADD_FAILURE() << "not refused";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("rollcon_contact_set_axes"), std::string::npos) << e.what();
  }
}

/// Puts an elastic half-space under a rigid sphere of radius 50 given as a mesh.
struct SphereOnPlane {
  std::shared_ptr<Context> context = std::make_shared<Context>();
  std::shared_ptr<Body> plane = std::make_shared<Body>(context, 3);
  std::shared_ptr<Body> sphere = rigid_body(context, sphere_cap(ElementType::quad9, 16, 1.4, 50, 0, false));
  Contact contact{context, plane, sphere};

  SphereOnPlane() {
    context->set_threads(1);
    plane->set_elastic(1, 1e4, 0.3);
    const double mu = 0.3;
    contact.scene.set_friction("coulomb", 1, &mu);
    contact.scene.prescribe(3, 1, 0.02);
    contact.scene.set_creep(-1.2e-3, 4e-4, 3e-4);
  }
  std::array<double, 3> force(Status status = Status::ok) {
    EXPECT_EQ(contact.solve(), status);
    std::array<double, 3> f{};
    contact.resultant(InAxes::global, f.data(), nullptr);
    return f;
  }
};

double largest_part(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst / std::abs(b[2]);
}

TEST(gap_from_geometry, a_rigid_sphere_given_as_a_mesh) {
  // The scene is solved once more with the sphere's gap as a quadratic form on a flat frame. Slopes are 0.03 at most,
  // and what is left between both is of their second order once the flat frame's tractions are added up in the
  // directions of the sphere: those of the first order cancel by symmetry, except for pressures that lean to one side
  // and for friction towards the middle.
  Pair flat(1e4, 0.3, 1e4, -2);
  standard_scene(flat, 16);
  flat.contact->scene.set_creep(-1.2e-3, 4e-4, 3e-4);
  ASSERT_EQ(flat.contact->solve(), Status::ok);
  const SurfaceMesh mesh = flat.contact->scene.mesh();
  const std::vector<double> t = flat.tractions();
  std::vector<double> weight(mesh.node.size());
  flat.contact->field(Field::weight, InAxes::local, mesh.nodes(), weight.data());
  std::array<double, 3> expected{};
  for (std::size_t k = 0; k < weight.size(); ++k) {
    const double x = mesh.node[k][0] / 50, y = mesh.node[k][1] / 50;
    const Triad local = local_triad({}, leveled({-x, -y, std::sqrt(1 - x * x - y * y)}));
    for (std::size_t c = 0; c < 3; ++c)
      expected[c] += weight[k] * (t[3 * k] * local.t1[c] + t[3 * k + 1] * local.t2[c] + t[3 * k + 2] * local.n[c]);
  }

  SphereOnPlane on_plane, on_sphere;
  on_plane.contact.scene.set_frame_nodes(mesh.nodes(), mesh.node[0].data(), 3, 1);
  on_plane.contact.scene.add_frame_elements(214, mesh.elements(), mesh.connectivity.data(), 0, 1);
  set_mesh(*on_sphere.sphere, sphere_cap(ElementType::quad4, 16, 1.3, 50, 0, false));
  on_sphere.contact.frame_from_body(2, on_sphere.sphere->mesh().surface.tag[0]);
  for (SphereOnPlane* scene : {&on_plane, &on_sphere}) {
    const double difference = largest_part(scene->force(), expected);
    std::printf("frame on the %s: forces differ by %.1e of the normal force (bound 5e-4)\n",
                scene == &on_plane ? "plane" : "sphere", difference);
    EXPECT_LT(difference, 5e-4);
    double worst = 0;
    for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
      worst = std::max(worst, scene->contact.stat(law));
    std::printf("laws: %.1e (bound 1e-8)\n", worst);
    EXPECT_LT(worst, 1e-8);
    const std::string plan = scene->contact.plan();
    EXPECT_NE(plan.find("curved"), std::string::npos) << plan;
    EXPECT_NE(plan.find("from the surfaces"), std::string::npos) << plan;
  }
  EXPECT_NE(on_sphere.contact.plan().find("faces of body 2"), std::string::npos);
  // A gap that is given wins.
  on_plane.contact.scene.set_gap_quadratic(1, 1, 0);
  std::array<double, 3> less = on_plane.force(Status::coarse);
  EXPECT_LT(std::abs(less[2]), 0.2 * std::abs(expected[2]));
}

TEST(gap_from_geometry, results_are_in_the_triads_of_their_nodes) {
  SphereOnPlane scene;
  set_mesh(*scene.sphere, sphere_cap(ElementType::quad4, 16, 1.3, 50, 0, false));
  scene.contact.frame_from_body(2, scene.sphere->mesh().surface.tag[0]);
  const std::array<double, 3> force = scene.force();
  const auto n = static_cast<std::size_t>(scene.contact.nodes());
  const auto get = [&](Field field, InAxes axes) {
    std::vector<double> v(static_cast<std::size_t>(scene.contact.field(field, axes, 0, nullptr)));
    scene.contact.field(field, axes, static_cast<std::int64_t>(v.size()), v.data());
    return v;
  };
  const std::vector<double> local = get(Field::traction, InAxes::local);
  const std::vector<double> global = get(Field::traction, InAxes::global);
  const std::vector<double> point = get(Field::point, InAxes::global);
  const std::vector<double> slip = get(Field::slip, InAxes::global);
  const std::vector<double> weight = get(Field::weight, InAxes::local);
  double resultant[3] = {}, turned = 0, tilt = 0, out_of_plane = 0, fastest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 g{global[3 * k], global[3 * k + 1], global[3 * k + 2]};
    // The outward normal of body 1 is against the sphere's.
    const Vec3 radial{point[3 * k], point[3 * k + 1], point[3 * k + 2] - 50};
    const Vec3 normal = leveled((-1 / length(radial)) * radial);
    turned = std::max(turned, std::abs(dot(g, normal) - local[3 * k + 2]));
    tilt = std::max(tilt, std::abs(g[2] - local[3 * k + 2]));
    for (std::size_t c = 0; c < 3; ++c) resultant[c] += weight[k] * g[c];
    const Vec3 s{slip[3 * k], slip[3 * k + 1], slip[3 * k + 2]};
    out_of_plane = std::max(out_of_plane, std::abs(dot(s, normal)));
    fastest = std::max(fastest, length(s));
  }
  // Normals of facets at the rim of an open surface are one-sided; those in contact are exact.
  std::printf("global tractions along the sphere's normals: off by %.1e (bound 0.05), axes' by %.1e\n", turned, tilt);
  EXPECT_LT(turned, 0.05);
  EXPECT_GT(tilt, 0.1);
  double off = 0;
  for (std::size_t c = 0; c < 3; ++c) off = std::max(off, std::abs(resultant[c] - force[c]));
  std::printf("weights times global tractions: %.1e of the force (bound 1e-9)\n", off / std::abs(force[2]));
  EXPECT_LT(off, 1e-9 * std::abs(force[2]));
  EXPECT_LT(out_of_plane, 0.03 * fastest);
}

}  // namespace
}  // namespace rollcon
