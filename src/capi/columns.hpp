#pragma once
/// Reads which columns of a table of results a caller wants.

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "support/input_checks.hpp"

namespace rollcon::capi {

/// Calls f(word, length) for each of the words between blanks.
template <class F>
void each_word(const char* text, F&& f) {
  while (text && *text) {
    const std::size_t blanks = std::strspn(text, " "), length = std::strcspn(text + blanks, " ");
    if (length > 0) f(text + blanks, length);
    text += blanks + length;
  }
}

/// Returns the places of the wanted names among those known, in the order asked for; `unknown` for others.
inline std::vector<std::size_t> read_names(const char* names, const char* argument, std::span<const char* const> known,
                                           Status unknown = Status::err_option) {
  require_pointer(names, argument);
  std::vector<std::size_t> wanted;
  each_word(names, [&](const char* word, std::size_t length) {
    const auto at = std::find_if(known.begin(), known.end(), [&](const char* name) {
      return std::strlen(name) == length && std::memcmp(name, word, length) == 0;
    });
    if (at == known.end()) {
      std::string allowed;
      for (const char* name : known) allowed += (allowed.empty() ? "" : ", ") + std::string(name);
      fail(unknown, "%s has '%.*s'; allowed: %s", argument, static_cast<int>(std::min<std::size_t>(length, 60)), word,
           allowed.c_str());
    }
    wanted.push_back(static_cast<std::size_t>(at - known.begin()));
  });
  return wanted;
}

/// Copies the wanted numbers of a whole row; returns the place behind them.
inline double* copy_columns(const std::vector<std::size_t>& wanted, const double* row, double* to) {
  for (const std::size_t column : wanted) *to++ = row[column];
  return to;
}

}  // namespace rollcon::capi
