#include "support/static_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rollcon::statics {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns the outward normals of a brick's tags 1 to 6.
Vec3 face_normal(std::int32_t tag) {
  Vec3 n{0, 0, 0};
  n[static_cast<std::size_t>(tag - 1) / 2] = tag % 2 ? -1 : 1;
  return n;
}

void give_tractions(StaticBody& body, const Tensor& stress, std::int32_t first_tag) {
  for (std::int32_t tag = first_tag; tag <= 6; ++tag) body.traction(tag, times(stress, face_normal(tag)));
}

}  // namespace

UniformStress::UniformStress(const Tensor& s, double young, double poisson)
    : stress(s), gradient(strain_of(s, young, poisson)) {
  const Vec3 spin{0.004, -0.003, 0.002};
  gradient[0] = gradient[0] + Vec3{0, -spin[2], spin[1]};
  gradient[1] = gradient[1] + Vec3{spin[2], 0, -spin[0]};
  gradient[2] = gradient[2] + Vec3{-spin[1], spin[0], 0};
}

void give(StaticBody& body, Given given, const UniformStress& exact) {
  switch (given) {
    case Given::tractions:
      give_tractions(body, exact.stress, 1);
      body.hold_statically(exact);
      break;
    case Given::displacements:
      body.hold_tags({1, 2, 3, 4, 5, 6}, 7, exact);
      break;
    case Given::clamped_face:
      give_tractions(body, exact.stress, 2);
      body.hold_tags({1}, 7, exact).hold_tags({6}, 4, exact);
      break;
    case Given::symmetry_planes:
      give_tractions(body, exact.stress, 1);
      body.hold_tags({1}, 1, exact).hold_tags({3}, 2, exact).hold_tags({5}, 4, exact);
      break;
  }
}

namespace beam {

surfaces::Block shape(double length, int along, int across) {
  surfaces::Block block = surfaces::brick({along, across, across}, {length, width, height});
  block.map = [](const Vec3& x) { return x - Vec3{0, width / 2, height / 2}; };
  return block;
}

Vec3 exact_displacement(const Vec3& x) {
  const double shear = young / 2;
  const double slope = force * (span * x[0] - x[0] * x[0] / 2) / (young * inertia);
  const double sag = force * (span * x[0] * x[0] / 2 - x[0] * x[0] * x[0] / 6) / (young * inertia);
  const double z = x[2];
  const double warp = force / (2 * inertia * shear) * (height * height / 4 * z - z * z * z / 3);
  return {warp - slope * z, 0, sag};
}

double error(StaticBody& body) {
  body.hold_tags({1}, 7, exact_displacement).solve();
  const auto end = surfaces::elements_with_tag(body.mesh(), 2);
  const Loaded loaded = load_faces(body.body(), end, [](const Vec3& x) {
    return Vec3{0, 0, force / (2 * inertia) * (height * height / 4 - x[2] * x[2])};
  });
  double worst = 0, size = 0;
  for (std::size_t k = 0; k < loaded.node.size(); ++k) {
    const Vec3 exact = exact_displacement(body.mesh().node[static_cast<std::size_t>(loaded.node[k])]);
    worst = std::max(worst, length(loaded.u[k] + body.displacement(loaded.node[k]) - exact));
    size = std::max(size, length(exact));
  }
  return worst / size;
}

double timoshenko(double length, double poisson) {
  const double shear = young / (2 * (1 + poisson));
  const double shear_factor = 10 * (1 + poisson) / (12 + 11 * poisson);
  return force * length * length * length / (3 * young * inertia) +
         force * length / (shear_factor * shear * width * height);
}

}  // namespace beam

namespace walls {

Vec3 sphere_displacement(const Vec3& x, double poisson) {
  const double r = length(x), a3 = inner * inner * inner, b3 = outer * outer * outer;
  const double u = pressure * a3 / (young * (b3 - a3)) * ((1 - 2 * poisson) * r + (1 + poisson) * b3 / (2 * r * r));
  return (u / r) * x;
}

Vec3 cylinder_displacement(const Vec3& x, double poisson) {
  const double r = std::hypot(x[0], x[2]), a2 = inner * inner, b2 = outer * outer;
  const double u = pressure * a2 * (1 + poisson) / (young * (b2 - a2)) * ((1 - 2 * poisson) * r + b2 / r);
  return (u / r) * Vec3{x[0], 0, x[2]};
}

surfaces::Block quarter_cylinder(int n) {
  surfaces::Block quarter = surfaces::brick({2 * n, n, n}, {pi / 2, 1, outer - inner});
  quarter.map = [](const Vec3& q) {
    return Vec3{(inner + q[2]) * std::sin(q[0]), q[1], (inner + q[2]) * std::cos(q[0])};
  };
  return quarter;
}

void press_cylinder(StaticBody& body) {
  body.hold_tags({1}, 1).hold_tags({2}, 4).hold_tags({3, 4}, 2).pressure(5, pressure);
}

surfaces::Block part_of_sphere(int n) {
  surfaces::Block part = surfaces::brick({2 * n, n, n}, {pi / 2, pi / 4, outer - inner});
  part.map = [](const Vec3& q) {
    const double r = inner + q[2];
    return Vec3{r * std::cos(q[1]) * std::cos(q[0]), r * std::cos(q[1]) * std::sin(q[0]), r * std::sin(q[1])};
  };
  return part;
}

void press_sphere(StaticBody& body, double poisson) {
  body.hold_tags({1}, 2).hold_tags({2}, 1).hold_tags({3}, 4).pressure(5, pressure);
  body.hold_tags({4}, 7, [poisson](const Vec3& x) { return sphere_displacement(x, poisson); });
}

}  // namespace walls

}  // namespace rollcon::statics
