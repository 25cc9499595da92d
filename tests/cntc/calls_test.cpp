// Calls in any order with any numbers, threads, and memory.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <thread>

#include "interface.hpp"

namespace {

using cntc_test::Element;
using cntc_test::Found;

/// Draws arguments: small numbers, codes, numbers that are none; arrays are as long as any length that is drawn.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed), reals_(8192), outputs_(4200000), integers_(4200000) {}

  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

  const int* argument(const int*) {
    static const int codes[] = {CNTC_ic_config, CNTC_ic_pvtime, CNTC_ic_bound,  CNTC_ic_tang,   CNTC_ic_norm,
                                CNTC_ic_force,  CNTC_ic_frclaw, CNTC_ic_discns, CNTC_ic_inflcf, CNTC_ic_mater,
                                CNTC_ic_exrhs,  CNTC_ic_heat,   CNTC_ic_iestim, CNTC_ic_output, CNTC_ic_return,
                                CNTC_ic_sens,   CNTC_if_units,  CNTC_if_idebug, CNTC_if_ncase,  CNTC_ic_npomax};
    const size_t n = 2100;
    if (ints_.size() < 40) ints_.emplace_back(n);
    std::vector<int>& v = ints_[used_++ % ints_.size()];
    for (size_t k = 0; k < 30; ++k) {
      const int kind = number(0, 9);
      v[k] = kind < 7 ? number(-2, 9) : kind < 9 ? codes[number(0, 19)] : number(-40, 40);
    }
    v[0] = number(0, 9) < 8 ? number(0, 12) : v[0];
    return v.data();
  }
  const double* argument(const double*) {
    static const double some[] = {0, 1, -1, .28, .3, .5, 2, 10, 15, 20, 1e-3, 1e-2, 460, -70, 1360, 1e4, 82000, 1e7};
    for (size_t k = 0; k < 40; ++k) reals_[k] = some[number(0, 17)];
    if (number(0, 30) == 0) reals_[size_t(number(0, 9))] = std::nan("");
    if (number(0, 30) == 0) reals_[size_t(number(0, 9))] = -std::numeric_limits<double>::infinity();
    if (number(0, 30) == 0) reals_[size_t(number(0, 9))] = 1e300;
    return reals_.data();
  }
  const char* argument(const char*) { return "no such file"; }
  int* argument(int*) { return integers_.data(); }
  double* argument(double*) { return outputs_.data(); }

  template <class... T>
  void call(void (*function)(T...)) {
    std::tuple<T...> arguments{argument(T{})...};
    place(arguments);
    std::apply(function, arguments);
  }

 private:
  /// Elements 1 and 2 are contacts, 3 is a wheel; others are made now and then.
  template <class... T>
  void place(std::tuple<const int*, T...>& arguments) {
    static const int elements[] = {1, 2, 3, 3, 1, 1, 0, 1000, 4};
    std::get<0>(arguments) = &elements[number(0, 8)];
    if constexpr (sizeof...(T) > 0) {
      if constexpr (std::is_same_v<std::tuple_element_t<1, std::tuple<const int*, T...>>, const int*>)
        if (number(0, 3)) std::get<1>(arguments) = contact();
    }
  }
  template <class... T>
  void place(std::tuple<T...>&) {}
  /// A contact problem; where the argument is an array, it is one of the usual length.
  const int* contact() {
    static const int contacts[] = {1, 1, 1, -1, -1, 2, 0, 10};
    int* v = const_cast<int*>(argument(static_cast<const int*>(nullptr)));
    v[0] = contacts[number(0, 7)];
    return v;
  }

  std::mt19937 engine_;
  std::vector<std::vector<int>> ints_;
  size_t used_ = 0;
  std::vector<double> reals_, outputs_;
  std::vector<int> integers_;
};

/// Something that can be solved, so that random calls meet solutions.
void set_scene(Draw& draw) {
  const int which = draw.number(0, 2);
  Element e(which + 1, which == 2 ? 1 : 3, which == 2 ? -1 : 1, true);
  e.flags({{CNTC_if_units, CNTC_un_cntc}});
  which == 2 ? cntc_test::set_wheel(e) : cntc_test::set_small(e, 1e-3);
}

