#include "contact/operators/dense_operators.hpp"

#include <algorithm>
#include <cmath>

#include "support/memory_limit.hpp"

namespace rollcon {

double DenseOperators::product(int r, std::size_t k, const std::vector<double> (&lambda)[3], Components columns) const {
  double sum = 0;
  for (int c = columns.first; c <= columns.last; ++c)
    if (!block[r][c].empty()) sum += dot(block[r][c].row(static_cast<std::int64_t>(k)), lambda[c].data(), nodes);
  return sum;
}

void DenseOperators::images(Components wanted, Components columns, std::span<const std::int32_t> at,
                            const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const {
  for (int r = wanted.first; r <= wanted.last; ++r)
    for (const std::int32_t k : at)
      image[r][static_cast<std::size_t>(k)] = product(r, static_cast<std::size_t>(k), lambda, columns);
}

double DenseOperators::slip_norm(int r, std::size_t k) const {
  const auto i = static_cast<std::int64_t>(k);
  return std::hypot(norm2(block[r][0].row(i), nodes), norm2(block[r][1].row(i), nodes));
}

void DenseOperators::release_slip() {
  for (int r = 0; r < 2; ++r)
    for (auto& matrix : block[r]) matrix.release();
  tangential = false;
}

void DenseOperators::release() {
  release_slip();
  for (auto& matrix : block[2]) matrix.release();
  normal = coupled = coupling_vanished = false;
}

std::size_t DenseOperators::bytes() const {
  std::size_t sum = 0;
  for (const auto& row : block)
    for (const auto& matrix : row)
      if (!matrix.empty()) sum += static_cast<std::size_t>(matrix.rows() * matrix.columns()) * sizeof(double);
  return sum;
}

void DenseOperators::require_memory_for(const bool (&wanted)[3][3]) const {
  double allocated = 0, written = 0;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      if (wanted[r][c] && block[r][c].empty()) allocated += 1;
      if (wanted[r][c] || !block[r][c].empty()) written += 1;
    }
  const double bytes = 8.0 * static_cast<double>(nodes) * static_cast<double>(nodes);
  require_memory({allocated * bytes, written * bytes},
                 "take a coarser or smaller frame; on a regular one above half-spaces, option "
                 "'operators' = 'fft' needs no matrices",
                 "the operators of a frame of %lld nodes need", static_cast<long long>(nodes));
}

void DenseOperators::loosen_held_tangents(std::span<const std::uint8_t> used, bool both) {
  if (!tangential) return;
  constexpr double rounding = 1e-12, looseness = 1e-6;
  double largest = 0;
  for (std::size_t k = 0; k < used.size(); ++k)
    if (used[k]) largest = std::max({largest, slip_norm(0, k), slip_norm(1, k)});
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (!used[k]) continue;
    const bool held[2] = {slip_norm(0, k) <= rounding * largest, slip_norm(1, k) <= rounding * largest};
    const auto i = static_cast<std::int64_t>(k);
    for (int r = 0; r < 2; ++r)
      if (held[r] && (both || !held[1 - r])) block[r][r].row(i)[i] = looseness * largest;
  }
}

}  // namespace rollcon
