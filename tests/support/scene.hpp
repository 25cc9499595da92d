#pragma once
/// Makes a pair of bodies in rolling contact, for tests and benches: RAII over the public C API and nothing else.
/// Failures (status < 0) throw std::runtime_error with the library's message.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/frame.hpp"
#include "rollcon_layers.h"
#include "support/closed_forms.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon::scenes {

using closed_forms::Elastic;

/// Holds results of a solve, in the contact's axes.
struct Solution {
  std::int32_t status = 0;
  std::vector<double> x, y;                     ///< node positions
  std::vector<std::array<double, 3>> traction;  ///< on body 1
  std::vector<std::array<double, 2>> slip;      ///< of body 1 relative to body 2
  std::vector<double> pressure, gap, area, weight;
  std::vector<std::int32_t> state;  ///< state of each node: ROLLCON_OPEN, ...
  std::array<double, 3> force{}, moment{}, creep{};
  double approach = 0;

  std::size_t nodes() const { return x.size(); }
};

/// Returns the largest difference of pressures over the largest one, or of frictional tractions over theirs. NaN: the
/// frames differ.
double traction_difference(const Solution& s, const Solution& reference);

/// Names faces whose nodes are held in some directions: bits 1 x, 2 y, 4 z.
struct Slide {
  std::int32_t tag = 0, dof_mask = 7;
};

/// Describes a body of finite elements if it has any, else of boundary elements; without material it is a rigid
/// surface.
struct MeshedBody {
  SurfaceMesh mesh;  ///< the surface, with the volume's nodes and its faces' tags
  VolumeElements volume;
  std::optional<Elastic> material;
  std::vector<std::int32_t> held_tag;  ///< faces held in all directions
  std::vector<Slide> slide;
  std::vector<std::int32_t> contact_tag;  ///< empty: the library's choice
  std::vector<std::pair<std::string, double>> option;
  std::vector<std::pair<std::string, std::int64_t>> int_option;
  /// The mesh is the section of a body that is turned about y: its least z is held, its greatest one in contact.
  bool turned = false;
};
/// Makes a body of finite elements.
MeshedBody meshed(volumes::Mesh mesh, const Elastic& material);
MeshedBody meshed(SurfaceMesh mesh, const Elastic& material);

struct HalfspaceBody {
  Elastic material;
};
struct RigidBody {};
/// Stands for body 1 once more as body 2, with a pose of its own.
struct TwinBody {};
using AnyBody = std::variant<HalfspaceBody, RigidBody, MeshedBody, TwinBody>;
/// Makes a body that is not body 1 itself. The caller releases it.
rollcon_body* make_body(rollcon_context* context, const AnyBody& body);

class RollingPair {
 public:
  RollingPair(const AnyBody& body1, const AnyBody& body2, int threads);
  /// Makes half-spaces; without material a body is rigid.
  RollingPair(std::optional<Elastic> body1, std::optional<Elastic> body2, int threads = 1);
  ~RollingPair();
  RollingPair(const RollingPair&) = delete;
  RollingPair& operator=(const RollingPair&) = delete;

  RollingPair& frame(const SurfaceMesh& mesh);
  /// Sets a frame of nx x ny elements, from -half_x to half_x and from -half_y to half_y in the plane of the axes.
  RollingPair& rectangle(ElementType type, int nx, int ny, double half_x, double half_y);
  RollingPair& frame_from_body(int which, std::int32_t tag);
  RollingPair& pose(int which, const std::array<Vec3, 3>& rotation, const Vec3& translation);
  RollingPair& axes(const Vec3& origin, const Vec3& rolling, const Vec3& normal);
  /// Sets the rolling direction at `angle` (radian) to the frame's x axis, the normal along z.
  RollingPair& rolling_at(double angle);
  RollingPair& gap(const std::vector<double>& h);
  RollingPair& gap_quadratic(double A, double B, double C = 0);
  RollingPair& speed(double v);
  RollingPair& creep(double longitudinal, double lateral, double spin);
  RollingPair& creep_field(const std::vector<double>& slip_pairs);
  RollingPair& approach(double value);  ///< normal direction by motion
  RollingPair& load(double value);      ///< normal direction by force
  RollingPair& tangential_force(std::int32_t direction, double value);
  RollingPair& friction(double mu);
  RollingPair& option(const char* name, const char* value);
  RollingPair& option(const char* name, double value);
  RollingPair& option(const char* name, std::int64_t value);

  /// Solves and returns the status, which is >= 0.
  std::int32_t solve();
  void reset();
  Solution solution() const;
  /// Returns displacements (three per point) of body 1 or 2 at (x, y) pairs.
  std::vector<double> displacements_at(int body, const std::vector<double>& xy) const;
  double stat(const char* name) const;
  double body_stat(int which, const char* name) const;
  std::string plan() const;

  rollcon_context* context() const { return context_; }
  rollcon_contact* handle() const { return contact_; }
  rollcon_body* body(int which) const { return body_[which - 1]; }

 private:
  std::int32_t check(std::int32_t status, const char* what) const;
  std::vector<double> field(std::int32_t which, std::size_t components) const;

  rollcon_context* context_ = nullptr;
  rollcon_body* body_[2] = {};
  rollcon_contact* contact_ = nullptr;
};

}  // namespace rollcon::scenes
