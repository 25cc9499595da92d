/// Tests the statistic `condition`.

#include "contact/scene_fixture.hpp"
#include "linalg/fft.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

TEST(condition, of_a_contact_does_not_depend_on_units_and_leaves_the_solution_alone) {
  double first = 0;
  for (const double unit : {1.0, 1e-6, 1e9}) {
    Pair pair(1e4 * unit, 0.3, 3e4 * unit, 0.1);
    standard_scene(pair, 10);
    pair.contact->scene.set_creep(1e-3, 0, 0);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double condition = pair.contact->stat("condition");
    if (unit == 1) first = condition;
    std::printf("stiffness times %g: condition %.6g\n", unit, condition);
    EXPECT_NEAR(condition, first, 1e-6 * first);
    EXPECT_GT(condition, 1);
    EXPECT_LT(condition, 1e5);
    const std::vector<double> tractions = pair.tractions();
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    EXPECT_EQ(pair.contact->stat("iterations"), 0) << "the solution is still at hand";
    EXPECT_LT(largest_difference(pair.tractions(), tractions), 1e-12);
  }
}

TEST(condition, is_zero_without_contact) {
  Pair apart(1e4, 0.3, 1e4, 0.3);
  standard_scene(apart, 8);
  apart.contact->scene.prescribe(3, 1, -1);
  ASSERT_EQ(apart.contact->solve(), Status::no_contact);
  EXPECT_EQ(apart.contact->stat("condition"), 0);
}

TEST(condition, is_zero_without_matrices) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  Pair fft(1e4, 0.3, 1e4, 0.3);
  standard_scene(fft, 16);
  fft.contact->scene.options.set_text("operators", "fft");
  ASSERT_EQ(fft.contact->solve(), Status::ok);
  EXPECT_EQ(fft.contact->stat("condition"), 0);
}

}  // namespace
}  // namespace rollcon
