#pragma once
/// Checks what every body model must provide for the contact, by one set of checks over Compliance.

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "geometry/pose.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Says where the body and its frame stand, and in which units their numbers are.
struct Placement {
  Pose pose;
  double length = 1, stress = 1;  ///< sizes of the standard's units in these units
};

/// Holds a body's compliance on a frame; `keep` owns what it refers to.
struct PlacedCompliance {
  std::vector<std::shared_ptr<const void>> keep;
  std::shared_ptr<const Frame> frame;
  std::shared_ptr<Compliance> compliance;
};

struct ComplianceCase {
  std::string name;
  /// Makes a finer body with a higher level; unit length and Young's modulus are those of the placement.
  std::function<PlacedCompliance(int level, const Placement&)> make;
  /// Makes the body carried along by a rigid motion of all that is held; null: none (a half-space).
  std::function<PlacedCompliance(const std::function<Vec3(const Vec3&)>& motion)> moved;
  double young = 1;
  // The members below are bounds of errors.
  double superposition = 1e-12;  ///< error of apply to a sum, over the largest displacement
  double expansion = 1e-10;      ///< error with the unknowns written out, over the largest entry
  double block = 1e-12;          ///< difference of block and apply
  double placement = 1e-10;      ///< difference when turned and shifted
  double units = 1e-12;
  std::vector<double> reciprocity;  ///< one bound per level; errors must fall
  double least_order = 0;           ///< least order of reciprocity from first to last level, halving each time
  double rigid_motion = 1e-8;
  /// Bound of t1^T M u2 = t2^T M u1 with the frame's mass matrix M; 0: not checked.
  double nodal_reciprocity = 0;
};
void PrintTo(const ComplianceCase& c, std::ostream* out);

// Each check prints errors and bounds and fails the running test.
void check_superposition(const ComplianceCase& c);
void check_expansion(const ComplianceCase& c);
void check_reciprocity(const ComplianceCase& c);
void check_nodal_reciprocity(const ComplianceCase& c);
void check_positive_definite(const ComplianceCase& c);
void check_placement(const ComplianceCase& c);
void check_units(const ComplianceCase& c);
void check_rigid_motion(const ComplianceCase& c);

/// Returns the largest entry of P K^-1 B + N less block(), over that block's largest: at the frame's nodes, at points
/// upstream of them and between them, and at points around the frame.
double expansion_error(const Frame& frame, const Compliance& compliance);

/// Returns t^T M u of smooth loads that vanish at the frame's rim: four each along t1, t2 and n.
std::vector<double> work_of_smooth_loads(const PlacedCompliance& p);

}  // namespace rollcon
