#pragma once
/// Solves contacts on strips that fit them, for frames that the library makes and for wheels (docs/theory.md, section
/// 4).

#include <optional>
#include <vector>

#include "contact/results/equivalent_ellipse.hpp"
#include "framing/strip_givens.hpp"
#include "framing/strips/strip_bridge.hpp"
#include "framing/strips/strip_results.hpp"

namespace rollcon {

class StripFrames final : public MovingFrame {
 public:
  /// Solves a solver's scene inside of the box, by Coulomb's law or, where another resists slip, without friction. The
  /// solver's bodies are prepared. patient: many starts are tried. unfit: strips do not fit, or a body ends where the
  /// contact does.
  strips::StripStatus fit(Solver& on, const Rectangle& box, strips::StripCounts counts, bool patient = true);
  /// Returns what fit() found; `by_law` friction is missing from it.
  const strips::StripTotals& totals() const { return totals_; }
  /// Says whether friction is missing from the totals.
  bool by_law() const { return !givens_.coulomb(); }
  /// Says whether pressures of the bodies shift them along the surface.
  bool coupled() const { return givens_.scene().bodies.ck != 0; }
  const strips::StripSolution& solution() const { return solution_; }
  /// Gives the scene of a solver, which fit() was given before, a frame of the strips, and solves on it from what was
  /// found. seconds: time that finding it took. Errors are those of Solver::solve().
  Status show(Solver& on, double seconds);
  double seconds() const { return seconds_; }  ///< time that the last fit took
  bool rates(Parameter parameter, Rates& found) override;
  /// Returns rates where all that is given changes from one scene to another nearby, at places that keep their
  /// coordinates in the axes. err_singular.
  Rates rates(const StripGivens& before, const StripGivens& behind, double distance);
  /// Holds the area in contact, the greatest overlap of the undeformed bodies, and the integral of |tangential
  /// traction|.
  struct Sizes {
    double area = 0, overlap = 0, carried = 0;
  };
  Sizes sizes() const;
  double largest_pressure() const { return strips::largest_pressure(peaked()).pressure; }
  /// Returns the angle of the contact's normals against n of the axes: the root of the mean square of its tangent, by
  /// pressures.
  double inclination() const;
  /// Returns the Hertzian contact that stands for what was found, without friction. Errors: those of
  /// rollcon::equivalent_ellipse().
  EquivalentEllipse equivalent_ellipse(const PairOfBodies& pair);
  /// Returns the power that friction takes, which is what forces, moment and given slip put in where tractions carried
  /// along change no energy: between bodies whose tractions do not couple. Nothing: they do.
  std::optional<double> friction_power() const;
  /// Returns the speed at which both bodies run through the contact.
  double speed() const { return givens_.speed(); }
  void forget() { warm_ = false; }
  /// Solves what fit() solved with another value of a parameter nearby; shift_back() returns to what was there. Returns
  /// false, and shifts nothing, where the parameter is not known or strips do not fit.
  bool shift(Parameter parameter, double step);
  void shift_back();
  /// Goes back to a copy of solution(), found for the scene that the solver has again.
  void return_to(const strips::StripSolution& solution, Solver& on, const Rectangle& box);

 private:
  bool within_bodies() const;
  /// Returns the strips, or where they do not fit a neighbour without a neck.
  const strips::StripState& peaked() const { return solution_.share > 0 ? solution_.strips : solution_.neighbour[1]; }
  Rates rates(const strips::StripParameter& by);
  std::optional<strips::StripParameter> parameter_of(Parameter parameter) const;

  StripGivens givens_;
  strips::StripContact contact_;
  strips::StripSolution solution_;
  strips::StripTotals totals_;
  strips::StripSolution solution_before_;  ///< what shift_back() returns to
  strips::StripParameter shifted_;
  Rectangle box_{};
  strips::StripState shown_;  ///< what show() solved
  std::vector<LoadedPlace> place_;
  bool warm_ = false;
  double seconds_ = 0;
};

/// Returns force and moment about the origin, in the axes, and motions.
Rates rates_of(const strips::StripTotals& totals);

}  // namespace rollcon
