#include "io/vtu.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <atomic>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "support/error.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace fs = std::filesystem;

/// Makes a directory of this test's own, removed at its end.
class Vtu : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "rollcon-vtu-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    directory_ = pattern;
  }
  void TearDown() override { fs::remove_all(directory_); }
  std::string path(const char* name) const { return (directory_ / name).string(); }
  int files() const {
    int n = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(directory_)) ++n;
    return n;
  }
  fs::path directory_;
};

std::string read(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Returns the numbers of one DataArray.
std::vector<double> array_of(const std::string& text, const std::string& name) {
  std::vector<double> values;
  std::size_t at = text.find("Name=\"" + name + "\"");
  if (at == std::string::npos) return values;
  at = text.find('>', at) + 1;
  std::istringstream in(text.substr(at, text.find('<', at) - at));
  in.imbue(std::locale::classic());
  for (std::string word; in >> word;) values.push_back(std::strtod(word.c_str(), nullptr));
  return values;
}

/// Makes one element of each type, side by side.
SurfaceMesh all_types() {
  SurfaceMesh all;
  all.offset = {0};
  const std::vector<double> one = {0, 1};
  double shift = 0;
  for (ElementType type :
       {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    const SurfaceMesh mesh = frames::rectangle(type, one, one);
    const auto first = static_cast<std::int32_t>(all.node.size());
    for (Vec3 x : mesh.node) all.node.push_back({x[0] + shift, x[1], 0.1 * x[0]});
    const auto nodes = mesh.element(0);
    for (std::int32_t k : nodes) all.connectivity.push_back(first + k);
    all.type.push_back(type);
    all.tag.push_back(static_cast<std::int32_t>(all.tag.size()) + 7);
    all.offset.push_back(static_cast<std::int64_t>(all.connectivity.size()));
    shift += 2;
  }
  return all;
}

struct Fields {
  std::vector<double> traction, pressure;
  std::vector<std::int32_t> status;
  std::vector<PointArray> arrays;

  explicit Fields(const SurfaceMesh& mesh) {
    for (std::size_t k = 0; k < mesh.node.size(); ++k) {
      const double v = static_cast<double>(k);
      traction.insert(traction.end(), {v / 3, -1e-300 * v, 1e300 / (v + 1)});
      pressure.push_back(std::sqrt(v));
      status.push_back(static_cast<std::int32_t>(k) % 4);
    }
    arrays = {{"traction", 3, traction.data(), nullptr},
              {"pressure", 1, pressure.data(), nullptr},
              {"status", 1, nullptr, status.data()}};
  }
};

TEST_F(Vtu, ReadsBackToTheSameBits) {
  const SurfaceMesh mesh = all_types();
  const Fields fields(mesh);
  write_vtu(path("frame.vtu"), mesh, fields.arrays);
  EXPECT_EQ(files(), 1);
  const std::string text = read(path("frame.vtu"));
  EXPECT_EQ(array_of(text, "traction"), fields.traction);
  EXPECT_EQ(array_of(text, "pressure"), fields.pressure);
  EXPECT_EQ(array_of(text, "status"), std::vector<double>(fields.status.begin(), fields.status.end()));
  EXPECT_EQ(array_of(text, "types"), (std::vector<double>{5, 22, 9, 23, 28}));
  EXPECT_EQ(array_of(text, "offsets"), (std::vector<double>{3, 9, 13, 21, 30}));
  EXPECT_EQ(array_of(text, "tag"), (std::vector<double>{7, 8, 9, 10, 11}));
  EXPECT_EQ(array_of(text, "connectivity"), std::vector<double>(mesh.connectivity.begin(), mesh.connectivity.end()));
  const auto points = array_of(text, "points");
  ASSERT_EQ(points.size(), 3 * mesh.node.size());
  for (std::size_t k = 0; k < mesh.node.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(points[3 * k + i], mesh.node[k][i]);
}

TEST_F(Vtu, AnotherReaderAgrees) {
  const std::string python = "/usr/bin/python3";
  if (std::system((python + " -c 'import meshio' >/dev/null 2>&1").c_str()) != 0) GTEST_SKIP() << "no meshio";
  const SurfaceMesh mesh = all_types();
  const Fields fields(mesh);
  write_vtu(path("frame.vtu"), mesh, fields.arrays);
  std::ofstream(path("read.py")) << R"(
import sys, meshio, numpy as np
m = meshio.read(sys.argv[1])
n = len(m.points)
assert [c.type for c in m.cells] == ['triangle', 'triangle6', 'quad', 'quad8', 'quad9'], m.cells
k = np.arange(n)
assert np.array_equal(m.point_data['pressure'].ravel(), np.sqrt(k))
assert np.array_equal(m.point_data['traction'][:, 0], k / 3)
assert np.array_equal(m.point_data['status'].ravel(), k % 4)
# Midside nodes lie half way between their corners in the order VTK asks for.
for c in m.cells:
    x, corners = m.points[c.data[0]], 3 if 'tri' in c.type else 4
    if len(x) > corners:
        for i in range(corners):
            assert np.allclose(x[corners + i], (x[i] + x[(i + 1) % corners]) / 2)
)";
  EXPECT_EQ(std::system((python + " '" + path("read.py") + "' '" + path("frame.vtu") + "'").c_str()), 0);
}

TEST_F(Vtu, DecimalPointInAnyLocale) {
  const char* used = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "es_ES.UTF-8"})
    if (!used) used = std::setlocale(LC_ALL, name);
  const SurfaceMesh mesh = all_types();
  const Fields fields(mesh);
  write_vtu(path("frame.vtu"), mesh, fields.arrays);
  std::setlocale(LC_ALL, "C");
  std::printf("locale of the test: %s\n", used ? used : "C (no other is installed)");
  const std::string text = read(path("frame.vtu"));
  EXPECT_EQ(text.find(','), std::string::npos);
  EXPECT_EQ(array_of(text, "traction"), fields.traction);
}