void call_at_random(unsigned seed, int calls) {
  Draw draw(seed);
  const std::vector<void (*)(Draw&)> functions = {
#define CNTC_ROW(name, category, body, parameters, ...) [](Draw& d) { d.call(&name); },
#include "../../bindings/cntc/functions.inc"
#undef CNTC_ROW
      [](Draw&) { cntc_finalizelast(); }};
  for (int k = 0; k < calls; ++k) {
    if (k % 50 == 0) set_scene(draw);
    size_t which = size_t(draw.number(0, int(functions.size()) - 1));
    if (which + 1 == functions.size() && draw.number(0, 20)) which = 0;
    functions[which](draw);
  }
  cntc_finalizelast();
}

TEST(calls, in_any_order) {
  call_at_random(1, 10000);
}
TEST(calls_nightly, in_any_order) {
  // Other seeds are tried with --gtest_shuffle --gtest_random_seed=N.
  const unsigned first = 2 + 100 * unsigned(testing::UnitTest::GetInstance()->random_seed());
  for (unsigned seed = first; seed < first + 38; ++seed) call_at_random(seed, 20000);
}

TEST(calls, eight_threads) {
  std::vector<double> alone(8), together(8);
  const auto solve = [](int ire) {
    Element e(ire, 3, 1);
    double sum = 0;
    for (int k = 0; k < 20; ++k) {
      cntc_test::set_small(e, 1e-4 * (ire + k));
      EXPECT_GE(e.calculate(), 0);
      sum += e.found().tx;
    }
    return sum;
  };
  const Element keeper(99, 3, 1);  // so that the session does not end with the last of the others
  for (int k = 0; k < 8; ++k) alone[size_t(k)] = solve(k + 1);
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k) threads.emplace_back([&, k] { together[size_t(k)] = solve(k + 1); });
  for (auto& thread : threads) thread.join();
  for (size_t k = 0; k < 8; ++k) EXPECT_EQ(alone[k], together[k]);
}

TEST(calls, one_contact_is_not_solved_by_two) {
  Element e(1, 3, 1);
  cntc_test::set_small(e, 1e-3);
  e.set(cntc_sethertzcontact, -1, {40, 40, 1e-3, 2e-3, 1.2});
  std::atomic<int> solved{0}, refused{0}, others{0};
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k)
    threads.emplace_back([&] {
      for (int n = 0; n < 5; ++n) {
        const int error = e.calculate();
        ++(error == 305 ? refused : error >= 0 ? solved : others);
      }
    });
  for (auto& thread : threads) thread.join();
  std::printf("  solved %d, refused %d\n", solved.load(), refused.load());
  EXPECT_GT(solved, 0);
  EXPECT_EQ(others, 0);
  EXPECT_EQ(solved + refused, 40);
}

/// Returns what the log says last.
std::string last_of_log() {
  std::ifstream file(cntc_test::folder() + "/cntc_test.out");
  std::string last, line;
  while (std::getline(file, line))
    if (!line.empty()) last = line;
  return last;
}

