/// Makes the rows of the operators that a scene needs, and the scales that follow them.

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "bodies/model/translation.hpp"
#include "contact/prepare/lattice_scene.hpp"
#include "contact/prepare/preparation.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

// Refuses a node that a support keeps from moving along its normal: Newton's iteration would not end.
void refuse_held_nodes(const Frame& frame, const Operators& op) {
  constexpr double rounding = 1e-12;
  const auto diagonal = [&](std::size_t k) {
    // A corner function of a quad8 has a negative mean: its node may even rise under pressure.
    return std::abs(op.own(2, 2, k));
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

// Fills operators of frames that are placed anew from solve to solve from those of their shape.
bool fill_from_family(Preparation& preparation, std::int64_t& assemblies) {
  Prepared& on = *preparation.made;
  const bool step = on.scheme == Scheme::time_step;
  if (!on.placed || on.frame.curved() || (on.scheme != Scheme::characteristic && !step)) return false;
  const auto kernel = on.compliance->translation();
  if (!kernel || !kernel->scales()) return false;
  const bool tangential = !on.frictionless;
  preparation.family.belong_to(preparation.convection.version(), tangential);
  const auto assemble = [&](const FramePlace& place, DenseOperators& op) {
    Frame frame = on.frame;
    Convection convection = on.problem.convection;
    preparation.unit.put_frame(place, on.frame.mesh.node, frame);
    if (!step) preparation.unit.put_convection(place, frame, convection);
    const auto compliance = make_pair_compliance(frame, on.pair, on.accuracy, preparation.threads);
    const bool mirrors = place.shear == 0;
    assemble_operators(frame, *compliance, convection, tangential, op,
                       mirrors ? preparation.unit.mirror() : std::span<const std::int32_t>{});
  };
  // std::cref avoids a copy.
  assemblies = preparation.family.fill(on.place, step, std::cref(assemble), *preparation.dense);
  return true;
}

}  // namespace

void assemble_missing(Preparation& preparation) {
  Prepared& on = *preparation.made;
  if (!preparation.dense) return;  // operators are whole from the start
  DenseOperators& op = *preparation.dense;
  if (op.normal && (on.frictionless || op.tangential)) return;
  const Stopwatch watch(preparation.timings.compliance);
  std::int64_t assemblies = 1;
  const bool stretched = fill_from_family(preparation, assemblies);
  if (!stretched && !fill_from_table(preparation))
    assemble_operators(on.frame, *on.compliance, on.problem.convection, !on.frictionless, op);
  if (!stretched) {  // bodies of a stretched frame have no supports
    refuse_held_nodes(on.frame, op);
    op.loosen_held_tangents(on.frame.used, !on.problem.convection.ahead.empty() || on.scheme == Scheme::time_step);
  }
  preparation.builds.operators += assemblies;
  ++preparation.rows;
  preparation.changes.images = preparation.changes.operators = true;
  if (!preparation.procedure.monolithic) preparation.changes.system = true;
}

void choose_scales(Preparation& preparation) {
  const bool estimate = !preparation.procedure.standard();
  Problem& problem = preparation.made->problem;
  if (!preparation.scales.enter(preparation.frame.version(), estimate ? preparation.place.version() : preparation.rows,
                                estimate))
    return;
  estimate ? estimate_scales(problem) : set_scales(problem);
  ++preparation.builds.scales;
  preparation.changes.operators = preparation.changes.system = true;
}

void require_operators(Preparation& preparation) {
  try {
    assemble_missing(preparation);
    choose_scales(preparation);
  } catch (...) {
    // Nothing else would drop what was half assembled, because no solve is running.
    forget_operators(preparation);
    preparation.changes.operators = true;
    throw;
  }
}

}  // namespace rollcon
