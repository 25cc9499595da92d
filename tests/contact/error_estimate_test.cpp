/// Tests that error estimates cost nothing until asked for, change nothing, do not depend on units or on how a motion
/// was prescribed, fall with the mesh, and are numbers in any state.

#include "build_info.hpp"
#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double rigid = -2;
constexpr const char* names[] = {"error_estimate_normal", "error_estimate_tangential", "error_estimate_tractions"};
constexpr const char* schemes[] = {"godunov", "least_squares", "characteristic"};

std::unique_ptr<Pair> rolling(int n, double poisson2, const char* scheme = "characteristic") {
  auto pair = std::make_unique<Pair>(1e4, 0.3, 1e4, poisson2);
  standard_scene(*pair, n);
  pair->contact->scene.set_creep(-1.2e-3, 4e-4, 0);
  pair->contact->scene.options.set_text("convection", scheme);
  return pair;
}

std::vector<double> estimates(const Contact& contact) {
  std::vector<double> v;
  for (const char* name : names) v.push_back(contact.stat(name));
  return v;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b, double bound, const char* what) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(a[i] / b[i] - 1);
    std::printf("%s: %s %.6e and %.6e, difference %.1e (bound %.0e)\n", what, names[i], a[i], b[i], difference, bound);
    EXPECT_LE(difference, bound);
  }
}

TEST(error_estimate, is_found_when_asked_for_and_once) {
  const auto pair = rolling(12, 0.3);
  Contact& contact = *pair->contact;
  ASSERT_EQ(contact.solve(), Status::ok);
  EXPECT_EQ(contact.stat("seconds_error_estimate"), 0);
  const double before = contact.stat("kernel_evaluations");
  const double first = contact.stat("error_estimate");
  const double after = contact.stat("kernel_evaluations");
  EXPECT_GT(first, 0);
  EXPECT_GT(after, before);
  EXPECT_GT(contact.stat("seconds_error_estimate"), 0);
  EXPECT_EQ(std::max(contact.stat(names[0]), contact.stat(names[1])), first);
  EXPECT_EQ(contact.stat("kernel_evaluations"), after) << "kept";
  EXPECT_EQ(contact.stat("compliance_assemblies"), 1);
  contact.scene.set_creep(-1.3e-3, 4e-4, 0);
  ASSERT_EQ(contact.solve(), Status::ok);
  EXPECT_EQ(contact.stat("seconds_error_estimate"), 0);
  EXPECT_EQ(contact.stat("kernel_evaluations"), after) << "a solve does not ask for it";
  EXPECT_NE(contact.stat("error_estimate"), first);
}

TEST(error_estimate, changes_nothing) {
  for (const double poisson2 : {0.3, rigid}) {
    const auto asked = rolling(12, poisson2), silent = rolling(12, poisson2);
    for (const double creep : {-1.2e-3, -1.4e-3, 3e-3}) {
      for (Contact* c : {asked->contact.get(), silent->contact.get()}) {
        c->scene.set_creep(creep, 0, 2e-4);
        ASSERT_EQ(c->solve(), Status::ok);
      }
      EXPECT_GT(asked->contact->stat("error_estimate"), 0);
      EXPECT_EQ(asked->tractions(), silent->tractions()) << "to the last bit";
      double a[3], b[3], unused[3];
      for (const Parameter p : {Parameter::longitudinal, Parameter::normal}) {
        asked->contact->sensitivity(p, a, nullptr, nullptr, unused);
        silent->contact->sensitivity(p, b, nullptr, nullptr, unused);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(a[i], b[i]);
      }
      for (const char* name : {"iterations", "law_normal", "law_slip"})
        EXPECT_EQ(asked->contact->stat(name), silent->contact->stat(name)) << name;
    }
  }
}

TEST(error_estimate, is_reproducible) {
  for (const char* scheme : schemes) {
    const auto one = rolling(10, rigid, scheme), two = rolling(10, rigid, scheme);
    ASSERT_EQ(one->contact->solve(), Status::ok);
    ASSERT_EQ(two->contact->solve(), Status::ok);
    EXPECT_EQ(estimates(*one->contact), estimates(*two->contact)) << scheme;
  }
}

