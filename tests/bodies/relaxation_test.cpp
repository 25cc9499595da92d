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

/// Samples moduli of a Prony series, so many a decade.
struct Moduli {
  std::vector<double> frequency, storage, loss;
  Moduli(const Terms& terms, double young, double from, double to, int per_decade) {
    for (double d = std::log10(from); d < std::log10(to) + 1e-9; d += 1.0 / per_decade) {
      frequency.push_back(std::pow(10, d));
      const std::complex<double> value = young * Relaxation{terms, {}}.modulus(frequency.back());
      storage.push_back(value.real()), loss.push_back(value.imag());
    }
  }
  std::int64_t size() const { return std::ssize(frequency); }
};

TEST(relaxation, series_fit_moduli) {
  for (const Terms& terms : {Terms{{0.5, 0.03}}, Terms{{0.25, 1e-3}, {0.25, 1e-2}, {0.2, 1e-1}}}) {
    const Moduli given(terms, 12, 1e-1, 1e5, 8);
    double young = 0;
    const Relaxation found =
        checked_moduli(given.size(), given.frequency.data(), given.storage.data(), given.loss.data(), young);
    double between = 0;
    for (double w = 0.2; w < 5e4; w *= 1.37) {
      const std::complex<double> exact = Relaxation{terms, {}}.modulus(w);
      between = std::max(between, std::abs(young / 12 * Relaxation{found.term, {}}.modulus(w) / exact - 1.0));
    }
    std::printf("%zu terms fitted by %zu: misfit %.1e, between points %.1e (bound 2e-3), E %+.1e (1e-2)\n",
                terms.size(), found.term.size(), found.misfit, between, young / 12 - 1);
    EXPECT_LT(found.misfit, 2e-3);
    EXPECT_LT(between, 2e-3);
    EXPECT_NEAR(young, 12, 0.12);
    // The table itself is interpolated.
    EXPECT_NEAR(found.modulus(given.frequency[5]).imag() * young, given.loss[5], 1e-12);
    EXPECT_NEAR(found.modulus(0).real() * young, given.storage[0], 1e-12);
    EXPECT_EQ(found.modulus(0).imag(), 0);
    EXPECT_NEAR(found.modulus(1e9).real() * young, given.storage.back(), 1e-12);
  }
}

TEST(relaxation, moduli_that_no_material_has_are_refused) {
  const auto context = std::make_shared<Context>();
  Body body(context, static_cast<std::int32_t>(BodyKind::halfspace));
  const auto refusal = [&](std::vector<double> w, std::vector<double> storage,
                           std::vector<double> loss) -> std::string {
    try {
      body.set_moduli(0, std::ssize(w), w.data(), storage.data(), loss.data());
    } catch (const Error& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_NE(refusal({1, 10}, {1, 2}, {0.3, 0.3}).find("Poisson's ratio"), std::string::npos);
  body.set_elastic(0, 100, 0.4);
  EXPECT_NE(refusal({1, 1}, {1, 2}, {0, 0}).find("entry 1 of frequencies"), std::string::npos);
  EXPECT_NE(refusal({1, 2}, {1, 0}, {0, 0}).find("entry 1 of storage"), std::string::npos);
  EXPECT_NE(refusal({1, 2}, {1, 2}, {0, -1}).find("entry 1 of loss"), std::string::npos);
  // The storage modulus of a material cannot fall with the frequency.
  EXPECT_NE(refusal({1, 10, 100}, {2, 1, 0.5}, {0.1, 0.1, 0.1}).find("nearest Prony series"), std::string::npos);
  EXPECT_FALSE(body.creeps()) << "the body is as it was";
  EXPECT_EQ(body.young(), 100);
  const Moduli given({{0.5, 0.03}}, 12, 1e-1, 1e4, 6);
  EXPECT_EQ(refusal(given.frequency, given.storage, given.loss), "");
  EXPECT_NEAR(body.young(), 12, 0.1);
  EXPECT_TRUE(body.creeps());
}

TEST(relaxation, half_spaces_relax_and_files_keep_it) {
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
