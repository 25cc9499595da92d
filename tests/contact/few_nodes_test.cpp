/// Tests that contacts of too few nodes are not called success: status, warnings, plan and estimates say so, and
/// contacts of enough nodes hear nothing of it.

#include "contact/estimate/few_nodes.hpp"

#include <algorithm>

#include "contact/scene_fixture.hpp"
#include "support/closed_forms.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double young = 2e5, poisson = 0.3, depth = 0.01;

struct Warnings {
  std::vector<std::string> text;
  explicit Warnings(Context& context) {
    context.set_log(
        2,
        [](std::int32_t, const char* message, void* user) { static_cast<Warnings*>(user)->text.emplace_back(message); },
        this);
  }
  bool say(const char* words) const {
    return std::any_of(text.begin(), text.end(),
                       [&](const std::string& t) { return t.find(words) != std::string::npos; });
  }
};

/// Presses equal half-spaces with a sphere's gap about (shift, shift) spacings, elements `spacing` Hertzian radii wide.
/// An even n puts a node at the middle.
struct Sphere : Pair {
  closed_forms::Hertz hertz;
  Sphere(double spacing, double shift, double mu, ElementType type = ElementType::quad4)
      : Pair(young, poisson, young, poisson) {
    const double shear = young / (2 * (1 + poisson));
    const closed_forms::Elastic steel{shear, poisson};
    hertz = closed_forms::hertz_from_approach(0.01, 0.01, closed_forms::effective_modulus(steel, steel), depth);
    const double h = spacing * hertz.a * (is_quadratic(type) ? 2 : 1);
    const int n = 2 * static_cast<int>(std::ceil(1.3 * hertz.a / h)) + 2;
    const std::vector<double> lines = frames::uniform_lines(-n * h / 2, n * h / 2, n);
    const SurfaceMesh mesh = frames::rectangle(type, lines, lines);
    frame(mesh);
    std::vector<double> gap;
    for (const Vec3& x : mesh.node) {
      const double dx = x[0] - shift * h, dy = x[1] - shift * h;
      gap.push_back(0.01 * (dx * dx + dy * dy));
    }
    contact->scene.set_gap(static_cast<std::int64_t>(gap.size()), gap.data());
    friction(mu);
    contact->scene.prescribe(3, 1, depth);
    contact->scene.set_creep(mu > 0 ? 1e-3 : 0, 0, 0);
  }
  double force() const {
    double f[3], m[3];
    contact->resultant(InAxes::local, f, m);
    return -f[2];
  }
};

TEST(few_nodes, one_to_four_nodes_are_no_success) {
  for (const double mu : {0.0, 0.3})
    for (const double spacing : {3.0, 2.0, 1.4})
      for (const double shift : {0.0, 0.5}) {
        Sphere s(spacing, shift, mu);
        Warnings warnings(*s.context);
        const Status status = s.contact->solve();
        if (status == Status::no_contact) continue;
        std::printf("spacing %.1f a, shift %.1f, mu %.1f: %g node(s), force off by %.0f %%\n", spacing, shift, mu,
                    s.contact->stat("nodes_contact"), 100 * std::abs(s.force() / s.hertz.load - 1));
        EXPECT_EQ(status, Status::coarse);
        EXPECT_EQ(s.contact->stat("nodes_inside"), 0);
        EXPECT_TRUE(warnings.say("too few nodes in contact to trust"));
        EXPECT_TRUE(warnings.say("finer frame"));
        EXPECT_NE(s.contact->plan().find("too few nodes in contact"), std::string::npos);
        EXPECT_EQ(s.contact->stat("error_estimate"), 1);
        EXPECT_EQ(s.contact->stat("error_estimate_tangential"), mu > 0 ? 1 : 0);
        EXPECT_EQ(s.contact->stat("error_estimate_tractions"), 1);
      }
}

// Every success has a force that means something.
TEST(few_nodes_long, success_is_within_ten_percent) {
  double worst = 0;
  for (const double mu : {0.0, 0.3})
    for (const ElementType type : {ElementType::quad4, ElementType::tri3, ElementType::quad8})
      for (double spacing = 0.25; spacing < 2.5; spacing *= 1.2)
        for (const double shift : {0.0, 0.25, 0.5}) {
          Sphere s(spacing, shift, mu, type);
          if (s.contact->solve() != Status::ok) continue;
          const double off = std::abs(s.force() / s.hertz.load - 1);
          if (off > 0.06)
            std::printf("type %d, mu %.1f, spacing %.2f a, shift %.2f: %g touch, %g inside, off by %.3f\n",
                        static_cast<int>(type), mu, spacing, shift, s.contact->stat("nodes_contact"),
                        s.contact->stat("nodes_inside"), off);
          worst = std::max(worst, off);
        }
  std::printf("normal force off by %.3f at most (bound 0.1)\n", worst);
  EXPECT_LT(worst, 0.1);
  EXPECT_GT(worst, 0.005);
}

