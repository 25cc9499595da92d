#include "linalg/fft.hpp"

#include <complex>
#include <thread>

#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

TEST(Fft, SizesAreEvenAndSmooth) {
  for (std::int64_t least = 1; least < 1100; ++least) {
    const std::int64_t n = fft_size(least);
    EXPECT_GE(n, least);
    EXPECT_LE(n, std::max<std::int64_t>(2, least + least / 3 + 1));
    EXPECT_EQ(n % 2, 0);
    std::int64_t rest = n;
    for (const int prime : {2, 3, 5, 7})
      while (rest % prime == 0) rest /= prime;
    EXPECT_EQ(rest, 1) << n;
  }
  for (const std::int64_t n : {64, 128, 256, 512, 1024}) EXPECT_EQ(fft_size(n - 1), n);
}

/// Returns the sum of x[k] exp(sign 2 pi i j k / n), one term after the other.
std::vector<std::complex<double>> direct_sum(const std::vector<std::complex<double>>& x, int sign) {
  const std::size_t n = x.size();
  std::vector<std::complex<double>> out(n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k)
      out[j] +=
          x[k] * std::polar(1.0, sign * 2 * std::numbers::pi * static_cast<double>(j * k % n) / static_cast<double>(n));
  return out;
}

template <class T>
void expect_direct_sums(std::int64_t n, double bound) {
  const auto size = static_cast<std::size_t>(n);
  std::vector<std::complex<double>> x(size);
  for (std::size_t k = 0; k < size; ++k)
    x[k] = {std::sin(1.0 + 37.0 * static_cast<double>(k)), std::cos(2.0 + 11.0 * static_cast<double>(k))};
  double error = 0, largest = 0;
  const auto compare = [&](std::complex<double> value, std::complex<double> expected) {
    error = std::max(error, std::abs(value - expected));
    largest = std::max(largest, std::abs(expected));
  };
  const ComplexFft<T> fft(n);
  AlignedArray<std::complex<T>> data(n), waves(n);
  for (const int sign : {-1, 1}) {
    for (std::size_t k = 0; k < size; ++k) data.data()[k] = std::complex<T>(x[k]);
    sign < 0 ? fft.forward(data.data(), waves.data()) : fft.inverse(data.data(), waves.data());
    const auto expected = direct_sum(x, sign);
    for (std::size_t k = 0; k < size; ++k) compare(waves.data()[k], expected[k]);
  }
  const RealFft<T> real(n);
  AlignedArray<T> line(n);
  AlignedArray<std::complex<T>> half(n / 2 + 1);
  for (std::size_t k = 0; k < size; ++k) {
    x[k] = x[k].real();
    line.data()[k] = static_cast<T>(x[k].real());
  }
  real.forward(line.data(), half.data());
  const auto expected = direct_sum(x, -1);
  for (std::size_t k = 0; k <= size / 2; ++k) compare(half.data()[k], expected[k]);
  for (std::size_t k = 0; k < size; ++k) compare(line.data()[k], x[k]);  // unchanged
  real.inverse(half.data(), line.data());
  for (std::size_t k = 0; k < size; ++k) compare(static_cast<double>(line.data()[k]), static_cast<double>(n) * x[k]);
  std::printf("length %lld: error %.1e, bound %.1e\n", static_cast<long long>(n), error / largest, bound);
  EXPECT_LT(error, bound * largest);
}

TEST(Fft, EqualsDirectSums) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  for (const std::int64_t n : {2, 4, 6, 30, 70, 128, 252}) {
    expect_direct_sums<double>(n, 1e-14);
    expect_direct_sums<float>(n, 5e-6);
  }
}

TEST(Fft, OnePlanServesManyThreadsAndPlansAreMadeInAny) {
  if (!has_fft()) GTEST_SKIP() << "built without FFTW";
  const ComplexFft<double> shared(120);
  std::vector<std::thread> threads;
  std::vector<double> error(4, 1);
  for (std::size_t t = 0; t < error.size(); ++t)
    threads.emplace_back([&, t] {
      error[t] = 0;
      for (int k = 0; k < 20; ++k) {
        const ComplexFft<double> own(120);
        AlignedArray<std::complex<double>> data(120), waves(120);
        for (int i = 0; i < 120; ++i) data.data()[i] = {std::sin(i + 1.0), 0};
        own.forward(data.data(), waves.data());
        shared.inverse(waves.data(), data.data());
        for (int i = 0; i < 120; ++i)
          error[t] = std::max(error[t], std::abs(data.data()[i] / 120.0 - std::sin(i + 1.0)));
      }
    });
  for (std::thread& t : threads) t.join();
  for (const double e : error) EXPECT_LT(e, 1e-14);
}

TEST(Fft, SaysWhenItIsNotBuiltIn) {
  if (has_fft()) GTEST_SKIP() << "built with FFTW";
  try {
    const RealFft<double> fft(8);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_unsupported);
    EXPECT_NE(std::string(e.what()).find("FFTW"), std::string::npos);
  }
}

}  // namespace
}  // namespace rollcon
