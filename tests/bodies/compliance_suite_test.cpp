// Runs the same checks on every body model.

#include "support/compliance_suite.hpp"

#include "bodies/model/mesh_models.hpp"
#include "bodies/pair.hpp"
#include "support/element_runs.hpp"
#include "support/frames.hpp"
#include "support/section_bodies.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double young = 1e4, poisson = 0.3;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

PlacedCompliance placed(std::shared_ptr<Body> body, std::shared_ptr<const void> owner, SurfaceMesh frame_mesh,
                        const Placement& where) {
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

/// Makes a case of a kind without a mesh.
ComplianceCase unmeshed(BodyKind kind, ElementType type, double nu) {
  ComplianceCase c;
  c.name = traits_of(kind).name + (", " + surfaces::name_of(type)) + ", nu " + std::to_string(nu).substr(0, 3);
  c.young = young;
  c.make = [kind, type, nu](int level, const Placement& where) {
    auto context = std::make_shared<Context>();
    auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(kind));
    body->set_elastic(0, where.stress * young, nu);
    body->prepare();
    return placed(body, context, scaled(frames::perturb(square(type, 4 << level), 0.15, 3), where.length), where);
  };
  c.reciprocity = {1e-5, 1e-5};
  c.block = 1e-12;
  c.placement = 1e-8;
  c.units = 1e-6;
  return c;
}

/// Describes a block [-2, 2]^2 x [-3, 0] held at its bottom, with the contact zone [-1, 1]^2 on its top.
surfaces::ZoneBlock zone_shape(int level) {
  return {.side = 4, .depth = 3, .zone = 2, .n = 4 << level, .grade = 1 << level, .deep = 2 << level};
}

statics::StaticBody elastic_block(ElementType type, int level, const Placement& where) {
  return {scaled(surfaces::zone_block(zone_shape(level), type), where.length), where.stress * young, poisson};
}

statics::StaticBody elastic_block(VolumeType type, int level, const Placement& where) {
  surfaces::ZoneBlock shape = zone_shape(level);
  shape.deep *= 2;
  return {volumes::transform(volumes::zone_block(shape, type), [&](const Vec3& x) { return where.length * x; }),
          where.stress * young, poisson};
}

template <class Type>
std::unique_ptr<statics::StaticBody> zone_body(Type type, int level, const Placement& where,
                                               const std::function<Vec3(const Vec3&)>& held) {
  auto body = std::make_unique<statics::StaticBody>(elastic_block(type, level, where));
  const std::int32_t zone[] = {2};
  body->body().set_contact_faces(1, zone);
  body->hold_tags({3}, 7, held).solve();
  return body;
}

/// Returns the type of elements of a frame of its own.
ElementType frame_type(ElementType type) {
  return type;
}
ElementType frame_type(VolumeType type) {
  return is_quadratic(type) ? ElementType::quad8 : ElementType::quad4;
}

PlacedCompliance on_zone(std::unique_ptr<statics::StaticBody> made, const Placement& where, ElementType type,
                         int own_mesh) {
  const std::shared_ptr<statics::StaticBody> owner = std::move(made);
  std::vector<std::int32_t> unused;
  SurfaceMesh zone = own_mesh > 0
                         ? scaled(square(type, own_mesh), 0.9 * where.length)
                         : surfaces::part_of(owner->mesh(), surfaces::elements_with_tag(owner->mesh(), 2), unused);
  return placed({owner, &owner->body()}, owner, std::move(zone), where);
}

/// Makes a case; with own_mesh a frame of its own is laid on, else the zone's faces are the frame.
template <class Type>
ComplianceCase meshed_body(Type type, const std::string& name, bool own_mesh) {
  ComplianceCase c;
  c.name = name + (own_mesh ? ", frame laid on" : "");
  c.young = young;
  const auto divisions = [own_mesh](int level) { return own_mesh ? 5 << level : 0; };
  c.make = [type, divisions](int level, const Placement& where) {
    return on_zone(zone_body(type, level, where, {}), where, frame_type(type), divisions(level));
  };
  c.moved = [type, divisions](const std::function<Vec3(const Vec3&)>& motion) {
    return on_zone(zone_body(type, 0, {}, motion), {}, frame_type(type), divisions(0));
  };
  const bool quadratic = is_quadratic(type);
  c.reciprocity = quadratic ? std::vector<double>{8e-3, 1e-3} : std::vector<double>{2.3e-2, 2.5e-3};
  c.least_order = quadratic ? 2.5 : 1.7;
  return c;
}

