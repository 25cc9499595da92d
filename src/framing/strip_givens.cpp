#include "framing/strip_givens.hpp"

#include <cmath>

#include "bodies/pair.hpp"
#include "contact/prepare/between_surfaces.hpp"
#include "support/linear_between.hpp"

namespace rollcon {

using namespace strips;

bool strips_may_fit(const Scene& scene, const PairOfBodies& pair) {
  const bool known = is_gap_known(scene, pair) || (scene.quadratic_gap() && !pair.meshed());
  return known && pair.half_spaces() && !pair.creeps() && !pair.meshed() && scene.step_kind() == StepKind::steady &&
         !scene.tilts() && !(scene.options.conformal > 0 && !scene.has_gap()) &&
         scene.options.convection == "characteristic" && choose_procedure(scene.options).standard();
}

void StripGivens::Gap::at(std::span<const Vec2> point, double* value, Vec2* slope) const {
  for (std::size_t i = 0; i < point.size(); ++i) {
    const auto [x, y] = point[i];
    if (of->quadratic_) {
      const auto& [a, b, c] = *of->quadratic_;
      value[i] = a * x * x + b * y * y + c * x * y;
      if (slope) slope[i] = {2 * a * x + c * y, 2 * b * y + c * x};
      continue;
    }
    Heights h;
    // Where a body has ended, bodies are apart.
    if (!of->known_->heights(x, y, h)) {
      value[i] = of->far_;
      if (slope) slope[i] = {0, 0};
      continue;
    }
    value[i] = h.gap();
    if (slope) slope[i] = h.slope[1] - h.slope[0];
  }
}

double StripGivens::height_between(double x, double y, Vec2* slope) const {
  Heights h;
  if (!known_ || !known_->heights(x, y, h)) h = {};
  if (slope) *slope = weight_[0] * h.slope[0] + weight_[1] * h.slope[1];
  return weight_[0] * h.height[0] + weight_[1] * h.height[1];
}

void StripGivens::Slip::at(std::span<const Vec2> point, double* value, Vec2* slope) const {
  for (std::size_t i = 0; i < point.size(); ++i) {
    value[i] =
        per_height * (of->height_between(point[i][0], point[i][1], slope ? &slope[i] : nullptr) - of->origin_height_);
    if (slope) slope[i] = per_height * slope[i];
  }
}

void StripGivens::Friction::at(std::span<const Vec2> point, double* value, Vec2* slope) const {
  for (std::size_t i = 0; i < point.size(); ++i) {
    value[i] = linear_between(y, mu, point[i][1]);
    if (slope) slope[i] = {0, slope_between(y, mu, point[i][1])};
  }
}

Vec2 StripGivens::slope(const Vec2& point) const {
  Heights h;
  return known_ && known_->heights(point[0], point[1], h) ? 0.5 * (h.slope[0] + h.slope[1]) : Vec2{};
}

void StripGivens::shift(const StripParameter& rates, double factor) {
  scene_.value += factor * rates.value;
  scene_.mu += factor * rates.mu;
  for (std::size_t k = 0; k < 3; ++k) scene_.motion[k] += factor * rates.motion[k];
}

bool StripGivens::both_at(const Vec2& point) const {
  Heights h;
  return !known_ || known_->heights(point[0], point[1], h);
}

// Reads creepages, or what velocities make of them, as contact/prepare/ does on any frame.
void StripGivens::read_motions(const Scene& scene, const Rectangle& box) {
  constexpr Direction directions[] = {Direction::longitudinal, Direction::lateral, Direction::spin};
  Vec3 creepage{}, turning{};
  if (scene.velocities_given()) {
    weight_ = {0.5, 0.5};
    const double x = 0.5 * (box.x_least + box.x_greatest), y = 0.5 * (box.y_least + box.y_greatest),
                 half = 0.5 * (box.x_greatest - box.x_least);
    Heights before, middle, after;
    if (known_ && known_->heights(x - half, y, before) && known_->heights(x, y, middle) &&
        known_->heights(x + half, y, after)) {
      const auto curvature = [&](int b) {
        return (b == 0 ? 1 : -1) * (2 * middle.height[b] - before.height[b] - after.height[b]) / (half * half);
      };
      weight_ = weights_between(curvature(0), curvature(1), half);
    }
    origin_height_ = height_between(0, 0, nullptr);
    const Vec3 origin{0, 0, origin_height_};
    speed_ = scene.speed(origin);
    const Velocity of = scene.relative_velocity();
    const Vec3 at_origin = of.at(origin);
    turning = of.angular;
    creepage = {at_origin[0] / speed_, at_origin[1] / speed_, turning[2] / speed_};
  } else {
    speed_ = scene.speed({0, 0, 0});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Load& load = scene.load(directions[k]);
    scene_.force_given[k] = load.how == How::by_force;
    scene_.motion[k] = load.how == How::by_velocity ? creepage[k] : load.value;
  }
  for (std::size_t c = 0; c < 2; ++c) {
    slip_[c].of = this;
    slip_[c].per_height = (c == 0 ? turning[1] : -turning[0]) / speed_;
    scene_.slip[c] = known_ && slip_[c].per_height != 0 ? &slip_[c] : nullptr;
  }
  creepage_ = scene_.motion;
}

std::array<double, 2> StripGivens::rigid_slip(const Vec2& point) const {
  const double height = height_between(point[0], point[1], nullptr) - origin_height_;
  return {creepage_[0] - creepage_[2] * point[1] + slip_[0].per_height * height,
          creepage_[1] + creepage_[2] * point[0] + slip_[1].per_height * height};
}

void StripGivens::read(Solver& on, const Rectangle& box) {
  const Scene& scene = on.scene;
  const PairOfBodies pair = on.bodies();
  const HalfspaceConstants bodies = half_spaces_of(pair);
  scene_.bodies = {bodies.cn, bodies.cv, bodies.ck};
  far_ = 100 * std::hypot(box.x_greatest - box.x_least, box.y_greatest - box.y_least);
  update_known_gap(scene, pair, known_);
  if (known_) known_->look_over(box);
  quadratic_ = known_ ? std::nullopt : scene.quadratic_gap();
  gap_.of = this;
  scene_.gap = &gap_;
  const Load& normal = scene.load(Direction::normal);
  scene_.by_load = normal.how == How::by_force;
  scene_.value = normal.value;
  coulomb_ = !scene.law() && scene.layer() == 0;
  friction_.y = scene.friction_places();
  friction_.mu = scene.friction_there();
  scene_.friction = scene.friction_varies_across() ? &friction_ : nullptr;
  scene_.mu = scene_.friction ? 1 : scene.friction(0, 0);
  read_motions(scene, box);
  if (coulomb_ && (scene_.friction || scene_.mu >= least_friction)) return;
  // What resists slip is not known here: the pressures alone are wanted.
  coulomb_ = coulomb_ && scene_.mu == 0;
  scene_.mu = 0;
  scene_.friction = nullptr;
  scene_.force_given = {};
  scene_.motion = {};
  scene_.slip = {};
}

}  // namespace rollcon
