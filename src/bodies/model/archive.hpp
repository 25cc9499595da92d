#pragma once
/// Digests, writes and reads a thing by one description of what it consists of, a function `content(archive, thing)`.
/// Numbers are written as they are in memory.

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/section_file.hpp"
#include "linalg/dense.hpp"
#include "support/checksum.hpp"

namespace rollcon {

/// Tells which types are copied byte by byte: they have no padding and no pointers.
template <class T>
struct IsPlain : std::bool_constant<std::is_arithmetic_v<T> || std::is_enum_v<T>> {};
template <class T, std::size_t n>
struct IsPlain<std::array<T, n>> : IsPlain<T> {};

/// Writes to any Sink that has write(const void*, std::size_t).
template <class Sink>
class OutArchive {
 public:
  static constexpr bool reads = false;
  explicit OutArchive(Sink& sink) : sink_(sink) {}

  template <class T>
  requires IsPlain<T>::value void operator()(const T& value) { sink_.write(&value, sizeof value); }
  template <class T>
  requires IsPlain<T>::value void operator()(const std::vector<T>& values) {
    count(values.size());
    sink_.write(values.data(), values.size() * sizeof(T));
  }
  void operator()(const std::string& text) {
    count(text.size());
    sink_.write(text.data(), text.size());
  }
  void operator()(const RowMatrix<double>& matrix) {
    (*this)(matrix.rows());
    (*this)(matrix.columns());
    sink_.write(matrix.data(), static_cast<std::size_t>(matrix.rows() * matrix.columns()) * sizeof(double));
  }
  /// Calls each(archive, entry) for the entries of a vector.
  template <class T, class Each>
  void list(const std::vector<T>& values, std::size_t /*least_bytes*/, Each each) {
    count(values.size());
    for (const T& value : values) each(*this, value);
  }
  void count(std::uint64_t n) { (*this)(n); }

 private:
  Sink& sink_;
};

class InArchive {
 public:
  static constexpr bool reads = true;
  explicit InArchive(SectionReader& file) : file_(file) {}

  template <class T>
  requires IsPlain<T>::value void operator()(T& value) { file_.read(&value, sizeof value); }
  template <class T>
  requires IsPlain<T>::value void operator()(std::vector<T>& values) {
    const std::size_t n = count(sizeof(T));
    values.resize(n);
    file_.read(values.data(), n * sizeof(T));
  }
  void operator()(std::string& text) {
    text.resize(count(1));
    file_.read(text.data(), text.size());
  }
  void operator()(RowMatrix<double>& matrix) {
    std::int64_t rows = 0, columns = 0;
    (*this)(rows);
    (*this)(columns);
    const auto room = static_cast<std::int64_t>(file_.left() / sizeof(double));
    if (rows < 0 || columns < 0 || (columns > 0 && rows > room / columns))
      file_.fail_here("a matrix of " + std::to_string(rows) + " x " + std::to_string(columns) +
                      " does not fit into the section");
    matrix.resize(rows, columns);
    file_.read(matrix.data(), static_cast<std::size_t>(rows * columns) * sizeof(double));
  }
  template <class T, class Each>
  void list(std::vector<T>& values, std::size_t least_bytes, Each each) {
    values.resize(count(least_bytes));
    for (T& value : values) each(*this, value);
  }
  /// Reads the count of entries that take at least so many bytes each.
  std::size_t count(std::size_t least_bytes) {
    std::uint64_t n = 0;
    (*this)(n);
    if (n > file_.left() / least_bytes)
      file_.fail_here("a count of " + std::to_string(n) + " does not fit into the section");
    return static_cast<std::size_t>(n);
  }
  SectionReader& file() { return file_; }

 private:
  SectionReader& file_;
};

/// Computes two checksums of different seeds: 128 bits, so that equal ones mean equal content.
class Digest {
 public:
  void write(const void* data, std::size_t bytes) {
    low_.add(data, bytes);
    high_.add(data, bytes);
  }
  std::pair<std::uint64_t, std::uint64_t> value() const { return {low_.value(), high_.value()}; }

 private:
  Checksum low_{0}, high_{0x9e3779b97f4a7c15U};
};

}  // namespace rollcon
