// Tests responses that a body caches: found again without work, bounded in bytes, the least recently used ones dropped.

#include "bodies/model/response_cache.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "support/surface_meshes.hpp"

namespace rollcon {
namespace {

/// Answers with the first face and the number of the question.
class Counted final : public ResponseCache {
 public:
  Counted(const SurfaceMesh& surface, std::int64_t most_bytes) : ResponseCache(surface, most_bytes) {}
  std::shared_ptr<const BodyEquations> equations(int /*threads*/) override { return nullptr; }
  OwnLoads solve_loads(const BodyMesh& /*loaded*/, int /*threads*/) override { return {}; }
  void solve_everywhere(std::span<double> /*load*/, SurfaceState& /*state*/, int /*threads*/) override {}
  BodyStatistics statistics() const override {
    const std::lock_guard lock(mutex_);
    BodyStatistics s = statistics_with(0);
    s.condensations = asked;
    return s;
  }

 private:
  void respond(const LoadedSurface& on, SurfaceRows& rows, int /*threads*/) override {
    fill(on.of_faces() ? static_cast<double>(on.face[0]) : on.layer.node[0][0], rows);
  }
  void load(const LoadedSurface& /*on*/, SurfaceLoads& /*loads*/, int /*threads*/) override { ++asked; }
  std::uint64_t numbering() const override { return 0; }
  std::int64_t factored() const override { return 0; }
  void write_factors(SectionWriter& /*file*/) const override {}
  void read_factors(SectionReader& /*file*/) override {}
  void fill(double mark, SurfaceRows& rows) {
    ++asked;
    rows.u.resize(3 * static_cast<std::int64_t>(rows.row.size()), 3 * static_cast<std::int64_t>(rows.column.size()));
    rows.u.data()[0] = mark;
  }

  std::int64_t asked = 0;
};

class Cache : public ::testing::Test {
 protected:
  /// Asks for a face by itself; all have as many rows and columns in the middle of a side.
  double ask(Counted& cache, std::int64_t face) const { return cache.rows({{face}, {}, {}}, 1)->u.data()[0]; }
  double lay(Counted& cache, double x) const {
    SurfaceMesh layer;
    layer.node = {{x, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    layer.type = {ElementType::tri3};
    layer.connectivity = {0, 1, 2};
    return cache.rows({{}, layer, {0, 1}}, 1)->u.data()[0];
  }
  std::size_t bytes_of_one() const {
    Counted cache(surface, 0);
    ask(cache, 0);
    return cache.statistics().bytes;
  }

  SurfaceMesh surface = surfaces::cube_sphere(ElementType::quad4, 4, 1);
};

TEST_F(Cache, finds_faces_and_layers_again) {
  Counted cache(surface, 1 << 30);
  for (int round = 0; round < 3; ++round) {
    for (std::int64_t face = 0; face < 20; ++face) EXPECT_EQ(ask(cache, face), face);
    for (double x : {0.1, 0.2, 0.3}) EXPECT_EQ(lay(cache, x), x);
  }
  const BodyStatistics s = cache.statistics();
  EXPECT_EQ(s.condensations, 23);
  EXPECT_EQ(s.responses_kept, 23);
  EXPECT_EQ(s.responses_dropped, 0);
}

TEST_F(Cache, drops_what_was_not_used_for_longest) {
  const std::size_t room = 4 * bytes_of_one();
  Counted cache(surface, static_cast<std::int64_t>(room));
  for (const std::int64_t face : {0, 1, 2}) ask(cache, face);
  ask(cache, 0);  // now 1 is the oldest
  for (const std::int64_t face : {3, 4, 5}) ask(cache, face);
  BodyStatistics s = cache.statistics();
  EXPECT_LE(s.bytes, room);
  EXPECT_EQ(s.condensations, 6);
  EXPECT_EQ(s.responses_kept + s.responses_dropped, 6);
  EXPECT_GE(s.responses_dropped, 2);
  EXPECT_EQ(ask(cache, 5), 5);
  EXPECT_EQ(cache.statistics().condensations, 6) << "the last one is there";
  EXPECT_EQ(ask(cache, 1), 1);
  EXPECT_EQ(cache.statistics().condensations, 7) << "the oldest was dropped and is asked again";
  for (std::int64_t face = 0; face < 90; ++face) {
    ask(cache, face);
    ASSERT_LE(cache.statistics().bytes, room) << "the bound holds at every moment";
  }
}

TEST_F(Cache, keeps_the_last_one_whatever_its_size) {
  Counted cache(surface, 0);
  for (int round = 0; round < 3; ++round) {
    ask(cache, 7);
    ask(cache, 7);
    EXPECT_EQ(cache.statistics().responses_kept, 1);
    lay(cache, 0.5);
    lay(cache, 0.5);
    EXPECT_EQ(cache.statistics().responses_kept, 1);
  }
  EXPECT_EQ(cache.statistics().condensations, 6);
  EXPECT_EQ(cache.statistics().responses_dropped, 5);
}

TEST_F(Cache, what_was_dropped_lives_as_long_as_someone_holds_it) {
  Counted cache(surface, 0);
  const auto held = cache.rows({{3}, {}, {}}, 1);
  for (std::int64_t face = 10; face < 20; ++face) ask(cache, face);
  EXPECT_EQ(held->u.data()[0], 3);
}

TEST_F(Cache, serves_many_threads_within_its_bound) {
  const std::size_t room = 3 * bytes_of_one();
  Counted cache(surface, static_cast<std::int64_t>(room));
  std::vector<std::thread> pool;
  for (int t = 0; t < 4; ++t)
    pool.emplace_back([&, t] {
      for (int k = 0; k < 200; ++k) {
        const std::int64_t face = (k * (t + 1)) % 11;
        EXPECT_EQ(ask(cache, face), face);
      }
    });
  for (std::thread& thread : pool) thread.join();
  const BodyStatistics s = cache.statistics();
  EXPECT_LE(s.bytes, room);
  EXPECT_EQ(s.condensations, s.responses_kept + s.responses_dropped);
}

}  // namespace
}  // namespace rollcon
