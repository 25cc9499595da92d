#include "io/mesh_types.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "mesh/element_type.hpp"
#include "mesh/volume_type.hpp"

namespace rollcon {
namespace {

constexpr std::int32_t number(ElementType type) {
  return static_cast<std::int32_t>(type);
}
constexpr std::int32_t number(VolumeType type) {
  return static_cast<std::int32_t>(type);
}

// Gmsh runs through the edges of an element in the order of its own tables.
constexpr int tet10[] = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr int wedge15[] = {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11};
constexpr int hex20[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15};

struct Gmsh {
  std::int64_t number;
  ForeignType type;
};
constexpr Gmsh gmsh[] = {
    {1, {2, 0, 2}},
    {2, {3, number(ElementType::tri3), 3}},
    {3, {4, number(ElementType::quad4), 4}},
    {4, {4, number(VolumeType::tet4), 4}},
    {5, {8, number(VolumeType::hex8), 8}},
    {6, {6, number(VolumeType::wedge6), 6}},
    {8, {3, 0, 3}},
    {9, {6, number(ElementType::tri6), 6}},
    {10, {9, number(ElementType::quad9), 9}},
    {11, {10, number(VolumeType::tet10), 10, tet10}},
    {12, {27, number(VolumeType::hex20), 20, hex20}},      // without the middles of faces and the centre
    {13, {18, number(VolumeType::wedge15), 15, wedge15}},  // without the middles of faces
    {15, {1, 0, 1}},
    {16, {8, number(ElementType::quad8), 8}},
    {17, {20, number(VolumeType::hex20), 20, hex20}},
    {18, {15, number(VolumeType::wedge15), 15, wedge15}},
};

// The volume elements are told by their number of nodes. Abaqus numbers nodes the way rollcon does.
constexpr ForeignType volumes[] = {
    {4, number(VolumeType::tet4), 4},      {10, number(VolumeType::tet10), 10}, {6, number(VolumeType::wedge6), 6},
    {15, number(VolumeType::wedge15), 15}, {8, number(VolumeType::hex8), 8},    {20, number(VolumeType::hex20), 20},
    {27, number(VolumeType::hex20), 20},
};
constexpr ForeignType surfaces[] = {
    {3, number(ElementType::tri3), 3},  {6, number(ElementType::tri6), 6},  {4, number(ElementType::quad4), 4},
    {8, number(ElementType::quad8), 8}, {9, number(ElementType::quad9), 9},
};
/// The families of membranes, shells, rigid surfaces and plane elements are each followed by the number of nodes.
constexpr std::string_view surface_families[] = {"S",   "M3D", "SFM3D", "R3D", "DS",   "STRI",
                                                 "CPS", "CPE", "CAX",   "F3D", "DC2D", "AC2D"};

template <std::size_t n>
const ForeignType* with_nodes(const ForeignType (&list)[n], int nodes) {
  const auto* found =
      std::find_if(std::begin(list), std::end(list), [&](const ForeignType& t) { return t.given == nodes; });
  return found == std::end(list) ? nullptr : found;
}

/// Returns the number that follows a family, or -1 when something else does.
int nodes_after(std::string_view name, std::string_view family) {
  if (!name.starts_with(family)) return -1;
  int nodes = 0;
  std::size_t i = family.size();
  for (; i < name.size() && name[i] >= '0' && name[i] <= '9' && nodes < 100; ++i) nodes = 10 * nodes + (name[i] - '0');
  return i == family.size() ? -1 : nodes;
}

}  // namespace

const ForeignType* gmsh_type(std::int64_t number) {
  const auto* found = std::find_if(std::begin(gmsh), std::end(gmsh), [&](const Gmsh& g) { return g.number == number; });
  return found == std::end(gmsh) ? nullptr : &found->type;
}

const ForeignType* abaqus_type(std::string_view name, bool& unsupported) {
  unsupported = false;
  for (const std::string_view family : {"C3D", "DC3D", "SC"}) {
    const int nodes = nodes_after(name, family);
    if (nodes < 0) continue;
    const ForeignType* type = with_nodes(volumes, nodes);
    unsupported = !type;
    return type;
  }
  if (name == "STRI65") return with_nodes(surfaces, 6);
  for (const std::string_view family : surface_families) {
    const int nodes = nodes_after(name, family);
    if (nodes >= 0) return with_nodes(surfaces, nodes);
  }
  return nullptr;
}

}  // namespace rollcon
