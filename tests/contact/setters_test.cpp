/// Tests that caches are keyed by what they depend on, for each setter of the scene and each option: only what depends
/// on the change is made again, and results are those of a fresh contact.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "build_info.hpp"
#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;
using Names = std::set<std::string>;

// The statistics count everything that a solve may do before its iteration.
const std::vector<std::string> counted{
    "body_preparations",   "frame_builds",    "compliance_builds",  "stencil_builds",       "gap_builds",
    "friction_builds",     "slip_builds",     "scale_builds",       "fields_derived",       "laws_checked",
    "displacement_fields", "error_estimates", "kernel_evaluations", "compliance_assemblies"};

const Names nothing{};
const Names scheme{"stencil_builds", "friction_builds",    "slip_builds",
                   "scale_builds",   "kernel_evaluations", "compliance_assemblies"};
const Names whole_frame{"frame_builds", "compliance_builds",  "stencil_builds",
                        "gap_builds",   "friction_builds",    "slip_builds",
                        "scale_builds", "kernel_evaluations", "compliance_assemblies"};
const Names whole_compliance{"compliance_builds", "stencil_builds",     "friction_builds",      "slip_builds",
                             "scale_builds",      "kernel_evaluations", "compliance_assemblies"};

struct Change {
  const char* name;
  std::function<void(Contact&)> apply;
  Names made;  ///< what the setter makes anew, and nothing else
  double bound = 1e-10;
};

void PrintTo(const Change& change, std::ostream* out) {
  *out << change.name;
}

std::vector<double> field_of(const Contact& contact, std::size_t components,
                             const std::function<double(std::size_t)>& value) {
  std::vector<double> v(static_cast<std::size_t>(contact.nodes()) * components);
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = value(k);
  return v;
}

std::function<void(Contact&)> integer(const char* option, std::int64_t value) {
  return [=](Contact& c) { c.scene.options.set_int(option, value); };
}
std::function<void(Contact&)> real(const char* option, double value) {
  return [=](Contact& c) { c.scene.options.set_real(option, value); };
}
std::function<void(Contact&)> text(const char* option, const char* value) {
  return [=](Contact& c) { c.scene.options.set_text(option, value); };
}

std::vector<Change> changes() {
  std::vector<Change> list{
      {"set_creep", [](Contact& c) { c.scene.set_creep(1e-3, 0, 5e-4); }, nothing},
      {"prescribe_approach", [](Contact& c) { c.scene.prescribe(3, 1, 0.019); }, nothing},
      {"prescribe_load", [](Contact& c) { c.scene.prescribe(3, 2, 130); }, nothing},
      {"prescribe_force", [](Contact& c) { c.scene.prescribe(1, 2, 15); }, nothing},
      {"prescribe_spin_moment", [](Contact& c) { c.scene.prescribe(4, 2, 1); }, nothing, 1e-9},
      {"set_friction",
       [](Contact& c) {
         const double mu = 0.2;
         c.scene.set_friction("coulomb", 1, &mu);
       },
       {"friction_builds"}},
      {"set_friction_to_none",
       [](Contact& c) {
         const double mu = 0;
         c.scene.set_friction("coulomb", 1, &mu);
       },
       {"friction_builds"}},
      {"set_friction_field",
       [](Contact& c) {
         const auto mu = field_of(c, 1, [](std::size_t k) { return 0.2 + 1e-3 * (k % 50); });
         c.scene.set_friction_field(c.nodes(), mu.data());
       },
       {"friction_builds"}},
      {"set_gap",
       [](Contact& c) {
         const auto& node = c.scene.mesh().node;
         const auto gap = field_of(
             c, 1, [&](std::size_t k) { return 0.012 * node[k][0] * node[k][0] + 0.011 * node[k][1] * node[k][1]; });
         c.scene.set_gap(c.nodes(), gap.data());
       },
       {"gap_builds"}},
      {"set_gap_quadratic", [](Contact& c) { c.scene.set_gap_quadratic(0.012, 0.011, 1e-4); }, {"gap_builds"}},
      {"set_creep_field",
       [](Contact& c) {
         const auto slip = field_of(c, 2, [](std::size_t k) { return 1e-4 * std::sin(0.1 * k); });
         c.scene.set_creep_field(c.nodes(), slip.data());
       },
       {"slip_builds"}},
      {"set_speed", [](Contact& c) { c.scene.set_speed(3); }, {"slip_builds"}},
      {"set_axes",
       [](Contact& c) {
         const double origin[3] = {0.05, 0, 0}, rolling[3] = {1, 0.2, 0}, normal[3] = {0, 0, 1};
         c.scene.set_axes(origin, rolling, normal);
       },
       whole_frame},
      {"set_frame",
       [](Contact& c) {
         const auto lines = frames::uniform_lines(-1.3, 1.3, 13);
         const SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
         c.scene.set_frame_nodes(mesh.nodes(), mesh.node[0].data(), 3, 1);
         c.scene.add_frame_elements(static_cast<std::int32_t>(mesh.type[0]), mesh.elements(), mesh.connectivity.data(),
                                    0, 1);
       },
       whole_frame},
      {"equal_values",
       [](Contact& c) {
         const double mu = 0.3;
         c.scene.set_friction("coulomb", 1, &mu);
         c.scene.set_gap_quadratic(0.01, 0.01, 0);
         c.scene.set_creep(-2e-3, 5e-4, 1e-3);
         c.scene.set_speed(1);
       },
       nothing},
      {"accuracy", real("accuracy", 1e-7), whole_compliance},
      {"convection", text("convection", "least_squares"), scheme},
      {"monolithic",
       [](Contact& c) { c.scene.options.set_procedure("system=monolithic"); },
       {"scale_builds", "kernel_evaluations"},
       1e-9},
      {"published", [](Contact& c) { c.scene.options.set_procedure("jacobian=simplified"); }, {"scale_builds"}, 1e-9},
  };
  if (ROLLCON_BUILD_PROCEDURES == 0)  // the last two are published procedures
    list.erase(list.end() - 2, list.end());
  for (const int which : {1, 2})
    list.push_back({which == 1 ? "set_pose_1" : "set_pose_2",
                    [which](Contact& c) {
                      const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, up[3] = {1, 2, 3};
                      c.scene.set_pose(which, one, up);
                    },
                    nothing});
  const std::pair<const char*, std::function<void(Contact&)>> free[] = {
      {"tolerance", real("tolerance", 1e-12)},
      {"max_iterations", integer("max_iterations", 60)},
      {"linear_solver_lu", text("linear_solver", "lu")},
      {"linear_solver_gmres", text("linear_solver", "gmres")},
      {"warm_start", integer("warm_start", 0)},
      {"linear_tolerance",
       [](Contact& c) {
         c.scene.options.set_text("linear_solver", "gmres");
         c.scene.options.set_real("linear_tolerance", 1e-8);
       }},
      {"adaptive_tolerance",
       [](Contact& c) {
         c.scene.options.set_text("linear_solver", "gmres_adaptive");
         c.scene.options.set_real("linear_tolerance", 1e-3);
       }},
      {"preconditioner",
       [](Contact& c) {
         c.scene.options.set_text("linear_solver", "gmres");
         c.scene.options.set_text("preconditioner", "kept_lu");
       }},
  };
  for (const auto& [name, apply] : free) list.push_back({name, apply, nothing});
  return list;
}

