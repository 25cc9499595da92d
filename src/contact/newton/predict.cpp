/// A warm start moved on along the line of the last change, where that lowers the error function.

#include <cmath>

#include "contact/newton/newton.hpp"
#include "support/index.hpp"

namespace rollcon {

// The iterate is still the last solution.
void Newton::begin_prediction() {
  const Problem& p = *problem_;
  prediction_ratio_ = 0;
  if (!predict) return;
  prediction_.reserve(p.nodes);
  prediction_.begin(p, *iterate_);
  double friction = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k)
    friction -= p.mu[k] * p.weight[k] * iterate_->lambda[2][k];
  std::array<double, 4> weight{};
  for (const int m : {xi1, xi2, spin})
    weight[at(m)] = p.by_force[at(m)] ? friction * (m == spin ? p.length : 1) : creep_scale(m);
  weight[approach] =
      p.by_force[approach] ? p.value[approach] : std::abs(iterate_->motion[approach]);
  prediction_ratio_ = prediction_.ratio(p, weight);
}

// Images of the extrapolated tractions are extrapolated too. They are not brought back to where the
// laws admit them: the step after that does it, and the error function counts it.
bool Newton::start_predicted(Part part) {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  const double ratio = prediction_ratio_;
  if (ratio == 0 || has_frozen_) return false;
  const bool normal = part != Part::tangential, tangential = part != Part::normal;
  if (normal && !p.op.field && !prediction_.gaps_known(p, it)) return false;
  for (int c = 0; c < 3; ++c) {
    if (c == 2 ? normal : tangential) {
      prediction_.tractions(it, ratio, c, next_[c]);
      prediction_.image(it, ratio, c, next_image_[c]);
    } else {
      next_[c] = it.lambda[c];
    }
  }
  for (int m = 0; m < 4; ++m) {
    const bool own = m == approach ? normal : tangential;
    next_motion_[at(m)] =
        own && p.by_force[at(m)] ? prediction_.motion(it, ratio, m) : it.motion[at(m)];
  }
  if (p.op.field) {
    take_step_field(part);
  } else if (tangential) {
    for (const std::int32_t i : active_) {
      const std::size_t k = at(i);
      if (prediction_.slip_known(it, k)) continue;
      for (int r = 0; r < 2; ++r) {
        double sum = 0;
        for (int c = 0; c < 3; ++c)
          if (!p.op.block[r][c].empty())
            sum += dot(p.op.block[r][c].row(i), next_[c].data(), p.nodes);
        next_image_[r][k] = sum;
      }
    }
  }
  if (!(trial_merit(part, 1) < trial_merit(part, 0))) return false;
  advance(part, 1);
  ++report_.predictions;
  return true;
}

}  // namespace rollcon
