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

/// Poisson's ratios no further than this from one before are solved on the coarser frame alone, as a difference: two
/// hundredths change forces by 0.6 % of mu Fn, and the coarser frame gives that change to a tenth.
constexpr double neighbours = 0.025;

/// Returns for each plane that which is solved on both frames for it: itself, or a neighbour of like bodies.
std::vector<std::size_t> solved_on_both(const TableGrid& grid) {
  const std::vector<double>& plane = grid.planes();
  std::vector<std::size_t> of(plane.size());
  for (std::size_t p = 1; p < plane.size(); ++p)
    of[p] = !grid.unlike() && plane[p] - plane[of[p - 1]] <= neighbours ? of[p - 1] : p;
  return of;
}

using Linear = std::array<double, most_linear_numbers>;
using Forces = RollingSampler::Forces;

/// Holds contacts of one ratio of semi-axes and one plane.
struct Sampled {
  std::unique_ptr<RollingSampler> sampler;
  RollingSampler* like = nullptr;  ///< like bodies on the same cells; where the bodies are alike, the sampler itself
  Linear linear{};                 ///< SampledNumber
  Linear linear_coarse{};          ///< SampledNumber without the finer frame
};

/// Holds what one thread solves with: contacts of the ratio it was at last, by plane.
struct Worker {
  std::int64_t ratio = -1;
  std::vector<Sampled> sampled;
  std::unique_ptr<RollingSampler> like;  ///< like bodies beside unlike ones
};

/// Finds linear theory by creepages so small that nothing slips.
void find_linear_theory(RollingSampler& like, Sampled& s) {
  constexpr double tiny = 1e-7;
  const Forces x = like.solve({tiny, 0, 0}), y = like.solve({0, tiny, 0}), z = like.solve({0, 0, tiny});
  const auto of = [](const auto& fx, const auto& fy, const auto& fz) {
    return Linear{-fx[0] / tiny, -fy[1] / tiny, -fz[1] / tiny, fy[2] / tiny, -fz[2] / tiny};
  };
  s.linear = of(x.extrapolated, y.extrapolated, z.extrapolated);
  s.linear_coarse = of(x.coarse, y.coarse, z.coarse);
}

/// Takes central differences over a thousandth of the magnitude's unit: pressure alone makes unlike bodies slip.
void find_unlike_theory(Sampled& s) {
  constexpr double step = 1e-3;
  const auto slope = [&](std::array<double, 3> by, double stiffness) {
    for (double& b : by) b *= step / stiffness;
    const auto more = s.sampler->solve(by).extrapolated, less = s.sampler->solve({-by[0], -by[1], -by[2]}).extrapolated;
    std::array<double, 3> rate{};
    for (std::size_t i = 0; i < 3; ++i) rate[i] = (more[i] - less[i]) * stiffness / (2 * step);
    return rate;
  };
  const auto at_rest = s.sampler->solve({0, 0, 0}).extrapolated;
  const auto x = slope({1, 0, 0}, s.linear[sampled_c11]), y = slope({0, 1, 0}, s.linear[sampled_c22]),
             z = slope({0, 0, 1}, s.linear[sampled_c22]);
  s.linear[sampled_c23] = -z[1];
  s.linear[sampled_c32] = y[2];
  s.linear[sampled_c33] = -z[2];
  s.linear[sampled_own_c11] = -x[0];
  s.linear[sampled_own_c22] = -y[1];
  s.linear[sampled_at_rest] = at_rest[0];
}

void stand_unlike(const TableGrid& grid, double ratio, const StripsSize& size, Worker& worker) {
  worker.like = std::make_unique<RollingSampler>(ratio, grid.pair.mean_poisson(), size.along, size.across);
  Sampled of_like;
  find_linear_theory(*worker.like, of_like);
  for (const double friction : grid.pair.friction) {
    Sampled s;
    s.sampler = std::make_unique<RollingSampler>(ratio, grid.pair, friction, size.along, size.across);
    s.like = worker.like.get();
    s.linear = of_like.linear;
    find_unlike_theory(s);
    worker.sampled.push_back(std::move(s));
  }
}

