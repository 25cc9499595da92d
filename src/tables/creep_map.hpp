#pragma once
/// Interpolates what nodes of a plane grid hold, which are found when they are first met.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <utility>

namespace rollcon {

class SectionReader;
class SectionWriter;

class CreepMap {
 public:
  static constexpr std::size_t numbers = 45;
  using Numbers = std::array<double, numbers>;
  struct Node {
    bool known = false;  ///< false: nothing is there
    Numbers value{};
  };
  using Place = std::pair<std::int64_t, std::int64_t>;
  using Find = std::function<Node(const Place&)>;

  CreepMap() = default;
  /// Reads what save() wrote; throws err_io where it is no map.
  explicit CreepMap(SectionReader& file);
  void save(SectionWriter& file);
  /// Interpolates by cubics whose slopes at a node are differences of its neighbours, to one side where only one is
  /// known. Returns how far the result is trusted: 1 within what is known, 0 at its border and beyond. Any thread may
  /// call it; results do not depend on what was asked for before if those of `find` do not.
  double at(double x, double y, const Find& find, Numbers& found);

 private:
  const Node& node(const Place& place, const Find& find);

  std::mutex mutex_;
  std::map<Place, Node> node_;
};

}  // namespace rollcon
