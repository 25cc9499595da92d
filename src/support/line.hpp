#pragma once
/// Formats a line of text without memory of its own, because solves that must not allocate make some.

#include <cstdio>
#include <cstring>
#include <string>

namespace rollcon {

struct Line {
  char text[512] = "";

  const char* c_str() const { return text; }
  std::string str() const { return text; }
};

/// Formats as printf does; a line that is too long ends with three dots.
template <class... Args>
Line line_of(const char* format, Args... args) {
  Line line;
  if (std::snprintf(line.text, sizeof line.text, format, args...) >= static_cast<int>(sizeof line.text))
    std::memcpy(line.text + sizeof line.text - 4, "...", 4);
  return line;
}

}  // namespace rollcon
