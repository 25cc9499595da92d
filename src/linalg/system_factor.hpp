#pragma once
/// Declares what a factorised system of equations answers, whatever holds its factors.

#include <cstddef>
#include <cstdint>

namespace rollcon {

class SystemFactor {
 public:
  virtual ~SystemFactor() = default;
  virtual std::int64_t size() const = 0;
  /// Overwrites `count` right sides of length size(), which lie one after the other, with their solutions.
  virtual void solve(double* b, std::int64_t count) const = 0;
  /// Solve in two steps. The second finds at least the unknowns from `first` on; those before them are then undefined.
  /// Sums of right sides may be taken between the steps.
  virtual void eliminate(double* b, std::int64_t count) const = 0;
  virtual void substitute(double* b, std::int64_t count, std::int64_t first) const = 0;
  /// Returns an estimate of ||A|| ||A^-1|| in Frobenius norms.
  virtual double condition() const = 0;
  virtual std::size_t bytes() const = 0;
};

}  // namespace rollcon
