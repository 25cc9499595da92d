#include "framing/strip_levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "framing/strips/strip_results.hpp"

namespace rollcon {
namespace {

/// Holds counts of strips, the coarser ones first, the least accuracy that solves on them begin with (none begins with
/// the last but one), the level of the coarser strips whose solution they are compared with, the part of the difference
/// that is added to tangential results, and the part by which these are then off at most in nine of ten contacts:
/// measured over random Hertzian contacts.
struct StripLevel {
  strips::StripCounts counts;
  double accuracy;
  std::size_t beside;
  double beyond, off_by;
};
constexpr std::array strip_levels{StripLevel{{5, 8}, 1, 0, 0, 1},
                                  StripLevel{{8, 12}, 0.015, 0, 0.3, 0.6},
                                  StripLevel{{12, 18}, 0.004, 0, 0.11, 0.25},
                                  StripLevel{{16, 24}, 0.0015, 1, 0.21, 0.4},
                                  StripLevel{{20, 30}, 0.0015, 2, 0.39, 0.6},
                                  StripLevel{{24, 36}, 0, 2, 0.21, 0.25}};
constexpr double more_of_coupled = 1.4;  // factor on that of unlike bodies

Rates results_of(const Solver& on) {
  const auto [force, moment] = on.loads();
  return {force, moment, on.motions()};
}

void add(Rates& to, double weight, const Rates& part) {
  to.force = to.force + weight * part.force;
  to.moment = to.moment + weight * part.moment;
  for (std::size_t m = 0; m < motion_count; ++m) to.motion[m] += weight * part.motion[m];
}

/// Adds a part of what tangential forces, spin moment and creepages of two solutions, or their rates, differ by to the
/// finer one's. Spins are given.
Rates beyond(double part, const Rates& coarse, const Rates& fine) {
  Rates r = fine;
  for (const Motion m : {xi1, xi2}) r.motion[m] += part * (fine.motion[m] - coarse.motion[m]);
  for (const std::size_t k : {0, 1}) r.force[k] += part * (fine.force[k] - coarse.force[k]);
  r.moment[2] += part * (fine.moment[2] - coarse.moment[2]);
  return r;
}

/// Returns the forces by which creepages that are found differ between two solutions: infinity where forces do not tell
/// creepages.
double forces_of_motions(const Scene& scene, StripFrames& on, const Rates& coarse, const Rates& fine) {
  double square = 0;
  for (const auto& [direction, parameter, motion] : {std::tuple{Direction::longitudinal, Parameter::longitudinal, xi1},
                                                     {Direction::lateral, Parameter::lateral, xi2}}) {
    if (on.by_law() || scene.load(direction).how != How::by_force) continue;
    Rates by;
    try {
      on.rates(parameter, by);
    } catch (const Error& error) {
      if (error.status() != Status::err_singular) throw;
      return INFINITY;
    }
    const double difference = fine.motion[motion] - coarse.motion[motion];
    if (difference != 0) square += difference * difference / (by.motion[motion] * by.motion[motion]);
  }
  return std::sqrt(square);
}

/// Estimates the error of what two solutions tend to, the finer one that on strips, from their difference. pressure:
/// the largest one of the coarser solution.
ErrorEstimate estimate(const Scene& scene, StripFrames& on, const StripLevel& level, const Rates& coarse,
                       double pressure, const Rates& fine) {
  const StripFrames::Sizes size = on.sizes();
  // What is missing around poles of sliding is mostly carried elsewhere. Pressures converge with the second order, and
  // so do normal results, which are not extrapolated.
  constexpr double lacking_missed = 0.1, of_pressures = 2, of_normal = 1.0 / 3;
  const double more = on.coupled() ? more_of_coupled : 1;
  const double off_by = more * (level.off_by + (on.by_law() ? level.beyond : 0)),
               normal_off_by = more * std::max(level.off_by, of_normal);
  const Vec3 force = fine.force - coarse.force;
  // Moments about the middles of the pressures do not depend on where the axes are.
  const auto own = [](const Rates& r) {
    return r.moment[2] - (r.moment[1] * r.force[1] + r.moment[0] * r.force[0]) / -r.force[2];
  };
  const double moment = (own(fine) - own(coarse)) / size.radius();
  ErrorEstimate e;
  e.known = true;
  e.normal = normal_off_by * (scene.load(Direction::normal).how == How::by_force
                                  ? 1.5 * std::abs(fine.motion[approach] - coarse.motion[approach]) / size.overlap
                                  : std::abs(force[2] / fine.force[2]));
  const double found = forces_of_motions(scene, on, coarse, fine);
  const double carried = on.by_law() ? std::hypot(fine.force[0], fine.force[1]) : size.carried;
  const auto [lack1, lack2, turning] = on.lacking_at_poles();
  const double lacking = std::max(
      std::hypot(lack1, lack2),
      std::abs(own({{lack1, lack2, fine.force[2]}, {fine.moment[0], fine.moment[1], turning}, {}})) / size.radius());
  const double differs = off_by * std::max({std::hypot(force[0], force[1]), std::abs(moment), found});
  e.tangential = carried > 0 ? std::max(differs, lacking_missed * lacking) / carried : 0;
  e.tractions =
      std::max({e.normal, e.tangential, of_pressures * level.beyond * std::abs(1 - pressure / on.largest_pressure())});
  return e;
}

/// Returns what has to be below the accuracy asked for. Largest pressures are judged less sharply than forces.
double reached(const ErrorEstimate& error) {
  return std::max(error.worst(), error.tractions / 4);
}

}  // namespace

// Mixes results of two levels where one is about to be enough, so that they do not jump there. find(level): results of
// a level, null where strips do not fit; last: the finest level that is tried.
template <class Find>
std::optional<StripLevels::Mixture> StripLevels::mix(const Scene& scene, Find find, std::size_t last) {
  const double wanted = scene.options.frame_accuracy;
  constexpr double enough = 0.7;
  Mixture m;
  double missing = 1;  // weight that is left
  for (m.level = 1; wanted < strip_levels[m.level].accuracy;) ++m.level;
  for (;; ++m.level) {
    const StripLevel& level = strip_levels[m.level];
    StripFrames& on = strips_[m.level];
    const Rates *const coarser = find(level.beside), *const finer = coarser ? find(m.level) : nullptr;
    if (!finer) return std::nullopt;
    m.error = estimate(scene, on, level, *coarser, strips_[level.beside].largest_pressure(), *finer);
    const double wider = (reached(m.error) / wanted - enough) / (1 - enough),
                 over = m.level == last ? 0 : std::clamp(wider, 0.0, 1.0),
                 weight = missing * (1 - over * over * (3 - 2 * over));
    // Results under other laws are those of the finer strips, as their derivatives are.
    add(m.sure, weight, on.by_law() ? *finer : beyond(level.beyond, *coarser, *finer));
    missing -= weight;
    m.mixed = weight < 1;
    if (m.level == last || !(missing > 0)) return m;
  }
}

double off_by_plane(double inclined, double turned) {
  constexpr double off_by_turning = 0.55;
  return 1 / std::cos(inclined) - 1 + off_by_turning * (1 / std::cos(turned) - 1);
}

std::optional<Status> StripLevels::solve(Solver& fine, const Rectangle& box, const std::optional<double>& area) {
  std::array<std::optional<Rates>, levels> found;
  const auto find = [&](std::size_t at) -> const Rates* {
    Rates now;
    if (!found[at] && fit(fine, box, at, now)) found[at] = now;
    return found[at] ? &*found[at] : nullptr;
  };
  const std::optional<Mixture> mixture = mix(fine.scene, find, levels - 1);
  if (!mixture) return std::nullopt;
  const auto& [sure, level, mixed, error] = *mixture;
  const double wanted = fine.scene.options.frame_accuracy;
  const auto [inclined, turned] = strips_[level].inclination();
  double seconds = 0;
  for (std::size_t i = 0; i <= level; ++i)
    if (found[i]) seconds += strips_[i].seconds();
  const Status status = strips_[level].show(fine, seconds);
  if (status != Status::ok) {
    fine.tell(status);
    return status;
  }
  Derived& derived = fine.derived();
  derived.error_estimate = error;
  derived.area = area.value_or(area_at(level));
  const bool by_law = strips_[level].by_law(), frictionless = fine.solution().frictionless;
  if (mixed || !(by_law || frictionless)) {
    derived.extrapolated = Extrapolated{sure.force, sure.moment, sure.motion, *derived.area, 0};
    // Strips without friction do not know the motions along the surface.
    if (frictionless)
      for (const Motion m : {xi1, xi2, spin}) derived.extrapolated->motion[m] = fine.solution().iterate.motion[m];
  }
  scene_ = &fine.scene;
  last_ = level;
  mixed_ = mixed;
  if (!by_law) fine.follow(*this);
  if (error.worst() > wanted) return tell_inaccurate(fine, error.worst());
  if (reached(error) > wanted) {
    char text[120];
    std::snprintf(text, sizeof text, "frames: the largest pressure on the finest frames is off by about %.2g %%",
                  100 * error.tractions);
    fine.host.caveat(Status::inaccurate, text);
    return Status::inaccurate;
  }
  derived.error_estimate.normal = std::max(derived.error_estimate.normal, off_by_plane(inclined, turned));
  return tell_inclined(fine, inclined, turned);
}

Status tell_inclined(const Solver& fine, double inclined, double turned) {
  const double off = off_by_plane(inclined, turned);
  if (off <= fine.scene.options.frame_accuracy) return Status::ok;
  constexpr double degrees = 180 / std::numbers::pi;
  char text[256];
  if (const double too_high = 1 / std::cos(inclined) - 1; too_high > 0.5 * off)
    std::snprintf(
        text, sizeof text,
        "the normals of the contact are inclined by %.3g degrees against n of the axes, so that pressures are "
        "about %.2g %% too high: turn the axes (rollcon_contact_set_axes) or, up to 60 degrees, set the option "
        "conformal to 1",
        inclined * degrees, 100 * too_high);
  else
    std::snprintf(
        text, sizeof text,
        "the normals turn by %.3g degrees, root mean square, within the contact, which a plane frame takes for "
        "flat: forces are off by about %.2g %%; set the option conformal to 1",
        turned * degrees, 100 * off);
  fine.host.caveat(Status::inaccurate, text);
  return Status::inaccurate;
}

// Returns a step of a parameter over which forces change by little.
double StripLevels::step_for(const Scene& scene, Parameter parameter, const Rates& rates) const {
  constexpr double little = 1e-4;
  const strips::StripTotals& now = strips_[last_].totals();
  const auto by_force = [&](Direction d) { return scene.load(d).how == How::by_force; };
  if (parameter == Parameter::normal) return little * (by_force(Direction::normal) ? now.load : now.approach);
  if (parameter == Parameter::friction) return little * scene.friction(0, 0);
  const double limit = scene.friction(0, 0) * now.load;
  if (parameter == Parameter::longitudinal && by_force(Direction::longitudinal)) return little * limit;
  if (parameter == Parameter::lateral && by_force(Direction::lateral)) return little * limit;
  const double radius = strips_[last_].sizes().radius();
  const double slope = std::hypot(rates.force[0], rates.force[1], rates.moment[2] / radius);
  // Where all slides, slopes are 0.
  const double largest = std::hypot(now.motion[0], now.motion[1], now.motion[2] * radius);
  const double most = 10 * little * (parameter == Parameter::spin ? largest / radius : largest);
  return most > 0 && slope * most > little * limit ? little * limit / slope : most;
}

bool StripLevels::rates(Parameter parameter, Rates& found) {
  const StripLevel& level = strip_levels[last_];
  Rates finest;
  if (!strips_[last_].rates(parameter, finest)) return false;
  const auto extrapolate = [&] {
    Rates coarser;
    if (!strips_[level.beside].rates(parameter, coarser)) return false;
    found = beyond(level.beyond, coarser, finest);
    return true;
  };
  if (!mixed_) return extrapolate();
  const double step = step_for(*scene_, parameter, finest);
  Rates sum;
  for (const double side : {-1.0, 1.0}) {
    std::array<std::optional<Rates>, levels> near;
    const auto find = [&](std::size_t at) -> const Rates* {
      if (!near[at] && strips_[at].shift(parameter, side * step)) near[at] = rates_of(strips_[at].totals());
      return near[at] ? &*near[at] : nullptr;
    };
    const std::optional<Mixture> mixture = step > 0 ? mix(*scene_, find, last_) : std::nullopt;
    for (std::size_t at = 0; at < levels; ++at)
      if (near[at]) strips_[at].shift_back();
    if (!mixture) return extrapolate();
    add(sum, side / (2 * step), mixture->sure);
  }
  found = sum;
  return true;
}

// Fits strips of a level. Returns false where they do not fit the contact.
bool StripLevels::fit(Solver& fine, const Rectangle& box, std::size_t level, Rates& found) {
  StripFrames& on = strips_[level];
  const bool fits = on.fit(fine, box, strip_levels[level].counts) == strips::StripStatus::solved;
  missed_corners_ = on.missed_corners();
  if (!fits) return false;
  found = rates_of(on.totals());
  if (!on.by_law()) return true;
  // What resists slip is known to the solver alone.
  if (!coarse_) coarse_ = fine.another();
  coarse_->take_over(fine);
  coarse_->scale_tangential_loads(1);
  if (on.show(*coarse_, 0) != Status::ok) return false;
  found = results_of(*coarse_);
  return true;
}

// Returns the area that those of two counts tend to, where both have strips.
double StripLevels::area_at(std::size_t level) const {
  const std::size_t beside = strip_levels[level].beside;
  const strips::StripSolution *coarse = &strips_[beside].solution(), *fine = &strips_[level].solution();
  if (!(coarse->share > 0 && fine->share > 0)) return strips_[level].sizes().area;
  const auto across = [&](std::size_t i) { return static_cast<double>(strip_levels[i].counts.across); };
  const double finer = across(level) / across(beside), found = strips::area(fine->strips);
  return found + (found - strips::area(coarse->strips)) / (finer * finer - 1);
}

Status StripLevels::tell_inaccurate(const Solver& fine, double reached) {
  char text[160];
  std::snprintf(text, sizeof text,
                "frames: the error on the finest frames is about %.2g %%, %.2g %% was asked for (option "
                "frame_accuracy)",
                100 * reached, 100 * fine.scene.options.frame_accuracy);
  fine.host.caveat(Status::inaccurate, text);
  return Status::inaccurate;
}

void StripLevels::forget() {
  for (StripFrames& strips : strips_) strips.forget();
}

}  // namespace rollcon
