// Tests pairs of bodies with their unknowns written out: the same displacements as condensed, from matrices that are
// assembled once, and nothing factorised on the way.

#include "bodies/model/expanded_compliance.hpp"

#include <thread>

#include "bodies/pair.hpp"
#include "support/compliance_suite.hpp"
#include "support/frames.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;

constexpr double curvature = 0.06;

/// Bends the tops of blocks [-2, 2]^2 x [-3, 0] to domes, with n x n faces on [-1, 1]^2; the blocks are held below.
Vec3 dome(const Vec3& x) {
  return {x[0], x[1], x[2] - curvature * (x[0] * x[0] + 0.5 * x[1] * x[1]) * (1 + x[2] / 3)};
}

surfaces::ZoneBlock shape(int n, int deep) {
  return {.side = 4, .depth = 3, .zone = 2, .n = n, .grade = 1, .deep = deep};
}

/// Makes the body without preparing it.
std::shared_ptr<StaticBody> elastic(ElementType type, int n, double poisson = 0.3) {
  auto body =
      std::make_shared<StaticBody>(surfaces::transform(surfaces::zone_block(shape(n, 2), type), dome), 1e4, poisson);
  body->hold_tags({3});
  return body;
}

std::shared_ptr<StaticBody> elastic(VolumeType type, int n, double poisson = 0.3) {
  auto body =
      std::make_shared<StaticBody>(volumes::transform(volumes::zone_block(shape(n, 3), type), dome), 2e4, poisson);
  body->hold_tags({3});
  return body;
}

std::shared_ptr<Body> simple(BodyKind kind) {
  auto body = std::make_shared<Body>(std::make_shared<Context>(), static_cast<std::int32_t>(kind));
  if (kind == BodyKind::halfspace) body->set_elastic(0, 1.5e4, 0.2);
  return body;
}

/// Holds body 1 and body 2, a block of the same axes turned over, above it; both stand somewhere.
struct Pair {
  std::array<std::shared_ptr<Body>, 2> body;
  std::vector<std::shared_ptr<const void>> keep;
  Frame frame;
  std::unique_ptr<Compliance> compliance;
};

Pose standing() {
  const double c = std::cos(0.4), s = std::sin(0.4), d = std::cos(-0.7), e = std::sin(-0.7);
  return {{{{c, -s * d, s * e}, {s, c * d, -c * e}, {0, e, d}}}, {3, -2, 5}};
}

Pose turned_over(const Pose& pose) {
  Pose result = pose;
  for (Vec3& row : result.rotation) row = {row[0], -row[1], -row[2]};
  return result;
}

/// Takes a frame on body 1, in its axes.
Pair pair_on(std::array<std::shared_ptr<Body>, 2> body, SurfaceMesh frame_mesh) {
  Pair p;
  p.body = std::move(body);
  PairOfBodies pair;
  pair.pose = {standing(), turned_over(standing())};
  bool meshed = false;
  for (std::size_t which = 0; which < 2; ++which) {
    p.body[which]->prepare();
    pair.body[which] = p.body[which].get();
    meshed = meshed || p.body[which]->response();
  }
  Axes axes;
  axes.origin = pair.pose[0].place({0, 0, 0});
  axes.t1 = pair.pose[0].turn({1, 0, 0});
  axes.t2 = pair.pose[0].turn({0, 1, 0});
  axes.n = pair.pose[0].turn({0, 0, 1});
  for (Vec3& x : frame_mesh.node) x = pair.pose[0].place(x);
  p.frame = build_frame(std::move(frame_mesh), axes);
  if (meshed) {
    const NormalField field(axes, pair);
    std::vector<Vec3> normal;
    for (std::size_t k = 0; k < p.frame.x.size(); ++k) normal.push_back(field.at(p.frame.x[k], p.frame.y[k]));
    curve_frame(p.frame, normal);
  }
  p.compliance = make_pair_compliance(p.frame, pair, 1e-6, 1);
  return p;
}

