#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/extremes_base.hpp"

namespace rollcon::extremes {
namespace {

constexpr Pairing pairings[] = {Pairing::on_rigid, Pairing::twins, Pairing::unlike};

std::string number(const char* what, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s %.7g", what, value);
  return text;
}

std::string label(const char* what, double value, Pairing pairing) {
  return number(what, value) + ", " + name_of(pairing);
}

}  // namespace

const char* name_of(Pairing pairing) {
  switch (pairing) {
    case Pairing::on_rigid:
      return "on rigid";
    case Pairing::twins:
      return "like bodies";
    default:
      return "unlike bodies";
  }
}

scenes::Elastic elastic(double young, double poisson) {
  return {.shear = young / (2 * (1 + poisson)), .poisson = poisson};
}

void set_frame(Scene& scene, SurfaceMesh mesh) {
  scene.given.frame = std::move(mesh);
  scene.given.regular = false;
  std::erase_if(scene.option, [](const auto& option) { return option.first == "accuracy"; });
}

void set_regular_frame(Scene& scene, int n, int m, double a, double b) {
  set_frame(scene,
            frames::rectangle(ElementType::quad4, frames::uniform_lines(-a, a, n), frames::uniform_lines(-b, b, m)));
  scene.given.regular = true;
  scene.set("accuracy", 1e-10);
}

Scene base(const std::string& group, const std::string& name, Pairing pairing) {
  Scene scene;
  scene.group = group;
  scene.name = name;
  scene.body1 = scenes::HalfspaceBody{elastic(1e4, 0.3)};
  if (pairing == Pairing::twins) scene.body2 = scene.body1;
  if (pairing == Pairing::unlike) scene.body2 = scenes::HalfspaceBody{elastic(3e4, 0.2)};
  scene.given.quadratic = {0.01, 0.01, 0};
  set_regular_frame(scene, 12, 12);
  return scene.approach(0.02).friction(0.3).creep(0.006, -0.003, 0.002);
}

double base_load(const Scene& scene) {
  const auto& first = std::get<scenes::HalfspaceBody>(scene.body1).material;
  const auto* second = std::get_if<scenes::HalfspaceBody>(&scene.body2);
  const double e_star =
      second ? closed_forms::effective_modulus(first, second->material) : closed_forms::effective_modulus(first);
  return closed_forms::hertz_from_approach(0.01, 0.01, e_star, 0.02).load;
}

std::vector<Scene> material_scenes() {
  std::vector<Scene> scenes;
  for (int k = -12; k <= 12; k += 2) {
    Scene scene = base("stiffness ratio", number("E2/E1", std::pow(10, k)), Pairing::unlike);
    scene.body2 = scenes::HalfspaceBody{elastic(1e4 * std::pow(10, k), 0.2)};
    scenes.push_back(scene);
  }
  for (int k = -6; k <= 15; k += 3)
    for (const Pairing pairing : {Pairing::on_rigid, Pairing::twins}) {
      const double young = std::pow(10, k);
      Scene scene = base("stiffness", label("E", young, pairing), pairing);
      scene.body1 = scenes::HalfspaceBody{elastic(young, 0.3)};
      if (pairing == Pairing::twins) scene.body2 = scene.body1;
      scenes.push_back(scene);
    }
  for (const double poisson : {-0.9, -0.5, 0.0, 0.3, 0.49, 0.4999, 0.499999, 0.5})
    for (const Pairing pairing : pairings) {
      Scene scene = base("Poisson's ratio", label("nu", poisson, pairing), pairing);
      scene.body1 = scenes::HalfspaceBody{elastic(1e4, poisson)};
      if (pairing == Pairing::twins) scene.body2 = scene.body1;
      scenes.push_back(scene);
    }
  struct Units {
    const char* name;
    double length, pressure;  // the units, in m and Pa
  };
  for (const Units& u : {Units{"m, Pa", 1, 1}, Units{"mm, MPa", 1e-3, 1e6}, Units{"um, GPa", 1e-6, 1e9},
                         Units{"inch, psi", 0.0254, 6894.757}})
    for (const Pairing pairing : pairings) {
      // The sphere has 50 mm and 10 GPa, in the unit's numbers.
      Scene scene = in_units(base("units", std::string(u.name) + ", " + name_of(pairing), pairing), 1e-3 / u.length,
                             1e6 / u.pressure);
      scenes.push_back(scene);
    }
  return scenes;
}

std::vector<Scene> friction_scenes() {
  std::vector<Scene> scenes;
  for (const double mu : {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.3, 0.6, 1.0, 3.0, 10.0})
    for (const Pairing pairing : pairings)
      scenes.push_back(base("friction", label("mu", mu, pairing), pairing).friction(mu));
  for (const Pairing pairing : pairings)
    for (const double low : {0.0, 1e-6, 0.1}) {
      Scene varying = base("friction", label("mu from 0.3 to", low, pairing), pairing);
      Scene jumping = base("friction", label("mu 0.3 and strips of", low, pairing), pairing);
      varying.given.friction.clear();
      jumping.given.friction.clear();
      for (const Vec3& x : varying.given.frame.node) {
        const double part = 0.5 + 0.5 * std::sin(3 * x[0] + 2 * x[1]);
        varying.given.friction.push_back(low + (0.3 - low) * part);
        jumping.given.friction.push_back(part > 0.5 ? 0.3 : low);
      }
      scenes.push_back(varying);
      scenes.push_back(jumping);
    }
  return scenes;
}

std::vector<Scene> motion_scenes() {
  std::vector<Scene> scenes;
  for (const double creep : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e-2, 0.1, 1.0, 10.0, 1e3})
    for (const Pairing pairing : pairings)
      scenes.push_back(base("creepage", label("creepage", creep, pairing), pairing).creep(creep, -0.5 * creep, 0));
  for (const double spin : {1e-15, 1e-9, 1e-4, 0.01, 0.1, 1.0, 1e3})
    for (const Pairing pairing : pairings)
      scenes.push_back(base("spin alone", label("spin", spin, pairing), pairing).creep(0, 0, spin));
  return scenes;
}

