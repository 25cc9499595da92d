#include "contact/newton/newton.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::size_t merit_window = 5;
constexpr double sufficient_decrease = 1e-4;
constexpr double smallest_step = 1.0 / 64;

}  // namespace

double Newton::Residual::worst(Part part) const {
  double worst = load;
  if (part != Part::tangential) worst = std::max(worst, normal);
  if (part != Part::normal) worst = std::max(worst, tangential);
  return worst;
}

bool Newton::Residual::within(Part part, double tolerance) const {
  constexpr double useless = 1e-6;  // so much rounding leaves nothing to call a solution
  const auto small = [&](double residual, double rounding) {
    return residual <= std::max(tolerance, std::min(rounding, useless));
  };
  return load <= tolerance && (part == Part::tangential || small(normal, normal_rounding)) &&
         (part == Part::normal || small(tangential, tangential_rounding));
}

std::size_t Newton::bytes() const {
  std::size_t sum = linear.bytes() + system_.bytes() + prediction_.bytes();
  for (int c = 0; c < 3; ++c)
    sum += sizeof(double) * (frozen_[c].capacity() + next_[c].capacity() +
                             next_image_[c].capacity() + known_[c].capacity());
  return sum + sizeof(double) *
                   (judged_.capacity() + b_.capacity() + x_.capacity() + correction_.capacity());
}

// Residuals of the projected laws at the iterate; also finds the active nodes and makes every image
// that the next step needs valid.
Newton::Residual Newton::evaluate(Part part) {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  Residual r;
  active_.clear();
  double pressure = 0, traction = 0, bound_max = 0, worst_n = 0, worst_t = 0;
  double sum_n = 0, sum_t = 0, gap_n = 0, slip_t = 0, gap_t = 0;
  const double delta = it.motion[approach];
  for (std::int64_t i = 0; i < p.nodes; ++i) {
    const std::size_t k = at(i);
    is_active_[k] = 0;
    if (!p.used[k]) continue;
    const double ln = it.lambda[2][k];
    double augmented = ln;
    if (part != Part::tangential) {
      it.update_gap(p, i);
      augmented = ln + p.rn[k] * (p.rigid_gap(k, delta) - it.image[2][k]);
      const double rest = ln - std::min(augmented, 0.0);
      worst_n = std::max(worst_n, std::abs(rest));
      sum_n += rest * rest;
    }
    pressure = std::max(pressure, -ln);
    const bool touching = augmented < 0;
    double terms = 0;  // of the gap, as a traction
    if (touching) {
      active_.push_back(static_cast<std::int32_t>(i));
      is_active_[k] = 1;
      if (part != Part::tangential) {
        terms = p.rn[k] * (std::abs(p.gap[k]) + std::abs(it.image[2][k]));
        gap_n = std::max(gap_n, terms);
      }
    }
    if (part == Part::normal) continue;
    const double l1 = it.lambda[0][k], l2 = it.lambda[1][k];
    double t1 = 0, t2 = 0;
    if (touching) {
      it.update_slip(p, i);
      const double s1 = p.rigid_slip1(i, it.motion), s2 = p.rigid_slip2(i, it.motion);
      const double a1 = l1 - p.rt[k] * (s1 + it.image[0][k]);
      const double a2 = l2 - p.rt[k] * (s2 + it.image[1][k]);
      const double bound = -p.mu[k] * augmented;
      // Where nodes slide only the share across the traction counts, which shrinks with the bound.
      const double length = std::hypot(a1, a2);
      const double share = length > bound ? bound / length : 1;
      slip_t = std::max(slip_t, share * p.rt[k] *
                                    (std::abs(s1) + std::abs(s2) + std::abs(it.image[0][k]) +
                                     std::abs(it.image[1][k])));
      gap_t = std::max(gap_t, p.mu[k] * terms);
      bound_max = std::max(bound_max, bound);
      project_on_disk(a1, a2, bound, t1, t2);
      if (!(std::hypot(a1, a2) < bound)) ++r.sliding;
    }
    traction = std::max(traction, std::hypot(l1, l2));
    const double rest = std::hypot(l1 - t1, l2 - t2);
    worst_t = std::max(worst_t, rest);
    sum_t += rest * rest;
  }
  r.contact = static_cast<std::int64_t>(active_.size());
  r.pressure = pressure;
  r.traction = traction;
  // Relative measures. Tangential residuals hide under normal ones, so they are judged by the
  // tangential tractions themselves as soon as there are any.
  pressure_scale_ = pressure > 0 ? pressure : worst_n;
  traction_scale_ = worst_t;
  if (traction > 0) traction_scale_ = bound_max > 0 ? std::min(traction, bound_max) : traction;
  r.normal = pressure_scale_ > 0 ? worst_n / pressure_scale_ : 0;
  r.tangential = traction_scale_ > 0 ? worst_t / traction_scale_ : 0;
  // What rounding of gaps and slips alone makes of the tractions: no iteration gets below that.
  if (pressure_scale_ > 0) r.normal_rounding = rounding_of_terms * gap_n / pressure_scale_;
  if (traction_scale_ > 0)
    r.tangential_rounding = rounding_of_terms * (slip_t + gap_t) / traction_scale_;
  r.load = load_residual(part, 0);
  if (!(pressure_scale_ > 0)) pressure_scale_ = 1;
  if (!(traction_scale_ > 0)) traction_scale_ = 1;
  // A relative error of a load stands for that error of the traction at every node.
  r.merit = 0.5 * (sum_n / (pressure_scale_ * pressure_scale_) +
                   sum_t / (traction_scale_ * traction_scale_) +
                   r.load * r.load * static_cast<double>(active_.size()));
  return r;
}

