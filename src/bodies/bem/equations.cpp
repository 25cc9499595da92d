/// Boundary elements written out: matrix and right sides, nothing factorised.

#include <algorithm>
#include <utility>

#include "bodies/bem/system.hpp"
#include "support/clock.hpp"
#include "support/index.hpp"

namespace rollcon::bem {

// The factors take the matrix's place: with them the body keeps no second copy of its own.
std::shared_ptr<const BodyEquations> System::equations(int threads) {
  const std::lock_guard lock(mutex_);
  if (auto known = equations_.lock()) return known;
  auto equations = std::make_shared<BodyEquations>();
  equations->unknowns = unknowns_.columns;
  {
    const Stopwatch watch(statistics_.seconds_assembly);
    equations->dense.resize(at(unknowns_.columns * unknowns_.columns));
    std::vector<double> no_load;
    assemble(threads, equations->dense.data(), no_load);
    ++statistics_.assemblies;
  }
  statistics_.peak_bytes = std::max(statistics_.peak_bytes,
                                    matrix_.bytes() + equations->dense.capacity() * sizeof(double));
  equations_ = equations;
  if (options_.keep_factors != 0 && !matrix_.factored()) kept_equations_ = equations;
  return equations;
}

void System::write_loads(const std::vector<double>& b, SurfaceLoads& loads) const {
  loads.unknown.clear();
  for (const std::int32_t k : loads.row)
    for (std::size_t c = 0; c < 3; ++c)
      loads.unknown.push_back(unknowns_.displacement[3 * at(k) + c]);
  const std::int64_t n = unknowns_.columns;
  SparseColumns& to = loads.load;
  to.rows = n;
  to.columns = 3 * static_cast<std::int64_t>(loads.column.size());
  to.start.push_back(0);
  const auto count =
      static_cast<std::size_t>(std::count_if(b.begin(), b.end(), [](double v) { return v != 0; }));
  to.row.reserve(count);
  to.value.reserve(count);
  for (std::int64_t k = 0; k < to.columns; ++k) {
    for (std::int64_t i = 0; i < n; ++i)
      if (const double v = b[at(i + k * n)]; v != 0) {
        to.row.push_back(i);
        to.value.push_back(v);
      }
    to.start.push_back(static_cast<std::int64_t>(to.row.size()));
  }
}

void System::load(std::span<const std::int64_t> face, SurfaceLoads& loads, int threads) {
  write_loads(right_sides(integrals_, columns_of_faces(face, loads), true, threads), loads);
}

void System::load(const SurfaceMesh& layer, SurfaceLoads& loads, int threads) {
  const BoundaryIntegrals integrals(layer, poisson_, options_.accuracy);
  write_loads(right_sides(integrals, columns_of_layer(layer), false, threads), loads);
  statistics_.kernel_evaluations += integrals.kernel_evaluations();
}

}  // namespace rollcon::bem
