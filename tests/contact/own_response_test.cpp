// Tests of the characteristic scheme that a node's traction drags the surface at the node further than at the point
// upstream of it, wherever the node lies. Otherwise its slip would grow with the friction that opposes it, and no
// solution need exist.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include "contact/lattice_case.hpp"
#include "support/graded_disc.hpp"

namespace rollcon {
namespace {

/// Returns n + 1 lines from -1 to 1 in spacings that grow by a factor.
std::vector<double> growing_lines(int n, double factor) {
  std::vector<double> lines{0};
  double spacing = 1;
  for (int k = 0; k < n; ++k, spacing *= factor) lines.push_back(lines.back() + spacing);
  for (double& x : lines) x = 2 * x / lines.back() - 1;
  return lines;
}

struct Named {
  std::string name;
  SurfaceMesh mesh;
};

std::vector<Named> meshes() {
  using namespace frames;
  std::vector<Named> all;
  const auto even = uniform_lines(-1, 1, 5), slender = uniform_lines(-0.05, 0.05, 5);
  constexpr std::pair<const char*, ElementType> types[] = {{"tri3", ElementType::tri3},
                                                           {"tri6", ElementType::tri6},
                                                           {"quad4", ElementType::quad4},
                                                           {"quad8", ElementType::quad8}};
  for (const auto& [text, type] : types) {
    const std::string name = text;
    all.push_back({name + ", even", rectangle(type, even, even)});
    all.push_back({name + ", slender", rectangle(type, even, slender)});
    for (const double factor : {1.5, 4.0, 0.25})
      all.push_back({name + ", growing by " + std::to_string(factor).substr(0, 4),
                     rectangle(type, growing_lines(5, factor), even)});
    all.push_back({name + ", shaken", perturb(rectangle(type, even, even), 0.35, 3)});
  }
  for (const ElementType type : {ElementType::tri3, ElementType::tri6})
    all.push_back({"rings", scenes::graded_disc(1, 1, 5, type)});
  return all;
}

void expect_positive(std::initializer_list<double> angles) {
  // The least response to both components is bounded over the median one.
  constexpr double bound = 0.01;
  for (const double angle : angles)
    for (const Named& named : meshes()) {
      const bool regular = named.name.starts_with("quad4, even") || named.name == "quad4, slender";
      if (regular && angle == 0.3) continue;  // corners of regular grids keep the grid's step
      const Frame frame = build_frame(frames::rotate(named.mesh, angle), Axes{});
      DenseOperators op;
      assemble_operators(frame, *make_halfspace_compliance(frame, alike, 1e-13, 1),
                         convection_of(frame, Scheme::characteristic), true, op);
      double least = INFINITY, median = 0;
      for (int c = 0; c < 2; ++c) {
        std::vector<double> own;
        for (std::int64_t k = 0; k < frame.nodes(); ++k) own.push_back(op.block[c][c].row(k)[k]);
        std::vector<double> sorted = own;
        std::sort(sorted.begin(), sorted.end());
        median = sorted[sorted.size() / 2];
        least = std::min(least, sorted.front() / median);
      }
      std::printf("%-28s turned by %.1f: least over median %.3f, bound %.3f\n", named.name.c_str(), angle, least,
                  bound);
      EXPECT_GT(least, bound) << named.name;
    }
}

TEST(own_response, is_positive_everywhere) {
  expect_positive({0.3});
}

TEST(own_response_long, is_positive_everywhere) {
  expect_positive({0.0, 3.14159265358979323846});
}

}  // namespace
}  // namespace rollcon
