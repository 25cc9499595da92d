/// Tests steps of the characteristic scheme on quadratic quadrilaterals: nodes that stand equally far from each other
/// step equally far.

#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

std::array<double, 3> force(ElementType type, int n, double young2, double poisson2, double* magnitude = nullptr) {
  Pair pair(2e5, 0.3, young2, poisson2);
  const std::vector<double> lines = frames::uniform_lines(-1.25, 1.25, n);
  pair.frame(frames::rectangle(type, lines, lines));
  pair.contact->scene.set_gap_quadratic(0.01, 0.012, 0);
  pair.friction(0.3);
  pair.contact->scene.prescribe(3, 1, 0.01);
  pair.contact->scene.set_creep(1e-3, 0, 0);
  if (pair.contact->solve() != Status::ok) throw std::runtime_error("not solved");
  std::array<double, 3> f{}, m{};
  pair.contact->resultant(InAxes::local, f.data(), m.data());
  if (magnitude) *magnitude = std::hypot(f[0], f[1]);
  return f;
}

// Steps by dual cells would be off by 0.13 and 0.09 (equal bodies), and by 0.37.
TEST(characteristic_steps, friction_on_quad8) {
  struct Scene {
    double young2, poisson2;
    int n;
    double bound;
  };
  for (const auto& [young2, poisson2, n, bound] :
       {Scene{2e5, 0.3, 8, 0.08}, Scene{2e5, 0.3, 12, 0.08}, Scene{1e4, 0.4, 12, 0.15}}) {
    double scale = 0;
    const auto limit = force(ElementType::quad4, 60, young2, poisson2, &scale);
    const auto f = force(ElementType::quad8, n, young2, poisson2);
    const double error = std::hypot(f[0] - limit[0], f[1] - limit[1]) / scale;
    std::printf("%d x %d quad8: off by %.3f (bound %.2f)\n", n, n, error, bound);
    EXPECT_LT(error, bound);
  }
}

}  // namespace
}  // namespace rollcon
