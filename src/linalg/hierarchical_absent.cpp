/// Stands in for hierarchical factors in a build without hmat-oss.

#include "linalg/hierarchical_factor.hpp"
#include "support/error.hpp"

namespace rollcon {

bool has_hierarchical_factor() {
  return false;
}

double hierarchical_bytes(std::int64_t /*unknowns*/, double /*accuracy*/) {
  return 0;
}

std::unique_ptr<SystemFactor> factor_hierarchically(const BlockMatrix& /*matrix*/, std::span<const Pivot> /*pivots*/,
                                                    double /*accuracy*/) {
  fail(Status::err_unsupported,
       "body option factor: 2 needs hierarchical factors, which this library was built without (ROLLCON_WITH_HMAT); "
       "allowed: 0, 1");
}

void write_hierarchical(const SystemFactor& /*factor*/,
                        const std::function<void(const void*, std::size_t)>& /*write*/) {}

std::unique_ptr<SystemFactor> read_hierarchical(std::span<const Pivot> /*pivots*/, double /*condition*/,
                                                const std::function<void(void*, std::size_t)>& /*read*/) {
  fail(Status::err_unsupported,
       "the body has hierarchical factors, which this library was built without (ROLLCON_WITH_HMAT)");
}

}  // namespace rollcon
