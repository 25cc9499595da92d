// Tests that files of bodies whose checksums are right and whose content is not are refused, or harmless, and never
// read beyond what is there.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "bodies/body.hpp"
#include "build_info.hpp"
#include "io/section_file.hpp"
#include "support/error.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

namespace fs = std::filesystem;
using statics::StaticBody;

/// Returns the file with some bytes changed and all checksums made right again.
std::string forged(const std::string& good, std::size_t at, const void* bytes, std::size_t count) {
  std::string bad = good;
  std::memcpy(bad.data() + at, bytes, std::min(count, bad.size() - at));
  SectionHeader header;
  std::memcpy(&header, bad.data(), sizeof header);
  for (std::uint32_t i = 0; i < header.sections; ++i) {
    Checksum sum;
    sum.add(bad.data() + header.section[i].offset, header.section[i].length);
    header.section[i].checksum = sum.value();
  }
  Checksum sum;
  sum.add(&header, offsetof(SectionHeader, checksum));
  header.checksum = sum.value();
  std::memcpy(bad.data(), &header, sizeof header);
  return bad;
}

class ForgedFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    path = (fs::temp_directory_path() / ("rollcon_forged_" + std::to_string(getpid()))).string();
  }
  void TearDown() override { fs::remove(path); }

  /// Loads what is written there, and asks the body for what it holds.
  void load(const std::string& bytes, std::size_t where) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    try {
      const auto body = Body::load(context, path);
      ++loaded;
      static_cast<void>(body->own().reaction);
    } catch (const Error& e) {
      ++refused;
      const bool fits =
          e.status() == Status::err_io || e.status() == Status::err_unsupported || e.status() == Status::err_memory;
      ASSERT_TRUE(fits) << where << ": " << e.what();
    }
  }
  void check(StaticBody& body, const std::vector<std::int64_t>& face) {
    body.body().prepare();
    body.body().response()->rows({face, {}, {}}, 1);
    body.body().save(path);
    std::ifstream in(path, std::ios::binary);
    std::stringstream all;
    all << in.rdbuf();
    const std::string good = all.str();
    load(forged(good, 0, good.data(), 0), 0);
    ASSERT_EQ(loaded, 1) << "not changed it is read";
    const std::size_t step = std::max<std::size_t>(1, good.size() / 250);
    const std::uint64_t huge = ~std::uint64_t{0}, large = std::uint64_t{1} << 40U;
    const double not_a_number = std::nan("");
    for (std::size_t k = sizeof(SectionHeader); k < good.size(); k += k < sizeof(SectionHeader) + 400 ? 6 : step) {
      const char flipped = static_cast<char>(good[k] ^ 1 << k % 8);
      load(forged(good, k, &flipped, 1), k);
      for (const void* word :
           {static_cast<const void*>(&huge), static_cast<const void*>(&large), static_cast<const void*>(&not_a_number)})
        if (k % 3 == 0) load(forged(good, k, word, 8), k);
    }
    std::printf("%lld forged files: %lld refused, %lld read\n", static_cast<long long>(loaded + refused),
                static_cast<long long>(refused), static_cast<long long>(loaded));
    EXPECT_GT(refused, 40);
  }

  std::shared_ptr<Context> context = std::make_shared<Context>();
  std::string path;
  std::int64_t loaded = 0, refused = 0;
};

TEST_F(ForgedFiles, of_boundary_elements) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  StaticBody body(surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), ElementType::quad4), 200, 0.3);
  body.hold_tags({5});
  check(body, {0});
}

TEST_F(ForgedFiles, of_hierarchical_boundary_elements) {
  if (ROLLCON_BUILD_HMAT == 0) GTEST_SKIP() << "this build has no hierarchical factors";
  StaticBody body(surfaces::block(surfaces::brick({4, 4, 2}, {2, 2, 1}), ElementType::quad4), 200, 0.3);
  body.body().set_int("factor", 2);
  body.hold_tags({5});
  check(body, {0});
}

TEST_F(ForgedFiles, of_finite_elements) {
  if (ROLLCON_BUILD_FEM == 0) GTEST_SKIP() << "this build has no finite elements";
  StaticBody body(volumes::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), VolumeType::hex8), 200, 0.3);
  body.hold_tags({5});
  check(body, {3});
}

}  // namespace
}  // namespace rollcon
