#pragma once
/// Makes what a solve stands on, part by part, each again only where something it depends on has changed.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/effort.hpp"
#include "contact/operators/dense_operators.hpp"
#include "contact/prepare/carried_rows.hpp"
#include "contact/prepare/operator_family.hpp"
#include "contact/prepare/placed_frame.hpp"
#include "contact/prepared.hpp"
#include "contact/scene/procedure.hpp"

namespace rollcon {

/// Tells whether a part is still that of its key.
template <class... Parts>
class Stage {
 public:
  /// Returns true if the part has to be made, for a key that is not the last one.
  bool enter(Parts... parts) {
    std::tuple<Parts...> key(std::move(parts)...);
    if (key_ && *key_ == key) return false;
    key_ = std::move(key);
    ++version_;
    return true;
  }
  /// Makes the next enter() return true, whatever its key.
  void forget() { key_.reset(); }
  /// Returns a number that is new whenever the part is made: it belongs to the keys of all that depend on the part.
  std::int64_t version() const { return version_; }

 private:
  std::optional<std::tuple<Parts...>> key_;
  std::int64_t version_ = 0;
};

/// Tells what preparing changed that solutions and solvers have to follow.
struct Changes {
  bool nodes = false;      ///< number of nodes changed
  bool operators = false;  ///< rows or scales were made anew
  bool images = false;     ///< rows that tractions were applied to were made anew
  bool system = false;     ///< systems of published procedures do not fit any more
  double datum = 0;        ///< amount added to the datum that approaches count from
};

struct Preparation {
  using Revision = std::int64_t;
  using Poses = std::array<Revision, 2>;

  Preparation() { made->problem.op = dense; }

  std::shared_ptr<Prepared> made = std::make_shared<Prepared>();
  /// Operators of `made` where their rows are formed, so that more can be added; else null.
  std::shared_ptr<DenseOperators> dense = std::make_shared<DenseOperators>();
  Revision mesh = -1;  ///< revision of the frame's mesh
  /// Key: mesh, place if it cannot follow that, axes, poses that turn or move it, gap if bodies end there, conformal.
  Stage<Revision, Revision, Revision, Poses, Poses, bool> frame;
  Stage<Revision, Revision> place;                     ///< frame, revision
  Stage<Revision, Poses, Poses> rim;                   ///< frame, poses of bodies with a mesh, where the gap ends
  Stage<Revision, double, double, double> compliance;  ///< frame, accuracy, layer, speed of bodies that creep
  Stage<Revision, Scheme> convection;                  ///< compliance, scheme
  Stage<Revision> offset;                              ///< convection
  /// Key: convection, revision, place if it varies across.
  Stage<Revision, Revision, Revision> friction;
  Stage<Revision, double> law;  ///< friction, rolling speed
  /// Key: frame, place, offset, revision, poses if measured.
  Stage<Revision, Revision, Revision, Revision, Poses> gap;
  /// Key: convection, gap, place of the points, poses; where there are velocities.
  Stage<Revision, Revision, Revision, Poses> between;
  /// Key: convection, between, place of the points, offset, revision.
  Stage<Revision, Revision, Revision, Revision, Revision> slip;
  Stage<Revision, Revision, double> points;  ///< convection, place, distance of a time step
  Stage<Revision> lattice;                   ///< frame
  Stage<Revision, Revision, bool> scales;    ///< frame, rows, estimated
  Revision offset_change = 0;                ///< changes whenever an offset comes, goes or is replaced
  Revision rows = 0;                         ///< counts assemblies of the operators' rows
  UnitFrame unit;                            ///< frame that is placed, before it was
  OperatorFamily family;                     ///< operators of a frame that is placed
  CarriedRows carried;                       ///< displacements a time step before
  int threads = 1;
  Procedure procedure;
  Builds builds;
  Timings timings;                  ///< times of the compliance and the stencils; the caller begins them anew
  Changes changes;                  ///< what the caller has to follow; it clears them
  SparseRows field_rows;            ///< rows that carry a creep field to where the characteristic scheme takes slip
  std::vector<double> field_given;  ///< workspace for these rows
  /// Points where velocities are compared, in the axes, over the origin and over the points at which slip is taken;
  /// empty: at the origin and at these points themselves.
  Vec3 origin_between{0, 0, 0};
  std::vector<Vec3> point_between;
  MotionValues creepage{};                         ///< creepages that follow from velocities, by Motion
  std::vector<double> rigid[2];                    ///< slip of a time step that neither motions nor tractions change
  std::unique_ptr<Compliance> body_compliance[2];  ///< compliance of one body, made when it is asked for
};

/// Prepares the bodies, as the first solve with them does. Throws Error naming the body.
void prepare_bodies(Preparation& preparation, Body& body1, Body& body2);
/// Brings everything that depends on the scene up to date; only what changed is done again. Throws Error; what was half
/// made is then useless.
void prepare(Preparation& preparation, const Scene& scene, Body& body1, Body& body2, int threads);
/// Returns what the scene prescribes, once it is prepared.
Prescribed prescribed_by(const Scene& scene, const Preparation& preparation);
/// Makes the dense operators, which the monolithic form leaves out, for what needs them after a solve.
void require_operators(Preparation& preparation);

// Parts of prepare() follow.

/// Drops all rows.
void forget_operators(Preparation& preparation);
/// Assembles the dense operators that the scene needs and that are not there yet.
void assemble_missing(Preparation& preparation);
void choose_scales(Preparation& preparation);  ///< measured by the rows, or estimated
/// Finds what the bodies' own loads, if any, add to gaps and slip.
void find_offset(Preparation& preparation);
void read_gap(Preparation& preparation, const Scene& scene);  ///< at the nodes, from the datum on
/// Returns the revisions of the poses of bodies with a surface; -1 for others.
Preparation::Poses poses_of_surfaces(const Scene& scene, const PairOfBodies& pair);

}  // namespace rollcon
