#include "contact/operators/lattice/lattice_dense.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "contact/lattice_case.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {
namespace {

/// Compares the rows of nodes that belong to an element.
double difference(const Frame& frame, const DenseOperators& a, const DenseOperators& b) {
  double worst = 0;
  for (int r = 0; r < 3; ++r) {
    double scale = 0, error = 0;
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(a.block[r][c].empty(), b.block[r][c].empty()) << r << " " << c;
      for (std::int64_t k = 0; k < a.block[r][c].rows() * a.block[r][c].columns(); ++k) {
        if (!frame.used[static_cast<std::size_t>(k / a.block[r][c].columns())]) continue;
        scale = std::max(scale, std::abs(a.block[r][c].data()[k]));
        error = std::max(error, std::abs(a.block[r][c].data()[k] - b.block[r][c].data()[k]));
      }
    }
    worst = std::max(worst, error / scale);
  }
  return worst;
}

TEST(LatticeDense, EqualsAssembledOperators) {
  constexpr std::pair<const char*, bool> kinds[] = {{"godunov", false},        {"least_squares", false},
                                                    {"characteristic", false}, {"godunov", true},
                                                    {"least_squares", true},   {"characteristic", true}};
  for (const LatticeCase& c : lattice_cases)
    for (const auto& [name, holes] : kinds) {
      const Frame frame = lattice_frame(c.nx, c.ny, c.dx, c.dy, c.angle, holes);
      const std::optional<Lattice> lattice = find_lattice(frame);
      ASSERT_TRUE(lattice.has_value());
      const Convection convection = convection_of(frame, scheme_of(name));
      DenseOperators assembled, filled;
      assemble_operators(frame, *make_halfspace_compliance(frame, c.c, 1e-13, 1), convection, true, assembled);
      fill_lattice_operators(*lattice, *make_halfspace_kernel(c.c), convection, true, filled);
      const double error = difference(frame, assembled, filled);
      std::printf("%-30s %-14s holes %d: error %.1e, bound 1e-12\n", c.name, name, holes, error);
      EXPECT_LT(error, 1e-12);
      EXPECT_EQ(assembled.coupled, filled.coupled);
      EXPECT_EQ(assembled.bytes(), filled.bytes());
    }
}

TEST(LatticeDense, SmallestLattices) {
  for (const Scheme scheme : {Scheme::characteristic, scheme_of("godunov"), scheme_of("least_squares")})
    for (int cells = 1; cells <= 4; ++cells) {
      const Frame frame = lattice_frame(cells, 2, 0.1, 0.2, 0.1);
      const std::optional<Lattice> lattice = find_lattice(frame);
      ASSERT_TRUE(lattice.has_value());
      const Convection convection = convection_of(frame, scheme);
      DenseOperators assembled, filled;
      if (scheme == Scheme::characteristic && cells == 1)
        continue;  // two nodes along the flow: rim nodes have steps of their own
      assemble_operators(frame, *make_halfspace_compliance(frame, unlike, 1e-13, 1), convection, true, assembled);
      fill_lattice_operators(*lattice, *make_halfspace_kernel(unlike), convection, true, filled);
      EXPECT_LT(difference(frame, assembled, filled), 1e-12) << cells;
    }
}

}  // namespace
}  // namespace rollcon
