// The Hertzian contact that stands for a patch of a wheel on its rail (rollcon_contact_get_equivalent_ellipse): forces
// and moment of the standard creep-force table from it, beside those of the patch's own solution. S1002 on 60E1, the
// Manchester benchmark's shifts, yaw and speeds about those of free rolling.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench.hpp"
#include "rollcon.h"
#include "statistics.hpp"
#include "support/frames.hpp"

namespace rollcon::bench {
namespace {

constexpr double mu = 0.3, load = 10000, shear = 82000, poisson = 0.28, speed = 2000, radius = 460;

void must(std::int32_t status) {
  if (status < 0) throw std::runtime_error(rollcon_last_error());
}

struct Errors {
  const char* patches;
  std::vector<double> force{}, moment{};
};

class Comparison {
 public:
  Comparison() {
    must(rollcon_context_create(ROLLCON_ABI, &context_));
    must(rollcon_table_standard(context_, &table_));
    const double unit = 1;
    const char* shape[] = {"s1002", "60e1"};
    for (std::size_t b = 0; b < 2; ++b) {
      must(rollcon_body_create(context_, ROLLCON_BODY_HALFSPACE, &body_[b]));
      must(rollcon_body_set_elastic(body_[b], 0, 2 * shear * (1 + poisson), poisson));
      must(rollcon_body_set_profile_shape(body_[b], shape[b], 1, &unit));
    }
    for (std::size_t side = 0; side < 2; ++side) {
      must(rollcon_wheelrail_create(context_, body_[0], body_[1], side == 0 ? ROLLCON_RIGHT : ROLLCON_LEFT,
                                    &wheel_[side]));
      must(rollcon_wheelrail_set_track(wheel_[side], 1435, 14, std::atan(1.0 / 40)));
      must(rollcon_wheelrail_set_wheelset(wheel_[side], 1360, -70, radius));
      must(rollcon_wheelrail_set_friction(wheel_[side], mu));
      must(rollcon_wheelrail_set_accuracy(wheel_[side], 0.005));
      must(rollcon_wheelrail_prescribe_vertical(wheel_[side], ROLLCON_BY_FORCE, load));
    }
  }
  ~Comparison() {
    for (rollcon_wheelrail* wheel : wheel_) rollcon_wheelrail_release(wheel);
    for (rollcon_body* body : body_) rollcon_body_release(body);
    rollcon_table_release(table_);
    rollcon_context_release(context_);
  }
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  /// Both wheels at a shift with creepages of their own.
  void add(double y, frames::Random& random, std::vector<Errors>& errors, std::int64_t& refused) {
    for (rollcon_wheelrail* wheel : wheel_) {
      const double position[6] = {0, y, 0, 0, 2.4e-3 * y + 2e-3 * random(), 0};
      const double velocity[6] = {speed, 0, 0, 0, 1e-3 * random(), -speed / radius * (1 + 2e-3 * random())};
      must(rollcon_wheelrail_set_position(wheel, position));
      must(rollcon_wheelrail_set_velocity(wheel, velocity));
      if (rollcon_wheelrail_solve(wheel) != ROLLCON_OK) continue;
      std::int64_t patches = 0;
      must(rollcon_wheelrail_get_patch_count(wheel, &patches));
      for (std::int64_t i = 0; i < patches; ++i) {
        rollcon_contact* contact = nullptr;
        must(rollcon_wheelrail_get_contact(wheel, i, &contact));
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
  rollcon_body* body_[2] = {};
  rollcon_wheelrail* wheel_[2] = {};
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
