#include "framing/automatic_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <numbers>
#include <optional>
#include <string>

#include "bodies/body.hpp"
#include "bodies/pair.hpp"
#include "contact/results/extrapolation.hpp"
#include "contact/results/outcome_text.hpp"
#include "contact/scene/known_gap.hpp"
#include "contact/solver.hpp"
#include "contact/statistics.hpp"
#include "framing/fitted_meshes.hpp"
#include "framing/hertz.hpp"
#include "framing/hertz_friction.hpp"
#include "framing/makers.hpp"
#include "framing/patch_search.hpp"
#include "framing/step_frames.hpp"
#include "framing/strip_levels.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

/// Holds the coarser frame's intervals along and across the rolling direction; the finer one has twice as many.
struct Level {
  std::int64_t along, across;
  /// Error of the finer frame as its pair shows it, on average over 40 random Hertzian contacts: measured for the first
  /// three, halved for the others.
  double usual;
};
constexpr std::array levels{Level{6, 4, 0.012},    Level{8, 6, 0.0053},   Level{12, 8, 0.0026},  Level{16, 12, 0.0013},
                            Level{24, 16, 0.0007}, Level{32, 24, 0.0004}, Level{48, 36, 0.0002}, Level{64, 48, 0.0001}};
/// Count the levels that contacts have. Lattices of half-spaces have more, because their operators are no matrices: one
/// more for bodies that creep, all levels for very unlike ones.
constexpr std::size_t usual_levels = 5, creeping_levels = 6;

using Tilts = std::array<double, 2>;

/// Says whether what ends over the contact deforms there: all surfaces are meshes of elastic bodies.
bool surfaces_deform(const PairOfBodies& pair) {
  return std::all_of(pair.body.begin(), pair.body.end(),
                     [](const Body* body) { return !body->has_surface() || (body->meshed() && !body->rigid()); });
}

/// Says whether the slip that pressures cause converges slowly on strips.
bool very_unlike(const PairOfBodies& pair) {
  constexpr double very = 0.1;
  return std::abs(dundurs_beta(pair)) > very;
}

/// Says whether friction and the slip that pressures cause move the edge so far that no fitted frame follows it.
bool unlike_under_friction(const PairOfBodies& pair, double friction) {
  constexpr double far = 0.1;
  return very_unlike(pair) && std::abs(dundurs_beta(pair)) * friction > far;
}

class AutomaticFrames final : public FrameMaker {
 public:
  /// Solves until the tilts that moments ask for, which move the contact along the bodies, fit the frames. Frames are
  /// made for the tilts found last, until these change by little compared with the bodies' flattening.
  Status solve(Solver& fine) override {
    missed_corners_ = fitted_instead_ = false;
    conformal_ = fine.scene.options.conformal;
    steps_on_lattice_ = fine.scene.step_kind() != StepKind::steady && lattices_fit(fine);
    if (steps_on_lattice_ && !shape_.sharp) return solve_step(fine);
    steps_on_lattice_ = false;
    try {
      const Status status = solve_within(fine);
      const bool cut_off = status == Status::rim_contact && !beyond_bounds_;
      if (!shape_.unlike || (status != Status::not_converged && !cut_off)) return status;
      fitted_instead_ = true;
    } catch (const Error& error) {
      // Frames that follow surfaces are not made on slopes beyond 60 degrees.
      if (error.status() != Status::err_mesh || conformal_ != 0 || !shape_.conformal) throw;
      conformal_ = -1;
    }
    return solve_within(fine);
  }

  void end_step(Status status) override {
    if (!coarse_) return;
    if (steps_on_lattice_) return coarse_->reset();
    coarse_->end_step(status);
  }
  void repeat_step() override {
    if (coarse_ && !steps_on_lattice_) coarse_->repeat_step();
  }

  void lay(Solver& solver, const Rectangle& sides, std::int64_t along, std::int64_t across) override {
    steps_.lay(solver, sides, along, across);
  }

  void reset() override {
    level_ = levels.size();
    tilts_known_ = false;
    if (coarse_) coarse_->reset();
    strips_.forget();
  }

