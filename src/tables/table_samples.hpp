#pragma once
/// Lays out solved cases that a table goes through.
///
/// For each plane (TableGrid::planes) and ratio of semi-axes: numbers of linear theory (SampledNumber); then chains of
/// magnitudes 1 .. magnitudes - 1 (unlike bodies: to magnitudes, where all slides) with Fx, Fy and Mz over mu Fn: one
/// chain of pure spin, then for angles 1 .. angles each direction. NaN: not yet solved.

#include <array>
#include <cstdint>
#include <vector>

#include "support/context.hpp"
#include "tables/creep_table.hpp"

namespace rollcon {

/// Lists derivatives at rest over G a b, lengths over sqrt(a b); the last three for unlike bodies alone: C11 and C22
/// then are those of like ones.
enum SampledNumber : std::size_t {
  sampled_c11,
  sampled_c22,
  sampled_c23,
  sampled_c32,
  sampled_c33,
  sampled_own_c11,
  sampled_own_c22,
  sampled_at_rest
};

struct SampleLayout {
  explicit SampleLayout(const TableGrid& grid);
  std::int64_t planes, chains, chain;  ///< planes of all ratios; chains of a plane; numbers of a chain
  std::int64_t numbers;                ///< numbers of linear theory
  std::int64_t plane() const { return numbers + chains * chain; }
  std::int64_t size() const { return planes * plane(); }
};

double log_ratio_of(const TableGrid& grid, std::int64_t ratio);  ///< coordinates of nodes by number
double angle_of(const TableGrid& grid, std::int64_t angle);
double magnitude_of(const TableGrid& grid, std::int64_t magnitude);
double direction_of(const TableGrid& grid, std::int64_t direction);

/// Returns creepages over mu Fn / (G a b) of magnitude r = 1; linear: SampledNumber.
std::array<double, 3> unit_creepages(const TableGrid& grid, double log_ratio, double angle, double direction,
                                     const double* linear);

/// Solves part `part` of `parts` of the samples that are not there yet, over ranks and threads. May throw Cancelled:
/// what was solved stays.
void solve_samples(const TableGrid& grid, std::int64_t part, std::int64_t parts, const Context& context,
                   std::vector<double>& sample);

/// Returns the coarser frame under an ellipse of this ratio. Long ones want more cells along their length than across
/// it: where the pole of sliding lies on it, forces depend on how many cells lie between the pole and the ends.
struct StripsSize {
  std::int64_t along, across;
};
StripsSize frame_of(const TableGrid& grid, double ratio);

/// Finds forces and moment over mu Fn, lengths over sqrt(a b), of bodies that slide and spin as rigid ones.
void sliding_limit(double ratio, const std::array<double, 3>& creepage, double* force);

}  // namespace rollcon
