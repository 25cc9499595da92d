#pragma once
/// Solves rolling contact of half-spaces on strips that fit the contact: every row's chord and the width are found with
/// the pressures, so that forces and what one differentiates are smooth in all that is given. docs/theory.md, sections
/// 1 to 3, has the signs and equations. Lengths, forces and creepages are in the caller's units.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "bodies/halfspace/strip_integrals.hpp"
#include "geometry/rectangle.hpp"
#include "geometry/vec2.hpp"
#include "linalg/lu.hpp"
#include "mesh/strip_layout.hpp"

namespace rollcon::strips {

/// Gives a function of the place in the plane of the axes.
class PlaneField {
 public:
  virtual ~PlaneField() = default;
  /// Returns values and slopes at points, finite anywhere. slope may be null.
  virtual void at(std::span<const Vec2> point, double* value, Vec2* slope) const = 0;
};

/// Holds what is given for a solve.
struct StripScene {
  StripBodies bodies;
  const PlaneField* gap = nullptr;  ///< gap of the undeformed bodies at approach 0, length
  bool by_load = true;
  double value = 0;                      ///< normal load, force; or approach, length
  double mu = 0;                         ///< friction coefficient
  const PlaneField* friction = nullptr;  ///< factor of mu; null: 1
  /// Longitudinal and lateral creepage and spin (1/length); or, where force_given, the force on body 1 along x or y or
  /// the spin moment about the origin of the axes.
  std::array<double, 3> motion{};
  std::array<bool, 3> force_given{};
  std::array<const PlaneField*, 2> slip{};  ///< rigid slip over speed, added to what creepages cause
};

/// Holds factors of a solve. Solves nearby take steps with them, which cost less than Newton's and lead to the same
/// solution.
struct StripFactors {
  Lu<double> normal, friction;  ///< the normal problem's, and friction's alone between like bodies
  std::vector<double> across;   ///< StripLayout::across of the normal problem
  int parts = 0;                ///< 0: there are none of the normal problem
  bool by_load = false;
  std::vector<char> slides;  ///< says which nodes slide in friction's; empty: none
  std::array<bool, 3> force_given{};
};

/// Holds a solution or the start of a solve: tractions on body 1 at the layout's nodes, pressures positive.
struct StripState {
  StripLayout layout;
  std::vector<double> geometry, pressure, traction;  ///< traction: along x of all nodes, then along y
  StripFactors factors;                              ///< those of the last solve
  std::vector<double> slip;  ///< slip over speed in the order of traction, 0 where nodes stick; of solutions alone
  double approach = 0;
  std::array<double, 3> motion{};
};

/// Holds resultants and motions, all of body 1.
struct StripTotals {
  double load = 0, approach = 0;
  std::array<double, 3> force{};   ///< forces along x and y, and spin moment about the origin
  std::array<double, 3> motion{};  ///< creepages and spin
  Vec2 pressed{};                  ///< integrals of pressure times x and times y
};

/// Tells how a solve ended. unfit: no strips were found from any start; beyond_friction: friction cannot carry the
/// forces.
enum class StripStatus { solved, no_contact, unfit, beyond_friction, not_converged };

struct StripReport {
  StripStatus status = StripStatus::solved;
  int normal_rounds = 0, friction_rounds = 0;
};

/// Names what to differentiate by: rates of what the scene holds. Its fields have rates at fixed places; null: 0.
struct StripParameter {
  double value = 0, mu = 0;        ///< rates of load or approach and of the friction coefficient
  std::array<double, 3> motion{};  ///< rates of creepages, spin, forces and moment that are given
  const PlaneField* gap = nullptr;
  const PlaneField* friction = nullptr;
  std::array<const PlaneField*, 2> slip{};
};

/// Says what of a state a solve begins with: the geometry; tractions over pressures, too; or a solution nearby.
enum class StripStart { geometry, shares, solution };

/// Holds room for unknowns and matrices alone: results depend on what a call is given. Warm solves allocate nothing.
class StripSolver {
 public:
  /// Solves a scene from the parts of `state` that `start` names.
  StripReport solve(const StripScene& scene, StripState& state, StripStart start);
  /// Solves the normal problem alone, under tangential tractions 0.
  StripReport press(const StripScene& scene, StripState& state, StripStart start);
  static StripTotals totals(const StripState& state);
  /// Computes total derivatives of the totals at a solution, the strips moving with it, one for each parameter; and of
  /// StripTrust::share if wanted.
  bool rates(const StripScene& scene, const StripState& state, std::span<const StripParameter> parameter,
             std::span<StripTotals> rate, std::span<double> share_rate = {});

