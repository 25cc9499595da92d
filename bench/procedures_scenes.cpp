// Makes the paper's examples for the cases of the solution procedures.

#include <cmath>

#include "procedures.hpp"
#include "support/example1.hpp"
#include "support/example2.hpp"
#include "support/example3.hpp"
#include "support/example4.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;
namespace example2 = scenes::example2;
namespace example3 = scenes::example3;
namespace example4 = scenes::example4;
using Pair = std::unique_ptr<scenes::RollingPair>;

/// Section 11.8 needs a matrix of convection, which the characteristic scheme does not have.
constexpr const char* scheme = "godunov";

/// Makes 15 mm of the ring's circumference, or all of it.
surfaces::Ring coarse(bool whole) {
  surfaces::Ring shape = example1::paper_ring();
  shape.sector = whole ? 0 : 0.3;
  shape.zone_around = 8;
  shape.across = 4;
  shape.around = whole ? 16 : 14;
  shape.deep = 2;
  return shape;
}

scenes::MeshedBody bem_ring(bool whole = false) {
  return example1::ring_body(coarse(whole), ElementType::quad4);
}

scenes::MeshedBody fem_ring() {
  surfaces::Ring shape = coarse(false);
  shape.deep = 4;
  shape.top_layer = 0.4;
  return example1::ring_body(shape, VolumeType::hex8);
}

Pair bem_on_bem(int threads) {
  return example1::pair(bem_ring(), scenes::TwinBody{}, scheme, threads);
}

Pair whole_rings(int threads) {
  return example1::pair(bem_ring(true), scenes::TwinBody{}, scheme, threads);
}

Pair fem_on_fem(int threads) {
  return example1::pair(fem_ring(), scenes::TwinBody{}, scheme, threads);
}

Pair fem_on_bem(int threads) {
  return example1::pair(fem_ring(), bem_ring(), scheme, threads);
}

Pair ring_on_ground(const surfaces::Ring& shape, int threads) {
  auto pair = example2::pair(shape, VolumeType::hex8, example2::Ground::half_space, threads);
  pair->option("convection", scheme);
  return pair;
}

Pair coarse_ring_on_ground(int threads) {
  surfaces::Ring shape = example2::ring_of(8);
  shape.across = 4;
  shape.around = 16;
  shape.largest = example1::longest(shape.around - shape.zone_around);
  return ring_on_ground(shape, threads);
}

Pair sphere(int threads) {
  const double reach = 1.3 * example3::hertz().a;
  return example3::pair(frames::o_grid(ElementType::quad4, 10, 4, reach, reach), scheme, threads);
}

/// Makes a part of the wheel of example 4 around its top: 20 x 20 x 14 mm, 9 x 9 elements in 6 x 6 mm.
Pair coarse_wheel(int threads) {
  return example4::pair(example4::part_of_wheel({20, 14, 6, 9, 1, 2}), scheme, threads);
}

Pair rolling_wheel(Pair pair) {
  pair->creep(-9e-4, 0, 0);
  return pair;
}

}  // namespace

std::vector<Example> coarse_examples() {
  return {{"example 1, BEM on BEM", bem_on_bem},
          {"example 1, FEM on FEM", fem_on_fem},
          {"example 1, FEM on BEM", fem_on_bem},
          {"example 2, FEM on half-space", coarse_ring_on_ground},
          {"example 3, half-space on rigid", sphere},
          {"example 4, BEM on rigid", [](int threads) { return rolling_wheel(coarse_wheel(threads)); }},
          {"example 1, whole rings", whole_rings, true}};
}

std::vector<Example> paper_examples() {
  return {{"example 1, BEM on BEM",
           [](int threads) { return example1::pair(example1::paper_ring(), ElementType::quad4, scheme, threads); }},
          {"example 1, FEM on FEM",
           [](int threads) {
             return example1::pair(example1::ring_body(example1::fem_ring(12), VolumeType::hex8), scenes::TwinBody{},
                                   scheme, threads);
           }},
          {"example 2, FEM on half-space", [](int threads) { return ring_on_ground(example2::ring_of(), threads); }},
          {"example 4, BEM on rigid",
           [](int threads) { return rolling_wheel(example4::pair(ElementType::quad4, scheme, threads)); }}};
}

}  // namespace rollcon::bench
