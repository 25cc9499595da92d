#include "bodies/bem/somigliana.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bodies/bem/kelvin.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"
#include "quadrature/rules.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::bem {
namespace {

/// Tolerance of one element's integrals, those of Kelvin's double layer, over the body's accuracy: stresses are
/// up to ten times as large, and errors add up.
constexpr double element_share = 0.3;
/// Points nearer to the surface than these parts of the element are on it: those inside, and those outside.
/// (Straight faces of linear elements, too: the equations' surface bulges beyond them, or they beyond it.)
constexpr double on_surface = 1e-9, just_outside = 1e-6;

std::vector<double> bulges(const LiftedSurface& lifted) {
  const SurfaceMesh& mesh = lifted.mesh;
  std::vector<double> most(at(mesh.elements()), 0.0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto node = mesh.element(e);
    const auto corners = static_cast<std::size_t>(corner_count(mesh.type[at(e)]));
    for (std::size_t k = corners; k < std::min(node.size(), 2 * corners); ++k)
      if (node[k] >= lifted.nodes) {
        const Vec3 middle = 0.5 * (mesh.node[at(node[k - corners])] + mesh.node[at(node[(k + 1) % corners])]);
        most[at(e)] = std::max(most[at(e)], length(mesh.node[at(node[k])] - middle));
      }
  }
  return most;
}

/// Returns the body's displacements with those of midside nodes.
std::vector<double> lifted_displacements(const LiftedSurface& lifted, const std::vector<double>& u) {
  std::vector<double> all = u;
  all.resize(3 * lifted.mesh.node.size(), 0.0);
  for (std::size_t m = 0; m + 1 < lifted.start.size(); ++m)
    for (std::int64_t k = lifted.start[m]; k < lifted.start[m + 1]; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        all[3 * (at(lifted.nodes) + m) + c] += lifted.part[at(k)].value * u[3 * at(lifted.part[at(k)].of) + c];
  return all;
}

/// Tractions stay linear along the sides of linear elements.
std::vector<double> lifted_tractions(const SurfaceMesh& surface, const LiftedSurface& lifted,
                                     const std::vector<double>& traction, double over) {
  std::vector<double> all(3 * lifted.mesh.connectivity.size(), 0.0);
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const std::size_t nodes = surface.element(e).size(), all_nodes = lifted.mesh.element(e).size();
    const double* from = traction.data() + 3 * at(surface.offset[at(e)]);
    double* to = all.data() + 3 * at(lifted.mesh.offset[at(e)]);
    for (std::size_t k = 0; k < 3 * nodes; ++k) to[k] = from[k] / over;
    for (std::size_t k = nodes; k < all_nodes; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        to[3 * k + c] = 0.5 * (from[3 * (k - nodes) + c] + from[3 * ((k - nodes + 1) % nodes) + c]) / over;
  }
  return all;
}

}  // namespace

SomiglianaSurface::SomiglianaSurface(const SurfaceMesh& mesh, double size, double accuracy)
    : mesh_(mesh),
      size_(size),
      tolerance_(element_share * accuracy),
      geometry_(geometries(mesh, 1 / size)),
      far_(geometry_, tolerance_) {}

std::vector<LoadedFace> SomiglianaSurface::faces(const double* u, const double* traction) const {
  std::vector<LoadedFace> all(at(mesh_.elements()));
  for (std::size_t e = 0; e < all.size(); ++e) {
    LoadedFace& face = all[e];
    face = {};
    face.type = geometry_[e].type;
    const auto nodes = mesh_.element(static_cast<std::int64_t>(e));
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        face.node[c][k] = geometry_[e].node[c][k];
        face.u[c][k] = u ? u[3 * at(nodes[k]) + c] / size_ : 0;
        face.traction[c][k] = traction[3 * (at(mesh_.offset[e]) + k) + c];
      }
  }
  return all;
}

void SomiglianaSurface::add(const std::vector<LoadedFace>& faces, const Vec3& x, double poisson,
                            const LinearField& linear, Workspace& w, double* sum) const {
  const SomiglianaKernels& kernels = somigliana_kernels(instruction_set());
  for (std::size_t e = 0; e < faces.size(); ++e) {
    const double distance = length(geometry_[e].shape.centre - x);
    const FarRule rule = far_.rule(e, distance, double_layer, factors_);
    if (rule.first > 0) {
      fill_rule(geometry_[e].corners == 3, rule.first, rule.second, w.points);
      kernels.face(faces[e], w.points, x.data(), poisson, linear, sum);
      continue;
    }
    const Tolerance tolerance{tolerance_, std::numeric_limits<double>::infinity()};
    near_field(geometry_[e], x, {}, tolerance, true, w.near,
               [&] { kernels.face(faces[e], w.near.points, x.data(), poisson, linear, sum); });
  }
}

SomiglianaBody::SomiglianaBody(const LiftedSurface& surface_given, double shear_given, double poisson_given,
                               double accuracy_given, double edge_angle_given)
    : lifted(surface_given),
      shear(shear_given),
      poisson(poisson_given),
      accuracy(accuracy_given),
      edge_angle(edge_angle_given),
      size(size_near(surface_given.mesh)),
      search(surface_given.mesh, {}),
      surface(surface_given.mesh, size, accuracy_given),
      bulge(bulges(surface_given)) {}

