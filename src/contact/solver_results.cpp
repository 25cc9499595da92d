/// Reads results of the last solve.

#include <numeric>

#include "bodies/body.hpp"
#include "contact/estimate/error_estimate.hpp"
#include "contact/estimate/few_nodes.hpp"
#include "contact/results/doubts.hpp"
#include "contact/results/extrapolation.hpp"
#include "contact/results/outcome_text.hpp"
#include "contact/results/power.hpp"
#include "contact/solver.hpp"
#include "linalg/blas_threads.hpp"
#include "support/index.hpp"

namespace rollcon {

void Solver::require_solution() const {
  if (!solution_.solved || solution_.revision.mesh != scene.revision.mesh)
    fail(Status::err_state,
         "there is no solution: call rollcon_contact_solve first (inputs that "
         "change the frame, or a failed solve, discard the last one)");
}

Loads Solver::loads() const {
  require_solution();
  if (derived_.extrapolated) return {derived_.extrapolated->force, derived_.extrapolated->moment};
  Loads loads;
  sum_tractions(solution_.prepared->problem, solution_.iterate.lambda, loads.force, loads.moment);
  return loads;
}

MotionValues Solver::motions() const {
  require_solution();
  if (derived_.extrapolated) return derived_.extrapolated->motion;
  MotionValues m = solution_.iterate.motion;
  m[approach] = solution_.given.approach_of(m, solution_.prepared->problem.datum);
  return m;
}

void Solver::require_operators() {
  if (!solution_.procedure.monolithic) return;
  if (!preparation_) fail(Status::err_internal, "operators that are shared cannot be assembled");
  try {
    rollcon::require_operators(*preparation_);
  } catch (...) {
    take_changes();
    throw;
  }
  take_changes();
  solution_.images_known = false;
}

void Solver::require_converged() const {
  const Outcome outcome = solution_.report.outcome;
  if (outcome == Outcome::not_converged || outcome == Outcome::cancelled)
    fail(Status::err_state, "the last solve did not converge: only a converged solution has derivatives");
}

const Rates& Solver::own_rates(Parameter parameter) {
  require_operators();
  const Rates& rates = rate_finder_.by(parameter, solution_, engine_.newton, derived_);
  effort_.peak_bytes = std::max(effort_.peak_bytes, bytes());
  return rates;
}

Rates Solver::rates(Parameter parameter) {
  require_solution();
  require_converged();
  const BlasThreads blas(blas_threads());
  if (Rates found; moving_ && moving_->rates(parameter, found)) return found;
  const Rates& own = own_rates(parameter);
  // Results on strips are extrapolated by what moves them, which knows their rates under Coulomb's law alone.
  const bool by_pair = derived_.extrapolated && derived_.extrapolated->left_over > 0;
  return by_pair ? beyond(*derived_.extrapolated, own, coarser_->own_rates(parameter)) : own;
}

Rates Solver::rates(const NodeGivens& rate) {
  require_solution();
  require_converged();
  const BlasThreads blas(blas_threads());
  require_operators();
  return rate_finder_.by(rate, solution_, engine_.newton, derived_);
}

void Solver::read_givens(NodeGivens& now) {
  prepare();
  const Problem& p = solution_.prepared->problem;
  const MotionValues& given = solution_.given.value;
  now.gap.resize(at(p.nodes));
  for (auto& slip : now.slip) slip.resize(at(p.nodes));
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    const auto i = static_cast<std::int64_t>(k);
    now.gap[k] = p.rigid_gap(k, given);
    now.slip[0][k] = p.rigid_slip1(i, given);
    now.slip[1][k] = p.rigid_slip2(i, given);
  }
  now.mu = p.mu;
}

double Solver::error_estimate() {
  return find_error_estimate(solution_, derived_).worst();
}

const Compliance& Solver::compliance_of(std::int32_t body) {
  require_solution();
  auto& compliance = preparation_->body_compliance[body - 1];
  const Prepared& on = *solution_.prepared;
  const int threads = host.context->threads();
  if (!compliance) compliance = make_body_compliance(on.frame, on.pair, body - 1, on.accuracy, threads);
  compliance->set_threads(threads);
  return *compliance;
}

std::vector<double> Solver::power_lost(std::int32_t body) {
  SurfaceState state;
  state.loads_alone = true;
  const Compliance& compliance = compliance_of(body);
  const auto& lambda = solution_.iterate.lambda;
  std::vector<double> traction(3 * lambda[0].size());
  for (std::size_t k = 0; k < traction.size(); ++k) traction[k] = lambda[k % 3][k / 3];
  compliance.everywhere(traction.data(), state);
  // Tractions between nodes flatten waves; the sum at nodes does not know of that.
  const double sum = std::accumulate(state.power.begin(), state.power.end(), 0.0);
  const double lost = solution_.prepared->speed * rolling_resistance(solution_, body - 1);
  for (double& power : state.power) power *= sum > 0 ? lost / sum : 0;
  return std::move(state.power);
}

void Solver::tell(Status status) const {
  const Solution& s = solution_;
  if (!s.solved || status == Status::ok || with_doubts(s, status_of(s)) != status) return;
  if (const Line doubt = describe_meshes(s); *doubt.text && is_answer(status)) host.caveat(status, doubt.c_str());
  if (status == Status::coarse) {
    if (nodes_at_rim(s) > 0) host.caveat(status, describe_outcome(s).c_str());
    host.caveat(status, describe_few_nodes(s).c_str());
  } else if (status == Status::not_converged || status == Status::rim_contact || status == Status::too_deep) {
    host.caveat(status, describe_outcome(s).c_str());
  }
  // The caveat told last is the one that callers see.
  if (const Line units = describe_units(s); *units.text && is_answer(status)) host.caveat(status, units.c_str());
}

}  // namespace rollcon
