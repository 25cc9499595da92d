#pragma once
/// Holds everything a caller gave for one contact, checked on the way in. The solver only reads it.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/scene/enumerators.hpp"
#include "contact/scene/friction_given.hpp"
#include "contact/scene/options.hpp"
#include "geometry/height_grid.hpp"
#include "geometry/pose.hpp"
#include "geometry/velocity.hpp"
#include "mesh/frame.hpp"
#include "support/linear_between.hpp"

namespace rollcon {

enum class Direction : std::int32_t { longitudinal = 1, lateral = 2, normal = 3, spin = 4, tilt1 = 6, tilt2 = 7 };
/// Says what a load follows from; by_velocity: creepages and spin follow from the velocities of the bodies.
enum class How : std::int32_t { by_velocity = 0, by_motion = 1, by_force = 2 };

/// Loads one direction. value: force (or spin moment) on body 1 when by force - except for the normal direction, where
/// it is the compressive load >= 0 - else approach, creepage or spin.
struct Load {
  How how = How::by_motion;
  double value = 0;
};

/// Tells the solver by counters what changed since it last looked. Setting equal values again counts nothing.
/// kinematics: speed, velocities and creep field; load: what is prescribed, creepages included. mesh: nodes and
/// elements of the frame; a frame that moves with its body counts as pose alone.
struct Revisions {
  std::int64_t mesh = 0, place = 0, axes = 0, gap = 0, kinematics = 0, load = 0, friction = 0;
  std::array<std::int64_t, 2> pose{};
  bool operator==(const Revisions&) const = default;
};

/// Places a mesh of the unit disc, or another that was given in the axes, as a frame: x = length X + shear Y, y = width
/// Y.
struct FramePlace {
  double length = 1, width = 1, shear = 0;
  bool operator==(const FramePlace&) const = default;
};

/// Tells where a frame that was taken from a body comes from.
struct FrameSource {
  int body = -1;  ///< 0 or 1; -1: the caller's own mesh
  std::int32_t tag = 0;
  std::vector<std::int64_t> element;  ///< body's element of each frame element
  std::vector<std::int32_t> node;     ///< body's node of each frame node
  std::vector<Vec3> place;            ///< frame nodes in the body's coordinates
};

/// Collects what is set for a contact. Setters throw Error and then leave everything as it was; those of a time loop
/// (all but frame nodes and elements) allocate nothing once their arrays have the frame's size.
class Scene {
 public:
  /// Makes an empty scene; messages count from index_base before elements tell the caller's way.
  explicit Scene(std::int32_t index_base = 0);

