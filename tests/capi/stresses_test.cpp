// Tests stresses below a solved contact through the public interface, and their invariants.

#include "fixture.hpp"

namespace {

using namespace capi_test;

constexpr double pi = std::numbers::pi;

/// Presses two half-spaces of their own materials, on a frame of the caller; creepages along both directions.
class stresses : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body[0]));
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body[1]));
    ASSERT_OK(rollcon_body_set_elastic(body[0], 0, 1e4, 0.3));
    ASSERT_OK(rollcon_body_set_elastic(body[1], 0, 3e4, 0.1));
    ASSERT_OK(rollcon_contact_create(context, body[0], body[1], &contact));
  }
  void TearDown() override {
    rollcon_contact_release(contact);
    for (rollcon_body* b : body) rollcon_body_release(b);
    rollcon_context_release(context);
  }

  void solve() {
    give_scene(contact, frame);
    ASSERT_OK(rollcon_contact_set_creep(contact, 1e-3, 5e-4, 1e-4));
    ASSERT_OK(rollcon_contact_solve(contact));
  }
  std::vector<double> tractions() {
    std::vector<double> t(static_cast<std::size_t>(3 * frame.nodes));
    EXPECT_OK(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes, t.data()));
    return t;
  }
  double largest_pressure() {
    double p = 0;
    EXPECT_OK(rollcon_contact_get_stat(contact, "max_pressure", &p));
    return p;
  }
  std::vector<double> stress_at(std::int32_t which, const std::vector<double>& xyz) {
    std::vector<double> s(2 * xyz.size());
    EXPECT_OK(rollcon_contact_get_fields_at(contact, which, static_cast<std::int64_t>(xyz.size() / 3), xyz.data(),
                                            ROLLCON_IN_CONTACT, nullptr, s.data()));
    return s;
  }

  SquareFrame frame{24, 1.5};
  rollcon_context* context = nullptr;
  rollcon_body* body[2] = {};
  rollcon_contact* contact = nullptr;
};

TEST_F(stresses, surface_carries_the_tractions_in_both_bodies) {
  solve();
  const std::vector<double> t = tractions();
  double worst = 0;
  for (const std::int32_t which : {1, 2}) {
    const std::vector<double> s = stress_at(which, frame.x);
    for (std::size_t k = 0; k < t.size() / 3; ++k)
      worst = std::max({worst, std::abs(s[6 * k + 4] - t[3 * k]), std::abs(s[6 * k + 5] - t[3 * k + 1]),
                        std::abs(s[6 * k + 2] - t[3 * k + 2])});
  }
  worst /= largest_pressure();
  std::printf("tractions of both bodies at the nodes: error %.1e of the pressure (bound 3e-7)\n", worst);
  EXPECT_LE(worst, 3e-7);
}

TEST_F(stresses, surface_displacements_are_those_of_the_surface) {
  solve();
  std::vector<double> xy, v(frame.x.size()), u(frame.x.size());
  for (std::int64_t k = 0; k < frame.nodes; ++k)
    xy.insert(xy.end(), {frame.x[static_cast<std::size_t>(3 * k)], frame.x[static_cast<std::size_t>(3 * k + 1)]});
  double worst = 0, largest = 0;
  for (const std::int32_t which : {1, 2}) {
    ASSERT_OK(rollcon_contact_get_displacements_at(contact, which, frame.nodes, xy.data(), v.data()));
    ASSERT_OK(rollcon_contact_get_fields_at(contact, which, frame.nodes, frame.x.data(), ROLLCON_IN_CONTACT, u.data(),
                                            nullptr));
    for (std::size_t k = 0; k < v.size(); ++k) {
      worst = std::max(worst, std::abs(u[k] - v[k]));
      largest = std::max(largest, std::abs(v[k]));
    }
  }
  std::printf("displacements of both bodies at the nodes: error %.1e (bound 9e-9)\n", worst / largest);
  EXPECT_LE(worst / largest, 9e-9);
}

