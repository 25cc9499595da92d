#pragma once
/// Which loads the reactions of a body's supports miss. Only boundary elements can miss any: nothing in their equations
/// keeps the balance.

#include <cstdio>
#include <string>
#include <utility>

namespace rollcon {

struct Imbalances {
  /// Parts of uniform tractions on frames, the largest of all frames: along the body's axes, and of a pressure.
  double along[3] = {0, 0, 0}, pressure = 0;
  double loads = 0;  ///< part of the body's own loads

  /// "57 % of a load along its axis y, ..."; empty where none is worth telling.
  std::string notable() const {
    constexpr double least = 0.1;
    const std::pair<double, const char*> all[] = {{loads, "its own loads"},
                                                  {pressure, "a pressure on a frame"},
                                                  {along[0], "a load along its axis x"},
                                                  {along[1], "a load along its axis y"},
                                                  {along[2], "a load along its axis z"}};
    std::string text;
    for (const auto& [part, load] : all) {
      if (!(part > least)) continue;
      char entry[80];
      std::snprintf(entry, sizeof entry, "%s%.2g %% of %s", text.empty() ? "" : ", ", 100 * part, load);
      text += entry;
    }
    return text;
  }
};

/// A response that may miss loads.
class MayMissLoads {
 public:
  virtual Imbalances imbalances() const = 0;

 protected:
  ~MayMissLoads() = default;
};

/// Of any response: none where it cannot miss a load.
template <class Response>
Imbalances imbalances_of(const Response* response) {
  const auto* missing = dynamic_cast<const MayMissLoads*>(response);
  return missing ? missing->imbalances() : Imbalances{};
}

/// What follows notable() in a message.
inline constexpr const char* imbalance_remedy =
    "under such loads its displacements may be off by as much, under others not; refine its mesh "
    "where it is thin, or take quadratic elements";

}  // namespace rollcon
