/// Tests the conversion of relaxation to creep, and what is refused of a material that relaxes.

#include "bodies/model/relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>

#include "bodies/body.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

using Terms = std::vector<PronyTerm>;

// Modulus and creep function at a frequency are each other's inverse.
double misfit(const Terms& relaxation) {
  const Terms creep = creep_of(relaxation);
  double worst = 0;
  for (double w = 1e-8; w < 1e8; w *= 3) {
    std::complex<double> modulus = 1, softness = 1;
    for (const PronyTerm& t : relaxation) modulus -= t.ratio / std::complex<double>(1, w * t.time);
    for (const PronyTerm& t : creep) softness += t.ratio / std::complex<double>(1, w * t.time);
    worst = std::max(worst, std::abs(modulus * softness - 1.0));
  }
  return worst;
}

TEST(relaxation, creep_is_the_inverse_of_the_modulus) {
  const Terms cases[] = {{{0.5, 2.0}},
                         {{0.3, 0.1}, {0.3, 1.0}, {0.2, 10.0}},
                         {{0.2, 1.0}, {0.2, 1.0 + 1e-9}, {0.2, 1.1}},
                         {{1e-12, 1e-3}, {0.9, 1.0}, {1e-9, 7.0}},
                         {{0.4, 1e-6}, {0.4, 1e6}, {0.19999, 1e7}}};
  for (const Terms& relaxation : cases) {
    const double off = misfit(relaxation);
    std::printf("relaxation of %zu terms: modulus times creep off 1 by %.1e (bound 1e-9)\n", relaxation.size(), off);
    EXPECT_LT(off, 1e-9);
    const Terms creep = creep_of(relaxation);
    ASSERT_EQ(creep.size(), relaxation.size());
    for (std::size_t k = 0; k < creep.size(); ++k) {
      EXPECT_GT(creep[k].ratio, 0);
      EXPECT_GE(creep[k].time, relaxation[k].time);
    }
  }
  const Terms one = creep_of({{0.75, 2.0}});
  EXPECT_NEAR(one[0].ratio, 3, 1e-12);
  EXPECT_NEAR(one[0].time, 8, 1e-11);
}

TEST(relaxation, terms_are_sorted_merged_and_checked) {
  const double ratios[] = {0.2, 0.0, 0.1, 0.3}, times[] = {5, 3, 1, 5};
  const Terms terms = checked_relaxation(4, ratios, times);
  ASSERT_EQ(terms.size(), 2U);
  EXPECT_EQ(terms[0], (PronyTerm{0.1, 1}));
  EXPECT_EQ(terms[1], (PronyTerm{0.5, 5}));
  EXPECT_TRUE(checked_relaxation(0, nullptr, nullptr).empty());
  const auto refusal = [](std::int64_t n, std::vector<double> g, std::vector<double> t) -> std::string {
    try {
      checked_relaxation(n, g.data(), t.data());
    } catch (const Error& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_NE(refusal(1, {1.0}, {1.0}).find("entry 0 of ratios"), std::string::npos);
  EXPECT_NE(refusal(2, {0.5, -0.1}, {1.0, 2.0}).find("entry 1 of ratios"), std::string::npos);
  EXPECT_NE(refusal(2, {0.5, 0.5}, {1.0, 2.0}).find("add up to"), std::string::npos);
  EXPECT_NE(refusal(1, {0.5}, {0.0}).find("entry 0 of times"), std::string::npos);
  EXPECT_NE(refusal(1, {0.5}, {std::numeric_limits<double>::infinity()}).find("times"), std::string::npos);
  EXPECT_NE(refusal(101, {0.5}, {1.0}).find("n is 101"), std::string::npos);
}

TEST(relaxation, only_half_spaces_relax_and_files_keep_it) {
  const auto context = std::make_shared<Context>();
  const double ratios[] = {0.5}, times[] = {2};
  Body rigid(context, static_cast<std::int32_t>(BodyKind::rigid));
  EXPECT_THROW(rigid.set_viscoelastic(0, 1, ratios, times), Error);
  Body body(context, static_cast<std::int32_t>(BodyKind::halfspace));
  body.set_elastic(0, 100, 0.4);
  body.set_viscoelastic(0, 1, ratios, times);
  const std::string path = (std::filesystem::temp_directory_path() / "relaxing_body.rcb").string();
  body.save(path);
  EXPECT_EQ(Body::load(context, path)->relaxation(), body.relaxation());
  EXPECT_EQ(body.copy()->relaxation(), body.relaxation());
  std::filesystem::remove(path);
  EXPECT_THROW(body.set_viscoelastic(0, 0, nullptr, nullptr), Error) << "it is prepared";
}

}  // namespace
}  // namespace rollcon
