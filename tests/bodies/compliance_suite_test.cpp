// Every body model passes the same checks.

#include "support/compliance_suite.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "bodies/pair.hpp"
#include "support/frames.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon {
namespace {

constexpr double young = 1e4, poisson = 0.3;

PlacedCompliance placed(std::shared_ptr<Body> body, std::shared_ptr<const void> owner,
                        SurfaceMesh frame_mesh, const Placement& where) {
  auto context = std::make_shared<Context>();
  auto rigid = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::rigid));
  rigid->prepare();
  Axes axes;
  axes.origin = where.pose.place({0, 0, 0});
  axes.t1 = where.pose.turn({1, 0, 0});
  axes.t2 = where.pose.turn({0, 1, 0});
  axes.n = where.pose.turn({0, 0, 1});
  for (Vec3& x : frame_mesh.node) x = where.pose.place(x);
  auto frame = std::make_shared<Frame>(build_frame(std::move(frame_mesh), axes));
  PairOfBodies pair;
  pair.body = {body.get(), rigid.get()};
  pair.pose[0] = where.pose;
  PlacedCompliance p;
  p.compliance = make_body_compliance(*frame, pair, 0, 1e-6, 1);
  p.frame = frame;
  p.keep = {std::move(owner), rigid, body, frame};
  return p;
}

SurfaceMesh scaled(SurfaceMesh mesh, double length) {
  for (Vec3& x : mesh.node) x = length * x;
  return mesh;
}

SurfaceMesh square(ElementType type, int n) {
  const auto lines = frames::uniform_lines(-1, 1, n);
  return frames::rectangle(type, lines, lines);
}

ComplianceCase halfspace(ElementType type, double nu) {
  ComplianceCase c;
  c.name = "half-space, " + surfaces::name_of(type) + ", nu " + std::to_string(nu).substr(0, 3);
  c.young = young;
  c.make = [type, nu](int level, const Placement& where) {
    auto context = std::make_shared<Context>();
    auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
    body->set_elastic(0, where.stress * young, nu);
    body->prepare();
    return placed(body, context,
                  scaled(frames::perturb(square(type, 4 << level), 0.15, 3), where.length), where);
  };
  c.reciprocity = {1e-5, 1e-5};
  c.block = 1e-12;
  c.placement = 1e-8;
  c.units = 1e-6;
  return c;
}

/// Block [-2, 2]^2 x [-3, 0] held at its bottom, contact zone [-1, 1]^2 on its top.
std::unique_ptr<statics::StaticBody> zone_body(ElementType type, int level, const Placement& where,
                                               const std::function<Vec3(const Vec3&)>& held) {
  const surfaces::ZoneBlock shape{
      .side = 4, .depth = 3, .zone = 2, .n = 4 << level, .grade = 1 << level, .deep = 2 << level};
  auto body = std::make_unique<statics::StaticBody>(
      scaled(surfaces::zone_block(shape, type), where.length), where.stress * young, poisson);
  const std::int32_t zone[] = {2};
  body->body().set_contact_faces(1, zone);
  body->hold_tags({3}, 7, held).solve();
  return body;
}

PlacedCompliance on_zone(std::unique_ptr<statics::StaticBody> made, const Placement& where,
                         ElementType type, int own_mesh) {
  const std::shared_ptr<statics::StaticBody> owner = std::move(made);
  std::vector<std::int32_t> unused;
  SurfaceMesh zone =
      own_mesh > 0
          ? scaled(square(type, own_mesh), 0.9 * where.length)
          : surfaces::part_of(owner->mesh(), surfaces::elements_with_tag(owner->mesh(), 2), unused);
  return placed({owner, &owner->body()}, owner, std::move(zone), where);
}

/// own_mesh: elements along the side of a frame of its own; 0: the zone's faces are the frame.
ComplianceCase boundary_elements(ElementType type, bool own_mesh) {
  ComplianceCase c;
  c.name = "boundary elements, " + surfaces::name_of(type) + (own_mesh ? ", frame laid on" : "");
  c.young = young;
  const auto divisions = [own_mesh](int level) { return own_mesh ? 5 << level : 0; };
  c.make = [type, divisions](int level, const Placement& where) {
    return on_zone(zone_body(type, level, where, {}), where, type, divisions(level));
  };
  c.moved = [type, divisions](const std::function<Vec3(const Vec3&)>& motion) {
    return on_zone(zone_body(type, 0, {}, motion), {}, type, divisions(0));
  };
  const bool quadratic = is_quadratic(type);
  c.reciprocity = quadratic ? std::vector<double>{8e-3, 1e-3} : std::vector<double>{1.5e-2, 4e-3};
  c.least_order = quadratic ? 2.5 : 1.7;
  c.placement = 1e-12;
  c.units = 1e-7;
  c.rigid_motion = 1e-7;
  return c;
}

class BodyModels : public ::testing::TestWithParam<ComplianceCase> {};

TEST_P(BodyModels, superposition) {
  check_superposition(GetParam());
}
TEST_P(BodyModels, reciprocity) {
  check_reciprocity(GetParam());
}
TEST_P(BodyModels, positive_definite) {
  check_positive_definite(GetParam());
}
TEST_P(BodyModels, turned_and_shifted) {
  check_placement(GetParam());
}
TEST_P(BodyModels, units) {
  check_units(GetParam());
}
TEST_P(BodyModels, rigid_motion) {
  check_rigid_motion(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Compliance, BodyModels,
                         ::testing::Values(halfspace(ElementType::quad4, 0.3),
                                           halfspace(ElementType::tri6, 0.0),
                                           boundary_elements(ElementType::quad4, false),
                                           boundary_elements(ElementType::tri3, false),
                                           boundary_elements(ElementType::quad8, false),
                                           boundary_elements(ElementType::quad4, true),
                                           boundary_elements(ElementType::quad8, true)),
                         [](const auto& param) {
                           std::string name = param.param.name;
                           for (char& ch : name)
                             if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
                           return name;
                         });

}  // namespace
}  // namespace rollcon
