// Sweeps the selector of rules over the foot's place on and beside the element, the height above it, aspect ratio,
// distortion and curvature, and compares each integral with brute force. Errors of T are relative to the free term of a
// smooth point, 1/2, the largest entry of a row; those of U to the element's own largest integral.

#include "bodies/bem/integrals/element_reference.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using element_reference::Integrals;
using element_reference::Reference;

constexpr double tolerance[3] = {1e-3, 1e-6, 1e-9};
constexpr double free_term = 0.5;

class KelvinRules : public ::testing::TestWithParam<ElementType> {
 protected:
  struct Result {
    double t = 0, u = 0;  ///< largest error over tolerance
    std::int64_t points = 0, cases = 0;
  };
  Result result_[3];

  void compare(int k, const Integrals& found, const Integrals& reference) {
    Result& r = result_[k];
    // A NaN must not pass, so it counts as larger than anything.
    auto raise = [](double& worst, double error) { worst = error <= worst ? worst : error; };
    raise(r.t, element_reference::difference(found.t, reference.t) / (free_term * tolerance[k]));
    raise(r.u, element_reference::difference(found.u, reference.u) /
                   (element_reference::largest(reference.u) * tolerance[k]));
    r.points += found.points;
    ++r.cases;
  }

  void check(const char* what) {
    for (int k = 0; k < 3; ++k) {
      const Result& r = result_[k];
      std::printf("%d nodes, %s: tolerance %.0e, error/tolerance T %.2g U %.2g (bound 1), %.0f points on average\n",
                  node_count(GetParam()), what, tolerance[k], r.t, r.u,
                  static_cast<double>(r.points) / static_cast<double>(r.cases));
      EXPECT_GT(r.cases, 0);
      EXPECT_LE(r.t, 1);
      EXPECT_LE(r.u, 1);
    }
  }

  bool triangle() const { return corner_count(GetParam()) == 3; }

  template <class Visit>
  void for_all_shapes(Visit visit) {
    for (const double aspect : {1.0, 5.0, 50.0})
      for (int shape = 0; shape < 3; ++shape) {
        if (shape == 2 && GetParam() == ElementType::tri3) continue;  // cannot bend
        const double distortion = shape == 0 ? 0 : 0.08;
        const double curvature = shape < 2 ? 0 : is_quadratic(GetParam()) ? 0.15 : 0.05;
        visit(element_reference::one_element(GetParam(), aspect, distortion, curvature,
                                             static_cast<std::uint32_t>(7 + 3 * shape + aspect)));
      }
  }
};

TEST_P(KelvinRules, beside_and_above_the_element) {
  const std::vector<Reference> feet =
      triangle() ? std::vector<Reference>{{0.3, 0.3}, {0.5, -0.02}, {-0.1, 1.05}, {1.5, -0.3}}
                 : std::vector<Reference>{{0.1, -0.2}, {0.97, 0.4}, {-1.05, -1.05}, {-0.4, -2.0}};
  const double height[] = {0, 1e-4, 3e-3, 0.03, 0.1, 0.3, 1, 3, 10, 40};
  for_all_shapes([&](const SurfaceMesh& element) {
    for (std::size_t f = 0; f < feet.size(); ++f)
      for (const double h : height) {
        const bool inside = triangle() ? f == 0 : f < 2;
        if (h == 0 && inside) continue;
        const Vec3 n = element_reference::normal(element, feet[f]);
        const Vec3 x = element_reference::position(element, feet[f]) + (h / length(n)) * n;
        const auto reference = element_reference::integrate(element, x, 0.3);
        const double scale = element_reference::largest(reference.u);
        for (int k = 0; k < 3; ++k)
          compare(k, element_reference::from_library(element, x, 0.3, free_term * tolerance[k], scale * tolerance[k]),
                  reference);
      }
  });
  check("off the element");
}

