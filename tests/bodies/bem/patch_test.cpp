// Uniform strain and pure bending: fields that the elements hold exactly, so that what is left is the error of the
// integrals and of the linear algebra.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/static_cases.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using statics::Given;
using statics::givens;
using statics::StaticBody;
using statics::Tensor;
using statics::UniformStress;
using validation::expect_error;

constexpr double young = 200;

struct MeshCase {
  std::string name;
  SurfaceMesh mesh;
};

std::vector<MeshCase> meshes() {
  std::vector<MeshCase> cases;
  for (const ElementType type : surfaces::all_types) {
    const std::string text = surfaces::name_of(type);
    cases.push_back({text + " cube", surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), type)});
    cases.push_back({text + " distorted brick",
                     surfaces::distort(surfaces::block(surfaces::brick({3, 2, 3}, {3, 0.7, 1.5}), type), 0.2, 11)});
  }
  for (const bool quadratic : {false, true})
    cases.push_back(
        {quadratic ? "mixed quadratic, distorted" : "mixed linear, distorted",
         surfaces::distort(surfaces::mixed_block(surfaces::brick({3, 2, 2}, {2, 1, 1}), quadratic), 0.15, 7)});
  return cases;
}

struct Errors {
  double displacement = 0, traction = 0, condition = 0;
};

Errors patch_error(const SurfaceMesh& mesh, Given given, const Tensor& stress, double poisson, double accuracy) {
  const UniformStress exact(stress, young, poisson);
  StaticBody body(mesh, young, poisson, accuracy);
  statics::give(body, given, exact);
  body.solve();
  return {body.displacement_error(exact), body.traction_error([&](const Vec3&) { return stress; }),
          body.body().response()->statistics().condition};
}

class Patch : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Patch, uniform_strain_is_exact_with_exact_integrals) {
  const MeshCase mesh = meshes()[GetParam()];
  double worst_condition = 0;
  for (const auto& [given, what] : givens) {
    Errors worst;
    for (const auto& field : statics::uniform_stresses) {
      const Errors e = patch_error(mesh.mesh, given, field.stress, 0.3, 1e-10);
      worst.displacement = std::max(worst.displacement, e.displacement);
      worst.traction = std::max(worst.traction, e.traction);
      worst_condition = std::max(worst_condition, e.condition);
    }
    expect_error(mesh.name + ", " + what + ": u", worst.displacement, 1e-8);
    expect_error(mesh.name + ", " + what + ": t", worst.traction, 1e-8);
  }
  expect_error(mesh.name + ": condition", worst_condition, 1e5);
}