  /// Replaces the frame's nodes; forgets elements, gap array and fields.
  void set_frame_nodes(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride);
  void add_frame_elements(std::int32_t type, std::int64_t n, const std::int32_t* connectivity, std::int32_t index_base,
                          std::int32_t tag);
  /// Takes the faces of body `which` (0 or 1) with that tag, nodes numbered anew in ascending order; those of body 2
  /// are turned over. They follow the body's pose. Forgets what set_frame_nodes forgets.
  void set_frame_from(int which, const SurfaceMesh& body, std::int32_t tag);
  /// Takes a frame in the plane of the axes that the library made. ends_at_edge: nodes on its outline lie where the
  /// contact ends and carry no traction. given: the caller asked for it; else the next solve may take another one.
  /// Forgets what set_frame_nodes forgets.
  void set_made_frame(SurfaceMesh mesh, bool ends_at_edge, bool given);
  /// Takes a frame of the library's choice that ends at the contact's edge: a mesh with nodes (X, Y, 0), to be placed
  /// anew where contacts change.
  void set_placed_frame(SurfaceMesh mesh, const FramePlace& place);
  /// Takes a frame of strips that ends at the contact's edge; where its layout is that of the last one it is moved. It
  /// lies in the plane of the axes; see set_made_frame() for the rest.
  void set_strips(const strips::StripLayout& layout, const std::vector<double>& geometry);
  /// Returns null where the frame is not of strips.
  const strips::StripFrame* strips() const { return strips_.get(); }
  /// Says whether the frame moves with the contact.
  bool frame_moves() const { return placed() || strips_; }
  /// Moves a placed frame; it follows the axes, too.
  void place_frame(const FramePlace& place);
  bool placed() const { return !unplaced_.empty(); }
  const FramePlace& place() const { return place_; }
  /// Returns the mesh of a placed frame as it would be elsewhere.
  SurfaceMesh mesh_at(const FramePlace& place) const;
  /// Lets the library make the frame from now on, as in a new scene.
  void forget_frame();
  /// Takes over what was set in another scene, apart from the frame and what is given node by node.
  void take_over(const Scene& other);
  /// Sets where body `which` (1 or 2) stands: x = rotation x_body + translation, rotation row by row.
  void set_pose(std::int32_t which, const double* rotation, const double* translation);
  void set_axes(const double* origin, const double* rolling, const double* normal);  ///< normal: out of body 1
  void set_gap(std::int64_t n, const double* gap);       ///< each of the three replaces the others
  void set_gap_quadratic(double a, double b, double c);  ///< a x^2 + b y^2 + c x y
  void set_gap_grid(const GridPlace& place, const double* gap);
  void set_speed(double speed);  ///< rolling speed, above 0
  /// Makes every solve a step of dt (StepKind's numbers); dt counts for nothing where it is steady.
  void set_step(std::int32_t kind, double dt);
  /// Sets the velocity of body `which` (1 or 2) or of the contact (0), in the axes of space, as Velocity has it; those
  /// not set are at rest. Creepages and spin follow from the velocities from then on, until they are prescribed, and
  /// the speed from that of the contact, until it is set.
  void set_velocity(std::int32_t which, const double* velocity, const double* angular_velocity, const double* point);
  /// Prescribes creepages and spin; forgets velocities.
  void set_creep(double longitudinal, double lateral, double spin);
  /// Sets the rigid slip velocity at each node, (c1, c2) pairs in the axes; it adds to creepages and spin.
  void set_creep_field(std::int64_t n, const double* slip);
  void prescribe(std::int32_t direction, std::int32_t how, double value);        ///< numbers of Direction and How
  void set_friction(const char* law, std::int32_t n, const double* parameters);  ///< see law_names()
  /// Takes law, layer and heat of another contact, with another (greatest) coefficient.
  void take_friction(const FrictionGiven& given, double mu);
  /// Takes the coefficients of `of`, which has Coulomb's law without a field, times a factor.
  void scale_friction(const Scene& of, double factor);
  void set_friction_field(std::int64_t n, const double* mu);  ///< coefficient at each node
  /// Sets the memory of laws that fall, whichever is set; a length of 0: none.
  void set_friction_memory(double length, double least_speed);
  /// Sets a layer between the bodies: its tangential displacement per traction; it flows under a traction of stress +
  /// hardening times the flow, with a stress of 0 never.
  void set_layer(double flexibility, double stress = 0, double hardening = 0);
  /// Sets coefficients along t2, linear between points (y, mu) with ascending y; they replace that of the law where no
  /// field is given. n = 0: none.
  void set_friction_across(std::int64_t n, const double* points);
  /// Sets the thermal properties of body `which` (1 or 2) and its temperature.
  void set_heat(std::int32_t which, double conductivity, double capacity, double temperature);

