// Tests the paper's example 3 on its frames: the same creepage on all within their errors, the peak pressure near
// Hertz's, and every law of contact recomputed from the results.

#include "support/example3.hpp"

#include "support/independent_schemes.hpp"
#include "validation/laws.hpp"

namespace rollcon::validation {
namespace {

namespace example3 = scenes::example3;

struct Reference {
  double creepage, p0;
};

double peak(const Solution& s) {
  return *std::max_element(s.pressure.begin(), s.pressure.end());
}

/// Returns the result of a fine frame fitted to the contact, by the characteristic scheme.
const Reference& reference() {
  static const Reference value = [] {
    const double a = example3::hertz().a;
    auto pair = example3::pair(graded_disc(a, a, 14), "characteristic");
    EXPECT_EQ(pair->solve(), ROLLCON_OK);
    const Solution s = pair->solution();
    return Reference{s.creep[0], peak(s)};
  }();
  return value;
}

std::vector<double> positions(const Solution& s, double shift_x) {
  std::vector<double> xy;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    xy.push_back(s.x[k] + shift_x);
    xy.push_back(s.y[k]);
  }
  return xy;
}

/// Returns u1 - u2 at the nodes moved by shift_x; the plane is rigid.
std::vector<double> displacement(const RollingPair& pair, const Solution& s, double shift_x) {
  return pair.displacements_at(1, positions(s, shift_x));
}

/// Returns the largest error of the published gap against h - approach - u_n from displacements at points.
double gap_error(const RollingPair& pair, const Solution& s) {
  const auto u = displacement(pair, s, 0);
  double error = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    const double h = (s.x[k] * s.x[k] + s.y[k] * s.y[k]) / (2 * example3::radius);
    error = std::max(error, std::abs(h - s.approach - u[3 * k + 2] - s.gap[k]));
  }
  return error / s.approach;
}

/// Returns the largest error of the published slip in contact against c + V D u with the tests' own Godunov operator.
double slip_error(const RollingPair& pair, const Solution& s, const SurfaceMesh& mesh) {
  const auto u = displacement(pair, s, 0);
  const laws::Rows rows = laws::godunov_rows(mesh, {s.x, s.y});
  double error = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    if (s.state[k] == ROLLCON_OPEN) continue;
    std::array<double, 2> slip{s.creep[0], s.creep[1]};
    for (const laws::Difference& d : rows[k])
      for (std::size_t c = 0; c < 2; ++c) slip[c] += d.c * (u[3 * static_cast<std::size_t>(d.node) + c] - u[3 * k + c]);
    error =
        std::max(error, std::hypot(slip[0] - s.slip[k][0] / example3::speed, slip[1] - s.slip[k][1] / example3::speed));
  }
  return error / std::abs(s.creep[0]);
}

/// Returns the root mean square difference, over nodes in contact, of the published slip and the exact derivative of
/// the displacements along the path, in units of V |xi|. It includes the scheme's error.
double slip_consistency(const RollingPair& pair, const Solution& s) {
  const double step = 1e-3 * example3::hertz().a;
  const auto here = displacement(pair, s, -step), ahead = displacement(pair, s, step);
  double sum = 0, area = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    if (s.state[k] == ROLLCON_OPEN) continue;
    const double V = example3::speed;
    const double sx = V * s.creep[0] + V * (here[3 * k] - ahead[3 * k]) / (2 * step);
    const double sy = V * s.creep[1] + V * (here[3 * k + 1] - ahead[3 * k + 1]) / (2 * step);
    sum += s.area[k] * (std::pow(sx - s.slip[k][0], 2) + std::pow(sy - s.slip[k][1], 2));
    area += s.area[k];
  }
  return std::sqrt(sum / area) / (example3::speed * std::abs(s.creep[0]));
}

