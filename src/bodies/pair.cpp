#include "bodies/pair.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/layer/layered_compliance.hpp"
#include "bodies/sum_compliance.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

HalfspaceConstants constants_of(const Body& body, int which) {
  if (!body.traits().half_space) return {};
  return halfspace_constants(body.young(), body.poisson(), which == 0 ? 1 : -1);
}

HalfspaceConstants together(const HalfspaceConstants& c1, const HalfspaceConstants& c2) {
  HalfspaceConstants sum{c1.cn + c2.cn, c1.cv + c2.cv, c1.ck + c2.ck};
  // Equal (1 - 2 nu)/G decouples; rounding of two equal materials must not couple them again.
  if (std::abs(sum.ck) <= 1e-14 * (std::abs(c1.ck) + std::abs(c2.ck))) sum.ck = 0;
  return sum;
}

}  // namespace

HalfspaceConstants half_spaces_of(const PairOfBodies& pair) {
  return together(constants_of(*pair.body[0], 0), constants_of(*pair.body[1], 1));
}

std::vector<LaggingBody> lags_of(const PairOfBodies& pair, int which) {
  std::vector<LaggingBody> bodies;
  for (int b = 0; b < 2; ++b) {
    const Body& body = *pair.body[at(b)];
    if (!body.traits().half_space || !body.creeps() || (which >= 0 && which != b)) continue;
    LaggingBody own{constants_of(body, b), {}};
    for (const PronyTerm& term : creep_of(body.relaxation().term))
      own.lag.push_back({term.ratio, pair.speed * term.time});
    if (!bodies.empty() && pair.body[0]->relaxation() == body.relaxation())
      bodies[0].c = together(bodies[0].c, own.c);
    else
      bodies.push_back(std::move(own));
  }
  return bodies;
}

// A lag of ratio f loses -f times the mean of the slope upstream.
std::vector<std::unique_ptr<Compliance>> make_losses(const Frame& frame, const PairOfBodies& pair, double accuracy,
                                                     int threads, int which) {
  std::vector<std::unique_ptr<Compliance>> losses;
  std::vector<LaggingBody> bodies = lags_of(pair, which);
  for (LaggingBody& body : bodies)
    for (Lag& lag : body.lag) lag = {-lag.ratio, lag.length, true};
  if (!bodies.empty()) losses.push_back(make_lagging_compliance(frame, {}, std::move(bodies), accuracy, threads));
  PairOfBodies losing = pair;
  losing.losses = true;
  for (int b = 0; b < 2; ++b)
    if (const Body& body = *pair.body[at(b)]; body.creeps() && body.traits().section && (which < 0 || which == b))
      losses.push_back(make_body_compliance(frame, losing, b, accuracy, threads));
  return losses;
}

std::unique_ptr<Compliance> make_pair_compliance(const Frame& frame, const PairOfBodies& pair, double accuracy,
                                                 int threads) {
  std::vector<std::unique_ptr<Compliance>> parts;
  const HalfspaceConstants sum = half_spaces_of(pair);
  if (sum.cn > 0) parts.push_back(make_lagging_compliance(frame, sum, lags_of(pair), accuracy, threads));
  for (int which = 0; which < 2; ++which)
    if (!pair.body[at(which)]->traits().half_space)
      if (auto part = make_body_compliance(frame, pair, which, accuracy, threads)) parts.push_back(std::move(part));
  if (std::none_of(parts.begin(), parts.end(), [](const auto& part) { return part->resolves_frame(); }) &&
      !parts.empty())
    fail(Status::err_mesh,
         "the frame has more nodes than the faces of the body below it, whose option between_nodes "
         "is 1: they cannot tell its tractions apart; coarsen the frame or set between_nodes to 0");
  auto both = make_sum(std::move(parts));
  return pair.layer > 0 ? make_layered(frame, std::move(both), pair.layer) : std::move(both);
}

std::unique_ptr<Compliance> make_body_compliance(const Frame& frame, const PairOfBodies& pair, int which,
                                                 double accuracy, int threads) {
  const BodyTraits& traits = pair.body[at(which)]->traits();
  if (!traits.make_compliance) return nullptr;
  return traits.make_compliance(frame, pair, which, accuracy, threads);
}

double contact_modulus(const PairOfBodies& pair) {
  double cn = 0;
  for (int which = 0; which < 2; ++which) {
    const Body& body = *pair.body[at(which)];
    if (!body.rigid()) cn += halfspace_constants(body.young(), body.poisson(), 1).cn;
  }
  return 1 / (std::numbers::pi * cn);
}

double relaxed_modulus(const PairOfBodies& pair) {
  double cn = 1 / (std::numbers::pi * contact_modulus(pair));
  for (const LaggingBody& body : lags_of(pair))
    for (const Lag& lag : body.lag) cn += lag.ratio * body.c.cn;
  return 1 / (std::numbers::pi * cn);
}

double dundurs_beta(const PairOfBodies& pair) {
  double cn = 0, ck = 0;
  for (int which = 0; which < 2; ++which) {
    const Body& body = *pair.body[at(which)];
    if (body.rigid()) continue;
    const HalfspaceConstants own = halfspace_constants(body.young(), body.poisson(), which == 0 ? 1 : -1);
    cn += own.cn;
    ck += own.ck;
  }
  return ck / cn;
}

}  // namespace rollcon
