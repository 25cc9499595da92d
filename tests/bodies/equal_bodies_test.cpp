// Tests that bodies of equal content in one context are prepared once and held once, and that different ones are not
// taken for equal.

#include "bodies/equal_bodies.hpp"

#include <thread>

#include "bodies/body.hpp"
#include "build_info.hpp"
#include "support/error.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

using Change = std::function<void(Body&)>;

/// Returns the kinds with meshes of this build.
std::vector<BodyKind> meshed_kinds(bool with_rigid) {
  std::vector<BodyKind> kinds;
  if (ROLLCON_BUILD_FEM != 0) kinds.push_back(BodyKind::fem);
  if (ROLLCON_BUILD_BEM != 0) kinds.push_back(BodyKind::bem);
  if (with_rigid) kinds.push_back(BodyKind::rigid);
  return kinds;
}

constexpr std::int32_t top = 6;

void give_surface(Body& body, const SurfaceMesh& mesh) {
  body.set_nodes(mesh.nodes(), mesh.node[0].data(), 3, 1);
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    body.add_elements(static_cast<std::int32_t>(mesh.type[static_cast<std::size_t>(e)]), 1, mesh.element(e).data(), 0,
                      mesh.tag[static_cast<std::size_t>(e)]);
}

std::vector<std::int32_t> nodes_at_bottom(const std::vector<Vec3>& node) {
  std::vector<std::int32_t> found;
  for (std::size_t k = 0; k < node.size(); ++k)
    if (node[k][2] == 0) found.push_back(static_cast<std::int32_t>(k));
  return found;
}

/// Makes a brick held at its bottom, not prepared.
std::shared_ptr<Body> brick(const std::shared_ptr<Context>& context, BodyKind kind, const Change& change = {}) {
  auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(kind));
  if (kind == BodyKind::fem) {
    const volumes::Mesh mesh = volumes::block(surfaces::brick({3, 3, 3}, {1, 1, 1}), VolumeType::hex8);
    const std::vector<Vec3>& node = mesh.surface.node;
    body->set_nodes(mesh.surface.nodes(), node[0].data(), 3, 1);
    body->add_elements(static_cast<std::int32_t>(VolumeType::hex8), mesh.volume.elements(),
                       mesh.volume.connectivity.data(), 0, 0);
    body->set_elastic(0, 200, 0.3);
    const auto held = nodes_at_bottom(node);
    body->set_support(static_cast<std::int64_t>(held.size()), held.data(), 0, 7, nullptr);
  } else {
    const SurfaceMesh mesh = surfaces::block(surfaces::brick({3, 3, 3}, {1, 1, 1}), ElementType::quad4);
    give_surface(*body, mesh);
    if (kind == BodyKind::bem) {
      body->set_elastic(0, 200, 0.3);
      const auto held = nodes_at_bottom(mesh.node);
      body->set_support(static_cast<std::int64_t>(held.size()), held.data(), 0, 7, nullptr);
    }
  }
  if (change) change(*body);
  return body;
}

TEST(EqualBodies, share_one_preparation) {
  for (const BodyKind kind : meshed_kinds(true)) {
    const auto context = std::make_shared<Context>();
    const auto first = brick(context, kind), second = brick(context, kind);
    first->prepare();
    EXPECT_FALSE(first->same_as(*second));
    second->prepare();
    EXPECT_TRUE(first->same_as(*second));
    EXPECT_FALSE(first->shared());
    EXPECT_TRUE(second->shared());
    EXPECT_EQ(first->response(), second->response());
    EXPECT_EQ(&first->mesh(), &second->mesh()) << "the mesh too is held once";
    if (kind == BodyKind::rigid) continue;
    EXPECT_EQ(second->response()->statistics().assemblies, 1);
    EXPECT_EQ(second->response()->statistics().factorizations, 1);
  }
}

TEST(EqualBodies, of_other_contexts_do_not) {
  const auto first = brick(std::make_shared<Context>(), BodyKind::rigid),
             second = brick(std::make_shared<Context>(), BodyKind::rigid);
  first->prepare();
  second->prepare();
  EXPECT_FALSE(first->same_as(*second));
  EXPECT_FALSE(second->shared());
}

