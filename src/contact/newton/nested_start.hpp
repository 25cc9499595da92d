#pragma once
/// Starts cold on lattices: the problem is solved on lattices of twice the spacing first.

#include <functional>

#include "contact/newton/newton.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Holds what a coarser problem is made of beside the finer one.
struct LatticeScene {
  const Frame& frame;
  const Lattice& lattice;
  /// Makes operators and convection of the problem on another lattice.
  std::function<void(const Frame&, const Lattice&, Problem&)> make_operators;
  std::function<bool()> cancelled;
};

/// Fills tractions and motions of a cold iterate from solutions on coarser lattices, the next one solved to
/// `tolerance`. Returns false, with nothing changed, where there is none, or where one was not found.
bool start_from_coarser(const Problem& problem, const Prescribed& given, const LatticeScene& scene, bool frictionless,
                        double tolerance, Iterate& iterate);
constexpr double start_tolerance = 1e-3;

/// Fills tractions and motions from the solution on the lattice of 2^halvings times the spacing alone. Returns false
/// where that has fewer nodes along a side than an estimate can use, or where it was not found.
bool solve_on_coarser(const Problem& problem, const Prescribed& given, const LatticeScene& scene, bool frictionless,
                      double tolerance, int halvings, Iterate& iterate);

}  // namespace rollcon
