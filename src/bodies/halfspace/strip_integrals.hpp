#pragma once
/// Computes displacements of half-spaces under tractions on strips, and their exact derivatives by the strips'
/// geometry.

#include <vector>

#include "bodies/halfspace/strip_kernels.hpp"
#include "mesh/strip_layout.hpp"

namespace rollcon::strips {

/// Holds the compliances of two half-spaces (docs/theory.md, section 3), length^2 over force.
struct StripBodies {
  double cn = 0, cv = 0, ck = 0;
};

enum class Displacement { normal, slip };  ///< kinds as StripKernels orders them

/// Points to what observe() found: values of each kind at all places of sources.
struct Observation {
  const double* values = nullptr;
  int stride = 0;  ///< step from one kind to the next
};

class StripIntegrals {
 public:
  /// Puts sources at a geometry, all of whose half lengths are > 0. The layout must outlive the use.
  void lay(const StripLayout& layout, const StripBodies& bodies, const double* geometry);
  /// Makes tractions at the nodes inside the field that integrals multiply: 0 pressure, 1 along x, 2 along y.
  void set_field(int field, const double* traction);
  /// Computes integrals for an observer, with or without rates, kept until the next call with the same slot (0 or 1).
  Observation observe(Displacement what, bool rates, const StripPoint& at, int slot) {
    return observe(what, rates, layout_->x(at, geometry_), layout_->y(at, geometry_), slot);
  }
  Observation observe(Displacement what, bool rates, double x, double y, int slot);
  int kinds(Displacement what) const { return (what == Displacement::slip ? 3 : 1) + (coupled() ? 2 : 0); }
  bool coupled() const { return bodies_.ck != 0; }

  /// Adds factor times the displacement by a unit traction of each node to row[node].
  void add_row(const Observation& from, int kind, double factor, double* row) const;
  /// Returns the displacement by a field, with the strips held.
  double displacement(const Observation& from, int kind, int field) const;
  /// Returns the displacement, too, and adds factor times its derivatives by the geometry to rates; `from` must have
  /// been observed with rates.
  double add_rates(const Observation& from, int kind, int field, const StripPoint& at, double factor,
                   double* rates) const;

 private:
  const StripLayout* layout_ = nullptr;
  StripBodies bodies_;
  const double* geometry_ = nullptr;
  std::vector<double> place_, foot_, scale_, field_[3], values_[2];
};

}  // namespace rollcon::strips
