#pragma once
/// Makes a cube of boundary elements through the public interface.

#include <map>

#include "fixture.hpp"

namespace capi_test {

/// Holds the surface of the cube [0, 1]^3 in n x n bilinear quadrilaterals a face, ids from 0, normals outwards. Faces
/// 1 to 6 are x = 0, x = 1, y = 0, y = 1, z = 0, z = 1, each with a tag of its own.
struct CubeSurface {
  std::vector<double> x;
  std::array<std::vector<std::int32_t>, 6> face;  ///< connectivity
  int per_edge;

  explicit CubeSurface(int n) : per_edge(n) {
    std::map<std::array<int, 3>, std::int32_t> known;
    const auto node = [&](const std::array<int, 3>& at) {
      const auto [entry, fresh] = known.try_emplace(at, static_cast<std::int32_t>(known.size()));
      if (fresh)
        for (const int i : at) x.push_back(static_cast<double>(i) / n);
      return entry->second;
    };
    for (std::size_t f = 0; f < 6; ++f) {
      const std::size_t axis = f / 2, p = (axis + 1) % 3, q = (axis + 2) % 3;
      const bool most = f % 2 == 1;
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          const std::array<std::array<int, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
          for (std::size_t k = 0; k < 4; ++k) {
            const auto& c = corner[most ? k : (4 - k) % 4];
            std::array<int, 3> at{};
            at[axis] = most ? n : 0;
            at[p] = i + c[0];
            at[q] = j + c[1];
            face[f].push_back(node(at));
          }
        }
      }
    }
  }

  std::int64_t nodes() const { return static_cast<std::int64_t>(x.size()) / 3; }
  std::int64_t face_elements() const { return std::int64_t{per_edge} * per_edge; }
  /// Returns the nodes with coordinate `axis` equal to `value`.
  std::vector<std::int32_t> nodes_at(std::size_t axis, double value) const {
    std::vector<std::int32_t> found;
    for (std::size_t i = 0; i < x.size() / 3; ++i)
      if (x[3 * i + axis] == value) found.push_back(static_cast<std::int32_t>(i));
    return found;
  }
};

/// Gives nodes and faces, those of face f with tag f + 1.
inline void give_mesh(rollcon_body* b, const CubeSurface& cube) {
  ASSERT_OK(rollcon_body_set_nodes(b, cube.nodes(), cube.x.data(), 3, 1));
  for (std::int32_t f = 0; f < 6; ++f)
    ASSERT_OK(rollcon_body_add_elements(b, ROLLCON_QUAD4, cube.face_elements(),
                                        cube.face[static_cast<std::size_t>(f)].data(), 0, f + 1));
}

/// Adds to the scene of Api a cube of its own material without supports or loads.
class BodyApi : public Api {
 protected:
  void SetUp() override {
    if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
    Api::SetUp();
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_BEM, &body));
    ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  }

  void TearDown() override {
    rollcon_body_release(body);
    Api::TearDown();
  }

  void set_mesh(rollcon_body* b) { give_mesh(b, cube); }

  /// Holds the bottom z = 0, wholly or along z alone.
  std::int32_t hold_bottom(std::int32_t dof_mask) { return hold(body, cube.nodes_at(2, 0), dof_mask); }

  void expect_size(std::int64_t nodes, std::int64_t elements) {
    std::int64_t n = -1, m = -1;
    ASSERT_OK(rollcon_body_get_size(body, &n, &m));
    EXPECT_EQ(n, nodes);
    EXPECT_EQ(m, elements);
  }

  static constexpr double young = 200, poisson = 0.3;
  CubeSurface cube{2};
  rollcon_body* body = nullptr;
};

}  // namespace capi_test