// Largest relative error of the part's prescribed loads at iterate + alpha step. Loads are linear
// in the tractions.
double Newton::load_residual(Part part, double alpha) const {
  const Problem& p = *problem_;
  double worst = 0;
  for (int m = 0; m < 4; ++m) {
    const bool relevant = m == approach ? part != Part::tangential : part != Part::normal;
    if (!p.by_force[at(m)] || !relevant) continue;
    LoadSum sum = load_on_body1(p, m, iterate_->lambda);
    if (alpha != 0) {
      const LoadSum next = load_on_body1(p, m, next_);
      sum.value += alpha * (next.value - sum.value);
      sum.magnitude = std::max(sum.magnitude, next.magnitude);
    }
    const double scale = std::max(sum.magnitude, std::abs(p.value[at(m)]));
    if (scale > 0) worst = std::max(worst, std::abs(sum.value - p.value[at(m)]) / scale);
  }
  return worst;
}

double Newton::trial_merit(Part part, double alpha) const {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  double sum_n = 0, sum_t = 0;
  std::array<double, 4> motion = it.motion;
  for (int m = 0; m < 4; ++m) motion[at(m)] += alpha * (next_motion_[at(m)] - motion[at(m)]);
  const auto blend = [&](const std::vector<double>& from, const std::vector<double>& to,
                         std::size_t k) {
    return alpha == 0 ? from[k] : from[k] + alpha * (to[k] - from[k]);
  };
  for (std::int64_t i = 0; i < p.nodes; ++i) {
    const std::size_t k = at(i);
    if (!p.used[k]) continue;
    const double ln = blend(it.lambda[2], next_[2], k);
    double augmented = ln;
    if (part != Part::tangential) {
      augmented =
          ln + p.rn[k] * (p.rigid_gap(k, motion[approach]) - blend(it.image[2], next_image_[2], k));
      const double rn = ln - std::min(augmented, 0.0);
      sum_n += rn * rn;
    }
    if (part == Part::normal || (!is_active_[k] && it.lambda[0][k] == 0 && it.lambda[1][k] == 0))
      continue;
    const double l1 = blend(it.lambda[0], next_[0], k), l2 = blend(it.lambda[1], next_[1], k);
    double t1 = 0, t2 = 0;
    if (augmented < 0 && is_active_[k]) {
      const double a1 =
          l1 - p.rt[k] * (p.rigid_slip1(i, motion) + blend(it.image[0], next_image_[0], k));
      const double a2 =
          l2 - p.rt[k] * (p.rigid_slip2(i, motion) + blend(it.image[1], next_image_[1], k));
      project_on_disk(a1, a2, -p.mu[k] * augmented, t1, t2);
    }
    sum_t += (l1 - t1) * (l1 - t1) + (l2 - t2) * (l2 - t2);
  }
  // A relative error of a load stands for that error of the traction at every node.
  const double load = load_residual(part, alpha) * std::sqrt(static_cast<double>(active_.size()));
  return 0.5 * (sum_n / (pressure_scale_ * pressure_scale_) +
                sum_t / (traction_scale_ * traction_scale_) + load * load);
}

void Newton::freeze_other_part(Part part) {
  has_frozen_ = problem_->op.coupled && part != Part::full;
  if (!has_frozen_) return;
  const Problem& p = *problem_;
  const std::int64_t n = p.nodes;
  if (p.op.field) {
    const auto& l = iterate_->lambda;
    const bool own = part == Part::normal;
    p.op.field->apply({own && p.op.tangential ? l[0].data() : nullptr,
                       own && p.op.tangential ? l[1].data() : nullptr, own ? nullptr : l[2].data()},
                      {own ? nullptr : frozen_[0].data(), own ? nullptr : frozen_[1].data(),
                       own ? frozen_[2].data() : nullptr});
    return;
  }
  if (part == Part::normal) {
    for (std::int64_t i = 0; i < n; ++i) {
      if (!p.used[at(i)]) continue;
      double sum = 0;
      for (int c = 0; c < 2; ++c)
        if (!p.op.block[2][c].empty())
          sum += dot(p.op.block[2][c].row(i), iterate_->lambda[c].data(), n);
      frozen_[2][at(i)] = sum;
    }
    return;
  }
  for (int r = 0; r < 2; ++r)
    for (std::int64_t i = 0; i < n; ++i)
      frozen_[r][at(i)] = p.op.block[r][2].empty() || !p.used[at(i)]
                              ? 0
                              : dot(p.op.block[r][2].row(i), iterate_->lambda[2].data(), n);
}

