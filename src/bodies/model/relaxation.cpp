#include "bodies/model/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "linalg/lapack.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

using Complex = std::complex<double>;

/// Returns x >= 0 that minimises x' g x / 2 - h' x, by Lawson and Hanson's active sets.
std::vector<double> non_negative_minimum(const std::vector<double>& g, const std::vector<double>& h) {
  constexpr double little = 1e-12;
  const std::size_t n = h.size();
  std::vector<double> x(n, 0.0);
  std::vector<std::uint8_t> tried(n, 0);
  std::vector<std::size_t> active;
  for (std::size_t round = 0; round < 3 * n; ++round) {
    std::size_t best = n;
    double steepest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double slope = h[i];
      for (const std::size_t k : active) slope -= g[i * n + k] * x[k];
      if (x[i] == 0 && !tried[i] && slope > little * h[i] && slope / std::sqrt(g[i * n + i]) > steepest)
        best = i, steepest = slope / std::sqrt(g[i * n + i]);
    }
    if (best == n) return x;
    tried[best] = 1;
    for (active.push_back(best); !active.empty();) {
      const int m = static_cast<int>(active.size()), one = 1;
      std::vector<double> a(active.size() * active.size()), s;
      for (std::size_t i = 0; i < active.size(); ++i) {
        s.push_back(h[active[i]]);
        for (std::size_t k = 0; k < active.size(); ++k)
          a[i * active.size() + k] = g[active[i] * n + active[k]] * (i == k ? 1 + little : 1);
      }
      int info = 0;
      const double unit = 1;
      dpotrf_("L", &m, a.data(), &m, &info);
      dtrsm_("L", "L", "N", "N", &m, &one, &unit, a.data(), &m, s.data(), &m);
      dtrsm_("L", "L", "T", "N", &m, &one, &unit, a.data(), &m, s.data(), &m);
      double part = 1;  // fraction of the way to s
      for (std::size_t i = 0; i < active.size(); ++i)
        if (!(s[i] > 0)) part = std::min(part, x[active[i]] / (x[active[i]] - s[i]));
      if (info != 0) part = 0;
      for (std::size_t i = 0; i < active.size(); ++i) x[active[i]] += part * (s[i] - x[active[i]]);
      if (part == 1) {
        std::fill(tried.begin(), tried.end(), std::uint8_t{0});
        break;
      }
      std::size_t least = active.size() - 1;
      for (std::size_t i = 0; i < active.size(); ++i)
        if (!(s[i] > 0) && x[active[i]] <= x[active[least]]) least = i;
      x[active[least]] = 0;
      active.erase(active.begin() + static_cast<std::ptrdiff_t>(least));
    }
  }
  return x;
}

/// Fits a Prony series to moduli given as they are, and returns the modulus at once.
double fit_terms(const std::vector<ModulusPoint>& point, std::vector<PronyTerm>& term) {
  constexpr double per_decade = 8, most = 98;
  const double first = std::log10(point.front().frequency) - 1, last = std::log10(point.back().frequency) + 1;
  const int count = static_cast<int>(std::min(most, std::ceil(per_decade * (last - first))));
  const std::size_t n = at(count) + 2;  // the modulus in the end comes first
  const auto part = [&](std::size_t k, double frequency) {
    if (k == 0) return Complex{1, 0};
    const double time = std::pow(10, -last + (last - first) * static_cast<double>(k - 1) / count);
    return 1.0 - 1.0 / Complex{1, frequency * time};
  };
  std::vector<double> g(n * n, 0.0), h(n, 0.0);
  for (const ModulusPoint& p : point) {
    const Complex given{p.storage, p.loss};
    for (std::size_t i = 0; i < n; ++i) {
      const Complex own = std::conj(part(i, p.frequency)) / std::norm(given);
      h[i] += (own * given).real();
      for (std::size_t k = 0; k < n; ++k) g[i * n + k] += (own * part(k, p.frequency)).real();
    }
  }
  std::vector<double> modulus = non_negative_minimum(g, h);
  constexpr double least_left = 1e-5;
  modulus[0] = std::max(modulus[0], least_left * std::accumulate(modulus.begin(), modulus.end(), 0.0));
  const double young = std::accumulate(modulus.begin(), modulus.end(), 0.0);
  for (std::size_t k = 1; k < n; ++k)
    if (modulus[k] > 0)
      term.push_back({modulus[k] / young, std::pow(10, -last + (last - first) * static_cast<double>(k - 1) / count)});
  return young;
}

}  // namespace

std::complex<double> Relaxation::modulus(double frequency) const {
  if (point.empty()) {
    Complex value = 1;
    for (const PronyTerm& t : term) value -= t.ratio / Complex{1, frequency * t.time};
    return value;
  }
  if (frequency < 0) return std::conj(modulus(-frequency));
  const ModulusPoint &first = point.front(), &last = point.back();
  if (frequency <= first.frequency) return {first.storage, first.loss * frequency / first.frequency};
  if (frequency >= last.frequency) return {last.storage, last.loss * last.frequency / frequency};
  const auto next = std::find_if(point.begin(), point.end(), [&](auto& p) { return p.frequency > frequency; });
  const ModulusPoint &a = next[-1], &b = *next;
  const double part = std::log(frequency / a.frequency) / std::log(b.frequency / a.frequency);
  return {a.storage + part * (b.storage - a.storage), a.loss + part * (b.loss - a.loss)};
}

