#include "study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "support/carter_strip.hpp"

namespace rollcon::bench {

namespace {

constexpr double orders[] = {1, 1.5, 2, 3};
constexpr double least_uncertainty = 1e-6;  ///< relative: the solver's own accuracy
constexpr int most_repeats = 5;
constexpr double repeat_below = 0.25;  ///< seconds

struct Fit {
  double value = 0, residual = 0;
};

/// Fits value + c x by least squares.
Fit straight_line(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sx += x[k], sy += y[k], sxx += x[k] * x[k], sxy += x[k] * y[k];
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  Fit fit{(sy - slope * sx) / n, 0};
  for (std::size_t k = 0; k < x.size(); ++k) fit.residual += std::pow(fit.value + slope * x[k] - y[k], 2);
  // Two of the points go into the line.
  fit.residual = x.size() > 2 ? std::sqrt(fit.residual / (n - 2)) : 0;
  return fit;
}

double extra_of(const Record& record, const std::string& name) {
  for (const auto& [key, value] : record.extra)
    if (key == name) return value;
  throw std::out_of_range("record without " + name);
}

bool has_mesh(rollcon_body* body) {
  std::int32_t kind = 0;
  if (rollcon_body_get_kind(body, &kind) < 0) return false;
  return kind == ROLLCON_BODY_BEM || kind == ROLLCON_BODY_FEM;
}

}  // namespace

Limit extrapolate(std::vector<Sample> curve) {
  std::sort(curve.begin(), curve.end(), [](const Sample& a, const Sample& b) {
    return a.across != b.across ? a.across > b.across : a.value < b.value;
  });
  std::size_t count = 0;
  while (count < curve.size() && (count < 3 || curve[count].across >= 0.45 * curve[0].across)) ++count;
  curve.resize(count);
  const double finest = curve.front().value, floor = least_uncertainty * std::abs(finest);
  if (count < 2) return {finest, std::abs(finest)};
  Fit best{0, std::numeric_limits<double>::max()};
  std::vector<double> y;
  for (const Sample& s : curve) y.push_back(s.value);
  for (const double order : orders) {
    std::vector<double> x;
    for (const Sample& s : curve) x.push_back(std::pow(curve.front().across / s.across, order));
    const Fit fit = straight_line(x, y);
    if (fit.residual < best.residual) best = fit;
    if (count == 2) break;  // first order, for want of a third point
  }
  return {best.value, std::hypot(0.5 * (best.value - finest), 2 * best.residual) + floor};
}

Limit combine(std::span<const Limit> limits) {
  double weights = 0, mean = 0, spread = 0;
  for (const Limit& limit : limits) {
    const double weight = 1 / (limit.uncertainty * limit.uncertainty);
    weights += weight, mean += weight * limit.value;
  }
  mean /= weights;
  for (const Limit& limit : limits) spread += std::pow((limit.value - mean) / limit.uncertainty, 2) / weights;
  return {mean, std::max(std::sqrt(1 / weights), std::sqrt(spread))};
}

void add_frame_limits(FrameLimits& limits, int parts, int coarse, int lines,
                      const std::function<std::unique_ptr<scenes::RollingPair>(int parts)>& make,
                      const std::function<std::vector<double>(scenes::RollingPair&, int lines)>& solve) {
  std::vector<std::vector<Sample>> curve;
  const auto fine = make(parts);
  for (const int n : {lines / 2, 3 * lines / 4, lines}) {
    const auto answer = solve(*fine, n);
    curve.resize(answer.size());
    for (std::size_t k = 0; k < answer.size(); ++k) curve[k].push_back({1.0 * n, answer[k]});
  }
  const auto rough = solve(*make(coarse), 3 * lines / 4);
  limits.resize(curve.size());
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double body = rough[k] - curve[k][1].value;
    Limit limit = extrapolate(curve[k]);
    limit.uncertainty = std::hypot(limit.uncertainty, body);
    limits[k].push_back(limit);
  }
}

RollingLimit rolling_limit(const Limit& longitudinal, const Limit& lateral, const Limit& moment) {
  return {{{longitudinal.value, lateral.value}, moment.value},
          std::hypot(longitudinal.uncertainty, lateral.uncertainty) / std::hypot(longitudinal.value, lateral.value),
          moment.uncertainty};
}

RollingLimit symmetric_limit(const Limit& longitudinal) {
  return rolling_limit(longitudinal, {}, {});
}

void add_size(Record& record, double across, double uncertainty) {
  record.extra.emplace_back("across", across);
  record.extra.emplace_back("uncertainty", uncertainty);
}

void Study::add(Record record, double across, bool trusted) {
  entries_.push_back({std::move(record), {}, across, trusted});
}

void Study::add(Record record, const scenes::RollingAnswer& found, double across, bool trusted) {
  record.value = found.force[0];
  record.extra.emplace_back("lateral", found.force[1]);
  record.extra.emplace_back("moment", found.moment);
  entries_.push_back({std::move(record), found, across, trusted});
}

