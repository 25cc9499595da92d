// Tests that frames that the library makes between rings of all elements pass its own check.

#include <array>
#include <random>
#include <string>

#include "support/example1.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using scenes::RollingPair;
namespace example1 = scenes::example1;

struct DrawnRing {
  VolumeType type;
  int parts;
};

void expect_a_frame(const DrawnRing& first, const DrawnRing* second, double part) {
  const auto body = [](const DrawnRing& r) { return example1::ring_body(example1::fem_ring(r.parts), r.type); };
  const auto pair = second ? example1::pair(body(first), body(*second), "characteristic")
                           : example1::pair(body(first), scenes::TwinBody{}, "characteristic");
  ASSERT_EQ(rollcon_contact_frame_automatic(pair->handle()), ROLLCON_OK);
  pair->load(part * example1::load).option("frame_accuracy", 0.05);
  pair->tangential_force(ROLLCON_LONGITUDINAL, part * example1::force_ratio * example1::mu * example1::load);
  const auto name = [](const DrawnRing& r) { return volumes::name_of(r.type) + " " + std::to_string(r.parts); };
  const std::string both = name(first) + " on " + (second ? name(*second) : "its twin");
  EXPECT_GE(rollcon_contact_solve(pair->handle()), 0) << both << ", load " << part << ": " << rollcon_last_error();
}

// Faces of rings of few elements bend away from the plane of the axes by more than 90 degrees.
TEST(ring_frames, between_like_rings_of_few_elements) {
  for (const VolumeType type : volumes::all_types) expect_a_frame({type, 4}, nullptr, 1);
}

TEST(ring_frames_nightly, between_random_rings) {
  std::mt19937 random(58);
  const auto draw = [&](int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); };
  const auto ring = [&] { return DrawnRing{volumes::all_types[static_cast<std::size_t>(draw(0, 5))], draw(3, 7)}; };
  for (int i = 0; i < 40; ++i) {
    const DrawnRing first = ring(), second = ring();
    expect_a_frame(first, i % 2 == 0 ? nullptr : &second, std::array{0.01, 0.1, 1.0}[static_cast<std::size_t>(i % 3)]);
  }
}

}  // namespace
}  // namespace rollcon