Relaxation checked_moduli(std::int64_t n, const double* frequencies, const double* storage, const double* loss,
                          double& young) {
  constexpr std::int64_t most_points = 10'000;
  constexpr double least = 1e-60, most = 1e60;
  if (!(n >= 0 && n <= most_points))
    fail(Status::err_argument, "n is %lld; allowed: 0 (none) to %lld points", static_cast<long long>(n),
         static_cast<long long>(most_points));
  Relaxation found;
  if (n == 0) return found;
  require_list(n, frequencies, "frequencies");
  require_list(n, storage, "storage");
  require_list(n, loss, "loss");
  for (std::int64_t k = 0; k < n; ++k) {
    const auto entry = static_cast<long long>(k);
    const double before = k > 0 ? frequencies[k - 1] : 0;
    if (!(frequencies[k] > before && frequencies[k] >= least && frequencies[k] <= most))
      fail(Status::err_argument,
           "entry %lld of frequencies (counting from 0) is %g after %g; allowed: ascending, from %g to %g", entry,
           frequencies[k], before, least, most);
    if (!(storage[k] >= least && storage[k] <= most))
      fail(Status::err_argument, "entry %lld of storage (counting from 0) is %g; allowed: > 0, from %g to %g", entry,
           storage[k], least, most);
    if (!(loss[k] >= 0 && loss[k] <= most))
      fail(Status::err_argument, "entry %lld of loss (counting from 0) is %g; allowed: >= 0, up to %g", entry, loss[k],
           most);
    found.point.push_back({frequencies[k], storage[k], loss[k]});
  }
  young = fit_terms(found.point, found.term);
  const std::vector<ModulusPoint> given = std::exchange(found.point, {});
  for (ModulusPoint p : given) {
    p.storage /= young, p.loss /= young;
    const Complex own{p.storage, p.loss};
    found.misfit = std::max(found.misfit, std::abs(found.modulus(p.frequency) - own) / std::abs(own));
  }
  for (const ModulusPoint& p : given) found.point.push_back({p.frequency, p.storage / young, p.loss / young});
  return found;
}

std::vector<PronyTerm> checked_relaxation(std::int64_t n, const double* ratios, const double* times) {
  constexpr std::int64_t most_terms = 100;
  constexpr double least_left = 1e-6, shortest = 1e-60, longest = 1e60;
  if (!(n >= 0 && n <= most_terms))
    fail(Status::err_argument, "n is %lld; allowed: 0 (none) to %lld terms", static_cast<long long>(n),
         static_cast<long long>(most_terms));
  std::vector<PronyTerm> term;
  if (n == 0) return term;
  std::map<double, double> ratio_of;  // by time
  require_list(n, ratios, "ratios");
  require_list(n, times, "times");
  double sum = 0;
  for (std::int64_t k = 0; k < n; ++k) {
    const auto entry = static_cast<long long>(k);
    if (!(ratios[k] >= 0 && ratios[k] < 1))
      fail(Status::err_argument, "entry %lld of ratios (counting from 0) is %g; allowed: 0 <= ratio < 1", entry,
           ratios[k]);
    if (!(times[k] >= shortest && times[k] <= longest))
      fail(Status::err_argument, "entry %lld of times (counting from 0) is %g; allowed: > 0, from %g to %g", entry,
           times[k], shortest, longest);
    sum += ratios[k];
    if (ratios[k] > 0) ratio_of[times[k]] += ratios[k];
  }
  if (!(1 - sum >= least_left))
    fail(
        Status::err_argument,
        "the ratios add up to %.9g; allowed: below 1, up to 1 - %g: the rest is what is left of Young's modulus in the "
        "end",
        sum, least_left);
  for (const auto& [time, ratio] : ratio_of) term.push_back({ratio, time});
  return term;
}

// With E(s) / E0 = 1 - sum of g / (1 + s tau), 1 / E(s) = (1 + sum of f / (1 + s T)) / E0 has a pole -1 / T at each
// zero of E, one between tau_k and the next longer time, the last one beyond all; f = T / (dE/ds / E0) there.
std::vector<PronyTerm> creep_of(const std::vector<PronyTerm>& relaxation) {
  constexpr int halvings = 200;
  std::vector<PronyTerm> creep;
  double left = 1;
  for (const PronyTerm& g : relaxation) left -= g.ratio;
  for (std::size_t k = 0; k < relaxation.size(); ++k) {
    const double from = relaxation[k].time;
    // T counts from tau_k, which it comes close to where the ratio is small.
    const auto beyond = [&](double off, std::size_t j) { return off + (from - relaxation[j].time); };
    double low = 0, high = k + 1 < relaxation.size() ? relaxation[k + 1].time - from : from * (1 / left - 1);
    for (int i = 0; i < halvings && low < high; ++i) {
      const double middle = low + 0.5 * (high - low);
      if (middle == low || middle == high) break;
      double sum = 0;
      for (std::size_t j = 0; j < relaxation.size(); ++j)
        sum += relaxation[j].ratio * (from + middle) / beyond(middle, j);
      (sum > 1 ? low : high) = middle;
    }
    const double off = low + 0.5 * (high - low), time = from + off;
    double slope = 0;
    for (std::size_t j = 0; j < relaxation.size(); ++j) {
      const double r = time / beyond(off, j);  // 1 / (1 - tau / T)
      slope += relaxation[j].ratio * (relaxation[j].time / time) * r * r;
    }
    creep.push_back({1 / slope, time});
  }
  return creep;
}

}  // namespace rollcon
