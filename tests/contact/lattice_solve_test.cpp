// Tests regular frames on half-spaces: operators applied by FFT give what dense ones give, in every kind of scene; work
// and memory grow with the number of nodes.

#include "support/steady_rolling.hpp"
#include "support/testing.hpp"

namespace {

namespace frames = rollcon::frames;
namespace scenes = rollcon::scenes;
namespace steady_rolling = scenes::steady_rolling;
using scenes::RollingPair;

constexpr double agreement = 1e-11;

bool have_fft() {
  return rollcon_has_feature("fftw") == 1;
}

enum class Second { same, rigid, softer };

struct Case {
  const char* name;
  Second second = Second::same;
  double lateral = 0, spin = 0, mu = steady_rolling::mu;
  const char* scheme = "characteristic";
  bool forces = false, approach = false;
  double angle = 0;    ///< angle of the rolling direction to the frame's x axis
  double narrow = 1;   ///< spacing across over spacing along
  double covered = 1;  ///< side of the frame over that of the usual one
  bool holes = false;  ///< cells lack amid the contact and at a corner
  double off = 0;      ///< distance of nodes from their places, in spacings
};

rollcon::SurfaceMesh mesh_of(const Case& c, double half, int n) {
  const auto x = frames::uniform_lines(-half, half, n);
  const auto y = frames::uniform_lines(-half, half, static_cast<int>(n / c.narrow));
  rollcon::SurfaceMesh mesh = frames::rectangle(rollcon::ElementType::quad4, x, y);
  frames::Random random(3);
  if (c.off > 0)
    for (rollcon::Vec3& node : mesh.node)
      for (std::size_t d = 0; d < 2; ++d) node[d] += c.off * (x[1] - x[0]) * random();
  if (!c.holes) return mesh;
  const int middle = n / 2 * n + n / 2;
  for (const int gone : {middle + n + 2, middle, middle - 1, 0}) {
    const auto first = mesh.connectivity.begin() + 4 * gone;
    mesh.connectivity.erase(first, first + 4);
    mesh.type.pop_back(), mesh.tag.pop_back(), mesh.offset.pop_back();
  }
  return mesh;
}

std::unique_ptr<RollingPair> make(const Case& c, const char* operators, int n = 20) {
  const scenes::Elastic soft{.shear = 41000, .poisson = 0.4};
  std::unique_ptr<RollingPair> pair;
  if (c.second == Second::rigid)
    pair = std::make_unique<RollingPair>(soft, std::nullopt);
  else
    pair =
        std::make_unique<RollingPair>(steady_rolling::steel, c.second == Second::softer ? soft : steady_rolling::steel);
  const double half = c.covered * steady_rolling::radius / 0.85;
  pair->frame(mesh_of(c, half, n));
  if (c.angle != 0) pair->rolling_at(c.angle);
  pair->gap_quadratic(steady_rolling::hertz.A, steady_rolling::hertz.B).friction(c.mu);
  pair->load(steady_rolling::hertz.load).creep(steady_rolling::creepage, c.lateral, c.spin);
  if (c.approach) pair->approach(0.9 * steady_rolling::hertz.approach);
  if (c.forces) {
    const double carried = c.mu * steady_rolling::hertz.load;
    pair->tangential_force(ROLLCON_LONGITUDINAL, 0.4 * carried);
    pair->tangential_force(ROLLCON_LATERAL, -0.2 * carried);
  }
  pair->option("convection", c.scheme).option("operators", operators);
  pair->option("tolerance", 1e-12).option("accuracy", 1e-11);
  return pair;
}

/// Returns the largest difference of the tractions over the largest pressure, and of the motions.
double difference(const scenes::Solution& a, const scenes::Solution& b) {
  double scale = 0, worst = 0;
  for (std::size_t k = 0; k < a.nodes(); ++k) scale = std::max(scale, a.pressure[k]);
  for (std::size_t k = 0; k < a.nodes(); ++k)
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a.traction[k][c] - b.traction[k][c]) / scale);
  worst = std::max(worst, std::abs(a.approach / b.approach - 1));
  for (std::size_t c = 0; c < 2; ++c) worst = std::max(worst, std::abs(a.creep[c] - b.creep[c]) / 1e-3);
  return worst;
}