ComplianceCase boundary_elements(ElementType type, bool own_mesh) {
  ComplianceCase c = meshed_body(type, "boundary elements, " + surfaces::name_of(type), own_mesh);
  c.placement = 1e-12;
  c.units = 1e-7;
  c.rigid_motion = 1e-7;
  return c;
}

ComplianceCase finite_elements(VolumeType type, bool own_mesh) {
  ComplianceCase c = meshed_body(type, "finite elements, " + volumes::name_of(type), own_mesh);
  c.placement = 1e-11;
  c.units = 1e-11;
  c.rigid_motion = 1e-11;
  c.least_order = 1.7;
  if (!own_mesh) {
    c.nodal_reciprocity = 1e-12;
    c.reciprocity = {1e-12, 1e-12};  // shape functions between nodes
    c.least_order = 0;
  }
  return c;
}

/// Makes the block without ends, by its section: it repeats along the frame after 4.
ComplianceCase section(ElementType type, bool own_mesh) {
  ComplianceCase c;
  c.name = "section, " + surfaces::name_of(type) + (own_mesh ? ", frame laid on" : "");
  c.young = young;
  c.make = [type, own_mesh](int level, const Placement& where) {
    const surfaces::Block block = surfaces::with_zone(zone_shape(level));
    const double unit = where.length;
    const auto owner = std::make_shared<sections::SectionBody>(
        sections::rectangle({block.line[1], block.line[2]}, type, [&](const Vec3& x) { return unit * x; }),
        where.stress * young, poisson);
    owner->tag(2, [&](const Vec3& x) { return x[2] > -1e-9 * unit && std::abs(x[1]) < 1.001 * unit; }).contact(2);
    owner->hold([&](const Vec3& x) { return x[2] < -2.999 * unit; }).draw_along_x(4 * unit).prepare();
    std::vector<std::int32_t> unused;
    std::vector<std::int64_t> zone;
    const SurfaceMesh& surface = owner->surface();
    for (std::int64_t e = 0; e < surface.elements(); ++e) {
      const auto nodes = surface.element(e);
      if (std::all_of(nodes.begin(), nodes.end(),
                      [&](std::int32_t k) { return std::abs(surface.node[at(k)][0]) < 1.001 * unit; }))
        zone.push_back(e);
    }
    SurfaceMesh frame = own_mesh ? scaled(square(ElementType::quad8, 5 << level), 0.9 * unit)
                                 : surfaces::part_of(surface, zone, unused);
    return placed({owner, &owner->body()}, owner, std::move(frame), where);
  };
  c.expansion = 0;
  c.placement = 1e-11;
  c.units = 1e-9;
  c.reciprocity = is_quadratic(type) ? std::vector<double>{8e-3, 1e-3} : std::vector<double>{2.3e-2, 5e-3};
  c.least_order = 1.7;
  return c;
}

/// Makes the block of finite elements again, by its flexibility on the nodes of its zone.
ComplianceCase condensed() {
  ComplianceCase c = finite_elements(VolumeType::hex8, true);
  c.name = "condensed hex8, frame laid on";
  c.moved = {};
  c.expansion = 0;
  c.make = [](int level, const Placement& where) {
    const std::shared_ptr<statics::StaticBody> from = zone_body(VolumeType::hex8, level, where, {});
    std::vector<std::int32_t> node;
    const auto faces = surfaces::elements_with_tag(from->mesh(), 2);
    const SurfaceMesh zone = surfaces::part_of(from->mesh(), faces, node);
    const RowMatrix<double> flexibility =
        condensed::matrix_on_faces(MatrixForm::flexibility, from->mesh(), faces, *from->body().response(), 1);
    auto context = std::make_shared<Context>();
    auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::condensed));
    body->set_nodes(zone.nodes(), zone.node.front().data(), 3, 1);
    for_runs(zone, [&](std::int32_t type, std::int32_t, std::int64_t count, const std::int32_t* connectivity) {
      body->add_elements(type, count, connectivity, 0, 0);
    });
    body->set_elastic(0, where.stress * young, poisson);
    // Its rows have the nodes of the block in ascending order.
    std::vector<std::int64_t> row;
    for (const std::int32_t k : node)
      for (std::int64_t c = 0; c < 3; ++c)
        row.push_back(3 * std::count_if(node.begin(), node.end(), [&](std::int32_t other) { return other < k; }) + c);
    std::vector<double> ordered;
    for (const std::int64_t i : row)
      for (const std::int64_t j : row) ordered.push_back(flexibility.row(i)[j]);
    body->set_condensed(2, std::ssize(ordered), ordered.data());
    body->prepare();
    return placed(body, context, scaled(square(ElementType::quad4, 5 << level), 0.9 * where.length), where);
  };
  return c;
}

