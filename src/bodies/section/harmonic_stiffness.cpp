#include "bodies/section/harmonic_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "bodies/section/plane_point.hpp"
#include "linalg/lapack.hpp"
#include "mesh/quadrature.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon::section {
namespace {

constexpr std::size_t most_unknowns = 3 * max_element_nodes;

/// Strains rr, tt, yy, rt, ty, ry of the unknowns of an element: b[0] + n b[1].
struct Strains {
  double b[2][6][most_unknowns];
};

Strains strains(const SweptSection& section, const PlanePoint& here, std::size_t nodes) {
  Strains s{};
  const double wave = 1 / section.way(here.p), curve = section.revolved() ? wave : 0;
  for (std::size_t a = 0; a < nodes; ++a) {
    const std::size_t u = 3 * a, t = u + 1, y = u + 2;
    s.b[0][0][u] = here.dp[a];
    s.b[0][1][u] = curve * here.value[a];
    s.b[1][1][t] = wave * here.value[a];
    s.b[0][2][y] = here.dq[a];
    s.b[1][3][u] = -wave * here.value[a];
    s.b[0][3][t] = here.dp[a] - curve * here.value[a];
    s.b[0][4][t] = here.dq[a];
    s.b[1][4][y] = -wave * here.value[a];
    s.b[0][5][u] = here.dq[a];
    s.b[0][5][y] = here.dp[a];
  }
  return s;
}

PlaneRule rule_of(ElementType type) {
  const int degree = is_quadratic(type) ? 7 : 5;
  return corner_count(type) == 3 ? triangle_rule(degree) : square_rule(degree);
}

/// Returns how many functions 1, xi, eta the dilatation is projected on.
std::size_t dilatations(ElementType type) {
  return corner_count(type) == 4 && is_quadratic(type) ? 3 : 1;
}

/// Adds scale a b' + b a' once to each power of n that the product of a0 + n a1 and b0 + n b1 has.
void add_product(const double (&a)[2][most_unknowns], const double (&b)[2][most_unknowns], double scale, std::size_t n,
                 std::vector<double> (&k)[3]) {
  for (std::size_t x = 0; x < 2; ++x)
    for (std::size_t z = 0; z < 2; ++z)
      for (std::size_t i = 0; i < n; ++i) {
        const double left = scale * a[x][i];
        if (left == 0) continue;
        double* to = k[x + z].data() + i * n;
        for (std::size_t j = 0; j < n; ++j) to[j] += left * b[z][j];
      }
}

/// Inverts the mass of the functions that dilatations are projected on, at most three, in place.
void invert(double (&m)[3][3], std::size_t n) {
  double inverse[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < n; ++i) {
    const double pivot = m[i][i];
    for (std::size_t j = 0; j < n; ++j) m[i][j] /= pivot, inverse[i][j] /= pivot;
    for (std::size_t r = 0; r < n; ++r) {
      if (r == i) continue;
      const double factor = m[r][i];
      for (std::size_t j = 0; j < n; ++j) m[r][j] -= factor * m[i][j], inverse[r][j] -= factor * inverse[i][j];
    }
  }
  std::copy(&inverse[0][0], &inverse[0][0] + 9, &m[0][0]);
}

}  // namespace

HarmonicStiffness::HarmonicStiffness(const BodyMesh& mesh, std::vector<Elastic> material, double reference)
    : mesh_(mesh), material_(std::move(material)), reference_(reference) {
  number();
  require_held();
  struct Entry {
    std::int64_t column, row;
    double k[3];
  };
  std::vector<Entry> entry;
  const SurfaceMesh& plane = mesh.section.plane();
  for (std::int64_t e = 0; e < plane.elements(); ++e) {
    const Element own = element(e);
    const auto nodes = plane.element(e);
    const std::size_t n = 3 * nodes.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const std::int64_t row = unknown(nodes[i / 3], i % 3), column = unknown(nodes[j / 3], j % 3);
        if (column >= 0 && row >= column)
          entry.push_back({column, row, {own.k[0][i * n + j], own.k[1][i * n + j], own.k[2][i * n + j]}});
      }
  }
  std::stable_sort(entry.begin(), entry.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.column, a.row) < std::tie(b.column, b.row);
  });
  pattern_.begin(count_);
  std::size_t k = 0;
  for (std::int64_t column = 0; column < count_; ++column) {
    for (std::int64_t last = -1; k < entry.size() && entry[k].column == column; ++k) {
      if (entry[k].row != last) pattern_.push(last = entry[k].row, 0), first_.push_back(0), second_.push_back(0);
      pattern_.value.back() += entry[k].k[0];
      first_.back() += entry[k].k[1];
      second_.back() += entry[k].k[2];
    }
    pattern_.end_column();
  }
}

