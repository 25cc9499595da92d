// Tests the half-space compliance that the contact sees: block against apply, threads, instruction sets, what is
// computed and what is not.

#include "bodies/model/compliance.hpp"

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/halfspace/kernels.hpp"
#include "bodies/sum_compliance.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using Blocks = std::vector<std::vector<double>>;

/// Makes a disc with triangles and quadrilaterals of several kinds: quad8 bent, its copy shifted as tri6.
Frame mixed_frame() {
  SurfaceMesh mesh = frames::bend_midsides(frames::o_grid(ElementType::quad8, 4, 2, 1, 1), 0.05, 3);
  const SurfaceMesh other[] = {
      frames::bend_midsides(frames::paper_disc(ElementType::tri6, 0.4), 0.05, 9),
      frames::perturb(frames::o_grid(ElementType::quad4, 4, 2, 0.5, 0.5), 0.1, 4),
      frames::rectangle(ElementType::tri3, frames::uniform_lines(-0.3, 0.3, 3), frames::uniform_lines(-0.3, 0.3, 3))};
  double shift = 2.5;
  for (const SurfaceMesh& part : other) {
    const auto first = static_cast<std::int32_t>(mesh.nodes());
    for (const Vec3& node : part.node) mesh.node.push_back({node[0] + shift, node[1], node[2]});
    for (const std::int32_t node : part.connectivity) mesh.connectivity.push_back(first + node);
    for (std::int64_t e = 0; e < part.elements(); ++e) {
      mesh.type.push_back(part.type[static_cast<std::size_t>(e)]);
      mesh.tag.push_back(0);
      mesh.offset.push_back(mesh.offset.back() + node_count(mesh.type.back()));
    }
    shift += 1.5;
  }
  return build_frame(std::move(mesh), Axes{});
}

/// Holds nodes and some points between and away from them.
struct Observers {
  std::vector<double> x, y;
  explicit Observers(const Frame& frame) {
    frames::Random random(17);
    for (std::size_t k = 0; k < frame.x.size(); k += 7) {
      x.push_back(frame.x[k]);
      y.push_back(frame.y[k]);
      x.push_back(frame.x[k] + 0.07 * random());
      y.push_back(frame.y[k] + 0.07 * random());
    }
    x.push_back(30);
    y.push_back(-8);
  }
  Points points() const { return {x, y}; }
};

Blocks blocks(const Compliance& compliance, Points points) {
  const auto n = static_cast<std::size_t>(compliance.nodes());
  Blocks a(9, std::vector<double>(points.size() * n, NAN));
  ComplianceBlock out;
  out.stride = static_cast<std::ptrdiff_t>(n);
  for (std::size_t k = 0; k < 9; ++k) out.a[k / 3][k % 3] = a[k].data();
  compliance.block(points, out);
  return a;
}

std::vector<double> tractions(std::int64_t nodes) {
  frames::Random random(23);
  std::vector<double> t(3 * static_cast<std::size_t>(nodes));
  for (double& value : t) value = random();
  return t;
}

std::vector<double> product(const Blocks& a, const std::vector<double>& t, std::size_t points) {
  const std::size_t n = t.size() / 3;
  std::vector<double> u(3 * points, 0.0);
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t b = 0; b < 9; ++b) u[3 * p + b / 3] += a[b][p * n + k] * t[3 * k + b % 3];
  return u;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double error = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    size = std::max(size, std::abs(b[i]));
    error = std::max(error, std::abs(a[i] - b[i]));
  }
  return error / size;
}

TEST(halfspace_compliance, apply_is_block_times_tractions) {
  const Frame frame = mixed_frame();
  const Observers at(frame);
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 1);
  const auto t = tractions(frame.nodes());
  std::vector<double> u(3 * at.x.size());
  compliance->apply(at.points(), t.data(), u.data());
  const double error = difference(u, product(blocks(*compliance, at.points()), t, at.x.size()));
  std::printf("apply against block: %.1e (bound 1e-13)\n", error);
  EXPECT_LE(error, 1e-13);
}

