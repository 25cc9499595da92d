// Compares XXH64 with published values, whole and in pieces.

#include "support/checksum.hpp"

#include "support/testing.hpp"

namespace rollcon {
namespace {

std::uint64_t checksum(const std::string& text, std::uint64_t seed = 0) {
  Checksum sum(seed);
  sum.add(text.data(), text.size());
  return sum.value();
}

TEST(Checksum, published_values) {
  EXPECT_EQ(checksum(""), 0xef46db3751d8e999U);
  EXPECT_EQ(checksum("a"), 0xd24ec4f1a98c6e5bU);
  EXPECT_EQ(checksum("abc"), 0x44bc2cf5ad770999U);
  EXPECT_EQ(checksum("Nobody inspects the spammish repetition"), 0xfbcea83c8a378bf1U);
  EXPECT_EQ(checksum("xxhash", 20141025), 13067679811253438005U);
}

TEST(Checksum, pieces_do_not_matter) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += static_cast<char>(7 * i + i / 9);
  const std::uint64_t whole = checksum(text);
  for (std::size_t piece = 1; piece < 100; ++piece) {
    Checksum sum;
    for (std::size_t at = 0; at < text.size(); at += piece)
      sum.add(text.data() + at, std::min(piece, text.size() - at));
    EXPECT_EQ(sum.value(), whole) << piece;
  }
}

TEST(Checksum, every_flipped_bit_shows) {
  std::string text(100, 'x');
  const std::uint64_t whole = checksum(text);
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    text[bit / 8] = static_cast<char>(text[bit / 8] ^ 1 << bit % 8);
    EXPECT_NE(checksum(text), whole) << bit;
    text[bit / 8] = static_cast<char>(text[bit / 8] ^ 1 << bit % 8);
  }
}

}  // namespace
}  // namespace rollcon