 private:
  Status solve_within(Solver& fine) {
    if (const std::optional<Status> found = solve_on_strips(fine)) return *found;
    find_shape(fine);
    if (!shape_.conformal) return solve_on_fitting_levels(fine);
    const FollowSurfaces following(fine.scene.options);
    return solve_on_fitting_levels(fine);
  }

  /// Sets the option conformal for a solve.
  class FollowSurfaces {
   public:
    explicit FollowSurfaces(Options& options) : options_(options), before_(options.conformal) { options.conformal = 1; }
    ~FollowSurfaces() { options_.conformal = before_; }
    FollowSurfaces(const FollowSurfaces&) = delete;
    FollowSurfaces& operator=(const FollowSurfaces&) = delete;

   private:
    Options& options_;
    std::int64_t before_;
  };

  /// Says whether frames may follow the bodies' surfaces where patches are inclined.
  bool may_follow(Solver& fine) const {
    const PairOfBodies pair = fine.pair();
    return conformal_ == 0 && !fine.scene.has_gap() && !pair.meshed() && !pair.creeps() &&
           fine.scene.step_kind() == StepKind::steady && (pair.body[0]->surface() || pair.body[1]->surface());
  }

  /// Holds slopes of the patches against the plane of the axes.
  struct Inclination {
    Vec2 mean{}, turned{};  ///< mean slopes, and their root mean square differences from them
    double within = 0;      ///< the same of slopes across from the means of their own patches
    double off_across() const { return off_by_plane(std::atan(mean[1]), std::atan(turned[1])); }
    double bent() const { return off_by_plane(0, std::atan(within)); }
  };

  /// Takes slopes at the middles of patches and half way to their ends.
  void find_inclination(const Patches& patches) {
    double all = 0, of_means = 0;
    Vec2 sum{}, square{};
    for (const Outline& outline : patches.outline) {
      const Rectangle b = outline.box();
      const double x = 0.5 * (b.x_least + b.x_greatest), y = 0.5 * (b.y_least + b.y_greatest);
      double count = 0;
      Vec2 here{};
      for (const double part : {-0.5, 0.0, 0.5}) {
        Heights h;
        if (!gap_->heights(x, y + part * (b.y_greatest - y), h)) continue;
        const Vec2 slope = 0.5 * (h.slope[0] + h.slope[1]);
        ++count;
        here = here + slope;
        square = square + Vec2{slope[0] * slope[0], slope[1] * slope[1]};
      }
      if (count > 0) of_means += here[1] * here[1] / count;
      all += count;
      sum = sum + here;
    }
    if (all == 0) return;
    const auto root = [](double of) { return std::sqrt(std::max(0.0, of)); };
    const Vec2 mean = (1 / all) * sum;
    inclination_.mean = mean;
    inclination_.turned = {root(square[0] / all - mean[0] * mean[0]), root(square[1] / all - mean[1] * mean[1])};
    inclination_.within = root((square[1] - of_means) / all);
  }

  Status solve_on_fitting_levels(Solver& fine) {
    constexpr int most_rounds = 8;
    constexpr double little = 0.02;
    for (int round = 1;; ++round) {
      const Status status = solve_on_levels(fine);
      const Tilts before = tilts_;
      if (!is_answer(status) || shape_.outline.empty() || !take_found_tilts(fine)) return status;
      double x = 0, y = 0;
      for (const Outline& outline : shape_.outline) {
        const Rectangle b = outline.box();
        x = std::max(x, 0.5 * (b.x_greatest - b.x_least)), y = std::max(y, 0.5 * (b.y_greatest - b.y_least));
      }
      const Vec3 force = fine.loads().force;
      const double moved = y * std::abs(tilts_[0] - before[0]) + x * std::abs(tilts_[1] - before[1]);
      if (moved <= little * std::abs(force[2]) / (contact_modulus(fine.pair()) * std::max(x, y)) ||
          round == most_rounds)
        return status;
    }
  }

  /// Holds what the outlines of patches were found from.
  struct Found {
    std::int64_t gap = -1;
    double modulus = 0;
    How how{};
    double value = 0;
    double speed = 0;  ///< speed of bodies that creep; else 0
    std::array<std::int64_t, 2> pose{-1, -1};
    std::int64_t axes = -1;
    /// Hold the option conformal and the accuracy by which it was chosen.
    std::int64_t conformal = -1;
    double accuracy = 0;
    bool unlike = false;
    bool tilted = false;
    Tilts tilts{};
    bool operator==(const Found&) const = default;
  };

