#include "bodies/fem/interior.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "bodies/fem/element_strain.hpp"
#include "bodies/fem/element_stress.hpp"
#include "mesh/volume_shape.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::fem {
namespace {

constexpr std::int64_t grain = 64;  ///< elements

// Recovery by patches (Zienkiewicz and Zhu, Int. J. Num. Meth. Engng 33, 1992):
// around each corner node inside the body a polynomial is fitted to the
// stresses of its elements where they are most accurate.

constexpr std::size_t most_terms = 10;

struct Patch {
  bool sound = false;
  Vec3 centre{0, 0, 0};
  double size = 1;
  std::size_t terms = 0;
  std::array<std::array<double, 6>, most_terms> factor{};  ///< of the monomials

  void monomials(const Vec3& x, double* m) const {
    const Vec3 d = 1 / size * (x - centre);
    const double all[most_terms] = {1,           d[0],        d[1],        d[2],        d[0] * d[0],
                                    d[1] * d[1], d[2] * d[2], d[0] * d[1], d[0] * d[2], d[1] * d[2]};
    std::copy_n(all, terms, m);
  }
  void add(const Vec3& x, double* stress) const {
    double m[most_terms];
    monomials(x, m);
    for (std::size_t i = 0; i < terms; ++i)
      for (std::size_t c = 0; c < 6; ++c) stress[c] += m[i] * factor[i][c];
  }
  void fit(const std::vector<Vec3>& x, const std::vector<std::array<double, 6>>& stress);
};

// Least squares by polynomials that are orthonormal on the samples; not sound
// where those do not tell the terms apart.
void Patch::fit(const std::vector<Vec3>& x, const std::vector<std::array<double, 6>>& stress) {
  constexpr double least = 1e-3;
  const std::size_t n = x.size();
  sound = n >= terms + terms / 2;
  if (!sound) return;
  for (const Vec3& at : x) size = std::max(size, length(at - centre));
  std::vector<double> value(n * terms);
  std::array<std::array<double, most_terms>, most_terms> of{};  // of monomials
  for (std::size_t q = 0; q < n; ++q) {
    double m[most_terms];
    monomials(x[q], m);
    for (std::size_t i = 0; i < terms; ++i) value[i * n + q] = m[i];
  }
  const auto product = [&](std::size_t i, std::size_t j) {
    double sum = 0;
    for (std::size_t q = 0; q < n; ++q) sum += value[i * n + q] * value[j * n + q];
    return sum;
  };
  for (std::size_t i = 0; i < terms; ++i) {
    of[i][i] = 1;
    const double whole = std::sqrt(product(i, i));
    for (int twice = 0; twice < 2; ++twice)
      for (std::size_t j = 0; j < i; ++j) {
        const double r = product(i, j);
        for (std::size_t q = 0; q < n; ++q) value[i * n + q] -= r * value[j * n + q];
        for (std::size_t k = 0; k < terms; ++k) of[i][k] -= r * of[j][k];
      }
    const double left = std::sqrt(product(i, i));
    if (!(left > least * whole)) {
      sound = false;
      return;
    }
    for (std::size_t q = 0; q < n; ++q) value[i * n + q] /= left;
    for (double& f : of[i]) f /= left;
    std::array<double, 6> part{};
    for (std::size_t q = 0; q < n; ++q)
      for (std::size_t c = 0; c < 6; ++c) part[c] += value[i * n + q] * stress[q][c];
    for (std::size_t k = 0; k < terms; ++k)
      for (std::size_t c = 0; c < 6; ++c) factor[k][c] += of[i][k] * part[c];
  }
}

VolumeType linear(VolumeType type) {
  const int corners = corner_count(type);
  return corners == 4 ? VolumeType::tet4 : corners == 6 ? VolumeType::wedge6 : VolumeType::hex8;
}

/// Where an element's stresses are sampled: each of the rule's points as a sum
/// of corners, of the corner functions.
struct Samples {
  std::vector<VolumeShape> corner, place;  ///< place: of all nodes
  explicit Samples(VolumeType type) {
    for (const Vec3& at : volume_rule(type, is_quadratic(type) ? (corner_count(type) == 8 ? 3 : 2) : 1).point) {
      evaluate_shape(linear(type), at, corner.emplace_back());
      evaluate_shape(type, at, place.emplace_back());
    }
  }
};

}  // namespace

