/// Tests the search for the largest stresses under contacts beside Hertz's closed forms, and measures of histories
/// beside what brute force makes of the same stresses.

#include "rollcon.h"
#include "support/closed_forms.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using scenes::RollingPair;
const closed_forms::Elastic steel{80e3, 0.3};

struct Found {
  double value = 0;
  Vec3 place{};
};

Found find(const RollingPair& pair, const char* measure, const std::vector<double>& parameter = {}, int body = 2) {
  Found f;
  EXPECT_EQ(rollcon_contact_find_stress(pair.handle(), body, measure, static_cast<std::int32_t>(parameter.size()),
                                        parameter.data(), &f.value, f.place.data()),
            ROLLCON_OK)
      << rollcon_last_error();
  return f;
}

closed_forms::Hertz press(RollingPair& pair, double A, double B, double load) {
  pair.friction(0).load(load).gap_quadratic(A, B);
  EXPECT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
  return closed_forms::hertz_from_load(A, B, closed_forms::effective_modulus(steel, steel), load);
}

// A ball on a plane, Poisson's ratio 0.3: 0.310 p0 at 0.481 a; orthogonal shear 0.214 p0.
TEST(stress_search, ball) {
  RollingPair pair(steel, steel);
  const closed_forms::Hertz h = press(pair, 1 / 20.0, 1 / 20.0, 100);
  for (const int body : {1, 2}) {
    const double side = body == 1 ? -1 : 1;
    const Found shear = find(pair, "shear", {}, body), mises = find(pair, "von_mises", {}, body);
    expect_error("largest shear", relative(shear.value, 0.3100 * h.p0), 3e-3);
    expect_error("its depth", relative(side * shear.place[2], 0.481 * h.a), 2e-2);
    expect_error("it is below the middle", std::hypot(shear.place[0], shear.place[1]) / h.a, 2e-2);
    expect_error("von Mises", relative(mises.value, 0.6200 * h.p0), 3e-3);
  }
  expect_error("orthogonal shear", relative(find(pair, "orthogonal_shear").value, 0.214 * h.p0), 5e-3);
}

// A long ellipse is a line contact in the middle: 0.300 p0 at 0.786 b, orthogonal shear 0.25 p0 at 0.5 b and 0.866 b.
TEST(stress_search_long, line) {
  RollingPair pair(steel, steel);
  const closed_forms::Hertz h = press(pair, 1 / 20.0, 1 / 20e3, 1000);
  const double b = std::min(h.a, h.b);
  report("ratio of the semi-axes", std::max(h.a, h.b) / b);
  const Found shear = find(pair, "shear"), orthogonal = find(pair, "orthogonal_shear");
  expect_error("largest shear", relative(shear.value, 0.3003 * h.p0), 1.5e-2);
  expect_error("its depth", relative(shear.place[2], 0.786 * b), 3e-2);
  expect_error("orthogonal shear", relative(orthogonal.value, 0.25 * h.p0), 5e-3);
  expect_error("its depth", relative(orthogonal.place[2], 0.5 * b), 3e-2);
  expect_error("its place", relative(std::abs(orthogonal.place[0]), 0.866 * b), 3e-2);
}

std::vector<std::array<double, 6>> history(const RollingPair& pair, double y, double z, double reach) {
  std::vector<double> xyz;
  constexpr int n = 200;
  for (int i = 0; i <= n; ++i) xyz.insert(xyz.end(), {reach * (2.0 * i / n - 1), y, z});
  std::vector<std::array<double, 6>> s(n + 1);
  EXPECT_EQ(
      rollcon_contact_get_fields_at(pair.handle(), 2, n + 1, xyz.data(), ROLLCON_IN_CONTACT, nullptr, s[0].data()),
      ROLLCON_OK);
  s.push_back({});
  return s;
}

double hydrostatic(const std::array<double, 6>& s) {
  return (s[0] + s[1] + s[2]) / 3;
}

/// Moves a centre towards the farthest deviator by ever smaller steps.
double radius_of_ball(const std::vector<std::array<double, 6>>& path, std::array<double, 6>& centre) {
  centre = {};
  double far = 0;
  for (int step = 1; step < 30000; ++step) {
    std::array<double, 6> toward{};
    far = -1;
    for (const auto& s : path) {
      std::array<double, 6> d;
      double square = 0;
      for (std::size_t c = 0; c < 6; ++c) {
        d[c] = s[c] - (c < 3 ? hydrostatic(s) : 0) - centre[c];
        square += (c < 3 ? 1 : 2) * d[c] * d[c];
      }
      if (square > far) far = square, toward = d;
    }
    for (std::size_t c = 0; c < 6; ++c) centre[c] += toward[c] / (step + 1);
  }
  return std::sqrt(far);
}