  /// Says whether time steps have lattices and, if so, finds the contact's shape. Half-spaces have the same response
  /// wherever nodes lie.
  bool lattices_fit(Solver& fine) {
    if (fine.bodies().meshed() || fine.scene.tilts() || fine.scene.options.conformal > 0) return false;
    find_shape(fine);
    return true;
  }

  Status solve_step(Solver& fine) {
    StepContact contact{shape_.box, INFINITY, INFINITY, fine.scene.options.frame_accuracy};
    for (const Rectangle& b : shape_.boxes()) {
      contact.length = std::min(contact.length, b.x_greatest - b.x_least);
      contact.width = std::min(contact.width, b.y_greatest - b.y_least);
    }
    const Status status = steps_.solve(fine, contact);
    if (status != Status::ok && status != Status::inaccurate) return status;
    if (beyond_bounds_) return tell_beyond_bounds(fine);
    return status == Status::ok ? tell_if_inclined(fine) : status;
  }

  Status tell_beyond_bounds(const Solver& fine) const {
    fine.host.caveat(Status::rim_contact, (std::string("frames: ") + beyond_bounds_).c_str());
    return Status::rim_contact;
  }

  /// Solves on strips that fit the contact, of two counts, and on finer ones until the accuracy asked for is met.
  /// Nothing: strips do not fit this scene.
  std::optional<Status> solve_on_strips(Solver& fine) {
    // Friction carries a little less on strips than it does; pairs of frames share loads that feel that.
    if (!strips_may_fit(fine.scene, fine.bodies()) || limit_differs(fine.scene)) return std::nullopt;
    find_shape(fine);
    if (very_unlike(fine.pair())) return std::nullopt;
    const bool sharp =
        std::any_of(shape_.outline.begin(), shape_.outline.end(), [&](const Outline& o) { return ends_sharply(o); });
    if (beyond_bounds_ || sharp || shape_.conformal) return std::nullopt;
    fine.scale_tangential_loads(1);
    std::optional<double> area;
    if (shape_.outline.empty() && dundurs_beta(fine.pair()) == 0)
      area = std::numbers::pi * shape_.place.length * shape_.place.width;
    const std::optional<Status> found = strips_.solve(fine, shape_.box, area);
    missed_corners_ = strips_.missed_corners();
    return found == Status::ok && missed_corners_ ? tell_missed_corner(fine) : found;
  }

  /// Says whether a body ends where the contact does, and its end is not rounded by much more than bodies overlap.
  bool ends_sharply(const Outline& outline) const {
    if (!outline.ends_body()) return false;
    constexpr double much = 10;
    const Rectangle b = outline.box();
    const double x = 0.5 * (b.x_least + b.x_greatest), y = 0.5 * (b.y_least + b.y_greatest), width = b.y_greatest - y;
    const double least = gap_at_(x, y), overlap = gap_at_(b.x_greatest, y) - least;
    const auto ends = [&](double outside) {
      const auto end = end_of_body([&](double at) { return gap_at_(x, at); }, y, outside);
      return end && gap_at_(x, *end) - least < much * overlap;
    };
    return !(overlap > 0) || ends(y - 2 * width) || ends(y + 2 * width);
  }

  static Status tell_missed_corner(const Solver& fine) {
    fine.host.caveat(Status::inaccurate,
                     "frames: the curvature of a profile jumps near the end of the contact, and the peak of pressure "
                     "there is narrower than the frame resolves: the largest pressure is too low");
    return Status::inaccurate;
  }

