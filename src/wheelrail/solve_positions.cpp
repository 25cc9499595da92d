#include "wheelrail/solve_positions.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "geometry/profile_wear.hpp"
#include "linalg/blas_threads.hpp"
#include "support/fpenv.hpp"

namespace rollcon {
namespace {

class ManyPositions {
 public:
  /// What to take of a position that was solved; it throws nothing of its own.
  using Take = std::function<void(const WheelRail& solved, std::int64_t i)>;

  ManyPositions(WheelRail& wheel, const PositionList& list, Take take)
      : wheel_(wheel),
        list_(list),
        take_(std::move(take)),
        status_(static_cast<std::size_t>(list.cases), Status::cancelled) {}

  void run() {
    const BlasThreads blas(1);
    const std::int64_t wanted =
        std::clamp<std::int64_t>(wheel_.context().threads(), 1, std::max<std::int64_t>(list_.cases, 1));
    std::vector<std::unique_ptr<WheelRail>> own;
    for (std::int64_t t = 0; t < wanted; ++t) {
      // Without a log, and one thread for each.
      auto context = std::make_shared<Context>();
      context->set_threads(1);
      own.push_back(wheel_.copy(context));
    }
    std::vector<std::thread> helper;
    helper.reserve(own.size());
    for (std::size_t t = 1; t < own.size(); ++t) {
      try {
        helper.emplace_back([this, &one = *own[t]] { work(one); });
      } catch (const std::exception&) {
        break;  // no more threads to be had
      }
    }
    work(*own[0]);
    for (std::thread& t : helper) t.join();
  }

  Status finish(std::int32_t* status) {
    std::sort(failures_.begin(), failures_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [i, text] : failures_)
      wheel_.context().log(LogLevel::warning, "position %lld (counting from 0): %s", static_cast<long long>(i),
                           text.c_str());
    if (status)
      std::transform(status_.begin(), status_.end(), status, [](Status s) { return static_cast<std::int32_t>(s); });
    const auto any = [&](auto is) { return std::any_of(status_.begin(), status_.end(), is); };
    if (any([](Status s) { return s == Status::cancelled; })) return Status::cancelled;
    if (any([](Status s) { return static_cast<std::int32_t>(s) < 0; })) return Status::not_converged;
    for (const Status s : {Status::not_converged, Status::derailed, Status::too_deep, Status::rim_contact,
                           Status::coarse, Status::no_contact})
      if (any([s](Status own) { return own == s; })) return s;
    return Status::ok;
  }

 private:
  void work(WheelRail& own) {
    const QuietFloatingPoint quiet;
    for (std::int64_t i = next_.fetch_add(1); i < list_.cases && !wheel_.cancelled(); i = next_.fetch_add(1)) {
      try {
        status_[static_cast<std::size_t>(i)] = solve(own, i);
        continue;
      } catch (const Error& error) {
        fail_case(i, error.status(), error.what());
      } catch (const std::bad_alloc&) {
        fail_case(i, Status::err_memory, "out of memory");
      } catch (const std::exception& error) {
        fail_case(i, Status::err_internal, error.what());
      }
    }
  }

  Status solve(WheelRail& own, std::int64_t i) {
    own.reset();
    own.set_position(list_.position + 6 * i);
    own.set_velocity(list_.velocity + 6 * i);
    const Status status = own.solve();
    take_(own, i);
    return status;
  }

  void fail_case(std::int64_t i, Status status, const char* text) {
    status_[static_cast<std::size_t>(i)] = status;
    const std::lock_guard lock(mutex_);
    try {
      failures_.emplace_back(i, text);
    } catch (const std::bad_alloc&) {
      // The status tells.
    }
  }

  WheelRail& wheel_;
  const PositionList& list_;
  Take take_;
  std::vector<Status> status_;
  std::atomic<std::int64_t> next_{0};
  std::mutex mutex_;
  std::vector<std::pair<std::int64_t, std::string>> failures_;
};

}  // namespace

Status solve_positions(WheelRail& wheel, const PositionList& list, double* totals, std::int32_t* status) {
  wheel.require_ready_for_positions();
  wheel.forget_cancel();
  std::fill_n(totals, list.cases * position_totals, std::numeric_limits<double>::quiet_NaN());
  ManyPositions many(wheel, list, [totals](const WheelRail& solved, std::int64_t i) {
    double row[position_totals];
    solved.resultant(false, row, row + 3);
    row[6] = solved.stat("z");
    row[7] = solved.stat("vertical_force");
    row[8] = solved.stat("friction_power");
    std::copy_n(row, position_totals, totals + position_totals * i);
  });
  many.run();
  return many.finish(status);
}

Status find_wear(WheelRail& wheel, const PositionList& list, const WearOfPositions& wear, std::int32_t* status) {
  wheel.require_solved_friction("wear");
  wheel.require_ready_for_positions();
  wheel.forget_cancel();
  const auto n = static_cast<std::size_t>(wear.points), cases = static_cast<std::size_t>(list.cases);
  const std::vector<Vec2> point[2] = {wheel.profile_points(1, wear.points), wheel.profile_points(2, wear.points)};
  // Of each position by itself, so that the sum does not depend on the threads.
  std::vector<double> part(2 * n * cases, 0.0), whole(2 * cases, 0.0);
  ManyPositions many(wheel, list, [&](const WheelRail& solved, std::int64_t i) {
    for (const std::int32_t body : {1, 2}) {
      const std::size_t row = 2 * static_cast<std::size_t>(i) + static_cast<std::size_t>(body - 1);
      whole[row] = solved.add_wear(wear.law, body, point[body - 1], 1, part.data() + n * row);
    }
  });
  many.run();
  for (const std::size_t body : {0U, 1U}) {
    double* depth = body == 0 ? wear.wheel : wear.rail;
    std::vector<double> sum(n, 0.0);
    double volume = 0;
    for (std::size_t i = 0; i < cases; ++i) {
      const double weight = wear.weight ? wear.weight[i] : 1.0 / static_cast<double>(cases);
      for (std::size_t j = 0; j < n; ++j) sum[j] += weight * part[n * (2 * i + body) + j];
      volume += weight * whole[2 * i + body];
    }
    const std::vector<double> share = shares_of_length(lengths_along(point[body]));
    for (std::size_t j = 0; depth && j < n; ++j) depth[j] = sum[j] / share[j];
    if (wear.volume) wear.volume[body] = volume;
  }
  return many.finish(status);
}

}  // namespace rollcon
