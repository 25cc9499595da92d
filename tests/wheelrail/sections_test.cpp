// Tests wheels and rails by a section in the handle of a wheel on its rail.

#include <cmath>

#include "framing/automatic_frames.hpp"
#include "support/section_bodies.hpp"
#include "wheel_rail_fixture.hpp"

namespace rollcon {
namespace {

using sections::Rectangle;

constexpr double radius = 460, half_gauge = 717.5, load = 80000, young = 210000, poisson = 0.3;
constexpr double speed = 20000, pitch = -1.0005 * speed / radius;

class wheel_sections : public wheels {
 protected:
  using Map = surfaces::Map;
  void SetUp() override {
    arc = profile({}, 300);
    plane = profile({}, 0);
  }
  /// Makes a half-space whose profile is an arc (0: a line) with its top at y = 0.
  std::shared_ptr<Body> profile(std::shared_ptr<Body> body, double of) const {
    body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
    body->set_elastic(0, young, poisson);
    std::vector<double> point;
    for (int y = -40; y <= 40; ++y) point.insert(point.end(), {1.0 * y, height(y, of)});
    body->set_profile(81, point.data(), 0);
    return body;
  }
  static double height(double y, double of) { return of > 0 ? of - std::sqrt(of * of - y * y) : 0; }
  /// Makes a body of a rectangle that is mapped; the side of most z touches, and that of least z is held.
  std::shared_ptr<Body> section(const Rectangle& shape, const Map& map, bool round, double springs = 0) const {
    const SurfaceMesh flat = sections::rectangle(shape, ElementType::quad8);
    const SurfaceMesh mesh = sections::rectangle(shape, ElementType::quad8, map);
    auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::section));
    body->set_elastic(0, young, poisson);
    body->set_nodes(mesh.nodes(), mesh.node.front().data(), 3, 1);
    body->add_elements(static_cast<std::int32_t>(ElementType::quad8), mesh.elements(), mesh.connectivity.data(), 0, 0);
    const auto at = [&](double z) {
      return surfaces::nodes_where(flat, [z](const Vec3& x) { return std::abs(x[2] - z) < 1e-9; });
    };
    const std::vector<std::int32_t> out = at(shape.z.back()), in = at(shape.z.front());
    body->tag_faces_of_nodes(static_cast<std::int64_t>(out.size()), out.data(), 0, 2);
    const std::int32_t tag = 2;
    body->set_contact_faces(1, &tag);
    const double stiff[3] = {springs, springs, springs};
    if (springs > 0) {
      body->tag_faces_of_nodes(static_cast<std::int64_t>(in.size()), in.data(), 0, 3);
      body->set_springs(3, stiff);
    } else {
      body->set_support(static_cast<std::int64_t>(in.size()), in.data(), 0, 7, nullptr);
    }
    const double origin[3] = {0, 0, 0}, y[3] = {0, 1, 0}, x[3] = {1, 0, 0};
    round ? body->revolve(origin, y) : body->extrude(origin, x, 3000);
    return body;
  }
  /// Makes hub, web and rim.
  std::shared_ptr<Body> with_web() const {
    const std::vector<double> r{90, 130, 190, 240, 300, 370, 402, 430, 445, 452, 457, radius};
    return section(
        {{-1, -0.7, -0.45, -0.3, -0.15, 0, 0.15, 0.3, 0.45, 0.7, 1}, r},
        [](const Vec3& x) {
          const double z = x[2];
          const double half = z < 130   ? 80
                              : z < 190 ? 80 - 67 * (z - 130) / 60
                              : z < 370 ? 13
                              : z < 402 ? 13 + 52 * (z - 370) / 32
                                        : 65;
          return Vec3{0, half * x[1], z};
        },
        true);
  }
  std::shared_ptr<Body> disc() const {
    std::vector<double> r{50};
    for (double left = 205; left > 4; left /= 2) r.push_back(radius - left);
    r.push_back(radius);
    return section({{-200, -130, -80, -50, -32, -20, -12, -8, -4, 0, 4, 8, 12, 20, 32, 50, 80, 130, 200}, r}, {}, true);
  }
  std::shared_ptr<Body> rail_section() const {
    return section(
        {{-36, -28, -20, -14, -9, -6, -3, 0, 3, 6, 9, 14, 20, 28, 36}, {-1, -0.7, -0.45, -0.25, -0.12, -0.05, 0}},
        [](const Vec3& x) {
          const double top = height(x[1], 300);
          return Vec3{0, x[1], top - (170 - top) * x[2]};
        },
        false, 5);
  }
  std::unique_ptr<WheelRail> on_rail(std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail, double y,
                                     std::int32_t side = 1) const {
    auto w = std::make_unique<WheelRail>(context, std::move(wheel), std::move(rail), side);
    w->set_track(2 * half_gauge, 0, 1.0 / 40);
    w->set_wheelset(2 * half_gauge, 0, radius);
    w->set_friction(mu);
    const double velocity[6] = {speed, 0, 0, 0, 0, pitch}, position[6] = {0, side * y, 0, 0, 0, 0};
    w->set_velocity(velocity);
    w->set_position(position);
    w->prescribe_vertical(2, load);
    return w;
  }
  std::shared_ptr<Body> arc, plane;
};

