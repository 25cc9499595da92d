/// Tests friction that varies across the rolling direction, on frames of every maker.

#include <algorithm>
#include <cmath>

#include "contact/scene_fixture.hpp"
#include "framing/automatic_frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double points[] = {-0.5, 0.1, 0.2, 0.4, 0.6, 0.2};

double wanted(double y) {
  if (y < -0.5) return 0.1;
  if (y < 0.2) return 0.1 + 0.3 * (y + 0.5) / 0.7;
  return y < 0.6 ? 0.4 - 0.2 * (y - 0.2) / 0.4 : 0.2;
}

std::vector<double> field_of(const Pair& pair, Field field) {
  std::vector<double> v(static_cast<std::size_t>(pair.contact->field(field, InAxes::local, 0, nullptr)));
  pair.contact->field(field, InAxes::local, static_cast<std::int64_t>(v.size()), v.data());
  return v;
}

TEST(friction_across, is_the_field_of_the_same_coefficients) {
  Pair pair(1e4, 0.3, 2e4, 0.2), other(1e4, 0.3, 2e4, 0.2);
  for (Pair* p : {&pair, &other}) sharp_scene(*p);
  pair.contact->scene.set_friction_across(3, points);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  const std::vector<double> x = field_of(pair, Field::point), mu = field_of(pair, Field::friction);
  std::vector<double> given(x.size() / 3);
  for (std::size_t k = 0; k < given.size(); ++k) {
    given[k] = wanted(x[3 * k + 1]);
    if (mu[k] > 0) {  // none where material enters
      EXPECT_NEAR(mu[k], given[k], 1e-15);
    }
  }
  other.contact->scene.set_friction_field(static_cast<std::int64_t>(given.size()), given.data());
  ASSERT_EQ(other.contact->solve(), Status::ok);
  const double off = largest_difference(pair.tractions(), other.tractions());
  std::printf("tractions off those of the field by %.1e (bound 1e-13)\n", off);
  EXPECT_LE(off, 1e-13);
  // A field goes before; nothing is left of points that are taken away.
  const std::vector<double> level(given.size(), 0.3);
  pair.contact->scene.set_friction_field(static_cast<std::int64_t>(level.size()), level.data());
  pair.contact->solve();
  const std::vector<double> by_field = pair.tractions();
  pair.contact->scene.set_friction_field(0, nullptr);
  pair.contact->scene.set_friction_across(0, nullptr);
  pair.contact->solve();
  EXPECT_LE(largest_difference(pair.tractions(), by_field), 1e-11);
}

// All nodes slide on frames of the library's choice: the force is the integral of mu p over Hertz's ellipse.
TEST(friction_across, frames_of_the_librarys_choice) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  pair.contact = std::make_unique<Contact>(pair.context, pair.body1, pair.body2, published, make_frame_maker);
  Scene& s = pair.contact->scene;
  pair.friction(0.3);
  s.set_gap_quadratic(0.01, 0.01, 0);
  s.prescribe(3, 1, 0.02);
  s.set_creep(1, 0, 0);
  s.set_friction_across(3, points);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  double force[3];
  pair.contact->resultant(InAxes::local, force, nullptr);
  // A strip at y of the unit disk carries 3/4 (1 - y^2) of the load.
  double sum = 0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double y = -1 + 2 * (i + 0.5) / steps;
    sum += wanted(y) * 0.75 * (1 - y * y) * 2 / steps;
  }
  std::printf("force over load %.5f, integral %.5f (bound 0.5 %%)\n", force[0] / force[2], sum);
  EXPECT_NEAR(force[0] / force[2], sum, 5e-3 * sum);
}

TEST(friction_across, refusals) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  Scene& s = pair.contact->scene;
  const double falling[] = {0.2, 0.1, -0.5, 0.1}, negative[] = {0, 0.1, 1, -0.1}, not_finite[] = {0, 0.1, NAN, 0.1};
  EXPECT_THROW(s.set_friction_across(2, falling), Error);
  EXPECT_THROW(s.set_friction_across(2, negative), Error);
  EXPECT_THROW(s.set_friction_across(2, not_finite), Error);
  EXPECT_THROW(s.set_friction_across(-1, points), Error);
  EXPECT_THROW(s.set_friction_across(2, nullptr), Error);
  EXPECT_FALSE(s.friction_varies_across());
}

}  // namespace
}  // namespace rollcon
