// The names of the interface, and what functions say before anything was set.
#include <gtest/gtest.h>

#include <cstring>

#include "interface.hpp"

// Declares each function a second time, with an underscore behind its name.
#define CNTC_ROW(name, category, body, parameters, ...) extern "C" void name##_ parameters;
#include "../../bindings/cntc/functions.inc"
#undef CNTC_ROW
extern "C" void cntc_finalizelast_(void);

namespace {

using cntc_test::Element;

/// Calls a function with as many null pointers as it has parameters.
template <class... T>
void call_with_nothing(void (*function)(T...)) {
  function(T{}...);
}

TEST(symbols, all_names_are_exported_in_both_spellings) {
  int names = 1;  // cntc_finalizelast
#define CNTC_ROW(name, category, body, parameters, ...) \
  ++names;                                              \
  EXPECT_NE(reinterpret_cast<void*>(&name), nullptr);   \
  EXPECT_NE(reinterpret_cast<void*>(&name), reinterpret_cast<void*>(&name##_));
#include "../../bindings/cntc/functions.inc"
#undef CNTC_ROW
  EXPECT_EQ(names, 70);
}

TEST(symbols, null_pointers_are_refused) {
#define CNTC_ROW(name, category, body, parameters, ...) \
  call_with_nothing(&name);                             \
  call_with_nothing(&name##_);
#include "../../bindings/cntc/functions.inc"
#undef CNTC_ROW
  cntc_finalizelast_();
  cntc_finalizelast();
}

TEST(symbols, version_of_the_interface) {
  int version = 0, error = 5;
  const int zero = 0, ire = 1, module = 3;
  cntc_initializefirst_new(&version, &error, &zero, "", CNTC_TEST_FOLDER, "cntc_version", &zero, &zero, &zero);
  EXPECT_EQ(version, 2520);
  EXPECT_EQ(error, 0);
  cntc_initialize(&ire, &module, &version, &error, "", &zero);
  EXPECT_EQ(error, 0);
  const int wrong = 7;
  cntc_initialize(&wrong, &wrong, &version, &error, "", &zero);
  EXPECT_EQ(error, CNTC_err_icp);
  cntc_finalizelast();
}

/// An answer to calculate for a result element of a module and a contact problem.
int refusal(int ire, int icp) {
  int error = 0;
  cntc_calculate(&ire, &icp, &error);
  return error;
}

TEST(symbols, categories_refuse) {
  const Element gap(1, 3, 1), wheel(2, 1, -1);
  EXPECT_EQ(refusal(0, 1), -101);
  EXPECT_EQ(refusal(1000, 1), -101);
  EXPECT_EQ(refusal(1, 10), -104);
  EXPECT_EQ(refusal(1, 0), -105);
  EXPECT_EQ(refusal(1, -1), -105);
  EXPECT_EQ(refusal(2, 1), -106);
  int error = 0;
  const int one = 1, two = 2;
  cntc_calculate1(&one, &error);
  EXPECT_EQ(error, -103);
  cntc_calculate3(&two, &one, &error);
  EXPECT_EQ(error, -102);
  // Setters that are refused leave outputs as they were.
  double value = 42;
  const int three = 3;
  cntc_getpenetration(&two, &three, &value);
  EXPECT_EQ(value, 42);
}

TEST(symbols, unknown_elements_are_made) {
  const int ire = 77, icp = -1, one = 1;
  int code = CNTC_ic_config, value = 0;
  cntc_getflags(&ire, &icp, &one, &code, &value);
  EXPECT_EQ(value, 1);
  EXPECT_EQ(refusal(77, -1), CNTC_err_profil);  // it is of module 1, and has no profiles
  cntc_finalize(&ire);
}

TEST(symbols, a_hundred_elements) {
  int version = 0, error = 0;
  const int zero = 0, module = 3;
  for (int ire = 1; ire <= 101; ++ire) {
    cntc_initialize(&ire, &module, &version, &error, "", &zero);
    EXPECT_EQ(error, ire <= 100 ? 0 : CNTC_err_icp) << ire;
  }
  for (int ire = 1; ire <= 100; ++ire) cntc_finalize(&ire);
}

TEST(flags, ranges_and_standards) {
  Element e(1, 1, -1);
  EXPECT_EQ(e.flag(CNTC_ic_tang), 3);
  EXPECT_EQ(e.flag(CNTC_ic_npomax), 20000);
  EXPECT_EQ(e.flag(CNTC_ic_discns), 2);
  EXPECT_EQ(e.flag(CNTC_if_units), CNTC_un_cntc);
  e.flags({{CNTC_ic_tang, 9}, {0, 5}, {CNTC_ic_npomax, 1}, {CNTC_ic_sbsout, 3}, {CNTC_ic_matfil, 7}, {4711, 1}});
  EXPECT_EQ(e.flag(CNTC_ic_tang), 3);
  EXPECT_EQ(e.flag(CNTC_ic_npomax), 100);
  EXPECT_EQ(e.flag(CNTC_ic_sbsout), 2);
  EXPECT_EQ(e.flag(CNTC_ic_matfil), 0);
  e.flags({{CNTC_if_units, CNTC_un_imper}, {CNTC_ic_mater, 4}});
  EXPECT_EQ(e.flag(CNTC_if_units), CNTC_un_cntc);
  EXPECT_EQ(e.flag(CNTC_ic_mater), 0);
  EXPECT_EQ(e.flag(4711), -777);
}

TEST(flags, friction_needs_its_parameters) {
  Element e(1, 3, 1);
  e.set(cntc_setfrictionmethod, 4, {.14, .19, 1250, 0, 1, .003, 0});
  EXPECT_EQ(e.flag(CNTC_ic_frclaw), 4);
  e.set(cntc_setfrictionmethod, 2, {.14, .19});
  EXPECT_EQ(e.flag(CNTC_ic_frclaw), 4);
  e.set(cntc_setfrictionmethod, 7, {.3, .3});
  EXPECT_EQ(e.flag(CNTC_ic_frclaw), 4);
  e.set(cntc_setfrictionmethod, 5, {.3, .4, .001});  // Polach is the exponential law
  EXPECT_EQ(e.flag(CNTC_ic_frclaw), 4);
  e.set(cntc_setfrictionmethod, 0, {.3, .25});
  EXPECT_EQ(e.flag(CNTC_ic_frclaw), 0);
}

}  // namespace
