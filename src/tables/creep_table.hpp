#pragma once
/// Provides creep-force tables: forces and spin moment of Hertzian steady rolling, from splines through solved cases
/// (docs/tables.md).

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tables/table_grid.hpp"

namespace rollcon {

/// Holds what a table is asked, in one consistent set of units.
struct TableInput {
  double shear, poisson, friction, a, b, load;
  double longitudinal, lateral, spin;  ///< creepages, spin in 1/length
};
constexpr std::size_t table_inputs = 9;

class SectionReader;
class SectionWriter;

class CreepTable {
 public:
  explicit CreepTable(TableGrid grid);

  const TableGrid& grid() const { return grid_; }
  /// Finds forces along t1 and t2 and moment about n, on body 1. derivative: [3][9] by the inputs in their order, or
  /// null. Throws err_argument, err_nonfinite with `entry` in the text. Allocates nothing.
  void evaluate(const TableInput& input, std::int64_t entry, double* result, double* derivative) const;

  /// Puts splines through samples (table_samples.hpp).
  static CreepTable fit(const TableGrid& grid, const std::vector<double>& sample);
  /// Write a table and read it; more: writes or reads further sections.
  void save(const std::string& path, const std::function<void(SectionWriter&)>& more = {}) const;
  static CreepTable load(const std::string& path, const std::function<void(SectionReader&)>& more = {});

 private:
  struct Point;
  struct Sums;
  void check(const TableInput& input, std::int64_t entry) const;
  /// Adds one plane, times its weight, to the point's results, and leaves its own in `own`. rates: with derivatives.
  template <bool rates>
  void add_plane(std::size_t plane, double share, const TableInput& input, Point& point) const;
  template <bool rates>
  Point between_planes(const TableInput& input) const;
  void find_linear_theory(std::size_t plane, const TableInput& input, double log_ratio, Point& point) const;
  template <bool rates>
  void sum_harmonics(std::size_t plane, Point& point, Sums& sums) const;
  void add_rates_at_rest(double share, Point& point) const;
  void add_rates(double share, const Sums& q, Point& point) const;

  TableGrid grid_;
  std::vector<double> log_friction_;  ///< logarithms of friction at the planes of unlike bodies
  /// Coefficients by plane, ratio, magnitude and angle; then for Fx, Fy and Mz by parity the harmonics.
  std::vector<float> coefficient_;
  /// Numbers of linear theory by plane and ratio: LinearNumber.
  std::vector<double> linear_;

  friend class TableFit;
};

/// Lists what linear theory says, by plane and ratio; the last three for unlike bodies alone. Cij are derivatives at
/// rest over G a b, lengths over sqrt(a b), `of` being those of like bodies, which scale the creepages.
enum LinearNumber : std::size_t {
  log_c11_of,
  log_c22_of,
  c23_by_spin,  ///< over the C22 of like bodies and the scale of spin
  c33_by_spin,
  c32_by_c22,
  c11_by_of,
  c22_by_of,
  force_at_rest,  ///< Fx over mu Fn
  most_linear_numbers
};
constexpr std::size_t like_linear_numbers = c11_by_of;
inline std::size_t linear_numbers(const TableGrid& grid) {
  return grid.unlike() ? most_linear_numbers : like_linear_numbers;
}

constexpr double half_magnitude = 3;  ///< r at which the magnitude s of creepages is 1/2
/// Bends forces so that they end at mu Fn; `unbend` is the inverse. Both change what is within 0.2 % of it alone.
double bend(double force, double* slope);
double unbend(double force);

}  // namespace rollcon
