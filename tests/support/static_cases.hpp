#pragma once
/// Provides bodies whose displacements are known: bricks under uniform stress, a cantilever with an end load, thick
/// walls under pressure from inside. Their shapes are blocks, to be meshed with any elements.

#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::statics {

/// Describes displacements of a uniform stress, with a rotation and a translation on top.
struct UniformStress {
  Tensor stress, gradient;
  Vec3 shift{0.01, -0.02, 0.005};
  UniformStress(const Tensor& stress, double young, double poisson);
  Vec3 operator()(const Vec3& x) const { return times(gradient, x) + shift; }
};

struct NamedStress {
  const char* name;
  Tensor stress;
};
inline constexpr NamedStress uniform_stresses[] = {
    {"uniaxial x", {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}}},
    {"uniaxial y", {{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}}},
    {"uniaxial z", {{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}}},
    {"shear", {{{0, 1, -0.4}, {1, 0, 0.7}, {-0.4, 0.7, 0}}}},
};

/// Says what of the field is given on a brick's faces (tags 1 to 6).
enum class Given { tractions, displacements, clamped_face, symmetry_planes };
inline constexpr std::pair<Given, const char*> givens[] = {{Given::tractions, "tractions"},
                                                           {Given::displacements, "displacements"},
                                                           {Given::clamped_face, "one face and a slide"},
                                                           {Given::symmetry_planes, "three slides"}};
void give(StaticBody& body, Given given, const UniformStress& exact);

/// Describes a cantilever of square section along x, loaded along z at its end, nu = 0: bending with a parabola of
/// shear solves the equations in three dimensions, with sigma_x = -F (L - x) z / I and tau = F / 2I (h^2 / 4 - z^2);
/// the displacements are cubic, and sections warp.
namespace beam {
inline constexpr double young = 1000, width = 1, height = 1, force = 1, span = 4;
inline constexpr double inertia = width * height * height * height / 12;
/// Tag 1 is the root, tag 2 the end.
surfaces::Block shape(double span, int along, int across);
Vec3 exact_displacement(const Vec3& x);
/// Holds the root as the exact solution moves it, loads the end, and compares displacements there.
double error(StaticBody& body);
/// Returns the deflection of Timoshenko's beam, clamped, with a force at its end.
double timoshenko(double span, double poisson);
}  // namespace beam

/// Describes thick walls from radius 1 to 2 under pressure from inside (Lame).
namespace walls {
inline constexpr double young = 1000, inner = 1, outer = 2, pressure = 10;
Vec3 sphere_displacement(const Vec3& x, double poisson);
/// Returns displacements around the y axis, in plane strain.
Vec3 cylinder_displacement(const Vec3& x, double poisson);
/// Makes a quarter of the cylinder, in 2 n by n by n parts, and its loads and sliding planes of symmetry.
surfaces::Block quarter_cylinder(int n);
void press_cylinder(StaticBody& body);
/// Makes a part of a sphere between three planes of symmetry and a cone.
surfaces::Block part_of_sphere(int n);
void press_sphere(StaticBody& body, double poisson);
}  // namespace walls

}  // namespace rollcon::statics
