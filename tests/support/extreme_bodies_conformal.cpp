/// Makes scenes with conformal zones: a pin, roller or ball in a bore of nearly its radius, with contact that turns by
/// up to 60 degrees to both sides of the axes' normal; and a flange. Rolling is along the bore.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "support/extreme_bodies.hpp"
#include "support/frames.hpp"
#include "support/independent_surface.hpp"

namespace rollcon::extremes {
namespace {

using scenes::AnyBody;
using scenes::Elastic;
using scenes::MeshedBody;

constexpr double degree = std::numbers::pi / 180;

/// Returns the gap along the normal of the bore to the pin in it, which touches it at the origin; from a point of the
/// pin, along its normal to the bore.
double gap_of_pin(const ConformalShape& shape, const Vec3& x) {
  const double pin = 1 - shape.clearance;
  const double angle = std::atan2(x[1], (shape.pin ? pin : 1) - x[2]);
  const double s = shape.clearance * std::sin(angle), c = shape.clearance * std::cos(angle);
  const double crown = shape.crown > 0 ? 0.5 * x[0] * x[0] / shape.crown : 0;
  const double reach = shape.pin ? std::sqrt(1 - s * s) - pin : 1 - std::sqrt(pin * pin - s * s);
  return reach - c + crown;
}

/// Adds a pin that is a body too, whose shape the library finds. It is wider, for the normals of the bore to meet it,
/// and quadratic, for its facets not to stand out further than the clearance.
Scene with_pin(Scene s, const ConformalShape& bore, double stiffness) {
  ConformalShape pin = bore;
  pin.model = bore.model == Model::fem ? Model::bem : Model::fem;
  pin.pin = true;
  pin.face = ElementType::quad8;
  pin.cell = VolumeType::hex20;
  pin.half_angle = 66;
  pin.half_length = 1.2 * bore.half_length;
  pin.n = {4, 10, 1};
  pin.young *= stiffness;
  s.body2 = make_conformal(pin);
  s.pose = turn_body_2;
  s.given.gap.clear();
  return s;
}

/// Makes tread and flange touch at once.
Scene touching_flange(Scene s) {
  s.given.gap.clear();
  for (const Vec3& x : s.given.frame.node) {
    const double along = x[1] < 0 ? x[1] : std::atan2(x[1], 1 - x[2]);
    const double tread = along + 0.5, flange = along - 0.85;
    s.given.gap.push_back(0.03 * std::min(tread * tread, flange * flange) + 0.02 * x[0] * x[0]);
  }
  return s;
}

}  // namespace

MeshedBody make_conformal(const ConformalShape& shape) {
  const double radius = shape.pin ? 1 - shape.clearance : 1, turn = shape.pin ? 1 : -1;
  const double last = shape.half_angle * degree, first = shape.flange ? -1 : -last;
  surfaces::Block block;
  block.line[0] = frames::uniform_lines(-shape.half_length, shape.half_length, shape.n[0]);
  block.line[1] = frames::uniform_lines(first, last, shape.n[1]);
  block.line[2] = frames::uniform_lines(-shape.wall, 0, shape.n[2]);
  block.map = [radius, turn, flange = shape.flange](const Vec3& q) {
    const double r = radius + turn * q[2];
    if (flange && q[1] < 0) return q;
    return Vec3{q[0], r * std::sin(q[1]), turn * (r * std::cos(q[1]) - radius)};
  };
  const Elastic material{.shear = shape.young / (2 * (1 + shape.poisson)), .poisson = shape.poisson};
  MeshedBody body = shape.model == Model::fem ? scenes::meshed(volumes::block(block, shape.cell), material)
                                              : scenes::meshed(surfaces::block(block, shape.face), material);
  body.held_tag = {5};
  body.contact_tag = {6};
  return body;
}

Scene scene_in_bore(const std::string& name, const ConformalShape& shape, double depth, double reach) {
  Scene s;
  s.group = "conformal zones";
  s.name = std::string(shape.model == Model::fem ? "finite" : "boundary") + " elements, " + name;
  s.turn = reach * degree;
  MeshedBody body = make_conformal(shape);
  const int which = shape.pin ? 2 : 1;
  s.frame_body = which;
  s.frame_tag = 6;
  s.given.frame = top_of(body, which);
  s.given.triad = laws::surface_triads(s.given.frame, laws::axes_of(s.given.rolling, s.given.normal));
  s.given.rounding = 4096;
  for (const Vec3& x : s.given.frame.node) s.given.gap.push_back(gap_of_pin(shape, x));
  if (shape.pin) {
    s.body1 = scenes::RigidBody{};
    s.pose = turn_body_2;
  }
  (shape.pin ? s.body2 : s.body1) = std::move(body);
  // The body is dragged and turned so that a part sticks.
  s.approach(depth).friction(0.3);
  const double creep = 0.1 * depth / shape.wall;
  s.creep(creep, -0.5 * creep, 0.5 * creep);
  return s;
}

std::vector<Scene> conformal_scenes() {
  std::vector<Scene> all;
  const auto add = [&](Scene s) -> Scene& {
    all.push_back(std::move(s));
    return all.back();
  };
  for (const Model model : {Model::fem, Model::bem}) {
    const ConformalShape fit{.model = model};
    const auto like = [&](auto change) {
      ConformalShape other = fit;
      change(other);
      return other;
    };
    using Shape = ConformalShape;
    add(scene_in_bore("to 15 degrees", fit, 1e-4, 15));
    add(scene_in_bore("to 30 degrees", fit, 2.5e-4, 30));
    add(scene_in_bore("to 45 degrees", fit, 6e-4, 45));
    const Scene full = scene_in_bore("to 60 degrees", fit, 3e-3, 59);
    add(full);
    // Normals fan out, so more than mu times the load can be carried along the bore.
    constexpr double load = 150, limit = 0.3 * load;
    for (const auto& [part, text] : {std::pair{0.99, "0.99"}, std::pair{1.05, "1.05"}, std::pair{1.3, "1.3"}}) {
      Scene& s = add(full);
      s.name += ", force " + std::string(text) + " of friction times load";
      s.load(load).force(ROLLCON_LONGITUDINAL, part * limit);
      if (part > 1.2) s.right = {ROLLCON_ERR_LOAD};
    }
    // Pressures take part in the balance of these loads.
    Scene& aside = add(full);
    aside.name += ", lateral force";
    aside.force(ROLLCON_LATERAL, 20);
    Scene& turned = add(full);
    turned.name += ", spin moment";
    turned.force(ROLLCON_SPIN, 1);
    add(scene_in_bore("to the body's edges", like([](Shape& o) { o.crown = 0; }), 3e-3, 59));
    add(scene_in_bore("no clearance", like([](Shape& o) { o.crown = o.clearance = 0; }), 1e-3, 59))
        .scheme(laws::Scheme::least_squares);
    add(scene_in_bore("clearance 1e-6", like([](Shape& o) { o.clearance = 1e-6; }), 3e-3, 59))
        .scheme(laws::Scheme::godunov)
        .friction(1);
    const Shape quadratic = like([](Shape& o) {
      o.half_angle = 59;
      o.face = o.model == Model::fem ? ElementType::quad8 : ElementType::quad9;
      o.cell = VolumeType::hex20;
      o.n = {4, 10, 1};
    });
    add(scene_in_bore("quadratic elements", quadratic, 3e-3, 58));
    add(scene_in_bore("triangles", like([](Shape& o) {
                        o.face = ElementType::tri3;
                        o.cell = VolumeType::tet4;
                        o.half_angle = 60;
                      }),
                      3e-3, 55));
    add(scene_in_bore("nearly incompressible", like([](Shape& o) { o.poisson = o.model == Model::fem ? 0.4999 : 0.5; }),
                      3e-3, 59));
    add(scene_in_bore("an elastic pin in a rigid bore", like([](Shape& o) { o.pin = true; }), 3e-3, 59))
        .creep(0, 0, 0.02);
    add(with_pin(scene_in_bore("a pin as stiff as the bore", fit, 3e-3, 59), fit, 1));
    add(with_pin(scene_in_bore("a pin 1e6 times as stiff", fit, 3e-3, 59), fit, 1e6));
    add(scene_in_bore("a ball", like([](Shape& o) { o.crown = 1, o.half_length = 0.15; }), 3e-3, 59));
    add(touching_flange(scene_in_bore("tread and flange", like([](Shape& o) { o.flange = true; }), 5e-3, 55)));
  }
  return all;
}

}  // namespace rollcon::extremes
