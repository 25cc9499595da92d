/// Writes a finite-element body's equations to a file, and reads them. The stiffness matrix is not written: it is
/// assembled again, and counted, should a frame need more than what is condensed.

#include <utility>

#include "bodies/fem/system.hpp"
#include "bodies/model/archive.hpp"
#include "linalg/condensed_factor.hpp"
#include "support/index.hpp"

namespace rollcon::fem {
namespace {

// Tells in a file that the factors are the end of a Cholesky factor, the rest of which is zero.
constexpr std::int32_t cholesky = 1;

void write_triangle(const CondensedView& view, SectionWriter& file) {
  for (std::int64_t j = 0; j < view.unknowns; ++j)
    file.write(view.matrix + j * view.unknowns + j, at(view.unknowns - j) * sizeof(double));
}

std::unique_ptr<double[]> read_triangle(std::int64_t n, SectionReader& file) {
  auto matrix = std::make_unique<double[]>(at(n * n));
  for (std::int64_t j = 0; j < n; ++j) file.read(matrix.get() + j * n + j, at(n - j) * sizeof(double));
  return matrix;
}

}  // namespace

std::uint64_t System::numbering() const {
  Checksum sum;
  sum.add(unknowns_.of.data(), unknowns_.of.size() * sizeof unknowns_.of[0]);
  return sum.value();
}

void System::write_factors(SectionWriter& file) const {
  const CondensedView view = factor_->condensed();
  OutArchive ar(file);
  ar(cholesky);
  ar(condensed_);
  ar(std::vector<std::int64_t>(view.place.begin(), view.place.end()));
  write_triangle(view, file);
}

void System::read_factors(SectionReader& file) {
  InArchive ar(file);
  std::int32_t form = 0;
  std::vector<std::int64_t> condensed, place;
  ar(form);
  ar(condensed);
  ar(place);
  const std::uint64_t n = condensed.size();
  if (file.left() % sizeof(double) != 0 || file.left() / sizeof(double) != n * (n + 1) / 2)
    file.fail_here("the factors do not fit the unknowns");
  auto matrix = read_triangle(static_cast<std::int64_t>(n), file);
  bool good = form == cholesky && place.size() == condensed.size();
  for (std::size_t k = 0; k < condensed.size(); ++k)
    good = good && condensed[k] < unknowns_.count && condensed[k] > (k > 0 ? condensed[k - 1] : std::int64_t{-1});
  std::vector<std::uint8_t> taken(condensed.size(), 0);
  for (const std::int64_t row : place) {
    good = good && row >= 0 && at(row) < taken.size() && taken[at(row)] == 0;
    if (good) taken[at(row)] = 1;
  }
  if (!good) file.fail_here("the factors are of other unknowns");
  SparseStatistics told;
  told.condition = statistics_.condition;
  told.nonzeros = statistics_.nonzeros;
  factor_ =
      make_condensed_factor(unknowns_.count, static_cast<std::int64_t>(n), std::move(place), std::move(matrix), told);
  statistics_.condensed = static_cast<std::int64_t>(n);
  place_condensed(std::move(condensed));
}

}  // namespace rollcon::fem
