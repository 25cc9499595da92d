// Uniform strain and pure bending on meshes of all finite elements: fields that the elements hold exactly.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/static_cases.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using statics::Given;
using statics::StaticBody;
using statics::UniformStress;
using validation::expect_error;

constexpr double young = 200;

struct MeshCase {
  std::string name;
  volumes::Mesh mesh;
  Vec3 size;
};

std::vector<MeshCase> meshes() {
  std::vector<MeshCase> cases;
  const Vec3 size{3, 0.7, 1.5};
  for (const VolumeType type : volumes::all_types)
    cases.push_back({volumes::name_of(type) + " distorted brick",
                     volumes::distort(volumes::block(surfaces::brick({3, 2, 3}, size), type), 0.2, 11), size});
  const Vec3 mixed{2, 1, 1};
  for (const bool quadratic : {false, true})
    cases.push_back({quadratic ? "mixed quadratic distorted" : "mixed linear distorted",
                     volumes::distort(volumes::mixed_block(surfaces::brick({3, 2, 2}, mixed), quadratic), 0.15, 7),
                     mixed});
  return cases;
}

/// tet4 and wedge6 are refused near incompressibility.
bool locks(const volumes::Mesh& mesh) {
  return std::any_of(mesh.volume.type.begin(), mesh.volume.type.end(),
                     [](VolumeType type) { return type == VolumeType::tet4 || type == VolumeType::wedge6; });
}

class FemPatch : public ::testing::TestWithParam<std::size_t> {};

TEST_P(FemPatch, uniform_strain_is_exact) {
  const MeshCase mesh = meshes()[GetParam()];
  for (const auto& [given, what] : statics::givens) {
    double worst = 0;
    for (const auto& field : statics::uniform_stresses) {
      const UniformStress exact(field.stress, young, 0.3);
      StaticBody body(mesh.mesh, young, 0.3);
      statics::give(body, given, exact);
      worst = std::max(worst, body.solve().displacement_error(exact));
    }
    expect_error(mesh.name + ", " + what + ": u", worst, 1e-11);
  }
}

TEST_P(FemPatch, of_any_material) {
  const MeshCase mesh = meshes()[GetParam()];
  for (const double poisson : {-0.9, 0.0, 0.45, 0.49, 0.499, 0.4999}) {
    if (locks(mesh.mesh) && poisson > 0.45) continue;
    double worst = 0;
    for (const auto& [given, what] : statics::givens) {
      const UniformStress exact(statics::uniform_stresses[3].stress, young, poisson);
      StaticBody body(mesh.mesh, young, poisson);
      statics::give(body, given, exact);
      worst = std::max(worst, body.solve().displacement_error(exact));
    }
    expect_error(mesh.name + ", nu " + std::to_string(poisson) + ": u", worst, 1e-9);
  }
}

// The root carries what the stress asks of its face, the other faces balance it.
TEST_P(FemPatch, reactions_are_in_equilibrium) {
  const MeshCase mesh = meshes()[GetParam()];
  const Vec3 size = mesh.size, centre{0, size[1] / 2, size[2] / 2};
  for (const auto& field : statics::uniform_stresses) {
    const UniformStress exact(field.stress, young, 0.3);
    StaticBody body(mesh.mesh, young, 0.3);
    statics::give(body, Given::clamped_face, exact);
    const Resultant reaction = body.solve().reaction();
    const Vec3 force = -size[1] * size[2] * statics::times(field.stress, {1, 0, 0});
    const double scale = size[1] * size[2] * 1.3;
    expect_error(mesh.name + ", " + field.name + ": reaction force", length(reaction.force - force) / scale, 1e-10);
    expect_error(mesh.name + ", " + field.name + ": reaction moment",
                 length(reaction.moment - cross(centre, force)) / (scale * size[0]), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, FemPatch, ::testing::Range(std::size_t{0}, meshes().size()), [](const auto& param) {
  std::string name = meshes()[param.param].name;
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
});

// Pure bending about y: sigma_x = E z / R, with quadratic displacements. Near incompressibility only the dilatation of
// hex20 is free enough to follow.
TEST(FemBending, quadratic_elements_bend_exactly) {
  constexpr double radius = 40;
  for (const double poisson : {0.0, 0.3, 0.4999}) {
    const auto exact = [&](const Vec3& x) {
      return (1 / radius) *
             Vec3{x[0] * x[2], -poisson * x[1] * x[2], -0.5 * (x[0] * x[0] + poisson * (x[2] * x[2] - x[1] * x[1]))};
    };
    for (const VolumeType type : volumes::all_types) {
      if (!is_quadratic(type)) continue;
      StaticBody body(volumes::block(statics::beam::shape(4, 4, 2), type), young, poisson);
      body.hold_tags({1, 2}, 7, exact).solve();
      expect_error(volumes::name_of(type) + " bent between its ends, nu " + std::to_string(poisson),
                   body.displacement_error(exact), poisson < 0.4 || type == VolumeType::hex20 ? 1e-9 : 2e-3);
    }
  }
}

// What is held carries the body along.
TEST(FemRigidMotion, the_body_follows_the_face_that_is_held) {
  const auto motion = [](const Vec3& x) { return Vec3{1, -2, 3} + cross({0.3, -0.2, 0.5}, x); };
  for (const MeshCase& mesh : meshes()) {
    StaticBody body(mesh.mesh, young, 0.3);
    body.hold_tags({1}, 7, motion).solve();
    expect_error(mesh.name + ": carried along", body.displacement_error(motion), 1e-11);
    const Resultant reaction = body.reaction();
    expect_error(mesh.name + ": force of it over E", length(reaction.force) / young, 1e-10);
  }
}

// Two materials in series: each keeps its own uniform strain.
TEST(FemMaterials, two_in_series) {
  for (const VolumeType type : volumes::all_types) {
    const auto mesh = volumes::with_materials(volumes::block(surfaces::brick({4, 2, 2}, {2, 1, 1}), type),
                                              [](const Vec3& x) { return x[0] > 1 ? 7 : 0; });
    StaticBody body(mesh, young, 0);
    body.body().set_elastic(7, young / 4, 0);
    body.hold_tags({1}, 1).hold_tags({3}, 2).hold_tags({5}, 4).traction(2, {1, 0, 0}).solve();
    const auto exact = [](const Vec3& x) {
      return Vec3{(std::min(x[0], 1.0) + 4 * std::max(x[0] - 1, 0.0)) / young, 0, 0};
    };
    expect_error(volumes::name_of(type) + ", soft half behind a stiff one", body.displacement_error(exact), 1e-11);
  }
}

}  // namespace
}  // namespace rollcon
