/// Tests files of profiles: what is read and written, what is said of files that are none.

#include "io/profile_file.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace fs = std::filesystem;

class ProfileFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "rollcon-profile-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    directory_ = pattern;
  }
  void TearDown() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  ProfileFile read(const std::string& name, const std::string& text) {
    std::ofstream(path(name), std::ios::binary) << text;
    return read_profile_file(path(name));
  }
  void expect_refused(const std::string& name, const std::string& text, const std::string& said) {
    try {
      read(name, text);
      ADD_FAILURE() << "read: " << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_io);
      EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
    }
  }
  fs::path directory_;
};

using Points = std::vector<std::array<double, 2>>;

double difference(const Points& a, const Points& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    for (std::size_t c = 0; c < 2; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]));
  return most;
}

const std::string simpack =
    "header.begin\n  version = 1\n  type = 0\nheader.end\n! a comment\nspline.begin\n  approx.smooth = 0.000000\n"
    "  comment = 'rail'\n  units.len.f = 1000.\n  shift.y = 1. % mm\n  point.begin\n   -2.0  4.0\n   0 0 ! top\n"
    "   2.0  4.0\n  point.end\nspline.end\n";

const std::string miniprof =
    "ProgramName=X\r\nColumnDef=X,Y,A,C,N\r\nXOffset=0.5\r\nYOffset=-1\r\n! said of it\r\n\r\n-2.0 4.0 0.1 0.2 0\r\n"
    "0 0 0 0 0 \" said of it\r\n2.0\t4.0\t0\t0\t0\r\n";

TEST_F(ProfileFiles, three_formats) {
  const ProfileFile columns = read("a.txt", "\xEF\xBB\xBF! y z\n-2, +4\n\n 0 0e0 # top\r\n2;4.0");
  EXPECT_EQ(difference(columns.point, {{-2, 4}, {0, 0}, {2, 4}}), 0);
  EXPECT_EQ(columns.line, (std::vector<std::int64_t>{2, 4, 5}));
  const ProfileFile rail = read("a.PRR", simpack);
  EXPECT_EQ(difference(rail.point, {{-1, 4}, {1, 0}, {3, 4}}), 0);
  EXPECT_EQ(rail.line, (std::vector<std::int64_t>{12, 13, 14}));
  EXPECT_EQ(difference(read("a.ban", miniprof).point, {{-1.5, 3}, {0.5, -1}, {2.5, 3}}), 0);
  EXPECT_EQ(difference(read("a.whl", "ColumnDef=A,Y,X\n\n9 1 2\n9 3 4\n").point, {{2, 1}, {4, 3}}), 0);
}

