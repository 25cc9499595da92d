#include "input.hpp"

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace fuzz {
namespace {

using Real = std::numeric_limits<double>;

constexpr double special[] = {0.0,          -0.0,    1e-3, 1e3,   1e-15, 1e15, 1e-30,  1e30,  1e-60,           1e60,
                              1e-160,       1e160,   -1e3, -1e15, 1e-9,  1e9,  1e-300, 1e300, DBL_MIN,         DBL_MAX,
                              DBL_TRUE_MIN, DBL_MAX, 0.5,  0.3,   0.49,  -1,   0.4999, 1,     Real::infinity()};

constexpr std::int64_t odd_number[] = {
    -1, INT64_MIN, INT64_MAX, INT32_MAX, INT32_MIN, std::int64_t{1} << 31, std::int64_t{1} << 32, 1000000, 65536, -2};

}  // namespace

std::int64_t Input::integer() {
  const int how = byte();
  if (how < 220) return how % 16;
  if (how < 250) return odd_number[static_cast<std::size_t>(how - 220) % std::size(odd_number)];
  return static_cast<std::int64_t>(word(8));
}

double Input::real() {
  const int how = byte();
  if (how < 128) return (how - 64) / 64.0;
  if (how < 192) return static_cast<std::int16_t>(word(2)) / 4096.0;
  if (how < 192 + static_cast<int>(std::size(special))) return special[how - 192];
  if (how < 240) return std::ldexp(1.0, 10 * (how - 230));
  if (how < 242) return Real::quiet_NaN();
  if (how < 243) return -Real::infinity();
  return std::bit_cast<double>(word(8));
}

double Input::positive() {
  const double value = real();
  return byte() < 240 ? std::abs(value) : value;
}

std::vector<double> Input::reals(std::size_t n) {
  std::vector<double> values(n);
  for (double& value : values) value = real();
  return values;
}

std::string Input::text(const std::vector<std::string>& words) {
  const int how = byte();
  if (how < 240 && !words.empty()) return words[(static_cast<std::size_t>(how) << 8U | byte()) % words.size()];
  std::string any(static_cast<std::size_t>(below(40)), ' ');
  for (char& c : any) c = static_cast<char>(byte() % 255 + 1);
  return any;
}

}  // namespace fuzz
