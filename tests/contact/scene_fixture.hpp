#pragma once
/// Makes a half-space scene for tests of the solver itself.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "build_info.hpp"
#include "contact/contact.hpp"
#include "procedures/published.hpp"
#include "support/frames.hpp"

namespace rollcon::contact_test {

#if ROLLCON_BUILD_PROCEDURES
inline constexpr MakePublished published = make_published;
#else
inline constexpr MakePublished published = nullptr;
#endif

struct Pair {
  std::shared_ptr<Context> context = std::make_shared<Context>();
  std::shared_ptr<Body> body1, body2;
  std::unique_ptr<Contact> contact;

  /// Poisson's ratio below -1 makes a body rigid.
  Pair(double young1, double poisson1, double young2, double poisson2) {
    context->set_threads(1);
    const auto make = [&](double young, double poisson) {
      auto body = std::make_shared<Body>(context, poisson < -1 ? 4 : 3);
      if (poisson >= -1) body->set_elastic(1, young, poisson);
      return body;
    };
    body1 = make(young1, poisson1);
    body2 = make(young2, poisson2);
    contact = std::make_unique<Contact>(context, body1, body2, published);
  }

  void frame(const SurfaceMesh& mesh) {
    Scene& s = contact->scene;
    s.set_frame_nodes(mesh.nodes(), mesh.node[0].data(), 3, 1);
    s.add_frame_elements(static_cast<std::int32_t>(mesh.type[0]), mesh.elements(), mesh.connectivity.data(), 0, 1);
  }
  void friction(double mu) { contact->scene.set_friction("coulomb", 1, &mu); }
  std::vector<double> tractions() const {
    std::vector<double> t(static_cast<std::size_t>(3 * contact->nodes()));
    contact->tractions(InAxes::local, contact->nodes(), t.data());
    return t;
  }
  double worst_law() const {
    double worst = 0;
    for (const char* name : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
      worst = std::max(worst, contact->stat(name));
    return worst;
  }
};

/// Sets a square quadrilateral frame of n x n elements, half-width 1.3, and the gap of a sphere of radius 50.
inline void standard_scene(Pair& pair, int n) {
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, n);
  pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
  pair.contact->scene.set_gap_quadratic(0.01, 0.01, 0);
  pair.friction(0.3);
  pair.contact->scene.prescribe(3, 1, 0.02);
}

/// Sets rolling on 15 x 15 nodes, tolerance 1e-13, dense operators.
inline void sharp_scene(Pair& pair) {
  standard_scene(pair, 14);
  Scene& s = pair.contact->scene;
  s.set_creep(-2e-3, 5e-4, 1e-3);
  s.options.set_real("tolerance", 1e-13);
  s.options.set_text("operators", "dense");
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0, scale = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    worst = std::max(worst, std::abs(a[k] - b[k]));
    scale = std::max(scale, std::abs(b[k]));
  }
  return scale > 0 ? worst / scale : worst;
}

}  // namespace rollcon::contact_test
