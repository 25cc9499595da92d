#pragma once
/// Tells how fine a creep-force table is, for which bodies it is, and its coordinates.

#include <cstdint>
#include <vector>

namespace rollcon {

/// Describes two bodies of unlike elastic constants: forces depend on friction by itself, and change where the rolling
/// direction is turned round.
struct UnlikePair {
  double flexibility[2]{1, 1};   ///< 1 / G over the mean of both; 0: rigid
  double poisson[2]{};           ///< Poisson's ratios; a rigid body's is no matter
  std::vector<double> friction;  ///< ascending, above 0; empty: the bodies are alike

  double mean_poisson() const;  ///< weighted by flexibility
  /// Returns the difference of (1 - 2 nu) / (2 G), body 1 less body 2, times the shear modulus of two equal bodies.
  double strained() const;
};

/// Names the coordinates: logarithm of the ratio of semi-axes; magnitude s = r / (r + 3) of the creepages, r being
/// about the force over mu Fn of linear theory; angle from pure spin (0) to no spin; direction of translational
/// creepage.
struct TableGrid {
  std::int64_t ratios = 12, magnitudes = 18, angles = 16;  ///< intervals
  std::int64_t directions = 16;                            ///< even: harmonics; samples of half a turn
  double least_ratio = 1.0 / 25, greatest_ratio = 25;
  /// Intervals of the coarser of two frames of strips under a circle (frame_of).
  std::int64_t along = 12, across = 10;
  std::vector<double> poisson{0.28, 0.3};  ///< ascending; for unlike bodies the mean alone
  /// Logarithm of `stretch` over that of the ratio: creepages count as C11 stretch, C22 / stretch, and C22 spin_scale
  /// sqrt(a b) of spin. Under long ellipses forces turn where the pole of sliding moves by the shorter semi-axis:
  /// directions are spread there.
  double stretched = 0.15;
  UnlikePair pair{};

  double stretch(double log_ratio) const;  ///< factor on longitudinal creepage
  double spin_scale(double log_ratio) const;

  bool unlike() const { return !pair.friction.empty(); }
  /// Returns where the table has planes of splines: coefficients of friction, or Poisson's ratios of like bodies.
  /// Returns how far beyond two Poisson's ratios of like bodies the table serves: forces are nearly linear in it.
  double beyond() const;
  const std::vector<double>& planes() const { return unlike() ? pair.friction : poisson; }
  /// Returns for each harmonic 1 where mirror images leave a sine or a cosine alone, 2 where they leave both.
  std::int64_t parities() const { return unlike() ? 2 : 1; }
  /// Counts samples of directions, over half a turn or a whole one.
  std::int64_t samples_around() const { return parities() * directions; }
  /// Counts samples of magnitudes: bodies that slide everywhere are an integral where they are alike.
  std::int64_t samples_along() const { return magnitudes - (unlike() ? 0 : 1); }
  /// Counts the numbers of one sum over harmonics: those of both forces and the moment.
  std::int64_t row() const { return 3 * parities() * directions; }
};

/// Says whether harmonic h of component i (Fx, Fy, Mz) is a cosine of the direction, else a sine. Parity 0 is what
/// mirror images across both axes leave; the other one is that of unlike bodies alone.
constexpr bool is_cosine(std::int64_t i, std::int64_t parity, std::int64_t h) {
  return ((i == 0) == (h % 2 != 0)) != (parity == 1);
}

/// Interpolates between planes at x, ascending: linearly between two; else by cubics whose slopes at a plane are those
/// of the parabola through it and its neighbours.
struct PlaneWeights {
  std::int64_t first = 0, count = 1;
  double value[4]{1, 0, 0, 0}, slope[4]{};  ///< slope: derivatives by x
};
PlaneWeights plane_weights(const std::vector<double>& x, double at);

}  // namespace rollcon