// Every setter makes another body by what it changes, and the same one when undone.
TEST(EqualBodies, every_input_counts) {
  const double pull[3] = {0, 0, 1}, moved[3] = {0, 0, 1e-3};
  const std::int32_t tags[1] = {top};
  const auto at_height = [](const Body& b, double z) {
    const std::vector<Vec3>& node = b.mesh().surface.node;
    const auto found = std::find_if(node.begin(), node.end(), [&](const Vec3& x) { return x[2] == z; });
    return static_cast<std::int32_t>(found - node.begin());
  };
  const std::vector<std::pair<const char*, Change>> changes{
      {"young", [](Body& b) { b.set_elastic(0, 201, 0.3); }},
      {"poisson", [](Body& b) { b.set_elastic(0, 200, 0.25); }},
      {"given displacement",
       [&](Body& b) {
         const std::int32_t held = at_height(b, 0);
         b.set_support(1, &held, 0, 4, moved);
       }},
      {"held component",
       [&](Body& b) {
         const std::int32_t free = at_height(b, 1);
         b.set_support(1, &free, 0, 2, nullptr);
       }},
      {"accuracy", [](Body& b) { b.set_real("accuracy", 1e-5); }},
      {"edge_angle", [](Body& b) { b.set_real("edge_angle", 50); }},
      {"keep_factors", [](Body& b) { b.set_int("keep_factors", 0); }},
      {"between_nodes", [](Body& b) { b.set_int("between_nodes", 1); }},
      {"prepare", [](Body& b) { b.set_int("prepare", 0); }},
      {"cache_bytes", [](Body& b) { b.set_int("cache_bytes", 1000); }},
  };
  const std::vector<std::pair<const char*, Change>> of_surfaces{
      {"traction", [&](Body& b) { b.set_traction(top, pull); }},
      {"pressure", [](Body& b) { b.set_pressure(top, 2); }},
      {"contact faces", [&](Body& b) { b.set_contact_faces(1, tags); }},
      {"tags",
       [](Body& b) {
         const std::vector<std::int32_t> all = [&] {
           std::vector<std::int32_t> ids;
           for (std::int32_t k = 0; k < b.size().first; ++k) ids.push_back(k);
           return ids;
         }();
         b.tag_faces_of_nodes(static_cast<std::int64_t>(all.size()), all.data(), 0, 9);
       }},
  };
  const auto check = [&](BodyKind kind, const char* name, const Change& change) {
    const auto context = std::make_shared<Context>();
    const auto plain = brick(context, kind), changed = brick(context, kind, change),
               again = brick(context, kind, change), last = brick(context, kind);
    for (const auto& body : {plain, changed, again, last}) body->prepare();
    EXPECT_FALSE(changed->same_as(*plain)) << name;
    EXPECT_TRUE(again->same_as(*changed)) << name;
    EXPECT_TRUE(last->same_as(*plain)) << name;
  };
  for (const BodyKind kind : meshed_kinds(false))
    for (const auto& [name, change] : changes) check(kind, name, change);
  if (ROLLCON_BUILD_BEM != 0)
    for (const auto& [name, change] : of_surfaces) check(BodyKind::bem, name, change);
}

TEST(EqualBodies, one_node_moved_by_the_last_bit_is_another_body) {
  const auto context = std::make_shared<Context>();
  SurfaceMesh mesh = surfaces::block(surfaces::brick({3, 3, 3}, {1, 1, 1}), ElementType::quad4);
  const auto rigid = [&] {
    auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::rigid));
    give_surface(*body, mesh);
    body->prepare();
    return body;
  };
  const auto first = rigid();
  mesh.node.back()[2] = std::nextafter(mesh.node.back()[2], 2.0);
  const auto second = rigid();
  EXPECT_FALSE(second->same_as(*first));
}

TEST(EqualBodies, what_nobody_holds_is_freed) {
  const auto context = std::make_shared<Context>();
  for (int round = 0; round < 40; ++round) {
    const auto body = brick(context, BodyKind::rigid, [](Body& b) { b.set_real("edge_angle", 30); });
    body->prepare();
    EXPECT_FALSE(body->shared()) << "the one before is gone";
  }
}

TEST(EqualBodies, a_body_that_fails_leaves_the_next_one_alone) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  const auto context = std::make_shared<Context>();
  const auto loose = [&] {  // held along x only, at one node
    auto body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::bem));
    give_surface(*body, surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), ElementType::quad4));
    body->set_elastic(0, 200, 0.3);
    const std::int32_t node = 0;
    body->set_support(1, &node, 0, 1, nullptr);
    return body;
  };
  const auto first = loose(), second = loose();
  EXPECT_THROW(first->prepare(), Error);
  EXPECT_THROW(second->prepare(), Error);
  EXPECT_FALSE(first->prepared() || second->prepared());
}

TEST(EqualBodies, threads_that_prepare_equal_bodies_do_the_work_once) {
  const auto context = std::make_shared<Context>();
  context->set_threads(1);
  for (const BodyKind kind : meshed_kinds(false)) {
    std::vector<std::shared_ptr<Body>> bodies;
    for (int k = 0; k < 6; ++k) bodies.push_back(brick(context, kind));
    std::vector<std::thread> pool;
    for (const auto& body : bodies) pool.emplace_back([&body] { body->prepare(); });
    for (std::thread& thread : pool) thread.join();
    int shared = 0;
    for (const auto& body : bodies) {
      EXPECT_TRUE(body->same_as(*bodies[0]));
      shared += body->shared();
    }
    EXPECT_EQ(shared, 5);
    EXPECT_EQ(bodies[0]->response()->statistics().assemblies, 1);
    EXPECT_EQ(bodies[0]->response()->statistics().factorizations, 1);
  }
}

}  // namespace
}  // namespace rollcon
