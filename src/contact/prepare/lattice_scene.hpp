#pragma once
/// Regular rectangular frames between bodies that respond alike everywhere: their operators come from tables of one
/// node's influence, applied by FFT or written out, instead of integrals over elements.

#include <string>

#include "contact/scene/options.hpp"
#include "contact/solution.hpp"

namespace rollcon {

struct Preparation;  // contact/prepare/preparation.hpp

/// Makes the operators of such a scene, or brings them up to date; leaves other scenes, and those better served by
/// dense operators, without; decides whether their rows come from a table. Throws Error (err_unsupported) naming the
/// reason when the option `operators` asks for FFT in vain.
void build_lattice_operators(Preparation& preparation, const Options& options);

/// Writes all rows of a small regular frame, where the scene was found to be one. False: it is not.
bool fill_from_table(Preparation& preparation);

/// A cold iterate under operators applied by FFT starts from coarser lattices.
void start_on_lattice(Solution& solution, const Monitor& monitor);

/// The solution's problem with its motions given, by the same scheme on the lattice of 2^halvings times the spacing;
/// tractions interpolated. False: there is none.
bool solve_on_coarser_lattice(const Solution& solution, double tolerance, int halvings, Iterate& iterate);

/// Displacements u[3 * k + c] at all nodes under the solution's tractions by the compliance of one body, with FFT.
/// False: it depends on the place.
bool displacements_on_lattice(const Solution& solution, const Compliance& body, double* u);

/// One line for the plan; empty: no lattice.
std::string describe_lattice(const Prepared& on);

}  // namespace rollcon
