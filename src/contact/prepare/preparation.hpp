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

/// Whether a part is still that of its key.
template <class... Parts>
class Stage {
 public:
  /// True if the part has to be made, for a key that is not the last one.
  bool enter(Parts... parts) {
    std::tuple<Parts...> key(std::move(parts)...);
    if (key_ && *key_ == key) return false;
    key_ = std::move(key);
    ++version_;
    return true;
  }
  /// The part has to be made again, whatever its key.
  void forget() { key_.reset(); }
  /// Another one whenever the part is made: belongs to the keys of all that depend on it.
  std::int64_t version() const { return version_; }

 private:
  std::optional<std::tuple<Parts...>> key_;
  std::int64_t version_ = 0;
};

/// What preparing changed that solutions and solvers have to follow.
struct Changes {
  bool nodes = false;      ///< there is another number of them
  bool operators = false;  ///< rows or scales were made anew
  bool images = false;     ///< so were the rows that tractions were applied to
  bool system = false;     ///< systems of published procedures do not fit any more
  double datum = 0;        ///< by so much more do approaches count from
};

struct Preparation {
  using Revision = std::int64_t;
  using Poses = std::array<Revision, 2>;

  Preparation() { made->problem.op = dense; }

  std::shared_ptr<Prepared> made = std::make_shared<Prepared>();
  /// The operators of `made` where their rows are formed: more can be added. Else null.
  std::shared_ptr<DenseOperators> dense = std::make_shared<DenseOperators>();
  Revision mesh = -1;  ///< of the frame
  /// mesh, place if it cannot follow that, axes, poses that turn or move it, gap if bodies end there, conformal
  Stage<Revision, Revision, Revision, Poses, Poses, bool> frame;
  Stage<Revision, Revision> place;             ///< frame, revision
  Stage<Revision, Poses, Poses> rim;           ///< frame, poses of bodies with a mesh, where the gap ends
  Stage<Revision, double, double> compliance;  ///< frame, accuracy, layer
  Stage<Revision, Scheme> convection;          ///< compliance, scheme
  Stage<Revision> offset;                      ///< convection
  /// convection, revision, place if it varies across
  Stage<Revision, Revision, Revision> friction;
  Stage<Revision, double> law;  ///< friction, rolling speed
  /// frame, place, offset, revision, poses if measured
  Stage<Revision, Revision, Revision, Revision, Poses> gap;
  /// convection, gap, place of the points, poses; where there are velocities
  Stage<Revision, Revision, Revision, Poses> between;
  /// convection, between, place of the points, offset, revision
  Stage<Revision, Revision, Revision, Revision, Revision> slip;
  Stage<Revision, Revision, double> points;  ///< convection, place, distance of a time step
  Stage<Revision> lattice;                   ///< frame
  Stage<Revision, Revision, bool> scales;    ///< frame, rows, estimated
  Revision offset_change = 0;                ///< one is there, or there was one before
  Revision rows = 0;                         ///< of the operators were assembled
  UnitFrame unit;                            ///< of a frame that is placed
  OperatorFamily family;                     ///< likewise
  CarriedRows carried;                       ///< of time steps
  int threads = 1;
  Procedure procedure;
  Builds builds;
  Timings timings;                  ///< of the compliance and the stencils; begun anew by the caller
  Changes changes;                  ///< taken by the caller
  SparseRows field_rows;            ///< carries a creep field to where the characteristic scheme takes slip
  std::vector<double> field_given;  ///< workspace for that
  /// Where velocities are compared, in the axes: over their origin, and over the points at which slip is taken; empty:
  /// there, and at the origin.
  Vec3 origin_between{0, 0, 0};
  std::vector<Vec3> point_between;
  MotionValues creepage{};                         ///< by Motion, from velocities
  std::vector<double> rigid[2];                    ///< of a time step: slip that neither motions nor tractions change
  std::unique_ptr<Compliance> body_compliance[2];  ///< of one body, made when it is asked for
};

/// Prepares the bodies, as the first solve with them does. Throws Error naming the body.
void prepare_bodies(Preparation& preparation, Body& body1, Body& body2);
/// Brings everything that depends on the scene up to date; only what changed is done again. Throws Error; what was half
/// made is then useless.
void prepare(Preparation& preparation, const Scene& scene, Body& body1, Body& body2, int threads);
/// What the scene prescribes, once it is prepared.
Prescribed prescribed_by(const Scene& scene, const Preparation& preparation);
/// The dense operators, which the monolithic form leaves out: for what needs them after a solve.
void require_operators(Preparation& preparation);

// Parts of prepare().

/// No rows are there from then on.
void forget_operators(Preparation& preparation);
/// The dense operators that the scene needs and that are not there yet.
void assemble_missing(Preparation& preparation);
void choose_scales(Preparation& preparation);
/// What the bodies' own loads add to gaps and slip, where they have some.
void find_offset(Preparation& preparation);
void read_gap(Preparation& preparation, const Scene& scene);
/// Revisions of the poses of bodies with a surface; -1 of others.
Preparation::Poses poses_of_surfaces(const Scene& scene, const PairOfBodies& pair);

}  // namespace rollcon
