#include "contact/results/equivalent_ellipse.hpp"

#include <cmath>
#include <numbers>

#include "bodies/body.hpp"
#include "contact/solution.hpp"
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

Moments moments_of(const Solution& s) {
  const Frame& frame = s.prepared->frame;
  const Problem& p = s.prepared->problem;
  Moments m;
  const auto each = [&](auto add) {
    for (std::size_t k = 0; k < at(p.nodes); ++k)
      if (s.iterate.lambda[2][k] < 0) add(-p.weight[k] * s.iterate.lambda[2][k], frame.x[k], frame.y[k]);
  };
  each([&](double f, double x, double y) { m.load += f, m.x += f * x, m.y += f * y; });
  if (!(m.load > 0)) fail(Status::err_state, "nothing carries load");
  m.x /= m.load;
  m.y /= m.load;
  each([&](double f, double x, double y) {
    m.xx += f * (x - m.x) * (x - m.x) / m.load;
    m.yy += f * (y - m.y) * (y - m.y) / m.load;
  });
  return m;
}

// Fits creepages to the rigid slip by least squares, weighted by pressure. Slip is taken at points that the scheme of
// convection chooses, a constant distance from the nodes.
void add_slip(const Solution& s, const Moments& m, EquivalentEllipse& to) {
  const Problem& p = s.prepared->problem;
  const std::vector<double>&x = p.convection.slip_x, &y = p.convection.slip_y;
  const auto each = [&](auto add) {
    for (std::size_t k = 0; k < at(p.nodes); ++k)
      if (s.iterate.lambda[2][k] < 0) add(k, -p.weight[k] * s.iterate.lambda[2][k] / m.load);
  };
  double mean_x = 0, mean_y = 0, turning = 0, arm = 0;
  each([&](std::size_t k, double share) { mean_x += share * x[k], mean_y += share * y[k]; });
  each([&](std::size_t k, double share) {
    const auto i = static_cast<std::int64_t>(k);
    const double s1 = p.rigid_slip1(i, s.iterate.motion), s2 = p.rigid_slip2(i, s.iterate.motion);
    to.creepage[0] += share * s1;
    to.creepage[1] += share * s2;
    turning += share * ((x[k] - mean_x) * s2 - (y[k] - mean_y) * s1);
    arm += share * ((x[k] - mean_x) * (x[k] - mean_x) + (y[k] - mean_y) * (y[k] - mean_y));
    to.friction += share * p.law->coefficient({s.given.coefficient(p.mu, k), -s.iterate.lambda[2][k],
                                               s.iterate.lambda[0][k], s.iterate.lambda[1][k], s1, s2});
  });
  to.creepage[2] = turning / arm;
  to.creepage[0] -= to.creepage[2] * (m.y - mean_y);
  to.creepage[1] += to.creepage[2] * (m.x - mean_x);
  for (double& c : to.creepage) c /= p.motion_scale;
}

}  // namespace

// Takes the means of 1 / G and nu / G.
CommonElasticity common_elasticity(const Body& body1, const Body& body2) {
  double flexible = 0, sideways = 0, strained = 0, sign = 1;
  for (const Body* body : {&body1, &body2}) {
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

EquivalentEllipse equivalent_ellipse(const Solution& state, double area) {
  require_comparable(state);
  const Moments m = moments_of(state);
  EquivalentEllipse e;
  const auto& body = state.prepared->pair.body;
  const CommonElasticity common = common_elasticity(*body[0], *body[1]);
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
  e.centre = {m.x, m.y};
  e.a = a * std::sqrt(filled);
  e.b = b * std::sqrt(filled);
  add_slip(state, m, e);
  return e;
}

}  // namespace rollcon
