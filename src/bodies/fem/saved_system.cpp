/// A finite-element body's equations to and from a file. The stiffness matrix is not written: it is assembled again,
/// and counted, should a frame need more than what is condensed.

#include <utility>

#include "bodies/fem/system.hpp"
#include "bodies/model/archive.hpp"
#include "linalg/condensed_factor.hpp"
#include "support/index.hpp"

namespace rollcon::fem {
namespace {

// What the factors are: the end of a Cholesky factor. The rest of it is zero.
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

std::int64_t System::solvable() const {
  const std::lock_guard lock(mutex_);
  return factor_ ? static_cast<std::int64_t>(condensed_.size()) : 0;
}

void System::save(SectionWriter& file, const OwnLoads& own) const {
  const std::lock_guard lock(mutex_);
  OutArchive ar(file);
  file.begin("response");
  ar(factor_ ? static_cast<std::int64_t>(condensed_.size()) : std::int64_t{0});
  ar(numbering());
  ar(statistics_.condition);
  ar(statistics_.nonzeros);
  ar(own.displacement);
  ar(own.reaction.force);
  ar(own.reaction.moment);
  if (factor_) {
    const CondensedView view = factor_->condensed();
    file.begin("factors");
    ar(cholesky);
    ar(condensed_);
    ar(std::vector<std::int64_t>(view.place.begin(), view.place.end()));
    write_triangle(view, file);
  }
  save_kept(file);
}

void System::restore_factor(SectionReader& file) {
  InArchive ar(file);
  file.begin("factors");
  std::int32_t form = 0;
  std::vector<std::int64_t> condensed, place;
  ar(form);
  ar(condensed);
  ar(place);
  const std::uint64_t n = condensed.size();
  if (file.left() % sizeof(double) != 0 || file.left() / sizeof(double) != n * (n + 1) / 2)
    file.fail_here("the factors do not fit the unknowns");
  auto matrix = read_triangle(static_cast<std::int64_t>(n), file);
  file.end();
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

void System::restore(SectionReader& file) {
  InArchive ar(file);
  file.begin("response");
  std::int64_t solvable = 0;
  std::uint64_t numbers = 0;
  ar(solvable);
  ar(numbers);
  ar(statistics_.condition);
  ar(statistics_.nonzeros);
  ar(own_.displacement);
  ar(own_.reaction.force);
  ar(own_.reaction.moment);
  file.end();
  if (numbers != numbering())
    file.fail_here("this library numbers the unknowns of the body differently: save it again");
  if (!own_.displacement.empty() && own_.displacement.size() != unknowns_.of.size())
    file.fail_here("the displacements under loads do not fit the mesh");
  if (file.has("factors")) restore_factor(file);
  add_kept(file);
  statistics_.peak_bytes = kept_bytes() + (factor_ ? factor_->statistics().bytes : 0);
}

}  // namespace rollcon::fem
