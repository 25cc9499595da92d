#include "wheelrail/solve_positions.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "geometry/profile_wear.hpp"
#include "linalg/blas_threads.hpp"
#include "support/batch.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon {
namespace {

/// Solves each position. take() puts the results of a solved position, `width` numbers, into its row of `rows`.
template <class Take>
Status solve_each(WheelRail& wheel, const PositionList& list, std::int32_t* status, double* rows, std::int64_t width,
                  const Take& take) {
  const BlasThreads blas(1);
  Batch batch(list.cases, wheel.context());
  std::vector<std::unique_ptr<WheelRail>> worker;
  while (std::ssize(worker) < std::min<std::int64_t>(wheel.context().threads(), list.cases)) {
    // Each worker has one thread and no log.
    const auto context = std::make_shared<Context>();
    context->set_threads(1);
    worker.push_back(wheel.copy(context));
  }
  parallel_for(list.cases, 1, static_cast<int>(worker.size()), [&](std::int64_t i, int thread) {
    if (wheel.cancelled() || !wheel.context().ranks().mine(i)) return;
    batch.take(i, [&] {
      WheelRail& own = *worker[at(thread)];
      own.reset();
      own.set_position(list.position + 6 * i);
      own.set_velocity(list.velocity + 6 * i);
      const Status found = own.solve();
      take(own, i);
      return found;
    });
  });
  batch.give(rows, width, width);
  return batch.finish("position", status);
}

}  // namespace

Status solve_positions(WheelRail& wheel, const PositionList& list, double* totals, std::int32_t* status) {
  wheel.require_ready_for_positions();
  wheel.forget_cancel();
  std::fill_n(totals, list.cases * position_totals, std::numeric_limits<double>::quiet_NaN());
  return solve_each(wheel, list, status, totals, position_totals, [totals](const WheelRail& solved, std::int64_t i) {
    double row[position_totals];
    solved.resultant(false, row, row + 3);
    row[6] = solved.stat("z");
    row[7] = solved.stat("vertical_force");
    row[8] = solved.stat("friction_power");
    std::copy_n(row, position_totals, totals + position_totals * i);
  });
}

Status find_wear(WheelRail& wheel, const PositionList& list, const WearOfPositions& wear, std::int32_t* status) {
  wheel.require_solved_friction("wear");
  wheel.require_ready_for_positions();
  wheel.forget_cancel();
  const auto n = static_cast<std::size_t>(wear.points), cases = static_cast<std::size_t>(list.cases);
  const std::vector<Vec2> point[2] = {wheel.profile_points(1, wear.points), wheel.profile_points(2, wear.points)};
  // Wear of each position and body is stored by itself, the volume after its points, so that the sum does not depend on
  // the threads.
  std::vector<double> part(2 * (n + 1) * cases, 0.0);
  const auto row = [&](std::int64_t i, std::size_t body) { return part.data() + (n + 1) * (2 * at(i) + body); };
  const auto each = [&](const WheelRail& solved, std::int64_t i) {
    for (const std::int32_t body : {1, 2}) {
      double* const to = row(i, at(body - 1));
      to[n] = solved.add_wear(wear.law, body, point[body - 1], 1, to);
    }
  };
  const Status worst = solve_each(wheel, list, status, part.data(), std::ssize(part) / list.cases, each);
  for (const std::size_t body : {0U, 1U}) {
    double* depth = body == 0 ? wear.wheel : wear.rail;
    std::vector<double> sum(n, 0.0);
    double volume = 0;
    for (std::int64_t i = 0; i < list.cases; ++i) {
      const double weight = wear.weight ? wear.weight[i] : 1.0 / static_cast<double>(cases), *from = row(i, body);
      for (std::size_t j = 0; j < n; ++j) sum[j] += weight * from[j];
      volume += weight * from[n];
    }
    const std::vector<double> share = shares_of_length(lengths_along(point[body]));
    for (std::size_t j = 0; depth && j < n; ++j) depth[j] = sum[j] / share[j];
    if (wear.volume) wear.volume[body] = volume;
  }
  return worst;
}

}  // namespace rollcon
