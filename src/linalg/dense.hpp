#pragma once
/// Provides dense row-major storage and the products that the contact solver needs.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "support/memory_limit.hpp"

namespace rollcon {

/// Leaves entries that nobody gave a value as the memory has them: the system gives large blocks no memory before they
/// are written. The error for a block that cannot be allocated tells its size.
template <class T>
struct UntouchedAllocator : std::allocator<T> {
  T* allocate(std::size_t n) {
    try {
      return std::allocator<T>::allocate(n);
    } catch (const std::bad_alloc&) {
      refuse_more_memory(static_cast<double>(n) * sizeof(T), "take a coarser frame or mesh", "a matrix needs");
    }
  }
  template <class U>
  struct rebind {
    using other = UntouchedAllocator<U>;
  };
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Values>
  void construct(U* at, Values&&... values) {
    ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }
};

/// Holds a row-major matrix that keeps its storage when it is resized to something smaller.
template <class T>
class RowMatrix {
 public:
  void resize(std::int64_t rows, std::int64_t columns) {
    const auto needed = static_cast<std::size_t>(rows * columns);
    if (data_.size() < needed) data_.resize(needed, T{});
    rows_ = rows;  // only once there is room
    columns_ = columns;
  }
  /// Resizes an empty matrix of which only some rows will be written.
  void resize_untouched(std::int64_t rows, std::int64_t columns) {
    data_.resize(static_cast<std::size_t>(rows * columns));
    rows_ = rows;
    columns_ = columns;
  }
  void release() { Data().swap(data_), rows_ = columns_ = 0; }
  /// Makes room for later growth, so that a resize up to this size does not allocate.
  void reserve(std::int64_t rows, std::int64_t columns) {
    const auto needed = static_cast<std::size_t>(rows * columns);
    if (data_.size() < needed) data_.resize(needed, T{});
  }
  std::int64_t rows() const { return rows_; }
  std::int64_t columns() const { return columns_; }
  bool empty() const { return rows_ == 0; }
  T* row(std::int64_t i) { return data() + static_cast<std::size_t>(i * columns_); }
  const T* row(std::int64_t i) const { return data() + static_cast<std::size_t>(i * columns_); }
  T* data() { return data_.data(); }
  const T* data() const { return data_.data(); }
  std::size_t bytes() const { return data_.capacity() * sizeof(T); }

 private:
  using Data = std::vector<T, UntouchedAllocator<T>>;
  std::int64_t rows_ = 0, columns_ = 0;
  Data data_;
};

/// Returns room for n unknowns and some more, because the systems of a time loop grow and shrink. Small ones get so
/// much that they hardly ever grow beyond it; large ones are dear.
template <class Integer>
constexpr Integer with_room(Integer n) {
  return n < 1000 ? n + n / 3 : n + n / 10;
}

/// Computes y = beta y + a x for a row-major a (rows by columns).
void multiply(const double* a, std::int64_t rows, std::int64_t columns, const double* x, double beta, double* y);
/// Computes c += a b.
void add_product(const RowMatrix<double>& a, const RowMatrix<double>& b, RowMatrix<double>& c);
double dot(const double* x, const double* y, std::int64_t n);
/// Computes y += alpha x.
void axpy(double alpha, const double* x, double* y, std::int64_t n);
double norm2(const double* x, std::int64_t n);

}  // namespace rollcon