TEST_F(stresses, in_axes_of_the_body_are_turned_by_its_pose) {
  // The body's x, y and z are the contact's t2, n and t1; its origin lies at (3, 4, 5).
  solve();
  const double rotation[9] = {0, 0, 1, 1, 0, 0, 0, 1, 0}, origin[3] = {3, 4, 5};
  ASSERT_OK(rollcon_contact_set_pose(contact, ROLLCON_BODY1, rotation, origin));
  const double x[3] = {0.3, -0.2, -0.4}, moved[3] = {x[1] - 4, x[2] - 5, x[0] - 3};
  double u[3], s[6], turned[3], stress[6];
  ASSERT_OK(rollcon_contact_get_fields_at(contact, ROLLCON_BODY1, 1, x, ROLLCON_IN_CONTACT, u, s));
  ASSERT_OK(rollcon_contact_get_fields_at(contact, ROLLCON_BODY1, 1, moved, ROLLCON_IN_BODY, turned, stress));
  const double expected_u[3] = {u[1], u[2], u[0]};
  const double expected_stress[6] = {s[1], s[2], s[0], s[5], s[3], s[4]};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(turned[i], expected_u[i], 1e-9 * std::abs(u[2])) << i;
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(stress[i], expected_stress[i], 1e-8 * largest_pressure()) << i;
}

TEST_F(stresses, every_plane_below_carries_the_force) {
  // Forces of the tractions agree with those of stresses on a plane at depth 1; beyond its rim at a distance R from the
  // origin the stresses are those of point forces, whose parts there are R^-3 and 1.5/R - 0.5/R^3.
  solve();
  double force[3];
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
  constexpr int rings = 60, spokes = 24;
  constexpr double outer = 12;
  for (const std::int32_t which : {1, 2}) {
    std::vector<double> xyz, area;
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < spokes; ++j) {
        const double u = (i + 0.5) / rings, r = outer * u * u, phi = 2 * pi * j / spokes;
        xyz.insert(xyz.end(), {r * std::cos(phi), r * std::sin(phi), which == 1 ? -1.0 : 1.0});
        area.push_back(2 * pi / spokes * r * 2 * outer * u / rings);
      }
    const std::vector<double> s = stress_at(which, xyz);
    double sum[3] = {0, 0, 0};
    for (std::size_t p = 0; p < area.size(); ++p)
      for (std::size_t c = 0; c < 3; ++c) sum[c] += area[p] * s[6 * p + (c == 2 ? 2 : 4 + c)];
    const double rim = std::hypot(1, outer), beyond = std::pow(rim, -3);
    const double normal = std::abs(sum[2] / (1 - beyond) / force[2] - 1), inside = 1 - 1.5 / rim + 0.5 * beyond;
    const double shear =
        std::hypot(sum[0] / inside - force[0], sum[1] / inside - force[1]) / std::hypot(force[0], force[1]);
    std::printf("force over a plane in body %d: normal %.1e (bound 4.5e-5), tangential %.1e (bound 9e-4)\n", which,
                normal, shear);
    EXPECT_LE(normal, 4.5e-5);
    EXPECT_LE(shear, 9e-4);
  }
}

