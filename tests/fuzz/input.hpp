#pragma once
/// Takes numbers from the bytes of an input, from its front; zeros when they are used up.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fuzz {

class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  bool more() const { return at_ != end_; }
  std::uint8_t byte() { return more() ? *at_++ : std::uint8_t{0}; }
  /// Returns 0 to n - 1.
  int below(int n) { return byte() % n; }
  bool one_in(int n) { return byte() % n == n - 1; }
  std::uint64_t word(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= std::uint64_t{byte()} << (8 * i);
    return value;
  }
  /// Returns numbers that are mostly small, seldom absurd.
  std::int64_t integer();
  std::int32_t integer32() { return static_cast<std::int32_t>(integer()); }
  /// Returns numbers mostly between -8 and 8, some tiny, huge, subnormal or not finite.
  double real();
  /// Returns numbers that are mostly positive and of order 1.
  double positive();
  std::vector<double> reals(std::size_t n);
  /// Returns one of the words, or any characters, without NUL within.
  std::string text(const std::vector<std::string>& words);

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

}  // namespace fuzz