void stand_like(const TableGrid& grid, double ratio, const StripsSize& size, Worker& worker) {
  const std::vector<std::size_t> both = solved_on_both(grid);
  for (std::size_t p = 0; p < grid.poisson.size(); ++p) {
    Sampled s;
    s.sampler =
        std::make_unique<RollingSampler>(ratio, grid.poisson[p], size.along, size.across, /*fine=*/both[p] == p);
    s.like = s.sampler.get();
    find_linear_theory(*s.sampler, s);
    if (both[p] != p)
      for (std::size_t k = 0; k < like_linear_numbers; ++k)
        s.linear[k] = worker.sampled[both[p]].linear[k] + s.linear_coarse[k] - worker.sampled[both[p]].linear_coarse[k];
    worker.sampled.push_back(std::move(s));
  }
}

void stand(const TableGrid& grid, std::int64_t at_ratio, Worker& worker) {
  if (worker.ratio == at_ratio) return;
  const double ratio = std::exp(log_ratio_of(grid, at_ratio));
  worker.ratio = -1;
  worker.sampled.clear();
  (grid.unlike() ? stand_unlike : stand_like)(grid, ratio, frame_of(grid, ratio), worker);
  worker.ratio = at_ratio;
}

struct ChainDirection {
  double theta, psi;
};

/// Returns forces at the magnitudes of a chain. Where the pole of sliding lies inside the contact, its place among the
/// cells counts. This error is known for like bodies that slide as rigid ones; the elastic displacements move the pole
/// ever less as the creepages grow, so that this error, times s cubed, is taken off. Measured on 98 random cases of s
/// above 0.5 against frames twice as fine: force 0.16 -> 0.11, 0.12 -> 0.05, 0.03 -> 0.04 % rms for a/b about 1, below
/// 0.2, above 5. That error is taken from like bodies on the same cells, too, where unlike ones are solved.
std::vector<Forces> forces_of_chain(const TableGrid& grid, double log_ratio, const ChainDirection& to,
                                    const Sampled& plane) {
  constexpr double vast = 1e5;
  const auto unit = unit_creepages(grid, log_ratio, to.theta, to.psi, plane.linear.data());
  const auto solve = [&](RollingSampler& sampler, double r) {
    return sampler.solve({r * unit[0], r * unit[1], r * unit[2]});
  };
  plane.sampler->reset();
  std::vector<Forces> f;
  for (std::int64_t i = 1; i <= grid.samples_along(); ++i) {
    const double s = magnitude_of(grid, i);
    f.push_back(solve(*plane.sampler, s < 1 ? half_magnitude * s / (1 - s) : vast));
  }
  if (grid.unlike()) plane.like->reset();
  const Forces found = solve(*plane.like, vast);
  double exact[3];
  sliding_limit(std::exp(log_ratio), unit, exact);
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double weight = std::pow(magnitude_of(grid, static_cast<std::int64_t>(i) + 1), 3);
    for (std::size_t k = 0; k < 3; ++k) {
      f[i].extrapolated[k] += weight * (exact[k] - found.extrapolated[k]);
      f[i].coarse[k] += weight * (exact[k] - found.coarse[k]);
    }
  }
  return f;
}

/// Solves a chain; to[p]: where its numbers for plane p go.
void solve_chain(const TableGrid& grid, std::int64_t chain, const Worker& worker, const std::vector<double*>& to) {
  const double log_ratio = log_ratio_of(grid, worker.ratio);
  const std::int64_t around = grid.samples_around(), angle = chain == 0 ? 0 : 1 + (chain - 1) / around;
  const ChainDirection direction{angle_of(grid, angle), chain == 0 ? 0 : direction_of(grid, (chain - 1) % around)};
  const std::vector<std::size_t> both = solved_on_both(grid);
  std::vector<std::vector<Forces>> f;
  for (std::size_t p = 0; p < to.size(); ++p) {
    f.push_back(forces_of_chain(grid, log_ratio, direction, worker.sampled[p]));
    const auto &own = f[p], &base = f[both[p]];
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        to[p][3 * i + k] =
            both[p] == p ? own[i].extrapolated[k] : base[i].extrapolated[k] + own[i].coarse[k] - base[i].coarse[k];
  }
}

/// Says whether a direction without spin is the mirror image of one on the other side of the rolling direction.
bool mirrored(const TableGrid& grid, std::int64_t chain) {
  const std::int64_t around = grid.samples_around();
  return chain > (grid.angles - 1) * around && (chain - 1) % around < around / 2;
}

void mirror(const TableGrid& grid, const SampleLayout& layout, double* plane) {
  const std::int64_t around = grid.samples_around();
  double* const first = plane + layout.numbers + (1 + (grid.angles - 1) * around) * layout.chain;
  for (std::int64_t k = 0; k < around / 2; ++k)
    for (std::int64_t i = 0; i < layout.chain; ++i)
      first[k * layout.chain + i] = (i % 3 == 0 ? 1 : -1) * first[(around - 1 - k) * layout.chain + i];
}

}  // namespace