TEST_F(Vtu, NamesAreEscaped) {
  const SurfaceMesh mesh = all_types();
  const std::vector<double> zero(mesh.node.size(), 0);
  const std::vector<PointArray> arrays = {{"a<b & \"c\"", 1, zero.data(), nullptr}};
  write_vtu(path("frame.vtu"), mesh, arrays);
  EXPECT_NE(read(path("frame.vtu")).find("Name=\"a&lt;b &amp; &quot;c&quot;\""), std::string::npos);
}

TEST_F(Vtu, MissingDirectoryIsNamed) {
  try {
    write_vtu(path("nowhere/frame.vtu"), all_types(), {});
    FAIL() << "written";
  } catch (const Error& error) {
    std::printf("%s\n", error.what());
    EXPECT_EQ(error.status(), Status::err_io);
    EXPECT_NE(std::string(error.what()).find("nowhere/frame.vtu': No such file"), std::string::npos);
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(Vtu, FailureLeavesNoHalfFile) {
  // A directory stands where the file should go: the rename fails after all has been written.
  fs::create_directory(path("frame.vtu"));
  EXPECT_THROW(write_vtu(path("frame.vtu"), all_types(), {}), Error);
  EXPECT_EQ(files(), 1);
}

TEST_F(Vtu, LinksAndPermissionsStay) {
  fs::create_directory(path("away"));
  const SurfaceMesh mesh = all_types();
  for (const bool there : {false, true}) {
    // The link leads first to nothing, then to a file that nobody else may read.
    if (!there) fs::create_symlink("away/frame.vtu", path("frame.vtu"));
    if (there) fs::permissions(path("away/frame.vtu"), fs::perms::owner_read | fs::perms::owner_write);
    write_vtu(path("frame.vtu"), mesh, {});
    EXPECT_TRUE(fs::is_symlink(path("frame.vtu")));
    EXPECT_NE(read(path("away/frame.vtu")).find("</VTKFile>"), std::string::npos);
  }
  EXPECT_EQ(fs::status(path("away/frame.vtu")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("round", path("round"));
  EXPECT_THROW(write_vtu(path("round"), mesh, {}), Error);
}

TEST_F(Vtu, FullDiskIsReported) {
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100, old.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  Status status = Status::ok;
  try {
    write_vtu(path("frame.vtu"), all_types(), {});
  } catch (const Error& error) {
    status = error.status();
  }
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(status, Status::err_io);
  EXPECT_EQ(files(), 0);
}

TEST_F(Vtu, WritersOfOneNameDoNotDisturbEachOther) {
  constexpr int writers = 4, files_each = 20;
  std::vector<std::thread> threads;
  std::atomic<int> failures{0};
  for (int t = 0; t < writers; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < files_each; ++i) {
        try {
          write_vtu(path("frame.vtu"), all_types(), {});
        } catch (const std::exception&) {
          ++failures;
        }
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(files(), 1) << "nothing is left beside it";
}

TEST_F(Vtu, PipesAndDevicesAreNotReplaced) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  try {
    write_vtu(pipe, all_types(), {});
    FAIL() << "written";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_io);
    EXPECT_NE(std::string(error.what()).find("no regular file"), std::string::npos);
  }
  EXPECT_TRUE(fs::is_fifo(pipe)) << "it is what it was";
  EXPECT_EQ(files(), 1);
}

TEST_F(Vtu, NotANumberIsRefused) {
  const SurfaceMesh mesh = all_types();
  std::vector<double> values(mesh.node.size(), 1);
  values[4] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<PointArray> arrays = {{"gap", 1, values.data(), nullptr}};
  try {
    write_vtu(path("frame.vtu"), mesh, arrays);
    FAIL() << "written";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_nonfinite);
    EXPECT_STREQ(error.what(), "array 'gap' is not finite at node 4 (counting from 0)");
  }
  EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace rollcon
