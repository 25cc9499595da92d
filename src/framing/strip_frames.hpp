#pragma once
/// Solves contacts on strips that fit them, for automatic frames and for wheels (docs/theory.md, section 4).

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "contact/results/equivalent_ellipse.hpp"
#include "framing/strip_givens.hpp"
#include "framing/strips/strip_adhesion.hpp"
#include "framing/strips/strip_bridge.hpp"
#include "framing/strips/strip_results.hpp"

namespace rollcon {

class StripFrames final : public MovingFrame {
 public:
  /// Solves a solver's scene inside of the box, with Coulomb's law, or without friction where another law resists slip.
  /// The solver's bodies must be prepared. patient: tries many starts. Returns unfit if strips do not fit, or if a body
  /// ends where the contact does.
  strips::StripStatus fit(Solver& on, const Rectangle& box, strips::StripCounts counts, bool patient = true);
  /// Returns the totals that fit() found, without friction where by_law() is true.
  const strips::StripTotals& totals() const { return totals_; }
  /// Says whether friction is missing from the totals.
  bool by_law() const { return !givens_.coulomb(); }
  /// Says whether pressures displace the bodies along the surface.
  bool coupled() const { return givens_.scene().bodies.ck != 0; }
  const strips::StripSolution& solution() const { return solution_; }
  /// Gives the scene of a solver, which fit() solved before, a frame of the strips, and solves on this frame from the
  /// solution of fit(). seconds: time that fit() took. onward: under another law than Coulomb's the solve continues the
  /// solver's last solution, where that was on strips of the same counts; else it starts from nothing. Errors are those
  /// of Solver::solve().
  Status show(Solver& on, double seconds, bool onward = false);
  /// Gives the scene a frame of the strips.
  void put_frame(Scene& scene) const;
  double seconds() const { return seconds_; }  ///< time that the last fit took
  bool rates(Parameter parameter, Rates& found) override;
  /// Returns rates of change from one scene to another nearby, `distance` apart, at places that keep their coordinates
  /// in the axes. Throws err_singular.
  Rates rates(const StripGivens& before, const StripGivens& behind, double distance);
  /// Holds the area in contact, the greatest overlap of the undeformed bodies, and the integral of |tangential
  /// traction|.
  struct Sizes {
    double area = 0, overlap = 0, carried = 0;
    double radius() const { return std::sqrt(area / std::numbers::pi); }  ///< radius of a disc of that area
  };
  Sizes sizes() const;
  double largest_pressure() const { return strips::largest_pressure(peaked()).pressure; }
  std::array<double, 3> lacking_at_poles() const { return strips::lacking_at_poles(peaked()); }
  /// Holds angles, weighted by pressures: that of the mean normal to n of the axes, and the root mean square by which
  /// normals turn away from the mean.
  struct Inclination {
    double mean = 0, turned = 0;
  };
  Inclination inclination() const;
  /// Returns the Hertzian contact that is equivalent to the solution without friction. Errors are those of
  /// rollcon::equivalent_ellipse().
  EquivalentEllipse equivalent_ellipse(const PairOfBodies& pair);
  /// Finds the forces of linear theory about the origin of the axes; the slip is the scene's own, by heights.
  bool adhesion(strips::Adhesion& found) { return strips::adhere(contact_, givens_.scene(), solution_, found); }
  bool creep_rates(strips::Adhesion& found) { return strips::creep_rates(contact_, givens_.scene(), solution_, found); }
  const strips::StripScene& scene() const { return givens_.scene(); }
  /// Returns the power of friction, which is the power that forces, moment and given slip put in if tractions carried
  /// along change no energy. This holds between bodies that pressures do not couple; returns nothing for others.
  std::optional<double> friction_power() const;
  /// Returns the rolling speed, at which both bodies run through the contact.
  double speed() const { return givens_.speed(); }
  /// Says whether the last fit missed peaks of pressure where curvatures jump.
  bool missed_corners() const { return contact_.missed_corners(); }
  void forget() { warm_ = false; }
  /// Solves the scene of fit() again with a parameter changed by a step; shift_back() returns to the solution before.
  /// Returns false, and changes nothing, if the parameter is not known or strips do not fit.
  bool shift(Parameter parameter, double step);
  void shift_back();
  /// Returns to a copy of solution() that was found for the solver's present scene.
  void return_to(const strips::StripSolution& solution, Solver& on, const Rectangle& box);

 private:
  bool within_bodies() const;
  /// Returns the strips or, where they do not fit, a neighbour without a neck.
  const strips::StripState& peaked() const { return solution_.share > 0 ? solution_.strips : solution_.neighbour[2]; }
  Rates rates(const strips::StripParameter& by);
  std::optional<strips::StripParameter> parameter_of(Parameter parameter) const;

  StripGivens givens_;
  strips::StripContact contact_;
  strips::StripSolution solution_;
  strips::StripTotals totals_;
  strips::StripSolution solution_before_;  ///< solution that shift_back() returns to
  strips::StripParameter shifted_;
  Rectangle box_{};
  std::array<std::vector<double>, 2> before_;  ///< tangential tractions that show() continues
  strips::StripState shown_;                   ///< strips that show() solved
  std::vector<LoadedPlace> place_;
  bool warm_ = false;
  double seconds_ = 0;
};

/// Returns the force, the moment about the origin, both in the axes, and the motions.
Rates rates_of(const strips::StripTotals& totals);

}  // namespace rollcon
