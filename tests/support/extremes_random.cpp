#include <algorithm>
#include <cmath>
#include <string>

#include "support/extremes_base.hpp"
#include "support/extremes_draw.hpp"
#include "support/frames.hpp"

namespace rollcon::extremes {
namespace {

using laws::Scheme;
using scenes::Elastic;

/// Draws the bodies and returns E*.
double draw_bodies(Draw& d, Scene& scene, double modulus) {
  constexpr double ratios[] = {-0.9, -0.5, 0, 0.2, 0.3, 0.3, 0.45, 0.49, 0.4999, 0.499999, 0.5};
  const Elastic first = elastic(modulus, d.of(ratios));
  scene.body1 = scenes::HalfspaceBody{first};
  switch (d.pick(4)) {
    case 0:
      scene.body2 = scenes::RigidBody{};
      return closed_forms::effective_modulus(first);
    case 1:
      scene.body2 = scene.body1;
      scene.body1 = scenes::RigidBody{};
      return closed_forms::effective_modulus(first);
    case 2:
      scene.body2 = scene.body1;
      return closed_forms::effective_modulus(first, first);
    default:
      break;
  }
  const double ratio = d.chance(0.5) ? d.log_between(1e-12, 1e12) : d.log_between(0.1, 10);
  const Elastic second = elastic(modulus * ratio, d.of(ratios));
  scene.body2 = scenes::HalfspaceBody{second};
  return closed_forms::effective_modulus(first, second);
}

/// Draws a frame over an ellipse of semi-axes a, b.
SurfaceMesh draw_frame(Draw& d, std::uint32_t seed, double a, double b, bool& regular) {
  const double room = d.between(1.1, 1.6);
  const int n = d.chance(0.1) ? 20 + d.pick(12) : 5 + d.pick(11), m = n + d.pick(5);
  constexpr ElementType linear[] = {ElementType::quad4, ElementType::tri3};
  constexpr ElementType quadratic[] = {ElementType::quad8, ElementType::quad9, ElementType::tri6};
  const auto x = frames::uniform_lines(-room * a, room * a, n);
  const auto y = frames::uniform_lines(-room * b, room * b, m);
  switch (d.pick(8)) {
    case 0:
    case 1:
      regular = true;
      return frames::rectangle(ElementType::quad4, x, y);
    case 2:
      return frames::rectangle(ElementType::tri3, x, y);
    case 3:
      return frames::perturb(frames::rectangle(d.of(linear), x, y), d.between(0.05, 0.3), seed);
    case 4:
      return frames::rectangle(d.of(linear), frames::cosine_lines(room * a, n), frames::cosine_lines(room * b, m));
    case 5: {
      const auto half = frames::uniform_lines(-room * a, room * a, std::max(3, n / 2));
      const auto side = frames::uniform_lines(-room * b, room * b, std::max(3, m / 2));
      return frames::rectangle(d.of(quadratic), half, side);
    }
    case 6: {
      // One family of lines drawn close together makes slivers.
      std::vector<double> lines = x;
      const double narrow = d.log_between(1e-4, 0.3);
      for (std::size_t k = 2; k + 1 < lines.size(); k += 2)
        lines[k] = lines[k - 1] + narrow * (lines[k] - lines[k - 1]);
      return d.chance(0.5) ? frames::rectangle(d.of(linear), lines, y) : frames::rectangle(d.of(linear), y, lines);
    }
    default: {
      const auto radii = frames::contact_radii(1, 3 + d.pick(6), room);
      return frames::stretch(frames::ring_disc(ElementType::tri3, radii, frames::ring_counts(radii)), a, b);
    }
  }
}

/// Draws a gap as an array, of several bumps or a ridge, or leaves it unchanged; `depth` is the overlap wanted.
void draw_gap(Draw& d, Scene& scene, double a, double b, double depth) {
  const int kind = d.pick(12);
  if (kind > 5) return;
  std::vector<double> h;
  const double shift = d.between(0.5, 1);
  const int bumps = d.chance(0.5) ? 2 : 5;
  const double turn = d.between(0, 3);
  for (const Vec3& node : scene.given.frame.node) {
    const double x = node[0] / a, y = node[1] / b;
    double value = x * x + y * y;
    if (kind == 0) value = 0;                                  // flat on flat
    if (kind == 1) value = x * x;                              // a ridge up to the rim
    if (kind == 2) value = (x - shift) * (x - shift) + y * y;  // at the rim
    if (kind == 3) value = value * value;                      // blunt
    if (kind > 3) {
      value = INFINITY;
      for (int k = 0; k < bumps; ++k) {
        const double angle = turn + 6.283185307179586 * k / bumps;
        value = std::min(value, std::pow(x - 0.65 * std::cos(angle), 2) + std::pow(y - 0.65 * std::sin(angle), 2));
      }
      value *= 8;
    }
    h.push_back(depth * value);
  }
  scene.given.quadratic.reset();
  scene.given.gap = h;
}

void draw_friction(Draw& d, Scene& scene) {
  constexpr double values[] = {0, 1e-12, 1e-9, 1e-6, 1e-3, 0.05, 0.1, 0.3, 0.3, 0.6, 1, 3, 10};
  const double mu = d.of(values);
  scene.friction(mu);
  if (!d.chance(0.2)) return;
  const bool jumps = d.chance(0.5);
  scene.given.friction.clear();
  for (std::int64_t k = 0; k < scene.given.frame.nodes(); ++k)
    scene.given.friction.push_back(jumps ? (d.chance(0.5) ? mu : 0.01 * mu) : mu * d.between(0.5, 1.5));
}

/// Draws the motion; `scale` is the creepage that would saturate a contact of friction 1, `load` about what will be
/// carried.
void draw_motion(Draw& d, Scene& scene, double scale, double size, double load) {
  const double mu = *std::max_element(scene.given.friction.begin(), scene.given.friction.end());
  const double amount =
      d.chance(0.6) ? scale * std::max(mu, 1e-3) * d.log_between(0.01, 10) : d.log_between(1e-15, 1e3);
  const auto part = [&] { return d.chance(0.4) ? 0 : amount * d.between(-1, 1); };
  scene.creep(part(), part(), d.chance(0.5) ? part() / size : 0);
  if (d.chance(0.05)) scene.creep(0, 0, amount / size);
  if (d.chance(0.7)) return;
  constexpr double fractions[] = {0, 0.1, 0.5, 0.9, 0.99, 0.999, 0.999999, 1, 2};
  const double force = mu * load * (d.chance(0.5) ? d.of(fractions) : d.between(0, 1.2));
  const double angle = d.between(0, 6.283);
  switch (d.pick(4)) {
    case 0:
      scene.force(ROLLCON_LONGITUDINAL, force);
      break;
    case 1:
      scene.force(ROLLCON_LATERAL, -force);
      break;
    case 2:
      scene.force(ROLLCON_LONGITUDINAL, force * std::cos(angle)).force(ROLLCON_LATERAL, force * std::sin(angle));
      break;
    default:
      scene.force(ROLLCON_SPIN, 0.3 * force * size * d.between(-1, 1));
  }
}

}  // namespace

Scene random_scene(std::uint32_t seed) {
  Draw d(seed);
  Scene scene;
  scene.name = std::to_string(seed);
  const double unit = d.chance(0.3) ? d.log_between(1e-6, 1e3) : 1;
  const double modulus = d.chance(0.3) ? d.log_between(1e-6, 1e15) : 1e4;
  const double e_star = draw_bodies(d, scene, modulus);
  const double aspect = d.chance(0.15) ? d.log_between(0.01, 100) : d.log_between(0.25, 4);
  const double a = unit * std::sqrt(aspect), b = unit / std::sqrt(aspect);
  const double strain = d.chance(0.5) ? 0.01 : d.log_between(1e-6, 0.1);  // depth over size
  const auto hertz = closed_forms::hertz_from_axes(a, b, 0.5 * strain * e_star, e_star);
  laws::Given& g = scene.given;
  g.frame = draw_frame(d, seed, a, b, g.regular);
  const double turned = d.chance(0.3) ? d.between(-3.1, 3.1) : 0;
  g.rolling = {std::cos(turned), std::sin(turned), 0};
  if (turned == 0)
    g.quadratic = {hertz.A, hertz.B, 0};
  else
    for (const Vec3& x : g.frame.node) g.gap.push_back(hertz.A * x[0] * x[0] + hertz.B * x[1] * x[1]);
  draw_gap(d, scene, a, b, hertz.approach);
  g.speed = d.chance(0.3) ? d.log_between(1e-6, 1e6) : 1;
  double press = d.between(0.3, 1.1);
  if (d.chance(0.1)) press = d.log_between(1e-12, 1);
  if (d.chance(0.03)) press = d.log_between(1, 1e6);
  if (d.chance(0.01)) press = 0;
  if (d.chance(0.01)) press = -press;
  if (d.chance(0.5) || press < 0)
    scene.approach(hertz.approach * press);
  else
    scene.load(hertz.load * std::pow(press, 1.5));
  draw_friction(d, scene);
  draw_motion(d, scene, 4 * hertz.p0 / e_star, std::sqrt(a * b), hertz.load * std::pow(std::abs(press), 1.5));
  constexpr Scheme schemes[] = {Scheme::characteristic, Scheme::characteristic, Scheme::least_squares, Scheme::godunov};
  scene.scheme(d.of(schemes));
  if (g.regular) {
    constexpr const char* operators[] = {"auto", "auto", "dense", "table", "fft"};
    scene.set("operators", d.operators(operators));
    scene.set("accuracy", 1e-10);  // the accuracy of the tables
  }
  const bool twins =
      scene.body1.index() == scene.body2.index() && std::get<scenes::HalfspaceBody>(scene.body1).material.shear ==
                                                        std::get<scenes::HalfspaceBody>(scene.body2).material.shear;
  const double mu = *std::max_element(g.friction.begin(), g.friction.end());
  scene.group =
      std::string("random: ") + (twins ? "like bodies" : "unlike bodies") + (mu < 0.8 ? ", mu < 0.8" : ", mu 1 to 10");
  scene.right = {ROLLCON_OK, ROLLCON_RIM_CONTACT, ROLLCON_COARSE, ROLLCON_NO_CONTACT};
  if (g.by_force[0] || g.by_force[1] || g.by_force[3]) scene.right.push_back(ROLLCON_ERR_LOAD);
  return scene;
}

}  // namespace rollcon::extremes
