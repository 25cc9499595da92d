#pragma once
/// What is computed from a solution when somebody asks, and kept until the next solve.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/solution.hpp"
#include "mesh/vec3.hpp"

namespace rollcon {

/// Errors relative to the results, of the forces that go with the motions of the solution.
struct ErrorEstimate {
  bool known = false;
  double normal = 0;      ///< normal force, over itself
  double tangential = 0;  ///< tangential force, over the integral of |tangential traction|
  double tractions = 0;   ///< L2 norm; of pressures or of tangential tractions, whichever is worse
  double seconds = 0;     ///< what finding it took

  /// NaN where either is.
  double worst() const { return tangential <= normal || normal != normal ? normal : tangential; }
};

/// What results on two frames of a family tend to (contact/results/extrapolation.hpp).
struct Extrapolated {
  Vec3 force{}, moment{};  ///< on body 1, about the origin, in the axes
  MotionValues motion{};   ///< by Motion; the approach from no approach on
  double area = 0;         ///< in contact
  double left_over = 0;    ///< of the difference of the frames, by which the finer one is off
};

/// Derivatives of results (contact/results/sensitivity.hpp), per unit of a parameter, in the axes.
struct Rates {
  Vec3 force{}, moment{};  ///< on body 1, about the origin
  MotionValues motion{};   ///< by Motion
};

/// What scene, poses and velocities prescribe at the nodes of a frame, or how fast that changes.
struct NodeGivens {
  std::vector<double> gap;      ///< at the approach that is prescribed
  std::vector<double> slip[2];  ///< rigid slip over speed, motions included
  std::vector<double> mu;
};

struct Sensitivities {
  static constexpr std::size_t parameters = 7;
  std::array<bool, parameters> known{};  ///< by Parameter, minus one
  std::array<Rates, parameters> rates{};
  std::int64_t right_sides = 0, factorizations = 0, linear_iterations = 0;
  double seconds = 0;
};

/// How often results were computed since the contact was made.
struct Computed {
  std::int64_t applications = 0;  ///< of the compliance, without rows
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
  bool displacements = false;  ///< those of a body were asked for
  Computed computed;

  /// Forgets everything but counts and storage: the only way back.
  void forget();
};

/// Slip, gap and status of the nodes.
void derive_fields(const Solution& solution, Derived& derived);
/// The deformed gap alone, at every node.
void derive_gap(const Solution& solution, double* gap);
/// The residuals of every law from matrix-free displacements, independently of the solver's operators:
/// complementarity, friction bound, slip direction, loads; each relative.
void check_laws(const Solution& solution, Derived& derived);

}  // namespace rollcon
