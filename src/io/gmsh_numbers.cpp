#include "io/gmsh_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/profile_lines.hpp"
#include "support/error.hpp"

namespace rollcon {

namespace {

constexpr std::string_view blanks = " \t\r\n\f\v";

}  // namespace

std::string_view GmshNumbers::word() {
  const std::string_view text = text_;
  const std::size_t from = std::min(text.find_first_not_of(blanks, position_), text.size());
  position_ = std::min(text.find_first_of(blanks, from), text.size());
  return text.substr(from, position_ - from);
}

std::string_view GmshNumbers::rest_of_line() {
  const std::string_view text = text_;
  const std::size_t from = position_, to = std::min(text.find('\n', from), text.size());
  position_ = to;
  return text.substr(from, to - from);
}

void GmshNumbers::end_line() {
  if (position_ < text_.size() && text_[position_] == '\r') ++position_;
  if (position_ >= text_.size() || text_[position_] != '\n') fail_here("the end of a line is missing");
  ++position_;
}

void GmshNumbers::skip_section(std::string_view name) {
  std::string end = "$End";
  end += name;
  for (std::size_t from = position_; (from = text_.find(end, from)) != std::string::npos; ++from) {
    const std::size_t after = from + end.size();
    if (after < text_.size() && blanks.find(text_[after]) == std::string_view::npos) continue;
    position_ = after;
    return;
  }
  fail_here("'" + end.substr(0, 40) + "' is missing: truncated");
}

template <class T>
T GmshNumbers::raw() {
  T value;
  if (text_.size() - position_ < sizeof value) fail_here("the file ends: truncated");
  std::memcpy(&value, text_.data() + position_, sizeof value);
  position_ += sizeof value;
  return value;
}

std::int64_t GmshNumbers::integer() {
  const std::string_view text = word();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty()) fail_here("the file ends: truncated");
  if (error != std::errc() || end != text.data() + text.size()) fail_here("'" + printable(text) + "' is no integer");
  return value;
}

std::int32_t GmshNumbers::int4() {
  if (binary_) return raw<std::int32_t>();
  const std::int64_t value = integer();
  if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
    fail_here(std::to_string(value) + " is out of the range of an int");
  return static_cast<std::int32_t>(value);
}

std::int64_t GmshNumbers::size8() {
  return binary_ ? raw<std::int64_t>() : integer();
}

double GmshNumbers::real() {
  if (binary_) return raw<double>();
  const std::string_view text = word();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty()) fail_here("the file ends: truncated");
  // A coordinate that is next to 0 may be written with more digits than a double has.
  if ((error != std::errc() && !(error == std::errc::result_out_of_range && text.find("e-") != text.npos)) ||
      end != text.data() + text.size())
    fail_here("'" + printable(text) + "' is no number");
  return value;
}

std::int64_t GmshNumbers::count(std::int64_t n, std::int64_t numbers, const char* what) const {
  constexpr std::int64_t least_text = 2, least_binary = 4;  // bytes of a number
  const std::int64_t room = (bytes() - at()) / (numbers * (binary_ ? least_binary : least_text)) + 1;
  if (n < 0 || n > room)
    fail_here("the number of " + std::string(what) + " is " + std::to_string(n) + "; the file has room for " +
              std::to_string(room) + " at most");
  return n;
}

void GmshNumbers::fail_at(std::int64_t at, const std::string& what) const {
  const std::size_t to = std::min(static_cast<std::size_t>(std::max<std::int64_t>(at, 0)), text_.size());
  // The place behind a word is still on its line.
  const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(to), '\n');
  fail(Status::err_io, "%s, %s %lld: %s", path_.c_str(), binary_ ? "byte" : "line",
       binary_ ? static_cast<long long>(at) : static_cast<long long>(line), what.c_str());
}

}  // namespace rollcon
