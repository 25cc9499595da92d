#pragma once
/// Makes finite-element bodies through the public interface.

#include "fixture.hpp"

namespace capi_test {

/// Holds the box [0, 1]^2 x [0, height] in n x n x n trilinear hexahedra, ids from 0; the last index of node and
/// element runs along z.
struct BoxVolume {
  int n;
  double height;
  std::vector<double> x;
  std::vector<std::int32_t> connectivity;

  explicit BoxVolume(int per_edge, double h = 1) : n(per_edge), height(h) {
    for (int k = 0; k <= n; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) x.insert(x.end(), {1.0 * i / n, 1.0 * j / n, height * k / n});
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          for (const auto& c : corners) connectivity.push_back(i + c[0] + (n + 1) * (j + c[1] + (n + 1) * (k + c[2])));
  }

  static constexpr std::array<std::array<int, 3>, 8> corners{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  static constexpr std::int32_t bottom = 0, top = 1, front = 2, right = 3, back = 4, left = 5;

  std::int64_t nodes() const { return static_cast<std::int64_t>(x.size()) / 3; }
  std::int64_t elements() const { return std::int64_t{n} * n * n; }
  std::int64_t layer_elements() const { return std::int64_t{n} * n; }
  std::vector<std::int32_t> nodes_at(std::size_t axis, double value) const {
    std::vector<std::int32_t> found;
    for (std::size_t i = 0; i < x.size() / 3; ++i)
      if (x[3 * i + axis] == value) found.push_back(static_cast<std::int32_t>(i));
    return found;
  }
  /// Returns elements of the uppermost layer, each with its upper face.
  std::pair<std::vector<std::int32_t>, std::vector<std::int32_t>> top_faces() const {
    std::vector<std::int32_t> element;
    for (std::int64_t e = elements() - layer_elements(); e < elements(); ++e)
      element.push_back(static_cast<std::int32_t>(e));
    return {element, std::vector<std::int32_t>(element.size(), top)};
  }
};

/// Gives nodes and elements of material 0, the upper faces with tag 6.
inline void give_mesh(rollcon_body* b, const BoxVolume& box) {
  const auto [element, face] = box.top_faces();
  ASSERT_OK(rollcon_body_set_nodes(b, box.nodes(), box.x.data(), 3, 1));
  ASSERT_OK(rollcon_body_add_elements(b, ROLLCON_HEX8, box.elements(), box.connectivity.data(), 0, 0));
  ASSERT_OK(rollcon_body_tag_faces(b, static_cast<std::int64_t>(element.size()), element.data(), face.data(), 0, 6));
}

/// Returns one element of a type: corners of a unit tetrahedron, wedge or cube, then the edge midpoints.
inline std::vector<double> unit_element(std::int32_t type) {
  using Corner = std::array<double, 3>;
  using Edge = std::array<std::size_t, 2>;
  std::vector<Corner> corner;
  std::vector<Edge> edge;
  switch (type) {
    case ROLLCON_TET4:
    case ROLLCON_TET10:
      corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      edge = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
      break;
    case ROLLCON_WEDGE6:
    case ROLLCON_WEDGE15:
      corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
      edge = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
      break;
    default:
      for (const auto& c : BoxVolume::corners) corner.push_back({1.0 * c[0], 1.0 * c[1], 1.0 * c[2]});
      edge = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  }
  std::vector<double> x;
  for (const Corner& c : corner) x.insert(x.end(), c.begin(), c.end());
  if (type == ROLLCON_TET10 || type == ROLLCON_WEDGE15 || type == ROLLCON_HEX20)
    for (const auto& [a, b] : edge)
      for (std::size_t c = 0; c < 3; ++c) x.push_back(0.5 * (corner[a][c] + corner[b][c]));
  return x;
}

/// Returns 0, 1, ..., n - 1.
inline std::vector<std::int32_t> counting(std::int64_t n) {
  std::vector<std::int32_t> id(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < id.size(); ++i) id[i] = static_cast<std::int32_t>(i);
  return id;
}

constexpr std::int32_t volume_types[] = {ROLLCON_TET4,    ROLLCON_TET10, ROLLCON_WEDGE6,
                                         ROLLCON_WEDGE15, ROLLCON_HEX8,  ROLLCON_HEX20};

/// Adds to the scene of Api a finite-element body with nothing given.
class FemApi : public Api {
 protected:
  void SetUp() override {
    if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
    Api::SetUp();
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
  }

