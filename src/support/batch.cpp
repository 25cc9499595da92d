#include "support/batch.hpp"

#include <algorithm>
#include <new>

namespace rollcon {

void Batch::keep_failure(std::int64_t i) {
  try {
    tell_exception([&](Status status, const char* text) {
      status_[at(i)] = status;
      const std::lock_guard lock(mutex_);
      failures_.emplace_back(i, text);
    });
  } catch (const std::bad_alloc&) {
    // Storing the text failed; the status alone tells.
  }
}

void Batch::give(double* row, std::int64_t width, std::int64_t stride) {
  constexpr auto number = static_cast<std::int64_t>(sizeof(double)), word = static_cast<std::int64_t>(sizeof(Status));
  std::vector<std::uint8_t> known = taken_;
  context_.ranks().give(status_.data(), std::ssize(status_), word, word, known);
  if (width > 0) context_.ranks().give(row, std::ssize(status_), width * number, stride * number, known = taken_);
}

Status Batch::finish(const char* what, std::int32_t* status) {
  std::sort(failures_.begin(), failures_.end());
  for (const auto& [i, text] : failures_)
    context_.log(LogLevel::warning, "%s %lld (counting from 0): %s", what, static_cast<long long>(i), text.c_str());
  Status worst = Status::ok;
  for (const Status s : status_) {
    worst = worse(worst, s);
    if (status) *status++ = static_cast<std::int32_t>(s);
  }
  return worst;
}

}  // namespace rollcon
