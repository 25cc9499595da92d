#pragma once
/// Single-precision factors of an earlier dense system as a preconditioner of a later one, whose
/// unknowns may be others: both carry keys. Unknowns that the factors do not know are left alone.

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "linalg/gmres.hpp"
#include "linalg/lu.hpp"

namespace rollcon {

class KeptLu final : public LinearOperator {
 public:
  /// False when the matrix (row-major, as many rows as keys) is singular to single precision.
  bool factor(std::span<const std::int64_t> key, const double* matrix);
  /// Says what the next vectors are made of.
  void match(std::span<const std::int64_t> key);
  void apply(const double* x, double* y) override;
  bool valid() const { return valid_; }
  void forget() { valid_ = false; }
  std::size_t bytes() const { return lu_.bytes(); }

 private:
  Lu<float> lu_;
  bool valid_ = false;
  std::unordered_map<std::int64_t, std::int64_t> place_;
  std::vector<std::int64_t> index_;
  std::vector<float> work_;
};

}  // namespace rollcon
