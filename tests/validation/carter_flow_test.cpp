// Carter's problem where the mesh does not follow the flow: flow along the mesh's y axis, at 30 degrees to a grid, and
// over unstructured triangles. First-order upwinding smears there; the errors are reported and bounded by what a
// first-order scheme of that mesh size may cost, not by a wish.

#include "report.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::validation {
namespace {

using closed_forms::Carter;
using namespace scenes;

constexpr double half_length = 3;  // of the short strips with near-isotropic meshes
constexpr double pi = 3.14159265358979323846;

/// F/(mu P) of the strip's middle half by the nodes' weights, and the relative L2 error of its tractions against a
/// function of x.
double middle_force(const Solution& s) {
  double force = 0, load = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    if (std::abs(s.y[k]) > 0.5 * half_length) continue;
    force += s.weight[k] * s.traction[k][0];
    load += s.weight[k] * s.pressure[k];
  }
  return force / (carter.mu * load);
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
  // Loaded ends: OK where the frame reaches beyond them, else the rim is in contact by intent.
  const std::int32_t status = pair.solve();
  EXPECT_TRUE(status == ROLLCON_OK || status == ROLLCON_RIM_CONTACT) << scheme;
  return pair.solution();
}

/// The strip's gap; open beyond its ends.
std::vector<double> strip_gap(const SurfaceMesh& mesh) {
  const Strip strip{carter.hertz, half_length};
  std::vector<double> h;
  for (const Vec3& node : mesh.node)
    h.push_back(std::abs(node[1]) > half_length + 1e-9 ? 100 * strip.approach() : strip.gap({node[0]}, {node[1]})[0]);
  return h;
}

/// What the short strip's middle half gives on a fine aligned frame.
double reference_force() {
  static const double value = [] {
    const auto mesh =
        frames::rectangle(ElementType::quad4, graded_nodes(32), frames::uniform_lines(-half_length, half_length, 16));
    return middle_force(roll(mesh, strip_gap(mesh), "characteristic"));
  }();
  return value;
}

/// Elements of a grid of size h, turned by `angle`, that lie within the strip and its margin.
SurfaceMesh turned_grid(double h, double angle) {
  const int n = static_cast<int>(std::ceil((half_length + 2) / h));
  const auto lines = frames::uniform_lines(-n * h, n * h, 2 * n);
  const SurfaceMesh whole = frames::rotate(frames::rectangle(ElementType::quad4, lines, lines), angle);
  SurfaceMesh part;
  part.offset.push_back(0);
  std::vector<std::int32_t> number(whole.node.size(), -1);
  for (std::int64_t e = 0; e < whole.elements(); ++e) {
    const auto nodes = whole.element(e);
    bool inside = true;
    for (std::int32_t k : nodes) {
      const Vec3& x = whole.node[static_cast<std::size_t>(k)];
      inside = inside && std::abs(x[0]) < 1.05 + 2 * h && std::abs(x[1]) < half_length + 1.5 * h;
    }
    if (!inside) continue;
    for (std::int32_t k : nodes) {
      auto& id = number[static_cast<std::size_t>(k)];
      if (id < 0) {
        id = static_cast<std::int32_t>(part.node.size());
        part.node.push_back(whole.node[static_cast<std::size_t>(k)]);
      }
      part.connectivity.push_back(id);
    }
    part.type.push_back(ElementType::quad4);
    part.tag.push_back(0);
    part.offset.push_back(static_cast<std::int64_t>(part.connectivity.size()));
  }
  return part;
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
    // The same discrete problem turned by 90 degrees: round-off and the integrals' tolerance.
    expect_error(std::string(scheme) + ": tractions, flow along y against flow along x", difference / carter.hertz.p0,
                 1e-5);
  }
}

TEST(CarterFlow_long, at_30_degrees_to_a_grid) {
  for (const char* scheme : schemes) {
    double error[2];
    const double h[2] = {0.2, 0.1};
    for (int i = 0; i < 2; ++i) {
      const SurfaceMesh mesh = turned_grid(h[i], pi / 6);
      const Solution s = roll(mesh, strip_gap(mesh), scheme);
      error[i] = middle_force(s) / reference_force() - 1;
      const std::string name = std::string(scheme) + ", " + std::to_string(std::lround(2 / h[i])) + " nodes across: ";
      report(name + "traction, relative L2 (plane theory)", middle_traction_error(s));
      // First order with the constant of Godunov's smearing: about h/a of the force.
      expect_error(name + "F/(mu P)", error[i], 0.6 * h[i]);
    }
    report(std::string(scheme) + ": observed order of F/(mu P)", observed_order(error[0], error[1], h[0], h[1]));
  }
}

TEST(CarterFlow_long, on_unstructured_triangles) {
  for (const char* scheme : schemes) {
    double error[2];
    const int across[2] = {10, 20};
    for (int i = 0; i < 2; ++i) {
      const SurfaceMesh mesh = random_triangles(across[i]);
      const Solution s = roll(mesh, strip_gap(mesh), scheme);
      error[i] = middle_force(s) / reference_force() - 1;
      const std::string name = std::string(scheme) + ", " + std::to_string(across[i]) + " triangles across: ";
      report(name + "traction, relative L2 (plane theory)", middle_traction_error(s));
      expect_error(name + "F/(mu P)", error[i], 1.2 / across[i]);
    }
    report(std::string(scheme) + ": observed order of F/(mu P)", observed_order(error[0], error[1], 2, 1));
  }
}

}  // namespace
}  // namespace rollcon::validation
