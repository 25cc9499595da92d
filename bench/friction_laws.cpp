// Measures what laws of friction cost beside Coulomb's: the same scenes from nothing under each of them, in turns, so
// that loads of the machine fall on all alike.

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::bench {
namespace {

namespace steady_rolling = scenes::steady_rolling;

struct Law {
  const char *label, *name;
  std::vector<double> parameter;
};

void run(Runner& runner) {
  // The speed of rolling is 1, so slip speeds are creepages. The second and third laws tell what less friction costs
  // from what a law costs.
  const Law laws[] = {{"coulomb", "coulomb", {0.3}},
                      {"coulomb, 0.2", "coulomb", {0.2}},
                      {"orthotropic, equal", "orthotropic", {0.3, 0.3, 0.6}},
                      {"orthotropic", "orthotropic", {0.3, 0.2, 0.6}},
                      {"orthotropic_collinear", "orthotropic_collinear", {0.3, 0.2, 0.6}},
                      {"linear", "linear", {0.15, 0.15, 3e-3}},
                      {"rational", "rational", {0.15, 0.15, 3e-3}},
                      {"exponential", "exponential", {0.15, 0.15, 3e-3}}};
  constexpr std::size_t count = std::size(laws);
  for (const bool like : {true, false})
    for (const int n : {24, 48, 96}) {
      if (runner.quick && n > 24) continue;
      if (!like && n > 48) continue;
      const int rounds = n > 48 ? 5 : 9;
      std::vector<double> seconds[count];
      std::int64_t iterations[count] = {};
      scenes::RollingPair pair(steady_rolling::steel,
                               like ? steady_rolling::steel : scenes::Elastic{.shear = 30000, .poisson = 0.4},
                               runner.threads);
      steady_rolling::prepare(pair, steady_rolling::grid(n), "b");
      for (int round = 0; round < rounds; ++round)
        for (std::size_t l = 0; l < count; ++l) {
          if (rollcon_contact_set_friction(pair.handle(), laws[l].name,
                                           static_cast<std::int32_t>(laws[l].parameter.size()),
                                           laws[l].parameter.data()) < 0)
            throw std::runtime_error(laws[l].name);
          pair.reset();
          const double began = now();
          pair.solve();
          if (round > 0) seconds[l].push_back(now() - began);  // the first round assembles
          iterations[l] = static_cast<std::int64_t>(pair.stat("iterations"));
        }
      double coulomb = 0;
      for (std::size_t l = 0; l < count; ++l) {
        std::sort(seconds[l].begin(), seconds[l].end());
        const double middle = seconds[l][seconds[l].size() / 2];
        if (l == 0) coulomb = middle;
        Record record{.case_name = "friction_laws", .method = laws[l].label, .model = like ? "like" : "unlike"};
        record.mesh = "grid " + std::to_string(n);
        record.threads = runner.threads;
        record.quantity = "seconds of a solve from nothing over those of Coulomb's law";
        record.against = "coulomb";
        record.value = middle / coulomb;
        record.seconds = middle;
        record.iterations = iterations[l];
        runner.emit(record);
      }
    }
}

}  // namespace

std::vector<Case> friction_law_cases() {
  return {{"friction_laws", "laws of friction beside Coulomb's: time of a solve", run}};
}

}  // namespace rollcon::bench