class setter : public testing::TestWithParam<Change> {};

TEST_P(setter, makes_only_what_depends_on_it) {
  const Change& change = GetParam();
  for (const double other : {0.3, 0.1}) {  // Poisson's ratio: uncoupled, coupled
    Pair pair(1e4, 0.3, 1e4, other), fresh(1e4, 0.3, 1e4, other);
    sharp_scene(pair);
    sharp_scene(fresh);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const auto read = [&] {
      std::vector<double> v;
      for (const std::string& name : counted) v.push_back(pair.contact->stat(name.c_str()));
      return v;
    };
    const std::vector<double> before = read();
    change.apply(*pair.contact);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const std::vector<double> after = read();
    for (std::size_t i = 0; i < counted.size(); ++i)
      EXPECT_EQ(after[i] != before[i], change.made.contains(counted[i]))
          << counted[i] << ": " << before[i] << " before, " << after[i] << " after";
    change.apply(*fresh.contact);
    ASSERT_EQ(fresh.contact->solve(), Status::ok);
    const double off = largest_difference(pair.tractions(), fresh.tractions());
    std::printf("%s, nu2 = %g: against a fresh contact %.1e (bound %.0e)\n", change.name, other, off, change.bound);
    EXPECT_LT(off, change.bound);
  }
}

INSTANTIATE_TEST_SUITE_P(scene, setter, testing::ValuesIn(changes()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(setter_of_friction, adds_tangential_rows_once) {
  for (const double other : {0.3, 0.1}) {
    Pair pair(1e4, 0.3, 1e4, other), fresh(1e4, 0.3, 1e4, other);
    sharp_scene(pair);
    sharp_scene(fresh);
    pair.friction(0);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double one_block = pair.contact->stat("operator_bytes");
    EXPECT_EQ(one_block, 8 * 225 * 225);
    for (const double mu : {0.3, 0.2, 0.0, 0.3}) {
      pair.friction(mu);
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      EXPECT_EQ(pair.contact->stat("compliance_assemblies"), 2);
    }
    EXPECT_EQ(pair.contact->stat("operator_bytes"), (other == 0.3 ? 5 : 9) * one_block);
    ASSERT_EQ(fresh.contact->solve(), Status::ok);
    EXPECT_LT(largest_difference(pair.tractions(), fresh.tractions()), 1e-10);
  }
}

}  // namespace
}  // namespace rollcon
