#pragma once
/// Makes creep tables that are small enough for a test, and asks them.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "support/frames.hpp"
#include "tables/creep_table.hpp"
#include "tables/table_samples.hpp"

namespace rollcon::small_tables {

inline TableGrid grid(int magnitudes) {
  TableGrid grid;
  grid.ratios = 4;
  grid.magnitudes = magnitudes;
  grid.angles = 6;
  grid.directions = 6;
  grid.least_ratio = 0.5;
  grid.greatest_ratio = 2;
  grid.along = 6;
  grid.across = 4;
  return grid;
}

inline std::vector<double> solve(const TableGrid& grid, int parts = 1, int threads = 2) {
  std::vector<double> sample(static_cast<std::size_t>(SampleLayout(grid).size()),
                             std::numeric_limits<double>::quiet_NaN());
  Context context;
  context.set_threads(threads);
  for (int part = 0; part < parts; ++part) solve_samples(grid, part, parts, context, sample);
  return sample;
}

/// Draws creepages of a size over friction times load / (shear a b), in any direction.
inline void draw_creepages(frames::Random& random, double size, TableInput& in) {
  const double scale = size * in.friction * in.load / (in.shear * in.a * in.b);
  in.longitudinal = scale * random.between(-1, 1);
  in.lateral = scale * random.between(-1, 1);
  in.spin = scale / std::sqrt(in.a * in.b) * random.between(-1, 1);
}

struct Answer {
  double force[3], by[3][9];
};

inline Answer ask(const CreepTable& table, const TableInput& in) {
  Answer a;
  table.evaluate(in, 0, a.force, &a.by[0][0]);
  return a;
}

/// Returns the worst difference between the change of forces over steps of the inputs and that by the derivatives, over
/// mu Fn. Steps are a fraction of each input; those that would leave its range are not taken.
template <class Draw>
double worst_derivative(const CreepTable& table, const Draw& draw, double share,
                        const std::map<int, std::array<double, 2>>& ranges) {
  double worst = 0;
  for (int n = 0; n < 300; ++n) {
    TableInput in = draw();
    const Answer a = ask(table, in);
    double* const input = &in.shear;
    const double bound = in.friction * in.load;
    for (int j = 0; j < 9; ++j) {
      const double keep = input[j], step = share * std::abs(keep);
      const auto range = ranges.find(j);
      if (range != ranges.end() && (keep - step < range->second[0] || keep + step > range->second[1])) continue;
      input[j] = keep + step;
      const Answer more = ask(table, in);
      input[j] = keep - step;
      const Answer less = ask(table, in);
      input[j] = keep;
      for (int i = 0; i < 3; ++i) {
        const double unit = bound * (i == 2 ? std::sqrt(in.a * in.b) : 1);
        worst = std::max(worst, std::abs((more.force[i] - less.force[i]) - 2 * step * a.by[i][j]) / unit);
      }
    }
  }
  return worst;
}

}  // namespace rollcon::small_tables