// Every value of every digit either is solved, or the log names the digit, its value and those that are taken.
TEST(calls, digits_run_or_are_refused_by_name) {
  const int one = 1, debug = CNTC_if_idebug, none = 0;  // other tests may have asked for a talkative log
  cntc_setglobalflags(&one, &debug, &none);
  struct Digit {
    const char* name;
    int code, most;
  };
  const Digit digits[] = {{"C1", CNTC_ic_config, 5},
                          {"P", CNTC_ic_pvtime, 3},
                          {"B", CNTC_ic_bound, 6},
                          {"T", CNTC_ic_tang, 3},
                          {"N", CNTC_ic_norm, 1},
                          {"F", CNTC_ic_force, 3},
                          {"D", CNTC_ic_discns, 9},
                          {"C3", CNTC_ic_inflcf, 4},
                          {"E", CNTC_ic_exrhs, 3},
                          {"I", CNTC_ic_iestim, 3},
                          {"M", 0, 7},
                          {"L", 0, 6}};
  std::string refused[2];
  for (const int module : {3, 1})
    for (const Digit& digit : digits)
      for (int value = 0; value <= digit.most; ++value) {
        Element e(1, module, module == 1 ? -1 : 1);
        if (module == 1) {
          cntc_test::set_wheel(e);
          if (digit.code == CNTC_ic_config && value >= 4) {
            e.set(cntc_settrackdimensions, 1, {14, 0, 1435, 0, 500});
            e.flags({{CNTC_ic_config, value}});
            e.set(cntc_setwheelsetvelocity, 2, {4, 0, 0, 0, 0, -4.34});
          }
        } else {
          cntc_test::set_small(e, 1e-3);
          if (digit.code == CNTC_ic_norm && value == 0) e.penetration(.01);
        }
        if (digit.code != 0) {
          e.flags({{digit.code, value}});
        } else if (digit.name[0] == 'M') {
          std::vector<double> constants{.28, .28, 82000, 82000, 1, 1, 1e-3, 1e-3};
          if (value == 4) constants = {.28, .28, 82000, 82000, 8200, .1, 0, 0};
          if (value == 3 || value == 5) constants.pop_back();
          if (value == 0 || value >= 6) constants.resize(4);
          e.set(cntc_setmaterialparameters, value, constants);
        } else {
          std::vector<double> law{.3, .3};
          if (value >= 2 && value <= 4) law = {.2, .1, 1000, 0, 1, 0, 0};
          if (value == 5) law = {.3, .5, 1e-3};
          if (value == 6) law = {.3, 0, -.1, 600, 0, 0};
          if (value == 1) law.clear();
          e.set(cntc_setfrictionmethod, value, law);
        }
        const int code = e.calculate();
        if (code >= 0) continue;
        const std::string said = last_of_log(), asked = std::string(digit.name) + " = " + std::to_string(value);
        EXPECT_NE(said.find(asked), std::string::npos) << "module " << module << ", " << asked << ": " << said;
        EXPECT_TRUE(said.find("allowed: ") != std::string::npos || said.find("needs ") != std::string::npos) << said;
        refused[module == 1] += asked + "; ";
      }
  EXPECT_EQ(refused[0],
            "B = 1; B = 3; B = 4; B = 5; B = 6; F = 3; E = 2; E = 3; M = 2; M = 3; M = 5; M = 6; M = 7; L = 6; ");
  EXPECT_EQ(
      refused[1],
      "C1 = 2; C1 = 3; B = 1; B = 2; B = 3; B = 4; B = 5; B = 6; F = 2; D = 6; D = 7; D = 8; D = 9; M = 1; M = 2; "
      "M = 3; M = 5; M = 6; M = 7; L = 6; ");
}

TEST(calls, fields_that_are_absent_are_named) {
  Element e(1, 3, 1);
  cntc_test::set_small(e, 1e-3);
  EXPECT_GE(e.calculate(), 0);
  for (const auto& [field, name] : {std::pair{CNTC_fld_taucrt, "TAUCRT"}, {CNTC_fld_uplsx, "UPLS"}}) {
    EXPECT_EQ(e.field(field, 4)[0], -777);
    EXPECT_NE(last_of_log().find(name), std::string::npos);
  }
  EXPECT_NE(e.field(CNTC_fld_pn, 4)[0], -777);
}

// Control words of input files: digits out of their ranges are refused by name, with the range.
TEST(calls, digits_of_files_are_refused_by_name) {
  const std::string words[3] = {"1203100", "0022035", "00112111"};
  struct Digit {
    int word, place;
    const char *name, *wrong;
  };
  const Digit digits[] = {
      {0, 0, "C1", "236789"},  {0, 1, "P", "456789"},   {0, 2, "B", "234789"},  {0, 3, "T", "456789"},
      {0, 4, "N", "23456789"}, {0, 5, "F", "2456789"},  {0, 6, "S", "456789"},  {1, 0, "V", "3456789"},
      {1, 1, "L", "5789"},     {1, 3, "C3", "56789"},   {1, 4, "M", "89"},      {1, 5, "Z", "456789"},
      {1, 6, "E", "6789"},     {2, 0, "X", "23456789"}, {2, 1, "H", "2456789"}, {2, 2, "G", "789"},
      {2, 3, "I", "456789"},   {2, 4, "A", "3456789"},  {2, 5, "O", "789"},     {2, 7, "R", "456789"}};
  Element e(1, 1, -1);
  const std::string name = cntc_test::folder() + "/digits.inp";
  for (const Digit& digit : digits)
    for (const char* value = digit.wrong; *value; ++value) {
      std::string changed[3] = {words[0], words[1], words[2]};
      changed[digit.word][size_t(digit.place)] = *value;
      std::ofstream(name) << "1\n" << changed[0] << "\n" << changed[1] << "\n" << changed[2] << "\n";
      const int type = CNTC_inp_modul1, length = int(name.size());
      int error = 0;
      cntc_readinpfile(e.ire(), &type, name.c_str(), &length, &error);
      EXPECT_EQ(error, CNTC_err_input);
      const std::string said = last_of_log(), wanted = std::string(digit.name) + " is " + *value + "; allowed: ";
      EXPECT_NE(said.find(wanted), std::string::npos) << wanted << said;
    }
}

}  // namespace
