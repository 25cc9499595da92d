#include "contact/operators/lattice/lattice_operator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>
#include <vector>

#include "contact/lattice_case.hpp"
#include "linalg/fft.hpp"
#include "mesh/lattice.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

struct Fields {
  std::vector<double> value[3];
  explicit Fields(std::size_t n) {
    for (auto& v : value) v.assign(n, 0.0);
  }
};

Fields product(const DenseOperators& op, const Fields& lambda) {
  const auto n = static_cast<std::size_t>(op.nodes);
  Fields image(n);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      if (!op.block[r][c].empty())
        multiply(op.block[r][c].data(), op.nodes, op.nodes, lambda.value[c].data(), 1.0, image.value[r].data());
  return image;
}

double largest(const std::vector<double>& v) {
  double m = 0;
  for (const double x : v) m = std::max(m, std::abs(x));
  return m;
}

double difference(const Fields& a, const Fields& b) {
  double worst = 0;
  for (int r = 0; r < 3; ++r) {
    double error = 0;
    for (std::size_t k = 0; k < a.value[r].size(); ++k)
      error = std::max(error, std::abs(a.value[r][k] - b.value[r][k]));
    worst = std::max(worst, error / largest(a.value[r]));
  }
  return worst;
}

/// Puts traction on the nodes with whole hats alone, or on all.
void expect_equals_dense(const LatticeCase& c, Scheme scheme, bool cut, bool holes) {
  const Frame frame = lattice_frame(c.nx, c.ny, c.dx, c.dy, c.angle, holes);
  const std::optional<Lattice> lattice = find_lattice(frame);
  ASSERT_TRUE(lattice.has_value());
  const Convection convection = convection_of(frame, scheme);
  LatticeOperator field(*lattice, make_halfspace_kernel(c.c),
                        scheme == Scheme::characteristic ? convection.ahead[0] : 0.0, convection.rows);
  DenseOperators op;
  assemble_operators(frame, *make_halfspace_compliance(frame, c.c, 1e-13, 1), convection, true, op);
  frames::Random random(7);
  const auto n = static_cast<std::size_t>(frame.nodes());
  Fields lambda(n), image(n), normal(n);
  for (auto& t : lambda.value)
    for (std::size_t k = 0; k < n; ++k) t[k] = frame.used[k] && (cut || !frame.rim[k]) ? random() : 0;
  const double* in[3] = {lambda.value[0].data(), lambda.value[1].data(), lambda.value[2].data()};
  double* out[3] = {image.value[0].data(), image.value[1].data(), image.value[2].data()};
  field.apply(in, out);
  Fields dense = product(op, lambda);
  for (auto& image_of : dense.value)
    for (std::size_t k = 0; k < n; ++k)
      if (!frame.used[k]) image_of[k] = 0;
  const double error = difference(dense, image);
  std::printf("%-30s %-14s cut hats %d holes %d: error %.1e, bound 1e-13\n", c.name, scheme.name, cut, holes, error);
  EXPECT_LT(error, 1e-13);

  // Some fields are left out.
  const double* normal_in[3] = {nullptr, nullptr, in[2]};
  double* normal_out[3] = {nullptr, nullptr, normal.value[2].data()};
  field.apply(normal_in, normal_out);
  Fields only(n);
  only.value[2] = lambda.value[2];
  const std::vector<double> expected = product(op, only).value[2];
  for (std::size_t k = 0; k < n; ++k)
    EXPECT_NEAR(normal.value[2][k], frame.used[k] ? expected[k] : 0, 1e-13 * largest(expected));
  if (holes) return;

  // The own entries and norms are those of the node in the middle.
  const std::int32_t middle = lattice->node[static_cast<std::size_t>(lattice->ny / 2 * lattice->nx + lattice->nx / 2)];
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k)
      if (!op.block[r][k].empty()) {
        const double scale = std::abs(op.block[r][r].row(middle)[middle]) + 1e-3 * c.c.cn;
        EXPECT_NEAR(field.own(r, k, 0), op.block[r][k].row(middle)[middle], 1e-12 * scale) << r << " " << k;
      }
  // Norms differ by the halves of hats that are missing on the rim.
  for (int r = 0; r < 2; ++r) {
    const double norm =
        std::hypot(norm2(op.block[r][0].row(middle), op.nodes), norm2(op.block[r][1].row(middle), op.nodes));
    EXPECT_NEAR(field.slip_norm(r, 0) / norm, 1, 0.03);
  }
}

