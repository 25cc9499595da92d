/// Tests an elastic layer between the bodies: alone it is the brush of the simplified theory, whose tractions grow
/// linearly from where material enters; all forms of the operators agree about it.

#include <algorithm>
#include <cmath>

#include "contact/scene_fixture.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

std::vector<double> field_of(const Pair& pair, Field field) {
  std::vector<double> v(static_cast<std::size_t>(pair.contact->field(field, InAxes::local, 0, nullptr)));
  pair.contact->field(field, InAxes::local, static_cast<std::int64_t>(v.size()), v.data());
  return v;
}

// Bodies that give way 1e-9 times as much leave t = -xi (x0 - x)/L from the node x0 before the contact on, up to mu p.
TEST(layer, a_soft_layer_is_a_brush) {
  constexpr double flexibility = 1e6, creep = 8e6;
  for (const ElementType type : {ElementType::quad4, ElementType::tri3})
    for (const char* operators : {"dense", "table", "fft"}) {
      if (type == ElementType::tri3 && operators[0] != 'd') continue;
      // The grid tells where slip is taken.
      const double spin = type == ElementType::quad4 ? 4e6 : 0;
      Pair pair(1e4, 0.3, 1e4, 0.3);
      standard_scene(pair, 20);
      const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 20);
      pair.frame(frames::rectangle(type, lines, lines));
      Scene& s = pair.contact->scene;
      s.set_gap_quadratic(0.01, 0.01, 0);
      s.options.set_real("tolerance", 1e-12);
      s.options.set_text("operators", operators);
      s.set_layer(flexibility);
      s.set_creep(creep, 0, spin);
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      const std::vector<double> t = pair.tractions(), x = field_of(pair, Field::point);
      double worst = 0;
      int stick = 0, slide = 0;
      for (std::size_t j = 0; j < 21; ++j) {
        double t1 = 0, t2 = 0;
        for (std::size_t i = 20; i-- > 0;) {
          const std::size_t k = 21 * j + i;
          if (!(t[3 * k + 2] < 0)) {
            t1 = t2 = 0;
            continue;
          }
          // Slip is taken 0.3 spacings upstream of the node.
          const double h = x[3 * (k + 1)] - x[3 * k], there = x[3 * k] + 0.3 * h;
          t1 -= h * (creep - spin * x[3 * k + 1]) / flexibility;
          t2 -= h * spin * there / flexibility;
          const double size = std::hypot(t1, t2), bound = -0.3 * t[3 * k + 2];
          if (size > bound) t1 *= bound / size, t2 *= bound / size, ++slide;
          stick += size <= bound;
          worst = std::max({worst, std::abs(t[3 * k] - t1), std::abs(t[3 * k + 1] - t2)});
        }
      }
      std::printf("element %d, %s: %d nodes stick, %d slide, tractions off by %.1e (bound 1e-5)\n",
                  static_cast<int>(type), operators, stick, slide, worst);
      EXPECT_GT(stick, 30);
      EXPECT_GT(slide, 20);
      EXPECT_LE(worst, 1e-5);
    }
}

// The layer gives way about as much as the bodies: the forms agree, and a small creepage causes less force.
TEST(layer, forms_of_the_operators_agree) {
  std::vector<double> first;
  double stiff = 0;
  for (const char* operators : {"dense", "table", "fft"})
    for (const double flexibility : {0.0, 2e-4}) {
      Pair pair(1e4, 0.3, 2e4, 0.2);
      standard_scene(pair, 20);
      Scene& s = pair.contact->scene;
      s.options.set_real("tolerance", 1e-12);
      s.options.set_text("operators", operators);
      s.set_layer(flexibility);
      s.set_creep(5e-4, -2e-4, 1e-3);
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      EXPECT_LE(pair.worst_law(), 1e-6);
      double force[3];
      pair.contact->resultant(InAxes::local, force, nullptr);
      if (flexibility == 0) {
        stiff = std::hypot(force[0], force[1]);
        continue;
      }
      EXPECT_LT(std::hypot(force[0], force[1]), 0.95 * stiff);
      if (first.empty()) first = pair.tractions();
      const double off = largest_difference(pair.tractions(), first);
      std::printf("%s: tractions off the dense ones by %.1e (bound 1e-7)\n", operators, off);
      EXPECT_LE(off, 1e-7);
    }
}

// The layer is set and taken away again; the bodies' displacements are their own.
TEST(layer, changes_and_goes) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  sharp_scene(pair);
  Scene& s = pair.contact->scene;
  pair.contact->solve();
  const std::vector<double> without = pair.tractions();
  s.set_layer(1e-4);
  pair.contact->solve();
  EXPECT_GT(largest_difference(pair.tractions(), without), 1e-3);
  EXPECT_NE(pair.contact->plan().find("elastic layer"), std::string::npos);
  const std::vector<double> u1 = field_of(pair, Field::displacement1), u2 = field_of(pair, Field::displacement2);
  Pair loaded(1e4, 0.3, 1e4, 0.3);
  sharp_scene(loaded);
  s.set_layer(0);
  pair.contact->solve();
  EXPECT_LE(largest_difference(pair.tractions(), without), 1e-11);
  EXPECT_THROW(s.set_layer(-1), Error);
  EXPECT_THROW(s.set_layer(INFINITY), Error);
}

