#include "tables/table_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "linalg/blas_threads.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"
#include "tables/rolling_sampler.hpp"

namespace rollcon {
namespace {

/// What one thread solves with: contacts of the plane it was at last, and linear theory's coefficients there.
struct Worker {
  std::int64_t plane = -1;
  std::unique_ptr<RollingSampler> sampler;
  std::array<double, linear_numbers> linear{};
};

/// By creepages so small that nothing slips.
std::array<double, linear_numbers> linear_theory(RollingSampler& sampler) {
  constexpr double tiny = 1e-7;
  const auto x = sampler.solve({tiny, 0, 0}), y = sampler.solve({0, tiny, 0}), z = sampler.solve({0, 0, tiny});
  return {-x[0] / tiny, -y[1] / tiny, -z[1] / tiny, y[2] / tiny, -z[2] / tiny};
}

void stand(const TableGrid& grid, std::int64_t plane, Worker& worker) {
  if (worker.plane == plane) return;
  const double ratio = std::exp(log_ratio_of(grid, plane % (grid.ratios + 1)));
  const double poisson = grid.poisson[at(plane / (grid.ratios + 1))];
  worker.plane = -1;
  const StripsSize size = frame_of(grid, ratio);
  worker.sampler = std::make_unique<RollingSampler>(ratio, poisson, size.along, size.across);
  worker.linear = linear_theory(*worker.sampler);
  worker.plane = plane;
}

void solve_chain(const TableGrid& grid, std::int64_t chain, Worker& worker, double* to) {
  const double log_ratio = log_ratio_of(grid, worker.plane % (grid.ratios + 1));
  const double spin = worker.linear[1] * grid.spin_scale(log_ratio);
  const std::int64_t angle = chain == 0 ? 0 : 1 + (chain - 1) / grid.directions;
  const double theta = angle_of(grid, angle);
  const double psi = chain == 0 ? 0 : direction_of(grid, (chain - 1) % grid.directions);
  worker.sampler->reset();
  const double turn = grid.stretch(log_ratio);
  const double unit[3] = {std::sin(theta) * std::cos(psi) / (worker.linear[0] * turn),
                          std::sin(theta) * std::sin(psi) * turn / worker.linear[1], std::cos(theta) / spin};
  for (std::int64_t i = 1; i < grid.magnitudes; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(grid.magnitudes);
    const double r = half_magnitude * s / (1 - s);
    const auto f = worker.sampler->solve({r * unit[0], r * unit[1], r * unit[2]});
    std::copy(f.begin(), f.end(), to + 3 * (i - 1));
  }
}

/// Without spin a direction is the mirror image of the one opposite across the rolling direction.
bool mirrored(const TableGrid& grid, std::int64_t chain) {
  return chain > (grid.angles - 1) * grid.directions && (chain - 1) % grid.directions < grid.directions / 2;
}

void mirror(const TableGrid& grid, const SampleLayout& layout, double* plane) {
  double* const first = plane + linear_numbers + (1 + (grid.angles - 1) * grid.directions) * layout.chain;
  for (std::int64_t k = 0; k < grid.directions / 2; ++k)
    for (std::int64_t i = 0; i < layout.chain; ++i)
      first[k * layout.chain + i] = (i % 3 == 0 ? 1 : -1) * first[(grid.directions - 1 - k) * layout.chain + i];
}

}  // namespace

SampleLayout::SampleLayout(const TableGrid& grid)
    : planes(static_cast<std::int64_t>(grid.poisson.size()) * (grid.ratios + 1)),
      chains(1 + grid.angles * grid.directions),
      chain(3 * (grid.magnitudes - 1)) {}

double log_ratio_of(const TableGrid& grid, std::int64_t ratio) {
  const double low = std::log(grid.least_ratio), high = std::log(grid.greatest_ratio);
  return low + (high - low) * static_cast<double>(ratio) / static_cast<double>(grid.ratios);
}

double angle_of(const TableGrid& grid, std::int64_t angle) {
  return std::numbers::pi / 2 * static_cast<double>(angle) / static_cast<double>(grid.angles);
}

double direction_of(const TableGrid& grid, std::int64_t direction) {
  return std::numbers::pi * ((static_cast<double>(direction) + 0.5) / static_cast<double>(grid.directions) - 0.5);
}

void solve_samples(const TableGrid& grid, std::int64_t part, std::int64_t parts, int threads,
                   std::vector<double>& sample) {
  const BlasThreads blas(1);
  const SampleLayout layout(grid);
  std::vector<Worker> worker(at(threads));
  parallel_for(layout.planes * layout.chains, 1, threads, [&](std::int64_t i, int thread) {
    const std::int64_t plane = i / layout.chains, chain = i % layout.chains;
    double* const numbers = sample.data() + plane * layout.plane();
    double* const to = numbers + linear_numbers + chain * layout.chain;
    if (i % parts != part || mirrored(grid, chain) || !std::isnan(to[layout.chain - 1])) return;
    Worker& w = worker[at(thread)];
    stand(grid, plane, w);
    if (chain == 0) std::copy(w.linear.begin(), w.linear.end(), numbers);
    solve_chain(grid, chain, w, to);
  });
  for (std::int64_t plane = 0; plane < layout.planes; ++plane)
    mirror(grid, layout, sample.data() + plane * layout.plane());
}

StripsSize frame_of(const TableGrid& grid, double ratio) {
  const auto part = [](std::int64_t n, double factor, double least, double most) {
    return static_cast<std::int64_t>(std::lround(static_cast<double>(n) * std::clamp(factor, least, most)));
  };
  return {part(grid.along, std::pow(ratio, 0.2), 0.5, 1.35), part(grid.across, std::pow(ratio, -0.35), 0.8, 2.2)};
}

void sliding_limit(double ratio, const double (&creepage)[3], double* force) {
  // Depth z = sqrt(1 - r^2) makes the pressure of Hertz smooth in both coordinates.
  constexpr int depths = 160, around = 240;
  const double a = std::sqrt(ratio);
  force[0] = force[1] = force[2] = 0;
  for (int i = 0; i < depths; ++i) {
    const double z = (i + 0.5) / depths, r = std::sqrt(1 - z * z), part = 3 * z * z / (depths * around);
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * std::numbers::pi * (j + 0.5) / around;
      const double x = a * r * std::cos(angle), y = r * std::sin(angle) / a;
      const double sx = creepage[0] - creepage[2] * y, sy = creepage[1] + creepage[2] * x, speed = std::hypot(sx, sy);
      if (speed == 0) continue;
      force[0] -= part * sx / speed;
      force[1] -= part * sy / speed;
      force[2] -= part * (x * sy - y * sx) / speed;
    }
  }
}

}  // namespace rollcon
