// Compares a uniformly loaded unit square with CONTACT's table, closed forms, and the largest von Mises stress.

#include "bodies/halfspace/inside/direct.hpp"
#include "support/frames.hpp"
#include "support/stress_invariants.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using inside::Solid;
using inside::Values;

constexpr Solid solid{1, 0.28};

Frame square() {
  const double side[] = {-0.5, 0.5};
  return build_frame(frames::rectangle(ElementType::quad4, side, side), Axes{});
}

std::vector<double> uniform(const Frame& frame, double x, double y, double z) {
  std::vector<double> t;
  for (std::int64_t k = 0; k < frame.nodes(); ++k) t.insert(t.end(), {x, y, z});
  return t;
}

TEST(inside_square_load, axis_matches_contact_reference) {
  // The columns are z, u_x of p_x, u_z of p_n, s_xx, s_zz, s_xz of both. p_x acts along x on the body.
  const double table[][6] = {{0, .482073, .403982, -.779815, -1.0, -.998999},
                             {.1, .383274, .379552, -.555944, -.994287, -.736402},
                             {.2, .307159, .351264, -.366593, -.960374, -.511760},
                             {.3, .249985, .321398, -.227289, -.891525, -.342706},
                             {.4, .207347, .292201, -.134431, -.799677, -.226067},
                             {.5, .175332, .265146, -.076184, -.700842, -.149363},
                             {.6, .150930, .240888, -.040853, -.606403, -.0998800},
                             {.7, .131980, .219530, -.019799, -.521977, -.0679770},
                             {.8, .116977, .200885, -.0073882, -.449212, -.0471990},
                             {.9, .104878, .184650, -.00015638, -.387679, -.0334500},
                             {1.0, .0949550, .170498, .0039769, -.336086, -.0241830},
                             {1.25, .0766230, .142315, .0077195, -.240934, -.0116370},
                             {1.667, .0578060, .110644, .0073417, -.149346, -.0042206},
                             {2.5, .0386920, .0758550, .0044578, -.0716110, -.00092701},
                             {5.0, .0193850, .0386000, .0013245, -.0187850, -.000061810}};
  const Frame frame = square();
  std::vector<std::array<double, 3>> points;
  for (const auto& row : table) points.push_back({0, 0, row[0]});
  const std::vector<Values> both = inside::from_library(frame, uniform(frame, 1, 0, 1), solid, points, 1e-8);
  double worst[5] = {};
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double value[] = {both[p][6], both[p][8], both[p][0], both[p][2], both[p][4]};
    for (std::size_t k = 0; k < 5; ++k) worst[k] = std::max(worst[k], std::abs(value[k] - table[p][k + 1]));
    std::printf("z %5.3f: %9.6f %9.6f %10.7f %9.6f %10.7f\n", points[p][2], value[0], value[1], value[2], value[3],
                value[4]);
  }
  // The table comes from a program on grids: its traction along x is 1e-3 too small, which s_xz at z = 0 shows.
  const char* name[] = {"u_x", "u_z", "s_xx", "s_zz", "s_xz"};
  const double bound[] = {1e-3, 3e-5, 4e-4, 1e-4, 2e-3};
  for (std::size_t k = 0; k < 5; ++k) expect_error(std::string("unit square, table, ") + name[k], worst[k], bound[k]);
}

/// Returns Newmark's pressure below a corner of a rectangle a x b, over the load.
double newmark(double a, double b, double z) {
  const double r1 = a * a + z * z, r2 = b * b + z * z, r3 = std::sqrt(a * a + b * b + z * z);
  return (std::atan2(a * b, z * r3) + a * b * z / r3 * (1 / r1 + 1 / r2)) / (2 * std::numbers::pi);
}

TEST(inside_square_load, normal_stress_matches_newmark) {
  const Frame frame = square();
  std::vector<std::array<double, 3>> points;
  for (const double z : {1e-6, 1e-3, 0.03, 0.2, 1.0, 7.0})
    for (const double x : {0.0, 0.31, 0.499, 0.5, 0.501, 0.8})
      for (const double y : {0.0, -0.2, 0.5}) points.push_back({x, y, z});
  const std::vector<Values> s = inside::from_library(frame, uniform(frame, 0, 0, 1), solid, points, 1e-8);
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto& [x, y, z] = points[p];
    double sum = 0;  // sum of four rectangles with a corner above the point, with their signs
    for (const double u : {0.5 - x, 0.5 + x})
      for (const double v : {0.5 - y, 0.5 + y})
        sum += std::copysign(1.0, u) * std::copysign(1.0, v) * newmark(std::abs(u), std::abs(v), z);
    worst = std::max(worst, std::abs(s[p][2] + sum));
  }
  expect_error("unit square, s_zz at, in and beside its edges, accuracy 1e-8", worst, 1.8e-9);
}

TEST(inside_square_load, centre_matches_closed_forms) {
  // The stress below the centre of a uniform pressure is -(1/2 + nu); displacements are Love's.
  const Frame frame = square();
  const Values s = inside::from_library(frame, uniform(frame, 1, 0, 1), solid, {{0, 0, 0}}, 1e-9)[0];
  const double love = 4 * std::asinh(1.0) / (2 * std::numbers::pi * solid.shear);
  expect_error("unit square, s_xx at the centre of its surface", s[0] + 0.5 + solid.poisson, 6e-8);
  expect_error("unit square, u_z", s[8] - (1 - solid.poisson) * love, 6e-9);
  expect_error("unit square, u_x", s[6] - (1 - solid.poisson / 2) * love, 3e-8);
}

TEST(inside_square_load, largest_von_mises_stress) {
  const Frame frame = square();
  // The largest stress at the table's depths is .665 at z = .4; between them it is larger.
  for (const auto& [step, value, at, coarse] :
       {std::tuple{0.1, 0.665, 0.4, "of the table's depths"}, std::tuple{0.01, 0.6717, 0.35, "of all depths"}}) {
    std::vector<std::array<double, 3>> points;
    for (int k = 1; k * step < 1.001; ++k) points.push_back({0, 0, step * k});
    const std::vector<Values> s = inside::from_library(frame, uniform(frame, 0, 0, 1), solid, points, 1e-6);
    double most = 0, depth = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (const double v = stress_invariants(s[p].data()).von_mises; v > most) most = v, depth = points[p][2];
    std::printf("unit pressure: largest von Mises stress %.4f at z = %.2f %s\n", most, depth, coarse);
    expect_error("unit square, largest von Mises stress", relative(most, value), 1e-3);
    expect_error("unit square, its depth", depth - at, 1e-6);
  }
}

}  // namespace
}  // namespace rollcon
