/// Writes a boundary-element body's equations to a file, and reads them.

#include <array>
#include <cmath>

#include "bodies/bem/system.hpp"
#include "bodies/model/archive.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon::bem {

std::uint64_t System::numbering() const {
  Checksum sum;
  const auto add = [&](const auto& values) { sum.add(values.data(), values.size() * sizeof values[0]); };
  add(unknowns_.displacement);
  add(unknowns_.traction);
  add(unknowns_.row);
  add(fans_.of);
  add(lifted_.mesh.connectivity);
  // Points count by their places on elements to six digits: positions differ in the last bit between compilers.
  for (const CollocationPoint& point : unknowns_.point) {
    add(std::array{point.node, point.element});
    add(std::array{to_index(std::round(1e6 * point.xi)), to_index(std::round(1e6 * point.eta))});
  }
  return sum.value();
}

void System::write_factors(SectionWriter& file) const {
  const auto* const dense = dynamic_cast<const FactoredMatrix*>(factor_.get());
  if (!dense)
    fail(Status::err_unsupported,
         "hierarchical factors are not written to files, because hmat-oss checks nothing of what it reads: prepare the "
         "body with option factor = 1, or save it with keep_factors = 0 once a contact has its compliance");
  const FactoredMatrix& matrix = *dense;
  const auto pivots = matrix.pivots();
  OutArchive ar(file);
  ar(matrix.size());
  file.write(pivots.data(), pivots.size_bytes());
  file.write(matrix.factors().data(), matrix.factors().size_bytes());
}

void System::read_factors(SectionReader& file) {
  const std::int64_t n = unknowns_.columns;
  std::int64_t size = 0;
  InArchive{file}(size);
  const std::uint64_t need = at(n) * sizeof(std::int32_t) + at(n) * at(n) * sizeof(double);
  if (size != n || file.left() != need) file.fail_here("the factors do not fit the unknowns");
  std::vector<std::int32_t> pivot(at(n));
  file.read(pivot.data(), pivot.size() * sizeof pivot[0]);
  auto matrix = std::make_unique<FactoredMatrix>();
  file.read(matrix->prepare(n), at(n) * at(n) * sizeof(double));
  if (!matrix->restore(pivot, statistics_.condition)) file.fail_here("the pivots are none");
  factor_ = std::move(matrix);
}

}  // namespace rollcon::bem
