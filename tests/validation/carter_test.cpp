// Tests Carter's steady rolling of identical cylinders on frames aligned with the flow, and on others.

#include "support/carter_strip.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

using namespace scenes;

struct Result {
  CarterErrors errors[3];  ///< errors by scheme
};

Result roll(const std::vector<double>& x, double half_length) {
  const Strip strip{carter.hertz, half_length};
  const auto mesh = frames::rectangle(ElementType::quad4, x, scenes::strip_lines(half_length));
  RollingPair pair(roller, roller);
  pair.frame(mesh);
  load_strip(pair, strip, mesh);
  Result result;
  for (int i = 0; i < 3; ++i) {
    pair.option("convection", schemes[i]);
    pair.reset();
    // The ends of the strip are loaded: the frame's rim is in contact by intent.
    EXPECT_EQ(pair.solve(), ROLLCON_RIM_CONTACT) << schemes[i];
    result.errors[i] = compare(scenes::middle_section(pair.solution()));
  }
  return result;
}

TEST(Carter, aligned_50_nodes_across) {
  const Result r = roll(strip_nodes(50), 20);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    expect_error(name + ": load of the middle section", r.errors[i].load, 1e-2);
    expect_error(name + ": F/(mu P) at given creepage", r.errors[i].force, 9e-3);
    expect_error(name + ": traction, relative L2", r.errors[i].traction, 1.5e-2);
  }
}

TEST(Carter, aligned_50_nodes_across_with_the_edge_on_a_node) {
  const Result r = roll(strip_nodes(50, 0), 20);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    expect_error(name + ": F/(mu P) at given creepage", r.errors[i].force, 9e-3);
    expect_error(name + ": traction, relative L2", r.errors[i].traction, 1.5e-2);
  }
}

TEST(Carter_long, uniform_nodes_converge_with_first_order) {
  const Result coarse = roll(strip_nodes(20), 20), fine = roll(strip_nodes(80), 20);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    report(name + ": F/(mu P), 20 nodes across", coarse.errors[i].force);
    report(name + ": F/(mu P), 80 nodes across", fine.errors[i].force);
    // The force is of first order; the square roots at the edges leave 1/2 to 1 in the L2 norm.
    expect_order(name + ": F/(mu P)", observed_order(coarse.errors[i].force, fine.errors[i].force, 4, 1), 0.75);
    expect_order(name + ": traction", observed_order(coarse.errors[i].traction, fine.errors[i].traction, 4, 1), 0.6);
  }
}

TEST(Carter_long, nodes_graded_to_the_edge_converge_faster) {
  const Result coarse = roll(graded_nodes(20), 40), fine = roll(graded_nodes(40), 40);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    report(name + ": F/(mu P), 20 graded elements", coarse.errors[i].force);
    report(name + ": traction, 20 graded elements", coarse.errors[i].traction);
    if (i == 0) {
      // The flux difference over a median-dual cell, (w_J - w_I)/Omega_I, is not consistent where the spacing changes:
      // Godunov's force still converges, slowly.
      report(name + ": traction, 40 graded elements", fine.errors[i].traction);
      expect_error(name + ": F/(mu P), 40 graded elements", fine.errors[i].force, 1e-1);
      expect_order(name + ": F/(mu P)", observed_order(coarse.errors[i].force, fine.errors[i].force, 2, 1), 0.5);
      continue;
    }
    expect_error(name + ": F/(mu P), 40 graded elements", fine.errors[i].force, 5e-4);
    expect_error(name + ": traction, 40 graded elements", fine.errors[i].traction, 1.5e-2);
    expect_order(name + ": F/(mu P)", observed_order(coarse.errors[i].force, fine.errors[i].force, 2, 1), 1.5);
  }
}

