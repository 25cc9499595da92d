#pragma once
/// Solves contacts whose caller gave no frame on strips, as fine as the accuracy asked for needs (docs/theory.md, 4).

#include <array>
#include <memory>
#include <optional>

#include "framing/strip_frames.hpp"

namespace rollcon {

class StripLevels {
 public:
  /// Solves on strips that fit the contact inside of the box, of two counts, and on finer ones until the accuracy that
  /// the scene asks for is met. area: that of the contact where it is known. Nothing: strips do not fit. Errors are
  /// those of Solver::solve().
  std::optional<Status> solve(Solver& fine, const Rectangle& box, const std::optional<double>& area);
  /// Tells that finest frames are off by `reached`, more than was asked for, and returns the status that says so.
  static Status tell_inaccurate(const Solver& fine, double reached);
  void forget();  ///< warm starts

 private:
  bool fit(Solver& fine, const Rectangle& box, std::size_t level, Rates& found);
  double area_at(std::size_t level) const;

  static constexpr std::size_t levels = 7;
  std::array<StripFrames, levels> strips_;
  std::unique_ptr<Solver> coarse_;
};

}  // namespace rollcon
