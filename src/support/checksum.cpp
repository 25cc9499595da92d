#include "support/checksum.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rollcon {
namespace {

constexpr std::uint64_t p1 = 0x9e3779b185ebca87U, p2 = 0xc2b2ae3d27d4eb4fU, p3 = 0x165667b19e3779f9U,
                        p4 = 0x85ebca77c2b2ae63U, p5 = 0x27d4eb2f165667c5U;
constexpr std::size_t stripe = 32;

// Reads a little-endian word, which the definition is made of.
template <class Word>
std::uint64_t word(const unsigned char* from) {
  Word v = 0;
  if constexpr (std::endian::native == std::endian::little)
    std::memcpy(&v, from, sizeof v);
  else
    for (std::size_t i = sizeof v; i-- > 0;) v = static_cast<Word>(v << 8U | from[i]);
  return v;
}

std::uint64_t round(std::uint64_t lane, std::uint64_t input) {
  return std::rotl(lane + input * p2, 31) * p1;
}

std::uint64_t merge(std::uint64_t sum, std::uint64_t lane) {
  return (sum ^ round(0, lane)) * p1 + p4;
}

void consume(std::uint64_t* lane, const unsigned char* from) {
  for (std::size_t i = 0; i < 4; ++i) lane[i] = round(lane[i], word<std::uint64_t>(from + 8 * i));
}

}  // namespace

Checksum::Checksum(std::uint64_t seed) : seed_(seed), lane_{seed + p1 + p2, seed + p2, seed, seed - p1}, rest_{} {}

void Checksum::add(const void* data, std::size_t bytes) {
  if (bytes == 0) return;
  const auto* from = static_cast<const unsigned char*>(data);
  const std::size_t held = total_ % stripe;
  total_ += bytes;
  if (held > 0) {
    const std::size_t taken = std::min(bytes, stripe - held);
    std::memcpy(rest_ + held, from, taken);
    if (held + taken < stripe) return;
    consume(lane_, rest_);
    from += taken;
    bytes -= taken;
  }
  for (; bytes >= stripe; from += stripe, bytes -= stripe) consume(lane_, from);
  std::memcpy(rest_, from, bytes);
}

std::uint64_t Checksum::value() const {
  std::uint64_t sum = seed_ + p5;
  if (total_ >= stripe) {
    sum = std::rotl(lane_[0], 1) + std::rotl(lane_[1], 7) + std::rotl(lane_[2], 12) + std::rotl(lane_[3], 18);
    for (const std::uint64_t lane : lane_) sum = merge(sum, lane);
  }
  sum += total_;
  const unsigned char* at = rest_;
  std::size_t left = total_ % stripe;
  for (; left >= 8; at += 8, left -= 8) sum = std::rotl(sum ^ round(0, word<std::uint64_t>(at)), 27) * p1 + p4;
  if (left >= 4) {
    sum = std::rotl(sum ^ word<std::uint32_t>(at) * p1, 23) * p2 + p3;
    at += 4, left -= 4;
  }
  for (; left > 0; ++at, --left) sum = std::rotl(sum ^ *at * p5, 11) * p1;
  sum = (sum ^ sum >> 33U) * p2;
  sum = (sum ^ sum >> 29U) * p3;
  return sum ^ sum >> 32U;
}

}  // namespace rollcon
