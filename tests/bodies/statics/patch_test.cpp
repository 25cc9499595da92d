// Tests uniform strain and pure bending, on meshes of all boundary and finite elements: fields that the elements hold
// exactly, so that what is left is the error of the integrals and of the linear algebra.

#include "support/static_cases.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using statics::Given;
using statics::givens;
using statics::StaticBody;
using statics::Tensor;
using statics::UniformStress;

constexpr double young = 200;
const Vec3 brick_size{3, 0.7, 1.5}, mixed_size{2, 1, 1};

/// Holds a surface, or a volume with its surface.
struct MeshCase {
  std::string name;
  Vec3 size;
  volumes::Mesh mesh;

  bool finite() const { return mesh.volume.elements() > 0; }
  StaticBody body(double poisson, double accuracy = 1e-10) const {
    return finite() ? StaticBody(mesh, young, poisson) : StaticBody(mesh.surface, young, poisson, accuracy);
  }
  /// Says whether it has tet4 or wedge6, which are refused near incompressibility.
  bool locks() const {
    return std::any_of(mesh.volume.type.begin(), mesh.volume.type.end(),
                       [](VolumeType type) { return rollcon::locks(type); });
  }
};

/// Returns surfaces, then volumes.
std::vector<MeshCase> meshes() {
  std::vector<MeshCase> cases;
  const auto brick = surfaces::brick({3, 2, 3}, brick_size), mixed = surfaces::brick({3, 2, 2}, mixed_size);
  for (const ElementType type : surfaces::all_types) {
    const std::string text = surfaces::name_of(type);
    cases.push_back({text + "_cube", {1, 1, 1}, {surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), type), {}}});
    cases.push_back(
        {text + "_distorted_brick", brick_size, {surfaces::distort(surfaces::block(brick, type), 0.2, 11), {}}});
  }
  for (const bool quadratic : {false, true})
    cases.push_back({quadratic ? "mixed_quadratic_surface" : "mixed_linear_surface",
                     mixed_size,
                     {surfaces::distort(surfaces::mixed_block(mixed, quadratic), 0.15, 7), {}}});
  for (const VolumeType type : volumes::all_types)
    cases.push_back({volumes::name_of(type) + "_distorted_brick", brick_size,
                     volumes::distort(volumes::block(brick, type), 0.2, 11)});
  for (const bool quadratic : {false, true})
    cases.push_back({quadratic ? "mixed_quadratic_volume" : "mixed_linear_volume", mixed_size,
                     volumes::distort(volumes::mixed_block(mixed, quadratic), 0.15, 7)});
  return cases;
}

struct Errors {
  double displacement = 0, traction = 0, condition = 0;
};

Errors patch_error(const MeshCase& mesh, Given given, const Tensor& stress, double poisson, double accuracy = 1e-10) {
  const UniformStress exact(stress, young, poisson);
  StaticBody body = mesh.body(poisson, accuracy);
  statics::give(body, given, exact);
  Errors e{.displacement = body.solve().displacement_error(exact)};
  if (mesh.finite()) return e;
  e.traction = body.traction_error([&](const Vec3&) { return stress; });
  e.condition = body.body().response()->statistics().condition;
  return e;
}

class Patch : public ::testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    mesh = meshes()[GetParam()];
    if (mesh.finite() ? ROLLCON_BUILD_FEM == 0 : ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "not in this build";
  }
  MeshCase mesh;
};
class SurfacePatch : public Patch {};
class VolumePatch : public Patch {};

TEST_P(Patch, uniform_strain_is_exact) {
  for (const auto& [given, what] : givens) {
    Errors worst;
    for (const auto& field : statics::uniform_stresses) {
      const Errors e = patch_error(mesh, given, field.stress, 0.3);
      worst.displacement = std::max(worst.displacement, e.displacement);
      worst.traction = std::max(worst.traction, e.traction);
      worst.condition = std::max(worst.condition, e.condition);
    }
    expect_error(mesh.name + ", " + what + ": u", worst.displacement, mesh.finite() ? 1e-11 : 1e-8);
    if (mesh.finite()) continue;
    expect_error(mesh.name + ", " + what + ": t", worst.traction, 1e-8);
    expect_error(mesh.name + ", " + what + ": condition", worst.condition, 1e5);
  }
}

