#include "contact/results/stresses.hpp"

#include <vector>

#include "bodies/halfspace/interior.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

void require_halfspace(const Body& body, std::int32_t which) {
  if (body.kind() == BodyKind::halfspace) return;
  fail(Status::err_unsupported, "body %d is a %s body: stresses are computed inside elastic half-spaces only", which,
       body.traits().name);
}

void require_inside(const PointsInside& points, std::int32_t body) {
  for (std::int64_t p = 0; p < points.count; ++p) {
    const double n = points.xyz[3 * p + 2];
    if (body == 1 ? n > 0 : n < 0)
      fail(Status::err_argument, "coordinate n of point %lld (counting from 0) is %g, outside of body %d: allowed: %s",
           static_cast<long long>(p), n, body, body == 1 ? "0 or less" : "0 or more");
  }
}

}  // namespace

void find_stresses(const SolverState& state, std::int32_t body, const PointsInside& points, double accuracy,
                   int threads, double* stress, double* displacement) {
  const Prepared& on = *state.prepared;
  const Body& which = *on.pair.body[at(body - 1)];
  require_halfspace(which, body);
  require_inside(points, body);
  // Depth points into the body: along -n into body 1, whose tractions are lambda, along n into body 2, which has
  // -lambda. A mirrored body obeys the same laws.
  const double side = body == 1 ? 1 : -1;
  const std::size_t nodes = at(on.problem.nodes), n = at(points.count);
  std::vector<double> traction(3 * nodes), inside(points.xyz, points.xyz + 3 * n);
  for (std::size_t k = 0; k < nodes; ++k) {
    traction[3 * k] = side * state.iterate.lambda[0][k];
    traction[3 * k + 1] = side * state.iterate.lambda[1][k];
    traction[3 * k + 2] = -state.iterate.lambda[2][k];
  }
  for (std::size_t p = 0; p < n; ++p) inside[3 * p + 2] *= -side;
  const HalfspaceInterior::Material material{which.young() / (2 * (1 + which.poisson())), which.poisson()};
  const HalfspaceInterior interior(on.frame, traction.data(), material, accuracy);
  interior.evaluate(points.count, inside.data(), stress, displacement, threads);
  if (body == 2) return;
  for (std::size_t p = 0; p < n; ++p) {
    if (stress) stress[6 * p + 4] = -stress[6 * p + 4], stress[6 * p + 5] = -stress[6 * p + 5];
    if (displacement) displacement[3 * p + 2] = -displacement[3 * p + 2];
  }
}

}  // namespace rollcon
