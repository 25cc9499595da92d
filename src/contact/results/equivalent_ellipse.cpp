#include "contact/results/equivalent_ellipse.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "bodies/body.hpp"
#include "contact/solution.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// A patch fills the ellipse that has its pressures' second moments: an ellipse all of it, two peaks that are one patch
/// 0.63, two patches at a distance of their own length less than a half.
constexpr double least_filled = 0.5;

void require_comparable(const Solution& s) {
  for (std::size_t i = 0; i < 2; ++i)
    if (s.prepared->pair.body[i]->meshed())
      fail(Status::err_unsupported, "body %zu has a mesh: a Hertzian contact stands for half-spaces and rigid bodies",
           i + 1);
  if (!s.prepared->problem.law->isotropic())
    fail(Status::err_unsupported, "friction is not the same in all directions, as that of a Hertzian contact is");
  if (s.prepared->pair.layer > 0)
    fail(Status::err_unsupported, "a layer lies between the bodies, which a Hertzian contact has not");
  if (s.prepared->step == StepKind::shift)
    fail(Status::err_state, "bodies are shifted, not rolled: there are no creepages");
}

struct Moments {
  double load = 0, x = 0, y = 0, xx = 0, yy = 0;
};

Moments moments_of(std::span<const LoadedPlace> place) {
  Moments m;
  for (const LoadedPlace& p : place) m.load += p.load, m.x += p.load * p.x, m.y += p.load * p.y;
  if (!(m.load > 0)) fail(Status::err_state, "nothing carries load");
  m.x /= m.load;
  m.y /= m.load;
  for (const LoadedPlace& p : place) {
    m.xx += p.load * (p.x - m.x) * (p.x - m.x) / m.load;
    m.yy += p.load * (p.y - m.y) * (p.y - m.y) / m.load;
  }
  return m;
}

// Fits creepages to the rigid slip by least squares, weighted by pressure. Slip is taken at points that the scheme of
// convection chooses, a constant distance from the nodes.
void add_slip(std::span<const LoadedPlace> place, const Moments& m, EquivalentEllipse& to) {
  double mean_x = 0, mean_y = 0, turning = 0, arm = 0;
  for (const LoadedPlace& p : place) mean_x += p.load / m.load * p.slip_x, mean_y += p.load / m.load * p.slip_y;
  for (const LoadedPlace& p : place) {
    const double part = p.load / m.load, x = p.slip_x - mean_x, y = p.slip_y - mean_y;
    to.creepage[0] += part * p.slip1;
    to.creepage[1] += part * p.slip2;
    turning += part * (x * p.slip2 - y * p.slip1);
    arm += part * (x * x + y * y);
    to.friction += part * p.friction;
  }
  to.creepage[2] = turning / arm;
  to.creepage[0] -= to.creepage[2] * (m.y - mean_y);
  to.creepage[1] += to.creepage[2] * (m.x - mean_x);
}

}  // namespace

// Takes the means of 1 / G and nu / G.
CommonElasticity common_elasticity(const Body& body1, const Body& body2) {
  double flexible = 0, sideways = 0, strained = 0, sign = 1;
  for (const Body* body : {&body1, &body2}) {
    if (body->creeps())
      fail(
          Status::err_unsupported,
          "a body is viscoelastic (rollcon_body_set_viscoelastic), which creep-force tables and simplified theories do "
          "not know; allowed: elastic and rigid bodies");
    if (!body->rigid()) {
      const double of_one = 2 * (1 + body->poisson()) / body->young();
      flexible += of_one / 2;
      sideways += body->poisson() * of_one / 2;
      strained += sign * (1 - 2 * body->poisson()) * of_one / 2;
    }
    sign = -sign;
  }
  return {1 / flexible, sideways / flexible, strained};
}

// Averages the strain along the rolling direction, weighted with the pressure of Hertz that causes it: (1 - 2 nu) / (2
// G) b / (a + b) 3/4 of the greatest, by the transform of Boussinesq's solution, (1 - 2 nu) / (2 G) kx^2 / k^2.
double strain_creepage(double strained, double load, double a, double b) {
  const double greatest = 3 * load / (2 * std::numbers::pi * a * b);
  return 0.75 * greatest * b / (a + b) * strained;
}

EquivalentEllipse equivalent_ellipse(std::span<const LoadedPlace> place, double area, const CommonElasticity& common) {
  const Moments m = moments_of(place);
  EquivalentEllipse e;
  e.shear = common.shear;
  e.poisson = common.poisson;
  e.strained = common.strained;
  // The pressure of Hertz has the second moments a^2 / 5 and b^2 / 5.
  const double a = std::sqrt(5 * m.xx), b = std::sqrt(5 * m.yy), filled = area / (std::numbers::pi * a * b);
  if (!(filled > least_filled))
    fail(Status::err_state,
         "the contact fills %.2g of the ellipse that has its pressure's second moments, less than %g: it is no single "
         "patch",
         filled, least_filled);
  e.load = m.load;
  e.filled = filled;
  e.centre = {m.x, m.y};
  e.a = a * std::sqrt(filled);
  e.b = b * std::sqrt(filled);
  add_slip(place, m, e);
  return e;
}

EquivalentEllipse equivalent_ellipse(const Solution& s, double area) {
  require_comparable(s);
  const Frame& frame = s.prepared->frame;
  const Problem& p = s.prepared->problem;
  std::vector<LoadedPlace> place;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    const double normal = s.iterate.lambda[2][k];
    if (!(normal < 0)) continue;
    const auto i = static_cast<std::int64_t>(k);
    const double s1 = p.rigid_slip1(i, s.iterate.motion), s2 = p.rigid_slip2(i, s.iterate.motion);
    const double friction = p.law->coefficient(
        {s.given.coefficient(p.mu, k), -normal, s.iterate.lambda[0][k], s.iterate.lambda[1][k], s1, s2});
    place.push_back({-p.weight[k] * normal, frame.x[k], frame.y[k], p.convection.slip_x[k], p.convection.slip_y[k],
                     s1 / p.motion_scale, s2 / p.motion_scale, friction});
  }
  const auto& body = s.prepared->pair.body;
  return equivalent_ellipse(place, area, common_elasticity(*body[0], *body[1]));
}

}  // namespace rollcon