/// Returns one case of every kind that deforms.
std::vector<ComplianceCase> all_models() {
  std::vector<ComplianceCase> all;
  for (const BodyTraits& row : all_kinds()) {
    if (!row.elastic) continue;
    if (!row.meshed)
      all.push_back(unmeshed(row.kind, ElementType::quad4, 0.3));
    else if (row.given)
      all.push_back(condensed());
    else if (row.section)
      all.push_back(section(ElementType::quad8, true));
    else if (row.volume)
      all.push_back(finite_elements(VolumeType::hex8, false));
    else
      all.push_back(boundary_elements(ElementType::quad4, false));
  }
  return all;
}

class BodyModels : public ::testing::TestWithParam<ComplianceCase> {};

TEST_P(BodyModels, superposition) {
  check_superposition(GetParam());
}
TEST_P(BodyModels, written_out) {
  if (GetParam().expansion <= 0) GTEST_SKIP() << "has no equations to write out";
  check_expansion(GetParam());
}
TEST_P(BodyModels, reciprocity) {
  check_reciprocity(GetParam());
}
TEST_P(BodyModels, nodal_reciprocity) {
  check_nodal_reciprocity(GetParam());
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

constexpr auto model_name = [](const auto& param) {
  std::string name = param.param.name;
  for (char& ch : name)
    if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
  return name;
};

INSTANTIATE_TEST_SUITE_P(Compliance, BodyModels, ::testing::ValuesIn(all_models()), model_name);
INSTANTIATE_TEST_SUITE_P(
    Compliance_long, BodyModels,
    ::testing::Values(unmeshed(BodyKind::halfspace, ElementType::tri6, 0.0),
                      boundary_elements(ElementType::tri3, false), boundary_elements(ElementType::quad8, false),
                      boundary_elements(ElementType::quad4, true), boundary_elements(ElementType::quad8, true),
                      finite_elements(VolumeType::hex20, false), finite_elements(VolumeType::tet4, false),
                      finite_elements(VolumeType::tet10, false), finite_elements(VolumeType::wedge6, false),
                      section(ElementType::quad4, true), section(ElementType::quad8, false),
                      finite_elements(VolumeType::wedge15, false), finite_elements(VolumeType::hex8, true),
                      finite_elements(VolumeType::hex20, true)),
    model_name);

// Finite and boundary elements of one block tend to the same work of smooth loads, under one frame laid on it.
TEST(SameBody_long, by_finite_and_by_boundary_elements) {
  constexpr int frame_parts = 6;
  const auto works = [&](auto type, int level) {
    return work_of_smooth_loads(on_zone(zone_body(type, level, {}, {}), {}, ElementType::quad8, frame_parts));
  };
  const auto distance = [](const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] / b[i] - 1));
    return worst;
  };
  const auto reference = works(ElementType::quad8, 1);
  const auto refine = [&](auto type, const std::string& name, double coarse, double fine, int level = 1) {
    const double e0 = distance(works(type, 0), reference), e1 = distance(works(type, level), reference);
    const std::string parts = std::to_string(4 << level);
    expect_error(name + ", 4 x 4 in the zone, work against 8 x 8 quad8", e0, coarse);
    expect_error(name + ", " + parts + " x " + parts + " in the zone, work against 8 x 8 quad8", e1, fine);
    EXPECT_LT(e1, 0.75 * e0) << name;
  };
  refine(ElementType::quad4, "quad4", 0.1, 0.04);
  // A half-space helps under a frame finer than the faces: the coarse mesh is better than its order.
  refine(VolumeType::hex8, "hex8", 0.15, 0.04, 2);
  refine(VolumeType::hex20, "hex20", 0.05, 0.01);
  refine(VolumeType::tet10, "tet10", 0.2, 0.03);
  refine(VolumeType::wedge15, "wedge15", 0.1, 0.015);
}

}  // namespace
}  // namespace rollcon
