#include "inp_reader.hpp"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "log.hpp"

namespace cntc {
namespace {

constexpr size_t most_bytes = 256u << 20;

bool separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '=' || c == '\r';
}

}  // namespace

InpReader::InpReader(const std::string& path) : path_(path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InpError(path + " cannot be read");
  std::string line;
  size_t bytes = 0;
  while (std::getline(file, line)) {
    bytes += line.size() + 1;
    if (bytes > most_bytes) throw InpError(path + " is longer than 256 MB");
    lines_.push_back(std::move(line));
  }
  if (file.bad()) throw InpError(path + " cannot be read");
}

void InpReader::fail(const std::string& text) const {
  throw InpError(print("%s, line %zu: %s", path_.c_str(), line_, text.c_str()));
}

/// Goes to the next line that has words; comments begin with a per cent sign outside of quotes.
bool InpReader::next_line() {
  words_.clear();
  while (line_ < lines_.size()) {
    const std::string& text = lines_[line_++];
    Word word;
    bool inside = false;
    for (const char c : text) {
      if (inside) {
        if (c == '\'') {
          inside = false;
          words_.push_back(word);
          word = {};
        } else {
          word.text += c;
        }
      } else if (c == '%') {
        break;
      } else if (c == '\'') {
        inside = true;
        word = {"", true};
      } else if (separator(c)) {
        if (!word.text.empty()) words_.push_back(word);
        word = {};
      } else {
        word.text += c;
      }
    }
    if (inside) fail("a quote is not closed");
    if (!word.text.empty()) words_.push_back(word);
    if (!words_.empty()) return true;
  }
  return false;
}

bool InpReader::at_end() {
  const size_t line = line_;
  const bool more = next_line();
  line_ = line;
  return !more;
}

/// Takes numbers in any form, with Fortran's exponents; d and r at the end are degrees and radians, T and F 1 and 0.
bool InpReader::number(const Word& word, double& value) {
  if (word.quoted || word.text.empty() || word.text.size() > 100) return false;
  std::string text = word.text;
  if (text == "T" || text == "F") {
    value = text == "T";
    return true;
  }
  double factor = 1;
  if (text.size() > 1) {
    const char last = char(std::tolower(static_cast<unsigned char>(text.back())));
    if (last == 'd') factor = 3.141592653589793 / 180;
    if (last == 'd' || last == 'r') text.pop_back();
  }
  for (char& c : text) {
    if (c == 'd' || c == 'D') c = 'e';
    if (!std::isdigit(static_cast<unsigned char>(c)) && c != '.' && c != '-' && c != '+' && c != 'e' && c != 'E')
      return false;
  }
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end) * factor;
  return *end == 0 && end != text.c_str() && std::isfinite(value);
}

std::vector<int> InpReader::control(std::initializer_list<Digit> digits, int* extra) {
  std::string names;
  for (const Digit& d : digits) names += (names.empty() ? "" : "-") + std::string(d.name);
  if (!next_line()) fail(print("the file ends before %s", names.c_str()));
  const std::string& word = words_[0].text;
  const size_t width = digits.size();
  if (word.size() > width) fail(print("%s has more than %zu digits: %.40s", names.c_str(), width, word.c_str()));
  std::vector<int> values;
  for (const Digit& d : digits) {
    const size_t at = values.size() + word.size();
    const char digit = at < width ? '0' : word[at - width];
    if (!std::isdigit(static_cast<unsigned char>(digit)))
      fail(print("%s: digits are expected, not %.40s", names.c_str(), word.c_str()));
    if (!std::strchr(d.allowed, digit)) {
      std::string allowed;
      for (const char* c = d.allowed; *c; ++c) allowed += (c == d.allowed ? "" : ", ") + std::string(1, *c);
      fail(print("%s is %c; allowed: %s", d.name, digit, allowed.c_str()));
    }
    values.push_back(digit - '0');
  }
  double more = 0;
  if (extra && words_.size() > 1 && number(words_[1], more) && more >= 0 && more <= 9) *extra = int(more);
  return values;
}

std::vector<double> InpReader::reals(int n, const char* what) {
  return reals(n, 0, what);
}

std::vector<double> InpReader::reals(int n, int more, const char* what) {
  std::vector<double> values;
  while (int(values.size()) < n) {
    if (!next_line()) fail(print("the file ends before %s", what));
    for (const Word& word : words_) {
      if (int(values.size()) >= n + more) break;
      double value = 0;
      if (!number(word, value)) {
        if (int(values.size()) >= n) break;
        fail(print("%s: number %zu of %d is expected, not '%.40s'", what, values.size() + 1, n, word.text.c_str()));
      }
      values.push_back(value);
    }
  }
  return values;
}

int InpReader::integer(const char* what) {
  const double value = reals(1, what)[0];
  if (value != std::floor(value) || std::abs(value) > 1e9) fail(print("%s: a whole number is expected", what));
  return int(value);
}

std::string InpReader::text(std::vector<double>& numbers, const char* what) {
  if (!next_line()) fail(print("the file ends before %s", what));
  if (!words_[0].quoted) fail(print("%s: a name in quotes is expected, not '%.40s'", what, words_[0].text.c_str()));
  numbers.clear();
  for (size_t k = 1; k < words_.size(); ++k) {
    double value = 0;
    if (!number(words_[k], value)) break;
    numbers.push_back(value);
  }
  return words_[0].text;
}

}  // namespace cntc
