#include "support/ranks.hpp"

#include <algorithm>
#include <cstdio>

#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

constexpr std::size_t text_size = 1024;

const Ranks alone;
thread_local const Ranks* shared_among = &alone;

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
  if (said.status == Status::cancelled) throw OnAll<Cancelled>();
  throw OnAll<Error>(said.status, first == rank_ ? text : said.text);
}

void Ranks::agree(std::int64_t count) const {
  if (size_ > 1) tell(Status::ok, "", count);
}

std::int64_t Ranks::least(std::int64_t value) const {
  if (size_ > 1) least(&value, 1);
  return value;
}

void Ranks::take_from_first(void* bytes, std::int64_t n) const {
  constexpr std::int64_t most = 1 << 28;
  auto* const part = static_cast<std::uint8_t*>(bytes);
  for (std::int64_t first = 0; first < n && size_ > 1; first += most)
    take_from(0, part + first, static_cast<int>(std::min(most, n - first)));
}

void Ranks::disagree() const {
  try {
    throw;
  } catch (const Cancelled&) {
    tell(Status::cancelled, "", 0);
  } catch (...) {
    tell_exception([&](Status status, const char* text) { tell(status, text, 0); });
  }
  fail(Status::err_internal, "internal error: the failure of a rank did not reach the others");
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

SharedWork::SharedWork(const Ranks& ranks) : former_(shared_among) {
  shared_among = &ranks;
}

SharedWork::~SharedWork() {
  shared_among = former_;
}

const Ranks& SharedWork::ranks() {
  return *shared_among;
}

}  // namespace rollcon
