// Compares hierarchical factors with dense ones, on a kernel that falls with the distance of points on a torus.

#include "linalg/hierarchical_factor.hpp"

#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

#include "linalg/factored_matrix.hpp"
#include "linalg/skeleton.hpp"
#include "support/error.hpp"
#include "support/interrupt.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// Has entries (1 + r.n / 2) / r of points, and a larger diagonal; rows are numbered backwards.
class Torus : public BlockMatrix {
 public:
  explicit Torus(std::int64_t around) {
    const std::int64_t across = around / 4;
    for (std::int64_t i = 0; i < around; ++i)
      for (std::int64_t j = 0; j < across; ++j) {
        const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around),
                     b = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(across);
        const double radius = 4 + std::cos(b);
        const auto k = static_cast<std::int32_t>(pivot.size());
        pivot.push_back({k, k, {radius * std::cos(a), radius * std::sin(a), std::sin(b)}});
      }
    for (Pivot& p : pivot) p.row = static_cast<std::int32_t>(pivot.size()) - 1 - p.column;
  }
  std::int64_t size() const { return static_cast<std::int64_t>(pivot.size()); }
  double entry(std::int32_t row, std::int32_t column) const {
    const auto &x = pivot[pivot.size() - 1 - static_cast<std::size_t>(row)].place, &y = pivot[at(column)].place;
    const double r = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
    return r == 0 ? diagonal : (1 + 0.5 * (x[0] - y[0]) / r) / r;
  }
  void block(std::span<const std::int32_t> rows, std::span<const std::int32_t> columns, double* to) const override {
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (std::size_t i = 0; i < rows.size(); ++i) to[i + j * rows.size()] = entry(rows[i], columns[j]);
    entries += static_cast<std::int64_t>(rows.size() * columns.size());
  }
  std::vector<std::int32_t> all() const {
    std::vector<std::int32_t> numbers(pivot.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }
  std::vector<Pivot> pivot;
  double diagonal = 2000;
  mutable std::int64_t entries = 0;
};

TEST(Skeleton, far_blocks_have_low_rank) {
  const Torus torus(120);
  std::vector<std::int32_t> rows, columns;
  for (std::int32_t k = 0; k < torus.size(); ++k) {
    const double x = torus.pivot[at(k)].place[0];
    if (x > 2) columns.push_back(k);
    if (x < -2) rows.push_back(static_cast<std::int32_t>(torus.size()) - 1 - k);
  }
  std::vector<double> exact(rows.size() * columns.size()), own(exact.size());
  torus.block(rows, columns, exact.data());
  for (const double accuracy : {1e-3, 1e-6}) {
    const Skeleton skeleton = skeleton_of(torus, rows, columns, accuracy, 0);
    EXPECT_GT(skeleton.rank, 0);
    EXPECT_LT(skeleton.rank, 60);
    skeleton.write(0, skeleton.rows, 0, skeleton.columns, own.data());
    double error = 0, size = 0;
    for (std::size_t k = 0; k < own.size(); ++k) {
      error += (own[k] - exact[k]) * (own[k] - exact[k]);
      size += exact[k] * exact[k];
    }
    expect_error("accuracy " + std::to_string(accuracy), std::sqrt(error / size), accuracy);
  }
}

TEST(HierarchicalFactor, solves_like_dense_factors) {
  const Torus torus(76);
  const std::int64_t n = torus.size();
  FactoredMatrix dense;
  torus.block(torus.all(), torus.all(), dense.prepare(n));
  ASSERT_TRUE(dense.factor());
  for (const double accuracy : {1e-4, 1e-7}) {
    torus.entries = 0;
    const auto factor = factor_hierarchically(torus, torus.pivot, accuracy);
    EXPECT_EQ(factor->size(), n);
    EXPECT_LT(factor->bytes(), at(8 * n * n));
    EXPECT_GT(factor->bytes(), at(8 * n));
    EXPECT_LT(std::abs(std::log(factor->condition() / dense.condition())), std::log(3.0));
    std::vector<double> b(at(2 * n));
    for (std::size_t k = 0; k < b.size(); ++k) b[k] = std::sin(0.01 * static_cast<double>(k));
    std::vector<double> exact = b, steps = b;
    dense.solve(exact.data(), 2);
    factor->solve(b.data(), 2);
    double error = 0, size = 0;
    for (std::size_t k = 0; k < b.size(); ++k) {
      error = std::max(error, std::abs(b[k] - exact[k]));
      size = std::max(size, std::abs(exact[k]));
    }
    expect_error("accuracy " + std::to_string(accuracy), error / size, accuracy);
    factor->eliminate(steps.data(), 2);
    factor->substitute(steps.data(), 2, n / 2);
    EXPECT_EQ(std::vector(steps.begin() + n / 2, steps.begin() + n), std::vector(b.begin() + n / 2, b.begin() + n));
  }
}