TEST_P(Patch, uniform_strain_with_standard_accuracy) {
  const MeshCase mesh = meshes()[GetParam()];
  for (const auto& [given, what] : givens) {
    const Errors e = patch_error(mesh.mesh, given, statics::uniform_stresses[3].stress, 0.3, 1e-6);
    expect_error(mesh.name + ", " + what + ": u", e.displacement, 1e-5);
    expect_error(mesh.name + ", " + what + ": t", e.traction, 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, Patch, ::testing::Range(std::size_t{0}, meshes().size()), [](const auto& param) {
  std::string name = meshes()[param.param].name;
  std::erase_if(name, [](char c) { return c == ','; });
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
});

TEST(PatchMaterials, from_auxetic_to_incompressible) {
  const SurfaceMesh mesh =
      surfaces::distort(surfaces::block(surfaces::brick({2, 2, 2}, {1, 1.2, 0.8}), ElementType::quad8), 0.15, 3);
  for (const double poisson : {-0.9, 0.0, 0.49, 0.4999, 0.5})
    for (const auto& [given, what] : givens) {
      // With all displacements given, an incompressible body has any pressure.
      if (given == Given::displacements && poisson > 0.49) continue;
      const Errors e = patch_error(mesh, given, statics::uniform_stresses[0].stress, poisson, 1e-10);
      const std::string text = "nu " + std::to_string(poisson) + ", " + what;
      expect_error(text + ": u", e.displacement, 1e-8);
      expect_error(text + ": t", e.traction, 1e-7);
    }
}

TEST(PatchMaterials, the_error_follows_the_accuracy_asked_for) {
  const SurfaceMesh mesh =
      surfaces::distort(surfaces::block(surfaces::brick({3, 2, 2}, {1, 1, 1}), ElementType::quad8), 0.2, 5);
  for (const double accuracy : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Errors e = patch_error(mesh, Given::clamped_face, statics::uniform_stresses[3].stress, 0.3, accuracy);
    expect_error("accuracy " + std::to_string(std::lround(std::log10(accuracy))) + ": t", e.traction, 30 * accuracy);
  }
}

// Pure bending about y: sigma_x = E z / R, with quadratic displacements.
TEST(PatchBending, quadratic_elements_bend_exactly) {
  constexpr double poisson = 0.3, radius = 40;
  const auto exact = [](const Vec3& x) {
    return (1 / radius) *
           Vec3{x[0] * x[2], -poisson * x[1] * x[2], -0.5 * (x[0] * x[0] + poisson * (x[2] * x[2] - x[1] * x[1]))};
  };
  const auto stress = [](const Vec3& x) { return Tensor{{{young * x[2] / radius, 0, 0}, {0, 0, 0}, {0, 0, 0}}}; };
  for (const ElementType type : surfaces::all_types) {
    if (!is_quadratic(type)) continue;
    const SurfaceMesh mesh =
        surfaces::transform(surfaces::block(surfaces::brick({4, 2, 2}, {4, 1, 1}), type), [](const Vec3& x) {
          return x - Vec3{0, 0.5, 0.5};
        });
    // The other end's tractions vary: it is given as a displacement too.
    StaticBody body(mesh, young, poisson, 1e-10);
    body.hold_tags({1, 2}, 7, exact).solve();
    expect_error(surfaces::name_of(type) + " bent between its ends: u", body.displacement_error(exact), 1e-8);
    expect_error(surfaces::name_of(type) + " bent between its ends: t", body.traction_error(stress), 1e-7);
    StaticBody whole(mesh, young, poisson, 1e-10);
    whole.hold_tags({1, 2, 3, 4, 5, 6}, 7, exact).solve();
    expect_error(surfaces::name_of(type) + " bent by all faces: t", whole.traction_error(stress), 1e-7);
  }
}

// What is held carries the body along.
TEST(RigidMotion, the_body_follows_the_face_that_is_held) {
  const auto turn = [](const Vec3& x) { return cross({0.3, -0.2, 0.5}, x); };
  const auto shift = [](const Vec3&) { return Vec3{1, -2, 3}; };
  for (const ElementType type : surfaces::all_types) {
    const SurfaceMesh bodies[] = {
        surfaces::distort(surfaces::block(surfaces::brick({3, 2, 2}, {2, 1, 1}), type), 0.2, 9),
        surfaces::ring({.around = 16, .zone_around = 4, .across = 2, .deep = 2}, type)};
    for (int k = 0; k < 2; ++k) {
      const std::int32_t held = k == 0 ? 1 : 3;
      const std::string text = surfaces::name_of(type) + (k == 0 ? " brick" : " ring");
      StaticBody shifted(bodies[k], young, 0.3, 1e-10), turned(bodies[k], young, 0.3, 1e-10);
      shifted.hold_tags({held}, 7, shift).solve();
      turned.hold_tags({held}, 7, turn).solve();
      double reaction = 0;
      for (std::int64_t f = 0; f < shifted.body().traction_nodes().size(); ++f)
        reaction = std::max({reaction, length(shifted.traction_at(f)), length(turned.traction_at(f))});
      expect_error(text + " shifted: u", shifted.displacement_error(shift), 1e-11);
      expect_error(text + " turned: u", turned.displacement_error(turn), 1e-8);
      expect_error(text + " shifted, turned: reactions over E", reaction / young, 1e-7);
    }
  }
}

}  // namespace
}  // namespace rollcon
