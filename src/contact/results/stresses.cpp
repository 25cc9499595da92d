#include "contact/results/stresses.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "bodies/halfspace/interior_grid.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon {
namespace {

void require_halfspace(const Body& body, std::int32_t which) {
  if (body.traits().half_space) return;
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

/// Evaluates whole slices of points below a regular frame at once. Returns the numbers of the other points.
std::vector<std::int64_t> find_on_slices(const InteriorGrid& grid, const PointsInside& points, int threads,
                                         double* stress, double* displacement) {
  const std::vector<InteriorSlice> slices = grid.slices(points.count, points.xyz);
  parallel_for(std::ssize(slices), 1, std::max(threads, 1),
               [&](std::int64_t k, int /*thread*/) { grid.evaluate(slices[at(k)], stress, displacement); });
  std::vector<std::uint8_t> done(at(points.count), 0);
  for (const InteriorSlice& slice : slices)
    for (const std::int64_t p : slice.point) done[at(p)] = 1;
  std::vector<std::int64_t> rest;
  for (std::int64_t p = 0; p < points.count; ++p)
    if (done[at(p)] == 0) rest.push_back(p);
  return rest;
}

/// Evaluates points one by one.
void find_at(const HalfspaceInterior& interior, const std::vector<std::int64_t>& which, const double* xyz, int threads,
             double* stress, double* displacement) {
  const std::size_t n = which.size();
  std::vector<double> x(3 * n), s(stress ? 6 * n : 0), u(displacement ? 3 * n : 0);
  for (std::size_t k = 0; k < n; ++k) std::copy_n(xyz + 3 * which[k], 3, x.data() + 3 * k);
  interior.evaluate(std::ssize(which), x.data(), stress ? s.data() : nullptr, displacement ? u.data() : nullptr,
                    threads);
  for (std::size_t k = 0; k < n; ++k) {
    if (stress) std::copy_n(s.data() + 6 * k, 6, stress + 6 * which[k]);
    if (displacement) std::copy_n(u.data() + 3 * k, 3, displacement + 3 * which[k]);
  }
}

}  // namespace

struct StressesInside::Fields {
  std::int32_t body;
  const Body* which;
  int threads;
  std::vector<double> traction;
  std::optional<InteriorGrid> grid;  ///< nothing: points are evaluated one by one
  HalfspaceInterior::Material material;
  const Frame* frame;
  double accuracy;
  std::optional<HalfspaceInterior> interior;  ///< made for points that no slice has

  const HalfspaceInterior& one_by_one() {
    if (!interior) interior.emplace(*frame, traction.data(), material, accuracy);
    return *interior;
  }
  // Depth points into the body: along -n into body 1, whose tractions are lambda, along n into body 2, which has
  // -lambda. A mirrored body obeys the same laws.
  double side() const { return body == 1 ? 1 : -1; }
};

StressesInside::~StressesInside() = default;

StressesInside::StressesInside(const Solution& state, std::int32_t body, double accuracy, int threads) {
  const Prepared& on = *state.prepared;
  const Body& which = *on.pair.body[at(body - 1)];
  require_halfspace(which, body);
  if (on.frame.section)
    fail(
        Status::err_unsupported,
        "stresses inside half-spaces are those under a contact in a plane, and this frame follows the surfaces (option "
        "conformal, inclined patches)");
  const HalfspaceInterior::Material material{which.young() / (2 * (1 + which.poisson())), which.poisson()};
  fields_ = std::make_unique<Fields>(Fields{body, &which, threads, {}, {}, material, &on.frame, accuracy, {}});
  const double side = fields_->side();
  std::vector<double>& traction = fields_->traction;
  traction.resize(3 * at(on.problem.nodes));
  for (std::size_t k = 0; k < traction.size() / 3; ++k) {
    traction[3 * k] = side * state.iterate.lambda[0][k];
    traction[3 * k + 1] = side * state.iterate.lambda[1][k];
    traction[3 * k + 2] = -state.iterate.lambda[2][k];
  }
  if (!on.lattice) return;
  fields_->grid.emplace(*on.lattice, traction.data(), material, accuracy);
  if (!fields_->grid->usable()) fields_->grid.reset();
}

void StressesInside::find(const PointsInside& points, double* stress, double* displacement) {
  Fields& on = *fields_;
  // Stresses under given tractions do not depend on the modulus.
  if (displacement && on.which->creeps())
    fail(Status::err_unsupported,
         "body %d is viscoelastic (rollcon_body_set_viscoelastic): displacements inside it are not computed; allowed: "
         "stresses alone, and displacements of its surface (rollcon_contact_get_displacements_at)",
         on.body);
  require_inside(points, on.body);
  const std::size_t n = at(points.count);
  std::vector<double> inside(points.xyz, points.xyz + 3 * n);
  for (std::size_t p = 0; p < n; ++p) inside[3 * p + 2] *= -on.side();
  if (!on.grid) {
    on.one_by_one().evaluate(points.count, inside.data(), stress, displacement, on.threads);
  } else if (const auto rest =
                 find_on_slices(*on.grid, {points.count, inside.data()}, on.threads, stress, displacement);
             !rest.empty()) {
    find_at(on.one_by_one(), rest, inside.data(), on.threads, stress, displacement);
  }
  if (on.body == 2) return;
  for (std::size_t p = 0; p < n; ++p) {
    if (stress) stress[6 * p + 4] = -stress[6 * p + 4], stress[6 * p + 5] = -stress[6 * p + 5];
    if (displacement) displacement[3 * p + 2] = -displacement[3 * p + 2];
  }
}

}  // namespace rollcon