TEST_P(KelvinRules, on_the_element) {
  std::vector<Reference> points = {{0.3, 0.3}, {0.05, 0.4}, {0.5, 0}};
  if (!triangle()) points = {{0.1, -0.2}, {0.97, 0.4}, {-1, 0.3}};
  for_all_shapes([&](const SurfaceMesh& element) {
    const std::size_t given = points.size();
    const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double triangle_corner[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    for (int i = 0; i < corner_count(GetParam()); ++i) {
      const double* c = triangle() ? triangle_corner[i] : corner[i];
      points.push_back({c[0], c[1]});
    }
    for (const Reference& at : points) {
      const auto reference = element_reference::integrate_on(element, at, 0.3);
      const double scale = element_reference::largest(reference.u);
      for (int k = 0; k < 3; ++k)
        compare(k, element_reference::from_library_on(element, at, 0.3, free_term * tolerance[k], scale * tolerance[k]),
                reference);
    }
    points.resize(given);
  });
  check("on the element");
}

/// The point lies on the element without the library being told so; only U is compared.
TEST_P(KelvinRules, single_layer_at_an_unknown_place_on_the_element) {
  constexpr double not_wanted = 1e300;
  const std::vector<Reference> points = triangle() ? std::vector<Reference>{{0.3, 0.3}, {0.05, 0.4}, {0.5, 1e-9}}
                                                   : std::vector<Reference>{{0.1, -0.2}, {0.97, 0.4}, {-1, 0.3}};
  for_all_shapes([&](const SurfaceMesh& element) {
    for (const Reference& at : points) {
      const auto reference = element_reference::integrate_on(element, at, 0.3);
      const double scale = element_reference::largest(reference.u);
      for (int k = 0; k < 3; ++k) {
        auto found = element_reference::from_library(element, element_reference::position(element, at), 0.3, not_wanted,
                                                     scale * tolerance[k]);
        std::copy_n(&reference.t[0][0], 9 * max_element_nodes, &found.t[0][0]);
        compare(k, found, reference);
      }
    }
  });
  check("place unknown");
}

/// The far field chooses from the distance alone; T and U are tested each by itself.
TEST_P(KelvinRules, far_field) {
  const double distance[] = {2.6, 3.5, 6, 15, 60, 300};
  std::int64_t left_to_near_field = 0;
  for_all_shapes([&](const SurfaceMesh& element) {
    const Reference middle = triangle() ? Reference{1.0 / 3, 1.0 / 3} : Reference{0, 0};
    const Vec3 centre = element_reference::position(element, middle);
    for (const double d : distance)
      for (int direction = 0; direction < 7; ++direction) {
        // The directions are the coordinate axes and others, in the element's plane and out of it.
        const double a = 0.9 * direction, b = 0.45 * direction;
        const Vec3 x = centre + d * Vec3{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
        const auto reference = element_reference::integrate(element, x, 0.3);
        const double scale = element_reference::largest(reference.u);
        for (int k = 0; k < 3; ++k) {
          auto found = element_reference::from_far_field(element, x, 0.3, bem::double_layer, free_term * tolerance[k]);
          const auto u = element_reference::from_far_field(element, x, 0.3, bem::single_layer, scale * tolerance[k]);
          if (found.points == 0 || u.points == 0) {
            ++left_to_near_field;
            continue;
          }
          found.points = std::max(found.points, u.points);
          std::copy_n(&u.u[0][0], 9 * max_element_nodes, &found.u[0][0]);
          compare(k, found, reference);
        }
      }
  });
  check("far field");
  std::printf("%lld of %lld left to the near field\n", static_cast<long long>(left_to_near_field),
              static_cast<long long>(left_to_near_field + result_[0].cases + result_[1].cases + result_[2].cases));
}

INSTANTIATE_TEST_SUITE_P(types, KelvinRules, ::testing::Values(ElementType::tri6, ElementType::quad4),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });
INSTANTIATE_TEST_SUITE_P(types_long, KelvinRules,
                         ::testing::Values(ElementType::tri3, ElementType::quad8, ElementType::quad9),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });

}  // namespace
}  // namespace rollcon
