#include "linalg/row_basis.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon {

// Gram and Schmidt's method with pivots, each new row twice.
RowBasis row_basis(RowMatrix<double> matrix, double rest) {
  const std::int64_t rows = matrix.rows(), columns = matrix.columns();
  std::vector<double> basis, product;  // product: by row of the basis, then of the matrix
  std::vector<double> size_of;
  for (std::int64_t i = 0; i < rows; ++i) size_of.push_back(norm2(matrix.row(i), columns));
  std::int64_t count = 0;
  for (; count < std::min(rows, columns); ++count) {
    const std::int64_t longest = std::max_element(size_of.begin(), size_of.end()) - size_of.begin();
    if (!(size_of[static_cast<std::size_t>(longest)] > rest)) break;
    std::vector<double> next(matrix.row(longest), matrix.row(longest) + columns);
    for (std::int64_t k = 0; k < count; ++k)
      axpy(-dot(basis.data() + k * columns, next.data(), columns), basis.data() + k * columns, next.data(), columns);
    const double size = norm2(next.data(), columns);
    for (double& v : next) v /= size;
    for (std::int64_t i = 0; i < rows; ++i) {
      product.push_back(dot(matrix.row(i), next.data(), columns));
      axpy(-product.back(), next.data(), matrix.row(i), columns);
      size_of[static_cast<std::size_t>(i)] = norm2(matrix.row(i), columns);
    }
    basis.insert(basis.end(), next.begin(), next.end());
  }
  RowBasis found;
  found.row.resize(count, columns);
  found.weight.resize(rows, count);
  std::copy(basis.begin(), basis.end(), found.row.data());
  for (std::int64_t k = 0; k < count; ++k)
    for (std::int64_t i = 0; i < rows; ++i) found.weight.row(i)[k] = product[static_cast<std::size_t>(k * rows + i)];
  return found;
}

}  // namespace rollcon
