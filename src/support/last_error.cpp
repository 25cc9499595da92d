#include "support/last_error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace rollcon {

namespace {

// Not a std::string: that would need memory when there is none, and its destructor, which runs when the thread ends,
// would keep a host from unloading the library before.
constexpr std::size_t room = 2048;
thread_local char text[room] = "";

}  // namespace

const char* last_error() noexcept {
  return text;
}

void set_last_error(const char* function, const char* message) noexcept {
  std::size_t length = 0;
  const auto add = [&](const char* part) {
    const std::size_t n = std::min(std::strlen(part), room - 1 - length);
    std::memmove(text + length, part, n);  // the message may be this very text
    length += n;
  };
  if (function) {
    add(function);
    add(": ");
  }
  add(message);
  text[length] = '\0';
}

}  // namespace rollcon
