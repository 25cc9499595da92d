// Tests that a frame may lie on a face whose supports leave it free along its normal, and on no other, on every side of
// a block.

#include "bodies/frame_on_body.hpp"
#include "support/error.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr std::int32_t all_components = 7;

/// Returns the face with this tag as a frame, its normal outwards: component `normal`, with the sign given.
Frame on_face(const SurfaceMesh& block, std::int32_t tag, std::size_t normal, double sign) {
  std::vector<std::int32_t> node;
  Axes axes;
  axes.n = axes.t1 = {0, 0, 0};
  axes.n[normal] = sign;
  axes.t1[(normal + 1) % 3] = 1;
  axes.t2 = cross(axes.n, axes.t1);
  return build_frame(surfaces::part_of(block, surfaces::elements_with_tag(block, tag), node), axes);
}

/// Returns the text of the refusal; empty: the frame was accepted.
std::string refusal(const SurfaceMesh& block, std::int32_t tag, std::int32_t held) {
  statics::StaticBody body(block, 1e4, 0.3);
  const std::size_t normal = static_cast<std::size_t>(tag - 1) / 2;
  const std::int32_t opposite = tag % 2 == 0 ? tag - 1 : tag + 1;
  body.hold_tags({opposite}).hold_tags({tag}, held);
  body.body().set_contact_faces(1, &tag);
  body.solve();
  try {
    lay_on_body(on_face(block, tag, normal, tag % 2 == 0 ? 1 : -1), body.body(), {}, 0);
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_state);
    return error.what();
  }
}

TEST(held_faces, carry_a_frame_unless_held_along_their_normal) {
  const SurfaceMesh block = surfaces::block(surfaces::brick({2, 2, 2}, {2, 2, 2}), ElementType::quad4);
  for (std::int32_t tag = 1; tag <= 6; ++tag) {
    const std::int32_t normal = 1 << ((tag - 1) / 2);
    for (std::int32_t held = 1; held <= all_components; ++held) {
      const std::string why = refusal(block, tag, held);
      if ((held & normal) == 0) {
        EXPECT_EQ(why, "") << "face " << tag << ", components " << held;
      } else {
        EXPECT_NE(why.find("is held by a support"), std::string::npos)
            << "face " << tag << ", components " << held << ": " << why;
      }
    }
  }
}

}  // namespace
}  // namespace rollcon