/// Holds what was written, and gives it back.
struct Bytes {
  std::vector<char> all;
  std::size_t taken = 0;
  void write(const void* data, std::size_t bytes) {
    all.insert(all.end(), static_cast<const char*>(data), static_cast<const char*>(data) + bytes);
  }
  void read(void* data, std::size_t bytes) {
    if (bytes > all.size() - taken) fail(Status::err_io, "the end");
    std::memcpy(data, all.data() + taken, bytes);
    taken += bytes;
  }
  std::unique_ptr<SystemFactor> factor(const Torus& torus, double condition) {
    taken = 0;
    return read_hierarchical(torus.pivot, condition, [this](void* to, std::size_t bytes) { read(to, bytes); });
  }
};

TEST(HierarchicalFactor, is_written_and_read_to_the_bit) {
  const Torus torus(64);
  const auto factor = factor_hierarchically(torus, torus.pivot, 1e-4);
  Bytes file;
  write_hierarchical(*factor, [&](const void* data, std::size_t bytes) { file.write(data, bytes); });
  const auto again = file.factor(torus, factor->condition());
  EXPECT_EQ(file.taken, file.all.size());
  EXPECT_EQ(again->bytes(), factor->bytes());
  EXPECT_EQ(again->condition(), factor->condition());
  std::vector<double> b(at(torus.size()));
  for (std::size_t k = 0; k < b.size(); ++k) b[k] = std::sin(0.01 * static_cast<double>(k));
  std::vector<double> same = b;
  factor->solve(b.data(), 1);
  again->solve(same.data(), 1);
  EXPECT_EQ(same, b);
}

TEST(HierarchicalFactor, what_does_not_fit_is_not_read) {
  const Torus torus(64);
  Bytes good;
  write_hierarchical(*factor_hierarchically(torus, torus.pivot, 1e-4),
                     [&](const void* data, std::size_t bytes) { good.write(data, bytes); });
  const auto refused = [&](const Torus& other, Bytes file, const char* text) {
    try {
      file.factor(other, 1);
      ADD_FAILURE() << "it was read, for " << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_io);
      EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
    }
  };
  refused(Torus(60), good, "other places");
  Bytes cut = good;
  cut.all.resize(cut.all.size() / 2);
  refused(torus, cut, "the end");
  // The order's checksum and the size of the first number, which says whether pivots follow, come before the entries.
  constexpr std::size_t first_size = 8, header = 16, entries = 20;
  Bytes sized = good;
  sized.all[first_size] = 8;
  refused(torus, sized, "another size");
  Bytes negative = good;
  const int below = -2;
  std::memcpy(negative.all.data() + header, &below, sizeof below);
  refused(torus, negative, "a rank");
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, good.all.data() + entries, sizeof bytes);
  Bytes wild = good;
  const int far = 1'000'000;
  std::memcpy(wild.all.data() + entries + 8 + bytes + 8, &far, sizeof far);
  refused(torus, wild, "pivot");
}

TEST(HierarchicalFactor, a_stop_ends_assembly_and_factorisation) {
  class StopAt final : public Interrupt {
   public:
    explicit StopAt(std::int64_t checks) : left_(checks) {}
    bool wanted() const override { return --left_ < 0; }

   private:
    void tell() override {}
    mutable std::int64_t left_;
  };
  const Torus torus(64);
  std::int64_t last = 0;
  for (std::int64_t checks = 0; checks < 4000; checks = 2 * checks + 1) {
    const StopAt stop(checks);
    try {
      factor_hierarchically(torus, torus.pivot, 1e-4);
      break;
    } catch (const Cancelled&) {
      last = checks;
    }
  }
  EXPECT_GT(last, 20) << "it asks often";
  EXPECT_LT(last, 2000) << "it ended";
  EXPECT_GT(factor_hierarchically(torus, torus.pivot, 1e-4)->condition(), 0) << "nothing is left behind";
}

TEST(HierarchicalFactor, failures_of_the_matrix_reach_the_caller) {
  class Failing final : public Torus {
   public:
    using Torus::Torus;
    void block(std::span<const std::int32_t> rows, std::span<const std::int32_t> columns, double* to) const override {
      if (entries > 100'000) throw std::bad_alloc();
      Torus::block(rows, columns, to);
    }
  };
  const Failing failing(64);
  EXPECT_THROW(factor_hierarchically(failing, failing.pivot, 1e-4), std::bad_alloc);
}

TEST(HierarchicalFactor, singular_matrices_are_told) {
  class Zero final : public Torus {
   public:
    using Torus::Torus;
    void block(std::span<const std::int32_t> rows, std::span<const std::int32_t> columns, double* to) const override {
      std::fill_n(to, rows.size() * columns.size(), 0.0);
    }
  };
  const Zero zero(32);
  bool told = false;
  try {
    told = !(factor_hierarchically(zero, zero.pivot, 1e-4)->condition() < 1e14);
  } catch (const Error& e) {
    told = e.status() == Status::err_singular;
  }
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace rollcon