/// Returns a frame of faces of body 1; others are laid on it.
SurfaceMesh zone_of(const StaticBody& body) {
  std::vector<std::int32_t> unused;
  return surfaces::part_of(body.mesh(), surfaces::elements_with_tag(body.mesh(), 2), unused);
}
SurfaceMesh laid(ElementType type, int n, double half_width = 0.9) {
  const auto lines = frames::uniform_lines(-half_width, half_width, n);
  return frames::transform(frames::rectangle(type, lines, lines), dome);
}

/// Returns a body that owns the StaticBody around it.
std::shared_ptr<Body> of(const std::shared_ptr<StaticBody>& body) {
  return {body, &body->body()};
}

std::int64_t stat(const Body& body, std::int64_t BodyStatistics::*member) {
  return body.response()->statistics().*member;
}

void expect_unknowns(const Pair& p, std::size_t bodies, bool direct) {
  ExpandedCompliance e;
  ASSERT_TRUE(p.compliance->expand({p.frame.x, p.frame.y}, e));
  EXPECT_EQ(e.body.size(), bodies);
  EXPECT_EQ(!e.direct.empty(), direct);
  for (const ExpandedBody& body : e.body) {
    EXPECT_EQ(body.load.rows, body.equations->unknowns);
    EXPECT_EQ(body.load.columns, 3 * p.frame.nodes());
    EXPECT_EQ(body.displacement.rows, body.equations->unknowns);
    EXPECT_EQ(body.displacement.columns, 3 * p.frame.nodes());
  }
}

TEST(Expanded, faces_of_one_body_laid_on_the_other) {
  const auto boundary = elastic(ElementType::quad4, 4, 0.4);
  const auto finite = elastic(VolumeType::hex8, 3);
  const Pair p = pair_on({of(boundary), of(finite)}, zone_of(*boundary));
  ASSERT_TRUE(p.frame.curved());
  expect_error("quad4 below hex8, faces of the first", expansion_error(p.frame, *p.compliance), 1e-12);
  expect_unknowns(p, 2, true);
  const auto fine = elastic(VolumeType::hex20, 2);
  const auto quads = elastic(ElementType::quad8, 3);
  const Pair q = pair_on({of(fine), of(quads)}, zone_of(*fine));
  expect_error("hex20 below quad8, faces of the first", expansion_error(q.frame, *q.compliance), 1e-12);
}

TEST(Expanded, faces_of_both) {
  const auto below = elastic(VolumeType::hex8, 4), above = elastic(VolumeType::hex8, 4, 0.1);
  const Pair p = pair_on({of(below), of(above)}, zone_of(*below));
  expect_error("hex8 below hex8", expansion_error(p.frame, *p.compliance), 1e-12);
  expect_unknowns(p, 2, false);
}

TEST(Expanded, with_bodies_that_have_no_unknowns) {
  const auto below = elastic(ElementType::tri6, 2);
  const Pair p = pair_on({of(below), simple(BodyKind::halfspace)}, zone_of(*below));
  expect_error("tri6 below a half-space", expansion_error(p.frame, *p.compliance), 1e-12);
  expect_unknowns(p, 1, true);
  const auto above = elastic(VolumeType::tet10, 2);
  const Pair q = pair_on({simple(BodyKind::rigid), of(above)}, laid(ElementType::quad4, 5));
  expect_error("tet10 above a rigid body", expansion_error(q.frame, *q.compliance), 1e-12);
  expect_unknowns(q, 1, true);
  const Pair r =
      pair_on({simple(BodyKind::halfspace), simple(BodyKind::halfspace)},
              frames::rectangle(ElementType::quad4, frames::uniform_lines(-1, 1, 5), frames::uniform_lines(-1, 1, 4)));
  expect_error("two half-spaces", expansion_error(r.frame, *r.compliance), 1e-12);
  expect_unknowns(r, 0, true);
}

