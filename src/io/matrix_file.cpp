#include "io/matrix_file.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "io/load_file.hpp"
#include "io/profile_lines.hpp"
#include "io/whole_file.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 34U;
constexpr std::int64_t most_number = std::int64_t{1} << 53U;

class MatrixReader {
 public:
  MatrixReader(const std::string& path, std::int64_t rows) : lines_(path, most_bytes), rows_(rows) {}

  MatrixFile read() {
    std::string_view line;
    if (!lines_.next(line)) lines_.fail_whole("it is empty");
    if (in_lower_case(line).starts_with("%%matrixmarket"))
      read_market(in_lower_case(line));
    else
      read_substructure(line);
    return std::move(file_);
  }

 private:
  bool next(std::string_view& line, char comment) {
    while (lines_.next(line)) {
      line = trimmed(line);
      if (!line.empty() && line.front() != comment) return true;
    }
    return false;
  }

  std::int64_t whole(double value, std::int64_t most) const {
    if (!(value >= 1 && value <= static_cast<double>(most) && value == std::floor(value)))
      lines_.fail_here("an index is not a whole number from 1 to " + std::to_string(most));
    return static_cast<std::int64_t>(value);
  }

  void require_rows(double found) {
    char text[120];
    std::snprintf(text, sizeof text, "a matrix of %.0f rows; needed: %lld, three for each node of the body", found,
                  static_cast<long long>(rows_));
    if (found != static_cast<double>(rows_)) lines_.fail_here(text);
    file_.value.resize(rows_, rows_);
  }

  void read_market(const std::string& head) {
    const bool coordinate = head.find("coordinate") != head.npos, symmetric = head.find("symmetric") != head.npos;
    if (head.find("matrix", 14) == head.npos || head.find("complex") != head.npos ||
        head.find("pattern") != head.npos || head.find("skew") != head.npos || head.find("hermitian") != head.npos)
      lines_.fail_here("allowed: matrix array or coordinate, real or integer, general or symmetric");
    std::string_view line;
    const bool sized = next(line, '%');
    const std::vector<double> size = sized ? lines_.numbers_in(line) : std::vector<double>{};
    if (size.size() != (coordinate ? 3U : 2U)) lines_.fail_here("the matrix has no size");
    if (size[0] != size[1]) lines_.fail_here("the matrix is not square");
    require_rows(size[0]);
    const double n = size[0];
    if (coordinate && !(size[2] >= 0 && size[2] <= n * n))
      lines_.fail_here("more entries than the matrix has room for");
    std::int64_t left = static_cast<std::int64_t>(coordinate ? size[2] : symmetric ? n * (n + 1) / 2 : n * n);
    for (std::int64_t column = 0, row = 0; left > 0; --left) {
      double v = 0;
      if (coordinate) {
        const std::vector<double> entry = next(line, '%') ? lines_.numbers_in(line) : std::vector<double>{};
        if (entry.size() != 3) lines_.fail_here("an entry is not a row, a column and a number");
        row = whole(entry[0], rows_) - 1, column = whole(entry[1], rows_) - 1, v = entry[2];
      } else {
        v = number('%');
      }
      file_.value.row(row)[column] = v;
      if (symmetric) file_.value.row(column)[row] = v;
      if (!coordinate && ++row == rows_) row = symmetric ? ++column : (++column, 0);
    }
  }

  /// Returns the next number of a list that goes on over lines.
  double number(char comment) {
    while (place_ == list_.size()) {
      std::string_view line;
      if (!next(line, comment)) lines_.fail_here("the matrix ends early");
      if (line.front() == '*') lines_.fail_here("the matrix ends early");
      list_ = lines_.numbers_in(line);
      place_ = 0;
    }
    return list_[place_++];
  }

  // Comments name the node of each position, data lines the position from which components are other ones; the first
  // line begins at position 1 without saying so.
  void read_substructure(std::string_view line) {
    std::vector<std::int64_t> position;
    std::vector<std::vector<std::int32_t>> component;
    bool nodes = false, element = false;
    do {
      line = trimmed(line);
      const std::string lower = in_lower_case(line);
      if (lower.starts_with("*matrix")) break;
      if (lower.starts_with("**")) {
        const std::string_view rest = trimmed(line.substr(2));
        if (lower.find("element nodes") != lower.npos) nodes = true;
        if (nodes && !rest.empty() && rest.front() >= '0' && rest.front() <= '9')
          for (const double node : lines_.numbers_in(rest)) position.push_back(whole(node, most_number));
      } else if (lower.starts_with("*")) {
        element = lower.starts_with("*user element");
      } else if (element && !line.empty()) {
        const std::vector<double> list = lines_.numbers_in(line);
        const std::size_t first = component.empty() ? 0 : 1;
        const auto from = first == 0 ? 0 : whole(list[0], std::ssize(position)) - 1;
        if (component.empty()) component.resize(position.size());
        for (std::size_t k = at(from); k < component.size(); ++k) component[k].clear();
        for (std::size_t k = at(from); k < component.size(); ++k)
          for (std::size_t i = first; i < list.size(); ++i)
            component[k].push_back(static_cast<std::int32_t>(whole(list[i], 3)) - 1);
      }
    } while (lines_.next(line));
    if (position.empty() || component.empty())
      lines_.fail_here("neither a MatrixMarket file nor a substructure: no *USER ELEMENT with ELEMENT NODES");
    if (in_lower_case(line).find("stiffness") == std::string::npos) lines_.fail_here("no *MATRIX, TYPE=STIFFNESS");
    for (std::size_t k = 0; k < position.size(); ++k)
      for (const std::int32_t c : component[k]) file_.node.push_back(position[k]), file_.component.push_back(c);
    require_rows(static_cast<double>(file_.node.size()));
    std::int64_t zeros = 0;
    for (std::int64_t i = 0; i < rows_; ++i)
      for (std::int64_t j = 0; j <= i; ++j) {
        file_.value.row(i)[j] = file_.value.row(j)[i] = number('\0');
        zeros += file_.value.row(i)[j] == 0 ? 1 : 0;
      }
    if (zeros > rows_ * rows_ / 4)
      lines_.fail_here(
          "most entries are exactly zero: nothing was condensed, the other nodes of the model were held (CalculiX 2.20 "
          "does that); condense its stiffness otherwise, as docs/howto/calculix.md shows");
  }

  TextLines lines_;
  std::int64_t rows_;
  MatrixFile file_;
  std::vector<double> list_;
  std::size_t place_ = 0;
};

}  // namespace

MatrixFile read_matrix_file(const std::string& path, std::int64_t rows) {
  return MatrixReader(path, rows).read();
}

void write_matrix_file(const std::string& path, const RowMatrix<double>& matrix, const std::string& title) {
  std::string text = "%%MatrixMarket matrix array real symmetric\n";
  text.append(commented(title, "% ")).append(std::to_string(matrix.rows())).append(" ");
  text.append(std::to_string(matrix.rows())).append("\n");
  char digits[40];
  for (std::int64_t column = 0; column < matrix.rows(); ++column)
    for (std::int64_t row = column; row < matrix.rows(); ++row) {
      text.append(digits, std::to_chars(digits, digits + sizeof digits, matrix.row(row)[column]).ptr);
      text += '\n';
    }
  write_whole_file(path, text);
}

}  // namespace rollcon
