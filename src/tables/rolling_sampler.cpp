#include "tables/rolling_sampler.hpp"

#include <cmath>

#include "bodies/body.hpp"
#include "bodies/body_kind.hpp"
#include "framing/hertz.hpp"
#include "framing/makers.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// Friction between like bodies is no matter.
constexpr double usual_friction = 0.3;

}  // namespace

RollingSampler::RollingSampler(double ratio, double poisson, std::int64_t along, std::int64_t across, bool fine)
    : context_(std::make_shared<Context>()), cancel_(std::make_unique<std::atomic<bool>>(false)) {
  make(ratio, {{1, 1}, {poisson, poisson}, {}}, usual_friction, along, across, fine);
}

RollingSampler::RollingSampler(double ratio, const UnlikePair& pair, double friction, std::int64_t along,
                               std::int64_t across)
    : context_(std::make_shared<Context>()), cancel_(std::make_unique<std::atomic<bool>>(false)) {
  make(ratio, pair, friction, along, across, true);
}

void RollingSampler::make(double ratio, const UnlikePair& pair, double friction, std::int64_t along,
                          std::int64_t across, bool fine) {
  context_->set_threads(1);
  const double modulus = 1 / (1 - pair.mean_poisson());  // E* of bodies whose mean of 1 / G is 1
  const QuadraticGap gap = gap_with_ratio(ratio, modulus);
  const HertzContact unit = hertz_by_load(gap, modulus, 1);
  const double load = std::pow(unit.larger * unit.smaller, -1.5);
  bound_ = friction * load;
  std::shared_ptr<Body> body[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const double flexibility = pair.flexibility[i], poisson = pair.poisson[i];
    const BodyKind kind = flexibility > 0 ? BodyKind::halfspace : BodyKind::rigid;
    body[i] = std::make_shared<Body>(context_, static_cast<std::int32_t>(kind));
    if (flexibility > 0) body[i]->set_elastic(0, 2 * (1 + poisson) / flexibility, poisson);
  }
  // The first argument is Dundurs' beta, for half-spaces.
  const double stretch = stretch_by_friction(pair.strained() * modulus / 2, friction);
  const double a = stretch * std::sqrt(ratio), b = stretch / std::sqrt(ratio);
  for (const std::int64_t finer : {2, 1}) {
    if (finer == 2 && !fine) continue;
    auto solver = std::make_unique<Solver>(Host{.context = context_, .cancel = cancel_.get()}, body[0], body[1]);
    Scene& scene = solver->scene;
    scene.set_gap_quadratic(gap.a, gap.b, gap.c);
    scene.set_friction("coulomb", 1, &friction);
    scene.prescribe(static_cast<std::int32_t>(Direction::normal), static_cast<std::int32_t>(How::by_force), load);
    scene.set_made_frame(strips_mesh({}, strips_of_ellipse(a, b, 0, finer * across), finer * along), true, true);
    (finer == 2 ? fine_ : coarse_) = std::move(solver);
  }
}

void RollingSampler::reset() {
  if (fine_) fine_->reset();
  coarse_->reset();
}

std::array<double, 3> RollingSampler::solve_on(Solver& solver, const std::array<double, 3>& creepage) {
  solver.scene.set_creep(bound_ * creepage[0], bound_ * creepage[1], bound_ * creepage[2]);
  Status status = solver.solve();
  if (status == Status::not_converged) {
    solver.reset();
    status = solver.solve();
  }
  if (status == Status::not_converged)
    fail(Status::err_internal, "a case of the table did not converge: creepages %g %g, spin %g over mu Fn / (G a b)",
         creepage[0], creepage[1], creepage[2]);
  const auto [force, moment] = solver.loads();
  return {force[0] / bound_, force[1] / bound_, moment[2] / bound_};
}

RollingSampler::Forces RollingSampler::solve(const std::array<double, 3>& creepage) {
  Forces f{};
  f.extrapolated = f.coarse = solve_on(*coarse_, creepage);
  if (!fine_) return f;
  const auto fine = solve_on(*fine_, creepage);
  for (std::size_t i = 0; i < 3; ++i) f.extrapolated[i] = (4 * fine[i] - f.coarse[i]) / 3;
  return f;
}

}  // namespace rollcon
