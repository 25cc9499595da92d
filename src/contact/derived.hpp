#pragma once
/// Holds what is computed from a solution when somebody asks; it stays until the next solve.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/solution.hpp"
#include "mesh/vec3.hpp"

namespace rollcon {

/// Holds relative errors of the forces that go with the motions of the solution.
struct ErrorEstimate {
  bool known = false;
  double normal = 0;      ///< error of the normal force, over that force
  double tangential = 0;  ///< error of the tangential force, over the integral of |tangential traction|
  double tractions = 0;   ///< L2 error of pressures or of tangential tractions, whichever is worse
  double seconds = 0;     ///< time that finding it took

  /// Returns the greater error; NaN where either is.
  double worst() const { return tangential <= normal || normal != normal ? normal : tangential; }
};

/// Holds what results on two frames of a family tend to (contact/results/extrapolation.hpp).
struct Extrapolated {
  Vec3 force{}, moment{};  ///< force on body 1 and its moment about the origin, in the axes
  MotionValues motion{};   ///< indexed by Motion; the approach counts from the gap as given
  double area = 0;         ///< area in contact
  double left_over = 0;    ///< part of the frames' difference by which the finer one is off
};

/// Holds derivatives of results (contact/results/sensitivity.hpp) with respect to one parameter, in the axes.
struct Rates {
  Vec3 force{}, moment{};  ///< force on body 1 and its moment about the origin
  MotionValues motion{};   ///< indexed by Motion
};

/// Holds what scene, poses and velocities prescribe at the nodes of a frame, or how fast that changes.
struct NodeGivens {
  std::vector<double> gap;      ///< undeformed gap minus the prescribed approach
  std::vector<double> slip[2];  ///< rigid slip over speed, motions included
  std::vector<double> mu;
};

struct Sensitivities {
  static constexpr std::size_t parameters = 7;
  std::array<bool, parameters> known{};  ///< indexed by Parameter, minus one
  std::array<Rates, parameters> rates{};
  std::int64_t right_sides = 0, factorizations = 0, linear_iterations = 0;
  double seconds = 0;
};

/// Counts how often results were computed since the contact was made.
struct Computed {
  std::int64_t applications = 0;  ///< applications of the compliance, without rows
  std::int64_t fields = 0, laws = 0, displacements = 0, estimates = 0;
};

struct Derived {
  bool fields = false;          ///< slip, gap and status are known
  std::vector<double> slip[2];  ///< slip velocity
  std::vector<double> gap;      ///< deformed gap
  std::vector<std::int32_t> status;
  bool laws_checked = false;
  std::array<double, 4> laws{};  ///< residuals: normal, friction, slip, equilibrium
  Sensitivities sensitivities;
  ErrorEstimate error_estimate;
  std::optional<Extrapolated> extrapolated;
  // What whoever made the frame knows better than its nodes tell follows.
  std::optional<double> largest_pressure, area;  ///< top of the pressures between nodes; area in contact
  bool displacements = false;                    ///< displacements of a body were asked for
  Computed computed;

  /// Forgets everything but counts and storage; there is no other reset.
  void forget();
};

/// Computes slip, gap and status of the nodes.
void derive_fields(const Solution& solution, Derived& derived);
/// Computes the deformed gap alone, at every node.
void derive_gap(const Solution& solution, double* gap);
/// Computes the relative residuals of all laws from matrix-free displacements, independently of the solver's operators:
/// complementarity, friction bound, slip direction, loads.
void check_laws(const Solution& solution, Derived& derived);

}  // namespace rollcon
