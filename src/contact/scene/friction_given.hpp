#pragma once
/// Holds what resists slip between two bodies, as a caller gave it: the law, its memory, a layer, and heat.

#include <cstdint>
#include <memory>
#include <vector>

#include "contact/heat/flash_temperature.hpp"
#include "contact/laws/friction_law.hpp"

namespace rollcon {

/// A value that setters check on the way in: they throw Error and then leave it as it was, and return whether they
/// changed something. Messages count parameters from index_base.
class FrictionGiven {
 public:
  /// Sets one of law_names().
  bool set_law(const char* law, std::int32_t n, const double* parameters, std::int32_t index_base = 0);
  /// Sets the memory of laws that fall, whichever is set; a length of 0: none.
  bool set_memory(double length, double least_speed);
  /// Sets a layer between the bodies: its tangential displacement per traction; it flows under a traction of stress +
  /// hardening times the flow, with a stress of 0 never.
  bool set_layer(double flexibility, double stress, double hardening);
  /// Sets the thermal properties of body `which` (1 or 2) and its temperature.
  bool set_heat(std::int32_t which, double conductivity, double capacity, double temperature);
  /// Replaces the law's coefficient, which is the greatest that it reaches.
  bool set_coefficient(double mu);
  /// Takes the coefficients of another one, which has Coulomb's law, times a factor.
  void scale(const FrictionGiven& of, double factor);

  bool given() const { return name_ != nullptr; }  ///< a law was set
  double mu() const { return mu_; }
  /// Returns null for Coulomb's law.
  const std::shared_ptr<const FrictionLaw>& law() const { return law_in_use_; }
  double layer() const { return layer_; }  ///< flexibility
  const BothHeats& heat() const { return heat_; }
  /// Says whether Coulomb's law between bare bodies is all there is.
  bool coulomb_alone() const { return !law_in_use_ && layer_ == 0; }
  /// Throws err_state or err_unsupported for a memory or a layer that the law does not take. handle: the first words of
  /// the names of the setters.
  void require_consistent(const char* handle) const;

 private:
  void choose_law();

  double mu_ = 0;
  std::shared_ptr<const FrictionLaw> law_, law_in_use_;  ///< law as named, and with what else was set
  FrictionMemory memory_;
  LayerYield yield_;
  double layer_ = 0;
  BothHeats heat_{};
  const LawName* name_ = nullptr;  ///< null: no law was given yet
  std::vector<double> parameters_;
};

}  // namespace rollcon