// The deviatoric part is integrated as it is. The dilatation counts as projected on a few functions; in triangles only
// what goes beyond four times the shear modulus does.
HarmonicStiffness::Element HarmonicStiffness::element(std::int64_t e) const {
  const ElementType type = mesh_.section.plane().type[at(e)];
  const std::size_t nodes = at(node_count(type)), n = 3 * nodes, functions = dilatations(type);
  const Elastic& m = material_[at(e)];
  const double shear = m.young / (2 * (1 + m.poisson)), bulk = m.young / (3 * (1 - 2 * m.poisson));
  const bool split = corner_count(type) == 3;
  const double local = split ? std::min(bulk, 4 * shear) : 0;
  Element out;
  for (auto& k : out.k) k.assign(n * n, 0.0);
  double mass[3][3] = {}, mean[3][2][most_unknowns] = {};
  const PlaneRule rule = rule_of(type);
  for (std::size_t g = 0; g < rule.size(); ++g) {
    const PlanePoint here = plane_point(mesh_.section, e, rule.xi[g], rule.eta[g]);
    const double area = rule.w[g] * std::abs(here.jacobian) * mesh_.section.way(here.p);
    const Strains s = strains(mesh_.section, here, nodes);
    const double f[3] = {1, rule.xi[g], rule.eta[g]};
    double row[7][2][most_unknowns];  // six strains, then the dilatation
    for (std::size_t x = 0; x < 2; ++x)
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < 6; ++c) row[c][x][i] = s.b[x][c][i];
        row[6][x][i] = s.b[x][0][i] + s.b[x][1][i] + s.b[x][2][i];
        for (std::size_t a = 0; a < functions; ++a) mean[a][x][i] += area * f[a] * row[6][x][i];
      }
    for (std::size_t c = 0; c < 6; ++c) add_product(row[c], row[c], (c < 3 ? 2 : 1) * shear * area, n, out.k);
    add_product(row[6], row[6], (local - 2 * shear / 3) * area, n, out.k);
    for (std::size_t a = 0; a < functions; ++a)
      for (std::size_t b = 0; b < functions; ++b) mass[a][b] += area * f[a] * f[b];
  }
  invert(mass, functions);
  for (std::size_t a = 0; a < functions; ++a)
    for (std::size_t b = 0; b < functions; ++b) add_product(mean[a], mean[b], (bulk - local) * mass[a][b], n, out.k);
  add_springs(e, out.k[0]);
  return out;
}

void HarmonicStiffness::add_springs(std::int64_t e, std::vector<double>& k) const {
  const SweptSection& s = mesh_.section;
  const auto nodes = s.plane().element(e);
  for (const Spring& spring : mesh_.spring)
    for (const SectionEdge& edge : s.edges()) {
      if (edge.element != e || edge.tag != spring.tag) continue;
      const EdgeMass mass = edge_mass(s, edge);
      for (std::size_t a = 0; a < edge.nodes(); ++a)
        for (std::size_t b = 0; b < edge.nodes(); ++b)
          for (std::size_t c = 0; c < 3; ++c) {
            const auto i = at(std::find(nodes.begin(), nodes.end(), edge.node[a]) - nodes.begin());
            const auto j = at(std::find(nodes.begin(), nodes.end(), edge.node[b]) - nodes.begin());
            k[(3 * i + c) * 3 * nodes.size() + 3 * j + c] += spring.stiffness[axis_[c].first] * mass[a][b] / reference_;
          }
    }
}

