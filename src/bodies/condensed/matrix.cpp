#include "bodies/condensed/matrix.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "bodies/model/mesh_models.hpp"
#include "geometry/surface_coupling.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon::condensed {

std::unique_ptr<SparseFactor> factor_of(const RowMatrix<double>& matrix, std::span<const std::int64_t> unknown,
                                        const char* what, std::int32_t index_base) {
  SparseMatrix lower;
  lower.begin(std::ssize(unknown));
  for (std::size_t j = 0; j < unknown.size(); ++j) {
    for (std::size_t i = j; i < unknown.size(); ++i)
      lower.push(static_cast<std::int64_t>(i), matrix.row(unknown[i])[unknown[j]]);
    lower.end_column();
  }
  try {
    return factor_definite(lower, {});
  } catch (const ZeroPivot& pivot) {
    const std::int64_t bad = unknown[at(pivot.unknown())];
    fail(Status::err_argument,
         "the %s is not positive definite: a force at component %c of node %lld (counting from %d) does work of the "
         "wrong sign, or none; check its entries, their signs, and that they have all digits",
         what, "xyz"[bad % 3], static_cast<long long>(bad / 3 + index_base), index_base);
  }
}

std::vector<double> inverse(SparseFactor& factor) {
  std::vector<double> b(at(factor.size() * factor.size()), 0.0);
  for (std::int64_t k = 0; k < factor.size(); ++k) b[at(k * factor.size() + k)] = 1;
  factor.solve(b.data(), factor.size());
  return b;
}

// A half-space moves by (1 - nu^2) P / (pi E) over the distance from a force P, and in the mean by 2.973 over the side
// of a square on which P is spread.
double local_young(const SurfaceMesh& surface, const RowMatrix<double>& flexibility, double poisson) {
  constexpr double middle = 1.0 / 3, of_pair = 2 * (2.973 - 1);
  std::vector<double> young;
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const Vec3 normal = unit_normal(surface, e, middle, middle);
    const auto corners = surface.element(e).first(at(corner_count(surface.type[at(e)])));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::int64_t pair[2] = {corners[k], corners[(k + 1) % corners.size()]};
      double work = 0;
      for (std::int64_t i = 0; i < 6; ++i)
        for (std::int64_t j = 0; j < 6; ++j)
          work += (i / 3 == j / 3 ? 1 : -1) * normal[at(i % 3)] * normal[at(j % 3)] *
                  flexibility.row(3 * pair[i / 3] + i % 3)[3 * pair[j / 3] + j % 3];
      const double away = length(surface.node[at(pair[0])] - surface.node[at(pair[1])]);
      if (work > 0) young.push_back((1 - poisson * poisson) / std::numbers::pi * of_pair / away / work);
    }
  }
  if (young.empty()) return 0;
  std::nth_element(young.begin(), young.begin() + std::ssize(young) / 2, young.end());
  return young[young.size() / 2];
}

// Unit nodal tractions act as forces M, so that displacements U = F M give F.
RowMatrix<double> matrix_on_faces(MatrixForm form, const SurfaceMesh& surface, const std::vector<std::int64_t>& faces,
                                  Condensed& response, int threads) {
  LoadedSurface loaded;
  loaded.face = faces;
  const std::shared_ptr<const SurfaceRows> rows = response.rows(loaded, threads);
  const SurfaceCoupling coupling = couple_faces(surface, faces);
  const auto n = std::ssize(coupling.node);
  const auto place = [](const std::vector<std::int32_t>& nodes, std::int64_t node) {
    return std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
  };
  RowMatrix<double> mass, matrix;
  mass.resize(n, n);
  for (std::int64_t j = 0; j < n; ++j)
    for (std::int64_t k = coupling.start[at(j)]; k < coupling.start[at(j) + 1]; ++k)
      mass.row(place(coupling.node, coupling.row[at(k)]))[j] = coupling.value[at(k)];
  std::vector<std::int64_t> all(at(3 * n));
  std::iota(all.begin(), all.end(), 0);
  const auto factor = factor_of(mass, std::span(all).first(at(n)), "mass of the faces", surface.index_base);
  matrix.resize(3 * n, 3 * n);
  std::vector<double> b(at(3 * n));
  for (std::int64_t i = 0; i < 3 * n; ++i) {
    const double* from = rows->u.row(3 * place(rows->row, coupling.node[at(i / 3)]) + i % 3);
    for (std::int64_t k = 0; k < 3 * n; ++k) b[at(k % 3 * n + k / 3)] = from[k];
    factor->solve(b.data(), 3);
    for (std::int64_t k = 0; k < 3 * n; ++k) matrix.row(i)[k] = b[at(k % 3 * n + k / 3)];
  }
  for (std::int64_t i = 0; i < 3 * n; ++i)
    for (std::int64_t j = 0; j < i; ++j)
      matrix.row(i)[j] = matrix.row(j)[i] = 0.5 * (matrix.row(i)[j] + matrix.row(j)[i]);
  if (form == MatrixForm::flexibility) return matrix;
  const auto flexible = factor_of(matrix, all, "flexibility of the contact faces", surface.index_base);
  const std::vector<double> inverted = inverse(*flexible);
  std::copy(inverted.begin(), inverted.end(), matrix.data());
  return matrix;
}

}  // namespace rollcon::condensed
