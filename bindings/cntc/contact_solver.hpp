#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "handles.hpp"
#include "result.hpp"

namespace cntc {

/// Holds where bodies with profiles stand: rotations and translations of rollcon's bodies, and the axes of the contact.
struct Placement {
  Mat3 wheel_rotation{}, rail_rotation{};
  Vec3 wheel_origin{}, rail_origin{};
  Vec3 origin{}, along{1, 0, 0}, normal{0, 0, 1};
  // Velocities and rates of rotation of the bodies, at a point of each, give the slip where by_velocity is set.
  bool by_velocity = false, conformal = false;
  Vec3 wheel_velocity{}, wheel_rate{}, wheel_point{}, rail_velocity{}, rail_rate{}, rail_point{};
};

/// Finds where a function that grows with its argument is 0, or with a step below 0 one that falls, from a start by
/// steps that double, then by the rule of false position; the last call is at the place found. Returns false where the
/// function keeps its sign as far as `far` from the start.
bool find_root(const std::function<double(double)>& off, double start, double step, double far, double accuracy);

/// Returns the coefficient of static friction at one place.
double rest_friction(const FrictionRow& row, int law);

/// Holds what is prescribed for one contact, and how, in mm, s and N, by CONTACT's signs.
struct ContactCase : Motion {
  Grid grid;
  int tang = 3, pvtime = 2, iestim = 0, force = 0;
  bool normal_by_force = false;
  std::vector<double> gap;  // by element; not used with profiles
  bool sensitivities = false;
  const Placement* placement = nullptr;
  bool moved = true;  // the placement differs from that of the last solve
};

/// Turns one case into a contact of rollcon: CONTACT's body 1 is rollcon's body 2, so that n is CONTACT's z.
class ContactSolver {
 public:
  /// Makes the bodies of the contact; set_bodies takes those of the caller instead, which have profiles.
  void set_material(const Inputs& in);
  void set_bodies(rollcon_context* context, rollcon_body* first, rollcon_body* second);
  /// Sets friction at one place, layer and heat; throws Failure where rollcon has no such friction, layer or heat.
  void set_surfaces(const Inputs& in, const FrictionRow& row, int tang);

  /// Solves; returns 0 or an error code, and the reason in why.
  int solve(const ContactCase& wanted, std::string& why);
  void read(const ContactCase& wanted, ContactResult& result) const;

  rollcon_contact* handle() const { return contact_.get(); }
  double fstat() const { return fstat_; }
  /// Returns the force of the last solve on rollcon's body 1, in the axes of its contact.
  Vec3 force() const;

 private:
  enum class Lattice { plain, ringed, point };

  void lay_frame(const ContactCase& wanted);
  void set_poses(const Placement& at);
  void set_gaps(const ContactCase& wanted);
  void set_motion(const ContactCase& wanted);
  int solve_once(const ContactCase& wanted, std::string& why);
  int run_solver(std::string& why);
  int solve_point(const ContactCase& wanted, std::string& why);
  int search_creepage(const ContactCase& wanted, std::string& why);
  bool sticks(const ContactCase& wanted, const Vec3& before);
  /// Tells whether the grid is a single element that sticks or is under given forces.
  bool pushed(const ContactCase& wanted) const {
    return lattice_ == Lattice::point && wanted.tang > 0 && (wanted.force >= 1 || stuck_);
  }
  /// Returns by how much a row of constant tractions is displaced beyond the frame: x, y, normal.
  Vec3 row_offset() const;
  size_t node(int i, int j) const;
  bool one_row() const { return lattice_ == Lattice::ringed && (grid_.mx == 1 || grid_.my == 1); }
  std::vector<double> field(int which, int values) const;
  void read_sensitivities(ContactResult& result) const;
  void read_elements(const ContactCase& wanted, ContactResult& result) const;

  ContextHandle context_;
  BodyHandle first_, second_;
  ContactHandle contact_;
  Material material_;
  bool relaxes_ = false;  // bodies are viscoelastic
  int threads_ = 1;
  double compliance_ = 1, shear_compliance_ = 1, layer_ = 0;
  Material felt_;  ///< the material with its immediate creep (TC = 0)
  bool stuck_ = false;
  double push_[2] = {};  ///< forces on a single element that sticks, in parts of the largest
  Lattice lattice_ = Lattice::plain;
  Grid grid_;
  double chi_ = 0;
  bool framed_ = false, solved_ = false, stepped_ = false, heat_ = false, several_ = false;
  std::vector<double> gap_;
  double fstat_ = 0;
};

}  // namespace cntc
