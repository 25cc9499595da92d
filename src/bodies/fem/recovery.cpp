#include "bodies/fem/recovery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "bodies/fem/element_stiffness_table.hpp"
#include "mesh/volume_shape.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::fem {
namespace {

constexpr std::int64_t grain = 64;  ///< nodes

// Recovery by patches (Zienkiewicz and Zhu, Int. J. Num. Meth. Engng 33, 1992) fits a polynomial around each corner
// node inside the body to the stresses of its elements where they are most accurate.

constexpr std::size_t most_terms = 10;

struct Patch {
  bool sound = false;
  Vec3 centre{0, 0, 0};
  double size = 1;
  std::size_t terms = 0;
  std::array<std::array<double, 6>, most_terms> factor{};  ///< factors of the monomials

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

// Fits least squares by polynomials that are orthonormal on the samples; not sound where these do not tell terms apart.
void Patch::fit(const std::vector<Vec3>& x, const std::vector<std::array<double, 6>>& stress) {
  constexpr double least = 1e-3;
  const std::size_t n = x.size();
  sound = n >= terms + terms / 2;
  if (!sound) return;
  for (const Vec3& at : x) size = std::max(size, length(at - centre));
  std::vector<double> value(n * terms);
  std::array<std::array<double, most_terms>, most_terms> of{};  // coefficients of monomials
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

/// Holds shape functions where an element's stresses are sampled, at the points of a rule.
struct Samples {
  std::vector<VolumeShape> corner, place;  ///< functions of the corners, and of all nodes
  explicit Samples(VolumeType type) {
    for (const Vec3& at : volume_rule(type, is_quadratic(type) ? (corner_count(type) == 8 ? 3 : 2) : 1).point) {
      evaluate_shape(linear(type), at, corner.emplace_back());
      evaluate_shape(type, at, place.emplace_back());
    }
  }
};

/// Holds the elements around each node, and what recovery asks of the nodes themselves.
struct Around {
  explicit Around(const BodyMesh& mesh)
      : corner(mesh.surface.node.size(), 0), outside(corner.size(), 0), start_(corner.size() + 1, 0) {
    const VolumeElements& volume = mesh.volume;
    for (const std::int32_t k : mesh.surface.connectivity) outside[at(k)] = 1;
    for (std::int64_t e = 0; e < volume.elements(); ++e) {
      const auto own = volume.element(e);
      for (std::size_t k = 0; k < own.size(); ++k) {
        ++start_[at(own[k]) + 1];
        if (k < static_cast<std::size_t>(corner_count(volume.type[at(e)]))) corner[at(own[k])] = 1;
      }
    }
    for (std::size_t k = 0; k < corner.size(); ++k) start_[k + 1] += start_[k];
    element_.resize(at(start_.back()));
    std::vector<std::int64_t> next(start_.begin(), start_.end() - 1);
    for (std::int64_t e = 0; e < volume.elements(); ++e)
      for (const std::int32_t k : volume.element(e)) element_[at(next[at(k)]++)] = e;
  }
  std::span<const std::int64_t> elements(std::int64_t node) const {
    return {element_.data() + start_[at(node)], at(start_[at(node) + 1] - start_[at(node)])};
  }
  std::vector<std::uint8_t> corner, outside;

 private:
  std::vector<std::int64_t> start_, element_;
};

class Recovery {
 public:
  Recovery(const BodyMesh& mesh, Hex8 hex8, const std::vector<double>& part)
      : mesh_(mesh), hex8_(hex8), part_(part), around_(mesh), patch_(mesh.surface.node.size()) {
    for (const VolumeType type : mesh.volume.type) samples_.try_emplace(type, type);
  }
  void fit(std::int64_t node);
  /// Recovers at a node by its own patch, else by those of its elements.
  void at_node(std::int64_t node, double* stress) const;

 private:
  void add_own(std::int64_t e, std::int64_t node, const Patch& p, double* to) const;
  bool one_material(std::span<const std::int64_t> elements) const {
    return std::ranges::all_of(
        elements, [&](std::int64_t e) { return mesh_.volume.tag[at(e)] == mesh_.volume.tag[at(elements[0])]; });
  }

  const BodyMesh& mesh_;
  Hex8 hex8_;
  const std::vector<double>& part_;
  Around around_;
  std::map<VolumeType, Samples> samples_;
  std::vector<Patch> patch_;
};

void Recovery::fit(std::int64_t node) {
  const VolumeElements& volume = mesh_.volume;
  const auto own = around_.elements(node);
  if (around_.corner[at(node)] == 0 || around_.outside[at(node)] != 0) return;
  if (!one_material(own)) return;  // stresses jump between materials
  Patch& p = patch_[at(node)];
  p.centre = mesh_.surface.node[at(node)];
  p.size = 0;
  p.terms = most_terms;
  std::vector<Vec3> x;
  std::vector<std::array<double, 6>> value;
  for (const std::int64_t e : own) {
    const VolumeType type = volume.type[at(e)];
    if (!is_quadratic(type)) p.terms = 4;
    const Samples& on = samples_.at(type);
    const auto member = volume.element(e);
    for (std::size_t q = 0; q < on.place.size(); ++q) {
      Vec3 place{0, 0, 0};
      for (std::size_t k = 0; k < member.size(); ++k)
        place = place + on.place[q].value[k] * mesh_.surface.node[at(member[k])];
      std::array<double, 6> s{};
      for (std::size_t k = 0; k < at(corner_count(type)); ++k)
        for (std::size_t c = 0; c < 6; ++c)
          s[c] += on.corner[q].value[k] * part_[6 * (at(volume.offset[at(e)]) + k) + c];
      x.push_back(place);
      value.push_back(s);
    }
  }
  p.fit(x, value);
}

// Returns the element's own function at a node less the one that the patch would have there.
void Recovery::add_own(std::int64_t e, std::int64_t node, const Patch& p, double* to) const {
  const VolumeElements& volume = mesh_.volume;
  const auto member = volume.element(e);
  const auto local = at(std::find(member.begin(), member.end(), node) - member.begin());
  const std::vector<double>& extend = to_nodes(volume.type[at(e)], hex8_);
  const std::size_t points = extend.size() / member.size();
  Vec3 x[max_volume_nodes];
  for (std::size_t k = 0; k < member.size(); ++k) x[k] = mesh_.surface.node[at(member[k])];
  double xyz[3 * max_points], seen[6] = {};
  element_stress(volume.type[at(e)], {x, member.size()}, 0, hex8_, nullptr, nullptr, xyz);
  for (std::size_t q = 0; q < points; ++q) {
    double there[6] = {};
    p.add({xyz[3 * q], xyz[3 * q + 1], xyz[3 * q + 2]}, there);
    for (std::size_t c = 0; c < 6; ++c) seen[c] += extend[local * points + q] * there[c];
  }
  for (std::size_t c = 0; c < 6; ++c) to[c] += part_[6 * (at(volume.offset[at(e)]) + local) + c] - seen[c];
}

// Patches reach far beyond their samples at other nodes than their own: of quadratic elements, which are more accurate
// themselves, only what the elements' functions miss of the patches' is taken.
void Recovery::at_node(std::int64_t node, double* stress) const {
  const VolumeElements& volume = mesh_.volume;
  const auto own = around_.elements(node);
  const Vec3& x = mesh_.surface.node[at(node)];
  if (patch_[at(node)].sound) {
    std::fill_n(stress, 6, 0.0);
    patch_[at(node)].add(x, stress);
    return;
  }
  if (!one_material(own)) return;
  double found[6] = {}, total = 0;
  for (const std::int64_t e : own)
    for (const std::int32_t k : volume.element(e)) {
      const Patch& p = patch_[at(k)];
      if (!p.sound) continue;
      ++total;
      p.add(x, found);
      if (is_quadratic(volume.type[at(e)])) add_own(e, node, p, found);
    }
  for (std::size_t c = 0; c < 6 && total > 0; ++c) stress[c] = found[c] / total;
}

}  // namespace

void recover_nodal_stresses(const BodyMesh& mesh, Hex8 hex8, const std::vector<double>& part, double* stress,
                            int threads) {
  Recovery recovery(mesh, hex8, part);
  const std::int64_t nodes = std::ssize(mesh.surface.node);
  parallel_for(nodes, grain, threads, [&](std::int64_t node, int /*thread*/) { recovery.fit(node); });
  parallel_for(nodes, grain, threads,
               [&](std::int64_t node, int /*thread*/) { recovery.at_node(node, stress + 6 * node); });
}

}  // namespace rollcon::fem
