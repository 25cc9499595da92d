#pragma once
/// Defines laws of wear.

#include <span>
#include <vector>

namespace rollcon {

/// Gives the depth worn off per length rolled, at a point.
class WearLaw {
 public:
  /// Makes a law: "archard" takes i, or i1, i2 and the angle of their axes from t1; "t_gamma" pairs of energy and rate.
  /// err_option: unknown name; err_argument, err_nonfinite.
  WearLaw(const char* name, std::span<const double> parameters);
  /// Returns the depth; slip is over the rolling speed, traction that of friction.
  double rate(double pressure, const double (&traction)[2], const double (&slip)[2]) const;

 private:
  enum class Kind { archard, t_gamma };
  Kind kind_;
  std::vector<double> value_;
  double cosine_ = 1, sine_ = 0;
};

}  // namespace rollcon