// part: of each element's corner functions at its nodes. Nodes whose elements
// have no sound patch keep their averages.
void Interior::recover(const std::vector<double>& part, double* stress, int threads) const {
  const VolumeElements& volume = mesh_.volume;
  const std::size_t nodes = mesh_.surface.node.size();
  std::map<VolumeType, Samples> samples;
  std::vector<std::uint8_t> corner(nodes, 0), outside(nodes, 0);
  std::vector<std::int64_t> start(nodes + 1, 0);
  for (const std::int32_t k : mesh_.surface.connectivity) outside[at(k)] = 1;
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    samples.try_emplace(volume.type[at(e)], volume.type[at(e)]);
    const auto own = volume.element(e);
    for (std::size_t k = 0; k < own.size(); ++k) {
      ++start[at(own[k]) + 1];
      if (k < static_cast<std::size_t>(corner_count(volume.type[at(e)]))) corner[at(own[k])] = 1;
    }
  }
  for (std::size_t k = 0; k < nodes; ++k) start[k + 1] += start[k];
  std::vector<std::int64_t> around(at(start[nodes])), next(start.begin(), start.end() - 1);
  for (std::int64_t e = 0; e < volume.elements(); ++e)
    for (const std::int32_t k : volume.element(e)) around[at(next[at(k)]++)] = e;
  const auto elements_of = [&](std::size_t node) {
    return std::span(around.data() + start[node], at(start[node + 1] - start[node]));
  };

  std::vector<Patch> patch(nodes);
  parallel_for(static_cast<std::int64_t>(nodes), grain, threads, [&](std::int64_t node, int /*thread*/) {
    if (corner[at(node)] == 0 || outside[at(node)] != 0) return;
    const auto own = elements_of(at(node));
    Patch& p = patch[at(node)];
    p.centre = mesh_.surface.node[at(node)];
    p.size = 0;
    std::vector<Vec3> x;
    std::vector<std::array<double, 6>> value;
    p.terms = most_terms;
    for (const std::int64_t e : own) {
      if (volume.tag[at(e)] != volume.tag[at(own[0])]) return;  // stresses jump between materials
      const VolumeType type = volume.type[at(e)];
      if (!is_quadratic(type)) p.terms = 4;
      const Samples& on = samples.at(type);
      const auto member = volume.element(e);
      for (std::size_t q = 0; q < on.place.size(); ++q) {
        Vec3 place{0, 0, 0};
        for (std::size_t k = 0; k < member.size(); ++k)
          place = place + on.place[q].value[k] * mesh_.surface.node[at(member[k])];
        std::array<double, 6> s{};
        for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(type)); ++k)
          for (std::size_t c = 0; c < 6; ++c)
            s[c] += on.corner[q].value[k] * part[6 * (at(volume.offset[at(e)]) + k) + c];
        x.push_back(place);
        value.push_back(s);
      }
    }
    p.fit(x, value);
  });

  // The element's own function at a node less the one that the patch would have there.
  const auto add_own = [&](std::int64_t e, std::int64_t node, const Patch& p, double* to) {
    const auto member = volume.element(e);
    const auto local = at(std::find(member.begin(), member.end(), node) - member.begin());
    const std::vector<double>& extend = to_nodes(volume.type[at(e)], hex8_);
    const std::size_t points = at(first_[at(e) + 1] - first_[at(e)]);
    double xyz[3 * max_points], seen[6] = {};
    element(e, nullptr, nullptr, xyz);
    for (std::size_t q = 0; q < points; ++q) {
      double there[6] = {};
      p.add({xyz[3 * q], xyz[3 * q + 1], xyz[3 * q + 2]}, there);
      for (std::size_t c = 0; c < 6; ++c) seen[c] += extend[local * points + q] * there[c];
    }
    for (std::size_t c = 0; c < 6; ++c) to[c] += part[6 * (at(volume.offset[at(e)]) + local) + c] - seen[c];
  };

  // Elsewhere: by the patches of its elements. They reach far beyond their samples there: of quadratic elements, which
  // are more accurate themselves, only what the elements' functions miss of the patches' is taken.
  parallel_for(static_cast<std::int64_t>(nodes), grain, threads, [&](std::int64_t node, int /*thread*/) {
    double* s = stress + 6 * node;
    const auto own = elements_of(at(node));
    const Vec3& x = mesh_.surface.node[at(node)];
    if (patch[at(node)].sound) {
      std::fill_n(s, 6, 0.0);
      patch[at(node)].add(x, s);
      return;
    }
    double found[6] = {}, total = 0;
    for (const std::int64_t e : own) {
      if (volume.tag[at(e)] != volume.tag[at(own[0])]) return;
      for (const std::int32_t k : volume.element(e)) {
        if (!patch[at(k)].sound) continue;
        ++total;
        patch[at(k)].add(x, found);
        if (is_quadratic(volume.type[at(e)])) add_own(e, node, patch[at(k)], found);
      }
    }
    for (std::size_t c = 0; c < 6 && total > 0; ++c) s[c] = found[c] / total;
  });
}

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
  recover(part, stress, threads);
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

}  // namespace rollcon::fem
