// Tests linear elements whose displacements are quadratic, by midside nodes that are no unknowns.

#include "bodies/bem/lifted_surface.hpp"

#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon::bem {
namespace {

constexpr ElementType linear_types[] = {ElementType::tri3, ElementType::quad4};

BodyMesh held_nowhere(SurfaceMesh surface) {
  BodyMesh body;
  body.surface = std::move(surface);
  body.held.assign(body.surface.node.size(), 0);
  body.held_value.resize(body.surface.node.size());
  return body;
}

std::int64_t parts_of(const LiftedSurface& lifted, std::size_t m) {
  return lifted.start[m + 1] - lifted.start[m];
}

/// Returns the fraction of the midside nodes that are more than the mean of their edge's ends.
double bent_part(const LiftedSurface& lifted) {
  double bent = 0;
  const std::size_t all = lifted.start.size() - 1;
  for (std::size_t m = 0; m < all; ++m)
    if (parts_of(lifted, m) > 2) ++bent;
  return bent / static_cast<double>(all);
}

/// Returns the largest difference at bent midside nodes between a field and what the body's nodes say of it.
double midside_error(const LiftedSurface& lifted, const std::function<double(const Vec3&)>& field) {
  double error = 0;
  for (std::size_t m = 0; m + 1 < lifted.start.size(); ++m) {
    if (parts_of(lifted, m) == 2) continue;
    double value = 0;
    for (std::int64_t k = lifted.start[m]; k < lifted.start[m + 1]; ++k) {
      const Part& part = lifted.part[static_cast<std::size_t>(k)];
      value += part.value * field(lifted.mesh.node[static_cast<std::size_t>(part.of)]);
    }
    const auto node = static_cast<std::size_t>(lifted.nodes) + m;
    error = std::max(error, std::abs(value - field(lifted.mesh.node[node])));
  }
  return error;
}

TEST(LiftedSurface, quadratic_fields_on_flat_faces_are_exact) {
  for (const ElementType type : linear_types) {
    const SurfaceMesh brick = surfaces::distort(surfaces::block(surfaces::brick({5, 4, 3}, {5, 3, 2}), type), 0.2, 3);
    const LiftedSurface lifted = lift(held_nowhere(brick), 40);
    const std::string what = surfaces::name_of(type) + " brick, ";
    // Triangles at a face's corner have too few nodes around them.
    expect_error(what + "sides that stay straight", 1 - bent_part(lifted), type == ElementType::quad4 ? 0 : 0.1);
    expect_error(what + "linear field", midside_error(lifted, [](const Vec3& x) { return x[0] - 2 * x[1] + x[2]; }),
                 1e-12);
    expect_error(
        what + "quadratic field",
        midside_error(lifted, [](const Vec3& x) { return x[0] * x[0] + x[0] * x[1] - x[1] * x[2] + 2 * x[2] * x[2]; }),
        1e-10);
  }
}

TEST(LiftedSurface, curved_faces_are_nearer_to_the_sphere_and_turn_rigidly) {
  for (const ElementType type : linear_types) {
    const LiftedSurface lifted = lift(held_nowhere(surfaces::cube_sphere(type, 6, 1)), 40);
    double chord = 0, curved = 0;
    for (std::size_t m = 0; m + 1 < lifted.start.size(); ++m)
      curved = std::max(curved, std::abs(1 - length(lifted.mesh.node[static_cast<std::size_t>(lifted.nodes) + m])));
    const SurfaceMesh& mesh = lifted.mesh;
    for (std::int64_t e = 0; e < mesh.elements(); ++e) {
      const auto node = mesh.element(e);
      const Vec3 middle =
          0.5 * (mesh.node[static_cast<std::size_t>(node[0])] + mesh.node[static_cast<std::size_t>(node[1])]);
      chord = std::max(chord, 1 - length(middle));
    }
    const std::string what = surfaces::name_of(type) + " sphere, ";
    expect_error(what + "depth of midside nodes over that of chords", curved / chord, 0.35);
    expect_error(what + "turned", midside_error(lifted, [](const Vec3& x) { return 0.3 * x[0] - 0.5 * x[1] + x[2]; }),
                 1e-12);
  }
}

/// Makes elements of length L beside elements of length 1 along x.
SurfaceMesh graded_block(ElementType type, double ratio, double unit) {
  return surfaces::transform(surfaces::block(surfaces::brick({2, 2, 2}, {2, 2, 2}), type), [&](const Vec3& x) {
    const double along = std::min(x[0], 1.0) * (ratio - 1) + x[0];
    return unit * Vec3{along, x[1], x[2]};
  });
}

// Weights have the sum 1 at a ratio of 2 and 2 at one of 4: no limit on them lets rounding choose.
TEST(LiftedSurface, graded_meshes_do_not_hang_on_rounding) {
  const auto differ = [](const LiftedSurface& a, const LiftedSurface& b) {
    if (a.start != b.start) return 1.0;
    double worst = 0;
    for (std::size_t k = 0; k < a.part.size(); ++k)
      worst = std::max(worst, std::abs(a.part[k].value - b.part[k].value));
    return worst;
  };
  for (const ElementType type : linear_types)
    for (const double ratio : {2.0, 4.0}) {
      const auto lifted = [&](double change, double unit) {
        return lift(held_nowhere(graded_block(type, ratio * (1 + change), unit)), 40);
      };
      const LiftedSurface even = lifted(0, 1);
      const std::string what = surfaces::name_of(type) + " graded by " + std::to_string(static_cast<int>(ratio));
      for (const double unit : {1e-3, 1e3, 1e-25})
        expect_error(what + ", in other units", differ(lifted(0, unit), even), 1e-12);
      for (const double change : {-1e-9, 1e-9})
        expect_error(what + ", a little longer or shorter", differ(lifted(change, 1), even), 1e-7);
    }
}

// The elements are twice as long as the body is thick, with two through it: without the midside nodes they were too
// stiff by half.
TEST(LiftedSurface, thin_bodies_of_linear_elements_bend_exactly) {
  constexpr double young = 1000, poisson = 0.3;
  const auto bent = [](const Vec3& x) {
    const double z = x[2] - 0.5, y = x[1] - 1;
    return Vec3{x[0] * z, -poisson * y * z, (poisson * (y * y - z * z) - x[0] * x[0]) / 2};
  };
  for (const ElementType type : linear_types) {
    statics::StaticBody plate(surfaces::block(surfaces::brick({4, 2, 2}, {8, 2, 1}), type), young, poisson);
    plate.hold_tags({1, 2}, 7, bent).solve();
    expect_error(surfaces::name_of(type) + " plate bent by its ends", plate.displacement_error(bent), 1e-5);
  }
}

}  // namespace
}  // namespace rollcon::bem
