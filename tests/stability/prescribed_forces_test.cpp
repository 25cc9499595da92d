/// Tests prescribed tangential forces up to the limit of friction, in one and two directions.

#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

TEST(stability, forces_up_to_the_limit_of_friction) {
  constexpr double load = 300, bound = 1e-7;
  double worst = 0;
  for (const double poisson2 : {0.3, -2.0})
    for (const double mu : {1e-3, 0.3})
      for (const char* scheme : {"characteristic", "least_squares", "godunov"})
        for (const double direction : {0.0, 0.9})
          for (const double fraction : {0.0, 0.5, 0.9, 0.99, 0.999, 0.999999}) {
            Pair pair(1e4, 0.3, 1e4, poisson2);
            standard_scene(pair, 14);
            Scene& scene = pair.contact->scene;
            scene.options.set_text("convection", scheme);
            pair.friction(mu);
            scene.prescribe(3, 2, load);
            scene.prescribe(1, 2, fraction * mu * load * std::cos(direction));
            if (direction > 0) scene.prescribe(2, 2, fraction * mu * load * std::sin(direction));
            const Status status = pair.contact->solve();
            const double law = pair.worst_law();
            EXPECT_EQ(status, Status::ok)
                << scheme << " mu " << mu << " fraction " << fraction << " direction " << direction;
            EXPECT_LT(law, bound);
            worst = std::max(worst, law);
          }
  std::printf("forces of 0 to 0.999999 of the limit: worst law residual %.1e (bound %.0e)\n", worst, bound);
}

}  // namespace
}  // namespace rollcon
