/// Stands in for UMFPACK in a build without it.

#include "linalg/sparse_lu.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

[[noreturn]] void refuse() {
  fail(Status::err_unsupported, "this build of rollcon has no UMFPACK (ROLLCON_WITH_UMFPACK is OFF)");
}

}  // namespace

struct SparseLu::Factors {};
SparseLu::SparseLu() = default;
SparseLu::~SparseLu() = default;
SparseLu::SparseLu(SparseLu&&) noexcept = default;
SparseLu& SparseLu::operator=(SparseLu&&) noexcept = default;

bool SparseLu::available() {
  return false;
}

bool SparseLu::factored() const {
  return false;
}

bool SparseLu::factor(const SparseMatrix& /*matrix*/) {
  refuse();
}

void SparseLu::solve(double* /*b*/) {
  refuse();
}

void SparseLu::release(bool /*all*/) {}

}  // namespace rollcon
