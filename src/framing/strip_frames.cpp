#include "framing/strip_frames.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "framing/strips/field_sum.hpp"
#include "framing/strips/strip_results.hpp"
#include "linalg/blas_threads.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {

using namespace strips;

Rates rates_of(const StripTotals& t) {
  Rates r;
  r.force = {t.force[0], t.force[1], -t.load};
  r.moment = {-t.pressed[1], t.pressed[0], t.force[2]};
  r.motion[xi1] = t.motion[0];
  r.motion[xi2] = t.motion[1];
  r.motion[spin] = t.motion[2];
  r.motion[approach] = t.approach;
  return r;
}

StripStatus StripFrames::fit(Solver& on, const Rectangle& box, StripCounts counts, bool patient) {
  seconds_ = 0;
  const Stopwatch watch(seconds_);
  givens_.read(on, box);
  box_ = box;
  const bool near = warm_ && solution_.strips.layout.counts == counts;
  const StripStatus status = contact_.solve(givens_.scene(), box, counts, solution_, near, patient).status;
  warm_ = status == StripStatus::solved;
  if (!warm_) return status;
  totals_ = StripContact::totals(solution_);
  const bool hollow = solution_.share > 0 && trust(solution_.strips).hollow > strips::StripTrust::most_hollow;
  return within_bodies() && !hollow ? status : StripStatus::unfit;
}

// Says whether both bodies are there wherever the contact ends.
bool StripFrames::within_bodies() const {
  const StripState& s = solution_.strips;
  for (const StripPoint& p : s.layout.observers)
    if (!givens_.both_at({s.layout.x(p, s.geometry.data()), s.layout.y(p, s.geometry.data())})) return false;
  return true;
}

StripFrames::Sizes StripFrames::sizes() const {
  const StripState& s = peaked();
  const StripLayout& l = s.layout;
  const double* g = s.geometry.data();
  Sizes size;
  for (std::size_t i = 0; i < l.node.size(); ++i) {
    const double cell = l.cell(l.node[i], g);
    const Vec2 at{l.x(l.node[i], g), l.y(l.node[i], g)};
    double gap = 0;
    givens_.scene().gap->at({&at, 1}, &gap, nullptr);
    size.area += l.unit_cell[i] * cell;
    size.overlap = std::max(size.overlap, s.approach - gap);
    size.carried += l.unit_weight[i] * cell * std::hypot(s.traction[i], s.traction[l.node.size() + i]);
  }
  return size;
}

StripFrames::Inclination StripFrames::inclination() const {
  const StripState& s = peaked();
  const StripLayout& l = s.layout;
  const double* g = s.geometry.data();
  double all = 0, square = 0;
  Vec2 sum{};
  for (std::size_t i = 0; i < l.node.size(); ++i) {
    const double load = s.pressure[i] * l.unit_weight[i] * l.cell(l.node[i], g);
    all += load;
    const Vec2 slope = givens_.slope({l.x(l.node[i], g), l.y(l.node[i], g)});
    sum = sum + load * slope;
    square += load * dot(slope, slope);
  }
  if (!(all > 0)) return {};
  const Vec2 mean = (1 / all) * sum;
  return {std::atan(length(mean)), std::atan(std::sqrt(std::max(0.0, square / all - dot(mean, mean))))};
}

EquivalentEllipse StripFrames::equivalent_ellipse(const PairOfBodies& pair) {
  const StripState& s = solution_.strips;
  const StripLayout& l = s.layout;
  const double* g = s.geometry.data();
  place_.clear();
  for (std::size_t i = 0; i < l.node.size(); ++i) {
    const Vec2 slip{l.x(l.slip_place[i], g), l.y(l.slip_place[i], g)};
    const auto [s1, s2] = givens_.rigid_slip(slip);
    place_.push_back({s.pressure[i] * l.unit_weight[i] * l.cell(l.node[i], g), l.x(l.centroid[i], g),
                      l.y(l.centroid[i], g), slip[0], slip[1], s1, s2, 0});
  }
  return rollcon::equivalent_ellipse(place_, area(s), common_elasticity(*pair.body[0], *pair.body[1]));
}

std::optional<double> StripFrames::friction_power() const {
  const StripScene& scene = givens_.scene();
  if (scene.bodies.ck != 0 || solution_.share < 1) return std::nullopt;
  const StripState& s = solution_.strips;
  const StripLayout& l = s.layout;
  const double* g = s.geometry.data();
  double work = 0;
  for (std::size_t k = 0; k < 3; ++k) work += totals_.force[k] * totals_.motion[k];
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t i = 0; scene.slip[c] && i < l.node.size(); ++i) {
      const Vec2 at{l.x(l.centroid[i], g), l.y(l.centroid[i], g)};
      double slip = 0;
      scene.slip[c]->at({&at, 1}, &slip, nullptr);
      work += l.unit_weight[i] * l.cell(l.node[i], g) * slip * s.traction[c * l.node.size() + i];
    }
  return -givens_.speed() * work;
}

void StripFrames::put_frame(Scene& scene) const {
  scene.set_strips(peaked().layout, peaked().geometry);
}

