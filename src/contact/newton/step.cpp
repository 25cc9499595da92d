/// Takes one step of Newton's iteration: the linear system, the line search along its solution, and what the step makes
/// of the images at hand.

#include <algorithm>
#include <cmath>

#include "contact/newton/iteration.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::size_t merit_window = 5;
constexpr double sufficient_decrease = 1e-4;
constexpr double smallest_step = 1.0 / 64;

double blend(double from, double to, double alpha) {
  return alpha == 0 ? from : from + alpha * (to - from);
}

/// Gives values of the laws on the way to the next iterate. Slip is known at the active nodes.
struct OnTheWay {
  static constexpr bool trial = true;
  const Problem& p;
  const Iterate& it;
  const std::vector<double> (&next)[3];
  const std::vector<double> (&next_image)[3];
  const std::vector<std::uint8_t>& active;
  const MotionValues motion;
  const double alpha;

  double lambda(int c, std::size_t k) const { return blend(it.lambda[c][k], next[c][k], alpha); }
  double image(int c, std::size_t k) const { return blend(it.image[c][k], next_image[c][k], alpha); }
  SummedGap gap(std::size_t k) const { return {p.rigid_gap(k, motion) - image(2, k), 0}; }
  bool slip_known(std::size_t k) const { return active[k] != 0; }
  SummedSlip slip(std::size_t k) const {
    const auto i = static_cast<std::int64_t>(k);
    return {p.rigid_slip1(i, motion) + image(0, k), p.rigid_slip2(i, motion) + image(1, k), 0};
  }
};

}  // namespace

// Interpolates the loads, which are linear in the tractions.
double NewtonIteration::load_error_at(Part part, double alpha) const {
  return load_error(*given_, part, [&](int m) {
    LoadSum sum = load_on_body1(*problem_, m, iterate_->lambda);
    if (alpha == 0) return sum;
    const LoadSum next = load_on_body1(*problem_, m, next_);
    sum.value += alpha * (next.value - sum.value);
    sum.magnitude = std::max(sum.magnitude, next.magnitude);
    return sum;
  });
}

double NewtonIteration::trial_merit(Part part, double alpha) const {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  MotionValues motion = it.motion;
  for (std::size_t m = 0; m < motion_count; ++m) motion[m] = blend(motion[m], next_motion_[m], alpha);
  const LawSums sums = sum_laws(p, *given_, part, OnTheWay{p, it, next_, next_image_, is_active_, motion, alpha},
                                [](std::size_t, bool, bool) {});
  return merit_of(sums, scales_, load_error_at(part, alpha), static_cast<std::int64_t>(active_.size()));
}

void NewtonIteration::freeze_other_part(Part part) {
  const Problem& p = *problem_;
  has_frozen_ = p.op->coupled && part != Part::full;
  if (!has_frozen_) return;
  listed_.clear();
  for (std::size_t k = 0; k < at(p.nodes); ++k)
    if (p.used[k]) listed_.push_back(static_cast<std::int32_t>(k));
  const bool own = part == Part::normal;
  p.op->images(own ? normal_component : slip_components, own ? slip_components : normal_component, listed_,
               iterate_->lambda, frozen_);
}

TangentialLaw NewtonIteration::law_of(Part part, std::int32_t node, bool bound_follows) const {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  const std::size_t k = at(node);
  double pressure = -it.lambda[2][k];
  if (part == Part::full) pressure = -(it.lambda[2][k] + p.rn[k] * (p.rigid_gap(k, it.motion) - it.image[2][k]));
  return linearise_friction(p, *given_, k, it.lambda, p.rigid_slip1(node, it.motion) + it.image[0][k],
                            p.rigid_slip2(node, it.motion) + it.image[1][k], pressure, bound_follows);
}

