#pragma once
/// A line of text that needs no memory: solves that must not allocate make some.

#include <cstdio>
#include <string>

namespace rollcon {

struct Line {
  char text[512] = "";

  const char* c_str() const { return text; }
  std::string str() const { return text; }
};

/// As printf; longer lines are cut.
template <class... Args>
Line line_of(const char* format, Args... args) {
  Line line;
  std::snprintf(line.text, sizeof line.text, format, args...);
  return line;
}

}  // namespace rollcon
