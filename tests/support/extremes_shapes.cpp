// Makes named scenes of shapes of gaps, and of frames.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/extremes_base.hpp"

namespace rollcon::extremes {
namespace {

using laws::Scheme;

constexpr Pairing pairings[] = {Pairing::on_rigid, Pairing::twins, Pairing::unlike};
constexpr Scheme schemes[] = {Scheme::characteristic, Scheme::least_squares, Scheme::godunov};

std::string with(const char* what, Pairing pairing) {
  return std::string(what) + ", " + name_of(pairing);
}

template <class F>
void set_gap(Scene& scene, F h) {
  scene.given.quadratic.reset();
  scene.given.gap.clear();
  for (const Vec3& x : scene.given.frame.node) scene.given.gap.push_back(h(x[0], x[1]));
}

/// Returns the height of the lowest of `count` spheres around the middle; their contacts are apart.
double patches(int count, double x, double y) {
  double h = INFINITY;
  for (int k = 0; k < count; ++k) {
    const double angle = 0.4 + 6.283185307179586 * k / count;
    h = std::min(h, std::pow(x - 0.8 * std::cos(angle), 2) + std::pow(y - 0.8 * std::sin(angle), 2));
  }
  return 0.1 * h;
}

/// Returns lines 1, 1/q, 1/q^2, ... mirrored about 0, down to `smallest`.
std::vector<double> graded_lines(double reach, double smallest, int n) {
  std::vector<double> lines{0};
  const double q = std::pow(reach / smallest, 1.0 / (n - 1));
  for (int k = 0; k < n; ++k) {
    const double x = smallest * std::pow(q, k);
    lines.push_back(x);
    lines.push_back(-x);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

/// Draws every second line towards its neighbour to this fraction of the spacing.
std::vector<double> paired_lines(double reach, int n, double part) {
  std::vector<double> lines = frames::uniform_lines(-reach, reach, n);
  for (std::size_t k = 2; k + 1 < lines.size(); k += 2) lines[k] = lines[k - 1] + part * (lines[k] - lines[k - 1]);
  return lines;
}

}  // namespace

std::vector<Scene> contact_scenes() {
  std::vector<Scene> scenes;
  for (const Pairing pairing : pairings) {
    Scene touching = base("hardly touching", with("approach 0", pairing), pairing).approach(0);
    touching.right = {ROLLCON_NO_CONTACT};
    scenes.push_back(touching);
    for (const double depth : {1e-18, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4}) {
      char text[60];
      std::snprintf(text, sizeof text, "one node, approach %g, %s", depth, name_of(pairing));
      scenes.push_back(base("hardly touching", text, pairing).approach(depth));
    }
    for (const double depth : {-1e-12, -0.02, -1e9}) {
      char text[60];
      std::snprintf(text, sizeof text, "apart by %g, %s", -depth, name_of(pairing));
      Scene apart = base("no contact", text, pairing).approach(depth);
      apart.right = {ROLLCON_NO_CONTACT};
      scenes.push_back(apart);
    }
    Scene unloaded = base("no contact", with("load 0", pairing), pairing).load(0);
    unloaded.right = {ROLLCON_NO_CONTACT};
    scenes.push_back(unloaded);
    for (const int count : {2, 5}) {
      char text[60];
      std::snprintf(text, sizeof text, "%d patches, %s", count, name_of(pairing));
      Scene apart = base("separate patches", text, pairing);
      set_regular_frame(apart, 16, 16);
      set_gap(apart, [&](double x, double y) { return patches(count, x, y); });
      scenes.push_back(apart);
      apart.name += ", unequal";
      for (std::size_t k = 0; k < apart.given.gap.size(); ++k)
        apart.given.gap[k] += 0.009 * (1 + apart.given.frame.node[k][0]);
      scenes.push_back(apart);
    }
    Scene rim = base("at the rim", with("half of the contact", pairing), pairing);
    set_gap(rim, [](double x, double y) { return 0.01 * ((x - 1.3) * (x - 1.3) + y * y); });
    rim.right = {ROLLCON_RIM_CONTACT};
    for (const Scheme scheme : schemes) {
      rim.name = with("half of the contact", pairing) + ", " + name_of(scheme);
      scenes.push_back(rim.scheme(scheme));
    }
    Scene flat = base("flat on flat", "", pairing);
    set_gap(flat, [](double, double) { return 0; });
    flat.right = {ROLLCON_RIM_CONTACT};
    for (const Scheme scheme : schemes) {
      flat.name = with("square with corners", pairing) + ", " + name_of(scheme);
      scenes.push_back(flat.scheme(scheme));
    }
    Scene tilted = flat;
    tilted.name = with("tilted", pairing);
    set_gap(tilted, [](double x, double y) { return 0.004 * (x + 1.3) + 0.002 * (y + 1.3); });
    scenes.push_back(tilted.scheme(Scheme::characteristic));
    for (const double slender : {100.0, 0.01}) {
      Scene scene =
          base("slender",
               slender > 1 ? with("100 : 1 along rolling", pairing) : with("100 : 1 across rolling", pairing), pairing);
      const double a = slender > 1 ? 100 : 1, b = slender > 1 ? 1 : 100;
      const auto hertz = closed_forms::hertz_from_axes(a, b, 0.01, 1.0);
      set_regular_frame(scene, 14, 14, 1.3 * a, 1.3 * b);
      scene.given.quadratic = {hertz.A, hertz.B, 0};
      scenes.push_back(scene.approach(hertz.approach).creep(0.004, -0.002, 1e-5));
    }
  }
  return scenes;
}

std::vector<Scene> frame_scenes() {
  std::vector<Scene> scenes;
  const auto add = [&](const std::string& name, const SurfaceMesh& mesh, double a = 1, double b = 1) {
    for (const Pairing pairing : {Pairing::on_rigid, Pairing::twins})
      for (const Scheme scheme : schemes) {
        Scene scene = base("frames", name + ", " + name_of(pairing) + ", " + name_of(scheme), pairing);
        set_frame(scene, mesh);
        if (a != 1 || b != 1) {
          const auto hertz = closed_forms::hertz_from_axes(a, b, 0.01, 1.0);
          scene.given.quadratic = {hertz.A, hertz.B, 0};
          scene.approach(hertz.approach).creep(0.004, -0.002, 0);
        }
        scenes.push_back(scene.scheme(scheme));
      }
  };
  const auto lines = frames::uniform_lines(-1.3, 1.3, 10);
  const auto coarse = frames::uniform_lines(-1.3, 1.3, 6);
  const auto linear = {ElementType::quad4, ElementType::tri3};
  for (const ElementType type : linear) {
    const std::string kind = type == ElementType::quad4 ? "quadrilaterals" : "triangles";
    const SurfaceMesh square = frames::rectangle(type, lines, lines);
    add(kind + ", perturbed", frames::perturb(square, 0.3, 7));
    const SurfaceMesh few = frames::rectangle(type, coarse, coarse);  // few elements, because integrals take long there
    add(kind + " 1000 : 1 along", frames::stretch(few, 1000, 1), 1000, 1);
    add(kind + " 1 : 1000 across", frames::stretch(few, 1, 1000), 1, 1000);
    add(kind + ", slivers along", frames::rectangle(type, lines, paired_lines(1.3, 10, 1e-3)));
    add(kind + ", slivers across", frames::rectangle(type, paired_lines(1.3, 10, 1e-3), lines));
    add(kind + ", sizes over 1e4", frames::rectangle(type, graded_lines(1.3, 1.3e-4, 7), graded_lines(1.3, 1.3e-4, 7)));
    add(kind + ", nodes 1e-9 apart", frames::rectangle(type, paired_lines(1.3, 10, 1e-8), paired_lines(1.3, 10, 1e-8)));
  }
  const auto radii = frames::contact_radii(1, 5, 1.3);
  add("rings of triangles", frames::ring_disc(ElementType::tri3, radii, frames::ring_counts(radii)));
  for (const auto& [type, kind] : {std::pair{ElementType::quad8, "quad8"}, std::pair{ElementType::quad9, "quad9"},
                                   std::pair{ElementType::tri6, "tri6"}}) {
    const SurfaceMesh mesh = frames::rectangle(type, coarse, coarse);
    add(kind, mesh);
    add(std::string(kind) + ", midsides displaced by 0.1", frames::bend_midsides(mesh, 0.1, 3));
  }
  for (const int n : {2, 3, 5, 24, 40, 100})
    for (const Pairing pairing : {Pairing::on_rigid, Pairing::twins}) {
      char text[80];
      std::snprintf(text, sizeof text, "regular, %d nodes, %s", (n + 1) * (n + 1), name_of(pairing));
      Scene scene = base("frames", text, pairing);
      set_regular_frame(scene, n, n);
      scene.given.regular = n > 1;
      scenes.push_back(scene);
    }
  return scenes;
}

}  // namespace rollcon::extremes
