#include "linalg/blas_kernels.hpp"

#include <algorithm>
#include <cctype>

// The symbols are weak, so that another BLAS links as well.
extern "C" {
__attribute__((weak)) char* openblas_get_corename(void);
__attribute__((weak)) char* openblas_get_config(void);
}

namespace rollcon {
namespace {

/// Returns the first two words: name and version.
std::string version_of(const std::string& config) {
  const std::size_t name = config.find(' ');
  return config.substr(0, name == std::string::npos ? name : config.find(' ', name + 1));
}

}  // namespace

BlasKernels blas_kernels() {
  BlasKernels kernels;
  if (openblas_get_corename)
    if (const char* core = openblas_get_corename()) kernels.core = core;
  if (openblas_get_config)
    if (const char* config = openblas_get_config()) kernels.config = config;
  return kernels;
}

// Warns of OpenBLAS 0.3.21 on Xeons with AVX512_BF16: getrf of 6000 unknowns took 16 s with its kernels for Cooper
// Lake, 6 s with those for Skylake-X or Haswell; up to 4500 all were alike.
std::string slow_factorization(const BlasKernels& kernels, std::int64_t unknowns) {
  constexpr std::int64_t alike = 4500;
  std::string core = kernels.core;
  std::transform(core.begin(), core.end(), core.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (unknowns <= alike || core != "cooperlake") return {};
  return (kernels.config.empty() ? "OpenBLAS" : version_of(kernels.config)) +
         " uses its kernels for Cooper Lake, with which dense factors of more than 4500 unknowns "
         "took up to 3 times as long as with others: set OPENBLAS_CORETYPE=SKYLAKEX in the "
         "environment before the program starts";
}

}  // namespace rollcon
