#include "contact/operators/operators.hpp"

#include <algorithm>
#include <cmath>

#include "support/memory_limit.hpp"

namespace rollcon {

double ContactOperators::product(int r, std::size_t k, const std::vector<double> (&lambda)[3], int first,
                                 int last) const {
  double sum = 0;
  for (int c = first; c <= last; ++c)
    if (!block[r][c].empty()) sum += dot(block[r][c].row(static_cast<std::int64_t>(k)), lambda[c].data(), nodes);
  return sum;
}

std::size_t ContactOperators::bytes() const {
  std::size_t sum = 0;
  for (const auto& row : block)
    for (const auto& matrix : row)
      if (!matrix.empty()) sum += static_cast<std::size_t>(matrix.rows() * matrix.columns()) * sizeof(double);
  return sum + (field ? field->bytes() : 0);
}

void require_operator_memory(const ContactOperators& op, const bool (&block)[3][3]) {
  double allocated = 0, written = 0;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      if (block[r][c] && op.block[r][c].empty()) allocated += 1;
      if (block[r][c] || !op.block[r][c].empty()) written += 1;
    }
  const double bytes = 8.0 * static_cast<double>(op.nodes) * static_cast<double>(op.nodes);
  require_memory({allocated * bytes, written * bytes},
                 "take a coarser or smaller frame; on a regular one above half-spaces, option "
                 "'operators' = 'fft' needs no matrices",
                 "the operators of a frame of %lld nodes need", static_cast<long long>(op.nodes));
}

}  // namespace rollcon
