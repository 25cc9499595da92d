#include "bodies/model/supports.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/lapack.hpp"
#include "mesh/box.hpp"
#include "mesh/surface_shells.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// A motion counts as free when it moves the held components by less than this part (its square root) of what it moves
/// the body.
constexpr double least_eigenvalue = 1e-13;
/// Least part of the work of a matrix's entries, their signs apart, that a motion costs. Files have 13 digits.
constexpr double least_work = 1e-11;

/// Adds the work of rigid motions against a stiffness, beside what its entries would do all with one sign.
void add_stiffness(const RowMatrix<double>& stiffness, const std::vector<Vec3>& node, const Vec3& middle, double size,
                   double (&gram)[6][6]) {
  const std::int64_t n = stiffness.rows();
  std::vector<double> motion[6], force(static_cast<std::size_t>(n));
  for (std::size_t m = 0; m < 6; ++m)
    for (const Vec3& x : node) {
      Vec3 unit{0, 0, 0};
      unit[m % 3] = 1;
      const Vec3 moves = m < 3 ? unit : (1 / size) * cross(unit, x - middle);
      motion[m].insert(motion[m].end(), moves.begin(), moves.end());
    }
  double all = 0;
  for (std::int64_t k = 0; k < n * n; ++k) all += std::abs(stiffness.data()[k]);
  for (auto& row : gram) {
    multiply(stiffness.data(), n, n, motion[&row - gram].data(), 0, force.data());
    for (std::size_t j = 0; j < 6; ++j) row[j] += dot(motion[j].data(), force.data(), n) / all;
  }
}

}  // namespace

void require_supports(const BodyMesh& mesh, const RowMatrix<double>* stiffness) {
  const Box box = box_of(mesh.surface.node);
  const Vec3 middle = 0.5 * (box.low + box.high);
  const double size = 0.5 * length(box.size());
  // Motions are translations e_c and rotations about the middle scaled by the size. gram is the sum over the held
  // components of r r^T, where r is what each motion moves them by.
  double gram[6][6] = {};
  std::int64_t held = 0;
  std::vector<std::uint8_t> stopped = mesh.held;  // springs stop motions, too
  for (std::int64_t e = 0; e < mesh.surface.elements(); ++e)
    for (const Spring& spring : mesh.spring)
      if (spring.tag == mesh.surface.tag[static_cast<std::size_t>(e)])
        for (const std::int32_t k : mesh.surface.element(e))
          for (std::size_t c = 0; c < 3; ++c)
            if (spring.stiffness[c] > 0) stopped[static_cast<std::size_t>(k)] |= static_cast<std::uint8_t>(1U << c);
  for (std::size_t k = 0; k < mesh.held.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(stopped[k] & (1U << c))) continue;
      ++held;
      const Vec3 arm = mesh.surface.node[k] - middle;
      double r[6] = {};
      r[c] = 1;
      Vec3 unit{0, 0, 0};
      unit[c] = 1;
      const Vec3 moment = cross(arm, unit);
      for (std::size_t j = 0; j < 3; ++j) r[3 + j] = moment[j] / size;
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) gram[i][j] += r[i] * r[j];
    }
  const char* remedy =
      "hold it with rollcon_body_set_support: all three components of one face, or at least six "
      "components that stop every translation and rotation";
  if (stiffness) add_stiffness(*stiffness, mesh.surface.node, middle, size, gram);
  if (held == 0 && !stiffness)
    fail(Status::err_singular, "the body has no supports and can move as a rigid body; %s", remedy);
  const int n = 6, work_size = 64;
  double value[6] = {}, work[work_size];
  int info = 0;
  dsyev_("V", "U", &n, &gram[0][0], &n, value, work, &work_size, &info);
  const double least = stiffness ? least_work : least_eigenvalue * value[5];
  if (info == 0 && std::abs(value[0]) > least) return;  // negative work is no rigid motion: the factor refuses it
  const auto free = std::count_if(std::begin(value), std::end(value), [&](double v) { return !(v > least); });
  // Column-major eigenvectors: gram[0] is the first.
  const double* motion = gram[0];
  const double largest =
      std::abs(*std::max_element(motion, motion + 6, [](double a, double b) { return std::abs(a) < std::abs(b); }));
  double shown[6];
  for (int i = 0; i < 6; ++i) {
    shown[i] = motion[i] / largest;
    if (std::abs(shown[i]) < 1e-6) shown[i] = 0;
  }
  fail(Status::err_singular,
       "the body is not held: %d rigid motion(s) are free, such as translation (%.3g, %.3g, %.3g) "
       "with rotation (%.3g, %.3g, %.3g) about (%.6g, %.6g, %.6g) over its size; %s",
       static_cast<int>(free), shown[0], shown[1], shown[2], shown[3], shown[4], shown[5], middle[0], middle[1],
       middle[2], remedy);
}

void refuse_incompressible_cavities(const BodyMesh& mesh, double poisson) {
  constexpr double most = 0.49;
  if (poisson <= most) return;
  const SurfaceMesh& surface = mesh.surface;
  constexpr double incompressible = 0.5 - 1e-9;
  constexpr std::uint8_t everything = 7;
  if (poisson > incompressible &&
      std::all_of(mesh.held.begin(), mesh.held.end(), [](std::uint8_t held) { return held == everything; }))
    fail(Status::err_unsupported,
         "poisson is %.12g and every node of the body is held: the pressure of an incompressible "
         "body "
         "is then undetermined; allowed: poisson < 0.5, or a free face",
         poisson);
  const Shells shells = find_shells(surface, sorted_sides(corner_cells(surface)));
  if (shells.size() < 2) return;
  const std::vector<double> volume = shell_volumes(surface, shells);
  const std::vector<std::uint8_t> held = held_elements(mesh);
  std::vector<std::uint8_t> shell_held(shells.size(), 0);
  for (std::size_t e = 0; e < held.size(); ++e)
    if (held[e]) shell_held[static_cast<std::size_t>(shells.shell[e])] = 1;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (volume[s] > 0 || shell_held[s]) continue;
    fail(Status::err_unsupported,
         "poisson is %.12g and the cavity of element %lld (counting from %d) is not held: boundary "
         "elements cannot tell its volume in a nearly incompressible body; allowed: poisson <= %g, "
         "or a held cavity",
         poisson, static_cast<long long>(shells.first[s]) + surface.index_base, surface.index_base, most);
  }
}

}  // namespace rollcon