// Takes the images at hand after a step for the product of the system with the iterate. Returns false where nodes that
// have just left the contact still carry tractions. The first step of a run makes the product anew, lest rounding adds
// up over solves.
bool NewtonIteration::take_product(Part part) {
  if (!images_fresh_) return false;
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  const int first = has_tangential(part) ? 0 : 2, last = has_normal(part) ? 2 : 1;
  for (std::size_t k = 0; k < at(p.nodes); ++k)
    for (int c = first; c <= last && !is_active_[k]; ++c)
      if (it.lambda[c][k] != 0) return false;
  const std::size_t na = active_.size();
  product_.resize(at(system_.components()) * na);
  for (int r = 0; r < system_.components(); ++r) {
    const int c = system_.component(r);
    for (std::size_t a = 0; a < na; ++a) {
      const std::size_t k = at(active_[a]);
      product_[at(r) * na + a] = system_.scale_of(c, a) * (it.image[c][k] - (has_frozen_ ? frozen_[c][k] : 0));
    }
  }
  return true;
}

// Fills next_, next_image_ and next_motion_ with the solution of the linearised problem.
bool NewtonIteration::newton_step(Part part, bool stick, double forcing) {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  const Prescribed& given = *given_;
  const std::size_t na = active_.size();
  system_.gather(p, given, part, active_, it.lambda, rows_changed_);
  rows_changed_ = false;
  MotionValues known = it.motion;
  for (std::size_t m = 0; m < motion_count; ++m) known[m] = given.by_force[m] ? 0 : given.value[m];
  for (auto& v : known_) v.resize(na);
  for (std::size_t a = 0; a < na; ++a) {
    const std::int32_t i = active_[a];
    const std::size_t k = at(i);
    if (has_normal(part)) known_[2][a] = p.rigid_gap(k, known) - (has_frozen_ ? frozen_[2][k] : 0);
    if (!has_tangential(part)) continue;
    system_.law(static_cast<std::int64_t>(a)) =
        stick && given.coefficient(p.mu, k) > 0 ? stick_law() : law_of(part, i, part == Part::full);
    known_[0][a] = p.rigid_slip1(i, known) + (has_frozen_ ? frozen_[0][k] : 0);
    known_[1][a] = p.rigid_slip2(i, known) + (has_frozen_ ? frozen_[1][k] : 0);
  }
  system_.right_side(known_[2], known_[0], known_[1], b_);

  // The correction is solved for: the forcing term is then relative to the present residual.
  const std::size_t n = at(system_.size());
  x_.resize(n);
  jx_.resize(n);
  system_.start(it.lambda, it.motion, x_);
  if (take_product(part))
    system_.apply_known(x_.data(), product_, jx_.data());
  else
    system_.apply(x_.data(), jx_.data());
  images_fresh_ = true;
  product_.assign(system_.product().begin(), system_.product().end());
  for (std::size_t i = 0; i < n; ++i) b_[i] -= jx_[i];
  if (!linear.solve(system_, p.nodes, b_, forcing, correction_)) return false;
  for (std::size_t i = 0; i < n; ++i) x_[i] += correction_[i];
  take_step(part);
  return true;
}

// Makes tractions, motions and images of the step from the solution x_ and the products of the system.
void NewtonIteration::take_step(Part part) {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  const std::size_t na = active_.size();
  const std::span<const double> step_product = system_.product();
  for (int c = 0; c < 3; ++c) {
    if (c == 2 ? has_normal(part) : has_tangential(part))
      std::fill(next_[c].begin(), next_[c].end(), 0.0);
    else
      next_[c] = it.lambda[c];
  }
  for (int r = 0; r < system_.components(); ++r) {
    const int c = system_.component(r);
    for (std::size_t a = 0; a < na; ++a) {
      const std::size_t k = at(active_[a]), row = at(r) * na + a;
      next_[c][k] = x_[row];
      next_image_[c][k] =
          (product_[row] + step_product[row]) / system_.scale_of(c, a) + (has_frozen_ ? frozen_[c][k] : 0);
    }
  }
  for (int m = 0; m < int{motion_count}; ++m)
    next_motion_[at(m)] = has_motion(part, m) ? system_.motion(*given_, m, x_.data()) : it.motion[at(m)];
  if (p.op->all_at_once()) return p.op->images(components_of(part), {}, {}, next_, next_image_);
  if (!has_normal(part)) return;
  listed_.clear();
  for (std::size_t k = 0; k < at(p.nodes); ++k)
    if (p.used[k] && !is_active_[k]) listed_.push_back(static_cast<std::int32_t>(k));
  p.op->images(normal_component, {}, listed_, next_, next_image_);
}

