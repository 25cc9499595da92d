#include "bodies/fem/interior.hpp"

#include <algorithm>
#include <optional>

#include "bodies/fem/element_strain.hpp"
#include "bodies/fem/element_stress.hpp"
#include "bodies/fem/recovery.hpp"
#include "mesh/volume_shape.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::fem {
namespace {

constexpr std::int64_t grain = 64;  ///< elements, or points

}  // namespace

Interior::Interior(const BodyMesh& mesh, const Assembly& assembly, Hex8 hex8, double reference)
    : mesh_(mesh), assembly_(assembly), hex8_(hex8), reference_(reference), first_{0} {
  for (const VolumeType type : mesh.volume.type) first_.push_back(first_.back() + stress_points(type, hex8));
}

double Interior::element(std::int64_t e, const double* u, double* stress, double* xyz) const {
  const auto nodes = mesh_.volume.element(e);
  Vec3 x[max_volume_nodes];
  double own[3 * max_volume_nodes];
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    x[k] = mesh_.surface.node[at(nodes[k])];
    if (stress) std::copy_n(u + 3 * static_cast<std::ptrdiff_t>(nodes[k]), 3, own + 3 * k);
  }
  const Material& material = assembly_.material(e);
  const double volume =
      element_stress(mesh_.volume.type[at(e)], {x, nodes.size()}, material.poisson, hex8_, own, stress, xyz);
  const double young = material.young * reference_;
  if (stress)
    for (std::int64_t k = 0; k < 6 * (first_[at(e) + 1] - first_[at(e)]); ++k) stress[k] *= young;
  return volume;
}

void Interior::at_points(const double* u, double* stress, double* xyz, int threads) const {
  parallel_for(mesh_.volume.elements(), grain, threads, [&](std::int64_t e, int /*thread*/) {
    const std::int64_t first = first_[at(e)];
    element(e, u, stress ? stress + 6 * first : nullptr, xyz ? xyz + 3 * first : nullptr);
  });
}

void Interior::at_nodes(const double* u, double* stress, int threads) const {
  const VolumeElements& volume = mesh_.volume;
  std::vector<double> part(6 * volume.connectivity.size()), weight(at(volume.elements()));
  parallel_for(volume.elements(), grain, threads, [&](std::int64_t e, int /*thread*/) {
    double own[6 * max_points];
    weight[at(e)] = element(e, u, own, nullptr);
    const std::vector<double>& extend = to_nodes(volume.type[at(e)], hex8_);
    const std::size_t nodes = volume.element(e).size(), points = at(first_[at(e) + 1] - first_[at(e)]);
    double* out = part.data() + 6 * volume.offset[at(e)];
    for (std::size_t k = 0; k < nodes; ++k)
      for (std::size_t q = 0; q < points; ++q)
        for (std::size_t c = 0; c < 6; ++c) out[6 * k + c] += extend[k * points + q] * own[6 * q + c];
  });
  const std::size_t nodes = mesh_.surface.node.size();
  std::vector<double> total(nodes, 0.0);
  std::fill_n(stress, 6 * nodes, 0.0);
  for (std::int64_t e = 0; e < volume.elements(); ++e)
    for (std::int64_t k = volume.offset[at(e)]; k < volume.offset[at(e)] + std::ssize(volume.element(e)); ++k) {
      const std::size_t node = at(volume.connectivity[at(k)]);
      total[node] += weight[at(e)];
      for (std::size_t c = 0; c < 6; ++c) stress[6 * node + c] += weight[at(e)] * part[6 * at(k) + c];
    }
  for (std::size_t node = 0; node < nodes; ++node)
    for (std::size_t c = 0; c < 6 && total[node] > 0; ++c) stress[6 * node + c] /= total[node];
  recover_nodal_stresses(mesh_, hex8_, part, stress, threads);
}

const VolumeSearch& Interior::search() const {
  std::call_once(searched_, [&] { search_ = std::make_unique<const VolumeSearch>(mesh_.surface.node, mesh_.volume); });
  return *search_;
}

bool Interior::interpolate(const Vec3& x, const double* u, const double* node_stress, double* displacement,
                           double* stress) const {
  const std::optional<VolumePoint> found = search().find(x);
  if (!found) return false;
  const auto nodes = mesh_.volume.element(found->element);
  VolumeShape shape;
  evaluate_shape(mesh_.volume.type[at(found->element)], found->reference, shape);
  const auto sum = [&](const double* from, std::size_t components, double* to) {
    if (!to) return;
    std::fill_n(to, components, 0.0);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t c = 0; c < components; ++c) to[c] += shape.value[k] * from[components * at(nodes[k]) + c];
  };
  sum(u, 3, displacement);
  sum(node_stress, 6, stress);
  return true;
}

void InteriorFields::at_points(std::int64_t n, const double* xyz, double* displacement, double* stress,
                               int threads) const {
  std::vector<double> of_nodes(stress && n > 0 ? 6 * at(interior_.nodes()) : 0);
  if (!of_nodes.empty()) at_nodes(of_nodes.data(), threads);
  std::vector<std::uint8_t> inside(at(n), 0);
  parallel_for(n, grain, threads, [&](std::int64_t p, int /*thread*/) {
    const double* x = xyz + 3 * p;
    inside[at(p)] =
        interior_.interpolate({x[0], x[1], x[2]}, u_.data(), of_nodes.data(),
                              displacement ? displacement + 3 * p : nullptr, stress ? stress + 6 * p : nullptr);
  });
  const auto out = std::find(inside.begin(), inside.end(), 0);
  if (out == inside.end()) return;
  const auto p = out - inside.begin();
  fail(Status::err_argument, "point %lld (counting from 0), at %g %g %g, is outside of the body's elements",
       static_cast<long long>(p), xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]);
}

}  // namespace rollcon::fem
