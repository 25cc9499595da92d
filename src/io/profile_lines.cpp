#include "io/profile_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/whole_file.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Says whether commas are decimal: something else is between the numbers then, there is no point, and each comma has
/// digits on both sides.
bool has_decimal_commas(std::string_view line) {
  const auto digit = [&](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  std::size_t comma = line.find(',');
  if (comma == line.npos || line.find('.') != line.npos || line.find_first_of(" \t;") == line.npos) return false;
  for (; comma != line.npos; comma = line.find(',', comma + 1))
    if (comma == 0 || !digit(comma - 1) || !digit(comma + 1)) return false;
  return true;
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string s;
  for (const char c : text.substr(0, most)) s += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > most ? s + "..." : s;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_lower_case(std::string_view text) {
  std::string s(text);
  std::transform(s.begin(), s.end(), s.begin(), lower);
  return s;
}

TextLines::TextLines(const std::string& path, std::uintmax_t most) : path_(path), text_(whole_file(path, most)) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;  // byte-order mark of UTF-8
}

bool TextLines::next(std::string_view& line) {
  if (position_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  line = std::string_view(text_).substr(position_, end - position_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  position_ = end + 1;
  ++number_;
  return true;
}

void TextLines::fail_here(const std::string& what) const {
  fail_at(number_, what);
}

void TextLines::fail_at(std::int64_t line, const std::string& what) const {
  fail(Status::err_io, "%s, line %lld: %s", path_.c_str(), static_cast<long long>(line), what.c_str());
}

void TextLines::fail_whole(const std::string& what) const {
  fail(Status::err_io, "%s: %s", path_.c_str(), what.c_str());
}

double TextLines::number_in(std::string_view text) const {
  text = trimmed(text);
  std::string digits(text.starts_with('+') ? text.substr(1) : text);
  for (char& c : digits)  // Fortran's exponents
    if (c == 'd' || c == 'D') c = 'e';
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    std::string what = "'";
    fail_here(what.append(printable(text)).append("' is no number"));
  }
  return value;
}

std::vector<double> TextLines::numbers_in(std::string_view line) const {
  constexpr std::string_view between = " \t\r\f\v,;";
  std::vector<double> found;
  std::string pointed;
  if (has_decimal_commas(line)) {
    pointed = line;
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    line = pointed;
  }
  for (std::size_t from = line.find_first_not_of(between); from != std::string_view::npos;) {
    const std::size_t to = std::min(line.find_first_of(between, from), line.size());
    found.push_back(number_in(line.substr(from, to - from)));
    from = line.find_first_not_of(between, to);
  }
  return found;
}

}  // namespace rollcon
