#pragma once
/// Computes XXH64 (Collet, xxHash): 64 bits of a stream of bytes. A change confined to one word of eight bytes always
/// shows; other changes are missed once in 2^64. It is no cryptography.

#include <cstddef>
#include <cstdint>

namespace rollcon {

class Checksum {
 public:
  explicit Checksum(std::uint64_t seed = 0);
  void add(const void* data, std::size_t bytes);
  /// Returns the checksum of all bytes so far; more may follow.
  std::uint64_t value() const;

 private:
  std::uint64_t seed_, total_ = 0;
  std::uint64_t lane_[4];
  unsigned char rest_[32];  ///< total_ % 32 bytes that do not fill the lanes yet
};

}  // namespace rollcon
