#include "support/ranks.hpp"

#include <algorithm>
#include <cstdio>

#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

constexpr std::size_t text_size = 1024;

}  // namespace

/// Marks what all ranks throw together.
template <class Thrown>
struct Ranks::OnAll : Thrown, OfAnother {
  using Thrown::Thrown;
};

// The least of (rank that fails, count, -count) says whether a rank fails, and whether all have the same count.
void Ranks::tell(Status status, const char* text, std::int64_t count) const {
  std::int64_t found[3] = {status == Status::ok ? size_ : rank_, count, -count};
  least(found, 3);
  if (found[0] == size_) {
    if (found[1] == -found[2]) return;
    throw OnAll<Error>(Status::err_state, "the ranks of the communicator make unlike calls");
  }
  const auto first = static_cast<int>(found[0]);
  struct {
    Status status;
    char text[text_size];
  } said{status, {}};
  std::snprintf(said.text, text_size, "rank %d: %s", rank_, text);
  take_from(first, &said, sizeof said);
  if (first == rank_) return;
  if (said.status == Status::cancelled) throw OnAll<Cancelled>();
  throw OnAll<Error>(said.status, said.text);
}

void Ranks::agree(std::int64_t count) const {
  tell(Status::ok, "", count);
}

void Ranks::disagree() const {
  try {
    throw;
  } catch (const Cancelled&) {
    tell(Status::cancelled, "", 0);
  } catch (...) {
    tell_exception([&](Status status, const char* text) { tell(status, text, 0); });
  }
}

void Ranks::give(void* rows, std::int64_t count, std::int64_t bytes, std::int64_t stride,
                 std::vector<std::uint8_t>& known) const {
  if (size_ == 1) return;
  auto* const row = static_cast<std::uint8_t*>(rows);
  std::vector<std::uint8_t> joined(at(count * (bytes + 1)), 0);  // rows, and whether they are known
  agree(std::ssize(joined));
  for (std::int64_t i = 0; i < count; ++i)
    if (known[at(i)]) std::copy_n(row + i * stride, bytes, joined.data() + i * bytes);
  std::copy(known.begin(), known.end(), joined.end() - count);
  join(joined.data(), std::ssize(joined));
  std::copy(joined.end() - count, joined.end(), known.begin());
  for (std::int64_t i = 0; i < count; ++i)
    if (known[at(i)]) std::copy_n(joined.data() + i * bytes, bytes, row + i * stride);
}

}  // namespace rollcon
