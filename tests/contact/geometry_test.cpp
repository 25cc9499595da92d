/// Compares normals and gaps from the surfaces of bodies with closed forms of spheres and planes.

#include "contact/scene/geometry.hpp"

#include "contact/body_geometry.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double radius1 = 2, radius2 = 3, clearance = 0.01;
constexpr double cap = 0.7;
constexpr std::int32_t zone_tag = 7;

/// Puts sphere 1 below, touching z = 0, and sphere 2 above, touching z = clearance.
Vec3 normal_of_1(double x, double y) {
  return leveled({x / radius1, y / radius1, std::sqrt(1 - (x * x + y * y) / (radius1 * radius1))});
}
double distance_to_1(const Vec3& p, const Vec3& n) {
  return to_sphere(p, n, {0, 0, -radius1}, radius1);
}
double distance_to_2(const Vec3& p, const Vec3& n) {
  return to_sphere(p, n, {0, 0, clearance + radius2}, radius2);
}

/// Makes the cap with the middle half of its elements, in both directions, tagged as a zone.
SurfaceMesh cap_with_zone(ElementType type, int n, double radius, double height, bool below) {
  SurfaceMesh mesh = sphere_cap(type, n, cap, radius, height, below);
  const int parts = corner_count(type) == 3 ? 2 : 1;
  for (int e = 0; e < static_cast<int>(mesh.elements()); ++e) {
    const int i = e / parts % n, j = e / parts / n;
    const bool inside = 4 * i >= n && 4 * i < 3 * n && 4 * j >= n && 4 * j < 3 * n;
    mesh.tag[static_cast<std::size_t>(e)] = inside ? zone_tag : 1;
  }
  return mesh;
}

enum class On { body1, body2, plane };

struct Errors {
  double normal = 0, gap = 0, mean_gap = 0;
};

/// Returns the largest (and root mean square) errors at the frame's nodes; the frame is a cap of a body or a flat mesh
/// between them.
Errors errors_of(ElementType type, int n, On on, const Pose& pose = {}) {
  auto context = std::make_shared<Context>();
  // The bodies' elements do not match, except on the body that carries the frame.
  auto lower = rigid_body(context, on == On::body1 ? cap_with_zone(type, n, radius1, 0, true)
                                                   : sphere_cap(type, 3 * n / 4, cap, radius1, 0, true));
  auto upper = rigid_body(context, on == On::body2 ? cap_with_zone(type, n, radius2, clearance, false)
                                                   : sphere_cap(type, 3 * n / 4, cap, radius2, clearance, false));
  lower->prepare();
  upper->prepare();
  Scene scene;
  double rotation[9];
  for (std::size_t i = 0; i < 9; ++i) rotation[i] = pose.rotation[i / 3][i % 3];
  scene.set_pose(1, rotation, pose.translation.data());
  scene.set_pose(2, rotation, pose.translation.data());
  if (on == On::body1) scene.set_frame_from(0, lower->mesh().surface, zone_tag);
  if (on == On::body2) scene.set_frame_from(1, upper->mesh().surface, zone_tag);
  if (on == On::plane) {
    const std::vector<double> lines = frames::uniform_lines(-0.45, 0.45, 17);
    const SurfaceMesh mesh = frames::transform(frames::rectangle(ElementType::quad4, lines, lines), [&](const Vec3& p) {
      return pose.place({p[0], p[1], 0.3 * clearance});
    });
    scene.set_frame_nodes(mesh.nodes(), mesh.node[0].data(), 3, 1);
    scene.add_frame_elements(214, mesh.elements(), mesh.connectivity.data(), 0, 1);
  }
  const Vec3 origin = pose.place({0, 0, 0}), t1 = pose.turn({1, 0, 0}), n_axis = pose.turn({0, 0, 1});
  scene.set_axes(origin.data(), t1.data(), n_axis.data());
  const PairOfBodies pair{{lower.get(), upper.get()}, {scene.pose(0), scene.pose(1)}};
  Frame frame = build_frame(scene.mesh(), scene.axes());
  curve_frame(frame, surface_normals(frame, scene.frame_source(), pair));
  const std::vector<double> gap = undeformed_gap(frame, scene.frame_source(), pair);
  Errors worst;
  for (std::size_t k = 0; k < gap.size(); ++k) {
    const Vec3 p = pose.to_body(frame.mesh.node[k]), m = pose.turn_back(frame.n[k]);
    const Vec3 n = normal_of_1(p[0], p[1]);
    worst.normal = std::max(worst.normal, length(m - n));
    const double expected = distance_to_2(p, n) - distance_to_1(p, n);
    worst.gap = std::max(worst.gap, std::abs(gap[k] - expected));
    worst.mean_gap += std::pow(gap[k] - expected, 2);
  }
  worst.mean_gap = std::sqrt(worst.mean_gap / static_cast<double>(gap.size()));
  return worst;
}

