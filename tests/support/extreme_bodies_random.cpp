#include <algorithm>
#include <cmath>
#include <string>

#include "support/extreme_bodies.hpp"
#include "support/extremes_draw.hpp"
#include "support/frames.hpp"

namespace rollcon::extremes {
namespace {

using scenes::AnyBody;
using scenes::Elastic;
using scenes::MeshedBody;

enum class Kind { fem, bem, halfspace, rigid };

double draw_poisson(Draw& d, Kind kind, VolumeType cell) {
  constexpr double all[] = {-0.9, 0, 0.2, 0.3, 0.3, 0.45, 0.49, 0.4999, 0.499999, 0.5};
  const double nu = d.of(all);
  if (kind != Kind::fem) return nu;
  const bool stiff = cell == VolumeType::tet4 || cell == VolumeType::wedge6;
  return std::min(nu, stiff ? 0.45 : 0.4999999);
}

/// Draws lines of a graded block: towards one end, the middle, or two of them nearly together.
std::vector<double> draw_lines(Draw& d, int n) {
  std::vector<double> line;
  const double power = d.between(1, 5);
  const int kind = d.pick(3);
  for (int i = 0; i <= n; ++i) {
    const double t = -1 + 2.0 * i / n;
    if (kind == 0) line.push_back(-1 + 2 * std::pow(0.5 * (t + 1), power));
    if (kind == 1) line.push_back(std::copysign(std::pow(std::abs(t), power), t));
    if (kind == 2) line.push_back(t);
  }
  if (kind == 2 && n > 2) line[1] = line[2] - d.log_between(1e-6, 0.3) * (line[2] - line[1]);
  line.back() = 1;
  return line;
}

/// Draws a block with half sizes 1 x 1 times `size` and a small mesh; with `frame`, its top may be the frame.
BlockShape draw_block(Draw& d, Kind kind, std::uint32_t seed, double size, bool frame) {
  BlockShape s;
  s.seed = seed;
  s.model = kind == Kind::fem ? Model::fem : Model::bem;
  constexpr ElementType faces[] = {ElementType::quad4, ElementType::quad4, ElementType::tri3,
                                   ElementType::quad8, ElementType::tri6,  ElementType::quad9};
  constexpr VolumeType cells[] = {VolumeType::hex8,  VolumeType::hex8,   VolumeType::tet4,   VolumeType::tet10,
                                  VolumeType::hex20, VolumeType::wedge6, VolumeType::wedge15};
  s.face = d.of(faces);
  s.cell = d.of(cells);
  const bool quadratic = s.model == Model::fem ? is_quadratic(s.cell) : is_quadratic(s.face);
  const int n = quadratic ? 2 + d.pick(2) : 3 + d.pick(4);
  s.n = {n, std::max(2, n - d.pick(2)), 1 + d.pick(quadratic ? 2 : 3)};
  const double depth = d.chance(0.3) ? d.log_between(1e-3, 30) : d.between(0.7, 2);
  s.half = {size, size, depth * size};
  if (d.chance(0.2))
    for (std::size_t c = 0; c < 3; ++c)
      if (d.chance(0.5)) s.line[c] = draw_lines(d, s.n[c]);
  if (d.chance(0.3)) s.distort = d.between(0.02, quadratic ? 0.1 : 0.25);
  // Walls stay steep, because beyond this the top's normals would lean at its edges.
  if (frame && d.chance(0.15)) s.shear = {d.between(-0.8, 0.8), d.between(-0.8, 0.8), d.between(-2, 2)};
  if (frame && d.chance(0.03)) s.shear[2] = d.chance(0.5) ? -30 : 30;
  if (d.chance(0.15)) s.held = {1, 2};
  if (d.chance(0.05)) s.held = {1};
  s.young = 1e4;
  s.poisson = draw_poisson(d, kind, s.cell);
  return s;
}

Elastic material_of(const AnyBody& body) {
  if (const auto* half = std::get_if<scenes::HalfspaceBody>(&body)) return half->material;
  return *std::get<MeshedBody>(body).material;
}

bool rigid(const AnyBody& body) {
  return std::holds_alternative<scenes::RigidBody>(body);
}

/// Says whether a block held at its ends alone bends so easily beside its own elements that its equations are singular
/// to rounding. Their condition goes with (length/thickness)^4/(1 - 2 nu) over the factor of the first bending mode of
/// a beam, clamped at one end or at both; 1500 times that for hex20, less for the others.
bool bends_beyond_rounding(const BlockShape& s) {
  constexpr double singular = 1e15;  // no digit is left
  if (s.model != Model::fem || std::count(s.held.begin(), s.held.end(), 5) > 0) return false;
  const double beam = s.held.size() == 1 ? 12.36 : 500.6;
  const double slender = 2 * s.half[0] / s.half[2];
  return 1500 / beam * std::pow(slender, 4) / (1 - 2 * s.poisson) >= singular;
}

AnyBody draw_body(Draw& d, Kind kind, std::uint32_t seed, double size, double young, bool frame, Scene& scene) {
  if (kind == Kind::rigid) return scenes::RigidBody{};
  if (kind == Kind::halfspace) {
    const double nu = draw_poisson(d, kind, VolumeType::hex8);
    return scenes::HalfspaceBody{{.shear = young / (2 * (1 + nu)), .poisson = nu}};
  }
  BlockShape s = draw_block(d, kind, seed, size, frame);
  s.young = young;
  if (bends_beyond_rounding(s)) scene.right.push_back(ROLLCON_ERR_SINGULAR);
  MeshedBody body = make_block(s);
  if (d.chance(0.05)) body.option.emplace_back("accuracy", d.chance(0.5) ? 1e-9 : 1e-4);
  if (d.chance(0.05)) body.option.emplace_back("edge_angle", d.chance(0.5) ? 1.0 : 80.0);
  if (d.chance(0.1)) body.int_option.emplace_back("keep_factors", 0);
  if (d.chance(0.1)) body.int_option.emplace_back("prepare", 0);
  if (kind == Kind::fem) d.chance(0.2);  // keeps the draws of later scenes unchanged
  if (kind == Kind::fem && d.chance(0.1)) body.int_option.emplace_back("hex8", 1);
  return body;
}

/// Draws a frame of its own within the half width.
SurfaceMesh draw_laid_frame(Draw& d, std::uint32_t seed, double half) {
  const int n = 4 + d.pick(6), m = n + d.pick(3);
  const auto x = frames::uniform_lines(-half, half, n);
  const auto y = frames::uniform_lines(-half * d.between(0.3, 1), half * d.between(0.3, 1), m);
  constexpr ElementType linear[] = {ElementType::quad4, ElementType::tri3};
  SurfaceMesh mesh = frames::rectangle(d.of(linear), x, y);
  return d.chance(0.4) ? frames::perturb(std::move(mesh), d.between(0.05, 0.3), seed) : mesh;
}

void draw_gap(Draw& d, Scene& scene, double a, double curvature, double depth) {
  laws::Given& g = scene.given;
  g.quadratic = {curvature, curvature, 0};
  const int kind = d.pick(10);
  if (kind > 3) return;
  g.quadratic.reset();
  const double shift = d.between(0.6, 1.5);
  for (const Vec3& node : g.frame.node) {
    const double x = node[0] / a, y = node[1] / a;
    double h = x * x;                                      // a ridge
    if (kind == 0) h = 0;                                  // flat on flat, up to the rim
    if (kind == 1) h = (x - shift) * (x - shift) + y * y;  // off the middle, perhaps at the rim
    if (kind == 2)                                         // two bumps
      h = 4 * std::min((x - 0.7) * (x - 0.7) + y * y, (x + 0.7) * (x + 0.7) + y * y);
    g.gap.push_back(depth * h);
  }
}

void draw_loads(Draw& d, Scene& scene, const closed_forms::Hertz& hertz, double e_star) {
  constexpr double frictions[] = {0, 1e-9, 1e-3, 0.05, 0.3, 0.3, 0.6, 1, 3};
  const double mu = d.of(frictions);
  scene.friction(mu);
  if (d.chance(0.1))
    for (std::size_t k = 1; k < scene.given.frame.node.size(); ++k)
      scene.given.friction.push_back(d.chance(0.5) ? mu : 0.1 * mu);
  double press = d.between(0.3, 1.1);
  if (d.chance(0.1)) press = d.log_between(1e-12, 1);
  if (d.chance(0.03)) press = d.log_between(1, 1e4);
  if (d.chance(0.02)) press = 0;
  if (d.chance(0.5))
    scene.approach(hertz.approach * press);
  else
    scene.load(hertz.load * std::pow(press, 1.5));
  const double saturating = 4 * std::max(mu, 1e-3) * hertz.p0 / e_star;
  const double amount = d.chance(0.7) ? saturating * d.log_between(0.01, 10) : d.log_between(1e-15, 1e3);
  const auto part = [&] { return d.chance(0.4) ? 0 : amount * d.between(-1, 1); };
  scene.creep(part(), part(), d.chance(0.4) ? part() / hertz.a : 0);
  if (d.chance(0.8)) return;
  constexpr double fractions[] = {0, 0.1, 0.5, 0.9, 0.99, 0.999999, 1, 2};
  const double force = mu * hertz.load * std::pow(press, 1.5) * d.of(fractions);
  scene.force(d.chance(0.5) ? ROLLCON_LONGITUDINAL : ROLLCON_LATERAL, force);
}

}  // namespace

Scene random_body_scene(std::uint32_t seed) {
  Draw d(seed);
  Scene scene;
  scene.group = "random bodies";
  scene.given.rounding = 4096;
  scene.name = std::to_string(seed);
  constexpr Kind kinds[] = {Kind::fem, Kind::fem, Kind::bem, Kind::bem, Kind::halfspace, Kind::rigid, Kind::rigid};
  Kind first = d.of(kinds), second = d.of(kinds);
  const auto meshed = [](Kind kind) { return kind == Kind::fem || kind == Kind::bem; };
  if (!meshed(first) && !meshed(second)) (d.chance(0.5) ? first : second) = d.chance(0.5) ? Kind::fem : Kind::bem;
  const double unit = d.chance(0.3) ? d.log_between(1e-6, 1e3) : 1;
  const double young = d.chance(0.3) ? d.log_between(1e-6, 1e15) : 1e4;
  const double ratio = d.chance(0.3) ? d.log_between(1e-12, 1e12) : d.log_between(0.1, 10);

  // The other body is larger than the one whose faces are the frame.
  const bool laid = d.chance(0.4);
  int whose = meshed(first) ? 1 : 2;
  if (meshed(first) && meshed(second) && d.chance(0.5)) whose = 2;
  const double room = laid ? 1 : 1.2;
  scene.right = {ROLLCON_OK, ROLLCON_RIM_CONTACT, ROLLCON_COARSE, ROLLCON_NO_CONTACT};
  scene.body1 = draw_body(d, first, seed, unit * (whose == 1 ? 1 : room), young, !laid && whose == 1, scene);
  scene.body2 =
      draw_body(d, second, seed + 1, unit * (whose == 2 ? 1 : room), young * ratio, !laid && whose == 2, scene);
  double e_star = 0;
  if (rigid(scene.body1) || rigid(scene.body2))
    e_star = closed_forms::effective_modulus(material_of(rigid(scene.body1) ? scene.body2 : scene.body1));
  else
    e_star = closed_forms::effective_modulus(material_of(scene.body1), material_of(scene.body2));
  if (meshed(second)) scene.pose = turn_body_2;

  laws::Given& g = scene.given;
  const auto* owner = std::get_if<MeshedBody>(whose == 1 ? &scene.body1 : &scene.body2);
  const ElementType type = owner->mesh.type.front();
  // Contacts of a few nodes with vertices whose shape functions have no mean may have no answer, and nodes on held
  // edges cannot be pressed.
  if (laid || type == ElementType::tri6 || type == ElementType::quad8 || owner->held_tag[0] != 5) {
    g.frame = draw_laid_frame(d, seed, unit * d.between(0.2, 0.45));
  } else {
    scene.frame_body = whose;
    scene.frame_tag = 6;
    g.frame = top_of(*owner, whose);
  }
  g.regular = equal_cells(g.frame);
  const double half = scene.frame_body == 0 ? std::abs(g.frame.node.front()[0]) : unit;
  const double size = half * d.between(0.3, 0.9);
  const double strain = d.chance(0.5) ? 0.01 : d.log_between(1e-5, 0.1);
  const auto hertz = closed_forms::hertz_from_axes(size, size, 2 / 3.14159265 * e_star * strain, e_star);
  draw_gap(d, scene, size, hertz.A, hertz.approach);
  draw_loads(d, scene, hertz, e_star);
  g.speed = d.chance(0.2) ? d.log_between(1e-6, 1e6) : 1;
  constexpr laws::Scheme schemes[] = {laws::Scheme::characteristic, laws::Scheme::least_squares, laws::Scheme::godunov};
  scene.scheme(d.of(schemes));
  if (g.by_force[0] || g.by_force[1]) scene.right.push_back(ROLLCON_ERR_LOAD);
  // Folded elements, frames beyond a sheared body, and thin bodies of boundary elements are refused.
  scene.right.push_back(ROLLCON_ERR_MESH);
  return scene;
}

}  // namespace rollcon::extremes
