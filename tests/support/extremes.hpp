#pragma once
/// Solves stiff and extreme scenes, and judges each by laws of contact recomputed without the solver
/// (independent_laws.hpp). It serves the tests and the bench, and uses the public C API alone.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "support/independent_laws.hpp"
#include "support/scene.hpp"

namespace rollcon::extremes {

using Setting = std::variant<std::int64_t, double, std::string>;

struct Scene {
  std::string group;  ///< what is stressed: a row of the tables
  std::string name;   ///< name within the group; the seed of random scenes
  scenes::AnyBody body1 = scenes::HalfspaceBody{}, body2 = scenes::RigidBody{};
  /// Data that defines the contact. For frames taken from a body (frame_body 1 or 2, faces with frame_tag),
  /// `given.frame` must hold the same faces, nodes and elements in the library's order.
  laws::Given given;
  int frame_body = 0;
  std::int32_t frame_tag = 0;
  std::vector<std::pair<std::string, Setting>> option;
  /// Sets poses and the like, after the frame was given; may be empty.
  std::function<void(scenes::RollingPair&)> pose;
  /// Statuses that are right (ROLLCON_OK, ...).
  std::vector<std::int32_t> right{ROLLCON_OK};
  double turn = 0;  ///< angle in radian that contact must reach between its normals and the axes'

  /// Says whether the status is right. Where OK is, COARSE is too: few nodes in contact are a caveat and no other
  /// answer.
  bool is_right(std::int32_t status) const;

  Scene& motion(std::int32_t direction, double value);
  Scene& force(std::int32_t direction, double value);
  Scene& creep(double longitudinal, double lateral, double spin);
  Scene& approach(double value) { return motion(ROLLCON_NORMAL, value); }
  Scene& load(double value) { return force(ROLLCON_NORMAL, value); }
  Scene& friction(double mu);
  Scene& scheme(laws::Scheme scheme);
  Scene& set(const std::string& which, Setting value);
};

const char* name_of(laws::Scheme scheme);

std::unique_ptr<scenes::RollingPair> make_pair(const Scene& scene, int threads = 1);
/// Gives a pair all of the scene except bodies and frame, or, below, all of it.
void give_loads(scenes::RollingPair& pair, const Scene& scene);
void give_scene(scenes::RollingPair& pair, const Scene& scene);

/// Says how a solve ended. `law` is set where the library says that it is solved.
struct Ending {
  std::int32_t status = 0;
  std::string message;  ///< text of a negative status
  laws::Laws law;
  double iterations = 0, fallbacks = 0, condition = 0, nodes = 0;
  double residual = 0;  ///< residual that the iteration stopped at
  double seconds = 0;   ///< seconds of the solve
  /// Says whether the library claims that the laws hold: OK, RIM_CONTACT, COARSE, INACCURATE, TOO_DEEP or NO_CONTACT.
  bool solved() const;
  /// Says whether it is solved to the bound, or ended with a status that admits failure or names what is impossible.
  bool honest(double bound) const { return !solved() || law.worst() <= bound; }
  std::vector<double> traction;  ///< three per node, if solved
};

/// Solves what was given and judges it; independent_laws.hpp explains most_nodes.
Ending solve(scenes::RollingPair& pair, const Scene& scene, bool condition = false, std::size_t most_nodes = 600);

/// Returns the same bodies and frame with everything else wildly different, in way 0, 1 or 2: pressed harder and
/// dragged the other way; hardly touching, spinning and with little friction; pressed on one side, with a load by
/// force. It serves warm starts from afar.
Scene disturbed(const Scene& scene, int way);

/// Returns the tangential force (or else spin moment) prescribed, over that of the same scene with every node sliding
/// against it: near 1 or above it, ROLLCON_ERR_LOAD is right. NaN: that was not solved.
double load_over_friction(const Scene& scene);

/// Returns for several loads together their greatest fraction, in any direction of motion, of what sliding in that
/// direction carries. Friction cannot carry them above 1.
double loads_over_friction(const Scene& scene);

/// Returns the largest difference of tractions, each over the greatest of its kind (normal, tangential) in b.
double traction_difference(const std::vector<double>& a, const std::vector<double>& b);

/// Returns scenes with names, of half-spaces and rigid bodies; extreme_bodies.hpp has those with meshes.
std::vector<Scene> named_scenes();
/// Returns the scene of a seed, of half-spaces and rigid bodies.
Scene random_scene(std::uint32_t seed);
/// Returns the scene of a seed with two or three tangential loads given (forces, spin moment), from 0 to 1.1 of what
/// friction carries; half of them are of equal half-spaces.
Scene forces_scene(std::uint32_t seed);

/// Returns a random scene, or one with several loads given, under a law of friction other than Coulomb's whose
/// parameters are drawn.
Scene law_scene(const std::string& law, std::uint32_t seed);

/// Returns a single-line description: materials, frame, loads.
std::string describe(const Scene& scene);

}  // namespace rollcon::extremes