class Lattices : public testing::TestWithParam<Case> {};

TEST_P(Lattices, FftAgreesWithDenseOperators) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  const auto dense = make(GetParam(), "dense"), fft = make(GetParam(), "fft");
  const std::int32_t expected = dense->solve();
  EXPECT_EQ(fft->solve(), expected);
  const double worst = difference(fft->solution(), dense->solution());
  std::printf("%s: difference %.2e (bound %.0e)\n", GetParam().name, worst, agreement);
  EXPECT_LE(worst, agreement);
  EXPECT_GT(fft->stat("operator_applications"), 0);
  EXPECT_EQ(fft->stat("kernel_evaluations"), 0);  // before the laws are checked by integrals
  for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
    EXPECT_LE(fft->stat(law), 1e-8) << law;
}

TEST_P(Lattices, WarmSolvesAgreeWithCold) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  const auto warm = make(GetParam(), "fft"), cold = make(GetParam(), "fft");
  warm->load(0.9 * steady_rolling::hertz.load).solve();
  warm->load(steady_rolling::hertz.load);
  cold->load(steady_rolling::hertz.load);
  EXPECT_EQ(warm->solve(), cold->solve());
  const double worst = difference(warm->solution(), cold->solution());
  std::printf("%s: warm off cold by %.1e (bound %.0e)\n", GetParam().name, worst, agreement);
  EXPECT_LE(worst, agreement);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Lattices,
    testing::Values(
        Case{.name = "longitudinal"}, Case{.name = "spin", .lateral = 2e-4, .spin = 3e-4},
        Case{.name = "rigid", .second = Second::rigid, .spin = 3e-4},
        Case{.name = "unlike", .second = Second::softer, .lateral = -3e-4}, Case{.name = "forces", .forces = true},
        Case{.name = "forces_rigid", .second = Second::rigid, .forces = true},
        Case{.name = "approach", .second = Second::rigid, .approach = true}, Case{.name = "frictionless", .mu = 0},
        Case{.name = "frictionless_rigid", .second = Second::rigid, .mu = 0},
        Case{.name = "rolling_at_30_degrees", .second = Second::rigid, .spin = 1e-4, .angle = 0.5235987755982988},
        Case{.name = "rolling_backwards", .spin = 2e-4, .angle = 2.8},
        Case{.name = "least_squares", .spin = 1e-4, .scheme = "least_squares"},
        Case{.name = "godunov", .second = Second::rigid, .scheme = "godunov"},
        Case{.name = "flat_cells", .second = Second::rigid, .spin = 1e-4, .narrow = 2.5},
        Case{.name = "beyond_the_rim", .second = Second::rigid, .covered = 0.7},
        Case{.name = "holes", .spin = 1e-4, .holes = true},
        Case{.name = "holes_least_squares", .second = Second::softer, .scheme = "least_squares", .holes = true}),
    [](const auto& info) { return std::string(info.param.name); });

// Newton's iterations and the applications of the operators hardly grow with the lattice in the rolling cases (a) and
// (b), alike and unlike; the bytes of a node do not grow at all.
TEST(Lattice_long, WorkAndMemoryGrowWithTheNodes) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  for (const Case& c : {Case{.name = "a"}, Case{.name = "b", .spin = steady_rolling::spin},
                        Case{.name = "b on rigid", .second = Second::rigid, .spin = steady_rolling::spin}}) {
    double first = 0;
    for (const int n : {32, 64, 128}) {
      const auto pair = make(c, "fft", n);
      pair->option("tolerance", 1e-6);
      ASSERT_EQ(pair->solve(), ROLLCON_OK);
      const double per_node = pair->stat("peak_bytes") / ((n + 1) * (n + 1));
      const double applications = pair->stat("operator_applications");
      std::printf("%s, %d x %d: %g Newton iterations, %g applications (bound 170), %.0f bytes per node\n", c.name, n, n,
                  pair->stat("iterations"), applications, per_node);
      if (first == 0) first = per_node;
      EXPECT_LE(per_node, 1.5 * first);
      EXPECT_LE(applications, 170);
      EXPECT_LE(pair->stat("iterations"), 9);
    }
  }
}