TangentialLaw Newton::law_of(Part part, std::int32_t node, bool bound_follows) const {
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  const std::int64_t i = node;
  const std::size_t k = at(i);
  double pressure = -it.lambda[2][k];
  if (part == Part::full)
    pressure =
        -(it.lambda[2][k] + p.rn[k] * (p.rigid_gap(k, it.motion[approach]) - it.image[2][k]));
  const double a1 = it.lambda[0][k] - p.rt[k] * (p.rigid_slip1(i, it.motion) + it.image[0][k]);
  const double a2 = it.lambda[1][k] - p.rt[k] * (p.rigid_slip2(i, it.motion) + it.image[1][k]);
  return linearise_coulomb(a1, a2, p.mu[k], p.mu[k] * pressure, bound_follows);
}

ReducedSystem& Newton::linearise(Problem& problem, Iterate& iterate, Part part) {
  problem_ = &problem;
  iterate_ = &iterate;
  reserve(at(problem.nodes));
  evaluate(part);
  system_.gather(problem, part, active_, iterate.lambda, operators_changed_);
  operators_changed_ = false;
  if (part != Part::normal)
    for (std::size_t a = 0; a < active_.size(); ++a)
      system_.law(static_cast<std::int64_t>(a)) = law_of(part, active_[a], true);
  return system_;
}

// After a step the images at hand are the product of the system with the iterate, unless nodes that
// have just left the contact still carry tractions. False: they do. The first step of a run makes
// the product anew, lest rounding adds up over solves.
bool Newton::take_product(Part part) {
  if (!images_fresh_) return false;
  const Problem& p = *problem_;
  const Iterate& it = *iterate_;
  const int first = part == Part::normal ? 2 : 0, last = part == Part::tangential ? 1 : 2;
  for (std::size_t k = 0; k < at(p.nodes); ++k)
    for (int c = first; c <= last && !is_active_[k]; ++c)
      if (it.lambda[c][k] != 0) return false;
  const std::size_t na = active_.size();
  product_.resize(static_cast<std::size_t>(system_.components()) * na);
  for (int r = 0; r < system_.components(); ++r) {
    const int c = system_.component(r);
    for (std::size_t a = 0; a < na; ++a) {
      const std::size_t k = at(active_[a]);
      const double scale = c == 2 ? p.rn[k] : p.rt[k];
      product_[static_cast<std::size_t>(r) * na + a] =
          scale * (it.image[c][k] - (has_frozen_ ? frozen_[c][k] : 0));
    }
  }
  return true;
}

// Fills next_, next_image_ and next_motion_ with the solution of the linearised problem.
bool Newton::newton_step(Part part, double forcing) {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  const std::size_t na = active_.size();
  system_.gather(p, part, active_, it.lambda, operators_changed_);
  operators_changed_ = false;
  std::array<double, 4> known = it.motion;
  for (int m = 0; m < 4; ++m) known[at(m)] = p.by_force[at(m)] ? 0 : p.value[at(m)];
  if (part == Part::tangential) known[approach] = it.motion[approach];
  for (auto& v : known_) v.resize(na);
  for (std::size_t a = 0; a < na; ++a) {
    const std::int32_t i = active_[a];
    const std::size_t k = at(i);
    if (part != Part::tangential)
      known_[2][a] = p.rigid_gap(k, known[approach]) - (has_frozen_ ? frozen_[2][k] : 0);
    if (part == Part::normal) continue;
    system_.law(static_cast<std::int64_t>(a)) =
        stick_first_ && p.mu[k] > 0 ? stick_law() : law_of(part, i, part == Part::full);
    known_[0][a] = p.rigid_slip1(i, known) + (has_frozen_ ? frozen_[0][k] : 0);
    known_[1][a] = p.rigid_slip2(i, known) + (has_frozen_ ? frozen_[1][k] : 0);
  }
  system_.right_side(known_[2], known_[0], known_[1], b_);

  // Solve for the correction: the forcing term is then relative to the present residual.
  const auto n = static_cast<std::size_t>(system_.size());
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
  const std::span<const double> step_product = system_.product();

  for (int c = 0; c < 3; ++c) {
    const bool own = (c == 2) ? part != Part::tangential : part != Part::normal;
    if (own)
      std::fill(next_[c].begin(), next_[c].end(), 0.0);
    else
      next_[c] = it.lambda[c];
  }
  for (int r = 0; r < system_.components(); ++r) {
    const int c = system_.component(r);
    for (std::size_t a = 0; a < na; ++a) {
      const std::size_t k = at(active_[a]), row = static_cast<std::size_t>(r) * na + a;
      next_[c][k] = x_[row];
      const double scale = c == 2 ? p.rn[k] : p.rt[k];
      next_image_[c][k] =
          (product_[row] + step_product[row]) / scale + (has_frozen_ ? frozen_[c][k] : 0);
    }
  }
  for (int m = 0; m < 4; ++m) {
    const bool own = (m == approach) ? part != Part::tangential : part != Part::normal;
    next_motion_[at(m)] = own ? system_.motion(p, m, x_.data()) : it.motion[at(m)];
  }
  if (p.op.field) {
    take_step_field(part);
    return true;
  }
  if (part == Part::tangential) return true;
  for (std::int64_t i = 0; i < p.nodes; ++i) {
    const std::size_t k = at(i);
    if (!p.used[k] || is_active_[k]) continue;
    double sum = 0;
    for (int c = 0; c < 3; ++c)
      if (!p.op.block[2][c].empty()) sum += dot(p.op.block[2][c].row(i), next_[c].data(), p.nodes);
    next_image_[2][k] = sum;
  }
  return true;
}

