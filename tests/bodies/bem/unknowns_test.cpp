// Tests the order of a boundary-element body's unknowns: what frames ask for stands at the end, so that only the end of
// solutions is worked out.

#include "bodies/bem/unknowns.hpp"

#include <span>

#include "mesh/traction_nodes.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon::bem {
namespace {

/// Makes a block that is held at its bottom, with a fine zone of tag 2 on top.
BodyMesh block_with_zone(ElementType type) {
  BodyMesh body;
  body.surface = surfaces::zone_block({10, 5, 2, 6, 4, 4}, type);
  body.held.assign(body.surface.node.size(), 0);
  body.held_value.resize(body.surface.node.size());
  for (const std::int32_t k : surfaces::nodes_with_tag(body.surface, std::array{3}))
    body.held[static_cast<std::size_t>(k)] = 7;
  return body;
}

/// Returns the fraction of the unknowns from the first one on that a frame of these faces asks for.
double asked_part(const BodyMesh& body, std::int32_t tag) {
  const Unknowns u = choose_unknowns(body, split_at_edges(body.surface, 40));
  std::int32_t first = static_cast<std::int32_t>(u.columns);
  const auto faces = surfaces::elements_with_tag(body.surface, tag);
  for (const std::int32_t k : nodes_around(body.surface, faces))
    for (std::size_t c = 0; c < 3; ++c)
      if (const std::int32_t column = u.displacement[3 * static_cast<std::size_t>(k) + c]; column >= 0)
        first = std::min(first, column);
  return 1 - static_cast<double>(first) / static_cast<double>(u.columns);
}

TEST(unknowns, of_a_fine_zone_are_the_last) {
  for (const ElementType type : surfaces::all_types) {
    BodyMesh body = block_with_zone(type);
    const auto faces = surfaces::elements_with_tag(body.surface, 2);
    const auto wanted =
        static_cast<double>(nodes_around(body.surface, faces).size()) / static_cast<double>(body.surface.nodes());
    const double found = asked_part(body, 2);
    body.contact_tag = {2};
    const double named = asked_part(body, 2);
    std::printf("%s: nodes of the zone %.2f, unknowns from the first of them on %.2f, named %.2f\n",
                surfaces::name_of(type).c_str(), wanted, found, named);
    EXPECT_LE(found, 2 * wanted);  // other faces are as fine
    EXPECT_LE(named, 1.01 * wanted);
  }
}

TEST(unknowns, of_coarse_faces_that_are_named_are_the_last) {
  BodyMesh body = block_with_zone(ElementType::quad4);
  const double unnamed = asked_part(body, 1);
  body.contact_tag = {1};
  const double named = asked_part(body, 1);
  std::printf("coarse faces: unknowns from the first on %.2f, named %.2f\n", unnamed, named);
  EXPECT_LT(named, unnamed);
}

}  // namespace
}  // namespace rollcon::bem
