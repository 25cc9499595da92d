#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "contact_solver.hpp"
#include "problem.hpp"
#include "profile.hpp"

namespace cntc {

/// Gives the length by which an overlap extends beyond each end of the contact, in lengths of the contact: the overlap
/// of an ellipse is longer by a factor of the square root of two.
constexpr double overlap_beyond = .2071;

/// Holds an interval that grows to what it takes.
struct Range {
  double low = 1e300, high = -1e300;

  void take(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  double length() const { return high - low; }
};

/// Holds a patch of the wheel: its place and its contact, in the track of the right side.
struct WheelPatch {
  Placement placement;
  Vec3 reference{};
  double delta = 0, overlap = 0, radius = 0;
  double tilt = 0;  // inclination of the normal to the front, beside the axis of a roller
  Range x, s;       // ends of the contact along its axes, from the reference
  double approach = 0;
  int number = 0;      // number among rollcon's patches
  bool tight = false;  // the grid covers the contact alone, because a profile ends beside it
  std::shared_ptr<ContactSolver> solver;
  ContactCase wanted;

  Vec3 along() const;
  Vec3 across() const;
  Vec3 normal() const;
};

/// Solves a wheel on its rail. rollcon's wheel on rail finds patches and height; each patch is then solved on the
/// caller's grid.
class WheelSolver {
 public:
  int solve(Problem& p, std::string& why);
  /// Fills elements of a patch that was solved on rollcon's frames.
  void fill_elements(Problem& p, size_t patch);

  double sign = 1;  // -1: a left wheel, which is solved as its mirror image
  double z = 0, pitch_rate = 0;
  double x = 0;                        // distance of the wheelset from the place above the axis of a roller
  std::array<double, 2> deflection{};  // how far the rail gives way along y and z of the track (F = 3)
  bool solved = false;
  BodyPlace rail, wheel, wheelset;
  Profile rail_profile, wheel_profile;
  std::vector<WheelPatch> patches;

 private:
  void prepare(const Problem& p);
  void mirror_inputs(const Inputs& in);
  int search(const Problem& p);
  int solve_on_frames(Problem& p, std::string& why);
  void read_extents(WheelPatch& patch) const;
  double patch_stat(int32_t k, const char* name) const;
  int solve_search();
  void place_wheel(double height);
  void place_rail();
  std::vector<WheelPatch> found_patches() const;
  void join_patches(const PlaneGrid& grid);
  void lay_grid(const Inputs& in, WheelPatch& patch) const;
  void stand_patch(WheelPatch& patch) const;
  void set_creepages(WheelPatch& patch) const;
  void set_velocities(const Inputs& in, WheelPatch& patch) const;
  void set_friction(const Inputs& in, WheelPatch& patch);
  int solve_patch(const Inputs& in, WheelPatch& patch, std::string& why) const;
  Vec3 solve_patches(Problem& p, double sink, int& code, std::string& why);
  Vec3 find_height(Problem& p, int& code, std::string& why);
  void find_pitch_rate(Problem& p, int& code, std::string& why);
  void find_deflection(Problem& p, int& code, std::string& why);
  void ready_patch(const Inputs& in, WheelPatch& patch);
  void read_patch(const Inputs& in, WheelPatch& patch, ContactResult& r) const;

  ContextHandle context_;
  WheelHandle search_;
  /// Numbers of the profiles, threads, shear moduli, Poisson's ratios, NOMRADW, YTAPE and the roller's radius.
  using Made =
      std::tuple<unsigned, unsigned, int, std::array<double, 2>, std::array<double, 2>, double, double, double>;
  Made made_;                       // what profiles and search are made of
  std::vector<double> dimensions_;  // what track and wheelset of the search have; none: nothing yet
  double roller_ = 0;               // radius; 0: a rail
  double depth_ = 0;                // of the roller's axis below the origin of its profile
  Profile roller_profile_;
  // Inputs, mirrored to the right side.
  Track track_;
  Wheelset set_;
  double roller_rate_ = 0, onward_ = 0;  // rate of the roller, speed of the contact over it or over the rail
  double radius_ = 0;                    // radius of the wheel at its profile's z = 0
  double slope_ = 0;                     // change of the force to the power 2/3 with the height
  double sink_ = 0;                      // depth below the height of the search
  Inputs framed_;                        // of the last solve on rollcon's frames
};

/// Returns the contact of a patch, counted from 1, or a null pointer if there is none.
rollcon_contact* wheel_contact(Problem& p, int patch);

}  // namespace cntc
