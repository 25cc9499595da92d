#pragma once
/// A solve by one of the published procedures. They are a component of the build; where it is left
/// out, choose_procedure() refuses them and procedures/procedures_absent.cpp stands for them.

#include "contact/newton/newton.hpp"
#include "contact/problem/problem.hpp"
#include "contact/scene/options.hpp"

namespace rollcon {

struct SolverState;

/// Augmentation parameters of half-spaces on cells of the frame's size: unlike set_scales() without
/// a look at any operator, so that both forms of the system walk the same path.
void estimate_scales(Problem& problem, double normal_factor, double tangential_factor);

/// Solves the prepared scene as state.procedure says, from state.iterate; fills the report and
/// counters of the last solve. Throws Error as the systems of the steps do.
void run_published(SolverState& state, const Options& options, Monitor& monitor);

}  // namespace rollcon
