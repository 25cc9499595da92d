#pragma once
/// Creep-force tables: forces and spin moment of Hertzian steady rolling of bodies with equal elastic constants, from
/// splines through solved cases (docs/tables.md).

#include <cstdint>
#include <string>
#include <vector>

namespace rollcon {

/// How fine a table is. Coordinates: logarithm of the ratio of semi-axes; magnitude s = r / (r + 3) of the creepages,
/// r being the force over mu Fn of linear theory, nearly; angle from pure spin (0) to no spin; direction of the
/// translational creepage.
struct TableGrid {
  std::int64_t ratios = 12, magnitudes = 18, angles = 16;  ///< intervals
  std::int64_t directions = 16;                            ///< even: samples of half a turn, harmonics + 1
  double least_ratio = 1.0 / 25, greatest_ratio = 25;
  /// Of the coarser of two frames of strips under a circle (frame_of).
  std::int64_t along = 12, across = 10;
  std::vector<double> poisson{0.28, 0.3};  ///< ascending
  /// Creepages count as C11 stretch, C22 / stretch, and C22 spin_scale sqrt(a b) of spin; this is the logarithm of
  /// stretch over that of the ratio. Under long ellipses forces turn where the pole of sliding moves by the shorter
  /// semi-axis: directions are spread there.
  double stretched = 0.15;

  double stretch(double log_ratio) const;
  double spin_scale(double log_ratio) const;
};

/// What a table is asked, in one consistent set of units.
struct TableInput {
  double shear, poisson, friction, a, b, load;
  double longitudinal, lateral, spin;  ///< creepages, spin in 1/length
};
constexpr std::size_t table_inputs = 9;

class CreepTable {
 public:
  explicit CreepTable(TableGrid grid);

  const TableGrid& grid() const { return grid_; }
  /// Forces along t1 and t2 and moment about n, on body 1. derivative: [3][9] by the inputs in their order, or null.
  /// Throws err_argument, err_nonfinite with `entry` in the text. Allocates nothing.
  void evaluate(const TableInput& input, std::int64_t entry, double* result, double* derivative) const;

  /// Splines through samples (table_samples.hpp).
  static CreepTable fit(const TableGrid& grid, const std::vector<double>& sample);
  void save(const std::string& path) const;
  static CreepTable load(const std::string& path);

  /// Numbers of one sum over harmonics: of both forces and the moment.
  std::int64_t row() const { return 3 * grid_.directions; }

 private:
  struct Point;
  struct Sums;
  void check(const TableInput& input, std::int64_t entry) const;
  /// Adds the share of one Poisson's ratio to the point's results. rates: with derivatives.
  template <bool rates>
  void add_plane(std::size_t plane, double share, const TableInput& input, Point& point) const;
  template <bool rates>
  Point at_poisson(const TableInput& input) const;
  /// At rest: linear theory.
  void add_rates_at_rest(double share, Point& point) const;
  void add_rates(double share, const Sums& q, Point& point) const;

  TableGrid grid_;
  /// By plane of poisson, ratio, magnitude and angle; then harmonics of Fx, Fy and Mz.
  std::vector<float> coefficient_;
  /// By plane and ratio: logarithms of C11, C22; C23 and C33 over the scale of spin, C32 / C22.
  std::vector<double> linear_;

  friend class TableFit;
};

constexpr std::size_t linear_numbers = 5;

/// Magnitude s of creepages.
constexpr double half_magnitude = 3;  ///< r of s = 1/2
/// Forces are bent so that they end at mu Fn; `unbend` is the inverse. Both change what is within 0.2 % of it alone.
double bend(double force, double* slope);
double unbend(double force);

}  // namespace rollcon
