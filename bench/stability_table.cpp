#include <algorithm>
#include <cmath>
#include <cstdio>

#include "stability.hpp"

namespace rollcon::bench {

void StabilityTable::add(const std::string& way, const std::string& group, const extremes::Ending& ending, bool right) {
  const auto remember = [](std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  };
  remember(ways_, way);
  remember(groups_, group);
  StabilityRow& row = row_[{way, group}];
  ++row.scenes;
  row.seconds += ending.seconds;
  row.iterations = std::max(row.iterations, ending.iterations);
  row.all_iterations += ending.iterations;
  if (std::isfinite(ending.condition)) row.condition = std::max(row.condition, ending.condition);
  if (ending.solved()) row.law = std::max(row.law, ending.law.worst());
  if (ending.status == ROLLCON_NOT_CONVERGED)
    ++row.not_converged;
  else if (!right || !ending.honest(law_bound))
    ++row.wrong;
  else
    ++(ending.solved() ? row.solved : row.refused);
}

void StabilityTable::print() const {
  for (const std::string& way : ways_) {
    std::printf("\n%s\n%-26s %6s %6s %7s %13s %5s %8s %11s %9s %8s\n", way.c_str(), "group", "scenes", "solved",
                "refused", "not converged", "wrong", "law", "iterations", "condition", "seconds");
    StabilityRow sum;
    const auto print_row = [](const std::string& name, const StabilityRow& r) {
      std::printf("%-26s %6lld %6lld %7lld %13lld %5lld %8.1e %5.1f/%5.0f %9.1e %8.2f\n", name.c_str(),
                  static_cast<long long>(r.scenes), static_cast<long long>(r.solved), static_cast<long long>(r.refused),
                  static_cast<long long>(r.not_converged), static_cast<long long>(r.wrong), r.law,
                  r.all_iterations / static_cast<double>(std::max<std::int64_t>(r.scenes, 1)), r.iterations,
                  r.condition, r.seconds);
    };
    for (const std::string& group : groups_) {
      const auto found = row_.find({way, group});
      if (found == row_.end()) continue;
      const StabilityRow& r = found->second;
      print_row(group, r);
      sum.scenes += r.scenes, sum.solved += r.solved, sum.refused += r.refused;
      sum.not_converged += r.not_converged, sum.wrong += r.wrong, sum.seconds += r.seconds;
      sum.all_iterations += r.all_iterations;
      sum.law = std::max(sum.law, r.law);
      sum.iterations = std::max(sum.iterations, r.iterations);
      sum.condition = std::max(sum.condition, r.condition);
    }
    print_row("all", sum);
  }
}

}  // namespace rollcon::bench