TEST(LatticeOperator, EqualsTheDenseOperators) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  for (const LatticeCase& c : lattice_cases)
    for (const Scheme scheme : {Scheme::characteristic, scheme_of("godunov"), scheme_of("least_squares")})
      for (const bool cut : {false, true})
        for (const bool holes : {false, true}) expect_equals_dense(c, scheme, cut, holes);
}

TEST(LatticeOperator, NeedsAnInnerNode) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  const Frame frame = lattice_frame(4, 1, 0.1, 0.1, 0);
  EXPECT_THROW(LatticeOperator(*find_lattice(frame), make_halfspace_kernel(alike), 0,
                               convection_of(frame, scheme_of("godunov")).rows),
               Error);
}

TEST(LatticeOperator, MemoryGrowsWithTheNodes) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  for (const int cells : {64, 128, 256}) {
    const Frame frame = lattice_frame(cells, cells, 0.1, 0.1, 0);
    const std::optional<Lattice> lattice = find_lattice(frame);
    ASSERT_TRUE(lattice.has_value());
    LatticeOperator field(*lattice, make_halfspace_kernel(unlike), 0.6 * lattice->spacing_along_flow(), {});
    const double per_node = static_cast<double>(field.bytes()) / static_cast<double>(frame.nodes());
    std::printf("%d x %d cells: %.0f bytes per node, bound 220\n", cells, cells, per_node);
    EXPECT_LT(per_node, 220);
  }
}

TEST(LatticeOperator, ColumnsOfCutHatsAreMadeWhenNeeded) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  const Frame frame = lattice_frame(20, 24, 0.1, 0.1, 0);
  const std::optional<Lattice> lattice = find_lattice(frame);
  ASSERT_TRUE(lattice.has_value());
  LatticeOperator field(*lattice, make_halfspace_kernel(unlike), 0.06, {});
  const auto n = static_cast<std::size_t>(frame.nodes());
  Fields lambda(n), image(n);
  const double* in[3] = {lambda.value[0].data(), lambda.value[1].data(), lambda.value[2].data()};
  double* out[3] = {image.value[0].data(), image.value[1].data(), image.value[2].data()};
  lambda.value[2][static_cast<std::size_t>(lattice->node[static_cast<std::size_t>(3 * lattice->nx + 5)])] = 1;
  const std::size_t before = field.bytes();
  field.apply(in, out);
  EXPECT_EQ(field.bytes(), before);
  lambda.value[2][static_cast<std::size_t>(lattice->node[3])] = 1;
  field.apply(in, out);
  const std::size_t with_side = field.bytes();
  EXPECT_GT(with_side, before);
  field.apply(in, out);
  EXPECT_EQ(field.bytes(), with_side);
  EXPECT_EQ(field.applications(), 3);
}

TEST(LatticeOperator, ThreadsApplyItSideBySide) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  const Frame frame = lattice_frame(30, 20, 0.1, 0.1, 0.2);
  const std::optional<Lattice> lattice = find_lattice(frame);
  ASSERT_TRUE(lattice.has_value());
  LatticeOperator field(*lattice, make_halfspace_kernel(unlike), 0.06, {});
  const auto n = static_cast<std::size_t>(frame.nodes());
  frames::Random random(3);
  Fields lambda(n), alone(n);
  for (auto& t : lambda.value)
    for (double& v : t) v = random();
  const double* in[3] = {lambda.value[0].data(), lambda.value[1].data(), lambda.value[2].data()};
  double* out[3] = {alone.value[0].data(), alone.value[1].data(), alone.value[2].data()};
  std::vector<Fields> image(4, Fields(n));
  std::vector<std::thread> threads;
  for (Fields& result : image)
    threads.emplace_back([&] {
      double* mine[3] = {result.value[0].data(), result.value[1].data(), result.value[2].data()};
      for (int k = 0; k < 5; ++k) field.apply(in, mine);
    });
  for (std::thread& t : threads) t.join();
  field.apply(in, out);
  for (const Fields& result : image)
    for (int r = 0; r < 3; ++r) EXPECT_EQ(result.value[r], alone.value[r]);
}

}  // namespace
}  // namespace rollcon