std::array<std::pair<std::size_t, double>, 3> body_axes_of(const SweptSection& section) {
  constexpr double rounding = 1e-9;
  std::array<std::pair<std::size_t, double>, 3> found;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& e = section.axes_at_start()[c];
    const std::size_t most = std::abs(e[0]) > 0.9 ? 0 : std::abs(e[1]) > 0.9 ? 1 : 2;
    if (std::abs(e[most]) < 1 - rounding)
      fail(
          Status::err_state,
          "the section's axes are (%.6g, %.6g, %.6g) and those of its plane, not the body's: hold all three components "
          "of a node, or draw the section along the body's axes",
          section.path().axis[0], section.path().axis[1], section.path().axis[2]);
    found[c] = {most, e[most]};
  }
  return found;
}

void HarmonicStiffness::number() {
  constexpr std::uint8_t all = 7;
  const std::vector<std::uint8_t>& held = mesh_.given_held;
  const bool partly = std::any_of(held.begin(), held.end(), [](std::uint8_t h) { return h != 0 && h != all; });
  if (partly || !mesh_.spring.empty()) axis_ = body_axes_of(mesh_.section);
  for (const std::uint8_t h : held)
    for (std::size_t c = 0; c < 3; ++c) of_.push_back(h == all || (h >> axis_[c].first & 1U) ? -1 : count_++);
}

// Rigid motions are harmonics: n = 0 along the axis and about it, n = 1 across it; extruded bodies have all of theirs
// in n = 0. Motions that move no held component are free.
void HarmonicStiffness::require_held() const {
  constexpr double least = 1e-13;
  const SweptSection& s = mesh_.section;
  double size = 0;
  for (std::int64_t k = 0; k < s.plane().nodes(); ++k)
    size = std::max(
        {size, std::abs(s.place(static_cast<std::int32_t>(k))[0]), std::abs(s.place(static_cast<std::int32_t>(k))[1])});
  std::vector<std::uint8_t> sprung(of_.size(), 0);
  for (const Spring& spring : mesh_.spring)
    for (const SectionEdge& edge : s.edges())
      for (std::size_t a = 0; edge.tag == spring.tag && a < edge.nodes(); ++a)
        for (std::size_t c = 0; c < 3; ++c)
          if (spring.stiffness[axis_[c].first] > 0) sprung[3 * at(edge.node[a]) + c] = 1;
  struct Motion {
    const char* name;
    int harmonic;
    std::array<double, 3> (*of)(double p, double q);
  };
  constexpr Motion revolved[] = {{"along its axis", 0,
                                  [](double, double) {
                                    return std::array<double, 3>{0, 0, 1};
                                  }},
                                 {"about its axis", 0,
                                  [](double p, double) {
                                    return std::array<double, 3>{0, p, 0};
                                  }},
                                 {"across its axis", 1,
                                  [](double, double) {
                                    return std::array<double, 3>{1, -1, 0};
                                  }},
                                 {"tilting its axis", 1,
                                  [](double p, double q) {
                                    return std::array<double, 3>{q, -q, -p};
                                  }}},
                   extruded[] = {{"across its line", 0,
                                  [](double, double) {
                                    return std::array<double, 3>{1, 0, 0};
                                  }},
                                 {"along its line", 0,
                                  [](double, double) {
                                    return std::array<double, 3>{0, 1, 0};
                                  }},
                                 {"across its line", 0,
                                  [](double, double) {
                                    return std::array<double, 3>{0, 0, 1};
                                  }},
                                 {"about its line", 0, [](double p, double q) {
                                    return std::array<double, 3>{-q, 0, p};
                                  }}};
  const Motion(&motions)[4] = s.revolved() ? revolved : extruded;
  for (const int harmonic : {0, 1}) {
    double gram[4][4] = {};
    std::vector<const Motion*> of;
    for (const Motion& m : motions)
      if (m.harmonic == harmonic) of.push_back(&m);
    if (of.empty()) continue;
    for (std::int32_t k = 0; k < s.plane().nodes(); ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        if (unknown(k, c) >= 0 && sprung[3 * at(k) + c] == 0) continue;
        const auto& [p, q] = s.place(k);
        for (std::size_t i = 0; i < of.size(); ++i)
          for (std::size_t j = 0; j < of.size(); ++j)
            gram[i][j] += of[i]->of(p / size, q / size)[c] * of[j]->of(p / size, q / size)[c];
      }
    const int n = static_cast<int>(of.size()), four = 4, work_size = 64;
    double value[4] = {}, work[work_size];
    int info = 0;
    dsyev_("V", "U", &n, &gram[0][0], &four, value, work, &work_size, &info);
    if (info == 0 && value[n - 1] > 0 && value[0] > least * value[n - 1]) continue;
    std::size_t most = 0;
    for (std::size_t i = 1; i < of.size(); ++i)
      if (std::abs(gram[0][i]) > std::abs(gram[0][most])) most = i;
    fail(Status::err_singular,
         "the section is not held: harmonic n = %d has a rigid motion %s that no support stops; hold it with "
         "rollcon_body_set_support, whose components act all along the way",
         harmonic, of[most]->name);
  }
}

