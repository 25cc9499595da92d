#pragma once
/// Reads the numbers of a Gmsh file, written as text or in binary, one after the other.

#include <cstdint>
#include <string>
#include <string_view>

namespace rollcon {

class GmshNumbers {
 public:
  explicit GmshNumbers(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {}

  void use_binary() { binary_ = true; }
  bool binary() const { return binary_; }
  std::int64_t at() const { return static_cast<std::int64_t>(position_); }
  std::int64_t bytes() const { return static_cast<std::int64_t>(text_.size()); }

  /// Returns the next word, in text whatever the mode; it is empty at the end.
  std::string_view word();
  std::string_view rest_of_line();
  /// Skips the end of a line before binary numbers.
  void end_line();
  /// Moves behind the line "$End" + name; fails if there is none.
  void skip_section(std::string_view name);

  std::int32_t int4();   ///< Gmsh's int
  std::int64_t size8();  ///< Gmsh's size_t
  double real();
  /// Returns n, the number of things of which each takes at least this many numbers; fails if the file cannot hold
  /// them.
  std::int64_t count(std::int64_t n, std::int64_t numbers, const char* what) const;

  /// Throws err_io: "PATH, line N: ..." or "PATH, byte N: ...".
  [[noreturn]] void fail_at(std::int64_t at, const std::string& what) const;
  [[noreturn]] void fail_here(const std::string& what) const { fail_at(at(), what); }

 private:
  std::int64_t integer();
  template <class T>
  T raw();

  std::string path_, text_;
  std::size_t position_ = 0;
  bool binary_ = false;
};

}  // namespace rollcon