TEST(geometry, gap_of_two_spheres) {
  const char* where[] = {"on body 1", "on body 2", "laid between"};
  for (const ElementType type :
       {ElementType::tri3, ElementType::quad4, ElementType::tri6, ElementType::quad8, ElementType::quad9})
    for (const On on : {On::body1, On::body2, On::plane}) {
      const Errors coarse = errors_of(type, 8, on), fine = errors_of(type, 16, on);
      // The bound is a hundredth of the sagitta of linear elements, h^2 (1/8R1 + 1/8R2), twice for a diagonal, because
      // they stand for a smooth surface. The effect of the normal's error is of second order on all.
      const bool quadratic = is_quadratic(type);
      const double h = 2 * cap / 6;
      const double bound = h * h * (1 / radius1 + 1 / radius2) / 4 * 0.01;
      const double order = std::log2(coarse.mean_gap / fine.mean_gap), least = on != On::body1 ? 2.8 : 1.8;
      std::printf("type %d, frame %s: gap error %.1e (bound %.1e), order %.2f (at least %.1f); normals %.1e, %.1e\n",
                  static_cast<int>(type), where[static_cast<int>(on)], coarse.gap, bound, order, least, coarse.normal,
                  fine.normal);
      EXPECT_LT(coarse.gap, bound);
      EXPECT_GT(order, least);
      EXPECT_LT(fine.normal, quadratic ? 2e-3 : 3e-2);
    }
}

TEST(geometry, poses_move_bodies_without_a_trace) {
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(0.4), e = std::sin(0.4);
  const Pose pose{{{{c, -s * d, s * e}, {s, c * d, -c * e}, {0, e, d}}}, {30, -20, 10}};
  for (const On on : {On::body1, On::body2, On::plane}) {
    const Errors still = errors_of(ElementType::quad8, 8, on);
    const Errors moved = errors_of(ElementType::quad8, 8, on, pose);
    const double change = std::max(std::abs(moved.gap - still.gap), std::abs(moved.normal - still.normal));
    std::printf("moved: errors change by %.1e (bound 1e-12)\n", change);
    EXPECT_LT(change, 1e-12);
  }
}