  Status solve_on_levels(Solver& fine) {
    find_shape(fine);
    // A level stays while the accuracy asked for does.
    if (const double asked = fine.scene.options.frame_accuracy; level_ >= level_count() || asked != asked_) {
      level_ = first_level(asked);
      asked_ = asked;
    }
    for (;; ++level_) {
      const Status status = solve_on_fitting(fine);
      if (status == Status::coarse && level_ + 1 < level_count()) continue;
      if (status != Status::ok) {
        (coarse_solved_ ? *coarse_ : fine).tell(status);
        return status;
      }
      const double wanted = fine.scene.options.frame_accuracy, reached = error_reached(fine);
      if (reached <= wanted) break;
      if (level_ + 1 == level_count()) {
        ended_inaccurate_ = true;
        return StripLevels::tell_inaccurate(fine, reached);
      }
    }
    // The finest pair alone is solved while it is not fine enough. Once it is, the next scene begins anew.
    if (std::exchange(ended_inaccurate_, false)) level_ = levels.size();
    if (beyond_bounds_) return tell_beyond_bounds(fine);
    if (missed_corners_) return tell_missed_corner(fine);
    return tell_if_inclined(fine);
  }

  /// Reports inclined normals that frames do not follow. Frames follow surfaces across the rolling direction alone.
  Status tell_if_inclined(const Solver& fine) const {
    Vec2 mean = inclination_.mean, turned = inclination_.turned;
    if (shape_.conformal) mean[1] = turned[1] = 0;
    return tell_inclined(fine, std::atan(length(mean)), std::atan(length(turned)));
  }

  /// Returns what has to be below the accuracy asked for. Largest pressures are judged less sharply than forces, and
  /// only where they have a bound.
  double error_reached(Solver& fine) {
    const double error = fine.error_estimate();
    if (!shape_.sharp || !(fine.scene.options.pressure_length > 0) || !coarse_solved_) return error;
    return std::max(error,
                    std::abs(1 - find_statistic(*coarse_, "max_pressure") / find_statistic(fine, "max_pressure")) / 4);
  }

  std::size_t level_count() const {
    if (shape_.unlike && !shape_.conformal) return levels.size();
    return found_.speed != 0 && shape_.lattice ? creeping_levels : usual_levels;
  }
  /// Returns the error that the finer frame of a level usually has for the shape.
  double usual_error(std::size_t level) const {
    constexpr double unlike = 0.23;  // error times intervals, 24 random contacts on rigid bodies
    return shape_.unlike ? unlike / static_cast<double>(2 * levels[level].across) : levels[level].usual;
  }
  std::size_t first_level(double accuracy) const {
    std::size_t level = 0;
    while (level + 1 < level_count() && usual_error(level) > 1.1 * accuracy) ++level;
    return level;
  }