TEST(Carter_long, the_strip_is_long_enough) {
  double force[3];
  for (int i = 0; i < 3; ++i)
    force[i] = roll(graded_nodes(24), 5.0 * (1 << i)).errors[2].force_ratio / carter.force_ratio();
  report("F/(mu P), half length  5 a", force[0]);
  report("F/(mu P), half length 10 a", force[1]);
  report("F/(mu P), half length 20 a", force[2]);
  // The pieces beyond the ends change the kernel by about (a / half length)^2 / 2.
  expect_error("change of F from half length 5 a to 20 a", force[0] - force[2], 0.5 / 25);
  expect_error("change of F from half length 10 a to 20 a", force[1] - force[2], 0.5 / 100);
}

TEST(Carter, more_creepage_more_slip_until_all_slides) {
  const Strip strip{carter.hertz, 20};
  const auto mesh = frames::rectangle(ElementType::quad4, strip_nodes(50), scenes::strip_lines(20));
  RollingPair pair(roller, roller);
  pair.frame(mesh);
  load_strip(pair, strip, mesh);
  pair.option("convection", "characteristic");
  for (double xi : {1e-4, 2e-4, 3e-4, 4e-4, 5e-4, 5.9e-4, 8e-4}) {
    pair.creep(-xi, 0, 0);
    EXPECT_EQ(pair.solve(), ROLLCON_RIM_CONTACT);
    const Section s = scenes::middle_section(pair.solution());
    Carter exact = carter;
    exact.xi = -xi;
    char name[60];
    std::snprintf(name, sizeof name, "xi = %.1e: F/(mu P) = %.4f, in mu P", xi, exact.force_ratio());
    const double unit = carter.mu * s.load();
    expect_error(name, std::hypot(s.force() / unit - exact.force_ratio(), s.lateral_force() / unit), 6e-3);
  }
}

// The mesh does not follow the flow here: flow along the mesh's y axis, at 30 degrees to a grid, and over unstructured
// triangles. First-order upwinding smears there; the errors are reported and bounded by what a first-order scheme of
// that mesh size may cost, not by a wish.

constexpr double half_length = 3;  // half length of the short strips with near-isotropic meshes
constexpr double pi = 3.14159265358979323846;

/// Returns the force vector over mu P of the strip's middle half by the nodes' weights; below, the relative L2 error of
/// its tractions against a function of x.
RollingAnswer middle_force(const Solution& s) {
  std::array<double, 2> force{};
  double load = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    if (std::abs(s.y[k]) > 0.5 * half_length) continue;
    for (std::size_t c = 0; c < 2; ++c) force[c] += s.weight[k] * s.traction[k][c];
    load += s.weight[k] * s.pressure[k];
  }
  return {{force[0] / (carter.mu * load), force[1] / (carter.mu * load)}, 0};
}

double middle_traction_error(const Solution& s) {
  double difference = 0, norm = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    if (std::abs(s.y[k]) > 0.5 * half_length) continue;
    const double q = carter.traction(s.x[k]);
    difference += s.area[k] * std::pow(s.traction[k][0] - q, 2);
    norm += s.area[k] * q * q;
  }
  return std::sqrt(difference / norm);
}

Solution roll(const SurfaceMesh& mesh, const std::vector<double>& gap, const char* scheme, double angle = 0) {
  const Strip strip{carter.hertz, half_length};
  RollingPair pair(roller, roller);
  pair.frame(mesh).gap(gap).friction(carter.mu).rolling_at(angle);
  pair.approach(strip.approach()).creep(carter.xi, 0, 0).option("convection", scheme);
  // The ends are loaded: the status is OK where the frame reaches beyond them, else the rim is in contact by intent.
  const std::int32_t status = pair.solve();
  EXPECT_TRUE(status == ROLLCON_OK || status == ROLLCON_RIM_CONTACT) << scheme;
  return pair.solution();
}

/// Returns the strip's gap, which is open beyond its ends.
std::vector<double> strip_gap(const SurfaceMesh& mesh) {
  const Strip strip{carter.hertz, half_length};
  std::vector<double> h;
  for (const Vec3& node : mesh.node)
    h.push_back(std::abs(node[1]) > half_length + 1e-9 ? 100 * strip.approach() : strip.gap({node[0]}, {node[1]})[0]);
  return h;
}

