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

// Hierarchical factors begin with the number of unknowns below zero.
void System::write_factors(SectionWriter& file) const {
  OutArchive ar(file);
  const auto* const dense = dynamic_cast<const FactoredMatrix*>(factor_.get());
  if (!dense) {
    ar(-factor_->size());
    return write_hierarchical(*factor_, [&](const void* data, std::size_t bytes) { file.write(data, bytes); });
  }
  const auto pivots = dense->pivots();
  ar(dense->size());
  file.write(pivots.data(), pivots.size_bytes());
  file.write(dense->factors().data(), dense->factors().size_bytes());
}

void System::read_factors(SectionReader& file) {
  const std::int64_t n = unknowns_.columns;
  std::int64_t size = 0;
  InArchive{file}(size);
  if (size == -n) {
    try {
      factor_ = read_hierarchical(pivots(), statistics_.condition, [&](void* data, std::size_t bytes) {
        if (bytes > file.left()) fail(Status::err_io, "hierarchical factors end early");
        file.read(data, bytes);
      });
    } catch (const Error& e) {
      if (e.status() != Status::err_io) throw;
      file.fail_here(e.what());
    }
    return;
  }
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
