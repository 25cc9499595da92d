// Linear systems are solved as accurately as Newton's step needs, the last one no more than the tolerance asks for:
// counted where operators are not formed and each iteration costs transforms.

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

}  // namespace
}  // namespace rollcon