// Rates with a layer are those of the same equations.
TEST(layer, sensitivities_are_those_of_differences) {
  Pair pair(1e4, 0.3, 2e4, 0.2);
  sharp_scene(pair);
  Scene& s = pair.contact->scene;
  s.set_layer(1e-4);
  const auto force = [&](double creep) {
    s.set_creep(creep, 5e-4, 1e-3);
    pair.contact->solve();
    double f[3];
    pair.contact->resultant(InAxes::local, f, nullptr);
    return f[0];
  };
  const double step = 1e-7, difference = (force(-2e-3 + step) - force(-2e-3 - step)) / (2 * step);
  force(-2e-3);
  double f[3], m[3], depth = 0, creep[3];
  pair.contact->sensitivity(Parameter::longitudinal, f, m, &depth, creep);
  std::printf("derivative %.8g, by differences %.8g\n", f[0], difference);
  EXPECT_NEAR(f[0], difference, 1e-5 * std::abs(difference));
}

// A brush that flows has a traction that grows from tc0 on by k xi/(1 + k L) a length instead of xi/L, and no further
// than friction allows; without hardening it stays at tc0.
TEST(layer, a_brush_that_flows) {
  constexpr double flexibility = 1e6, creep = 3e6, yield = 3;
  for (const double hardening : {0.0, 3e-7, 1e-6}) {
    Pair pair(1e4, 0.3, 1e4, 0.3);
    standard_scene(pair, 32);
    Scene& s = pair.contact->scene;
    s.options.set_real("tolerance", 1e-11);
    s.set_layer(flexibility, yield, hardening);
    s.set_creep(creep, 0, 0);
    ASSERT_EQ(pair.contact->solve(), Status::ok) << pair.contact->plan();
    const std::vector<double> t = pair.tractions(), x = field_of(pair, Field::point);
    const double h = x[3] - x[0], slope = hardening * creep / (1 + hardening * flexibility);
    double worst = 0;
    int flows = 0, slides = 0;
    for (std::size_t j = 0; j < 33; ++j) {
      double length = 0;
      bool slid = false;
      for (std::size_t i = 32; i-- > 0;) {
        const std::size_t k = 33 * j + i;
        if (!(t[3 * k + 2] < 0)) {
          length = 0, slid = false;
          continue;
        }
        length += h;
        const double elastic = creep * length / flexibility, bound = -0.3 * t[3 * k + 2];
        const double size = elastic < yield ? elastic : yield + slope * (length - yield * flexibility / creep);
        slid = slid || size >= bound;
        if (slid) {
          slides += elastic >= yield;
          continue;
        }
        flows += elastic >= yield;
        worst = std::max(worst, std::abs(-t[3 * k] - size));
      }
    }
    // The flow and the elastic slip add up to the creepage, wherever in a cell the yield falls.
    std::printf("hardening %.0e: %d nodes flow, %d slide, tractions off by %.1e (bound 1e-6), %g rounds\n", hardening,
                flows, slides, worst, pair.contact->stat("friction_rounds"));
    EXPECT_GT(flows, 100);
    EXPECT_LE(worst, 1e-6);
    EXPECT_LE(pair.worst_law(), 1e-7);
    // Nothing is above the yield without hardening.
    if (hardening == 0) {
      for (std::size_t k = 0; k < t.size() / 3; ++k) EXPECT_LE(std::hypot(t[3 * k], t[3 * k + 1]), yield * (1 + 1e-9));
    }
  }
}

TEST(layer, that_never_flows_is_elastic) {
  Pair pair(1e4, 0.3, 2e4, 0.2), elastic(1e4, 0.3, 2e4, 0.2);
  for (Pair* p : {&pair, &elastic}) {
    sharp_scene(*p);
    p->contact->scene.set_layer(1e-4);
  }
  elastic.contact->solve();
  Scene& s = pair.contact->scene;
  s.set_layer(1e-4, 1e9, 1);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  const double off = largest_difference(pair.tractions(), elastic.tractions());
  std::printf("tractions off those of the elastic layer by %.1e (bound 1e-10)\n", off);
  EXPECT_LE(off, 1e-10);
  // Less friction is mobilised where it flows.
  s.set_layer(1e-4, 4);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  const std::vector<double> t = pair.tractions();
  double greatest = 0;
  for (std::size_t k = 0; k < t.size() / 3; ++k) greatest = std::max(greatest, std::hypot(t[3 * k], t[3 * k + 1]));
  EXPECT_NEAR(greatest, 4, 1e-7);
  const double orthotropic[] = {0.3, 0.2, 0};
  s.set_friction("orthotropic", 3, orthotropic);
  try {
    pair.contact->solve();
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_unsupported);
  }
  s.set_layer(1e-4);
  EXPECT_EQ(pair.contact->solve(), Status::ok);
}

}  // namespace
}  // namespace rollcon
