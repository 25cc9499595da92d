/// Rows of the operators that a scene needs, and the scales that follow them.

#include <algorithm>
#include <cmath>

#include "contact/prepare/lattice_scene.hpp"
#include "contact/prepare/preparation.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

// A node that a support keeps from moving along its normal can carry any pressure: Newton's iteration would not end.
void refuse_held_nodes(const Frame& frame, const ContactOperators& op) {
  constexpr double rounding = 1e-12;
  const auto diagonal = [&](std::size_t k) {
    // A corner function of a quad8 has a negative mean: its node may even rise under pressure.
    return std::abs(op.block[2][2].row(static_cast<std::int64_t>(k))[k]);
  };
  double largest = 0;
  for (std::size_t k = 0; k < frame.used.size(); ++k)
    if (frame.used[k]) largest = std::max(largest, diagonal(k));
  long long held = 0, first = -1;
  for (std::size_t k = 0; k < frame.used.size(); ++k)
    if (frame.used[k] && !(diagonal(k) > rounding * largest) && held++ == 0)
      first = static_cast<long long>(k) + frame.mesh.index_base;
  if (held > 0)
    fail(Status::err_state,
         "node %lld of the frame (counting from %d) does not move along its normal under pressure: "
         "a support holds the body there; %lld such node(s); end the frame before them or hold the "
         "body elsewhere",
         first, frame.mesh.index_base, held);
}

}  // namespace

void loosen_held_tangents(const std::vector<std::uint8_t>& used, ContactOperators& op) {
  if (!op.tangential) return;
  constexpr double rounding = 1e-12, looseness = 1e-6;
  const std::int64_t n = op.nodes;
  const auto row_norm = [&](int r, std::int64_t k) {
    return std::hypot(norm2(op.block[r][0].row(k), n), norm2(op.block[r][1].row(k), n));
  };
  double largest = 0;
  for (std::int64_t k = 0; k < n; ++k)
    if (used[static_cast<std::size_t>(k)]) largest = std::max({largest, row_norm(0, k), row_norm(1, k)});
  // Both rows vanish at the inflow rim of upwind schemes.
  const bool upwind = op.convection.ahead.empty();
  for (std::int64_t k = 0; k < n; ++k) {
    if (!used[static_cast<std::size_t>(k)]) continue;
    const bool held[2] = {row_norm(0, k) <= rounding * largest, row_norm(1, k) <= rounding * largest};
    for (int r = 0; r < 2; ++r)
      if (held[r] && !(upwind && held[1 - r])) op.block[r][r].row(k)[k] = looseness * largest;
  }
}

void assemble_missing(SolverState& state) {
  Preparation& preparation = *state.preparation;
  Prepared& on = *preparation.made;
  ContactOperators& op = on.problem.op;
  if (op.normal && (state.frictionless || op.tangential)) return;
  const Stopwatch watch(state.timings.compliance);
  if (!fill_from_table(state)) assemble_operators(on.frame, *on.compliance, !state.frictionless, op);
  refuse_held_nodes(on.frame, op);
  loosen_held_tangents(on.frame.used, op);
  ++state.assemblies;
  state.iterate.invalidate();
  ++preparation.rows;
  state.newton.operators_changed();
  if (!state.procedure.monolithic) state.published.reset();
}

void choose_scales(SolverState& state) {
  const bool estimate = !state.procedure.standard();
  Preparation& preparation = *state.preparation;
  Problem& problem = preparation.made->problem;
  if (!preparation.scales.enter(preparation.frame.version(), estimate ? 0 : preparation.rows, estimate)) return;
  estimate ? estimate_scales(problem) : set_scales(problem);
  ++state.work.scales;
  state.newton.operators_changed();
  state.published.reset();
}

void require_operators(SolverState& state) {
  if (!state.preparation) fail(Status::err_internal, "operators that are shared cannot be assembled");
  try {
    assemble_missing(state);
    choose_scales(state);
  } catch (...) {
    // Not during a solve: nothing else would drop what was half assembled.
    ContactOperators& op = state.preparation->made->problem.op;
    for (auto& row : op.block)
      for (auto& block : row) block.release();
    op.normal = op.tangential = false;
    state.newton.operators_changed();
    throw;
  }
  state.images_known = false;
}

}  // namespace rollcon
