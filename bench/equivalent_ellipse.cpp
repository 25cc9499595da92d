// Compares the Hertzian contact that stands for a patch of a wheel on its rail
// (rollcon_contact_get_equivalent_ellipse): forces and moment of the standard creep-force table from it, with those of
// the patch's own solution. The scenes are S1002 on 60E1, the Manchester benchmark's shifts, yaw and speeds about those
// of free rolling.

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench.hpp"
#include "statistics.hpp"
#include "support/frames.hpp"
#include "wheels.hpp"

namespace rollcon::bench {
namespace {

struct Errors {
  const char* patches;
  std::vector<double> force{}, moment{};
};

class Comparison {
 public:
  Comparison() {
    must(rollcon_context_create(ROLLCON_ABI, &context_));
    must(rollcon_table_standard(context_, &table_));
  }
  ~Comparison() {
    rollcon_table_release(table_);
    rollcon_context_release(context_);
  }
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  /// Adds both wheels at a shift with creepages of their own.
  void add(double y, frames::Random& random, std::vector<Errors>& errors, std::int64_t& refused) {
    for (Wheel* wheel : {&right_, &left_}) {
      const double position[6] = {0, y, 0, 0, 2.4e-3 * y + 2e-3 * random(), 0};
      const double velocity[6] = {
          Wheel::speed, 0, 0, 0, 1e-3 * random(), -Wheel::speed / Wheel::radius * (1 + 2e-3 * random())};
      if (wheel->solve(position, velocity) != ROLLCON_OK) continue;
      std::int64_t patches = 0;
      must(rollcon_wheelrail_get_patch_count(wheel->handle(), &patches));
      for (std::int64_t i = 0; i < patches; ++i) {
        rollcon_contact* contact = nullptr;
        must(rollcon_wheelrail_get_contact(wheel->handle(), i, &contact));
        if (!compare(contact, errors)) ++refused;
        rollcon_contact_release(contact);
      }
    }
  }

 private:
  bool compare(const rollcon_contact* contact, std::vector<Errors>& errors) const {
    double in[9], center[2], f[3], force[3], moment[3];
    if (rollcon_contact_get_equivalent_ellipse(contact, in, center) != ROLLCON_OK) return false;
    must(rollcon_table_evaluate(table_, 1, in, f));
    must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment));
    const double bound = in[2] * in[5], about_center = moment[2] - center[0] * force[1] + center[1] * force[0];
    const double f_off = std::hypot(f[0] - force[0], f[1] - force[1]) / bound;
    const double m_off = std::abs(f[2] - about_center) / (bound * std::sqrt(in[3] * in[4]));
    const bool long_ones = std::max(in[3] / in[4], in[4] / in[3]) > 3;
    for (Errors* e : {&errors[0], &errors[long_ones ? 2 : 1]}) e->force.push_back(f_off), e->moment.push_back(m_off);
    return true;
  }

  rollcon_context* context_ = nullptr;
  rollcon_table* table_ = nullptr;
  Wheel right_{0.005, true, CreepForces::solved}, left_{0.005, true, CreepForces::solved, ROLLCON_LEFT};
};

void run(Runner& runner) {
  Comparison comparison;
  frames::Random random(20261125);
  std::vector<Errors> errors{{"all"}, {"axes up to 1 : 3"}, {"longer ones"}};
  std::int64_t refused = 0;
  const int shifts = 20, draws = runner.quick ? 1 : 20;
  for (int k = 0; k <= shifts; ++k)
    for (int i = 0; i < draws; ++i) comparison.add(10.0 * k / shifts, random, errors, refused);
  for (const Errors& e : errors) {
    if (e.force.empty()) continue;
    Record r{.case_name = "equivalent_ellipse", .method = "table"};
    r.model = "steel on steel";
    r.mesh = e.patches;
    r.quantity = "root mean square error of the force over mu Fn";
    r.against = "the patch's own solution";
    r.value = r.error = rms(e.force);
    r.moment_error = rms(e.moment);
    r.extra = {{"patches", static_cast<double>(e.force.size())},
               {"refused", static_cast<double>(refused)},
               {"force_median", quantile(e.force, 0.5)},
               {"force_90", quantile(e.force, 0.9)},
               {"force_worst", quantile(e.force, 1)},
               {"moment_median", quantile(e.moment, 0.5)},
               {"moment_90", quantile(e.moment, 0.9)},
               {"moment_worst", quantile(e.moment, 1)}};
    runner.emit(r);
  }
}

}  // namespace

std::vector<Case> equivalent_ellipse_cases() {
  return {{"equivalent_ellipse", "creep-force tables for patches of wheels on rails", run}};
}

}  // namespace rollcon::bench
