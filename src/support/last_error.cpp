#include "support/last_error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace rollcon {

namespace {

/// Holds text in an array, not a std::string: that would need memory when there is none, and its destructor, which runs
/// when the thread ends, would keep a host from unloading the library before.
template <std::size_t room>
struct Text {
  char text[room];

  /// Joins the parts; those that are null are left out. One may be this very text.
  void set(std::initializer_list<const char*> parts) noexcept {
    std::size_t length = 0;
    for (const char* part : parts) {
      if (!part) continue;
      const std::size_t n = std::min(std::strlen(part), room - 1 - length);
      std::memmove(text + length, part, n);
      length += n;
    }
    text[length] = '\0';
  }
};

thread_local Text<2048> error{""};
thread_local Text<1024> caveat{""};
thread_local Text<768> note{""};
thread_local Status noted = Status::ok;

}  // namespace

const char* last_error() noexcept {
  return error.text;
}

void set_last_error(const char* function, const char* message) noexcept {
  error.set({function, function ? ": " : nullptr, message});
}

const char* last_caveat() noexcept {
  return caveat.text;
}

void note_caveat(Status status, const char* detail) noexcept {
  noted = status;
  note.set({detail});
}

void forget_caveat_note() noexcept {
  noted = Status::ok;
}

void set_last_caveat(const char* function, Status status, const char* general) noexcept {
  const bool more = noted == status;
  caveat.set({function, ": ", general, more ? "; " : nullptr, more ? note.text : nullptr});
}

}  // namespace rollcon
