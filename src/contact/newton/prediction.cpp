#include "contact/newton/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollcon {
namespace {

constexpr double farthest = 2;  // steps beyond the last solution, in steps before it
constexpr double astray = 0.5;  // fraction of the change that may lie off the line

}  // namespace

// Reserves storage, so that a time loop allocates nothing as it goes on.
void Prediction::reserve(std::int64_t nodes) {
  for (Iterate* it : {&last_, &before_})
    if (it->lambda[2].size() != static_cast<std::size_t>(nodes)) {
      it->resize(nodes);
      forget();
    }
}

void Prediction::begin(const Prescribed& given, const Iterate& last) {
  now_ = given;
  if (!solved_) return;
  last_ = last;
}

void Prediction::solved() {
  if (solved_) {
    std::swap(before_, last_);
    at_before_ = at_last_;
    known_ = true;
  }
  at_last_ = now_;
  solved_ = true;
}

void Prediction::move_datum(double change) {
  for (Iterate* it : {&last_, &before_}) it->motion[approach] -= change;
  for (Prescribed* p : {&at_last_, &at_before_})
    if (!p->by_force[approach]) p->value[approach] -= change;
}

double Prediction::ratio(const Prescribed& given, std::size_t nodes, const MotionValues& weight) const {
  if (!known_ || at_before_.by_force != given.by_force || at_last_.by_force != given.by_force) return 0;
  if (before_.lambda[2].size() != nodes) return 0;
  double along = 0, before = 0, now = 0;
  for (std::size_t m = 0; m < motion_count; ++m) {
    if (!(weight[m] > 0)) continue;
    const double a = (at_last_.value[m] - at_before_.value[m]) / weight[m];
    const double b = (given.value[m] - at_last_.value[m]) / weight[m];
    along += a * b, before += a * a, now += b * b;
  }
  if (!(before > 0) || !(now > 0) || !std::isfinite(along)) return 0;
  const double ratio = along / before;
  if (now - ratio * along > astray * astray * now) return 0;
  return std::clamp(ratio, -1.0, farthest);
}

void Prediction::tractions(const Iterate& last, double ratio, int c, std::vector<double>& lambda) const {
  const auto &new_one = last.lambda[c], &old_one = before_.lambda[c];
  for (std::size_t k = 0; k < lambda.size(); ++k) lambda[k] = new_one[k] + ratio * (new_one[k] - old_one[k]);
}

void Prediction::image(const Iterate& last, double ratio, int c, std::vector<double>& image) const {
  const auto &new_one = last.image[c], &old_one = before_.image[c];
  for (std::size_t k = 0; k < image.size(); ++k) image[k] = new_one[k] + ratio * (new_one[k] - old_one[k]);
}

double Prediction::motion(const Iterate& last, double ratio, int m) const {
  const auto k = static_cast<std::size_t>(m);
  return last.motion[k] + ratio * (last.motion[k] - before_.motion[k]);
}

bool Prediction::gaps_known(const Problem& p, const Iterate& last) const {
  for (std::size_t k = 0; k < p.used.size(); ++k)
    if (p.used[k] && !(last.gap_valid[k] && before_.gap_valid[k])) return false;
  return true;
}

std::size_t Prediction::bytes() const {
  std::size_t sum = 0;
  for (const Iterate* it : {&last_, &before_})
    for (int c = 0; c < 3; ++c) sum += (it->lambda[c].capacity() + it->image[c].capacity()) * sizeof(double);
  return sum;
}

}  // namespace rollcon
