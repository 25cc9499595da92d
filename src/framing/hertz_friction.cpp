#include "framing/hertz_friction.hpp"

#include <cmath>
#include <numbers>

#include "quadrature/rules.hpp"

namespace rollcon {

// Spreads points over the unit disc: the load within the radius sin(t) grows by 3 cos^2(t) sin(t) dt.
HertzFriction::HertzFriction() {
  constexpr double pi = std::numbers::pi;
  constexpr int rings = 16, around = 160;
  const LineRule& rule = quadrature::line_rule(rings);
  for (std::size_t i = 0; i < rule.x.size(); ++i) {
    const double t = pi / 4 * (1 + rule.x[i]), s = std::sin(t), c = std::cos(t);
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * pi * (k + 0.5) / around;
      x_.push_back(s * std::cos(angle));
      y_.push_back(s * std::sin(angle));
      weight_.push_back(pi / 4 * rule.w[i] * 3 * c * c * s / around);
    }
  }
  const std::size_t n = x_.size();
  problem_.nodes = static_cast<std::int64_t>(n);
  problem_.weight = problem_.cell_area = weight_;
  for (auto* v : {&problem_.mu, &problem_.moment_x, &problem_.moment_y, &problem_.convection.slip_x,
                  &problem_.convection.slip_y, &lambda_[0], &lambda_[1], &lambda_[2]})
    v->assign(n, 0.0);
}

FrictionShare HertzFriction::share(const Scene& scene, const FramePlace& place, double load) {
  Prescribed given;
  for (const Direction d : {Direction::longitudinal, Direction::lateral, Direction::spin}) {
    const std::size_t m = motion_of(d);
    given.by_force[m] = scene.load(d).how == How::by_force;
    given.value[m] = scene.load(d).value;
  }
  problem_.own_law = scene.law();
  problem_.law = problem_.own_law ? problem_.own_law.get() : &coulomb();
  problem_.length = std::sqrt(place.length * place.width);
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const double x = place.length * x_[k] + place.shear * y_[k], y = place.width * y_[k];
    problem_.mu[k] = scene.friction(0, y);
    problem_.moment_x[k] = weight_[k] * x;
    problem_.moment_y[k] = weight_[k] * y;
    problem_.convection.slip_x[k] = x;
    problem_.convection.slip_y[k] = y;
    lambda_[2][k] = -load;
  }
  return share_of_friction(problem_, given, lambda_);
}

}  // namespace rollcon
