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

Status Batch::finish(const Context& context, const char* what, std::int32_t* status) {
  std::sort(failures_.begin(), failures_.end());
  for (const auto& [i, text] : failures_)
    context.log(LogLevel::warning, "%s %lld (counting from 0): %s", what, static_cast<long long>(i), text.c_str());
  Status worst = Status::ok;
  for (const Status s : status_) {
    worst = worse(worst, s);
    if (status) *status++ = static_cast<std::int32_t>(s);
  }
  return worst;
}

}  // namespace rollcon