  /// Sets shape_ and counts what changed it.
  void find_shape(Solver& fine) {
    const Scene& scene = fine.scene;
    PairOfBodies pair = fine.bodies();
    if (const auto quadratic = scene.quadratic_gap();
        quadratic && !pair.meshed() && pair.half_spaces() && !scene.tilts()) {
      shape_.conformal = false;
      inclination_ = {};
      if (pair.creeps()) return find_creeping(fine, {(*quadratic)[0], (*quadratic)[1], (*quadratic)[2]});
      shape_.outline.clear();
      const HertzContact hertz =
          find_ellipse(fine, {(*quadratic)[0], (*quadratic)[1], (*quadratic)[2]}, contact_modulus(fine.pair()));
      shape_.unlike = shape_.lattice = !fitted_instead_ && unlike_under_friction(pair, scene.friction(0, 0));
      const FramePlace before = std::exchange(shape_.place, place_of_disc(hertz.larger, hertz.smaller, hertz.angle));
      if (shape_.lattice) {
        if (!(shape_.place == before)) ++shapes_;
        gap_at_ = [g = *quadratic](double x, double y) { return g[0] * x * x + g[1] * y * y + g[2] * x * y; };
      }
      shape_.load = hertz.load;
      shape_.stretch = stretch_by_friction(dundurs_beta(fine.pair()), scene.friction(0, 0));
      shape_.find_box();
      shape_.sharp = false;
      beyond_bounds_ = nullptr;
      return;
    }
    if (scene.tilts() && scene.quadratic_gap())
      fail(Status::err_state,
           "no frame was given: with tilts the library makes one where the gap is on a grid or between profiles or "
           "meshes; else call rollcon_contact_frame_rectangle or another maker of frames");
    if (!is_gap_known(scene, pair))
      fail(Status::err_state,
           "no frame was given: the library makes one where the gap is known between nodes, too "
           "(rollcon_contact_set_gap_quadratic, rollcon_contact_set_gap_grid, profiles of the bodies); else call "
           "rollcon_contact_frame_ellipse, rollcon_contact_frame_nodes or rollcon_contact_frame_from_body");
    pair = fine.pair();
    Found now = found_now(fine);
    if (!scene.has_gap() || pair.meshed()) {
      now.pose = scene.revision.pose;
      now.axes = scene.revision.axes;
    }
    now.conformal = scene.has_gap() || pair.meshed() ? -1 : conformal_;
    now.accuracy = now.conformal >= 0 ? scene.options.frame_accuracy : 0;
    now.unlike =
        pair.half_spaces() && !pair.meshed() && !pair.creeps() && unlike_under_friction(pair, scene.friction(0, 0));
    now.tilted = scene.tilts();
    if (now.tilted) now.tilts = tilts_for(fine);
    if (!shape_.outline.empty() && now == found_) return;
    gap_ = known_gap(scene, pair);
    gap_at_ = [this](double x, double y) { return (*gap_)(x, y); };
    const auto gap = [this, now](double x, double y) {
      return gap_at_(x, y) - (now.tilted ? now.tilts[0] * y - now.tilts[1] * x : 0);
    };
    const PatchScene on{gap,
                        gap_->bounds(),
                        now.modulus,
                        now.speed,
                        now.how == How::by_force,
                        now.value,
                        !scene.has_gap() && !pair.meshed()};
    Patches patches = search_.find(fine, on);
    inclination_ = {};
    if (!scene.has_gap() && !pair.meshed()) find_inclination(patches);
    const double wanted = scene.options.frame_accuracy;
    const bool bent = inclination_.bent() > wanted;
    shape_.conformal = now.conformal > 0 || (may_follow(fine) && !bent && inclination_.off_across() > wanted);
    if (shape_.conformal && !bent)
      patches = search_.find_inclined(fine, on, [this](double x, double y) {
        Heights h;
        return gap_->heights(x, y, h) ? 1 / std::hypot(1.0, 0.5 * (h.slope[0][1] + h.slope[1][1])) : 1.0;
      });
    take_outlines(fine, patches, now);
    shape_.lattice = shape_.lattice || (shape_.conformal && bent);
    beyond_bounds_ = patches.at_bounds ? gap_->beyond_bounds() : nullptr;
  }

  /// Finds where bodies that creep touch under a quadratic gap: ahead of where elastic ones do.
  void find_creeping(Solver& fine, const QuadraticGap& given) {
    const Scene& scene = fine.scene;
    const Load& normal = scene.load(Direction::normal);
    const Found now = found_now(fine);
    beyond_bounds_ = nullptr;
    if (!shape_.outline.empty() && now == found_) return;
    gap_at_ = [given](double x, double y) { return given.a * x * x + given.b * y * y + given.c * x * y; };
    // The search looks so much further than relaxed bodies touch.
    constexpr double wider = 2;
    const HertzContact largest = find_ellipse(fine, given, relaxed_modulus(fine.pair()));
    const FramePlace place = place_of_disc(largest.larger, largest.smaller, largest.angle);
    const double x = wider * std::hypot(place.length, place.shear), y = wider * place.width;
    const Patches patches = search_.find(
        fine, {gap_at_, {-x, x, -y, y}, now.modulus, now.speed, normal.how == How::by_force, normal.value});
    take_outlines(fine, patches, now);
  }

  /// Returns what frames for outlines are found from.
  static Found found_now(Solver& fine) {
    const PairOfBodies pair = fine.pair();
    const Load& normal = fine.scene.load(Direction::normal);
    Found now{fine.scene.revision.gap, contact_modulus(pair), normal.how, normal.value};
    if (pair.creeps()) now.speed = fine.scene.speed({0, 0, 0});
    return now;
  }