TEST(halfspace_compliance, threads_do_not_change_a_bit) {
  const Frame frame = mixed_frame();
  const Observers at(frame);
  const auto one = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 1);
  const auto three = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 3);
  const Blocks a = blocks(*one, at.points()), b = blocks(*three, at.points());
  EXPECT_TRUE(a == b);
  const auto t = tractions(frame.nodes());
  std::vector<double> u(3 * at.x.size()), v = u;
  one->apply(at.points(), t.data(), u.data());
  three->apply(at.points(), t.data(), v.data());
  EXPECT_TRUE(u == v);
  EXPECT_EQ(one->kernel_evaluations(), three->kernel_evaluations());
}

TEST(halfspace_compliance, a_row_does_not_depend_on_the_rows_beside_it) {
  const Frame frame = mixed_frame();
  const Observers at(frame);
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 1);
  const Blocks all = blocks(*compliance, at.points());
  const std::size_t p = at.x.size() / 2, n = static_cast<std::size_t>(frame.nodes());
  const Blocks row = blocks(*compliance, {{&at.x[p], 1}, {&at.y[p], 1}});
  for (std::size_t k = 0; k < 9; ++k)
    EXPECT_TRUE(std::equal(row[k].begin(), row[k].end(), all[k].begin() + static_cast<std::ptrdiff_t>(p * n)));
}

TEST(halfspace_compliance_long, instruction_sets_agree) {
  using rollcon::InstructionSet;
  const Frame frame = mixed_frame();
  const Observers at(frame);
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 1);
  const auto t = tractions(frame.nodes());
  rollcon::force_instruction_set(InstructionSet::baseline);
  const Blocks reference = blocks(*compliance, at.points());
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    rollcon::force_instruction_set(set);
    const Blocks a = blocks(*compliance, at.points());
    double error = 0;
    for (std::size_t k = 0; k < 9; ++k) error = std::max(error, difference(a[k], reference[k]));
    std::vector<double> u(3 * at.x.size());
    compliance->apply(at.points(), t.data(), u.data());
    error = std::max(error, difference(u, product(reference, t, at.x.size())));
    std::printf("%s against baseline: %.1e (bound 1e-12)\n", halfspace::kernels(rollcon::instruction_set()).name,
                error);
    EXPECT_LE(error, 1e-12);
  }
  rollcon::force_instruction_set(InstructionSet::avx512);
}

TEST(halfspace_compliance_long, mixed_elements_meet_the_tolerance_in_every_row) {
  const Frame frame = mixed_frame();
  const Observers at(frame);
  const auto n = static_cast<std::size_t>(frame.nodes());
  const Blocks fine = blocks(*make_halfspace_compliance(frame, {1, 1, 1}, 1e-11, 1), at.points());
  for (const double tolerance : {1e-6, 1e-9}) {
    const Blocks a = blocks(*make_halfspace_compliance(frame, {1, 1, 1}, tolerance, 1), at.points());
    double worst = 0;
    for (std::size_t p = 0; p < at.x.size(); ++p) {
      double error = 0, size = 0;
      for (std::size_t k = 0; k < 9; ++k)
        for (std::size_t m = p * n; m < (p + 1) * n; ++m) {
          size = std::max(size, std::abs(fine[k][m]));
          error = std::max(error, std::abs(a[k][m] - fine[k][m]));
        }
      worst = std::max(worst, error / size);
    }
    std::printf("rows of a mixed frame: error %.1e (bound %.0e)\n", worst, tolerance);
    EXPECT_LE(worst, tolerance);
  }
}

TEST(halfspace_compliance, unloaded_elements_cost_nothing) {
  const Frame frame = mixed_frame();
  const Observers at(frame);
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 1);
  std::vector<double> t(3 * static_cast<std::size_t>(frame.nodes()), 0.0), u(3 * at.x.size(), NAN);
  compliance->apply(at.points(), t.data(), u.data());
  EXPECT_EQ(compliance->kernel_evaluations(), 0);
  for (const double value : u) EXPECT_EQ(value, 0);
  t[3 * 5 + 2] = 1;  // one loaded node
  compliance->apply(at.points(), t.data(), u.data());
  const auto few = compliance->kernel_evaluations();
  EXPECT_GT(few, 0);
  std::fill(t.begin(), t.end(), 1.0);
  compliance->apply(at.points(), t.data(), u.data());
  EXPECT_GT(compliance->kernel_evaluations() - few, 20 * few);
}

