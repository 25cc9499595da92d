/// Tests rolling of sections that creep: beside half-spaces, the balance of power, orders, symmetries, refusals.

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

#include "contact/prepared.hpp"
#include "contact/scene_fixture.hpp"
#include "contact/solver.hpp"
#include "support/section_bodies.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double young = 12, poisson = 0.4;
const std::vector<double> ratio{0.5}, time{0.03};

/// Describes a ring, finest at its tread, pressed on a plane that is flat across it (bulge 0) or a ball's gap. The
/// frame is its own faces, or a lattice.
struct Rolled {
  double speed = 100, radius = 100, load = 30 / radius;
  std::vector<double> y = frames::uniform_lines(-0.5, 0.5, 2);
  int deep = 8, stations = 6000;
  int lattice = 0;  ///< intervals of a lattice each way; 0: the faces
  double depth = 20, reach = 3, bulge = 0, mu = 0, way = 1;
  Status status = Status::ok;  ///< that the ring ends with
};

struct Rolling {
  std::shared_ptr<Context> context = std::make_shared<Context>();
  std::shared_ptr<Body> body, plane;
  std::unique_ptr<Contact> contact;
  std::array<double, 6> load;

  double resistance() const { return contact->stat("rolling_resistance"); }
  /// Returns how far ahead of the middle the pressure acts.
  double offset() const { return -load[4] / load[2]; }
};

std::vector<double> graded(int n, double from, double to) {
  std::vector<double> line;
  for (int k = 0; k <= n; ++k) {
    const double part = 1 - static_cast<double>(k) / n;
    line.push_back(to - (to - from) * part * part * part);
  }
  return line;
}

/// Returns a frame of the faces of a tread: quad9 between stations.
SurfaceMesh faces(const Rolled& r) {
  const double step = 2 * std::numbers::pi / r.stations;
  const int n = static_cast<int>(std::ceil(r.reach / (2 * r.radius * step))), m = static_cast<int>(r.y.size()) - 1;
  SurfaceMesh mesh;
  mesh.offset = {0};
  for (int j = 0; j <= 2 * m; ++j)
    for (int i = -2 * n; i <= 2 * n; ++i)
      mesh.node.push_back(
          {r.radius * std::sin(i * step), 0.5 * (r.y[surfaces::at(j / 2)] + r.y[surfaces::at((j + 1) / 2)]), r.radius});
  const auto id = [&](int i, int j) { return static_cast<std::int32_t>(j * (4 * n + 1) + i + 2 * n); };
  for (int j = 0; j < 2 * m; j += 2)
    for (int i = -2 * n; i < 2 * n; i += 2)
      surfaces::add_element(mesh, ElementType::quad9,
                            {id(i, j), id(i + 2, j), id(i + 2, j + 2), id(i, j + 2), id(i + 1, j), id(i + 2, j + 1),
                             id(i + 1, j + 2), id(i, j + 1), id(i + 1, j + 1)});
  return mesh;
}