// Images of the step at all nodes, by one application of operators that are not formed.
void Newton::take_step_field(Part part) {
  const ContactOperators& op = problem_->op;
  const bool tangential = part != Part::normal, normal = part != Part::tangential;
  const auto from = [&](int c) { return c == 2 || op.tangential ? next_[c].data() : nullptr; };
  const auto to = [&](int r) {
    return (r == 2 ? normal : tangential) ? next_image_[r].data() : nullptr;
  };
  op.field->apply({from(0), from(1), from(2)}, {to(0), to(1), to(2)});
}

// Non-monotone Armijo rule with halving; the best step seen is taken when none satisfies it. The
// first steps of a warm start are taken whole: the merit of a solution of a neighbouring problem is
// far below that of every useful iterate.
double Newton::line_search(Part part, double merit) {
  if (free_steps_ > 0) {
    --free_steps_;
    merits_.push_back(INFINITY);
    return 1;
  }
  if (merits_.size() == merit_window) merits_.erase(merits_.begin());
  merits_.push_back(merit);
  const double reference = *std::max_element(merits_.begin(), merits_.end());
  double best = 1, best_merit = INFINITY;
  for (double alpha = 1; alpha >= smallest_step; alpha /= 2) {
    const double trial = trial_merit(part, alpha);
    if (trial <= (1 - 2 * sufficient_decrease * alpha) * reference) return alpha;
    if (trial < best_merit) best = alpha, best_merit = trial;
  }
  return best;
}

void Newton::advance(Part part, double alpha) {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  const auto blend = [alpha](double& from, double to) {
    from = alpha == 1 ? to : from + alpha * (to - from);
  };
  for (int m = 0; m < 4; ++m) blend(it.motion[at(m)], next_motion_[at(m)]);
  const bool everywhere = p.op.field != nullptr;  // the step's slip is known at all nodes
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    if (!p.used[k]) continue;
    for (int c = 0; c < 3; ++c) {
      const bool own = (c == 2) ? part != Part::tangential : part != Part::normal;
      if (own) blend(it.lambda[c][k], next_[c][k]);
    }
    if (part != Part::tangential)
      blend(it.image[2][k], next_image_[2][k]);
    else if (p.op.coupled)
      it.gap_valid[k] = 0;
    if (part != Part::normal && (is_active_[k] || (everywhere && it.slip_valid[k]))) {
      blend(it.image[0][k], next_image_[0][k]);
      blend(it.image[1][k], next_image_[1][k]);
    } else if (part != Part::normal || p.op.coupled) {
      it.slip_valid[k] = 0;
    }
  }
}

// A body that gives way more than a half-space (a rim, a ring) parts everywhere under the guessed
// pressures at the guessed approach. Moves the bodies together until the gap of the loaded nodes
// closes on average.
void Newton::fit_approach() {
  const Problem& p = *problem_;
  Iterate& it = *iterate_;
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    if (!(it.lambda[2][k] < 0)) continue;
    it.update_gap(p, static_cast<std::int64_t>(k));
    sum += it.lambda[2][k] * (p.gap[k] - it.image[2][k]) / p.closing(k);
    weight += it.lambda[2][k];
  }
  if (weight < 0) it.motion[approach] = sum / weight;
}

}  // namespace rollcon