/// Returns what the short strip's middle half gives on a fine aligned frame.
RollingAnswer reference_force() {
  static const RollingAnswer value = [] {
    const auto mesh =
        frames::rectangle(ElementType::quad4, graded_nodes(32), frames::uniform_lines(-half_length, half_length, 16));
    return middle_force(roll(mesh, strip_gap(mesh), "characteristic"));
  }();
  return value;
}

/// Returns the elements of a grid of size h, turned by `angle`, that lie within the strip and its margin.
SurfaceMesh turned_grid(double h, double angle) {
  const int n = static_cast<int>(std::ceil((half_length + 2) / h));
  const auto lines = frames::uniform_lines(-n * h, n * h, 2 * n);
  const SurfaceMesh whole = frames::rotate(frames::rectangle(ElementType::quad4, lines, lines), angle);
  std::vector<std::int64_t> inside;
  for (std::int64_t e = 0; e < whole.elements(); ++e)
    if (std::ranges::all_of(whole.element(e), [&](std::int32_t k) {
          const Vec3& x = whole.node[static_cast<std::size_t>(k)];
          return std::abs(x[0]) < 1.05 + 2 * h && std::abs(x[1]) < half_length + 1.5 * h;
        }))
      inside.push_back(e);
  std::vector<std::int32_t> node;
  return surfaces::part_of(whole, inside, node);
}

SurfaceMesh random_triangles(int across) {
  const auto x = frames::uniform_lines(-1.2, 1.2, across * 6 / 5);
  const auto y = frames::uniform_lines(-half_length, half_length, across * 3);
  return frames::perturb(frames::rectangle(ElementType::tri3, x, y), 0.25, 7);
}

TEST(CarterFlow, along_the_y_axis_of_the_mesh) {
  const auto mesh =
      frames::rectangle(ElementType::quad4, strip_nodes(30), frames::uniform_lines(-half_length, half_length, 12));
  const auto gap = strip_gap(mesh);
  for (const char* scheme : schemes) {
    const Solution along_x = roll(mesh, gap, scheme);
    const Solution along_y = roll(frames::rotate(mesh, pi / 2), gap, scheme, pi / 2);
    double difference = 0;
    for (std::size_t k = 0; k < along_x.nodes(); ++k)
      for (std::size_t i = 0; i < 3; ++i)
        difference = std::max(difference, std::abs(along_x.traction[k][i] - along_y.traction[k][i]));
    // The discrete problem is turned by 90 degrees: only round-off and the integrals' tolerance differ.
    expect_error(std::string(scheme) + ": tractions, flow along y against flow along x", difference / carter.hertz.p0,
                 1e-5);
  }
}

/// Expects the forces of two meshes of sizes h and half of it to have errors of `factor` times their size.
template <class Make>
void expect_first_order(const std::string& what, double h, double factor, Make&& make) {
  for (const char* scheme : schemes) {
    double error[2];
    for (int i = 0; i < 2; ++i) {
      const SurfaceMesh mesh = make(i);
      const Solution s = roll(mesh, strip_gap(mesh), scheme);
      error[i] = rolling_errors(middle_force(s), reference_force()).force;
      const std::string name =
          std::string(scheme) + ", " + what + ", " + std::to_string(std::lround((2 << i) / h)) + " across: ";
      report(name + "traction, relative L2 (plane theory)", middle_traction_error(s));
      expect_error(name + "F/(mu P)", error[i], factor * h / (1 << i));
    }
    report(std::string(scheme) + ": observed order of F/(mu P)", observed_order(error[0], error[1], 2, 1));
  }
}

TEST(CarterFlow_long, at_30_degrees_to_a_grid) {
  // The order is first, with the constant of Godunov's smearing, measured: 0.14 h/a of the force.
  expect_first_order("grid at 30 degrees", 0.2, 0.15, [](int i) { return turned_grid(0.2 / (1 << i), pi / 6); });
}

TEST(CarterFlow_long, on_unstructured_triangles) {
  expect_first_order("triangles", 0.2, 0.23, [](int i) { return random_triangles(10 << i); });
}

}  // namespace
}  // namespace rollcon::validation