TEST(halfspace_compliance, only_wanted_blocks_are_written) {
  const Frame frame = mixed_frame();
  const auto n = static_cast<std::size_t>(frame.nodes());
  const double x[] = {0.1}, y[] = {0.2};
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 1);
  const Blocks all = blocks(*compliance, {x, y});
  for (std::size_t k = 0; k < 9; ++k) {
    std::vector<double> one(n, NAN);
    ComplianceBlock out;
    out.stride = static_cast<std::ptrdiff_t>(n);
    out.a[k / 3][k % 3] = one.data();
    compliance->block({x, y}, out);
    EXPECT_LE(difference(one, all[k]), 1e-14) << "block " << k;
  }
}

TEST(halfspace_constants, follow_the_materials) {
  const HalfspaceConstants c = halfspace_constants(2.6, 0.3, 1), d = halfspace_constants(2.6, 0.3, -1);
  EXPECT_NEAR(c.cn, 0.7 / (2 * std::numbers::pi), 1e-15);
  EXPECT_NEAR(c.cv, 0.3 / (2 * std::numbers::pi), 1e-15);
  EXPECT_NEAR(c.ck, 0.4 / (4 * std::numbers::pi), 1e-15);
  EXPECT_EQ(d.ck, -c.ck);
  EXPECT_EQ(d.cn, c.cn);
  EXPECT_EQ(halfspace_constants(1e4, 0.5, 1).ck, 0);
  EXPECT_EQ(halfspace_constants(1e4, 0.0, 1).cv, 0);
}

// The results do not depend on what the caller's array held.
TEST(halfspace_constants, displacements_are_written_and_not_added) {
  const std::vector<double> lines = frames::uniform_lines(0, 2, 2);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, lines, lines), Axes{});
  constexpr double garbage = 7;
  const auto applied = [&](const Compliance& compliance) {
    const std::vector<double> t(3 * frame.x.size(), 1.0);
    std::vector<double> u(t.size(), garbage);
    compliance.apply({frame.x, frame.y}, t.data(), u.data());
    return u;
  };
  for (const double u : applied(*make_halfspace_compliance(frame, {}, 1e-6, 1))) EXPECT_EQ(u, 0);
  const HalfspaceConstants first{1, 0.4, 0.2}, second{0.5, 0.1, -0.1}, both{1.5, 0.5, 0.1};
  std::vector<std::unique_ptr<Compliance>> parts;
  for (const HalfspaceConstants& c : {first, second}) parts.push_back(make_halfspace_compliance(frame, c, 1e-6, 1));
  const double error =
      difference(applied(*make_sum(std::move(parts))), applied(*make_halfspace_compliance(frame, both, 1e-6, 1)));
  std::printf("a sum of two beside one: %.1e (bound 1e-13)\n", error);
  EXPECT_LE(error, 1e-13);
}

TEST(halfspace_constants_long, rigid_and_uncoupled_pairs) {
  const Frame frame = mixed_frame();
  const Observers at(frame);
  const auto rigid = make_halfspace_compliance(frame, {}, 1e-6, 1);
  for (const auto& block : blocks(*rigid, at.points()))
    for (const double a : block) ASSERT_EQ(a, 0);
  EXPECT_EQ(rigid->kernel_evaluations(), 0);
  EXPECT_FALSE(rigid->couples());
  const auto uncoupled = make_halfspace_compliance(frame, {1, 0.4, 0}, 1e-6, 1);
  EXPECT_FALSE(uncoupled->couples());
  const Blocks a = blocks(*uncoupled, at.points());
  const Blocks b = blocks(*make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-6, 1), at.points());
  for (const std::size_t zero : {2u, 5u, 6u, 7u})
    for (const double value : a[zero]) ASSERT_EQ(value, 0);
  for (const std::size_t same : {0u, 1u, 3u, 4u, 8u}) EXPECT_LE(difference(a[same], b[same]), 1e-14);
}

}  // namespace
}  // namespace rollcon