using wheel_sections_long = wheel_sections;

/// Solves a contact of the same bodies in the track, at the height found, and expects the handle's answer.
TEST_F(wheel_sections_long, carry_the_load_at_the_height_that_their_own_contact_has) {
  const double y = 12, cant = 1.0 / 40;
  const auto body = with_web();
  const auto wheel = on_rail(body, arc, y), stiff = on_rail(plane, arc, y);
  ASSERT_EQ(wheel->solve(), Status::ok);
  ASSERT_EQ(stiff->solve(), Status::ok);
  EXPECT_NEAR(wheel->stat("vertical_force"), load, 1e-6 * load);
  const double z = wheel->stat("z");
  EXPECT_GT(z - stiff->stat("z"), 0.1 * stiff->patch_stat(0, "overlap"));  // the web bends

  const auto rail = arc->with_profile_alone();
  const double origin[3] = {0, half_gauge, 0}, along[3] = {1, 0, 0}, down[3] = {0, std::sin(cant), std::cos(cant)};
  rail->extrude_profile(origin, along, down);
  Contact contact(context, body, rail, nullptr, make_frame_maker);
  const Axes axes = wheel->patch_axes(0);
  contact.scene.set_axes(axes.origin.data(), axes.t1.data(), axes.n.data());
  const double turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, place[3] = {0, half_gauge + y, z - radius};
  contact.scene.set_pose(1, turn, place);
  const double none[3] = {0, 0, 0}, forward[3] = {speed, 0, 0}, rolls[3] = {0, pitch, 0};
  contact.scene.set_velocity(0, forward, none, none);
  contact.scene.set_velocity(1, forward, rolls, place);
  contact.scene.set_velocity(2, none, none, none);
  contact.scene.set_friction("coulomb", 1, &mu);
  contact.scene.prescribe(3, static_cast<std::int32_t>(How::by_force), wheel->patch_stat(0, "normal_force"));
  ASSERT_EQ(contact.solve(), Status::ok);
  double approach = 1;
  contact.motion(&approach, nullptr);
  EXPECT_NEAR(approach, 0, 1e-3 * (z - stiff->stat("z")));
  Vec3 force;
  contact.resultant(InAxes::local, force.data(), nullptr);
  EXPECT_NEAR(force[0], wheel->patch_stat(0, "longitudinal_force"), 0.005 * mu * load);
  EXPECT_NEAR(contact.stat("max_pressure"), wheel->patch_stat(0, "max_pressure"), 0.002 * contact.stat("max_pressure"));

  // The height gives the force back, and so does the mirror image.
  const double position[6] = {0, -y, z, 0, 0, 0};
  const auto left = on_rail(body, arc, y, -1);
  left->set_position(position);
  left->prescribe_vertical(1, 0);
  ASSERT_EQ(left->solve(), Status::ok);
  EXPECT_NEAR(left->stat("vertical_force"), load, 5e-4 * load);
  EXPECT_EQ(left->stat("z"), z);
  EXPECT_NEAR(left->patch_stat(0, "lateral_force"), -wheel->patch_stat(0, "lateral_force"), 1e-3 * mu * load);
}

