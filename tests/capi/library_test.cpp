/// Tests facts about the library.

#include <gtest/gtest.h>
#include <rollcon.h>

#include <cstring>
#include <set>
#include <string>

TEST(library, version_text_and_number_agree) {
  const std::string text = std::to_string(ROLLCON_VERSION_MAJOR) + "." + std::to_string(ROLLCON_VERSION_MINOR) + "." +
                           std::to_string(ROLLCON_VERSION_PATCH);
  const std::string prerelease = ROLLCON_VERSION_PRERELEASE;
  EXPECT_EQ(rollcon_version_string(), prerelease.empty() ? text : text + "-" + prerelease);
  EXPECT_EQ(rollcon_version(), 10000 * ROLLCON_VERSION_MAJOR + 100 * ROLLCON_VERSION_MINOR + ROLLCON_VERSION_PATCH);
  EXPECT_EQ(rollcon_abi(), ROLLCON_ABI);
}

TEST(library, build_info_names_licence_and_version) {
  const std::string info = rollcon_build_info();
  EXPECT_NE(info.find("BSD-3-Clause"), std::string::npos) << info;
  EXPECT_NE(info.find(rollcon_version_string()), std::string::npos) << info;
}

TEST(library, every_status_has_its_own_text) {
  std::set<std::string> texts;
  for (const int status : {0, 1, 2, 3, 4, 5, 6, 7, 8, -1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12, -13, -99})
    texts.insert(rollcon_status_string(status));
  EXPECT_EQ(texts.size(), 23U);
  for (const int unknown : {9, -14, 1000, INT32_MIN, INT32_MAX})
    EXPECT_STREQ(rollcon_status_string(unknown), "unknown status");
}

TEST(library, features_are_yes_no_or_unknown) {
  EXPECT_EQ(rollcon_has_feature("halfspace"), 1);
  EXPECT_EQ(rollcon_has_feature("rigid"), 1);
  for (const char* name : {"bem", "fem", "procedures", "vtu", "openmp", "fftw"})
    EXPECT_EQ(rollcon_has_feature(name) & ~1, 0) << name;
  EXPECT_EQ(rollcon_has_feature("no such feature"), 0);
  EXPECT_EQ(rollcon_has_feature(""), 0);
  EXPECT_EQ(rollcon_has_feature(nullptr), 0);
}