  void TearDown() override {
    rollcon_body_release(body);
    Api::TearDown();
  }

  std::int32_t set_nodes_of_box() { return rollcon_body_set_nodes(body, box.nodes(), box.x.data(), 3, 1); }

  /// Makes a new body of one element of the type, held at its bottom z = 0.
  void set_element(std::int32_t type, double nu = poisson) {
    rollcon_body_release(body);
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
    const std::vector<double> x = unit_element(type);
    const auto n = static_cast<std::int64_t>(x.size()) / 3;
    ASSERT_OK(rollcon_body_set_nodes(body, n, x.data(), 3, 1));
    ASSERT_OK(rollcon_body_add_elements(body, type, 1, counting(n).data(), 0, 0));
    ASSERT_OK(rollcon_body_set_elastic(body, 0, young, nu));
    std::vector<std::int32_t> bottom;
    for (std::int32_t i = 0; i < n; ++i)
      if (x[3 * static_cast<std::size_t>(i) + 2] == 0) bottom.push_back(i);
    ASSERT_OK(hold(bottom, ROLLCON_DOF_XYZ));
  }

  /// Adds layers of elements from `first` to the one before `end`, of a material.
  std::int32_t add_layers(int first, int end, std::int32_t tag) {
    const std::int32_t* from = box.connectivity.data() + 8 * first * box.layer_elements();
    return rollcon_body_add_elements(body, ROLLCON_HEX8, (end - first) * box.layer_elements(), from, 0, tag);
  }

  /// Gives nodes and all elements with material tag 0.
  void set_mesh() {
    ASSERT_OK(set_nodes_of_box());
    ASSERT_OK(add_layers(0, box.n, 0));
  }

  std::int32_t tag_top(std::int32_t tag) {
    const auto [element, face] = box.top_faces();
    return rollcon_body_tag_faces(body, static_cast<std::int64_t>(element.size()), element.data(), face.data(), 0, tag);
  }

  std::int32_t tag_nodes_at(std::size_t axis, double value, std::int32_t tag) {
    const std::vector<std::int32_t> nodes = box.nodes_at(axis, value);
    return rollcon_body_tag_faces_of_nodes(body, static_cast<std::int64_t>(nodes.size()), nodes.data(), 0, tag);
  }

  std::int32_t hold(const std::vector<std::int32_t>& nodes, std::int32_t dof_mask) {
    return capi_test::hold(body, nodes, dof_mask);
  }

  std::int32_t hold_bottom(std::int32_t dof_mask) { return hold(box.nodes_at(2, 0), dof_mask); }

  /// Holds the bottom along z, its corner at the origin along x and y, the next one along y.
  void hold_freely() {
    ASSERT_OK(hold_bottom(ROLLCON_DOF_Z));
    ASSERT_OK(hold({0}, ROLLCON_DOF_X + ROLLCON_DOF_Y));
    ASSERT_OK(hold({box.n}, ROLLCON_DOF_Y));
  }

  void expect_size(std::int64_t nodes, std::int64_t elements) {
    std::int64_t n = -1, m = -1;
    ASSERT_OK(rollcon_body_get_size(body, &n, &m));
    EXPECT_EQ(n, nodes);
    EXPECT_EQ(m, elements);
  }

  /// Returns the nodes and elements of the frame that the faces of the body with the tag make; -1 if none.
  std::pair<std::int64_t, std::int64_t> frame_size(std::int32_t tag) {
    rollcon_contact* c = nullptr;
    std::int64_t n = -1, m = -1;
    EXPECT_OK(rollcon_contact_create(context, body, plane, &c));
    if (rollcon_contact_frame_from_body(c, 1, tag) == ROLLCON_OK) {
      EXPECT_OK(rollcon_contact_get_size(c, &n, &m));
    }
    rollcon_contact_release(c);
    return {n, m};
  }

  double statistic(const char* name) {
    double value = -1;
    EXPECT_OK(rollcon_body_get_stat(body, name, &value)) << name;
    return value;
  }

  static constexpr double young = 200, poisson = 0.3;
  BoxVolume box{2};
  rollcon_body* body = nullptr;
};

}  // namespace capi_test
