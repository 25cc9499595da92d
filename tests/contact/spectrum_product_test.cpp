#include "contact/lattice/spectrum_product.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <vector>

#include "support/frames.hpp"

namespace rollcon {
namespace {

using halfspace::InstructionSet;

template <class T>
void expect_products(InstructionSet set, double bound) {
  const SpectrumProducts<T> products = spectrum_products<T>(set);
  frames::Random random(11);
  const auto numbers = [&](std::size_t n) {
    std::vector<std::complex<T>> v(n);
    for (auto& z : v) z = {static_cast<T>(random()), static_cast<T>(random())};
    return v;
  };
  for (const int count : {1, 2, 3, 4, 7, 8, 9, 31, 64})
    for (int terms = 1; terms <= 3; ++terms) {
      const auto n = static_cast<std::size_t>(count);
      std::vector<std::vector<std::complex<T>>> s, f;
      SpectrumProduct<T> job;
      for (int m = 0; m < 3; ++m) s.push_back(numbers(n)), f.push_back(numbers(n));
      for (std::size_t m = 0; m < 3; ++m) {
        job.spectrum[m] = reinterpret_cast<const T*>(s[m].data());
        job.field[m] = reinterpret_cast<const T*>(f[m].data());
        job.factor[m] = m == 1 ? T(-1) : T(1);
      }
      // One number more, which must stay as it is.
      std::vector<std::complex<T>> sum(n + 1, {T(7), T(9)});
      job.terms = terms;
      job.count = count;
      job.sum = reinterpret_cast<T*>(sum.data());
      for (const bool reversed : {false, true}) {
        (reversed ? products.reversed : products.same)(job);
        for (std::size_t k = 0; k < n; ++k) {
          std::complex<double> expected = 0;
          for (std::size_t m = 0; m < static_cast<std::size_t>(terms); ++m)
            expected += static_cast<double>(job.factor[m]) *
                        std::complex<double>(s[m][reversed ? n - 1 - k : k]) *
                        std::complex<double>(f[m][k]);
          EXPECT_LT(std::abs(std::complex<double>(sum[k]) - expected), bound)
              << count << " " << terms << " " << reversed << " " << k;
        }
        EXPECT_EQ(sum[n], std::complex<T>(7, 9));
      }
    }
}

TEST(SpectrumProduct, EqualsComplexArithmetic) {
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > halfspace::best_instruction_set()) continue;
    expect_products<double>(set, 1e-15);
    expect_products<float>(set, 1e-6);
  }
}

}  // namespace
}  // namespace rollcon
