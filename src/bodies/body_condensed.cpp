/// Takes the stiffness or flexibility of a body that another program condensed, and writes that of a body.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bodies/body.hpp"
#include "bodies/model/mesh_models.hpp"
#include "io/matrix_file.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

MatrixForm checked_form(std::int32_t form) {
  if (form != 1 && form != 2) fail(Status::err_argument, "form is %d; allowed: 1 (stiffness), 2 (flexibility)", form);
  return static_cast<MatrixForm>(form);
}

std::string entry_name(std::int64_t row, std::int32_t index_base) {
  std::string name(1, "xyz"[row % 3]);
  return name.append(" of node ").append(std::to_string(row / 3 + index_base));
}

/// Orders rows by the body's nodes: those have the numbers of the mesh's file, else the order in which this one names
/// them.
CondensedMatrix in_order(MatrixForm form, const MatrixFile& file, std::span<const std::int64_t> number) {
  const std::int64_t rows = file.value.rows();
  if (file.node.empty()) return {form, file.value};
  if (form != MatrixForm::stiffness)
    fail(Status::err_argument, "form is 2 (flexibility), but the file has a stiffness");
  std::map<std::int64_t, std::int64_t> place;
  for (const std::int64_t n : number.empty() ? std::span<const std::int64_t>(file.node) : number)
    place.try_emplace(n, std::ssize(place));
  std::vector<std::int64_t> to, taken(at(rows), 0);
  for (std::size_t k = 0; k < file.node.size(); ++k) {
    const auto found = place.find(file.node[k]);
    if (found == place.end())
      fail(Status::err_argument, "the file has node %lld, which the body lacks", static_cast<long long>(file.node[k]));
    to.push_back(3 * found->second + file.component[k]);
    if (to.back() >= rows || taken[at(to.back())]++ > 0)
      fail(Status::err_argument, "the file does not have components x, y and z of each node once: see node %lld",
           static_cast<long long>(file.node[k]));
  }
  CondensedMatrix matrix{form, {}};
  matrix.value.resize(rows, rows);
  for (std::int64_t i = 0; i < rows; ++i)
    for (std::int64_t j = 0; j < rows; ++j) matrix.value.row(to[at(i)])[to[at(j)]] = file.value.row(i)[j];
  return matrix;
}

}  // namespace

void require_matrix(const CondensedMatrix& matrix, std::int64_t nodes, std::int32_t index_base) {
  checked_form(static_cast<std::int32_t>(matrix.form));
  constexpr double symmetric = 1e-6;
  const RowMatrix<double>& a = matrix.value;
  if (a.rows() != 3 * nodes || a.columns() != a.rows())
    fail(Status::err_argument, "the matrix has %lld rows; needed: %lld, three for each node of the body",
         static_cast<long long>(a.rows()), static_cast<long long>(3 * nodes));
  for (std::int64_t i = 0; i < a.rows(); ++i)
    for (std::int64_t j = 0; j <= i; ++j) {
      const double v = a.row(i)[j], w = a.row(j)[i];
      const auto name = [&](std::int64_t k) { return entry_name(k, index_base); };
      if (!std::isfinite(v) || !std::isfinite(w))
        fail(Status::err_nonfinite, "the entry of the matrix for %s and %s (counting from %d) is %g", name(i).c_str(),
             name(j).c_str(), index_base, std::isfinite(v) ? w : v);
      if (std::abs(v - w) > symmetric * std::sqrt(std::abs(a.row(i)[i] * a.row(j)[j])))
        fail(Status::err_argument,
             "the matrix is not symmetric: for %s and %s (counting from %d) it has %.9g, and %.9g the other way round",
             name(i).c_str(), name(j).c_str(), index_base, v, w);
    }
}

void Body::take_matrix(CondensedMatrix matrix) {
  require_matrix(matrix, given().surface.nodes(), given().surface.index_base);
  for (std::int64_t i = 0; i < matrix.value.rows(); ++i)
    for (std::int64_t j = 0; j < i; ++j)
      matrix.value.row(i)[j] = matrix.value.row(j)[i] = 0.5 * (matrix.value.row(i)[j] + matrix.value.row(j)[i]);
  given().matrix = std::make_shared<const CondensedMatrix>(std::move(matrix));
}

void Body::set_condensed(std::int32_t form, std::int64_t n, const double* matrix) {
  if (!traits_.given) fail(Status::err_state, "a %s body takes no stiffness or flexibility", traits_.name);
  CondensedMatrix taken{checked_form(form), {}};
  require_pointer(matrix, "matrix");
  const std::lock_guard lock(mutex_);
  require_unprepared("matrix is");
  const std::int64_t rows = 3 * given().surface.nodes();
  if (rows == 0) fail(Status::err_state, "the body has no nodes: call rollcon_body_set_nodes before its matrix");
  if (n != rows * rows)
    fail(Status::err_argument, "n is %lld; needed: %lld, the square of three times the body's %lld nodes",
         static_cast<long long>(n), static_cast<long long>(rows * rows), static_cast<long long>(rows / 3));
  taken.value.resize(rows, rows);
  std::copy_n(matrix, n, taken.value.data());
  take_matrix(std::move(taken));
}

void Body::read_condensed(std::int32_t form, const char* path) {
  if (!traits_.given) fail(Status::err_state, "a %s body takes no stiffness or flexibility", traits_.name);
  const MatrixForm as = checked_form(form);
  require_pointer(path, "path");
  const std::lock_guard lock(mutex_);
  require_unprepared("matrix is");
  const std::int64_t nodes = given().surface.nodes();
  if (nodes == 0) fail(Status::err_state, "the body has no nodes: call rollcon_body_set_nodes before its matrix");
  take_matrix(in_order(as, read_matrix_file(path, 3 * nodes), number_));
}

void Body::write_condensed(std::int32_t form, const char* path) const {
  const MatrixForm as = checked_form(form);
  require_pointer(path, "path");
  if (!traits_.make_response)
    fail(Status::err_unsupported, "the body is a %s body: it has no stiffness on nodes", traits_.name);
  if (!prepared()) fail(Status::err_state, "the body is not prepared: call rollcon_body_prepare first");
  const std::vector<std::int64_t> faces = contact_elements(mesh());
  if (faces.empty()) fail(Status::err_state, "the body has no contact faces (rollcon_body_set_contact_faces)");
  const RowMatrix<double> matrix =
      condensed::matrix_on_faces(as, mesh().surface, faces, *response(), context_->threads());
  std::string title = as == MatrixForm::stiffness ? "Stiffness" : "Flexibility";
  title.append(" of a ").append(traits_.name);
  title += " body of rollcon on the nodes of its contact faces, x, y, z of each. Their numbers:";
  const std::span<const std::int64_t> number = node_numbers();
  std::size_t count = 0;
  for (const std::int32_t k : nodes_of(mesh().surface, faces))
    title.append(count++ % 10 == 0 ? "\n" : " ").append(std::to_string(number.empty() ? k + 1 : number[at(k)]));
  write_matrix_file(path, matrix, title);
}

}  // namespace rollcon