// Follows a non-monotone Armijo rule with halving; the best step seen is taken when none satisfies it. The first steps
// of a warm start are taken whole (`free`): the merit of a solution of a neighbouring problem is far below that of
// every useful iterate.
double NewtonIteration::line_search(Part part, bool free) {
  if (free) {
    merits_.push_back(INFINITY);
    return 1;
  }
  if (merits_.size() == merit_window) merits_.erase(merits_.begin());
  merits_.push_back(trial_merit(part, 0));
  const double reference = *std::max_element(merits_.begin(), merits_.end());
  double best = 1, best_merit = INFINITY;
  for (double alpha = 1; alpha >= smallest_step; alpha /= 2) {
    const double trial = trial_merit(part, alpha);
    if (trial <= (1 - 2 * sufficient_decrease * alpha) * reference) return alpha;
    if (trial < best_merit) best = alpha, best_merit = trial;
  }
  return best;
}

void NewtonIteration::advance(Part part, double alpha) {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  const auto move = [alpha](double& from, double to) { from = alpha == 1 ? to : from + alpha * (to - from); };
  for (std::size_t m = 0; m < motion_count; ++m) move(it.motion[m], next_motion_[m]);
  const bool everywhere = p.op->all_at_once();  // the step's slip is known at all nodes
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    if (!p.used[k]) continue;
    for (int c = 0; c < 3; ++c)
      if (c == 2 ? has_normal(part) : has_tangential(part)) move(it.lambda[c][k], next_[c][k]);
    if (has_normal(part))
      move(it.image[2][k], next_image_[2][k]);
    else if (p.op->coupled)
      it.gap_valid[k] = 0;
    if (has_tangential(part) && (is_active_[k] || (everywhere && it.slip_valid[k]))) {
      move(it.image[0][k], next_image_[0][k]);
      move(it.image[1][k], next_image_[1][k]);
    } else if (has_tangential(part) || p.op->coupled) {
      it.slip_valid[k] = 0;
    }
  }
}

// Moves a warm start on along the line of the last change, where that lowers the error function. Images of the
// extrapolated tractions are extrapolated too. They are not brought back to where the laws admit them: the step after
// that does it, and the error function counts it.
bool NewtonIteration::start_predicted(Part part) {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  const double ratio = prediction_ratio;
  if (ratio == 0 || has_frozen_) return false;
  if (has_normal(part) && !p.op->all_at_once() && !prediction.gaps_known(p, it)) return false;
  for (int c = 0; c < 3; ++c) {
    if (c == 2 ? has_normal(part) : has_tangential(part)) {
      prediction.tractions(it, ratio, c, next_[c]);
      prediction.image(it, ratio, c, next_image_[c]);
    } else {
      next_[c] = it.lambda[c];
    }
  }
  for (int m = 0; m < int{motion_count}; ++m)
    next_motion_[at(m)] =
        has_motion(part, m) && given_->by_force[at(m)] ? prediction.motion(it, ratio, m) : it.motion[at(m)];
  if (p.op->all_at_once()) {
    p.op->images(components_of(part), {}, {}, next_, next_image_);
  } else if (has_tangential(part)) {
    for (const std::int32_t i : active_)
      if (!prediction.slip_known(it, at(i))) p.op->images(slip_components, {}, {&i, 1}, next_, next_image_);
  }
  if (!(trial_merit(part, 1) < trial_merit(part, 0))) return false;
  advance(part, 1);
  ++solve_->report.predictions;
  return true;
}

}  // namespace rollcon
