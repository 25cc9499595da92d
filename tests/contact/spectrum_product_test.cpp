#include "contact/operators/lattice/spectrum_product.hpp"

#include <complex>

#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using rollcon::InstructionSet;

void expect_products(InstructionSet set, double bound) {
  const SpectrumProducts products = spectrum_products(set);
  frames::Random random(11);
  const auto numbers = [&](std::size_t n) {
    std::vector<std::complex<double>> v(n);
    for (auto& z : v) z = {random(), random()};
    return v;
  };
  for (const int count : {1, 2, 3, 4, 7, 8, 9, 31, 64})
    for (int terms = 1; terms <= 3; ++terms) {
      const auto n = static_cast<std::size_t>(count);
      std::vector<std::vector<std::complex<double>>> s, f;
      SpectrumProduct job;
      for (int m = 0; m < 3; ++m) s.push_back(numbers(n)), f.push_back(numbers(n));
      for (std::size_t m = 0; m < 3; ++m) {
        job.spectrum[m] = reinterpret_cast<const double*>(s[m].data());
        job.field[m] = reinterpret_cast<const double*>(f[m].data());
        job.factor[m] = m == 1 ? -1.0 : 1.0;
      }
      // The vector has one number more, which must not change.
      std::vector<std::complex<double>> sum(n + 1, {7.0, 9.0});
      job.terms = terms;
      job.count = count;
      job.sum = reinterpret_cast<double*>(sum.data());
      for (const bool reversed : {false, true}) {
        (reversed ? products.reversed : products.same)(job);
        for (std::size_t k = 0; k < n; ++k) {
          std::complex<double> expected = 0;
          for (std::size_t m = 0; m < static_cast<std::size_t>(terms); ++m)
            expected += job.factor[m] * s[m][reversed ? n - 1 - k : k] * f[m][k];
          EXPECT_LT(std::abs(sum[k] - expected), bound) << count << " " << terms << " " << reversed << " " << k;
        }
        EXPECT_EQ(sum[n], std::complex<double>(7, 9));
      }
    }
}

TEST(SpectrumProduct, EqualsComplexArithmetic) {
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > rollcon::best_instruction_set()) continue;
    expect_products(set, 1e-15);
  }
}

}  // namespace
}  // namespace rollcon
