/// Tests frames on bodies, all or some of whose nodes stand on the body's, in any pose.

#include "bodies/frame_on_body.hpp"

#include <chrono>

#include "contact/body_geometry.hpp"
#include "contact/scene/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using contact_test::rigid_body;
using contact_test::sphere_cap;
using frames::uniform_lines;
using surfaces::name_of;

Pose turned(double a, double b, const Vec3& translation) {
  const double c = std::cos(a), s = std::sin(a), d = std::cos(b), e = std::sin(b);
  return {{{{c, -s * d, s * e}, {s, c * d, -c * e}, {0, e, d}}}, translation};
}

void set_pose(Scene& scene, std::int32_t which, const Pose& pose) {
  double rotation[9];
  for (std::size_t i = 0; i < 9; ++i) rotation[i] = pose.rotation[i / 3][i % 3];
  scene.set_pose(which, rotation, pose.translation.data());
}

/// Makes `mesh`, given in the coordinates of the scene, a body standing in this pose.
std::shared_ptr<Body> standing(const std::shared_ptr<Context>& context, const SurfaceMesh& mesh, const Pose& pose) {
  auto body = rigid_body(context, frames::transform(mesh, [&](const Vec3& x) { return pose.to_body(x); }));
  body->prepare();
  return body;
}

TEST(frame_on_body, nodes_of_the_other_body_are_recognised_in_any_pose) {
  const Pose poses[] = {{}, turned(0.7, -0.4, {30, -20, 10}), turned(-2.1, 1.3, {-400, 700, 250})};
  for (const ElementType type : surfaces::all_types)
    for (const Pose& pose1 : poses)
      for (const Pose& pose2 : poses) {
        // The caps have different radii and face each other, divided alike along z; the whole stands somewhere, too.
        const Pose place = turned(0.3, 0.5, {5, 6, -7});
        const auto at_place = [&](const Vec3& x) { return place.place(x); };
        auto context = std::make_shared<Context>();
        auto lower = standing(context, frames::transform(sphere_cap(type, 6, 0.5, 3, 0, true), at_place), pose1);
        auto upper = standing(context, frames::transform(sphere_cap(type, 6, 0.5, 5, 0.01, false), at_place), pose2);
        Scene scene;
        set_pose(scene, 1, pose1);
        set_pose(scene, 2, pose2);
        scene.set_frame_from(0, lower->mesh().surface, lower->mesh().surface.tag[0]);
        const Vec3 origin = place.place({0, 0, 0}), t1 = place.turn({1, 0, 0}), n = place.turn({0, 0, 1});
        scene.set_axes(origin.data(), t1.data(), n.data());
        const Frame frame = build_frame(scene.mesh(), scene.axes());
        const FrameOnBody own = lay_on_body(frame, *lower, scene.pose(0), 0),
                          other = lay_on_body(frame, *upper, scene.pose(1), 1);
        for (const FrameOnBody* on : {&own, &other}) {
          EXPECT_TRUE(on->of_faces()) << name_of(type);
          EXPECT_EQ(on->face.size(), static_cast<std::size_t>(frame.elements()));
        }
        for (std::int64_t k = 0; k < frame.nodes(); ++k) {
          const auto i = static_cast<std::size_t>(k);
          ASSERT_GE(other.node[i], 0);
          const Vec3 x = place.to_body(frame.mesh.node[i]),
                     y = place.to_body(
                         scene.pose(1).place(upper->mesh().surface.node[static_cast<std::size_t>(other.node[i])]));
          EXPECT_LT(std::hypot(x[0] - y[0], x[1] - y[1]), 1e-10);
        }
      }
}

TEST(frame_on_body, nodes_that_coincide_only_in_part) {
  // One half of the frame's elements are the body's, the others are divided otherwise.
  for (const ElementType type : surfaces::all_types) {
    const auto joined = [&](int n) {
      std::vector<double> x = uniform_lines(-1, 0, 4);
      const std::vector<double> right = uniform_lines(0, 1, n);
      x.insert(x.end(), right.begin() + 1, right.end());
      return frames::rectangle(type, x, uniform_lines(-1, 1, 6));
    };
    auto body = standing(std::make_shared<Context>(), joined(5), {});
    const Frame frame = build_frame(joined(7), {});
    const FrameOnBody on = lay_on_body(frame, *body, {}, 0);
    EXPECT_FALSE(on.of_faces());
    for (std::size_t k = 0; k < on.node.size(); ++k) {
      const Vec3& x = frame.mesh.node[k];
      if (x[0] <= 0) {
        ASSERT_GE(on.node[k], 0);
        const auto node = static_cast<std::size_t>(on.node[k]);
        EXPECT_LT(length(body->mesh().surface.node[node] - x), 1e-12);
      } else if (x[0] < 1 && std::abs(x[0] - 0.5) > 1e-9) {  // midside nodes meet there
        EXPECT_EQ(on.node[k], -1);
      }
    }
  }
}

TEST(frame_on_body, nodes_as_near_as_rounded_coordinates_are_one) {
  for (const double off : {1e-8, 1e-7, 1e-5}) {
    const std::vector<double> lines = uniform_lines(-1, 1, 8);
    auto body = standing(std::make_shared<Context>(), frames::rectangle(ElementType::quad8, lines, lines), {});
    const Frame frame = build_frame(frames::transform(frames::rectangle(ElementType::quad8, lines, lines),
                                                      [&](const Vec3& x) {
                                                        // The point lies outwards at the rim, too.
                                                        return Vec3{(1 + off) * x[0], (1 + off) * x[1], 0.1};
                                                      }),
                                    {});
    if (off < 1e-6) {
      EXPECT_TRUE(lay_on_body(frame, *body, {}, 0).of_faces()) << off;
    } else {
      EXPECT_THROW(lay_on_body(frame, *body, {}, 0), Error) << off;
    }
  }
}

TEST(frame_on_body_long, five_thousand_nodes_on_twenty_thousand_faces) {
  using Clock = std::chrono::steady_clock;
  for (const ElementType type : {ElementType::quad4, ElementType::quad8}) {
    auto body = rigid_body(std::make_shared<Context>(), sphere_cap(type, 142, 0.5, 3, 0, true));
    body->prepare();
    const int n = type == ElementType::quad4 ? 70 : 40;  // about 5000 nodes
    for (const bool matching : {false, true}) {
      SurfaceMesh mesh = matching ? sphere_cap(type, 142, 0.5, 3, 0, true) : sphere_cap(type, n, 0.49, 3, 0, true);
      const Frame frame = build_frame(mesh, {});
      const auto start = Clock::now();
      const SurfaceSearch search(body->mesh().surface, {});
      const auto built = Clock::now();
      const FrameOnBody on = lay_on_body(frame, *body, {}, 0);
      const auto end = Clock::now();
      EXPECT_EQ(on.of_faces(), matching);
      const double tree = std::chrono::duration<double>(built - start).count(),
                   lay = std::chrono::duration<double>(end - built).count();
      std::printf("%lld nodes on %lld %s: tree %.3f s, frame laid %.3f s%s\n", static_cast<long long>(frame.nodes()),
                  static_cast<long long>(body->mesh().surface.elements()), name_of(type).c_str(), tree, lay,
                  matching ? ", matching" : "");
    }
  }
}

}  // namespace
}  // namespace rollcon