SampleLayout::SampleLayout(const TableGrid& grid)
    : planes(static_cast<std::int64_t>(grid.planes().size()) * (grid.ratios + 1)),
      chains(1 + grid.angles * grid.samples_around()),
      chain(3 * grid.samples_along()),
      numbers(static_cast<std::int64_t>(linear_numbers(grid))) {}

double log_ratio_of(const TableGrid& grid, std::int64_t ratio) {
  const double low = std::log(grid.least_ratio), high = std::log(grid.greatest_ratio);
  return low + (high - low) * static_cast<double>(ratio) / static_cast<double>(grid.ratios);
}

double angle_of(const TableGrid& grid, std::int64_t angle) {
  return std::numbers::pi / 2 * static_cast<double>(angle) / static_cast<double>(grid.angles);
}

double magnitude_of(const TableGrid& grid, std::int64_t magnitude) {
  return static_cast<double>(magnitude) / static_cast<double>(grid.magnitudes);
}

double direction_of(const TableGrid& grid, std::int64_t direction) {
  const auto around = static_cast<double>(grid.samples_around()), turn = static_cast<double>(grid.parities());
  return std::numbers::pi * turn * ((static_cast<double>(direction) + 0.5) / around - 0.5);
}

std::array<double, 3> unit_creepages(const TableGrid& grid, double log_ratio, double angle, double direction,
                                     const double* linear) {
  const double turn = grid.stretch(log_ratio), spin = linear[sampled_c22] * grid.spin_scale(log_ratio);
  return {std::sin(angle) * std::cos(direction) / (linear[sampled_c11] * turn),
          std::sin(angle) * std::sin(direction) * turn / linear[sampled_c22], std::cos(angle) / spin};
}

void solve_samples(const TableGrid& grid, std::int64_t part, std::int64_t parts, const Context& context,
                   std::vector<double>& sample) {
  const BlasThreads blas(1);
  const SampleLayout layout(grid);
  const std::int64_t ratios = grid.ratios + 1, count = ratios * layout.chains;
  const auto start = [&](std::int64_t plane, std::int64_t chain) {
    return sample.data() + plane * layout.plane() + layout.numbers + chain * layout.chain;
  };
  const auto wanted = [&](std::int64_t i) {
    const std::int64_t chain = i % layout.chains, last = layout.planes - ratios + i / layout.chains;
    return i % parts == part && !mirrored(grid, chain) && std::isnan(start(last, chain)[layout.chain - 1]);
  };
  std::vector<Worker> worker(at(context.threads()));
  try {
    parallel_for(count, 1, context.threads(), [&](std::int64_t i, int thread) {
      if (!context.ranks().mine(i / parts) || !wanted(i)) return;
      const std::int64_t ratio = i / layout.chains, chain = i % layout.chains;
      std::vector<double*> to;
      for (std::int64_t p = ratio; p < layout.planes; p += ratios) to.push_back(start(p, chain));
      Worker& w = worker[at(thread)];
      stand(grid, ratio, w);
      for (std::size_t p = 0; chain == 0 && p < to.size(); ++p)
        std::copy_n(w.sampled[p].linear.begin(), layout.numbers, to[p] - layout.numbers);
      solve_chain(grid, chain, w, to);
    });
  } catch (const Cancelled&) {
    // All ranks see this by the samples that are still wanted.
  }
  std::vector<std::uint8_t> known;
  for (const double v : sample) known.push_back(std::isnan(v) ? 0 : 1);
  context.ranks().give(sample.data(), std::ssize(sample), sizeof(double), sizeof(double), known);
  for (std::int64_t plane = 0; plane < layout.planes; ++plane)
    mirror(grid, layout, sample.data() + plane * layout.plane());
  for (std::int64_t i = 0; i < count; ++i)
    if (wanted(i)) throw Cancelled{};
}

StripsSize frame_of(const TableGrid& grid, double ratio) {
  const auto part = [](std::int64_t n, double factor, double least, double most) {
    return to_index(std::round(static_cast<double>(n) * std::clamp(factor, least, most)));
  };
  return {part(grid.along, std::pow(ratio, 0.2), 0.5, 1.35), part(grid.across, std::pow(ratio, -0.35), 0.8, 2.2)};
}

void sliding_limit(double ratio, const std::array<double, 3>& creepage, double* force) {
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