TEST(geometry, a_body_without_mesh_is_the_plane_of_the_axes) {
  auto context = std::make_shared<Context>();
  auto plane = std::make_shared<Body>(context, 4);
  const SurfaceMesh mesh = sphere_cap(ElementType::quad9, 12, 0.8, radius2, clearance, false);
  auto sphere = rigid_body(context, mesh);
  plane->prepare();
  sphere->prepare();
  const std::vector<double> lines = frames::uniform_lines(-0.5, 0.5, 9);
  const SurfaceMesh flat = frames::transform(frames::rectangle(ElementType::tri3, lines, lines), [](const Vec3& p) {
    return Vec3{p[0], p[1], 0.002 * p[0] + 0.001};
  });
  const Frame bare = build_frame(flat, {});
  for (const int which : {0, 1}) {  // number of the body that has the sphere
    Frame frame = bare;
    PairOfBodies pair{{plane.get(), sphere.get()}, {}};
    if (which == 0) {  // the sphere is body 1: turned upside down, below the plane
      pair.body = {sphere.get(), plane.get()};
      pair.pose[0].rotation = {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    }
    curve_frame(frame, surface_normals(frame, {}, pair));
    const std::vector<double> gap = undeformed_gap(frame, {}, pair);
    double worst = 0, largest = 0;
    for (std::size_t k = 0; k < gap.size(); ++k) {
      const Vec3 p = frame.mesh.node[k];
      const double up = which == 1 ? 1 : -1;  // where the centre lies
      const Vec3 centre{0, 0, up * (clearance + radius2)};
      const double rim = std::sqrt(radius2 * radius2 - p[0] * p[0] - p[1] * p[1]);
      const Vec3 n = leveled((1 / radius2) * Vec3{-up * p[0], -up * p[1], rim});
      const double sphere_at = to_sphere(p, n, centre, radius2), plane_at = -p[2] / n[2];
      const double expected = which == 1 ? sphere_at - plane_at : plane_at - sphere_at;
      worst = std::max(worst, std::abs(gap[k] - expected));
      largest = std::max(largest, expected);
    }
    std::printf("sphere as body %d: gap error %.1e of %.2e (bound 2e-5)\n", which + 1, worst, largest);
    EXPECT_LT(worst, 2e-5);
  }
}

TEST(geometry, zones_do_not_break_smooth_normals) {
  // The frame is a tagged part in the middle of a larger surface.
  auto context = std::make_shared<Context>();
  auto body = rigid_body(context, cap_with_zone(ElementType::quad4, 12, radius1, 0, true));
  auto other = std::make_shared<Body>(context, 4);
  body->prepare();
  other->prepare();
  Scene scene;
  scene.set_frame_from(0, body->mesh().surface, zone_tag);
  EXPECT_EQ(scene.mesh().nodes(), 49);
  EXPECT_EQ(scene.mesh().elements(), 36);
  Frame frame = build_frame(scene.mesh(), {});
  curve_frame(frame, surface_normals(frame, scene.frame_source(), {{body.get(), other.get()}, {}}));
  double worst = 0;
  for (std::size_t k = 0; k < frame.n.size(); ++k)
    worst = std::max(worst, length(frame.n[k] - normal_of_1(frame.mesh.node[k][0], frame.mesh.node[k][1])));
  // One-sided normals would be off by half an element: 0.03.
  std::printf("normals of a zone: error %.1e (bound 2e-3)\n", worst);
  EXPECT_LT(worst, 2e-3);
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_mesh);
    return e.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

void expect_text(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in: " << text;
}

TEST(geometry, nodes_beside_a_body_are_named) {
  auto context = std::make_shared<Context>();
  auto plane = std::make_shared<Body>(context, 4);
  auto sphere = rigid_body(context, sphere_cap(ElementType::quad4, 6, 0.3, radius2, clearance, false));
  plane->prepare();
  sphere->prepare();
  const std::vector<double> lines = frames::uniform_lines(-0.4, 0.4, 4);
  SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
  mesh.index_base = 1;
  Frame frame = build_frame(mesh, {});
  const PairOfBodies pair{{plane.get(), sphere.get()}, {}};
  for (const bool normals : {true, false}) {
    const std::string text = refusal([&] {
      if (normals)
        surface_normals(frame, {}, pair);
      else
        undeformed_gap(frame, {}, pair);
    });
    expect_text(text, "16 of the 25 nodes of the frame (counting from 1)");
    expect_text(text, "contact faces of body 2");
    expect_text(text, "16 such node(s) beyond the edge of the body");
    expect_text(text, ": 1, 2, 3, 4, 5, ...");
    EXPECT_EQ(text.find("behind"), std::string::npos) << text;
  }
  // Axes that point the wrong way see from behind all that lies over the body.
  Axes down;
  down.n = {0, 0, -1};
  down.t2 = {0, -1, 0};
  frame = build_frame(surfaces::turn_inside_out(mesh), down);
  const std::string text = refusal([&] { undeformed_gap(frame, {}, pair); });
  expect_text(text, "25 of the 25 nodes");
  expect_text(text,
              "9 such node(s) meet a contact face from behind (the normal of the axes must point out of body 1, into "
              "body 2): 7, 8, 9, 12, 13, ...");
  // Some faces are not offered to contact.
  SurfaceMesh marked = sphere_cap(ElementType::quad4, 6, 0.6, radius2, clearance, false);
  for (std::int64_t e = 0; e < marked.elements(); ++e)
    marked.tag[static_cast<std::size_t>(e)] = unit_normal(marked, e, 0, 0)[0] > 0.05 ? 8 : 9;
  auto half = std::make_shared<Body>(context, 4);
  set_mesh(*half, marked);
  const std::int32_t tag = 9;
  half->set_contact_faces(1, &tag);
  half->prepare();
  frame = build_frame(mesh, {});
  const std::string other = refusal([&] { undeformed_gap(frame, {}, {{plane.get(), half.get()}, {}}); });
  expect_text(other, "over faces that are held, loaded or not among rollcon_body_set_contact_faces");
}

TEST(geometry, frames_that_end_where_the_body_does_may_be_rounded) {
  // The frame has the size of the body, its coordinates written with seven digits.
  auto context = std::make_shared<Context>();
  auto plane = std::make_shared<Body>(context, 4);
  auto sphere = rigid_body(context, sphere_cap(ElementType::quad4, 6, 0.3, radius2, clearance, false));
  plane->prepare();
  sphere->prepare();
  const std::vector<double> lines = frames::uniform_lines(-0.3, 0.3, 6);
  for (const double beyond : {0.0, 3e-8, 1e-5}) {
    const SurfaceMesh mesh =
        frames::stretch(frames::rectangle(ElementType::quad4, lines, lines), 1 + beyond, 1 + beyond);
    const Frame frame = build_frame(mesh, {});
    const PairOfBodies pair{{plane.get(), sphere.get()}, {}};
    if (beyond < 1e-7) {
      const std::vector<double> gap = undeformed_gap(frame, {}, pair);
      double worst = 0;
      for (std::size_t k = 0; k < gap.size(); ++k) {
        const Vec3 p = frame.mesh.node[k];
        const double r2 = p[0] * p[0] + p[1] * p[1];
        worst = std::max(worst, std::abs(gap[k] - clearance - r2 / (radius2 + std::sqrt(radius2 * radius2 - r2))));
      }
      std::printf("beyond the edge by %.0e: gap error %.1e (bound 1e-6)\n", beyond, worst);
      EXPECT_LT(worst, 1e-6);
    } else {
      expect_text(refusal([&] { undeformed_gap(frame, {}, pair); }), "24 of the 49 nodes");
    }
  }
}

TEST(geometry, initial_overlap_is_counted) {
  const std::vector<double> lines = frames::uniform_lines(-1, 1, 4);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, lines, lines), {});
  std::vector<double> gap(static_cast<std::size_t>(frame.nodes()), 0.25);
  gap[3] = -1e-3;
  gap[7] = -2e-3;
  gap[8] = -1e-14;  // rounding
  const InitialOverlap overlap = initial_overlap(frame, gap);
  EXPECT_EQ(overlap.nodes, 2);
  EXPECT_EQ(overlap.depth, 2e-3);
}

}  // namespace
}  // namespace rollcon
