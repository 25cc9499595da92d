#pragma once
/// Solves the contact of a solution once more, discretised otherwise, for error estimates to compare with.

#include <memory>
#include <vector>

#include "contact/newton/newton.hpp"
#include "contact/operators/traction_space.hpp"

namespace rollcon {

struct Solution;

/// Says whether the solution's operators are those of half-spaces whose rows are not formed.
bool applies_half_spaces(const Solution& solution);

class Variant {
 public:
  /// Keeps the solution's nodes in contact alone, with tangential rows by the characteristic scheme. tangential: false
  /// leaves these out.
  static Variant same_nodes(const Solution& state, bool tangential, double step);
  /// Keeps all nodes, where rows are not formed, and takes another step of the characteristic scheme.
  static Variant other_step(const Solution& state, double step);
  /// Keeps about a quarter of the nodes. Throws Error where the coarse triangles are no valid frame.
  static Variant coarse(const Solution& state, double step);

  /// Solves with the motions of the solution; with its normal load instead of the approach if given_load. Returns false
  /// if nothing useful was found.
  bool solve(const Solution& state, bool given_load);
  /// Returns tractions at the nodes of the solution's frame.
  const std::vector<double> (&tractions() const)[3] { return traction_; }
  /// Finds the rate of a solved variant's pressures with the approach, tangential tractions held.
  bool pressure_rate(std::vector<double>& rate);
  const TractionSpace& space() const { return *space_; }
  const Iterate& iterate() const { return iterate_; }

 private:
  void take_step(const Solution& state);
  void take_problem(const Solution& state);
  void assemble(const Solution& state, bool tangential);
  void move_given_slip(const Solution& state);

  std::unique_ptr<TractionSpace> space_;  // on the heap, as the compliance refers to it
  std::unique_ptr<Compliance> compliance_;
  std::unique_ptr<Newton> newton_;
  bool frictionless_ = false;
  Problem problem_;
  Prescribed given_;
  Iterate iterate_;
  std::vector<double> traction_[3];
};

}  // namespace rollcon