  void take_outlines(Solver& fine, const Patches& patches, const Found& now) {
    const PairOfBodies pair = fine.bodies();
    shape_.outline = patches.outline;
    shape_.find_box();
    constexpr double too_hollow = 0.1;
    shape_.unlike = now.unlike;
    // Lattices are fast for half-spaces that creep.
    shape_.lattice = shape_.unlike || (now.speed != 0 && pair.half_spaces()) ||
                     std::any_of(shape_.outline.begin(), shape_.outline.end(),
                                 [](const Outline& outline) { return outline.hollow() > too_hollow; });
    shape_.stretch = FrameShape::usual_stretch;
    shape_.at_body_ends = surfaces_deform(pair) ? AtBodyEnds::even : AtBodyEnds::closer;
    shape_.sharp = !pair.meshed() && !fine.scene.has_gap() &&
                   std::any_of(shape_.outline.begin(), shape_.outline.end(),
                               [](const Outline& outline) { return outline.ends_body(); });
    shape_.lattice = shape_.lattice || shape_.sharp;
    found_ = now;
    ++shapes_;
    // Pressures at a sharp end depend on the frame: no level is taken over from the scene before.
    if (shape_.at_body_ends == AtBodyEnds::closer &&
        std::any_of(shape_.outline.begin(), shape_.outline.end(), [](const Outline& o) { return o.ends_body(); }))
      level_ = levels.size();
  }

  /// Returns tilts that are given or were found last for moments, at first the gap's slope where the load acts.
  Tilts tilts_for(Solver& fine) {
    const Scene& scene = fine.scene;
    const Load* const load[2] = {&scene.load(Direction::tilt1), &scene.load(Direction::tilt2)};
    if (const double normal = scene.load(Direction::normal).value;
        !std::exchange(tilts_known_, true) && normal > 0 && scene.load(Direction::normal).how == How::by_force) {
      const std::unique_ptr<KnownGap> gap = known_gap(scene, fine.pair());
      const double x = load[1]->value / normal, y = -load[0]->value / normal;
      const Rectangle b = gap->bounds();
      const double step = 1e-3 * std::min(b.x_greatest - b.x_least, b.y_greatest - b.y_least);
      tilts_ = {((*gap)(x, y + step) - (*gap)(x, y - step)) / (2 * step),
                ((*gap)(x - step, y) - (*gap)(x + step, y)) / (2 * step)};
    }
    for (std::size_t t = 0; t < 2; ++t) {
      if (load[t]->how == How::by_motion) tilts_[t] = load[t]->value;
      if (!std::isfinite(tilts_[t])) tilts_[t] = 0;
    }
    return tilts_;
  }

  /// Takes the tilts found last; returns false if no tilt is unknown.
  bool take_found_tilts(const Solver& fine) {
    const MotionValues found = fine.motions();
    bool any = false;
    for (const auto& [t, direction] : {std::pair{0, Direction::tilt1}, {1, Direction::tilt2}})
      if (fine.scene.load(direction).how == How::by_force) tilts_[at(t)] = found[at(t) + tilt1], any = true;
    return any;
  }

  static HertzContact find_ellipse(Solver& fine, const QuadraticGap& gap, double modulus) {
    if (!has_ellipse(gap))
      fail(Status::err_state,
           "no frame was given, and the gap %g x^2 %c %g y^2 %c %g x y does not grow in all directions: no ellipse "
           "bounds the contact; call rollcon_contact_frame_rectangle or another maker of frames",
           gap.a, gap.b < 0 ? '-' : '+', std::abs(gap.b), gap.c < 0 ? '-' : '+', std::abs(gap.c));
    const Load& normal = fine.scene.load(Direction::normal);
    HertzContact hertz = normal.how == How::by_force ? hertz_by_load(gap, modulus, normal.value)
                                                     : hertz_by_approach(gap, modulus, normal.value);
    // Bodies that do not touch still have a frame, about a thousandth of the radius of curvature in size.
    if (!(hertz.larger > 0 && hertz.smaller > 0 && std::isfinite(hertz.larger)))
      hertz = hertz_by_approach(gap, modulus, 1e-6 / (gap.a + gap.b));
    return hertz;
  }

  /// Gives longer strips to patches whose edge friction moves outwards, or that the search found too small.
  Status solve_on_fitting(Solver& fine) {
    const double longer = shape_.unlike ? 1.1 : 1.02;
    constexpr int most_trials = 5;
    Status status = solve_pair(fine);
    for (int trial = 0; status == Status::rim_contact && !elliptic() && trial < most_trials; ++trial) {
      shape_.stretch *= longer;
      ++shapes_;
      status = solve_pair(fine);
    }
    // A step is made on both frames, whatever the finer one says: each has its own start for the next step.
    if (coarse_solved_ || fine.scene.step_kind() == StepKind::steady || !is_answer(status)) return status;
    const Status below = coarse_->solve();
    return is_answer(below) ? status : below;
  }

