#pragma once
/// Makes what the named scenes start from: a sphere on a plane, pressed to a circle of radius 1.

#include <string>
#include <vector>

#include "support/extremes.hpp"
#include "support/frames.hpp"

namespace rollcon::extremes {

enum class Pairing { on_rigid, twins, unlike };
const char* name_of(Pairing pairing);

scenes::Elastic elastic(double young, double poisson);

/// Makes the base scene: E = 1e4, nu = 0.3 (unlike: nu = 0.2 against it), radius 50, approach 0.02, mu = 0.3, creepages
/// and spin at which half of the contact sticks; 12 x 12 quad4 on a square of half-width 1.3.
Scene base(const std::string& group, const std::string& name, Pairing pairing = Pairing::on_rigid);
/// Sets a regular frame of n x m quad4 over half-widths a, b. The integrals are as exact as the tables that the library
/// has for it.
void set_regular_frame(Scene& scene, int n, int m, double a = 1.3, double b = 1.3);
void set_frame(Scene& scene, SurfaceMesh mesh);
/// Returns the load of the base scene's circle.
double base_load(const Scene& scene);

/// Each of these returns a family that named_scenes strings together.
std::vector<Scene> material_scenes();
std::vector<Scene> friction_scenes();
std::vector<Scene> motion_scenes();
std::vector<Scene> load_scenes();
std::vector<Scene> contact_scenes();
std::vector<Scene> frame_scenes();

/// Returns the scene in units of length and pressure `length`, `pressure` times smaller.
Scene in_units(Scene scene, double length, double pressure);

}  // namespace rollcon::extremes