TEST(error_estimate, does_not_depend_on_units_or_speed) {
  // The units make lengths 1e3, stresses 1e-7 and the speed 40 times as large.
  constexpr double length = 1e3, stress = 1e-7, speed = 40;
  for (const double poisson2 : {0.3, rigid}) {
    const auto pair = rolling(12, poisson2);
    ASSERT_EQ(pair->contact->solve(), Status::ok);
    Pair other(1e4 * stress, 0.3, 1e4 * stress, poisson2);
    const std::vector<double> lines = frames::uniform_lines(-1.3 * length, 1.3 * length, 12);
    other.frame(frames::rectangle(ElementType::quad4, lines, lines));
    Scene& scene = other.contact->scene;
    scene.set_gap_quadratic(0.01 / length, 0.01 / length, 0);
    other.friction(0.3);
    scene.set_speed(speed);
    scene.prescribe(3, 1, 0.02 * length);
    scene.set_creep(-1.2e-3, 4e-4, 0);
    ASSERT_EQ(other.contact->solve(), Status::ok);
    expect_same(estimates(*other.contact), estimates(*pair->contact), 1e-6, "units");
  }
}

TEST(error_estimate, is_that_of_the_motions_however_they_were_prescribed) {
  for (const double poisson2 : {0.3, rigid}) {
    const auto pair = rolling(12, poisson2);
    Contact& contact = *pair->contact;
    ASSERT_EQ(contact.solve(), Status::ok);
    const std::vector<double> by_motion = estimates(contact);
    double force[3], moment[3];
    contact.resultant(InAxes::local, force, moment);
    contact.scene.prescribe(1, 2, force[0]);
    contact.scene.prescribe(2, 2, force[1]);
    contact.scene.prescribe(4, 2, moment[2]);
    contact.reset();
    ASSERT_EQ(contact.solve(), Status::ok);
    expect_same(estimates(contact), by_motion, 1e-5, "tangential forces given");
  }
}

TEST(error_estimate, is_the_same_after_any_procedure) {
  if (ROLLCON_BUILD_PROCEDURES == 0) GTEST_SKIP() << "this build has no published procedures";
  const auto standard = rolling(10, rigid), monolithic = rolling(10, rigid), published = rolling(10, rigid);
  monolithic->contact->scene.options.set_procedure("system=monolithic");
  published->contact->scene.options.set_procedure("jacobian=b_derivative");
  for (Pair* pair : {standard.get(), monolithic.get(), published.get()}) ASSERT_EQ(pair->contact->solve(), Status::ok);
  expect_same(estimates(*monolithic->contact), estimates(*standard->contact), 1e-5, "monolithic");
  expect_same(estimates(*published->contact), estimates(*standard->contact), 1e-5, "b_derivative");
}

TEST(error_estimate, takes_spin_given_as_a_field_like_spin) {
  const auto pair = rolling(12, 0.3), field = rolling(12, 0.3);
  constexpr double spin = 6e-4;
  pair->contact->scene.set_creep(-1.2e-3, 0, spin);
  ASSERT_EQ(pair->contact->solve(), Status::ok);
  std::vector<double> slip;
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 12);
  const SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
  for (const Vec3& x : mesh.node) {
    slip.push_back(-spin * x[1]);
    slip.push_back(spin * x[0]);
  }
  field->contact->scene.set_creep(-1.2e-3, 0, 0);
  field->contact->scene.set_creep_field(static_cast<std::int64_t>(mesh.node.size()), slip.data());
  ASSERT_EQ(field->contact->solve(), Status::ok);
  expect_same(estimates(*field->contact), estimates(*pair->contact), 1e-5, "creep field");
}