// The forms are those that measuring devices and people write.
TEST_F(ProfileFiles, forms_of_devices_and_people) {
  const Points three{{-2, 4.5}, {0, 0}, {2, 4.5}};
  const auto same = [&](const std::string& name, const std::string& text, const std::string& told = "") {
    const ProfileFile file = read(name, text);
    EXPECT_EQ(difference(file.point, three), 0) << text;
    EXPECT_EQ(file.told.find(told), told.empty() ? file.told.size() : 0U) << file.told;
  };
  const std::string rows = "-2.0 4.5\n0.0 0\n2.0 4.5\n", words = "Stock.......:\n30.0 30.0 10.0 (Sd/Sh/qR)\n\n";
  same("heading.csv", "Y,Z\n-2.0,4.5\n0,0\n2.0,4.5\n");
  same("heading.csv", "\"Y\";\"Z\"\n-2.0;4.5\n0;0\n2.0;4.5\n");
  same("count.txt", "3\n" + rows);
  same("count.txt", "Rail 7, worn\n 3 ! points\n" + rows);
  same("index.txt", "1\t-2.0\t4.5\n2\t0\t0\n3\t2\t4.5\n", "its first column counts");
  same("index.txt", "no y z\n0, -2, 4.5\n1, 0, 0\n2, 2, 4.5\n", "its first column counts");
  same("comma.txt", "-2,0;4,5\n0,0;0,0\n2;4,5\n");
  same("comma.txt", "-2,0 4,5\n0,0 0,0\n2,0\t4,5\n");
  same("comma.txt", "-2, 4.5\n0 ,0\n2,4.5\n");
  same("fortran.txt", "-2.0D+00 4.5d0\n0.D0 +0.0D0\n+.2D1 45D-1\n");
  same("old.whl", "#MINIWHEELPROF\nwheel.whl\nMINIPROF 2020\n\" 30.0 30.0 10.0\n" + words + rows);
  same("older.whl", "MINIPROF 101 148 1994 3 24\n" + words + "-2.0 4.5 0.1\n0 0 0.1\n2.0 4.5 0.1\n");
  same("bare.ban", rows);
  same("empty.ban", "ProgramName=\nXOffset=\nYOffset=\nColumnDef=X,Y\n\n" + rows);
  same("no_blank.ban", "ProgramName=MiniProf for Windows\nColumnDef=X,Y\n" + rows);
  same("comments.ban", "ColumnDef=X,Y,A,C,N\n\n-2.0 4.5 0 0 1\n0 0 0 0 1 % dent\n2.0 4.5 0 0 1 ! edge\n");
  same("one.mpt", "[FileInfo]\nProgramName=x\n\n[Profile1Info]\nXOffset=\n\n[Profile1Points]\n" + rows);
  same("parts.mpt", "[Profile1Points]\n" + rows + "\n[Profile2Info]\nA=b\n[Profile2Points]\n9 9\n8 8\n",
       "it has 1 more profile(s) behind the first");
  same("vampire.rai", "RAILPROFILE\nA rail\nGAUGE 1435\n-2 4.5 -2 4.5\n0 0 0 0\n2 4.5 2 4.5\n");
  same("vampire.rai", "RAILPROFILE\nA rail\n-2 4 -2 4.5\n0 0 0 0\n2 4.5 2 4.5\n", "its two rails differ");
  same("empty.prr", "spline.begin\nshift.y=\npoint.begin\n" + rows + "point.end\nspline.end\n");
}

TEST_F(ProfileFiles, simpack_keys_in_their_order) {
  const auto with = [&](const std::string& keys) {
    return read("k.prw", "spline.begin\n" + keys + "point.begin\n0 0\n0.001 0\n1 0\n2 1\npoint.end\nspline.end\n")
        .point;
  };
  EXPECT_EQ(difference(with("point.dist.min = 0.01\n"), {{0, 0}, {1, 0}, {2, 1}}), 0);
  EXPECT_EQ(difference(with("bound.y.min = 0.5\nbound.y.max = 3\n"), {{1, 0}, {2, 1}}), 0);
  EXPECT_EQ(with("bound.y.min = 3\nbound.y.max = 0.5\n").size(), 4U) << "no bound";
  // The points are shifted, then turned by a right angle from y to z, then bounded, mirrored, and metres made
  // millimetres.
  const Points turned = with(
      "units.len.f = 1\nunits.ang.f = 57.29577951308232\nrotate = 90\nshift.y = 1\npoint.dist.min = 0.01\n"
      "bound.z.min = 1.5\nbound.z.max = 9\nmirror.y = 1\ninversion = 1\n");
  expect_error("Simpack: all at once, mm", difference(turned, {{1000, 3000}, {0, 2000}}), 1e-9);
  expect_error("Simpack: mirrored in z",
               difference(with("mirror.z = 1\nbound.y.min = 1\nbound.y.max = 3\n"), {{1, 0}, {2, -1}}), 0);
}

TEST_F(ProfileFiles, round_trips) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  Points point;
  for (int i = 0; i < 500; ++i) point.push_back({i + 0.3 * any(random), any(random) * std::pow(10, 10 * any(random))});
  for (const char* name : {"r.txt", "r.prr", "r.prw"}) {
    write_profile_file(path(name), point);
    EXPECT_EQ(difference(read_profile_file(path(name)).point, point), 0) << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), 3) << "nothing else is left";
  EXPECT_THROW(write_profile_file(path("none/r.txt"), point), Error);
}

