#pragma once
/// Solves contacts that are about to split or to join: rows of one part and rows of two parts differ, and neither fits
/// a neck that vanishes. Such a contact is interpolated between contacts whose neck is filled up or dug out.

#include <array>

#include "framing/strips/strip_find.hpp"

namespace rollcon::strips {

/// Describes a neck between two places where the undeformed bodies are nearest, as the gap alone has it.
struct Neck {
  Vec2 place{};       ///< place of the largest gap between both
  double radius = 0;  ///< radius of the bump, 0.63 of the distance of both
  double wall = 0;    ///< gap there less the gap at the shallower of both; 0: there is no neck
};

/// Adds a smooth bump, height (1 - r^2/radius^2)^3, to a gap at a neck; a height below 0 fills the neck.
struct BridgedGap : PlaneField {
  const PlaneField* gap = nullptr;
  Neck neck;
  double height = 0;
  void at(std::span<const Vec2> point, double* value, Vec2* slope) const override;
};

/// Holds the contact of a scene: strips, and where these do not fit a neck, a mean of them and four neighbours.
struct StripSolution {
  StripState strips;
  double share = 1;  ///< weight of the strips in the mean
  std::array<StripState, 4> neighbour;
  Neck neck;
};

/// Solves scenes with or without necks. It holds only memory: results depend on what a call is given.
class StripContact {
 public:
  /// Solves a scene whose contact lies inside of the box (length). warm: `solution` is one nearby. patient: many starts
  /// are tried.
  StripReport solve(const StripScene& scene, const Rectangle& box, StripCounts counts, StripSolution& solution,
                    bool warm, bool patient = true);
  /// Says whether the last contact has peaks of pressure at corners that its strips miss.
  bool missed_corners() const { return finder_.missed_corners(); }
  static StripTotals totals(const StripSolution& solution);
  /// Computes total derivatives of the totals, one for each parameter; the weight and the neck move with it.
  bool rates(const StripScene& scene, const StripSolution& solution, std::span<const StripParameter> parameter,
             std::span<StripTotals> rate);

 private:
  bool solve_near_neck(const StripScene& scene, const Rectangle& box, StripCounts counts, StripSolution& solution,
                       bool patient);
  bool change_bump(const StripScene& scene, BridgedGap& gap, StripState& state, double from, double to, int steps);
  void start_from_neighbours(const StripScene& scene, StripSolution& solution);
  bool bridge(const StripScene& scene, const Rectangle& box, StripCounts counts, StripSolution& solution, bool warm,
              bool patient);
  bool find_neck(const StripScene& scene, const StripReport& report, StripSolution& solution) const;

  StripFinder finder_;
  std::vector<StripTotals> part_rates_;
  std::vector<double> share_rates_;
};

}  // namespace rollcon::strips
