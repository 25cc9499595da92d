// Tests tractions as coarse faces feel them: constants stay, the rest becomes smoother with the weight of smoothing.

#include "bodies/model/felt_tractions.hpp"

#include "geometry/surface_coupling.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

struct Felt {
  std::vector<double> traction;  ///< tractions at the nodes
  double force = 0;
};

/// Returns what is felt of tractions at the nodes of the faces themselves.
Felt felt(const SurfaceMesh& surface, double share, const std::vector<double>& t) {
  std::vector<std::int64_t> face(static_cast<std::size_t>(surface.elements()));
  std::iota(face.begin(), face.end(), 0);
  const SurfaceCoupling coupling = couple_faces(surface, face);
  std::vector<std::int32_t> column(t.size());
  std::iota(column.begin(), column.end(), 0);
  const std::vector<double> shares(face.size(), share);
  const FeltTractions f = felt_tractions(surface, face, shares, coupling, column);
  Felt result;
  for (std::int64_t i = 0; i < f.traction.rows(); ++i) {
    double value = 0;
    for (std::size_t c = 0; c < t.size(); ++c) {
      value += f.traction.row(i)[c] * t[c];
      result.force += f.load.row(i)[c] * t[c];
    }
    result.traction.push_back(value);
  }
  return result;
}

double roughness(const std::vector<double>& t) {
  double sum = 0;
  for (std::size_t k = 1; k < t.size(); ++k) sum += (t[k] - t[k - 1]) * (t[k] - t[k - 1]);
  return sum;
}

class FeltTractionsOf : public ::testing::TestWithParam<ElementType> {};

TEST_P(FeltTractionsOf, coarse_faces_are_smoother_with_the_same_resultant) {
  const std::vector<double> x = frames::uniform_lines(0, 3, 5), y = frames::uniform_lines(0, 2, 4);
  const SurfaceMesh surface = frames::rectangle(GetParam(), x, y);
  const auto n = static_cast<std::size_t>(surface.nodes());
  frames::Random random(9);
  std::vector<double> constant(n, 1.7), rough(n);
  for (double& value : rough) value = random();
  double of_constant = 0, of_rough = 0, last = roughness(rough);
  const double force = felt(surface, 0, rough).force;
  for (const double share : {0.0, 0.5, 1.0}) {
    for (const double value : felt(surface, share, constant).traction)
      of_constant = std::max(of_constant, std::abs(value / 1.7 - 1));
    const Felt found = felt(surface, share, rough);
    of_rough = std::max(of_rough, std::abs(found.force - force));
    const double now = roughness(found.traction);
    std::printf("%d nodes per face, share %.1f: roughness %.4g\n", node_count(GetParam()), share, now);
    if (share == 0) {
      for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(found.traction[k], rough[k], 1e-10);
    } else {
      EXPECT_LT(now, 0.8 * last);
    }
    last = now;
  }
  std::printf("constants off by %.1e, resultants by %.1e (bound 1e-11)\n", of_constant, of_rough);
  EXPECT_LE(of_constant, 1e-11);
  EXPECT_LE(of_rough, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(types, FeltTractionsOf,
                         ::testing::Values(ElementType::tri3, ElementType::tri6, ElementType::quad4,
                                           ElementType::quad8),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });

// A frame with four spaces on a face gives its nodes 1/16 of the area each, and the face's own nodes 1/1 or 1/4.
TEST(SmoothingShares, follow_the_frames_spacing_over_the_faces_in_any_unit) {
  for (const auto& [type, fine] : {std::pair{ElementType::quad4, 15.0 / 16}, {ElementType::quad8, 3.0 / 4 / 2}})
    for (const double unit : {1e-6, 1.0, 1e4}) {
      const auto coarse = frames::uniform_lines(0, 6 * unit, 6), dense = frames::uniform_lines(0, 6 * unit, 24);
      const SurfaceMesh body = frames::rectangle(type, coarse, coarse);
      std::vector<std::int64_t> face(static_cast<std::size_t>(body.elements()));
      std::iota(face.begin(), face.end(), 0);
      const TractionNodes fans = split_at_edges(body, 30);
      const auto shares = [&](const SurfaceMesh& layer) {
        return smoothing_shares(body, fans, face, couple_layer(body, face, layer));
      };
      const std::size_t inside = 2 * 6 + 2;  // a face whose nodes are no ends of the frame
      const double found = shares(frames::rectangle(ElementType::quad4, dense, dense))[inside];
      std::printf("%d nodes per face, unit %g: %.6f (%.6f)\n", node_count(type), unit, found, fine);
      EXPECT_NEAR(found, fine, 1e-9);
      if (type == ElementType::quad4) {
        EXPECT_EQ(shares(body)[inside], 0);
      }
    }
}

}  // namespace
}  // namespace rollcon
