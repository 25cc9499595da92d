#include "procedures/step_factors.hpp"

#include "support/error.hpp"

namespace rollcon {
namespace {

/// A matrix may be as large without UMFPACK as LAPACK takes in bearable time (half a minute on two cores).
constexpr std::int64_t largest_dense = 12000;

bool prefers_dense(const ContactEquations& equations) {
  double dense = 0;
  for (const BodiesEquations::Body& body : equations.bodies().bodies())
    dense += static_cast<double>(body.equations->dense.size());
  const auto n = static_cast<double>(equations.size());
  const auto own = static_cast<double>(equations.contact_size());
  if (equations.couples_pairs()) dense += own * own;
  return dense > 0.4 * n * n;
}

}  // namespace

bool StepFactors::factor(const ContactEquations& equations) {
  const std::int64_t n = equations.size();
  is_dense_ = prefers_dense(equations);
  if (!is_dense_ && !SparseLu::available()) {
    if (n > largest_dense)
      fail(Status::err_unsupported,
           "option 'system' is 'monolithic': a sparse system of %lld unknowns needs UMFPACK, which "
           "this build of rollcon does not have (ROLLCON_WITH_UMFPACK is OFF; without it at most "
           "%lld)",
           static_cast<long long>(n), static_cast<long long>(largest_dense));
    is_dense_ = true;
  }
  if (is_dense_) {
    equations.assemble(dense_.prepare(n));
    return dense_.factor();
  }
  equations.assemble(entries_);
  return sparse_.factor(entries_);
}

void StepFactors::solve(double* b) {
  if (is_dense_)
    dense_.solve(b, 1);
  else
    sparse_.solve(b);
}

}  // namespace rollcon
