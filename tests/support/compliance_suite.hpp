#pragma once
/// What every body model owes the contact: one set of checks over Compliance.

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "geometry/pose.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Where the body and its frame stand, and in which units their numbers are.
struct Placement {
  Pose pose;
  double length = 1, stress = 1;  ///< sizes of the standard's units in these units
};

/// A body's compliance on a frame; what it refers to is kept alive.
struct PlacedCompliance {
  std::vector<std::shared_ptr<const void>> keep;
  std::shared_ptr<const Frame> frame;
  std::shared_ptr<Compliance> compliance;
};

struct ComplianceCase {
  std::string name;
  /// Finer with the level; unit length and Young's modulus are those of the placement.
  std::function<PlacedCompliance(int level, const Placement&)> make;
  /// The same body carried along by a rigid motion of all that is held; null: none (a half-space).
  std::function<PlacedCompliance(const std::function<Vec3(const Vec3&)>& motion)> moved;
  double young = 1;
  // Bounds.
  double superposition = 1e-12;  ///< apply of a sum; of the largest displacement
  double expansion = 1e-10;      ///< with the unknowns written out; of the largest entry
  double block = 1e-12;          ///< block against apply
  double placement = 1e-10;      ///< turned and shifted
  double units = 1e-12;
  std::vector<double> reciprocity;  ///< one bound per level; errors must fall
  double least_order = 0;           ///< of reciprocity from first to last level, halving each time
  double rigid_motion = 1e-8;
  /// t1^T M u2 = t2^T M u1 with the frame's mass matrix M; 0: not so.
  double nodal_reciprocity = 0;
};
void PrintTo(const ComplianceCase& c, std::ostream* out);

// Each prints errors and bounds and fails the running test.
void check_superposition(const ComplianceCase& c);
void check_expansion(const ComplianceCase& c);
void check_reciprocity(const ComplianceCase& c);
void check_nodal_reciprocity(const ComplianceCase& c);
void check_positive_definite(const ComplianceCase& c);
void check_placement(const ComplianceCase& c);
void check_units(const ComplianceCase& c);
void check_rigid_motion(const ComplianceCase& c);

/// Largest entry of P K^-1 B + N less block() over that block's largest: at the frame's nodes, at points upstream of
/// them and between them, and at points around the frame.
double expansion_error(const Frame& frame, const Compliance& compliance);

/// t^T M u of smooth loads that vanish at the frame's rim: four each along t1, t2 and n.
std::vector<double> work_of_smooth_loads(const PlacedCompliance& p);

}  // namespace rollcon