Limit Study::limit(const std::string& extra) const {
  std::map<std::string, std::vector<Sample>> curves;
  for (const Entry& e : entries_)
    if (e.trusted)
      curves[e.record.method + e.record.model + e.record.element].push_back(
          {e.across, extra.empty() ? e.record.value : extra_of(e.record, extra)});
  std::vector<Limit> limits;
  for (auto& [name, curve] : curves) limits.push_back(extrapolate(std::move(curve)));
  return combine(limits);
}

void Study::compare(const std::string& name, const Limit& limit) {
  for (Entry& e : entries_) {
    const double error = extra_of(e.record, name) / limit.value - 1;
    e.record.extra.emplace_back("error_" + name, error);
    e.record.extra.emplace_back("uncertainty_" + name, std::abs(limit.uncertainty / limit.value));
  }
}

void Study::emit(Runner& runner, const Limit& limit, const std::string& against) {
  const auto judge = [&](Record& record, std::size_t) { record.error = record.value / limit.value - 1; };
  emit(runner, judge, std::abs(limit.uncertainty / limit.value), against);
}

void Study::emit(Runner& runner, const RollingLimit& limit, const std::string& against) {
  const auto judge = [&](Record& record, std::size_t number) {
    record.judge(scenes::rolling_errors(entries_[number].found, limit.answer));
    record.extra.emplace_back("uncertainty_moment", limit.moment_uncertainty);
  };
  emit(runner, judge, limit.uncertainty, against);
}

void Study::emit(Runner& runner, const std::function<void(Record&, std::size_t number)>& judge, double uncertainty,
                 const std::string& against) {
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    Record& record = entries_[k].record;
    judge(record, k);
    record.against = against;
    add_size(record, entries_[k].across, uncertainty);
    runner.emit(record);
  }
  entries_.clear();
}

Solved cold_solve(const Runner& runner, Record& record, const MakePair& make) {
  const Record blank = record;
  Solved best;
  double spent = 0;
  for (int k = 0; k < (runner.quick ? 1 : most_repeats) && spent < repeat_below; ++k) {
    Record attempt = blank;
    const double began = now();
    Solved solved{make(), {}};
    solved.solution = timed_solve(*solved.pair, attempt, began);
    spent += attempt.seconds;
    if (best.pair && attempt.seconds >= record.seconds) continue;
    record = attempt;
    best = std::move(solved);
  }
  add_bodies(record, *best.pair);
  return best;
}

double warm_solve(const Runner& runner, scenes::RollingPair& pair, const std::array<double, 3>& creep) {
  double best = std::numeric_limits<double>::max(), spent = 0;
  // A prediction would be the solution where the creepage is back where it came from.
  pair.option("warm_start", std::int64_t{1});
  for (int k = 0; k < (runner.quick ? 1 : most_repeats) && spent < repeat_below; ++k) {
    pair.creep(1.01 * creep[0], creep[1], creep[2]);
    pair.solve();
    pair.creep(creep[0], creep[1], creep[2]);
    const double began = now();
    pair.solve();
    best = std::min(best, now() - began);
    spent += now() - began;
  }
  return best;
}

void solve_by_schemes(const Runner& runner, const Record& blank, const MakePair& make,
                      const std::function<void(Record&, const Solved&)>& finish) {
  Solved solved;
  double prepared = 0;
  for (const char* scheme : scenes::schemes) {
    Record record = blank;
    record.method = scheme;
    if (!solved.pair) {
      solved = cold_solve(runner, record, [&] {
        auto pair = make();
        pair->option("convection", scheme);
        return pair;
      });
      prepared = record.seconds - (solved.pair->stat("seconds_total") - solved.pair->stat("seconds_compliance"));
    } else {
      const double began = now();
      solved.pair->option("convection", scheme).reset();
      solved.solution = timed_solve(*solved.pair, record, began);
      record.seconds += prepared;
      add_bodies(record, *solved.pair);
    }
    finish(record, solved);
  }
}

void add_bodies(Record& record, const scenes::RollingPair& pair) {
  std::map<std::string, double> seconds;
  double bytes = 0, unknowns = 0;
  for (const int which : {1, 2}) {
    if (!has_mesh(pair.body(which)) || (which == 2 && pair.body(1) == pair.body(2))) continue;
    for (const char* phase : {"assembly", "order", "factor", "condense"})
      seconds[phase] += pair.body_stat(which, (std::string("seconds_") + phase).c_str());
    bytes += pair.body_stat(which, "peak_bytes");
    unknowns += pair.body_stat(which, "unknowns");
  }
  if (seconds.empty()) return;
  record.phase_seconds.insert(record.phase_seconds.end(), seconds.begin(), seconds.end());
  record.peak_bytes += std::llround(bytes);
  record.extra.emplace_back("body_unknowns", unknowns);
}

}  // namespace rollcon::bench