TEST_F(stresses, hertz_on_frames_of_the_library) {
  const double mu = 0, load = 300, radius = 50;
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.5 / radius, 0.5 / radius, 0));
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  ASSERT_OK(rollcon_contact_set_real(contact, "frame_accuracy", 1e-3));
  ASSERT_OK(rollcon_contact_solve(contact));
  const double modulus = 1 / ((1 - 0.09) / 1e4 + (1 - 0.01) / 3e4);
  const double a = std::cbrt(0.75 * load * radius / modulus), p0 = 1.5 * load / (pi * a * a);
  for (const std::int32_t which : {1, 2}) {
    const double nu = which == 1 ? 0.3 : 0.1;
    std::vector<double> xyz;
    for (int k = 0; k <= 100; ++k) xyz.insert(xyz.end(), {0, 0, (which == 1 ? -0.02 : 0.02) * k * a});
    const std::vector<double> s = stress_at(which, xyz);
    std::vector<double> mises(xyz.size() / 3), shear(mises.size());
    ASSERT_OK(rollcon_stress_invariants(static_cast<std::int64_t>(mises.size()), s.data(), nullptr, mises.data(),
                                        shear.data()));
    double worst = 0;
    for (std::size_t k = 0; k < mises.size(); ++k) {
      const double z = 0.02 * static_cast<double>(k), arctan = k > 0 ? z * std::atan(1 / z) : 0;
      const double radial = -(1 + nu) * (1 - arctan) + 0.5 / (1 + z * z), axial = -1 / (1 + z * z);
      worst = std::max({worst, std::abs(s[6 * k] / p0 - radial), std::abs(s[6 * k + 1] / p0 - radial),
                        std::abs(s[6 * k + 2] / p0 - axial)});
    }
    const double most = *std::max_element(mises.begin(), mises.end()) / p0;
    std::printf(
        "Hertz, body %d: stresses on the axis off by %.1e p0 (bound 3.6e-3), largest von Mises %.4f p0, shear "
        "%.4f p0\n",
        which, worst, most, *std::max_element(shear.begin(), shear.end()) / p0);
    EXPECT_LE(worst, 3.6e-3);
    if (which == 1) {
      EXPECT_NEAR(most, 0.620, 1e-3 * 0.620);
      EXPECT_NEAR(*std::max_element(shear.begin(), shear.end()) / p0, 0.310, 1e-3 * 0.310);
    }
  }
}

TEST_F(stresses, fatigue_index_and_wear_number) {
  solve();
  double force[3], creep[3], area = 0, index = 0, wear = 0;
  ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr));
  ASSERT_OK(rollcon_contact_get_motion(contact, nullptr, creep));
  ASSERT_OK(rollcon_contact_get_stat(contact, "contact_area", &area));
  ASSERT_OK(rollcon_contact_get_stat(contact, "t_gamma", &wear));
  const double k = 30, utilised = std::hypot(force[0], force[1]) / -force[2];
  ASSERT_OK(rollcon_contact_get_fatigue_index(contact, k, &index));
  EXPECT_NEAR(index, utilised + 2 * area * k / (3 * force[2]), 1e-15);
  EXPECT_NEAR(wear, -force[0] * creep[0] - force[1] * creep[1], 1e-14);
  EXPECT_GT(wear, 0);
  EXPECT_FAILS(rollcon_contact_get_fatigue_index(contact, 0, &index), ARGUMENT, "shear_yield is 0", "above 0");
  EXPECT_FAILS(rollcon_contact_get_fatigue_index(contact, std::nan(""), &index), NONFINITE, "shear_yield");
  EXPECT_FAILS(rollcon_contact_get_fatigue_index(contact, k, nullptr), ARGUMENT, "index is NULL");
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, -1));
  EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
  EXPECT_FAILS(rollcon_contact_get_fatigue_index(contact, k, &index), STATE, "no normal force");
}