TEST_F(ProfileFiles, bad_files_are_named_with_their_lines) {
  EXPECT_THROW(read_profile_file(path("missing.txt")), Error);
  EXPECT_THROW(read_profile_file(directory_.string()), Error);
  expect_refused("e.txt", "", "0 point(s); needed: 2 or more");
  expect_refused("b.txt", "0 0\n1 0 0\n", "line 2: 3 number(s); needed: y and z");
  expect_refused("b.txt", "0 0\n\n1 1,2,x\n", "line 3: 'x' is no number");
  expect_refused("b.txt", "0 0\n1 nan\n", "line 2: 'nan' is no number");
  expect_refused("b.txt", "0 0\n1 1e999\n", "line 2: '1e999' is no number");
  expect_refused("b.txt", std::string("0 0\n1 \x01\xff\n"), "line 2: '?\?' is no number");
  expect_refused("b.prr", "spline.begin\npoint.begin\n0 0\n1 1\n", "ends before 'point.end': truncated");
  expect_refused("b.prr", "spline.begin\npoint.end\n", "line 2: 'point.end' ends a section that is not open");
  expect_refused("b.prr", "spline.begin\nspline.end\n", "no section of points");
  expect_refused("b.prr", "spline.begin\nhello\n", "line 2: neither a section nor 'key = value'");
  expect_refused("b.prr", "shift.y = far\n", "line 1: 'far' is no number");
  expect_refused("b.prr", "units.len.f = 0\npoint.begin\n0 0\n1 1\npoint.end\n", "units.len.f is not > 0");
  expect_refused("b.prr", "point.begin\n0\n", "line 2: 1 number; needed: y and z");
  expect_refused("b.prr", "point.begin\npoint.end\npoint.begin\n", "line 3: a second section of points");
  expect_refused("b.ban", "Nothing\n", "headings and no point below them");
  expect_refused("b.ban", "MINIPROF 101\n1 2\n3 4\n", "no point below them; in files of Miniprof a blank line ends");
  expect_refused("b.txt", "3\n0 0\n1 1\n", "it announces 3 points and has 2");
  expect_refused("b.txt", "0 0 1\n0.5 0 1\n", "line 2: 3 number(s); needed: y and z; a third one");
  expect_refused("b.txt", "1 0 0\n2 1 0\n4 2 0\n", "line 3: 3 number(s); needed: y and z");
  expect_refused("b.txt", "0,5,1,5\n1,5,2,5\n", "line 1: 4 number(s); needed: y and z");
  expect_refused("b.txt", "0,5;1,5;2,5\n", "line 1: 3 number(s)");
  expect_refused("b.txt", "y z\n-3O.5 1\n", "line 2: '-3O.5' is no number");
  expect_refused("b.txt", "0 0\ny z\n1 1\n", "line 2: 'y z' among the points");
  expect_refused("b.txt",
                 "\xE2\x88\x92"
                 "1 0\n1 1\n",
                 "line 1: '???1' is no number");
  expect_refused("b.ban", "ColumnDef=A,C\n\n1 2\n", "line 1: ColumnDef names no columns X and Y");
  expect_refused("b.ban", "ColumnDef=X,A,Y\n\n1 2\n", "line 3: 2 number(s); needed by ColumnDef: 3");
}

// A file truncated anywhere, or with any byte changed, is read or refused, no more.
TEST_F(ProfileFiles, truncated_and_changed_files_are_read_or_refused) {
  std::mt19937 random(9);
  int refused = 0, read_all = 0;
  const auto attempt = [&](const std::string& name, const std::string& text) {
    try {
      EXPECT_GE(read(name, text).point.size(), 2U);
      ++read_all;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), Status::err_io);
      ++refused;
    }
  };
  const std::pair<const char*, std::string> files[] = {
      {"t.prr", simpack}, {"t.ban", miniprof}, {"t.txt", "0 0\n1 2\n3 4\n"}};
  for (const auto& [name, text] : files) {
    for (std::size_t n = 0; n < text.size(); ++n) attempt(name, text.substr(0, n));
    for (int i = 0; i < 1000; ++i) {
      std::string changed = text;
      for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = static_cast<char>(random() % 256);
      attempt(name, changed);
    }
  }
  EXPECT_GT(refused, 500);
  EXPECT_GT(read_all, 100);
}

}  // namespace
}  // namespace rollcon