TEST(Expanded, by_shape_functions_between_the_nodes) {
  const auto below = elastic(VolumeType::hex8, 4);
  const auto above = elastic(ElementType::quad4, 4);
  for (const auto& body : {below, above}) body->body().set_int("between_nodes", 1);
  const Pair p = pair_on({of(below), of(above)}, laid(ElementType::quad4, 3, 0.95));
  expect_error("hex8 below quad4, between_nodes 1", expansion_error(p.frame, *p.compliance), 1e-12);
  expect_unknowns(p, 2, false);
}

template <class Type>
void expect_nothing_factorised(Type type, const std::string& name) {
  const auto owner = elastic(type, 3);
  owner->body().set_int("prepare", 0);
  const Pair p = pair_on({of(owner), simple(BodyKind::rigid)}, zone_of(*owner));
  const Pair q = pair_on({of(owner), simple(BodyKind::halfspace)}, laid(ElementType::quad4, 4));
  const Body& body = owner->body();
  const auto expect_counts = [&](std::int64_t assemblies, std::int64_t factorizations, std::int64_t condensations,
                                 const char* when) {
    EXPECT_EQ(stat(body, &BodyStatistics::assemblies), assemblies) << name << ", " << when;
    EXPECT_EQ(stat(body, &BodyStatistics::factorizations), factorizations) << name << ", " << when;
    EXPECT_EQ(stat(body, &BodyStatistics::condensations), condensations) << name << ", " << when;
  };
  expect_counts(0, 0, 0, "prepared");
  EXPECT_GT(stat(body, &BodyStatistics::unknowns), 0) << name;
  {
    ExpandedCompliance first, second, third;
    ASSERT_TRUE(p.compliance->expand({p.frame.x, p.frame.y}, first));
    const std::vector<double> x{0.1, -0.4}, y{0.2, 0.3};
    ASSERT_TRUE(p.compliance->expand({x, y}, second));
    ASSERT_TRUE(q.compliance->expand({q.frame.x, q.frame.y}, third));
    EXPECT_EQ(first.body[0].equations, second.body[0].equations) << name;
    EXPECT_EQ(first.body[0].equations, third.body[0].equations) << name;
  }
  ExpandedCompliance again;
  ASSERT_TRUE(p.compliance->expand({p.frame.x, p.frame.y}, again));
  expect_counts(1, 0, 0, "written out");
  std::vector<double> t(static_cast<std::size_t>(3 * p.frame.nodes()), 1.0), u(t.size());
  p.compliance->apply({p.frame.x, p.frame.y}, t.data(), u.data());
  expect_counts(1, 1, 1, "condensed");
  again = {};
  ASSERT_TRUE(p.compliance->expand({p.frame.x, p.frame.y}, again));
  EXPECT_EQ(stat(body, &BodyStatistics::factorizations), 1) << name << ", written out later";
}

TEST(Expanded, nothing_is_factorised_and_the_matrix_is_assembled_once) {
  expect_nothing_factorised(ElementType::quad4, "boundary elements");
  expect_nothing_factorised(VolumeType::hex8, "finite elements");
}

TEST(Expanded, standard_preparation_factorises) {
  const auto boundary = elastic(ElementType::quad4, 3);
  boundary->body().prepare();
  EXPECT_EQ(stat(boundary->body(), &BodyStatistics::factorizations), 1);
  EXPECT_GT(boundary->body().response()->statistics().condition, 1);
}

TEST(Expanded, loads_of_its_own_are_solved_in_any_case) {
  const auto own_displacement = [](auto owner, std::int64_t prepare) {
    owner->body().set_int("prepare", prepare);
    owner->pressure(4, 30);
    owner->body().prepare();
    EXPECT_EQ(stat(owner->body(), &BodyStatistics::factorizations), 1);
    const auto& u = owner->body().own().displacement;
    return std::vector<double>(u.begin(), u.end());
  };
  const auto same = [&](auto type) {
    const std::vector<double> at_once = own_displacement(elastic(type, 3), 1),
                              checked = own_displacement(elastic(type, 3), 0);
    ASSERT_FALSE(at_once.empty());
    ASSERT_EQ(at_once.size(), checked.size());
    double most = 0, error = 0;
    for (std::size_t k = 0; k < at_once.size(); ++k) {
      most = std::max(most, std::abs(at_once[k]));
      error = std::max(error, std::abs(at_once[k] - checked[k]));
    }
    expect_error("own displacement, prepare 0 against 1", error / most, 1e-12);
  };
  same(ElementType::quad4);
  same(VolumeType::hex8);
}