Status StripFrames::show(Solver& on, double seconds, bool onward) try {
  const StripState& from = peaked();
  const Solution& last = on.solution();
  const std::int64_t mesh = on.scene.revision.mesh;
  const bool solved = onward && last.solved && !last.frictionless && on.scene.strips();
  for (std::size_t c = 0; solved && c < 2; ++c) before_[c] = last.iterate.lambda[c];
  put_frame(on.scene);
  const bool known = solved && on.scene.revision.mesh == mesh;
  if (onward && !known) on.reset();
  Iterate& it = on.start(seconds);
  // A law that falls is solved from nothing with the friction of rest first, which needs the solver's own start.
  const bool from_rest = onward && !known && on.scene.law() && on.scene.law()->falls();
  const std::vector<std::int32_t>& node = on.scene.strips()->node;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::size_t k = at(node[i]);
    it.lambda[2][k] = from_rest ? 0 : -from.pressure[i];
    for (std::size_t c = 0; c < 2; ++c)
      it.lambda[c][k] = !by_law() ? from.traction[c * node.size() + i] : known ? before_[c][k] : 0;
  }
  it.motion[xi1] = from.motion[0];
  it.motion[xi2] = from.motion[1];
  it.motion[spin] = from.motion[2];
  it.motion[approach] = from.approach - on.solution().prepared->problem.datum;
  const Status status = on.solve();
  if (!is_answer(status)) return status;
  if (solution_.share > 0) {
    shown_ = from;
    for (std::size_t i = 0; i < node.size(); ++i) shown_.pressure[i] = -it.lambda[2][at(node[i])];
    on.derived().largest_pressure = strips::largest_pressure(shown_).pressure;
  }
  if (by_law()) return status;
  if (solution_.share < 1) {
    const Rates all = rates_of(totals_);
    Extrapolated results;
    results.force = all.force;
    results.moment = all.moment;
    results.motion = all.motion;
    for (std::size_t k = 0; k < it.lambda[2].size(); ++k)
      if (it.lambda[2][k] < 0) results.area += on.solution().prepared->problem.cell_area[k];
    on.derived().extrapolated = results;
  }
  on.follow(*this);
  return status;
} catch (const Cancelled&) {
  return Status::cancelled;
}

std::optional<StripParameter> StripFrames::parameter_of(Parameter parameter) const {
  StripParameter by;
  switch (parameter) {
    case Parameter::longitudinal:
      by.motion[0] = 1;
      break;
    case Parameter::lateral:
      by.motion[1] = 1;
      break;
    case Parameter::spin:
      by.motion[2] = 1;
      break;
    case Parameter::normal:
      by.value = 1;
      break;
    case Parameter::friction:
      by.mu = givens_.scene().mu;
      break;
    default:
      return std::nullopt;
  }
  return by;
}

bool StripFrames::rates(Parameter parameter, Rates& found) {
  const std::optional<StripParameter> by = parameter_of(parameter);
  if (by) found = rates(*by);
  return by.has_value();
}

bool StripFrames::shift(Parameter parameter, double step) {
  const std::optional<StripParameter> by = parameter_of(parameter);
  if (!by) return false;
  solution_before_ = solution_;
  shifted_ = {.value = step * by->value, .mu = step * by->mu};
  for (std::size_t k = 0; k < 3; ++k) shifted_.motion[k] = step * by->motion[k];
  givens_.shift(shifted_, 1);
  const bool found = contact_.solve(givens_.scene(), box_, solution_.strips.layout.counts, solution_, true).status ==
                     StripStatus::solved;
  if (found)
    totals_ = StripContact::totals(solution_);
  else
    shift_back();
  return found;
}

void StripFrames::shift_back() {
  givens_.shift(shifted_, -1);
  solution_ = solution_before_;
  totals_ = StripContact::totals(solution_);
}

Rates StripFrames::rates(const StripParameter& by) {
  const BlasThreads blas(1);  // several are slower for systems of this size
  StripTotals rate;
  if (!contact_.rates(givens_.scene(), solution_, {&by, 1}, {&rate, 1}))
    fail(Status::err_singular, "the linearised system of the contact on strips has no solution");
  return rates_of(rate);
}

Rates StripFrames::rates(const StripGivens& before, const StripGivens& behind, double distance) {
  const StripScene &a = before.scene(), &b = behind.scene();
  StripParameter by;
  FieldSum gap, slip[2], friction;
  const auto set = [&](FieldSum& rate, const PlaneField* from, const PlaneField* to) {
    rate.field[0] = from;
    rate.field[1] = to;
    rate.factor[0] = -1 / distance;
    rate.factor[1] = 1 / distance;
    return from || to ? &rate : nullptr;
  };
  by.gap = set(gap, a.gap, b.gap);
  for (std::size_t c = 0; c < 2; ++c) by.slip[c] = set(slip[c], a.slip[c], b.slip[c]);
  by.friction = set(friction, a.friction, b.friction);
  by.value = (b.value - a.value) / distance;
  by.mu = (b.mu - a.mu) / distance;
  for (std::size_t k = 0; k < 3; ++k) by.motion[k] = (b.motion[k] - a.motion[k]) / distance;
  return rates(by);
}

void StripFrames::return_to(const StripSolution& solution, Solver& on, const Rectangle& box) {
  givens_.read(on, box);
  solution_ = solution;
  totals_ = StripContact::totals(solution_);
  warm_ = true;
}

}  // namespace rollcon