TEST(stress_search_long, measures_of_histories) {
  RollingPair pair(steel, steel);
  pair.creep(1e-2, 0, 0).friction(0.1).load(100).gap_quadratic(1 / 20.0, 1 / 60.0);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  const double a = 0.3, weight = 0.25;
  const Found crossland = find(pair, "crossland", {weight}), dang_van = find(pair, "dang_van", {weight});
  const auto of = [&](double y, double z, bool by_crossland) {
    const auto path = history(pair, y, z, 6 * a);
    std::array<double, 6> centre;
    const double radius = radius_of_ball(path, centre);
    double most = -INFINITY, shear = -INFINITY;
    for (auto s : path) {
      most = std::max(most, hydrostatic(s));
      const double h = hydrostatic(s);
      for (std::size_t c = 0; c < 6; ++c) s[c] -= centre[c];
      double tau = 0;
      EXPECT_EQ(rollcon_stress_invariants(1, s.data(), nullptr, nullptr, &tau), ROLLCON_OK);
      shear = std::max(shear, tau + weight * h);
    }
    return by_crossland ? radius / std::sqrt(2.0) + weight * most : shear;
  };
  for (const bool by_crossland : {true, false}) {
    const Found& f = by_crossland ? crossland : dang_van;
    const std::string name = by_crossland ? "Crossland" : "Dang Van";
    expect_error(name + ": at its place", relative(f.value, of(f.place[1], f.place[2], by_crossland)), 5e-3);
    for (const double up : {0.7, 1.3})
      EXPECT_LT(of(f.place[1], up * f.place[2] + 0.01, by_crossland), 1.003 * f.value) << name << " " << up;
    EXPECT_LT(of(f.place[1] + 0.1, f.place[2], by_crossland), 1.003 * f.value) << name;
  }
}

// The integral of Lundberg and Palmgren by sums over another grid of points.
TEST(stress_search_long, integral_of_lundberg_and_palmgren) {
  RollingPair pair(steel, steel);
  const closed_forms::Hertz h = press(pair, 1 / 20.0, 1 / 60.0, 100);
  const double c = 31.0 / 3, e = 7.0 / 3, width = std::min(h.a, h.b), across = std::max(h.a, h.b);
  const Found life = find(pair, "lundberg_palmgren", {c, e, 0});
  double sum = 0;
  constexpr int ny = 20, nz = 30;
  for (int j = 0; j < ny; ++j)
    for (int k = 0; k < nz; ++k) {
      const double y = across * (j + 0.5) / ny, z = 2 * width * (k + 0.5) / nz;
      double shear = 0;
      for (const auto& s : history(pair, y, z, 2 * across)) shear = std::max(shear, std::abs(s[4]));
      sum += 2 * across / ny * 2 * width / nz * std::pow(shear, c) * std::pow(z, -e);
    }
  expect_error("integral", relative(life.value, sum), 3e-2);
  const Found orthogonal = find(pair, "orthogonal_shear");
  expect_error("place of the largest amplitude", relative(life.place[2], orthogonal.place[2]), 0.15);
}

TEST(stress_search, bad_input_is_told) {
  RollingPair pair(steel, steel);
  double value = -7, place[3];
  const auto failed = [&](std::int32_t status, std::int32_t expected, const char* text) {
    EXPECT_EQ(status, expected);
    EXPECT_NE(std::string(rollcon_last_error()).find(text), std::string::npos) << rollcon_last_error();
    EXPECT_EQ(value, -7);
  };
  rollcon_contact* const c = pair.handle();
  failed(rollcon_contact_find_stress(c, 1, "shear", 0, nullptr, &value, place), ROLLCON_ERR_STATE, "no solution");
  press(pair, 1 / 20.0, 1 / 20.0, 100);
  const double one[3] = {1, 2, -1};
  failed(rollcon_contact_find_stress(c, 3, "shear", 0, nullptr, &value, place), ROLLCON_ERR_ARGUMENT, "3");
  failed(rollcon_contact_find_stress(c, 1, "tresca", 0, nullptr, &value, place), ROLLCON_ERR_OPTION,
         "measure is \"tresca\"; allowed: von_mises, shear");
  failed(rollcon_contact_find_stress(c, 1, "dang_van", 0, nullptr, &value, place), ROLLCON_ERR_ARGUMENT,
         "\"dang_van\" was given 0 parameter(s); allowed: the weight");
  failed(rollcon_contact_find_stress(c, 1, "lundberg_palmgren", 3, one, &value, place), ROLLCON_ERR_ARGUMENT,
         "1, 2, -1");
}

}  // namespace
}  // namespace rollcon
