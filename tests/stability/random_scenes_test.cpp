/// Random scenes over wide ranges from fixed seeds: each one is solved with the laws satisfied, or
/// ends with a status that says why not.

#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

TEST(stability, random_scenes_end_solved_or_with_a_status) {
  constexpr int scenes = 300;
  constexpr double law_bound = 1e-7;
  int solved = 0, not_converged = 0, refused = 0;
  double worst = 0;
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    frames::Random random(seed);
    const auto between = [&](double a, double b) { return a + (b - a) * 0.5 * (random() + 1); };
    const auto log_between = [&](double a, double b) {
      return std::exp(between(std::log(a), std::log(b)));
    };
    const auto pick = [&](int n) { return std::min(n - 1, static_cast<int>(between(0, n))); };
    constexpr double ratios[] = {-0.5, 0, 0.3, 0.49, 0.4999, 0.5};
    const int kind = pick(3);  // on rigid, identical, dissimilar
    const double poisson1 = ratios[pick(6)];
    const double poisson2 = kind == 0 ? -2 : kind == 1 ? poisson1 : ratios[pick(6)];
    const double young2 = kind == 2 ? 1e4 * log_between(1e-6, 1e6) : 1e4;
    Pair pair(1e4, poisson1, young2, poisson2);
    const int n = 8 + pick(7);
    const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, n);
    constexpr ElementType types[] = {ElementType::quad4, ElementType::tri3};
    SurfaceMesh mesh = frames::rectangle(types[pick(2)], lines, lines);
    if (pick(2) == 1) mesh = frames::perturb(mesh, 0.2, seed);
    const double aspect = log_between(0.2, 5);
    pair.frame(frames::stretch(mesh, aspect, 1));
    Scene& scene = pair.contact->scene;
    scene.set_gap_quadratic(0.01 / (aspect * aspect), 0.01, 0);
    constexpr double frictions[] = {1e-6, 0.05, 0.3, 0.6, 1, 3};
    pair.friction(frictions[pick(6)]);
    scene.prescribe(3, 1, between(0.006, 0.015));
    const double creep = log_between(1e-6, 10);
    scene.set_creep(creep * random(), creep * random(), creep * random());
    constexpr const char* schemes[] = {"least_squares", "godunov", "characteristic"};
    scene.options.set_text("convection", schemes[pick(3)]);
    Status status = Status::ok;
    try {
      status = pair.contact->solve();
    } catch (const Error& e) {
      ++refused;
      std::printf("seed %u: %s\n", seed, e.what());
      continue;
    }
    if (status == Status::not_converged) {
      ++not_converged;
      std::printf("seed %u: not converged\n", seed);
      continue;
    }
    const double law = pair.worst_law();
    EXPECT_LT(law, law_bound) << seed;
    worst = std::max(worst, law);
    ++solved;
  }
  std::printf("%d scenes: %d solved, worst law residual %.1e (bound %.0e); %d not converged\n",
              scenes, solved, worst, law_bound, not_converged);
  EXPECT_EQ(refused, 0);
  EXPECT_LE(not_converged, scenes / 100);
}

}  // namespace
}  // namespace rollcon