std::vector<Scene> load_scenes() {
  std::vector<Scene> scenes;
  for (const double part : {0.0, 0.9, 0.99, 0.999, 0.999999, 1.0, 1.0 + 1e-9, 2.0})
    for (const Pairing pairing : pairings)
      for (const int way : {0, 1, 2}) {
        constexpr const char* ways[] = {"along", "across", "both ways"};
        Scene scene = base(part < 1 ? "tangential force" : "force beyond friction",
                           number(ways[way], part) + " mu Fn, " + name_of(pairing), pairing);
        const double load = base_load(scene), force = part * 0.3 * load;
        scene.load(load).creep(0, 0, 0);
        if (way == 0) scene.force(ROLLCON_LONGITUDINAL, force);
        if (way == 1) scene.force(ROLLCON_LATERAL, -force);
        if (way == 2) scene.force(ROLLCON_LONGITUDINAL, 0.6 * force).force(ROLLCON_LATERAL, 0.8 * force);
        if (part >= 1) scene.right = {ROLLCON_ERR_LOAD};
        scenes.push_back(scene);
      }
  for (const double part : {0.1, 0.5, 0.9})
    for (const Pairing pairing : pairings) {
      // Friction that turns about the middle carries 3 pi / 16 mu Fn a.
      Scene scene = base("tangential force", label("spin moment over that of sliding", part, pairing), pairing);
      const double load = base_load(scene);
      scenes.push_back(scene.load(load).creep(0, 0, 0).force(ROLLCON_SPIN, part * 0.589 * 0.3 * load));
    }
  for (int k = -12; k <= 12; k += 3)
    for (const Pairing pairing : pairings) {
      const double factor = std::pow(10, k), size = std::cbrt(factor);
      Scene scene = base("load", label("frame of the contact's size, load", factor, pairing), pairing);
      const double load = base_load(scene) * factor;
      set_regular_frame(scene, 12, 12, 1.3 * size, 1.3 * size);
      scenes.push_back(scene.load(load).creep(0.006 * size, -0.003 * size, 0.002));
      Scene fixed = base("load", label("same frame, load", factor, pairing), pairing);
      fixed.right = {ROLLCON_OK, ROLLCON_RIM_CONTACT, ROLLCON_COARSE};
      scenes.push_back(fixed.load(load));
    }
  return scenes;
}

Scene in_units(Scene scene, double length, double pressure) {
  const auto rescale = [&](scenes::AnyBody& body) {
    if (auto* half = std::get_if<scenes::HalfspaceBody>(&body)) half->material.shear *= pressure;
  };
  rescale(scene.body1);
  rescale(scene.body2);
  laws::Given& g = scene.given;
  for (Vec3& x : g.frame.node) x = length * x;
  for (double& h : g.gap) h *= length;
  if (g.quadratic)
    for (double& c : *g.quadratic) c /= length;
  g.speed *= length;
  for (double& s : g.creep_field) s *= length;
  for (std::size_t d = 0; d < 4; ++d) {
    const double force = pressure * length * length;
    if (g.by_force[d])
      g.value[d] *= d == 3 ? force * length : force;
    else if (d >= 2)
      g.value[d] *= d == 3 ? 1 / length : length;
  }
  return scene;
}

std::vector<Scene> named_scenes() {
  std::vector<Scene> all;
  for (const auto family : {material_scenes, friction_scenes, motion_scenes, load_scenes, contact_scenes, frame_scenes})
    for (Scene& scene : family()) all.push_back(std::move(scene));
  return all;
}

}  // namespace rollcon::extremes
