#pragma once
/// Predicts the next solution of a sweep: when the prescribed values move on along the line of their last change,
/// tractions and motions are extrapolated from the last two solutions.

#include <array>
#include <cstdint>
#include <vector>

#include "contact/problem/problem.hpp"

namespace rollcon {

class Prediction {
 public:
  /// Must be called with the last solution, before what is prescribed now gets into it.
  void begin(const Prescribed& given, const Iterate& last);
  void reserve(std::int64_t nodes);
  /// Ends a solve: the solution of begin() is then the one before the last.
  void solved();
  void forget() { solved_ = known_ = false; }
  /// Makes approaches count from a datum that is further by so much.
  void move_datum(double change);
  /// Returns the length of the step from the last solution over that to the last one; 0: none, the prescribed values
  /// did not change before or turn away from their line. weight[m]: a change of value m that would matter.
  double ratio(const Prescribed& given, std::size_t nodes, const MotionValues& weight) const;
  /// Extrapolate by `ratio`: images are those of the tractions, as both are linear. Nodes whose slip was not up to date
  /// in both solutions are not `valid`.
  void tractions(const Iterate& last, double ratio, int component, std::vector<double>& lambda) const;
  void image(const Iterate& last, double ratio, int component, std::vector<double>& image) const;
  double motion(const Iterate& last, double ratio, int m) const;
  bool slip_known(const Iterate& last, std::size_t k) const { return last.slip_valid[k] && before_.slip_valid[k]; }
  bool gaps_known(const Problem& problem, const Iterate& last) const;
  std::size_t bytes() const;

 private:
  Iterate last_, before_;  ///< copies
  Prescribed now_, at_last_, at_before_;
  bool solved_ = false;  ///< at_last_ belongs to the last solution
  bool known_ = false;   ///< before_ and at_before_ too
};

}  // namespace rollcon
