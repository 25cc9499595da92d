/// Tests how values go from the nodes of one regular grid to those of another.

#include "mesh/lattice_values.hpp"

#include "support/index.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Makes a grid along the axes whose nodes are numbered from the last one on.
Lattice grid(double x0, double y0, double dx, double dy, std::int64_t nx, std::int64_t ny) {
  Lattice l;
  l.nx = nx, l.ny = ny, l.dx = dx, l.dy = dy, l.x0 = x0, l.y0 = y0;
  for (std::int64_t k = 0; k < nx * ny; ++k) l.node.push_back(static_cast<std::int32_t>(nx * ny - 1 - k));
  return l;
}

template <class Function>
std::vector<double> values(const Lattice& l, Function f) {
  std::vector<double> v(l.node.size());
  for (std::int64_t j = 0; j < l.ny; ++j)
    for (std::int64_t i = 0; i < l.nx; ++i)
      v[at(l.node[at(j * l.nx + i)])] = f(l.x0 + static_cast<double>(i) * l.dx, l.y0 + static_cast<double>(j) * l.dy);
  return v;
}

double integral(const Lattice& l, const std::vector<double>& v) {
  return l.dx * l.dy * std::accumulate(v.begin(), v.end(), 0.0);
}

TEST(lattice_values, finer_and_wider_grids_take_bilinear_fields_exactly) {
  const Lattice from = grid(-1, 2, 0.25, 0.5, 9, 7), to = grid(-0.75, 3, 0.125, 0.25, 9, 5);
  const auto field = [](double x, double y) { return 1 + x - 2 * y + 0.5 * x * y; };
  std::vector<double> carried;
  carry_to_lattice(from, values(from, field), to, carried);
  const std::vector<double> exact = values(to, field);
  double worst = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) worst = std::max(worst, std::abs(carried[k] - exact[k]));
  expect_error("on halved cells", worst, 1e-13);
  // Nodes beyond the first grid get nothing; the others what was there, to the bit.
  const Lattice wide = grid(-1 - 3 * 0.25, 2 - 2 * 0.5, 0.25, 0.5, 15, 12);
  carry_to_lattice(from, values(from, field), wide, carried);
  const std::vector<double> wanted = values(
      wide, [&](double x, double y) { return x < -1.01 || x > 1.01 || y < 1.99 || y > 5.01 ? 0.0 : field(x, y); });
  EXPECT_EQ(carried, wanted);
}

TEST(lattice_values, larger_cells_keep_the_integral) {
  const Lattice from = grid(0, 0, 0.1, 0.2, 21, 11);
  const auto bump = [](double x, double y) {
    return std::max(0.0, 0.25 - (x - 1.03) * (x - 1.03)) * (1 + y * (2 - y));
  };
  std::vector<double> field = values(from, bump), carried;
  for (std::int64_t i = 0; i < from.nx; ++i)
    for (const std::int64_t j : {std::int64_t{0}, from.ny - 1}) field[at(from.node[at(j * from.nx + i)])] = 0;
  for (const std::int64_t ratio : {2, 4}) {
    const auto times = static_cast<double>(ratio);
    const Lattice to = grid(-0.1 * times, -0.2 * times, 0.1 * times, 0.2 * times, 24 / ratio + 2, 14 / ratio + 2);
    carry_to_lattice(from, field, to, carried);
    expect_error("integral on cells " + std::to_string(ratio) + " times as large",
                 integral(to, carried) / integral(from, field) - 1, 1e-13);
  }
}

TEST(lattice_values, grids_with_holes_or_turned_do_not_lie_along_the_axes) {
  Lattice l = grid(0, 0, 1, 1, 3, 3);
  EXPECT_TRUE(lies_along_axes(l));
  l.node[4] = -1;
  EXPECT_FALSE(lies_along_axes(l));
  l = grid(0, 0, 1, 1, 3, 3);
  l.ex = 0.8, l.ey = 0.6;
  EXPECT_FALSE(lies_along_axes(l));
}

}  // namespace
}  // namespace rollcon