std::unique_ptr<Rolling> make(const Rolled& r, bool half_space = false) {
  auto made = std::make_unique<Rolling>();
  const auto body = [&](BodyKind kind) {
    return std::make_shared<Body>(made->context, static_cast<std::int32_t>(kind));
  };
  made->body = body(half_space ? BodyKind::halfspace : BodyKind::section), made->plane = body(BodyKind::rigid);
  Body& own = *made->body;
  own.set_elastic(0, young, poisson);
  own.set_viscoelastic(0, std::ssize(ratio), ratio.data(), time.data());
  if (!half_space) {
    const sections::Rectangle shape{r.y, graded(r.deep, r.radius - r.depth, r.radius)};
    const SurfaceMesh mesh = sections::rectangle(shape, ElementType::quad8);
    own.set_nodes(mesh.nodes(), mesh.node[0].data(), 3, 1);
    own.add_elements(static_cast<std::int32_t>(mesh.type[0]), mesh.elements(), mesh.connectivity.data(), 0, 0);
    const auto nodes = [&](double z) {
      return surfaces::nodes_where(mesh, [&](const Vec3& x) { return std::abs(x[2] - z) < 1e-9; });
    };
    const auto bore = nodes(r.radius - r.depth), tread = nodes(r.radius);
    own.set_support(std::ssize(bore), bore.data(), 0, 7, nullptr);
    own.tag_faces_of_nodes(std::ssize(tread), tread.data(), 0, 2);
    const std::int32_t tag = 2;
    own.set_contact_faces(1, &tag);
    const double origin[] = {0, 0, 0}, axis[] = {0, 1, 0};
    own.revolve(origin, axis);
    own.set_int("stations", r.stations);
  }
  made->contact = std::make_unique<Contact>(made->context, made->body, made->plane, published);
  Scene& scene = made->contact->scene;
  const double origin[] = {0, 0, r.radius}, rolling[] = {r.way, 0, 0}, normal[] = {0, 0, 1};
  scene.set_axes(origin, rolling, normal);
  const std::vector<double> lines = frames::uniform_lines(-r.reach, r.reach, r.lattice);
  SurfaceMesh frame = r.lattice > 0 ? frames::rectangle(ElementType::quad4, lines, lines) : faces(r);
  if (r.lattice > 0)
    for (Vec3& x : frame.node) x[2] += r.radius;
  scene.set_frame_nodes(frame.nodes(), frame.node[0].data(), 3, 1);
  scene.add_frame_elements(static_cast<std::int32_t>(frame.type[0]), frame.elements(), frame.connectivity.data(), 0, 1);
  scene.set_gap_quadratic(0.5 / r.radius, r.bulge, 0);
  scene.set_friction("coulomb", 1, &r.mu);
  scene.set_speed(r.speed);
  scene.prescribe(3, 2, r.load);
  EXPECT_EQ(made->contact->solve(), half_space ? Status::ok : r.status);
  made->contact->resultant(InAxes::local, made->load.data(), made->load.data() + 3);
  return made;
}

TEST(viscoelastic_section, large_ring_rolls_as_a_half_space) {
  const std::vector<double> y{-16, -7, -3.5, -2.3, -1.8, -1.35, -0.9, -0.45, 0, 0.45, 0.9, 1.35, 1.8, 2.3, 3.5, 7, 16};
  for (const double speed : {30.0, 300.0}) {
    const Rolled r{.speed = speed,
                   .radius = 400,
                   .load = 0.25,
                   .y = y,
                   .stations = 14000,
                   .lattice = 16,
                   .depth = 30,
                   .reach = 2.6,
                   .bulge = 0.5 / 400};
    const auto ring = make(r), half_space = make(r, true);
    const double resistance = ring->resistance() / half_space->resistance() - 1,
                 offset = ring->offset() / half_space->offset() - 1,
                 pressure = ring->contact->stat("max_pressure") / half_space->contact->stat("max_pressure") - 1;
    std::printf("V %3.0f: offset %+.1e, largest pressure %+.1e, resistance %+.1e off a half-space's (bound 1e-2)\n",
                speed, offset, pressure, resistance);
    EXPECT_LT(std::abs(resistance), 1e-2);
    EXPECT_LT(std::abs(offset), 1e-2);
    EXPECT_LT(std::abs(pressure), 1e-2);
    const std::vector<double> power = ring->contact->body_power(1);
    EXPECT_NEAR(std::accumulate(power.begin(), power.end(), 0.0), speed * ring->resistance(), 1e-9 * speed);
  }
}

// Pressures drive the body about its axis where they act: at points that are displaced along the way.
TEST(viscoelastic_section, harmonics_lose_what_the_pressures_drive) {
  for (const double speed : {30.0, 300.0}) {
    const Rolled r{.speed = speed, .stations = 12000};
    const auto ring = make(r);
    const Contact& contact = *ring->contact;
    const SurfaceMesh frame = faces(r);
    std::vector<double> xy, u(3 * frame.node.size()), traction(u.size());
    for (const Vec3& x : frame.node) xy.insert(xy.end(), {x[0], x[1]});
    contact.displacements_at(1, frame.nodes(), xy.data(), u.data());
    contact.tractions(InAxes::local, frame.nodes(), traction.data());
    const std::vector<double>& weight = contact.solver->solution().prepared->problem.weight;
    double driven = ring->load[4] / r.radius * speed;
    for (std::size_t k = 0; k < weight.size(); ++k)
      driven -= weight[k] * traction[3 * k + 2] * u[3 * k] / r.radius * speed;
    const double lost = contact.stat("body_power");
    double sum = 0, least = INFINITY;
    for (const double power : contact.body_power(1)) sum += power, least = std::min(least, power);
    std::printf("V %3.0f: %.6e lost in harmonics, %.6e driven by pressures: %+.1e (bound 1e-3)\n", speed, lost, driven,
                lost / driven - 1);
    EXPECT_GT(driven, 0);
    EXPECT_NEAR(lost, driven, 1e-3 * driven);
    EXPECT_NEAR(sum, lost, 1e-12 * lost);
    EXPECT_GE(least, -1e-12 * lost) << "no harmonic gains power";
  }
}

