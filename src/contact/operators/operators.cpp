#include "contact/operators/operators.hpp"

#include <algorithm>
#include <cmath>

#include "support/memory_limit.hpp"

namespace rollcon {
namespace {

// Derivatives along the surface instead of along its projection.
void follow_surface(const Frame& frame, ContactOperators& op) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  op.upstream_path.resize(op.upstream.size());
  for (std::size_t i = 0; i < n; ++i) {
    const double cosine = dot(frame.t1[i], frame.axes.t1);
    if (!op.upstream.empty()) {
      op.upstream_path[i] = op.upstream[i] / cosine;
      continue;
    }
    for (auto k = static_cast<std::size_t>(op.convection.start[i]);
         k < static_cast<std::size_t>(op.convection.start[i + 1]); ++k)
      op.convection.value[k] *= cosine;
  }
}

}  // namespace

double ContactOperators::product(int r, std::size_t k, const std::vector<double> (&lambda)[3],
                                 int first, int last) const {
  double sum = 0;
  for (int c = first; c <= last; ++c)
    if (!block[r][c].empty())
      sum += dot(block[r][c].row(static_cast<std::int64_t>(k)), lambda[c].data(), nodes);
  return sum;
}

std::size_t ContactOperators::bytes() const {
  std::size_t sum = 0;
  for (const auto& row : block)
    for (const auto& matrix : row)
      if (!matrix.empty() && !matrix.shared())
        sum += static_cast<std::size_t>(rows * matrix.columns()) * sizeof(double);
  if (field) sum += field->bytes();
  return sum + convection.value.capacity() * (sizeof(double) + sizeof(std::int32_t));
}

void require_operator_memory(const ContactOperators& op, const bool (&block)[3][3],
                             std::int64_t rows) {
  double allocated = 0, written = 0;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      if (block[r][c] && op.block[r][c].empty()) allocated += 1;
      if (block[r][c] || !(op.block[r][c].empty() || op.block[r][c].shared())) written += 1;
    }
  const double row_bytes = 8.0 * static_cast<double>(op.nodes);
  require_memory({allocated * static_cast<double>(op.nodes) * row_bytes,
                  written * static_cast<double>(rows) * row_bytes},
                 "take a coarser or smaller frame; on a regular one above half-spaces, option "
                 "'operators' = 'fft' needs no matrices",
                 "the operators of a frame of %lld nodes need", static_cast<long long>(op.nodes));
}

void prepare_convection(const Frame& frame, Scheme scheme, double step, ContactOperators& op) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  op.slip_x = frame.x;
  op.slip_y = frame.y;
  op.upstream.clear();
  op.upstream_path.clear();
  op.convection = SparseRows{};
  switch (scheme) {
    case Scheme::godunov:
      op.convection = godunov(frame, 1, 0);
      break;
    case Scheme::least_squares:
      op.convection = least_squares(frame, 1, 0);
      break;
    case Scheme::characteristic:
      op.upstream = characteristic_steps(frame, step);
      for (std::size_t i = 0; i < n; ++i)
        op.slip_x[i] += op.upstream[i] / 2;  // second order: the difference is centred there
  }
  if (frame.curved()) follow_surface(frame, op);
}

void convect(const ContactOperators& op, const double* w, const double* ahead,
             std::vector<double> (&slip)[2]) {
  const std::size_t n = op.slip_x.size();
  for (auto& v : slip) v.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t c = 0; c < 2; ++c) {
      if (!op.upstream.empty()) {
        if (op.upstream[k] > 0) slip[c][k] = (w[3 * k + c] - ahead[3 * k + c]) / op.path(k);
        continue;
      }
      for (auto j = static_cast<std::size_t>(op.convection.start[k]);
           j < static_cast<std::size_t>(op.convection.start[k + 1]); ++j)
        slip[c][k] +=
            op.convection.value[j] * w[3 * static_cast<std::size_t>(op.convection.column[j]) + c];
    }
}

}  // namespace rollcon
