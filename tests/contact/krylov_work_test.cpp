// Tests that linear systems are solved as accurately as Newton's step needs, the last one no more than the tolerance
// asks for. The work is counted where operators are not formed and each iteration costs transforms.

#include "contact/scene_fixture.hpp"
#include "linalg/fft.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

TEST(krylov_work, is_no_more_than_the_tolerance_asks_for) {
  if (!has_fft()) GTEST_SKIP() << "this build is without FFTW";
  constexpr double bound = 16.5;
  double inner = 0, outer = 0;
  for (const double poisson2 : {0.3, 0.1, -2.0})
    for (const double tolerance : {1e-6, 1e-10}) {
      Pair pair(1e4, 0.3, 1e4, poisson2);
      standard_scene(pair, 24);
      Scene& s = pair.contact->scene;
      s.options.set_text("operators", "fft");
      s.options.set_real("tolerance", tolerance);
      for (const double creepage : {-1e-3, -1.05e-3}) {
        s.set_creep(creepage, 5e-4, 5e-4);
        ASSERT_EQ(pair.contact->solve(), Status::ok);
        inner += pair.contact->stat("linear_iterations");
        outer += pair.contact->stat("iterations");
      }
    }
  std::printf("%g linear iterations in %g of Newton: %.1f in each (bound %.1f)\n", inner, outer, inner / outer, bound);
  EXPECT_LE(inner, bound * outer);
}

TEST(krylov_work, follows_the_linear_tolerance_asked_for) {
  const auto iterations = [](double linear_tolerance) {
    Pair pair(1e4, 0.3, 1e4, 0.1);
    standard_scene(pair, 12);
    Scene& s = pair.contact->scene;
    s.set_creep(-1e-3, 5e-4, 5e-4);
    s.options.set_text("linear_solver", "gmres");
    s.options.set_real("linear_tolerance", linear_tolerance);
    EXPECT_EQ(pair.contact->solve(), Status::ok);
    return pair.contact->stat("linear_iterations") / pair.contact->stat("iterations");
  };
  const double rough = iterations(1e-2), sharp = iterations(1e-8);
  std::printf("linear iterations in one of Newton: %.1f to 1e-2, %.1f to 1e-8\n", rough, sharp);
  EXPECT_GT(sharp, 2 * rough);
}

}  // namespace
}  // namespace rollcon