Somigliana::Somigliana(std::shared_ptr<const SomiglianaBody> body, const SurfaceMesh& surface,
                       const SurfaceState& state)
    : body_(std::move(body)),
      nodes_(surface.nodes()),
      values_{body_->lifted.mesh, lifted_displacements(body_->lifted, state.u),
              lifted_tractions(surface, body_->lifted, state.traction, body_->shear), body_->poisson},
      layer_(state.layer),
      layer_values_{layer_, {}, {}, body_->poisson} {
  faces_ = body_->surface.faces(values_.u.data(), values_.traction.data());
  TractionBesides more;
  if (layer_.elements() > 0) {
    for (const std::int32_t node : layer_.connectivity)
      for (std::size_t c = 0; c < 3; ++c)
        layer_values_.traction.push_back(state.layer_traction[3 * at(node) + c] / body_->shear);
    layer_search_ = std::make_unique<SurfaceSearch>(layer_, std::span<const std::int64_t>{});
    layer_surface_ = std::make_unique<SomiglianaSurface>(layer_, body_->size, body_->accuracy);
    layer_faces_ = layer_surface_->faces(nullptr, layer_values_.traction.data());
    const SurfaceMesh& mesh = values_.mesh;
    more.assign(mesh.connectivity.size(), Vec3{0, 0, 0});
    for (std::int64_t e = 0; e < mesh.elements(); ++e)
      for (std::size_t k = 0; k < mesh.element(e).size(); ++k)
        more[at(mesh.offset[at(e)]) + k] =
            layer_traction(mesh.node[at(mesh.element(e)[k])], 1e-3 * element_diameter(mesh, e));
  }
  smoothed_ = smoothed_stresses(values_, more, body_->edge_angle);
}

Vec3 Somigliana::layer_traction(const Vec3& x, double reach) const {
  if (!layer_search_) return {0, 0, 0};
  const SurfacePoint on = layer_search_->nearest(x);
  if (on.distance > reach) return {0, 0, 0};
  return layer_values_.traction_at(on.element, on.xi, on.eta);
}

struct Somigliana::Result {
  double stress[6], u[3];  ///< stresses over G
  double distance;         ///< distance from the surface
};

bool Somigliana::evaluate(const Vec3& x, SomiglianaSurface::Workspace& w, Result& result) const {
  const SurfacePoint foot = body_->search.nearest(x);
  const double reach = element_diameter(values_.mesh, foot.element);
  LinearField linear = values_.field(foot.element, foot.xi, foot.eta, layer_traction(foot.x, 1e-3 * reach));
  interpolate_stress(values_.mesh, smoothed_, foot.element, foot.xi, foot.eta, result.stress);
  std::copy_n(linear.u, 3, result.u);
  result.distance = foot.distance;
  if (foot.distance <= on_surface * reach) return true;
  const Vec3 from = 1 / body_->size * (x - foot.x);  // the field's value at x
  for (std::size_t i = 0; i < 3; ++i) {
    linear.u[i] /= body_->size;
    for (std::size_t j = 0; j < 3; ++j) linear.u[i] += linear.gradient[i][j] * from[j];
  }
  double sum[somigliana_count] = {};
  const Vec3 place = 1 / body_->size * x;
  body_->surface.add(faces_, place, body_->poisson, linear, w, sum);
  if (!(sum[9] > 2 * std::numbers::pi))
    return foot.distance <= just_outside * reach + 2 * body_->bulge[at(foot.element)];
  if (layer_surface_) layer_surface_->add(layer_faces_, place, body_->poisson, {}, w, sum);
  for (std::size_t s = 0; s < 6; ++s) result.stress[s] = linear.stress[s] + sum[s];
  for (std::size_t c = 0; c < 3; ++c) result.u[c] = body_->size * (linear.u[c] + sum[6 + c]);
  return true;
}

void Somigliana::at_points(std::int64_t n, const double* xyz, double* displacement, double* stress, int threads) const {
  line_rule(1);  // tables are made before the threads start
  symmetric_triangle_rules();
  std::vector<Result> found(at(n));
  std::vector<std::uint8_t> inside(at(n), 0);
  const auto most = static_cast<int>(std::clamp<std::int64_t>(n, 1, std::max(1, threads)));
  std::vector<SomiglianaSurface::Workspace> workspaces(at(most));
  parallel_for(n, 4, most, [&](std::int64_t p, int thread) {
    inside[at(p)] = evaluate({xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]}, workspaces[at(thread)], found[at(p)]);
  });
  const auto out = std::find(inside.begin(), inside.end(), 0);
  if (out != inside.end()) {
    const auto p = out - inside.begin();
    fail(Status::err_argument, "point %lld (counting from 0), at %g %g %g, is outside of the body's surface, by %.3g",
         static_cast<long long>(p), xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2], found[at(p)].distance);
  }
  for (std::size_t p = 0; p < found.size(); ++p) {
    for (std::size_t c = 0; displacement && c < 3; ++c) displacement[3 * p + c] = found[p].u[c];
    for (std::size_t c = 0; stress && c < 6; ++c) stress[6 * p + c] = body_->shear * found[p].stress[c];
  }
}

void Somigliana::at_nodes(double* stress, int /*threads*/) const {
  const std::vector<double> all = stresses_at_nodes(values_.mesh, smoothed_);
  for (std::size_t k = 0; k < 6 * at(nodes_); ++k) stress[k] = body_->shear * all[k];
}

}  // namespace rollcon::bem
