#include "bodies/model/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "support/error.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

std::vector<PronyTerm> checked_relaxation(std::int64_t n, const double* ratios, const double* times) {
  constexpr std::int64_t most_terms = 100;
  constexpr double least_left = 1e-6, shortest = 1e-60, longest = 1e60;
  if (!(n >= 0 && n <= most_terms))
    fail(Status::err_argument, "n is %lld; allowed: 0 (none) to %lld terms", static_cast<long long>(n),
         static_cast<long long>(most_terms));
  std::vector<PronyTerm> term;
  if (n == 0) return term;
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
    if (ratios[k] > 0) term.push_back({ratios[k], times[k]});
  }
  if (!(1 - sum >= least_left))
    fail(
        Status::err_argument,
        "the ratios add up to %.9g; allowed: below 1, up to 1 - %g: the rest is what is left of Young's modulus in the "
        "end",
        sum, least_left);
  std::sort(term.begin(), term.end(), [](const PronyTerm& a, const PronyTerm& b) { return a.time < b.time; });
  std::vector<PronyTerm> merged;
  for (const PronyTerm& t : term) {
    if (!merged.empty() && merged.back().time == t.time)
      merged.back().ratio += t.ratio;
    else
      merged.push_back(t);
  }
  return merged;
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