TEST(Expanded, without_factors_nothing_is_kept) {
  const auto expect_assemblies = [](const auto& owner, const char* name) {
    owner->body().set_int("prepare", 0);
    owner->body().set_int("keep_factors", 0);
    const Pair p = pair_on({of(owner), simple(BodyKind::rigid)}, zone_of(*owner));
    for (std::int64_t round = 1; round <= 2; ++round) {
      ExpandedCompliance first, second;
      ASSERT_TRUE(p.compliance->expand({p.frame.x, p.frame.y}, first));
      ASSERT_TRUE(p.compliance->expand({p.frame.x, p.frame.y}, second));
      EXPECT_EQ(first.body[0].equations, second.body[0].equations) << name;
      EXPECT_EQ(stat(owner->body(), &BodyStatistics::assemblies), round) << name;
    }
  };
  expect_assemblies(elastic(ElementType::quad4, 3), "boundary elements");
  expect_assemblies(elastic(VolumeType::hex8, 3), "finite elements");
}

TEST(Expanded, one_body_below_and_above) {
  const auto below = elastic(VolumeType::hex8, 4);
  const Pair p = pair_on({of(below), of(below)}, zone_of(*below));
  ExpandedCompliance e;
  ASSERT_TRUE(p.compliance->expand({p.frame.x, p.frame.y}, e));
  ASSERT_EQ(e.body.size(), 2U);
  EXPECT_EQ(e.body[0].equations, e.body[1].equations);
  EXPECT_EQ(stat(below->body(), &BodyStatistics::assemblies), 2)
      << "preparing condensed all of the contact faces and freed the matrix";
  expect_error("hex8 on itself", expansion_error(p.frame, *p.compliance), 1e-12);
}

template <class Type>
void expect_one_assembly_for_threads(Type type) {
  const auto owner = elastic(type, 3);
  owner->body().set_int("prepare", 0);
  constexpr std::size_t threads = 4;
  const auto pair = [&] { return pair_on({of(owner), simple(BodyKind::rigid)}, zone_of(*owner)); };
  const Pair pairs[threads] = {pair(), pair(), pair(), pair()};  // built in place: frames stay put
  std::vector<ExpandedCompliance> expanded(threads);
  std::vector<std::vector<double>> u(threads);
  std::vector<std::thread> pool;
  for (std::size_t k = 0; k < threads; ++k)
    pool.emplace_back([&, k] {
      const Frame& f = pairs[k].frame;
      EXPECT_TRUE(pairs[k].compliance->expand({f.x, f.y}, expanded[k]));
      const std::vector<double> t(3 * f.x.size(), 1.0);
      u[k].resize(t.size());
      pairs[k].compliance->apply({f.x, f.y}, t.data(), u[k].data());
    });
  for (std::thread& t : pool) t.join();
  for (std::size_t k = 0; k < threads; ++k) {
    EXPECT_EQ(u[k], u[0]);
    EXPECT_EQ(expanded[k].body[0].load.value, expanded[0].body[0].load.value);
  }
  for (const auto count :
       {&BodyStatistics::assemblies, &BodyStatistics::factorizations, &BodyStatistics::condensations})
    EXPECT_EQ(stat(owner->body(), count), 1);
}

TEST(Expanded, in_many_threads) {
  expect_one_assembly_for_threads(ElementType::quad4);
  expect_one_assembly_for_threads(VolumeType::hex8);
}

}  // namespace
}  // namespace rollcon