 private:
  /// Linearises a node's law: direction and share of the bound in the augmented traction.
  struct Law {
    bool slides = false;
    double share = 1;
    Vec2 along{1, 0};
  };
  struct Samples {
    std::vector<Vec2> point, slope;
    std::vector<double> value;
  };
  void sample(const PlaneField* field, std::span<const StripPoint> points, const StripLayout& layout,
              const double* geometry, Samples& into);
  /// Selects what normal_rows() computes: residuals alone, or also columns for pressures at the nodes, or for all
  /// unknowns: pressures (over cn), geometry, approach. Rows are gaps at nodes and edges, and the load.
  enum class Rows { none, pressures, all };
  void normal_rows(const StripScene& scene, const StripState& state, Rows rows, double* matrix, int columns, int stride,
                   double* residual);
  double kept_step(const StripScene& scene, StripState& state, const StripFactors& factors, int n);
  static double normal_size(const StripState& state, const double* step);
  static double normal_step(const StripScene& scene, StripState& state, const double* step, double share);
  bool press_on(const StripScene& scene, StripState& state);
  /// Returns where factors of a solve belong: the state, unless they take megabytes.
  StripFactors& factors(StripState& state) {
    constexpr int most_nodes = 160;
    return state.layout.nodes <= most_nodes ? state.factors : large_;
  }
  bool press_by_kept(const StripScene& scene, StripState& state, int n);
  void slip_rows(const StripScene& scene, const StripState& state, bool rates);
  void rigid_slip(const StripScene& scene, const StripState& state);
  void bounds(const StripScene& scene, const StripState& state);
  void slip(const StripState& state);
  void keep_slip(StripState& state) const;
  void load_errors(const StripScene& scene, const StripState& state);
  double judge(const StripScene& scene, const StripState& state);
  double* spread(const double* u, const double* v, double* to) const;
  void spread_bounds(const StripScene& scene, const StripState& state, const double* u, const double* v,
                     double* pressure, double* geometry) const;
  int reduced_size() const;
  void put_on_bounds(StripState& state) const;
  void friction_rows(const StripScene& scene, const StripState& state, bool complete, double* row, int columns);
  void take(const StripScene& scene, StripState& state, const double* by, double share) const;
  void friction_errors(const StripScene& scene, double* error) const;
  bool is_kept(const StripScene& scene, const StripFactors& factors) const;
  bool friction_step(const StripScene& scene, StripState& state, bool by_kept);
  /// Computes slopes of a total (forces and moment, load, integrals of pressure times x and y) by pressures and
  /// geometry, and by tractions along x (u) and y (v).
  static void total_slopes(const StripState& state, int which, double* slope, double* u, double* v);
  void linearise(const StripScene& scene, const StripState& state);
  void prepare(const StripScene& scene, const StripState& state, bool rates);
  bool factor_all();
  void solve_all(double* right) const;
  void set_fields(const StripState& state);
  void explicit_rates(const StripScene& scene, const StripState& state, const StripParameter& p, double* right);
  StripTotals total_rates(const StripScene& scene, const StripState& state, const StripParameter& p, double* dz);
  StripReport couple(const StripScene& scene, StripState& state, StripReport report);
  void slide(const StripScene& scene, StripState& state, StripStart start, StripReport& report);

  StripIntegrals integrals_;
  Lu<double> lu_, lu_friction_;
  StripFactors large_;
  Samples gap_, friction_, slip_[2], creep_rates_[2];
  std::vector<double> residual_, step_;
  std::vector<double> compliance_[5];  ///< derivatives of slip by tractions: 11, 12, 22; by pressures: 1n, 2n
  std::vector<double> slip_rates_;     ///< derivatives of slip by geometry
  std::vector<double> rigid_, bound_, scale_, slip_now_, form_, total_slope_, matrix_, all_right_;
  std::vector<double> bound_rates_, traction_rates_, all_slopes_, shares_;
  std::vector<Law> laws_;
  StripState beside_;
  int normal_size_ = 0, friction_size_ = 0;  ///< sizes in the system of all equations
  std::array<double, 3> load_error_{};
  double friction_limit_ = 0;
};

}  // namespace rollcon::strips
