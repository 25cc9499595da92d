/// Tests that the budget of threads is a maximum for the BLAS.

#include "contact/scene_fixture.hpp"

namespace rollcon::contact_test {
namespace {

double threads_of(int n, const char* operators, std::int32_t budget) {
  Pair pair(1000, 0.3, 1000, 0.3);
  pair.context->set_threads(budget);
  standard_scene(pair, n);
  pair.contact->scene.prescribe(3, 1, 1e-4);  // a few nodes touch
  pair.contact->scene.options.set_text("operators", operators);
  pair.contact->solve();
  return pair.contact->stat("threads");
}

TEST(blas_threads, small_frames_get_one) {
  for (const std::int32_t budget : {1, 2, 3}) EXPECT_EQ(threads_of(14, "dense", budget), 1) << budget;
#ifdef _OPENMP
  for (const std::int32_t budget : {1, 2, 3}) EXPECT_EQ(threads_of(44, "dense", budget), budget);
#endif
}

TEST(blas_threads, frames_without_rows_get_one) {
#if ROLLCON_BUILD_FFTW
  EXPECT_EQ(threads_of(44, "fft", 2), 1);
#endif
}

}  // namespace
}  // namespace rollcon::contact_test