TEST(viscoelastic_section, coarse_faces_are_told) {
  const std::vector<double> y{-16, -7, -4.5, -3, -1.8, -0.6, 0.6, 1.8, 3, 4.5, 7, 16};
  const Rolled r{.radius = 400,
                 .load = 0.25,
                 .y = y,
                 .deep = 4,
                 .stations = 4200,
                 .lattice = 16,
                 .reach = 2.6,
                 .bulge = 0.5 / 400,
                 .status = Status::inaccurate};
  EXPECT_LT(make(r)->resistance(), 0.95 * make(r, true)->resistance());
}

TEST(viscoelastic_section, rolling_the_other_way_is_the_mirror_image) {
  const auto there = make({.stations = 3000}), back = make({.stations = 3000, .way = -1});
  EXPECT_GT(there->offset(), 0.1);
  EXPECT_NEAR(back->offset(), there->offset(), 1e-6);
  EXPECT_NEAR(back->resistance(), there->resistance(), 1e-6 * there->resistance());
}

TEST(viscoelastic_section, forces_converge) {
  double resistance[3];
  for (int k = 0; k < 3; ++k) resistance[k] = make({.deep = 3 << k, .stations = 1500 << k})->resistance();
  const double order = std::log2(std::abs((resistance[0] - resistance[1]) / (resistance[1] - resistance[2])));
  std::printf("resistance %.6f %.6f %.6f: order %.2f (bound 1)\n", resistance[0], resistance[1], resistance[2], order);
  EXPECT_GT(order, 1);
}

TEST(viscoelastic_section, what_does_not_know_of_creep_refuses) {
  const auto ring = make({.deep = 3, .stations = 2000});
  const auto message = [&](auto work) -> std::string {
    try {
      work(*ring->contact);
    } catch (const Error& e) {
      return e.what();
    }
    return "nothing was thrown";
  };
  EXPECT_NE(message([](Contact& c) { c.body_power(2); }).find("rigid body"), std::string::npos);
  std::vector<double> moved(static_cast<std::size_t>(ring->contact->body_displacements(1, nullptr)));
  ring->contact->body_displacements(1, moved.data());
  const double deepest = *std::min_element(moved.begin(), moved.end()), middle[] = {0, 0, 0};
  double u[3], stress[6];
  ring->contact->fields_at(1, false, 1, middle, u, stress);
  EXPECT_LT(deepest, -1e-3);
  EXPECT_NEAR(u[2], deepest, 0.1 * std::abs(deepest)) << "fields inside know the rate";
  EXPECT_LT(stress[2], 0);
  const double origin[] = {0, 0, Rolled().radius}, across[] = {0, 1, 0}, along[] = {1, 0, 0}, normal[] = {0, 0, 1};
  ring->contact->scene.set_axes(origin, across, normal);
  EXPECT_NE(message([](Contact& c) { c.solve(); }).find("degrees to the way"), std::string::npos);
  ring->contact->scene.set_axes(origin, along, normal);
  ring->contact->scene.set_step(1, 0.1);
  EXPECT_NE(message([](Contact& c) { c.solve(); }).find("steady rolling"), std::string::npos);
  ring->contact->scene.set_step(0, 0);
  EXPECT_EQ(ring->contact->solve(), Status::ok) << "the contact is usable";
}

}  // namespace
}  // namespace rollcon