SparseMatrix HarmonicStiffness::matrix(double n) const {
  SparseMatrix k = pattern_;
  for (std::size_t i = 0; i < k.value.size(); ++i) k.value[i] += n * first_[i] + n * n * second_[i];
  return k;
}

std::vector<double> HarmonicStiffness::given(const BodyMesh& loaded) const {
  std::vector<double> u(of_.size(), 0.0);
  for (std::size_t k = 0; k < of_.size(); ++k)
    if (of_[k] < 0) u[k] = dot(loaded.given_value[k / 3], mesh_.section.axes_at_start()[k % 3]);
  return u;
}

std::vector<double> HarmonicStiffness::forces(const std::vector<double>& u) const {
  std::vector<double> force(u.size(), 0.0);
  const SurfaceMesh& plane = mesh_.section.plane();
  for (std::int64_t e = 0; e < plane.elements(); ++e) {
    const auto nodes = plane.element(e);
    const std::size_t n = 3 * nodes.size();
    const bool still = std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t k) {
      return u[3 * at(k)] == 0 && u[3 * at(k) + 1] == 0 && u[3 * at(k) + 2] == 0;
    });
    if (still) continue;
    const Element own = element(e);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        force[3 * at(nodes[i / 3]) + i % 3] += own.k[0][i * n + j] * u[3 * at(nodes[j / 3]) + j % 3];
  }
  return force;
}

std::vector<double> HarmonicStiffness::loads(const BodyMesh& loaded) const {
  const SweptSection& s = mesh_.section;
  std::vector<double> force(of_.size(), 0.0);
  const auto add = [&](std::int32_t node, double weight, const Vec3& f) {
    for (std::size_t c = 0; c < 3; ++c) force[3 * at(node) + c] += weight * dot(f, s.axes_at_start()[c]) / reference_;
  };
  const auto& [e1, along, e2] = s.axes_at_start();
  for (const FaceLoad& load : loaded.load)
    for (const SectionEdge& edge : s.edges()) {
      if (edge.tag != load.tag) continue;
      for (const EdgePoint& here : edge_points(s, edge)) {
        const Vec3 f = std::hypot(here.dp, here.dq) * load.traction - load.pressure * (here.dq * e1 - here.dp * e2);
        for (std::size_t a = 0; a < edge.nodes(); ++a) add(edge.node[a], here.weight * here.value[a], f);
      }
    }
  const SurfaceMesh& plane = s.plane();
  for (const BodyForce& load : loaded.body_force)
    for (std::int64_t e = 0; e < plane.elements(); ++e) {
      if (plane.tag[at(e)] != load.tag) continue;
      const PlaneRule rule = rule_of(plane.type[at(e)]);
      const auto nodes = plane.element(e);
      for (std::size_t g = 0; g < rule.size(); ++g) {
        const PlanePoint here = plane_point(s, e, rule.xi[g], rule.eta[g]);
        const double area = rule.w[g] * std::abs(here.jacobian) * s.way(here.p);
        Vec3 x{0, 0, 0};
        for (std::size_t a = 0; a < nodes.size(); ++a) x = x + here.value[a] * plane.node[at(nodes[a])];
        for (std::size_t a = 0; a < nodes.size(); ++a) add(nodes[a], area * here.value[a], load.at(x));
      }
    }
  return force;
}

}  // namespace rollcon::section
