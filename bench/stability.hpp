#pragma once
/// Runs the stability suite: stiff and extreme scenes, each judged by laws of contact recomputed without the solver.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench.hpp"
#include "procedures.hpp"
#include "support/extremes.hpp"

namespace rollcon::bench {

/// The laws of contact must hold to this.
inline constexpr double law_bound = 1e-8;

/// Returns scenes with bodies that have meshes.
std::vector<extremes::Scene> stability_body_scenes(bool quick);
/// Returns the scene of a seed 1, 2, ...
extremes::Scene stability_random_body_scene(std::uint32_t seed);
/// Returns how many of them are among so many random scenes.
std::uint32_t stability_random_body_count(std::uint32_t scenes);

/// Returns what was asked for in vain, and what the library said.
std::vector<std::pair<std::string, std::string>> stability_refusals();

/// Holds the numbers of one group of scenes and one way of solving.
struct StabilityRow {
  std::int64_t scenes = 0;
  std::int64_t solved = 0;   ///< scenes that satisfy the laws
  std::int64_t refused = 0;  ///< scenes that ended with a status that is right
  std::int64_t not_converged = 0;
  std::int64_t wrong = 0;  ///< scenes with broken laws, or another status than is right
  double law = 0, iterations = 0, all_iterations = 0, condition = 0, seconds = 0;
};

/// Holds rows by way of solving and group, in the order of their first record.
class StabilityTable {
 public:
  void add(const std::string& way, const std::string& group, const extremes::Ending& ending, bool right);
  void print() const;

 private:
  std::vector<std::string> ways_, groups_;
  std::map<std::pair<std::string, std::string>, StabilityRow> row_;
};

}  // namespace rollcon::bench