// Coordinates in single precision and missing cells do not slow it down, and results are off by as little.
TEST(Lattice, FlawsKeepTheFft) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  for (const Case& c : {Case{.name = "rounded", .off = 2e-6}, Case{.name = "holes", .holes = true}}) {
    const auto fast = make(c, "auto"), exact = make(c, "dense");
    const std::int32_t expected = c.holes ? ROLLCON_RIM_CONTACT : ROLLCON_OK;
    ASSERT_EQ(fast->solve(), expected);
    ASSERT_EQ(exact->solve(), expected);
    EXPECT_GT(fast->stat("operator_applications"), 0);
    const double worst = difference(fast->solution(), exact->solution()), bound = c.off > 0 ? 10 * c.off : agreement;
    std::printf("%s: difference %.1e (bound %.0e), bytes %.0f, dense %.0f\n", c.name, worst, bound,
                fast->stat("peak_bytes"), exact->stat("peak_bytes"));
    EXPECT_LE(worst, bound);
    EXPECT_LE(fast->stat("peak_bytes"), 0.2 * exact->stat("peak_bytes"));
    EXPECT_NE(fast->plan().find(c.holes ? "4 cell(s) of the grid missing" : "of a spacing off"), std::string::npos)
        << fast->plan();
  }
  // The text says what is missing to be a lattice.
  const auto jittered = make(Case{.name = "jittered", .off = 1e-3}, "auto", 12);
  EXPECT_EQ(jittered->solve(), ROLLCON_OK);
  EXPECT_NE(jittered->plan().find("not a regular grid of quad4 elements: node"), std::string::npos) << jittered->plan();
}

TEST(Lattice, AnythingElseIsRefusedByName) {
  const auto error_of = [](RollingPair& pair) -> std::string {
    try {
      pair.solve();
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return {};
  };
  RollingPair triangles(steady_rolling::steel, steady_rolling::steel);
  triangles.rectangle(rollcon::ElementType::tri3, 12, 12, 6, 6);
  triangles.gap_quadratic(0.01, 0.01).load(1000).friction(0.3).option("operators", "fft");
  const std::string message = error_of(triangles);
  EXPECT_NE(message.find("operators"), std::string::npos) << message;
  EXPECT_NE(message.find(have_fft() ? "grid" : "FFTW"), std::string::npos) << message;
  // Two lines of nodes have no inner one, so operators are dense, whatever their number.
  RollingPair strip(steady_rolling::steel, steady_rolling::steel);
  strip.rectangle(rollcon::ElementType::quad4, 320, 1, 6, 0.1);
  strip.gap_quadratic(0.01, 0).load(10).friction(0.3);
  EXPECT_GE(strip.solve(), ROLLCON_OK);
  strip.option("operators", "table");
  EXPECT_NE(error_of(strip).find("no inner node"), std::string::npos);
  // The handle stays usable.
  triangles.option("operators", "auto");
  EXPECT_EQ(triangles.solve(), ROLLCON_COARSE);
  if (!have_fft()) return;
  auto regular = make(Case{.name = "procedure"}, "fft");
  regular->option("procedure", "jacobian=b_derivative");
  EXPECT_NE(error_of(*regular).find("jacobian"), std::string::npos);
}

TEST(Lattice, DisplacementsOfEachBodyAreThoseOfIntegrals) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  const auto pair = make(Case{.name = "unlike", .second = Second::softer, .spin = 2e-4}, "fft");
  pair->solve();
  const scenes::Solution s = pair->solution();
  std::vector<double> xy;
  for (std::size_t k = 0; k < s.nodes(); ++k) xy.insert(xy.end(), {s.x[k], s.y[k]});
  const std::vector<double> few(xy.begin(), xy.end() - 2);  // not all the nodes, so by integrals
  for (const int body : {1, 2}) {
    const std::vector<double> fft = pair->displacements_at(body, xy);
    const std::vector<double> integrals = pair->displacements_at(body, few);
    double scale = 0, worst = 0;
    for (std::size_t i = 0; i < integrals.size(); ++i) {
      scale = std::max(scale, std::abs(integrals[i]));
      worst = std::max(worst, std::abs(integrals[i] - fft[i]));
    }
    std::printf("body %d: displacements differ by %.1e of the largest (bound 1e-10)\n", body, worst / scale);
    EXPECT_LE(worst, 1e-10 * scale);
  }
}

