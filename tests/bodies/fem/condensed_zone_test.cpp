// Tests that a body is condensed to what a frame touches, however many of its faces may come into contact.

#include "bodies/model/surface_response.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

TEST(CondensedZone, is_that_of_the_frame) {
  statics::StaticBody body(volumes::block(surfaces::brick({24, 24, 2}, {24, 24, 2}), VolumeType::hex8), 200, 0.3);
  body.hold_tags({5});
  body.body().prepare();
  const auto counts = [&] { return body.body().response()->statistics(); };
  EXPECT_EQ(counts().factorizations, 0) << "it waits for the frame";
  // 3 x 3 faces have 4 x 4 nodes, and 6 x 6 with those around them.
  std::vector<std::int64_t> middle, corner;
  for (const std::int64_t e : surfaces::elements_with_tag(body.mesh(), 6)) {
    const Vec3& x = body.mesh().node[static_cast<std::size_t>(body.mesh().element(e)[0])];
    const auto within = [&](double from) { return x[0] >= from && x[0] < from + 3 && x[1] >= from && x[1] < from + 3; };
    if (within(10)) middle.push_back(e);
    if (within(4)) corner.push_back(e);
  }
  ASSERT_EQ(middle.size(), 9U);
  body.body().response()->rows({middle, {}, {}}, 1);
  EXPECT_EQ(counts().condensed, 3 * 36);
  EXPECT_EQ(counts().factorizations, 1);
  body.body().response()->rows({corner, {}, {}}, 1);
  EXPECT_EQ(counts().condensed, 3 * (36 + 36)) << "what the first frame needed stays";
  body.body().response()->rows({middle, {}, {}}, 1);
  EXPECT_EQ(counts().factorizations, 2);
}

}  // namespace
}  // namespace rollcon
