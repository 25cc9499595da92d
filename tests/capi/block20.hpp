#pragma once
/// Makes a block of serendipity hexahedra for tests of fields and loads, and a ball that rolls on it.

#include <map>
#include <set>

#include "fixture.hpp"

namespace capi_test {

/// Holds [-half, half]^2 x [-depth, 0] in serendipity hexahedra, with nodes closer together near the top's middle.
struct Block20 {
  std::vector<double> x;
  std::vector<std::int32_t> connectivity, rim, top;  ///< nodes of the sides and the bottom in `rim`

  Block20(int across, int deep, double half, double depth) {
    const int nx = 2 * across, nz = 2 * deep;
    const auto place = [](double s, double growth) { return s * (1 + growth * s * s) / (1 + growth); };
    std::vector<std::int32_t> id(static_cast<std::size_t>((nx + 1) * (nx + 1) * (nz + 1)), -1);
    const auto key = [&](int i, int j, int k) { return static_cast<std::size_t>((k * (nx + 1) + j) * (nx + 1) + i); };
    const auto corner = [&](int i, int n, double growth, double a, double b) {
      // Midside nodes lie in the middle of straight edges.
      const auto at = [&](int even) { return place(a + (b - a) * even / n, growth); };
      return i % 2 == 0 ? at(i) : 0.5 * (at(i - 1) + at(i + 1));
    };
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= nx; ++j)
        for (int i = 0; i <= nx; ++i) {
          if (i % 2 + j % 2 + k % 2 > 1) continue;
          const auto n = static_cast<std::int32_t>(x.size() / 3);
          id[key(i, j, k)] = n;
          if (i % nx == 0 || j % nx == 0 || k == 0) rim.push_back(n);
          if (k == nz) top.push_back(n);
          x.insert(x.end(), {half * corner(i, nx, 1.2, -1, 1), half * corner(j, nx, 1.2, -1, 1),
                             depth * corner(k, nz, 1.2, -1, 0)});
        }
    constexpr int at[20][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                               {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                               {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
    for (int k = 0; k < nz; k += 2)
      for (int j = 0; j < nx; j += 2)
        for (int i = 0; i < nx; i += 2)
          for (const auto& c : at) connectivity.push_back(id[key(i + c[0], j + c[1], k + c[2])]);
  }
  std::int64_t nodes() const { return static_cast<std::int64_t>(x.size() / 3); }
};

/// Holds the surface of such a block in serendipity quadrilaterals.
struct Surface8 {
  std::vector<double> x;
  std::vector<std::int32_t> connectivity, rim, top;

  explicit Surface8(const Block20& block) {
    constexpr int side[6][8] = {{0, 3, 2, 1, 11, 10, 9, 8},   {4, 5, 6, 7, 12, 13, 14, 15},
                                {0, 1, 5, 4, 8, 17, 12, 16},  {1, 2, 6, 5, 9, 18, 13, 17},
                                {2, 3, 7, 6, 10, 19, 14, 18}, {3, 0, 4, 7, 11, 16, 15, 19}};
    std::map<std::set<std::int32_t>, std::vector<std::int32_t>> once;
    for (std::size_t e = 0; e < block.connectivity.size(); e += 20)
      for (const auto& face : side) {
        std::vector<std::int32_t> nodes;
        for (const int k : face) nodes.push_back(block.connectivity[e + static_cast<std::size_t>(k)]);
        const std::set<std::int32_t> key(nodes.begin(), nodes.end());
        if (!once.try_emplace(key, nodes).second) once.erase(key);
      }
    std::map<std::int32_t, std::int32_t> number;
    for (const auto& [key, nodes] : once)
      for (const std::int32_t k : nodes) {
        if (number.try_emplace(k, static_cast<std::int32_t>(number.size())).second)
          x.insert(x.end(), block.x.begin() + 3 * k, block.x.begin() + 3 * k + 3);
        connectivity.push_back(number[k]);
      }
    for (const std::int32_t k : block.rim) rim.push_back(number.at(k));
    for (const std::int32_t k : block.top) top.push_back(number.at(k));
  }
  std::int64_t nodes() const { return static_cast<std::int64_t>(x.size() / 3); }
};

/// Rolls a rigid ball on a body with a force ahead, on a frame of its own, or on the body's faces of a tag. The caller
/// releases the contact.
inline rollcon_contact* press_ball(rollcon_context* context, rollcon_body* body, rollcon_body* ball,
                                   const SquareFrame& frame, double force = 40, std::int32_t on_faces = 0) {
  rollcon_contact* c = nullptr;
  const double mu = 0.4;
  EXPECT_OK(rollcon_contact_create(context, body, ball, &c));
  if (on_faces > 0) {
    EXPECT_OK(rollcon_contact_frame_from_body(c, 1, on_faces));
  } else {
    give_frame(c, frame);
  }
  EXPECT_OK(rollcon_contact_set_gap_quadratic(c, 0.02, 0.02, 0));
  EXPECT_OK(rollcon_contact_set_friction(c, "coulomb", 1, &mu));
  EXPECT_OK(rollcon_contact_set_rolling(c, 1));
  EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_FORCE, force));
  EXPECT_OK(rollcon_contact_prescribe(c, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 0.2 * force));
  // The status is INACCURATE where the block's elements are deeper than half of the contact's width.
  const rollcon_status status = solve_small(c);
  EXPECT_TRUE(status == ROLLCON_OK || status == ROLLCON_INACCURATE) << status;
  return c;
}

}  // namespace capi_test