  Status solve_pair(Solver& fine) {
    if (!coarse_) coarse_ = fine.another();
    coarse_->take_over(fine);
    if (const StepHistory& steps = fine.steps(); steps.of_steps && !coarse_->steps().of_steps) {
      coarse_->steps().last = steps.last;
      coarse_->steps().of_steps = true;
    }
    lay_frames(fine.scene, coarse_->scene);
    share_loads(fine);
    const Status status = fine.solve();
    coarse_solved_ = status == Status::ok;
    if (!coarse_solved_) return status;
    const Status below = coarse_->solve();
    if (below != Status::ok) return below;
    fine.extrapolate_from(*coarse_, family(fine));
    // Peaks of half-spaces on strips have errors of second order, too: nodes of the coarser frame are nodes of the
    // finer.
    if (!shape_.lattice && fine.bodies().half_spaces()) {
      const double peak = find_statistic(fine, "max_pressure"), before = find_statistic(*coarse_, "max_pressure");
      fine.derived().largest_pressure = peak + (peak - before) / 3;
    }
    return status;
  }

  /// Gives each frame of a pair loads of the same utilisation, that of what the frames tend to, because friction
  /// carries less on coarse frames, its moment by 2 % on 6 x 4 strips.
  void share_loads(Solver& fine) {
    fine.scale_tangential_loads(1);
    coarse_->scale_tangential_loads(1);
    if (!limit_differs(fine.scene)) return;
    std::optional<FrictionShare> taken = fine.frictionless_share();
    const std::optional<FrictionShare> coarse = coarse_->frictionless_share();
    if (!taken || !coarse || !(taken->sliding > 0 && coarse->sliding > 0)) return;
    double share = 0;
    if (shape_.outline.empty()) {
      if (!hertz_friction_) hertz_friction_ = std::make_unique<HertzFriction>();
      share = hertz_friction_->share(fine.scene, shape_.place, shape_.load).together;
    } else {
      const double left_over = 1 / (std::exp2(family(fine).order) - 1);
      share = 1 / (1 / taken->sliding + left_over * (1 / taken->sliding - 1 / coarse->sliding));
    }
    if (!(share < 1)) {
      for (double* const s : {&taken->force, &taken->moment, &taken->sliding}) *s *= share / taken->sliding;
      fail(Status::err_load, "%s: there is no steady solution", describe_beyond_friction(*taken).c_str());
    }
    fine.scale_tangential_loads(share / taken->sliding);
    coarse_->scale_tangential_loads(share / coarse->sliding);
  }

  /// Says whether the limits of both frames differ: they do not for forces alone under a given load.
  static bool limit_differs(const Scene& scene) {
    const auto loaded = [&](Direction d) { return scene.load(d).how == How::by_force && scene.load(d).value != 0; };
    if (loaded(Direction::spin)) return true;
    return scene.load(Direction::normal).how == How::by_motion &&
           (loaded(Direction::longitudinal) || loaded(Direction::lateral));
  }

  /// Says whether frames are those of an ellipse.
  bool elliptic() const { return shape_.outline.empty() && !shape_.lattice; }

  FrameFamily family(Solver& on) const {
    // Differences halve, or shrink a little more, when intervals are halved.
    constexpr double order_of_unlike = 1.2;
    if (shape_.unlike) return {order_of_unlike, 1, usual_error(level_)};
    // The slip that pressures of unlike bodies cause is off by more on the coarser frame than order 2 says, and two
    // frames may agree by chance.
    FrameFamily of{.order = 2};
    if (const PairOfBodies pair = on.pair(); very_unlike(pair) && !pair.meshed() && !on.solution().frictionless) {
      constexpr double order = 2.6, off = 22;  // error over beta, times intervals to that power
      const double intervals = static_cast<double>(2 * levels[level_].across);
      of.order = order;
      of.counted = 1.7;  // makes the estimate that of order 2
      of.least_tangential = off * std::abs(dundurs_beta(pair)) / std::pow(intervals, order);
    }
    // Contacts fill a stretched ellipse on the side that friction moves them to, on small frames as far as nodes tell
    // on both.
    if (elliptic()) {
      const Level& l = levels[level_];
      const bool filled =
          find_statistic(on, "nodes_contact") == static_cast<double>((2 * l.along - 1) * (2 * l.across - 1));
      of.cover = 1 / (filled ? shape_.stretch * shape_.stretch : shape_.stretch);
      return of;
    }
    if (!shape_.lattice) {
      of.cover = 1 / (FrameShape::usual_stretch * FrameShape::usual_stretch);
      return of;
    }
    // These fit contacts of wheels and rails, 12 to 96 intervals across: the outline's place among the nodes is chance.
    constexpr double order = 1.5, off = 0.08;  // error over intervals
    return {order, 1, off / static_cast<double>(2 * levels[level_].across)};
  }

