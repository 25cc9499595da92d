/// A boundary-element body's equations to and from a file.

#include <array>
#include <cmath>

#include "bodies/bem/system.hpp"
#include "bodies/model/archive.hpp"
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
  // By places on elements to six digits: positions differ in the last bit between compilers.
  for (const CollocationPoint& point : unknowns_.point) {
    add(std::array{point.node, point.element});
    add(std::array{to_index(std::round(1e6 * point.xi)), to_index(std::round(1e6 * point.eta))});
  }
  return sum.value();
}

std::int64_t System::solvable() const {
  const std::lock_guard lock(mutex_);
  return matrix_.factored() ? unknowns_.columns : 0;
}

void System::save(SectionWriter& file, const OwnLoads& own) const {
  const std::lock_guard lock(mutex_);
  OutArchive ar(file);
  file.begin("response");
  ar(matrix_.factored() ? unknowns_.columns : std::int64_t{0});
  ar(numbering());
  ar(statistics_.condition);
  ar(own.displacement);
  ar(own.traction);
  if (matrix_.factored()) {
    file.begin("factors");
    const auto pivots = matrix_.pivots();
    ar(matrix_.size());
    file.write(pivots.data(), pivots.size_bytes());
    file.write(matrix_.factors().data(), matrix_.factors().size_bytes());
  }
  save_kept(file);
}

void System::restore(SectionReader& file) {
  InArchive ar(file);
  file.begin("response");
  std::int64_t solvable = 0;
  std::uint64_t numbers = 0;
  ar(solvable);
  ar(numbers);
  ar(statistics_.condition);
  ar(own_.displacement);
  ar(own_.traction);
  file.end();
  if (numbers != numbering())
    file.fail_here("this library numbers the unknowns of the body differently: save it again");
  const std::size_t u = own_.displacement.size(), t = own_.traction.size();
  if ((u != 0 || t != 0) && (u != unknowns_.displacement.size() || t != unknowns_.traction.size()))
    file.fail_here("the displacements under loads do not fit the mesh");
  if (t != 0) own_.reaction = support_reaction(own_.traction, given_tractions(mesh_));
  if (solvable > 0) {
    file.begin("factors");
    const std::int64_t n = unknowns_.columns;
    std::int64_t size = 0;
    ar(size);
    const std::uint64_t need = at(n) * sizeof(std::int32_t) + at(n) * at(n) * sizeof(double);
    if (size != n || file.left() != need) file.fail_here("the factors do not fit the unknowns");
    std::vector<std::int32_t> pivot(at(n));
    file.read(pivot.data(), pivot.size() * sizeof pivot[0]);
    file.read(matrix_.prepare(n), at(n) * at(n) * sizeof(double));
    file.end();
    if (!matrix_.restore(pivot, statistics_.condition)) file.fail_here("the pivots are none");
  }
  add_kept(file);
  statistics_.peak_bytes = matrix_.bytes() + kept_bytes();
}

}  // namespace rollcon::bem