TEST(error_estimate, falls_with_the_mesh) {
  for (const double poisson2 : {0.3, rigid})
    for (const char* scheme : schemes) {
      std::vector<double> sizes[2];
      for (const int finer : {0, 1}) {
        const auto pair = rolling(finer ? 32 : 8, poisson2, scheme);
        ASSERT_EQ(pair->contact->solve(), Status::ok);
        sizes[finer] = estimates(*pair->contact);
      }
      // A mesh four times finer shows order 3/2 for the normal force, about one for the rest.
      const double bound[] = {0.25, 0.6, 0.6};
      for (std::size_t i = 0; i < 3; ++i) {
        std::printf("%s, %s: 8 x 8 %.2e, 32 x 32 %.2e, ratio %.3f (bound %.2f)\n", scheme, names[i], sizes[0][i],
                    sizes[1][i], sizes[1][i] / sizes[0][i], bound[i]);
        EXPECT_LT(sizes[1][i], bound[i] * sizes[0][i]);
      }
    }
}

TEST(error_estimate_long, of_every_kind_of_element) {
  for (const ElementType type :
       {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8, ElementType::quad9})
    for (const char* scheme : schemes) {
      Pair pair(1e4, 0.3, 1e4, rigid);
      const bool quadratic = is_quadratic(type);
      const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, quadratic ? 8 : 16);
      pair.frame(frames::perturb(frames::rectangle(type, lines, lines), 0.15, 7));
      Scene& scene = pair.contact->scene;
      scene.set_gap_quadratic(0.01, 0.01, 0);
      pair.friction(0.3);
      scene.prescribe(3, 2, 150);
      scene.set_creep(-1.2e-3, 0, 2e-4);
      scene.options.set_text("convection", scheme);
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      for (const char* name : names) {
        const double value = pair.contact->stat(name);
        std::printf("%d %s: %s %.2e (0 to 0.7)\n", static_cast<int>(type), scheme, name, value);
        EXPECT_GT(value, 0);
        EXPECT_LT(value, 0.7);
      }
    }
}

TEST(error_estimate, is_a_number_in_every_state) {
  const auto pair = rolling(8, rigid);
  Scene& scene = pair->contact->scene;
  scene.prescribe(3, 1, -0.01);
  ASSERT_EQ(pair->contact->solve(), Status::no_contact);
  for (const char* name : names) EXPECT_EQ(pair->contact->stat(name), 0) << name;
  scene.prescribe(3, 1, 0.02);
  scene.options.set_int("max_iterations", 2);
  ASSERT_EQ(pair->contact->solve(), Status::not_converged);
  for (const char* name : names) EXPECT_EQ(pair->contact->stat(name), 1) << name;
  scene.options.set_int("max_iterations", 500);
  pair->friction(0);
  scene.set_creep(0, 0, 0);
  ASSERT_EQ(pair->contact->solve(), Status::ok);
  EXPECT_GT(pair->contact->stat("error_estimate_normal"), 0);
  EXPECT_EQ(pair->contact->stat("error_estimate_tangential"), 0);
}

TEST(error_estimate, of_contacts_of_a_few_nodes) {
  for (const int n : {1, 2, 3, 4})
    for (const double depth : {1e-4, 4e-3, 2e-2})
      for (const char* scheme : schemes) {
        const auto pair = rolling(n, rigid, scheme);
        pair->contact->scene.prescribe(3, 1, depth);
        const Status status = pair->contact->solve();
        ASSERT_GE(static_cast<int>(status), 0);
        for (const char* name : names) {
          const double value = pair->contact->stat(name);
          EXPECT_TRUE(std::isfinite(value) && value >= 0)
              << n << " elements, approach " << depth << ": " << name << " = " << value;
        }
      }
}

TEST(error_estimate, of_a_frame_that_cannot_be_coarsened_is_unknown) {
  const auto pair = rolling(1, rigid);
  Scene& scene = pair->contact->scene;
  scene.set_gap_quadratic(1e-6, 1e-6, 0);  // all four nodes in contact
  ASSERT_EQ(pair->contact->solve(), Status::coarse);
  EXPECT_EQ(pair->contact->stat("error_estimate_tangential"), 1);
  EXPECT_EQ(pair->contact->stat("error_estimate_tractions"), 1);
}

}  // namespace
}  // namespace rollcon