  void lay_frames(Scene& fine, Scene& coarse) {
    const Level& l = levels[level_];
    const FramePlace place{shape_.stretch * shape_.place.length, shape_.stretch * shape_.place.width,
                           shape_.stretch * shape_.place.shear};
    const Made now{level_, fine.revision.mesh, elliptic() ? -1 : fine.revision.axes, elliptic() ? -1 : shapes_,
                   shape_.conformal};
    if (!(now == made_)) {
      if (elliptic()) {
        fine.set_placed_frame(strips_mesh({}, strips_of_ellipse(1, 1, 0, 2 * l.across), 2 * l.along), place);
        coarse.set_placed_frame(strips_mesh({}, strips_of_ellipse(1, 1, 0, l.across), l.along), place);
      } else if (shape_.lattice) {
        fine.set_made_frame(lattice_over(shape_, gap_at_, fine.axes(), 2 * l.along, 2 * l.across), false, false);
        coarse.set_made_frame(lattice_over(shape_, gap_at_, coarse.axes(), l.along, l.across), false, false);
      } else {
        fine.set_made_frame(strips_over(shape_, gap_at_, fine.axes(), 2 * l.along, 2 * l.across), true, false);
        coarse.set_made_frame(strips_over(shape_, gap_at_, coarse.axes(), l.along, l.across), true, false);
      }
      made_ = now;
      made_.mesh = fine.revision.mesh;
    } else if (elliptic() && (!(place == fine.place()) || placed_on_ != fine.revision.axes)) {
      fine.place_frame(place);
      coarse.place_frame(place);
    }
    placed_on_ = fine.revision.axes;
  }

  struct Made {
    std::size_t level = levels.size();
    std::int64_t mesh = -1, axes = -1, shape = -1;
    bool conformal = false;
    bool operator==(const Made&) const = default;
  };

  StripLevels strips_;
  StepFrames steps_;
  std::unique_ptr<Solver> coarse_;
  bool coarse_solved_ = false;  // the last pair solved it
  bool missed_corners_ = false;
  std::int64_t conformal_ = 0;   ///< option for this solve
  bool fitted_instead_ = false;  ///< lattices of unlike bodies gave way to fitted frames
  Inclination inclination_;
  PatchSearch search_;
  std::unique_ptr<HertzFriction> hertz_friction_;  ///< made when it is asked for
  FrameShape shape_;
  Found found_;
  Tilts tilts_{};                        ///< tilts for which frames were made last
  bool tilts_known_ = false;             ///< tilts come from a solve or a guess
  std::unique_ptr<KnownGap> gap_;        ///< gap of the scene being solved
  GapBetween gap_at_;                    ///< that gap, or the quadratic one of bodies that creep
  const char* beyond_bounds_ = nullptr;  ///< text for a contact that reaches the bounds
  std::int64_t shapes_ = 0;              ///< number of shapes found so far
  std::size_t level_ = levels.size();    ///< levels.size(): none yet
  double asked_ = 0;
  bool ended_inaccurate_ = false;  ///< the last pair was the finest one, and not fine enough
  bool steps_on_lattice_ = false;  ///< the last step has a single frame, no pair
  Made made_;
  std::int64_t placed_on_ = -1;  ///< revision of the axes of the last placed frame
};

}  // namespace

std::unique_ptr<FrameMaker> make_frame_maker() {
  return std::make_unique<AutomaticFrames>();
}

}  // namespace rollcon
