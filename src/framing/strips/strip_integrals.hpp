#pragma once
/// Displacements of half-spaces under tractions on strips, and their exact derivatives by the strips' geometry.

#include <vector>

#include "framing/strips/strip_kernels.hpp"
#include "framing/strips/strip_layout.hpp"

namespace rollcon::strips {

/// Compliances of two half-spaces (docs/theory.md, section 3), length^2 over force.
struct StripBodies {
  double cn = 0, cv = 0, ck = 0;
};

enum class Displacement { normal, slip };  ///< kinds as StripKernels orders them

/// Where an observer was put: values of each kind at all places of sources.
struct Observation {
  const double* values = nullptr;
  int stride = 0;  ///< from one kind to the next
};

class StripIntegrals {
 public:
  /// Puts sources at a geometry, all of whose half lengths are > 0. The layout outlives the use.
  void lay(const StripLayout& layout, const StripBodies& bodies, const double* geometry);
  /// Tractions at the nodes inside become what integrals multiply. Field 0: pressure, 1 and 2: along x and y.
  void set_field(int field, const double* traction);
  /// Integrals for an observer, with their rates or without; kept until the next call with the same slot (0 or 1).
  Observation observe(Displacement what, bool rates, const StripPoint& at, int slot);
  int kinds(Displacement what) const { return (what == Displacement::slip ? 3 : 1) + (coupled() ? 2 : 0); }
  bool coupled() const { return bodies_.ck != 0; }

  /// row[node] += factor times the displacement by a unit traction of the node.
  void add_row(const Observation& from, int kind, double factor, double* row) const;
  /// The displacement by a field, with the strips held.
  double displacement(const Observation& from, int kind, int field) const;
  /// The same; rates += factor times its derivatives by the geometry. `from` was observed with rates.
  double add_rates(const Observation& from, int kind, int field, const StripPoint& at, double factor,
                   double* rates) const;

 private:
  const StripLayout* layout_ = nullptr;
  StripBodies bodies_;
  const double* geometry_ = nullptr;
  std::vector<double> place_, foot_, scale_, field_[3], values_[2];
};

}  // namespace rollcon::strips