  const SurfaceMesh& mesh() const { return mesh_; }
  bool frame_given() const { return frame_given_; }
  bool ends_at_edge() const { return ends_at_edge_; }
  const FrameSource& frame_source() const { return frame_source_; }
  const Pose& pose(std::size_t body) const { return pose_[body]; }  ///< 0 or 1
  const Axes& axes() const { return axes_; }
  /// Returns the speed at a point of the axes: what was set, or the speed of the contact over both bodies.
  double speed(const Vec3& point) const;
  bool speed_given() const { return rolling_.speed_given || rolling_.travel_given; }
  StepKind step_kind() const { return rolling_.step; }
  double step_time() const { return rolling_.dt; }
  bool velocities_given() const { return rolling_.velocities_given; }
  /// Returns the velocity of body 1 relative to body 2, in the directions of the axes; its point is their origin.
  Velocity relative_velocity() const;
  const Load& load(Direction d) const { return load_[motion_of(d)]; }
  /// Says whether body 1 turns about t1 or t2, by a motion or a moment that is given.
  bool tilts() const;
  const std::vector<double>& creep_field() const { return creep_field_; }
  bool has_gap() const { return gap_.kind != GapKind::none; }
  /// Returns a, b, c of set_gap_quadratic, where that is what was given last.
  std::optional<std::array<double, 3>> quadratic_gap() const;
  /// Returns the gap of set_gap_grid where that was given last; else null.
  std::shared_ptr<const HeightGrid> gap_grid() const { return gap_.kind == GapKind::grid ? gap_.grid : nullptr; }
  /// Returns the gap of node k at (x, y) in the axes; needs has_gap(). err_argument: a grid has no gap there.
  double gap(std::int64_t k, double x, double y) const;
  /// Returns the friction coefficient of node k, which lies at y.
  double friction(std::int64_t k, double y) const {
    if (!friction_field_.empty()) return friction_field_[static_cast<std::size_t>(k)];
    return across_.y.empty() ? friction_.mu() : linear_between(across_.y, across_.mu, y);
  }
  /// Return where coefficients across are given, and these.
  const std::vector<double>& friction_places() const { return across_.y; }
  const std::vector<double>& friction_there() const { return across_.mu; }
  /// Returns null for Coulomb's law.
  const std::shared_ptr<const FrictionLaw>& law() const { return friction_.law(); }
  bool friction_varies_across() const { return friction_field_.empty() && !across_.y.empty(); }
  double layer() const { return friction_.layer(); }  ///< flexibility
  const BothHeats& heat() const { return friction_.heat(); }
  /// Throws err_state naming what is missing: nodes, elements, gap (unless a body has a surface), friction, speed
  /// (where there are velocities). Arrays always fit the frame: their length is checked when they are set, and new
  /// nodes forget them.
  void require_complete(bool has_surface = false) const;

  Options options;
  Revisions revision;

 private:
  void require_frame_size(std::int64_t n, const char* what) const;
  void replace_frame(SurfaceMesh mesh, FrameSource source);
  void put_nodes(const FramePlace& place, std::vector<Vec3>& node) const;

  SurfaceMesh mesh_;
  FrameSource frame_source_;
  bool frame_given_ = false, ends_at_edge_ = false;
  std::vector<Vec3> unplaced_;  ///< nodes of a placed frame; empty: it is none
  std::unique_ptr<strips::StripFrame> strips_;
  FramePlace place_;
  std::array<Pose, 2> pose_{};
  Axes axes_;
  // What is set together, as values.
  enum class GapKind { none, nodes, quadratic, grid };
  struct GapGiven {
    GapKind kind = GapKind::none;
    std::vector<double> node;
    std::array<double, 3> quadratic{0, 0, 0};
    std::shared_ptr<const HeightGrid> grid;  ///< owned together with the scenes that took it over
  };
  struct Rolling {
    StepKind step = StepKind::steady;
    double dt = 0, speed = 1;
    bool speed_given = false, velocities_given = false, travel_given = false;
    std::array<Velocity, 3> velocity{};  ///< velocities of the contact and both bodies
  };
  struct FrictionAcross {
    std::vector<double> y, mu;
  };
  GapGiven gap_;
  Rolling rolling_;
  std::array<Load, motion_count> load_{};
  FrictionGiven friction_;
  FrictionAcross across_;
  std::vector<double> creep_field_, friction_field_;
};

}  // namespace rollcon
