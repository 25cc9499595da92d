#pragma once
/// Solved cases that a table goes through.
///
/// For each Poisson's ratio and ratio of semi-axes: C11, C22, C23, C32, C33; then chains of magnitudes 1 .. magnitudes
/// - 1 with Fx, Fy and Mz over mu Fn: one chain of pure spin, then for angles 1 .. angles each direction. NaN: not yet
/// solved.

#include <cstdint>
#include <vector>

#include "tables/creep_table.hpp"

namespace rollcon {

struct SampleLayout {
  explicit SampleLayout(const TableGrid& grid);
  std::int64_t planes, chains, chain;  ///< planes: of Poisson's ratio and ratio; numbers of a chain
  std::int64_t plane() const { return static_cast<std::int64_t>(linear_numbers) + chains * chain; }
  std::int64_t size() const { return planes * plane(); }
};

double log_ratio_of(const TableGrid& grid, std::int64_t ratio);
double angle_of(const TableGrid& grid, std::int64_t angle);
double magnitude_of(const TableGrid& grid, std::int64_t magnitude);
double direction_of(const TableGrid& grid, std::int64_t direction);

/// Solves part `part` of `parts` of the samples that are not there yet, over threads. May throw Cancelled: what was
/// solved stays.
void solve_samples(const TableGrid& grid, std::int64_t part, std::int64_t parts, int threads,
                   std::vector<double>& sample);

/// The coarser frame under an ellipse of this ratio. Long ones want more cells along their length than across it: where
/// the pole of sliding lies on it, forces depend on how many cells lie between the pole and the ends.
struct StripsSize {
  std::int64_t along, across;
};
StripsSize frame_of(const TableGrid& grid, double ratio);

/// Forces and moment over mu Fn, lengths over sqrt(a b), of bodies that slide and spin as rigid ones.
void sliding_limit(double ratio, const double (&creepage)[3], double* force);

}  // namespace rollcon
