#pragma once
/// Makes stiff and extreme scenes with bodies that have meshes; extremes.hpp judges them.

#include <cstdint>
#include <string>
#include <vector>

#include "support/extremes.hpp"

namespace rollcon::extremes {

enum class Model { fem, bem };

/// Describes a block [-x, x] x [-y, y] x [-depth, 0] of n[0] x n[1] x n[2] elements, held at its bottom; tag 6 is its
/// top, the contact face, tags 1 to 5 are the sides and the bottom.
struct BlockShape {
  Model model = Model::fem;
  ElementType face = ElementType::quad4;  ///< type of the surface, for boundary elements
  VolumeType cell = VolumeType::hex8;     ///< type of the volume, for finite elements
  Vec3 half{1, 1, 1};                     ///< x, y, depth
  std::array<int, 3> n{6, 6, 3};
  std::array<std::vector<double>, 3> line{};  ///< lines over the half sizes, -1 to 1; empty: uniform
  double distort = 0;                         ///< fraction of the shortest edge; top and sides stay flat
  Vec3 shear{0, 0, 0};                        ///< x += s[0] z, y += s[1] z, x += s[2] y
  std::vector<std::int32_t> held{5};
  std::uint32_t seed = 1;
  double young = 1e4, poisson = 0.3;
};
scenes::MeshedBody make_block(const BlockShape& shape);

/// Returns the top of a block as a frame with the library's node numbers: of body 1 where it stands, of body 2 turned
/// upside down about the x axis.
SurfaceMesh top_of(const scenes::MeshedBody& body, int which, std::int32_t tag = 6);

/// Says whether the mesh is a full grid of equal quadrilaterals of 3 x 3 nodes or more, where the library takes one
/// spacing.
bool equal_cells(const SurfaceMesh& mesh);

/// Turns body 2, given as a block that looks up, about the x axis, to lie on body 1.
void turn_body_2(scenes::RollingPair& pair);

/// Describes a ball of curvature 1 / radius (or two bodies with that gap) pressed on blocks and sliding. The size is
/// about the contact's radius for `strain` = size / radius.
struct Press {
  double size = 0.5, strain = 0.02, friction = 0.3, creep = 1;  ///< creep over what saturates
};
/// Gives the press to a scene whose body1, body2 and frame are set; e_star is that of half-spaces of the same
/// materials.
void give_press(Scene& scene, const Press& press, double e_star);

/// Presses a ball on a block's own top, which is body 1 and the frame, by a second body (of the same kind of material
/// where it has none); it must be solved.
Scene scene_on_block(const std::string& group, const std::string& name, const BlockShape& shape, scenes::AnyBody second,
                     const Press& press = {});

/// Describes a bore of radius 1 (its axis along x at height 1), or a pin for it; or a flat tread of length 1 that turns
/// into such a bore: half_angle degrees to both sides (to one). It is held where the wall ends; tag 6 is the contact
/// face, tangent to z = 0 at the origin. A pin looks up, as it would as body 1.
struct ConformalShape {
  Model model = Model::fem;
  bool pin = false, flange = false;
  double half_angle = 63.5;  ///< facets lean half an element less, and may by 60 degrees
  double clearance = 1e-3;   ///< difference of the radii of the bore and of what lies in it
  double crown = 20;         ///< radius of curvature along the bore; 0: none
  double half_length = 0.5, wall = 0.3;
  std::array<int, 3> n{6, 16, 2};  ///< elements along, around, through the wall
  ElementType face = ElementType::quad4;
  VolumeType cell = VolumeType::hex8;
  double young = 1e4, poisson = 0.3;
};
scenes::MeshedBody make_conformal(const ConformalShape& shape);
/// Presses a rigid roller into an elastic bore, or the other way round a pin, by `depth`, rolling along the bore;
/// contact must reach `reach` degrees.
Scene scene_in_bore(const std::string& name, const ConformalShape& shape, double depth, double reach);

/// Returns a part of named_body_scenes.
std::vector<Scene> conformal_scenes();
std::vector<Scene> named_body_scenes();
Scene random_body_scene(std::uint32_t seed);

}  // namespace rollcon::extremes
