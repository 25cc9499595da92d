#pragma once
/// Dense row-major storage and the products that the contact solver needs.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rollcon {

/// Row-major matrix that keeps its storage when it is resized to something smaller.
template <class T>
class RowMatrix {
 public:
  void resize(std::int64_t rows, std::int64_t columns) {
    const auto needed = static_cast<std::size_t>(rows * columns);
    if (data_.size() < needed) data_.resize(needed);
    rows_ = rows;  // not before there is room
    columns_ = columns;
  }
  void release() { std::vector<T>().swap(data_), rows_ = columns_ = 0; }
  /// Makes room for later growth, so that a resize up to this size does not allocate.
  void reserve(std::int64_t rows, std::int64_t columns) {
    const auto needed = static_cast<std::size_t>(rows * columns);
    if (data_.size() < needed) data_.resize(needed);
  }
  std::int64_t rows() const { return rows_; }
  std::int64_t columns() const { return columns_; }
  bool empty() const { return rows_ == 0; }
  T* row(std::int64_t i) { return data_.data() + static_cast<std::size_t>(i * columns_); }
  const T* row(std::int64_t i) const {
    return data_.data() + static_cast<std::size_t>(i * columns_);
  }
  T* data() { return data_.data(); }
  const T* data() const { return data_.data(); }
  std::size_t bytes() const { return data_.capacity() * sizeof(T); }

 private:
  std::int64_t rows_ = 0, columns_ = 0;
  std::vector<T> data_;
};

/// y = beta y + a x for a row-major a (rows by columns).
void multiply(const double* a, std::int64_t rows, std::int64_t columns, const double* x,
              double beta, double* y);
double dot(const double* x, const double* y, std::int64_t n);
/// y += alpha x
void axpy(double alpha, const double* x, double* y, std::int64_t n);
double norm2(const double* x, std::int64_t n);

}  // namespace rollcon
