#pragma once
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

namespace cntc {

/// Says what is wrong in an input file, and on which line.
struct InpError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads words of an input file of CONTACT. A group of values may span lines; the rest of its last line is ignored.
class InpReader {
 public:
  /// Reads a file as a whole; throws InpError where that cannot be done.
  explicit InpReader(const std::string& path);

  /// Names a digit of a control word, and the values that it may have.
  struct Digit {
    const char *name, *allowed;
  };
  /// Reads a control word; leading zeros may be missing. A digit in the next word goes to *extra.
  std::vector<int> control(std::initializer_list<Digit> digits, int* extra = nullptr);
  std::vector<double> reals(int n, const char* what);
  /// Reads n values, and up to `more` further ones on the line of the last.
  std::vector<double> reals(int n, int more, const char* what);
  int integer(const char* what);
  /// Reads a line that begins with a text in quotes, and the numbers that follow the text.
  std::string text(std::vector<double>& numbers, const char* what);
  bool at_end();

  [[noreturn]] void fail(const std::string& text) const;

 private:
  struct Word {
    std::string text;
    bool quoted = false;
  };
  bool next_line();
  static bool number(const Word& word, double& value);

  std::string path_;
  std::vector<std::string> lines_;
  size_t line_ = 0;
  std::vector<Word> words_;
};

}  // namespace cntc