void roll(int nodes, const char* scheme, double bound) {
  const auto frame = example3::frame(nodes);
  auto pair = example3::pair(frame.mesh, scheme);
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  const Solution s = pair->solution();
  const std::string name = frame.name + ", " + scheme + ": ";
  report(name + "Newton iterations", pair->stat("iterations"));
  expect_error(name + "force found, Ft/(mu Fn)", s.force[0] / (example3::mu * example3::load) - example3::force_ratio,
               1e-7);
  const auto found = scenes::found_creepage(s, example3::mu * example3::load, example3::hertz().a);
  const auto errors = scenes::rolling_errors(found, {{reference().creepage, 0}, 0});
  expect_error(name + "creepage, turned like the force", errors.force, bound);
  expect_error(name + "spin moment", errors.moment, 2e-4);
  expect_error(name + "peak pressure against the fine frame", relative(peak(s), reference().p0), 1e-2);
  // The pressure of 140 MPa is Hertz's 140.8 without friction; the coupling of this pair raises it by 1.8 %.
  expect_error(name + "peak pressure against 140 MPa", relative(peak(s), 140), 3e-2);
  expect_laws(frame.name + ", " + scheme, check_laws(s, example3::mu, example3::speed * std::abs(s.creep[0])));
  expect_error(name + "gap from displacements", gap_error(*pair, s), 1e-5);
  if (std::string(scheme) == "godunov" && (nodes == 673 || nodes == 703))
    expect_error(name + "slip from displacements, own operator", slip_error(*pair, s, frame.mesh), 1e-4);
  report(name + "slip against the exact derivative, rms", slip_consistency(*pair, s));
}

/// Holds the bound of the creepage: up to twice the scheme's measured error, and never below that of the reference
/// itself (14 rings differ from 18 by 0.13 %).
struct Rolling {
  int nodes;
  const char* scheme;
  double bound;
};

class Example3Frames : public testing::TestWithParam<Rolling> {};

TEST_P(Example3Frames, creepage_pressure_and_laws) {
  roll(GetParam().nodes, GetParam().scheme, GetParam().bound);
}

constexpr auto rolling_name = [](const auto& test) {
  return std::to_string(test.param.nodes) + "_" + std::string(test.param.scheme);
};
// Cells of triangles and above all of the split quad8 are irregular, and Godunov pays for it.
INSTANTIATE_TEST_SUITE_P(Validation, Example3Frames,
                         testing::Values(Rolling{673, "godunov", 0.006}, Rolling{673, "least_squares", 0.008},
                                         Rolling{673, "characteristic", 0.004}, Rolling{703, "godunov", 0.05},
                                         Rolling{703, "least_squares", 0.008}, Rolling{703, "characteristic", 0.004}),
                         rolling_name);
INSTANTIATE_TEST_SUITE_P(Validation_long, Example3Frames,
                         testing::Values(Rolling{1985, "godunov", 0.15}, Rolling{1985, "least_squares", 0.008},
                                         Rolling{1985, "characteristic", 0.004}),
                         rolling_name);
INSTANTIATE_TEST_SUITE_P(Validation_nightly, Example3Frames,
                         testing::Values(Rolling{2745, "godunov", 0.03}, Rolling{2745, "least_squares", 0.006},
                                         Rolling{2745, "characteristic", 0.004}),
                         rolling_name);

// Tractions carried along a half-space change no elastic energy: friction loses what the force and the rolling moment
// put in, -int lt.s = V (M2/R - F1 xi1).
TEST(Example3, friction_loses_what_force_and_moment_put_in) {
  const double a = example3::hertz().a;
  for (const auto& [scheme, bound] : {std::pair{"characteristic", 0.07}, std::pair{"least_squares", 0.15}}) {
    auto pair = example3::pair(graded_disc(a, a, 12), scheme);
    ASSERT_EQ(pair->solve(), ROLLCON_OK);
    const Solution s = pair->solution();
    const double put_in = example3::speed * (s.moment[1] / example3::radius - s.force[0] * s.creep[0]);
    expect_error(std::string(scheme) + ": power of friction against the work put in",
                 relative(pair->stat("friction_power"), put_in), bound);
  }
}

TEST(Example3, creepage_change_resolves_in_few_iterations) {
  auto pair = example3::pair(example3::frame(673).mesh, "least_squares");
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  expect_error("Newton iterations, cold", pair->stat("iterations"), 12);
  const double xi = pair->solution().creep[0];
  pair->creep(1.01 * xi, 0, 0);
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  expect_error("Newton iterations, warm after 1 % more creepage", pair->stat("iterations"), 4);
}

}  // namespace
}  // namespace rollcon::validation