TEST_P(SurfacePatch, uniform_strain_with_standard_accuracy) {
  for (const auto& [given, what] : givens) {
    const Errors e = patch_error(mesh, given, statics::uniform_stresses[3].stress, 0.3, 1e-6);
    expect_error(mesh.name + ", " + what + ": u", e.displacement, 1e-5);
    expect_error(mesh.name + ", " + what + ": t", e.traction, 1e-5);
  }
}

TEST_P(VolumePatch, of_any_material) {
  for (const double poisson : {-0.9, 0.0, 0.45, 0.49, 0.499, 0.4999}) {
    if (mesh.locks() && poisson > 0.45) continue;
    double worst = 0;
    for (const auto& [given, what] : givens)
      worst = std::max(worst, patch_error(mesh, given, statics::uniform_stresses[3].stress, poisson).displacement);
    expect_error(mesh.name + ", nu " + std::to_string(poisson) + ": u", worst, 1e-9);
  }
}

// The root carries what the stress asks of its face, and the other faces balance it.
TEST_P(VolumePatch, reactions_are_in_equilibrium) {
  const Vec3 size = mesh.size, centre{0, size[1] / 2, size[2] / 2};
  for (const auto& field : statics::uniform_stresses) {
    const UniformStress exact(field.stress, young, 0.3);
    StaticBody body = mesh.body(0.3);
    statics::give(body, Given::clamped_face, exact);
    const Resultant reaction = body.solve().reaction();
    const Vec3 force = -size[1] * size[2] * statics::times(field.stress, {1, 0, 0});
    const double scale = size[1] * size[2] * 1.3;
    expect_error(mesh.name + ", " + field.name + ": reaction force", length(reaction.force - force) / scale, 1e-10);
    expect_error(mesh.name + ", " + field.name + ": reaction moment",
                 length(reaction.moment - cross(centre, force)) / (scale * size[0]), 1e-10);
  }
}

// The held face carries the body along.
TEST_P(Patch, the_body_follows_the_face_that_is_held) {
  const auto turn = [](const Vec3& x) { return cross({0.3, -0.2, 0.5}, x); };
  const auto shift = [](const Vec3&) { return Vec3{1, -2, 3}; };
  StaticBody shifted = mesh.body(0.3), turned = mesh.body(0.3);
  shifted.hold_tags({1}, 7, shift).solve();
  turned.hold_tags({1}, 7, turn).solve();
  expect_error(mesh.name + " shifted: u", shifted.displacement_error(shift), 1e-11);
  expect_error(mesh.name + " turned: u", turned.displacement_error(turn), mesh.finite() ? 1e-11 : 1e-8);
  double reaction = mesh.finite() ? std::max(length(shifted.reaction().force), length(turned.reaction().force)) : 0;
  for (std::int64_t f = 0; !mesh.finite() && f < shifted.body().traction_nodes().size(); ++f)
    reaction = std::max({reaction, length(shifted.traction_at(f)), length(turned.traction_at(f))});
  expect_error(mesh.name + " shifted, turned: reactions over E", reaction / young, mesh.finite() ? 1e-10 : 1e-7);
}

constexpr auto mesh_name = [](const auto& param) { return meshes()[param.param].name; };
constexpr std::size_t surfaces_in_all = 12, all = 20;
// Among surfaces, cubes and the mixed linear one are quick; distorted bricks and the mixed quadratic one are not.
INSTANTIATE_TEST_SUITE_P(Bodies, Patch, ::testing::Range(std::size_t{0}, surfaces_in_all, std::size_t{2}), mesh_name);
INSTANTIATE_TEST_SUITE_P(Bodies_long, Patch, ::testing::Range(std::size_t{1}, surfaces_in_all, std::size_t{2}),
                         mesh_name);
INSTANTIATE_TEST_SUITE_P(Volumes, Patch, ::testing::Range(surfaces_in_all, all), mesh_name);
INSTANTIATE_TEST_SUITE_P(Bodies, SurfacePatch, ::testing::Range(std::size_t{0}, surfaces_in_all), mesh_name);
INSTANTIATE_TEST_SUITE_P(Bodies, VolumePatch, ::testing::Range(surfaces_in_all, all), mesh_name);

