#pragma once
/// Prepares regular rectangular frames between bodies that respond alike everywhere: their operators come from tables
/// of one node's influence, applied by FFT or written out, instead of integrals over elements.

#include <string>

#include "contact/scene/options.hpp"
#include "contact/solution.hpp"

namespace rollcon {

struct Preparation;  // contact/prepare/preparation.hpp

/// Makes a regular frame's operators, or brings them up to date, and decides whether dense rows come from a table;
/// makes none where the scene is another or dense operators serve it better. Throws Error (err_unsupported) naming the
/// reason when the option `operators` asks for FFT in vain.
void build_lattice_operators(Preparation& preparation, const Options& options);

/// Writes all rows of a small regular frame. Returns false where the scene was not found to be one.
bool fill_from_table(Preparation& preparation);

/// Starts a cold iterate under operators applied by FFT from coarser lattices.
void start_on_lattice(Solution& solution, const Monitor& monitor);

/// Solves the solution's problem, its motions given, by the same scheme on the lattice of 2^halvings times the spacing,
/// and interpolates the tractions. Returns false where there is no such lattice.
bool solve_on_coarser_lattice(const Solution& solution, double tolerance, int halvings, Iterate& iterate);

/// Finds displacements u[3 * k + c] at all nodes under tractions lambda by the compliance of one body, with FFT.
/// Returns false where that compliance depends on the place.
bool displacements_on_lattice(const Solution& solution, const Compliance& body, const std::vector<double> (&lambda)[3],
                              double* u);

/// Returns one line for the plan; empty: no lattice.
std::string describe_lattice(const Prepared& on);

}  // namespace rollcon
