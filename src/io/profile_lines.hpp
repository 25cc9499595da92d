#pragma once
/// Reads lines of text files of numbers.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rollcon {

std::string_view trimmed(std::string_view text);
std::string in_lower_case(std::string_view text);
/// Returns the start of the text for messages, with ? for what cannot be printed.
std::string printable(std::string_view text);

/// Holds a text file in memory, gives it line by line, and names the line in errors. All failures are err_io.
class TextLines {
 public:
  /// Takes the bytes that the file may have as `most`.
  explicit TextLines(const std::string& path, std::uintmax_t most = std::uintmax_t{1} << 28U);

  /// Gives the next line without its end; returns false after the last one.
  bool next(std::string_view& line);
  std::int64_t number() const { return number_; }  ///< number of that line, from 1
  std::int64_t bytes() const { return static_cast<std::int64_t>(text_.size()); }
  /// Throws "PATH, line N: ...".
  [[noreturn]] void fail_here(const std::string& what) const;
  [[noreturn]] void fail_at(std::int64_t line, const std::string& what) const;
  [[noreturn]] void fail_whole(const std::string& what) const;
  /// Returns the finite number that is all of the text; fails naming it.
  double number_in(std::string_view text) const;
  /// Returns the numbers of a line, apart by blanks, tabs, semicolons or commas that are not decimal ones.
  std::vector<double> numbers_in(std::string_view line) const;

 private:
  std::string path_, text_;
  std::size_t position_ = 0;
  std::int64_t number_ = 0;
};

}  // namespace rollcon
