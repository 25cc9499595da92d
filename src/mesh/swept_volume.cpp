#include "mesh/swept_volume.hpp"

#include <algorithm>

#include "support/index.hpp"

namespace rollcon {
namespace {

/// Returns angles of stations, ascending: ends and middles of elements in turn.
std::vector<double> stations_of(const SweptSection& section, double middle, double sector) {
  constexpr double growth = 1.4, longest = SweptSection::pi / 12;
  std::vector<double> end{0}, angle;  // ends on one side of the middle
  for (double step = 2 * section.step(); end.back() < sector / 2; step = std::min(growth * step, longest))
    end.push_back(end.back() + step);
  const double fit = sector / 2 / end.back();
  for (std::size_t i = end.size() - 1; i > 0; --i) {
    angle.push_back(middle - fit * end[i]);
    angle.push_back(middle - fit * (end[i] + end[i - 1]) / 2);
  }
  for (std::size_t i = 0; i + 1 < end.size(); ++i) {
    angle.push_back(middle + fit * end[i]);
    angle.push_back(middle + fit * (end[i] + end[i + 1]) / 2);
  }
  angle.push_back(middle + fit * end.back());
  return angle;
}

VolumeType swept_type(ElementType type) {
  if (corner_count(type) == 3) return is_quadratic(type) ? VolumeType::wedge15 : VolumeType::wedge6;
  return is_quadratic(type) ? VolumeType::hex20 : VolumeType::hex8;
}

}  // namespace

SweptVolume sweep_volume(const SweptSection& section, double middle, double sector) {
  constexpr double rounding = 1e-9;
  std::vector<double> angle = stations_of(section, middle, sector);
  const std::size_t elements = angle.size() / 2;
  if (section.revolved() && sector > 2 * SweptSection::pi * (1 - rounding)) angle.pop_back();
  const SurfaceMesh& plane = section.plane();
  SweptVolume swept;
  std::vector<std::int32_t> number(angle.size() * at(plane.nodes()), -1);
  const auto push = [&](std::size_t station, std::int32_t node) {
    station %= angle.size();
    std::int32_t& id = number[station * at(plane.nodes()) + at(node)];
    if (id < 0) {
      id = static_cast<std::int32_t>(swept.surface.nodes());
      swept.surface.node.push_back(section.point(node, angle[station]));
    }
    swept.volume.connectivity.push_back(id);
  };
  for (std::size_t k = 0; k < elements; ++k)
    for (std::int64_t e = 0; e < plane.elements(); ++e) {
      const ElementType type = plane.type[at(e)];
      const std::size_t corners = at(corner_count(type));
      const auto node = plane.element(e);
      // Elements that run from e1 to e2 run counter-clockwise seen from where the way begins.
      const std::size_t bottom = 2 * k + (section.orientation(e) > 0 ? 2 : 0), top = 4 * k + 2 - bottom;
      for (std::size_t first = 0; first < (is_quadratic(type) ? 2 : 1) * corners; first += corners)
        for (const std::size_t station : {bottom, top})
          for (const std::int32_t n : node.subspan(first, corners)) push(station, n);
      for (std::size_t i = 0; i < corners && is_quadratic(type); ++i) push(2 * k + 1, node[i]);
      swept.volume.type.push_back(swept_type(type));
      swept.volume.tag.push_back(plane.tag[at(e)]);
      swept.volume.offset.push_back(std::ssize(swept.volume.connectivity));
    }
  return swept;
}

}  // namespace rollcon