TEST(few_nodes, eight_across_are_enough) {
  for (const double mu : {0.0, 0.3})
    for (const ElementType type :
         {ElementType::quad4, ElementType::tri3, ElementType::tri6, ElementType::quad8, ElementType::quad9}) {
      Sphere s(0.25, 0.2, mu, type);
      Warnings warnings(*s.context);
      EXPECT_EQ(s.contact->solve(), Status::ok) << static_cast<int>(type);
      EXPECT_TRUE(warnings.text.empty());
      EXPECT_EQ(s.contact->plan().find("too few"), std::string::npos);
      EXPECT_GE(s.contact->stat("nodes_inside"), 5);
      EXPECT_NE(s.contact->plan().find("error not estimated"), std::string::npos);
      s.contact->stat("error_estimate");
      EXPECT_NE(s.contact->plan().find("the normal force is off by about"), std::string::npos);
    }
}

// A slender contact has many nodes and no inside.
TEST(few_nodes, two_lines_of_many_nodes_are_too_few) {
  Pair pair(young, poisson, young, poisson);
  pair.frame(frames::rectangle(ElementType::quad4, frames::uniform_lines(-2, 2, 8), frames::uniform_lines(-8, 8, 40)));
  pair.contact->scene.set_gap_quadratic(0.05, 0.0003, 0);
  pair.friction(0.3);
  pair.contact->scene.prescribe(3, 1, 0.01);
  EXPECT_EQ(pair.contact->solve(), Status::coarse);
  std::printf("%g nodes touch, %g inside\n", pair.contact->stat("nodes_contact"), pair.contact->stat("nodes_inside"));
  EXPECT_GE(pair.contact->stat("nodes_contact"), 20);
  EXPECT_EQ(pair.contact->stat("nodes_inside"), 0);
}

// Elements within |x|, |y| <= 2 touch; nodes without an open neighbour were counted by hand.
TEST(few_nodes, counts_nodes_without_an_open_neighbour) {
  struct Count {
    ElementType type;
    std::int64_t touching, inside;
  };
  for (const Count& c :
       {Count{ElementType::quad4, 25, 9}, Count{ElementType::tri3, 25, 9}, Count{ElementType::tri6, 81, 49},
        Count{ElementType::quad8, 65, 33}, Count{ElementType::quad9, 81, 49}}) {
    const std::vector<double> lines = frames::uniform_lines(-4, 4, 8);
    const auto on = std::make_shared<Prepared>();
    Solution s;
    s.prepared = on;
    Frame& frame = on->frame;
    frame = build_frame(frames::rectangle(c.type, lines, lines), Axes{});
    std::int64_t touching = 0;
    for (const Vec3& x : frame.mesh.node) {
      const bool open = std::max(std::abs(x[0]), std::abs(x[1])) > 2.01;
      s.iterate.lambda[2].push_back(open ? 0 : -1);
      touching += open ? 0 : 1;
    }
    EXPECT_EQ(touching, c.touching);
    EXPECT_EQ(nodes_inside(s), c.inside) << static_cast<int>(c.type);
    // Nothing is open where the frame ends.
    std::fill(s.iterate.lambda[2].begin(), s.iterate.lambda[2].end(), -1.0);
    EXPECT_EQ(nodes_inside(s), frame.nodes());
  }
}

// The data end with the bodies' surfaces falling away: the load finds its approach at the rim.
TEST(few_nodes, the_end_of_the_data_is_told_with_its_approach) {
  Pair pair(young, poisson, young, poisson);
  const std::vector<double> lines = frames::uniform_lines(-10, 10, 20);
  const SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
  pair.frame(mesh);
  std::vector<double> gap;
  for (const Vec3& x : mesh.node) gap.push_back(0.01 * x[0] * x[0] - (x[1] > 9.5 ? 80 : 0));
  pair.contact->scene.set_gap(static_cast<std::int64_t>(gap.size()), gap.data());
  pair.friction(0);
  pair.contact->scene.prescribe(3, 2, 10);
  Warnings warnings(*pair.context);
  EXPECT_EQ(pair.contact->solve(), Status::coarse) << "goes before rim_contact";
  double found = 0, creep[3];
  pair.contact->motion(&found, creep);
  std::printf("approach %.6g, %g node(s) at the rim\n", found, pair.contact->stat("nodes_rim"));
  EXPECT_LT(found, -79.9);
  EXPECT_GT(pair.contact->stat("nodes_rim"), 0);
  EXPECT_TRUE(warnings.say("too few nodes in contact to trust"));
  EXPECT_TRUE(warnings.say("reaches the rim of the frame"));
  EXPECT_TRUE(warnings.say("approach -79.9") || warnings.say("approach -80"));
}

}  // namespace
}  // namespace rollcon
