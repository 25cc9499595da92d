// Measures thick walls under pressure from inside (Lame): bodies by themselves, of every element by boundary and by
// finite elements.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "meshes.hpp"
#include "study.hpp"

namespace rollcon::bench {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double young = 1000, poisson = 0.3, inner = 1, outer = 2, pressure = 10;
const scenes::Elastic material{.shear = young / (2 * (1 + poisson)), .poisson = poisson};

void must(std::int32_t status, const char* what) {
  if (status < 0) throw std::runtime_error(std::string("lame: ") + what);
}

struct Wall {
  const char* name;
  surfaces::Block (*shape)(int n);  ///< 2 n by n by n elements; tag 5 is the inner face
  Vec3 (*exact)(const Vec3& x);
  std::vector<scenes::Slide> slide;  ///< planes of symmetry
  std::int32_t given_tag;            ///< tag where the exact displacements are given; 0: nowhere
};

/// Makes a quarter around the y axis, in plane strain.
surfaces::Block cylinder(int n) {
  surfaces::Block b = surfaces::brick({2 * n, n, n}, {pi / 2, 1, outer - inner});
  b.map = [](const Vec3& q) { return Vec3{(inner + q[2]) * std::sin(q[0]), q[1], (inner + q[2]) * std::cos(q[0])}; };
  return b;
}

Vec3 cylinder_displacement(const Vec3& x) {
  const double r = std::hypot(x[0], x[2]), a2 = inner * inner, b2 = outer * outer;
  const double u = pressure * a2 * (1 + poisson) / (young * (b2 - a2)) * ((1 - 2 * poisson) * r + b2 / r);
  return (u / r) * Vec3{x[0], 0, x[2]};
}

/// Makes the part between three planes of symmetry and a cone at 45 degrees, where the displacements are given.
surfaces::Block sphere(int n) {
  surfaces::Block b = surfaces::brick({2 * n, n, n}, {pi / 2, pi / 4, outer - inner});
  b.map = [](const Vec3& q) {
    const double r = inner + q[2], across = r * std::cos(q[1]);
    return Vec3{across * std::cos(q[0]), across * std::sin(q[0]), r * std::sin(q[1])};
  };
  return b;
}

Vec3 sphere_displacement(const Vec3& x) {
  const double r = length(x), a3 = std::pow(inner, 3), b3 = std::pow(outer, 3);
  const double u = pressure * a3 / (young * (b3 - a3)) * ((1 - 2 * poisson) * r + (1 + poisson) * b3 / (2 * r * r));
  return (u / r) * x;
}

const Wall walls[] = {{"cylinder", cylinder, cylinder_displacement, {{1, 1}, {2, 4}, {3, 2}, {4, 2}}, 0},
                      {"sphere", sphere, sphere_displacement, {{1, 2}, {2, 1}, {3, 4}}, 4}};

void give_displacements(rollcon_body* body, const SurfaceMesh& mesh, const Wall& wall) {
  const std::int32_t tag[] = {wall.given_tag};
  const std::vector<std::int32_t> node = surfaces::nodes_with_tag(mesh, tag);
  std::vector<double> value;
  for (const std::int32_t k : node) {
    const Vec3 u = wall.exact(mesh.node[static_cast<std::size_t>(k)]);
    value.insert(value.end(), u.begin(), u.end());
  }
  must(rollcon_body_set_support(body, static_cast<std::int64_t>(node.size()), node.data(), 0, 7, value.data()),
       "set_support");
}

/// Solves from arrays to displacements; fills seconds, bytes, sizes and the error.
void press(const Wall& wall, const scenes::MeshedBody& shape, Record& record) {
  const double began = now();
  rollcon_context* context = nullptr;
  must(rollcon_context_create(ROLLCON_ABI, &context), "context_create");
  must(rollcon_context_set_threads(context, record.threads), "set_threads");
  rollcon_body* body = scenes::make_body(context, shape);
  if (wall.given_tag != 0) give_displacements(body, shape.mesh, wall);
  must(rollcon_body_set_pressure(body, 5, pressure), "set_pressure");
  must(rollcon_body_prepare(body), "prepare");
  std::vector<double> u(3 * shape.mesh.node.size());
  must(rollcon_body_get_displacements(body, shape.mesh.nodes(), u.data()), "get_displacements");
  record.seconds = now() - began;

  double largest = 0, worst = 0;
  for (std::size_t k = 0; k < shape.mesh.node.size(); ++k) {
    const Vec3 exact = wall.exact(shape.mesh.node[k]);
    largest = std::max(largest, length(exact));
    worst = std::max(worst, length(Vec3{u[3 * k], u[3 * k + 1], u[3 * k + 2]} - exact));
  }
  record.value = worst;
  record.error = worst / largest;
  record.nodes = shape.mesh.nodes();
  record.elements = std::max(shape.volume.elements(), shape.mesh.elements());
  const auto stat = [&](const char* name) {
    double value = 0;
    must(rollcon_body_get_stat(body, name, &value), name);
    return value;
  };
  record.unknowns = std::llround(stat("unknowns"));
  record.peak_bytes = std::llround(stat("peak_bytes"));
  for (const char* phase : {"assembly", "order", "factor"})
    record.phase_seconds.emplace_back(phase, stat((std::string("seconds_") + phase).c_str()));
  rollcon_body_release(body);
  rollcon_context_release(context);
}

std::vector<int> sizes(const BodyKind& kind, bool quick) {
  if (quick) return kind.quadratic ? std::vector{1, 2} : std::vector{2, 4};
  if (kind.volume) return kind.quadratic ? std::vector{1, 2, 3, 4, 6, 8} : std::vector{2, 4, 6, 8, 12, 16};
  return kind.quadratic ? std::vector{1, 2, 3, 4, 6} : std::vector{2, 4, 6, 8, 12};
}

void run(Runner& runner) {
  std::vector<BodyKind> kinds = boundary_elements();
  for (BodyKind& kind : finite_elements()) kinds.push_back(std::move(kind));
  for (const Wall& wall : walls)
    for (const BodyKind& kind : kinds)
      for (const int n : sizes(kind, runner.quick)) {
        Record record{.case_name = "lame", .method = kind.volume ? "FEM" : "BEM"};
        record.model = wall.name;
        record.element = kind.name;
        record.mesh = kind.name + ", " + std::to_string(n) + " through the wall";
        record.threads = runner.threads;
        record.quantity = "largest error of a node's displacement";
        record.against = "Lame's closed form";
        scenes::MeshedBody body = meshed_block(wall.shape(n), kind, material);
        body.slide = wall.slide;
        press(wall, body, record);
        add_size(record, n, 0);
        runner.emit(record);
      }
}

}  // namespace

std::vector<Case> lame_cases() {
  return {{"lame", "thick cylinder and sphere under pressure: every element, BEM and FEM", run}};
}

}  // namespace rollcon::bench
