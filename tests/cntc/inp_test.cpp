// Input files: cases of both modules, refusals, what is written, and files with random faults.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include "interface.hpp"

namespace {

using cntc_test::Element;
using cntc_test::near;

const std::string& folder = cntc_test::folder();

void write(const std::string& name, const std::string& text) {
  std::ofstream(folder + "/" + name) << text;
}

void write_profiles() {
  for (const char* name : {"s1002", "60e1"}) {
    std::ofstream file(folder + "/" + name + ".txt");
    const auto points = cntc_test::profile_points(name);
    for (size_t k = 0; k < points.size(); k += 2) file << points[k] << " " << points[k + 1] << "\n";
  }
}

std::string read(const std::string& name) {
  std::ifstream file(folder + "/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Runs the program; returns its exit status.
int run(const std::string& arguments) {
  const std::string command = std::string(CNTC_TEST_PROGRAM) + " " + arguments + " 2> " + folder + "/errors.txt";
  const int status = std::system(command.c_str());
  return status < 0 ? -1 : status / 256;
}

/// Numbers of the line that comes `after` lines below a heading, the n-th of its kind.
std::vector<double> numbers_below(const std::string& text, const std::string& heading, int nth, int after) {
  size_t at = 0;
  for (int k = 0; k <= nth; ++k) at = text.find(heading, k == 0 ? 0 : at + 1);
  if (at == std::string::npos) return {};
  for (int k = 0; k < after; ++k) at = text.find('\n', at + 1);
  std::istringstream line(text.substr(at + 1, text.find('\n', at + 1) - at - 1));
  std::vector<double> values;
  for (double v = 0; line >> v;) values.push_back(v);
  return values;
}

const char* const curve = R"(% creep curve
 3  1 1  MODULE
  203100    P-B-T-N-F-S
  022020    L-D-C-M-Z-E
  0012211   G-I-A-O-W-R, and X-H in front
  999 20 25 1 1.e-5   MAXGS MAXIN MAXNR MAXOUT EPS
  106700.  1.0d-5, 0. 0.   FN CKSI CETA CPHI
  0.33 0.33     FSTAT FKIN
  0d  0.2889  10000.   CHI DQ VELOC
  0.28  0.28           % values over two lines
  82000. 82000.  POISS GG
  -2   IPOTCN
  44 48  .0008  .5  1.0083
% the next case keeps friction and grid
 3
  203100    P-B-T-N-F-S
  110000    L-D-C-M-Z-E
  0112211   X-H-G-I-A-O-W-R
  106700.  1.6d-3 0. 0.
  0  MODULE
)";

TEST(inp, creep_curve) {
  write("curve.inp", curve);
  ASSERT_EQ(run(folder + "/curve.inp"), 0) << read("errors.txt");
  const std::string out = read("curve.out");
  // CONTACT's parser looks for this on the second line, and counts lines and blanks below these headings.
  const size_t second = out.find('\n') + 1;
  EXPECT_NE(out.substr(second, out.find('\n', second) - second).find("detailed investigation of 3D"),
            std::string::npos);
  EXPECT_NE(out.find("ELAST.EN.   FRIC.POWER"), std::string::npos);
  EXPECT_EQ(numbers_below(out, "ELAST.EN.   FRIC", 0, 1).size(), 6u);
  EXPECT_EQ(numbers_below(out, "ELAST.EN.   FRIC", 0, 3).size(), 6u);
  const auto statistics = numbers_below(out, "CONTACT STATISTICS", 0, 4);
  ASSERT_EQ(statistics.size(), 6u);
  EXPECT_GT(statistics[4], 1);  // a cold solve takes several Newton steps
  EXPECT_EQ(statistics[5], statistics[4]);
  for (int k = 0; k < 2; ++k) {
    const auto relative = numbers_below(out, "FN/G", k, 1);
    ASSERT_GE(relative.size(), 5u) << out;
    EXPECT_TRUE(near("Fx/(fstat Fn)", relative[1], k == 0 ? -7.015e-3 : -.7831, .01));
    EXPECT_TRUE(near("approach", relative[3], .07651, 2e-4));
  }
  // The table of elements: six pairs of lines, a heading, and a row for each element in contact.
  std::istringstream mat(read("curve.0002.mat"));
  std::string line;
  int rows = 0, columns = 0;
  double force = 0;
  for (int k = 0; std::getline(mat, line); ++k) {
    if (k < 12 || line.find('%') != std::string::npos) {
      if (k < 12) {
        EXPECT_EQ(line[0] == '%', k % 2 == 0);
      }
      // Every row has 11 numbers of 14 places, as tables that are loaded must have; two whole ones share one place.
      if (k % 2 == 1) {
        std::istringstream words(line);
        size_t n = 0;
        for (double x = 0; words >> x;) ++n;
        EXPECT_EQ(n, 11u) << line;
      }
      if (k == 7) {
        EXPECT_EQ(line.substr(0, 14), "     44  48   ");
      }
      continue;
    }
    std::istringstream words(line);
    std::vector<double> v;
    for (double x = 0; words >> x;) v.push_back(x);
    columns = int(v.size());
    EXPECT_EQ(line.size(), 140u) << line;
    EXPECT_EQ(line.substr(11, 3), "   ") << line;
    ++rows;
    force += v[4] * 2 * 6.303597 * 1.0083 / 44 * 2 * 12.607194 * 1.0083 / 48;
  }
  EXPECT_EQ(columns, 11);
  EXPECT_TRUE(near("Fn of the table", force, 106700, 1));
  EXPECT_GT(rows, 1300);
}

TEST(inp, cases_of_a_wheel_and_its_inside) {
  write_profiles();
  write("wheel.inp", R"(
 1 MODULE
  1203103   C-P-B-T-N-F-S
  0022035   V-L-D-C-M-Z-E
  0101201   X-H-G-I-A-O-W-R
  0.3 0.3   FSTAT FKIN
  0.28 0.28 82000 82000  POISS GG
  0.4 0.4 1.0 90d 8 4   DX DS DQREL A_SEP D_SEP D_COMB
  14 0 1435 .02499479 0   GAUGHT GAUGSQ GAUGWD CANT CURV
  '60e1.txt' 0 1.0 0.0 -1
  0 0 0 0 0 0  deviation
  1360 -70 460   FBDIST FBPOS NOMRADW
  's1002.txt' 0 1.0 0.0 -1
  0 2 10000 -1.128e-4 4.8e-3 0
  2000 0 0 0 0 -4.3459197
  0 0 0 0 0 0 0 0 0 0 0 0
  1 1  MATFIL OUTPUT
  9  ISUBS
  2 1 3
  -3.0 0.0
  0.
  0. .5 1.
  0  ISUBS
 1
  0203100   the left wheel, one millimetre
  0112002
  0101201
  0.28 0.28 82000 82000
  0 1 10000 -5.049e-5 2.4e-3 0
  2000 0 0 0 0 -4.3465752
 0
)");
  ASSERT_EQ(run(folder + "/wheel.inp"), 0) << read("errors.txt");
  const std::string out = read("wheel.out");
  const auto f = numbers_below(out, "FX(TR)", 0, 1), left = numbers_below(out, "FX(TR)", 1, 1);
  ASSERT_GE(f.size(), 3u) << out;
  ASSERT_GE(left.size(), 3u) << out;
  // Lines below these headings are where CONTACT's parser takes them.
  for (const auto& [heading, line] : {std::pair{"FX(TR)      FY(TR)", 1},
                                      {"MX(TR)      MY(TR)", 1},
                                      {"WHEEL-SET POSITION", 2},
                                      {"WHEEL-SET POSITION", 5},
                                      {"----- DATA FOR CONTACT PATCH  1", 4},
                                      {"CONTACT REFERENCE LOCATION", 2},
                                      {"KINEMATIC CONSTANTS", 2}})
    EXPECT_EQ(numbers_below(out, heading, 0, line).size(), 6u) << heading;
  EXPECT_NE(out.find("CONTACT, RIGHT WHEEL,  1 CONTACT PATCH\n"), std::string::npos);
  EXPECT_NE(out.find(" MAX     SIGVM ="), std::string::npos);
  EXPECT_TRUE(near("Fx, right, 2 mm", f[0], -517.3, 30));
  EXPECT_TRUE(near("Fz, right, 2 mm", f[2], 10000, 1));
  EXPECT_TRUE(near("Fx, left, 1 mm", left[0], 829.2, 30));
  EXPECT_NE(read("wheel.0001a.subs").find("SIGVM"), std::string::npos);
}

TEST(inp, cases_of_a_roller_and_a_variable_rail) {
  write_profiles();
  write("same.slcs", "0. 1.\n2\n0 0 0\n1\n-100 '60e1.txt'\n100 '60e1.txt'\n");
  const std::string text = R"(
 1 MODULE
  5203100   C-P-B-T-N-F-S
  0022033   V-L-D-C-M-Z-E
  0000211   X-H-G-I-A-O-W-R
  999 20 25 1 1e-5
  0.3 0.3
  0.28 0.28 82000 82000
  0.4 0.4 1.0 90d 8 4
  0 753.4 .2 RADIUS 0   GAUGHT RAILY0 RAILZ0 NOMRADR or CANT, CURV
  'RAIL' 0 1.0 0.0 -1
  0 0 0 0 0 0
  1360 -70 460
  's1002.txt' 0 1.0 0.0 -1
  0 2 10000 0 4.8e-3 0
  SPEED 0 0 0 0 -4.3459197
 0
)";
  const auto forces = [&](const char* config, const char* radius, const char* rail, const char* speed) {
    std::string own = text;
    const auto put = [&](const std::string& word, const char* by) { own.replace(own.find(word), word.size(), by); };
    put("5203100", config);
    put("RADIUS", radius);
    put("RAIL' ", rail);
    put("SPEED", speed);
    write("roller.inp", own);
    EXPECT_EQ(run(folder + "/roller.inp"), 0) << read("errors.txt");
    return numbers_below(read("roller.out"), "FX(TR)", 0, 1);
  };
  const auto plain = forces("1203100", "0", "60e1.txt' ", "2000"),
             vast = forces("5203100", "1e7", "60e1.txt' ", "2e-4"),
             slices = forces("1203100", "0", "same.slcs' ", "2000");
  ASSERT_GE(plain.size(), 3u);
  ASSERT_GE(vast.size(), 3u);
  ASSERT_GE(slices.size(), 3u);
  EXPECT_TRUE(near("Fz", plain[2], 10000, 1));
  for (const size_t k : {0u, 1u, 2u}) {
    EXPECT_TRUE(near("vast roller", vast[k], plain[k], 1));
    EXPECT_TRUE(near("equal slices", slices[k], plain[k], 1));
  }
}

TEST(inp, wrong_files_are_refused_with_their_line) {
  const std::pair<const char*, const char*> faults[] = {
      {"106700.  1.0d-5", "106700.  abc"}, {"022020", "922020"}, {"022020", "002020"},  {"-2   IPOTCN", "7  IPOTCN"},
      {"0.28  0.28 ", "0.9 0.28"},         {"203100", "2x3100"}, {" 3  1 1", " 4 1 1"}, {"44 48", "0 48"}};
  for (const auto& [from, to] : faults) {
    std::string text = curve;
    text.replace(text.find(from), std::string(from).size(), to);
    write("wrong.inp", text);
    EXPECT_EQ(run(folder + "/wrong.inp"), 1) << to;
    EXPECT_NE(read("errors.txt").find("line "), std::string::npos) << to;
  }
  EXPECT_EQ(run(folder + "/missing.inp"), 1);
}

TEST(inp, what_was_set_is_written_and_read_again) {
  double forces[3];
  {
    Element e(1, 3, 1);
    e.flags({{CNTC_if_wrtinp, 1}});
    e.set(cntc_setmaterialparameters, 4, {.28, .3, 82000, 70000, 8200, 1.25, 0, 0});
    e.set(cntc_setfrictionmethod, 4, {.14, .19, 1250, 0, 1, 0, 0});
    e.set(cntc_sethertzcontact, -2, {14, 16, .0008, .5, 1.1});
    e.velocity(10000);
    e.normal_force(106700);
    e.creepages(2e-3, 1e-3, 1e-5);
    ASSERT_GE(e.calculate(), 0);
    forces[0] = e.found().fn;
    forces[1] = e.found().tx;
    forces[2] = e.found().ty;
  }
  std::string text = read("cntc_test.inp");
  const size_t at = text.find("   X-H-G-I-A-O-W-R");
  text[at - 3] = '2';  // O
  write("again.inp", text + " 0\n");
  ASSERT_EQ(run(folder + "/again.inp"), 0) << read("errors.txt");
  const auto again = numbers_below(read("again.out"), "ELAST.EN.", 0, 1);
  ASSERT_GE(again.size(), 3u);
  for (size_t k = 0; k < 3; ++k) EXPECT_TRUE(near("force", again[k], forces[k], 1e-3 * forces[0]));
}

TEST(inp, library_takes_a_wheel_from_a_file) {
  // cases_of_a_wheel_and_its_inside has written profiles, if it ran in this program; the file is read all the same.
  write("first.inp", R"(1
  1203100
  0022035
  0101201
  0.25 0.25
  0.28 0.28 82000 82000
  0.4 0.4 1.0 90d 8 4
  14 0 1435 1.4321d 0
  'none.txt' 0 1.0 0.0
  0 .1 0 0 0 0
  1360 -70 460
  'none.txt' 0 1.0 0.0
  0 2 10000 0 4.8e-3 0
  2000 0 0 0 0 -4.3459197
  0 0 0 0 0 0 0 0 0 0 0 0
)");
  Element e(1, 1, -1);
  const std::string name = folder + "/first.inp";
  const int length = int(name.size()), type = CNTC_inp_modul1, other = CNTC_inp_vamp;
  int error = 1;
  cntc_readinpfile(e.ire(), &type, name.c_str(), &length, &error);
  EXPECT_EQ(error, 0);
  EXPECT_EQ(e.position()[1], 2);
  EXPECT_EQ(e.flag(CNTC_ic_norm), 1);
  EXPECT_EQ(e.calculate(), CNTC_err_profil);  // the file names profiles that are not there
  cntc_readinpfile(e.ire(), &other, name.c_str(), &length, &error);
  EXPECT_EQ(error, CNTC_err_input);
  write("curve_again.inp", curve);
  const std::string gap = folder + "/curve_again.inp";
  const int longer = int(gap.size());
  cntc_readinpfile(e.ire(), &type, gap.c_str(), &longer, &error);
  EXPECT_EQ(error, CNTC_err_input);
  EXPECT_EQ(e.position()[1], 2);  // nothing has changed
}

/// Files with a few random faults: they are read or refused, and nothing else.
void fuzz(unsigned seed, int files) {
  std::mt19937 engine(seed);
  const auto number = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(engine); };
  const std::string alphabet = "0123456789.-+edDr%'\" ,\n\tTF";
  std::ostringstream list;
  for (int k = 0; k < files; ++k) {
    std::string text = curve;
    for (size_t faults = 1 + number(4); faults > 0; --faults) {
      const size_t at = number(text.size());
      switch (number(4)) {
        case 0:
          text[at] = alphabet[number(alphabet.size())];
          break;
        case 1:
          text.erase(at, 1 + number(20));
          break;
        case 2:
          text.insert(at, std::string(1 + number(3), alphabet[number(alphabet.size())]));
          break;
        default:
          text.insert(at, text.substr(number(text.size()), number(60)));
      }
    }
    write("fuzz.inp", text);
    const int status = run("--check " + folder + "/fuzz.inp");
    EXPECT_TRUE(status == 0 || status == 1) << status << "\n" << text;
  }
}
TEST(inp, faults_are_read_or_refused) {
  fuzz(1, 60);
}
TEST(inp_nightly, faults_are_read_or_refused) {
  fuzz(2 + unsigned(testing::UnitTest::GetInstance()->random_seed()), 5000);
}

}  // namespace