// The force Fx of the next finer lattices tells the error, which the estimate finds to a factor of a few.
TEST(Lattice_long, ErrorEstimatesFollowTheErrors) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  const Case c{.name = "a"};
  const auto solve = [&](int n) {
    auto pair = make(c, "fft", n);
    pair->option("tolerance", 1e-8).solve();
    return pair;
  };
  const auto fine = solve(160);
  const double limit = fine->solution().force[0];
  double before = 1;
  for (const int n : {24, 48, 96}) {
    const auto pair = solve(n);
    const double error = std::abs(pair->solution().force[0] / limit - 1);
    const double estimate = pair->stat("error_estimate_tangential");
    std::printf("%d x %d: error of Fx %.4f, estimate %.4f\n", n, n, error, estimate);
    EXPECT_GT(estimate, 0.5 * error);
    EXPECT_LT(estimate, 8 * error);
    EXPECT_LT(estimate, before);
    before = estimate;
  }
}

// Two lattices can agree by accident where the edge of the contact falls between the nodes: from these two alone
// estimates were a fifth (characteristic, 64) and a tenth (least squares, against a coarse lattice by another scheme)
// of the errors.
TEST(Lattice_long, ErrorEstimatesDoNotMissErrorsByAccident) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  const auto solve = [&](const char* scheme, int n) {
    const scenes::Elastic hard{.shear = 2e5 / 2.6, .poisson = 0.3};
    const scenes::Elastic soft{.shear = 1e5 / 2.6, .poisson = 0.3};
    auto pair = std::make_unique<RollingPair>(hard, soft);
    pair->rectangle(rollcon::ElementType::quad4, n, n, 1.3, 1.3);
    pair->gap_quadratic(0.01, 0.012).friction(0.3).approach(0.01).creep(1e-3, 0, 0);
    pair->option("convection", scheme).option("operators", "fft").option("tolerance", 1e-6);
    EXPECT_EQ(pair->solve(), ROLLCON_OK);
    return pair;
  };
  const std::array<double, 3> limit = solve("characteristic", 160)->solution().force;
  for (const auto& [scheme, n] : {std::pair{"characteristic", 48}, std::pair{"characteristic", 64},
                                  std::pair{"least_squares", 48}, std::pair{"least_squares", 96}}) {
    const auto pair = solve(scheme, n);
    const scenes::Solution s = pair->solution();
    double magnitude = 0;
    for (std::size_t k = 0; k < s.nodes(); ++k)
      magnitude += s.weight[k] * std::hypot(s.traction[k][0], s.traction[k][1]);
    const double error = std::hypot(s.force[0] - limit[0], s.force[1] - limit[1]) / magnitude;
    const double estimate = pair->stat("error_estimate_tangential");
    std::printf("%s %d: error %.4f, estimate %.4f (0.5 to 8 times)\n", scheme, n, error, estimate);
    EXPECT_GT(estimate, 0.5 * error);
    EXPECT_LT(estimate, 8 * error);
  }
}

TEST(Lattice, DerivativesAreThoseOfDenseOperators) {
  if (!have_fft()) GTEST_SKIP() << "built without FFTW";
  const Case c{.name = "derivatives", .second = Second::rigid, .spin = 2e-4};
  const auto dense = make(c, "dense"), fft = make(c, "fft");
  dense->solve();
  fft->solve();
  for (const std::int32_t parameter : {1, 2, 3, 4, 5}) {
    double a[3], b[3];
    ASSERT_EQ(rollcon_contact_get_sensitivity(dense->handle(), parameter, a, nullptr, nullptr, nullptr), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_get_sensitivity(fft->handle(), parameter, b, nullptr, nullptr, nullptr), ROLLCON_OK);
    const double scale = std::hypot(a[0], a[1], a[2]);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-6 * scale) << parameter;
  }
}

}  // namespace