TEST(PatchMaterials, of_boundary_elements_from_auxetic_to_incompressible) {
  if (absent(ElementType::quad8)) GTEST_SKIP() << "not in this build";
  const MeshCase mesh{
      "quad8",
      {},
      {surfaces::distort(surfaces::block(surfaces::brick({2, 2, 2}, {1, 1.2, 0.8}), ElementType::quad8), 0.15, 3), {}}};
  for (const double poisson : {-0.9, 0.0, 0.49, 0.4999, 0.5})
    for (const auto& [given, what] : givens) {
      // An incompressible body has any pressure if all displacements are given.
      if (given == Given::displacements && poisson > 0.49) continue;
      const Errors e = patch_error(mesh, given, statics::uniform_stresses[0].stress, poisson);
      const std::string text = "nu " + std::to_string(poisson) + ", " + what;
      expect_error(text + ": u", e.displacement, 1e-8);
      expect_error(text + ": t", e.traction, 1e-7);
    }
  for (const double accuracy : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Errors e = patch_error(mesh, Given::clamped_face, statics::uniform_stresses[3].stress, 0.3, accuracy);
    expect_error("accuracy " + std::to_string(std::lround(std::log10(accuracy))) + ": t", e.traction, 30 * accuracy);
  }
}

// Two materials in series have each its own uniform strain.
TEST(PatchMaterials, of_finite_elements_two_in_series) {
  for (const VolumeType type : volumes::all_types) {
    if (absent(type)) GTEST_SKIP() << "not in this build";
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

class PatchBending : public ::testing::TestWithParam<AnyElement> {};

// Pure bending about y has sigma_x = E z / R, with quadratic displacements. Near incompressibility only the dilatation
// of hex20, among finite elements, is free enough to follow.
TEST_P(PatchBending, of_quadratic_elements_is_exact) {
  constexpr double radius = 40;
  const AnyElement type = GetParam();
  if (absent(type)) GTEST_SKIP() << "not in this build";
  const auto stress = [](const Vec3& x) { return Tensor{{{young * x[2] / radius, 0, 0}, {0, 0, 0}, {0, 0, 0}}}; };
  for (const double poisson : {0.0, 0.3, 0.4999}) {
    const auto exact = [&](const Vec3& x) {
      return (1 / radius) *
             Vec3{x[0] * x[2], -poisson * x[1] * x[2], -0.5 * (x[0] * x[0] + poisson * (x[2] * x[2] - x[1] * x[1]))};
    };
    const std::string what = name_of(type) + ", nu " + std::to_string(poisson) + ", bent ";
    const auto bent = [&](std::initializer_list<std::int32_t> held) {
      StaticBody body(statics::beam::shape(4, 4, 2), type, young, poisson, 1e-10);
      body.hold_tags(held, 7, exact).solve();
      return body;
    };
    // The other end's tractions vary, so it is given as a displacement too.
    const StaticBody body = bent({1, 2});
    if (is_finite_element(type)) {
      const bool follows = poisson < 0.4 || type == AnyElement(VolumeType::hex20);
      expect_error(what + "between its ends: u", body.displacement_error(exact), follows ? 1e-9 : 2e-3);
    } else {
      expect_error(what + "between its ends: u", body.displacement_error(exact), 1e-8);
      expect_error(what + "between its ends: t", body.traction_error(stress), 1e-7);
      expect_error(what + "by all faces: t", bent({1, 2, 3, 4, 5, 6}).traction_error(stress), 1e-7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, PatchBending,
                         ::testing::Values(ElementType::quad8, VolumeType::tet10, VolumeType::wedge15,
                                           VolumeType::hex20),
                         [](const auto& param) { return name_of(param.param); });
INSTANTIATE_TEST_SUITE_P(Bodies_long, PatchBending, ::testing::Values(ElementType::tri6, ElementType::quad9),
                         [](const auto& param) { return name_of(param.param); });

}  // namespace
}  // namespace rollcon