TEST_F(wheel_sections_long, are_half_spaces_where_they_are_large) {
  const auto large = on_rail(disc(), arc, 0), half = on_rail(plane, arc, 0);
  ASSERT_EQ(large->solve(), Status::ok);
  ASSERT_EQ(half->solve(), Status::ok);
  const auto off = [&](const char* name) { return large->patch_stat(0, name) / half->patch_stat(0, name) - 1; };
  EXPECT_NEAR(large->stat("z") - half->stat("z"), 0, 5e-3 * half->patch_stat(0, "overlap"));
  EXPECT_NEAR(off("max_pressure"), 0, 0.015);
  EXPECT_NEAR(off("area"), 0, 0.005);
  EXPECT_NEAR(off("longitudinal_force"), 0, 0.04);  // the tread is stretched by 1.3e-5, and so is the creepage
}

TEST_F(wheel_sections_long, rails_bend_on_their_foundation) {
  const auto bent = on_rail(with_web(), rail_section(), 5), wheel = on_rail(with_web(), arc, 5);
  ASSERT_EQ(bent->solve(), Status::ok);
  ASSERT_EQ(wheel->solve(), Status::ok);
  EXPECT_NEAR(bent->patch_stat(0, "area") / wheel->patch_stat(0, "area"), 1, 0.03);
  EXPECT_NEAR(bent->patch_stat(0, "y"), wheel->patch_stat(0, "y"), 1e-3);
  // The rail of 72 x 170 mm moves as a beam on Winkler's foundation, P / (8 EI beta^3), and a little more by shear.
  const double foundation = 5 * 72, bending = young * 72 * std::pow(170, 3) / 12,
               beta = std::pow(foundation / (4 * bending), 0.25), beam = load / (8 * bending * std::pow(beta, 3));
  EXPECT_NEAR((bent->stat("z") - wheel->stat("z")) / beam, 1.1, 0.1);
}

TEST_F(wheel_sections, say_what_they_do_not_take) {
  const auto body = with_web();
  auto wheel = on_rail(body, arc, 0);
  wheel->set_int("conformal", 1);
  refused([&] { wheel->solve(); }, Status::err_unsupported, {"section", "conformal"});
  wheel->set_int("conformal", 0);
  ASSERT_EQ(wheel->solve(), Status::ok);
  refused([&] { wheel->derivative(1); }, Status::err_unsupported, {"section", "derivatives"});
  wheel->set_wheelset(2 * half_gauge, 0, 500);
  refused([&] { wheel->solve(); }, Status::err_argument, {"radius", "500", "460"});
  const auto rail = rail_section();
  refused([&] { on_rail(rail, arc, 0)->solve(); }, Status::err_argument, {"radius"});
  const auto turned = with_web();
  const double origin[3] = {0, 0, 0}, x[3] = {1, 0, 0};
  turned->revolve(origin, x);
  EXPECT_THROW(on_rail(turned, arc, 0), Error);
}

TEST_F(wheel_sections_long, copies_and_snapshots_solve_again) {
  const auto wheel = on_rail(with_web(), arc, 0);
  ASSERT_EQ(wheel->solve(), Status::ok);
  const double pressure = wheel->patch_stat(0, "max_pressure"), z = wheel->stat("z");
  wheel->snapshot(0);
  wheel->prescribe_vertical(2, 0.5 * load);
  ASSERT_EQ(wheel->solve(), Status::ok);
  EXPECT_LT(wheel->patch_stat(0, "max_pressure"), 0.9 * pressure);
  wheel->rollback(0);
  EXPECT_EQ(wheel->patch_stat(0, "max_pressure"), pressure);
  EXPECT_EQ(wheel->copy()->stat("z"), z);
}

}  // namespace
}  // namespace rollcon