TEST_F(stresses, hertz_index_of_fatigue) {
  // Full sliding on frames of the library has mu - 2 pi a^2 k/(3 Fn).
  const double mu = 0.4, load = 300, radius = 50, k = 30;
  ASSERT_OK(rollcon_contact_set_gap_quadratic(contact, 0.5 / radius, 0.5 / radius, 0));
  ASSERT_OK(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  ASSERT_OK(rollcon_contact_set_creep(contact, 0.3, 0, 0));
  ASSERT_OK(rollcon_contact_solve(contact));
  const double modulus = 1 / ((1 - 0.09) / 1e4 + (1 - 0.01) / 3e4), a = std::cbrt(0.75 * load * radius / modulus);
  double index = 0, wear = 0, power = 0;
  ASSERT_OK(rollcon_contact_get_fatigue_index(contact, k, &index));
  ASSERT_OK(rollcon_contact_get_stat(contact, "t_gamma", &wear));
  ASSERT_OK(rollcon_contact_get_stat(contact, "friction_power_balance", &power));
  const double exact = mu - 2 * pi * a * a * k / (3 * load);
  std::printf("fatigue index %.5f (%.5f, bound 1e-3), T-gamma %.5f (%.5f, bound 3e-6), power %.5f\n", index, exact,
              wear, mu * load * 0.3, power);
  EXPECT_NEAR(power / wear, 1, 1e-2) << "speed 1, no spin; unlike bodies add their free rolling";
  EXPECT_NEAR(index, exact, 1e-3);
  EXPECT_NEAR(wear / (mu * load * 0.3), 1, 3e-6);
}

TEST_F(stresses, accuracy_is_an_option) {
  solve();
  const std::vector<double> xyz{0.1, 0.2, -0.05, 0.7, -0.3, -0.4, 0, 0, 0};
  double standard = 0;
  ASSERT_OK(rollcon_contact_get_real(contact, "stress_accuracy", &standard));
  EXPECT_EQ(standard, 1e-5);
  const std::vector<double> usual = stress_at(1, xyz);
  const auto off = [&](double accuracy, const std::vector<double>& s) {
    EXPECT_OK(rollcon_contact_set_real(contact, "stress_accuracy", accuracy));
    const std::vector<double> other = stress_at(1, xyz);
    double worst = 0;
    for (std::size_t k = 0; k < s.size(); ++k) worst = std::max(worst, std::abs(other[k] - s[k]));
    return worst / largest_pressure();
  };
  const double of_usual = off(1e-9, usual), of_rough = off(1e-2, stress_at(1, xyz));
  std::printf("stress_accuracy 1e-5: error %.1e (bound 1e-5); 1e-2: %.1e (bound 1e-2)\n", of_usual, of_rough);
  EXPECT_LE(of_usual, 1e-5);
  EXPECT_LE(of_rough, 1e-2);
  EXPECT_GT(of_rough, 10 * of_usual);
}

TEST(stress_invariants, known_states) {
  // The stresses are a pull, pressure on all sides, shear, and a pull along (1, 1, 1).
  const double s[][6] = {{2, 0, 0, 0, 0, 0}, {-3, -3, -3, 0, 0, 0}, {0, 0, 0, 0, 1, 0}, {1, 1, 1, 1, 1, 1}};
  const double principal[][3] = {{2, 0, 0}, {-3, -3, -3}, {1, 0, -1}, {3, 0, 0}};
  const double mises[] = {2, 0, std::sqrt(3.0), 3}, shear[] = {1, 0, 1, 1.5};
  double p[12], m[4], t[4];
  for (const double unit : {1.0, 1e-300, 1e300}) {
    std::vector<double> stress(&s[0][0], &s[0][0] + 24);
    for (double& v : stress) v *= unit;
    ASSERT_OK(rollcon_stress_invariants(4, stress.data(), p, m, t));
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(p[3 * k + i] / unit, principal[k][i], 1e-15);
      EXPECT_NEAR(m[k] / unit, mises[k], 1e-15);
      EXPECT_NEAR(t[k] / unit, shear[k], 1e-15);
    }
  }
}

TEST(stress_invariants, random_states_keep_trace_determinant_and_deviator) {
  std::uint64_t state = 1;
  const auto random = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) / 4503599627370496.0 - 1;
  };
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    double s[6], p[3], m = 0, t = 0;
    for (double& v : s) v = random();
    ASSERT_OK(rollcon_stress_invariants(1, s, p, &m, &t));
    EXPECT_TRUE(p[0] >= p[1] && p[1] >= p[2]);
    const double determinant =
        s[0] * (s[1] * s[2] - s[5] * s[5]) - s[3] * (s[3] * s[2] - s[5] * s[4]) + s[4] * (s[3] * s[5] - s[1] * s[4]);
    const double x = p[0] - p[1], y = p[1] - p[2], z = p[2] - p[0];
    worst =
        std::max({worst, std::abs(p[0] + p[1] + p[2] - s[0] - s[1] - s[2]), std::abs(p[0] * p[1] * p[2] - determinant),
                  std::abs(m - std::sqrt(0.5 * (x * x + y * y + z * z))), std::abs(t - 0.5 * (p[0] - p[2]))});
  }
  std::printf("invariants of random stresses: error %.1e (bound 6e-15)\n", worst);
  EXPECT_LE(worst, 6e-15);
}

}  // namespace
