#include "contact/operators.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t chunk = 64;  // rows of compliance held at a time

// Transpose of the sparse convective rows: which slip rows use node J, with what factor.
struct Users {
  std::vector<std::int64_t> start;
  std::vector<std::int32_t> row;
  std::vector<double> value;
};

Users transpose(const SparseRows& d, std::int64_t n) {
  Users t;
  t.start.assign(static_cast<std::size_t>(n) + 1, 0);
  for (const std::int32_t j : d.column) ++t.start[static_cast<std::size_t>(j) + 1];
  for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j) t.start[j + 1] += t.start[j];
  t.row.resize(d.column.size());
  t.value.resize(d.column.size());
  std::vector<std::int64_t> next(t.start.begin(), t.start.end() - 1);
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t k = d.start[static_cast<std::size_t>(i)];
         k < d.start[static_cast<std::size_t>(i) + 1]; ++k) {
      const auto s = static_cast<std::size_t>(
          next[static_cast<std::size_t>(d.column[static_cast<std::size_t>(k)])]++);
      t.row[s] = static_cast<std::int32_t>(i);
      t.value[s] = d.value[static_cast<std::size_t>(k)];
    }
  return t;
}

// Spacing along the flow (t1): dual-cell area over half the extent of the neighbours across it.
std::vector<double> spacing_along_flow(const Frame& frame) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  std::vector<double> low(frame.y), high(frame.y), spacing(n);
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    double y_low = 1e300, y_high = -1e300;
    for (const std::int32_t k : frame.mesh.element(e)) {
      y_low = std::min(y_low, frame.y[static_cast<std::size_t>(k)]);
      y_high = std::max(y_high, frame.y[static_cast<std::size_t>(k)]);
    }
    const bool split = is_quadratic(frame.mesh.type[static_cast<std::size_t>(e)]);
    const double half = split ? 0.5 : 1.0;  // a quadratic element spans two spacings
    for (const std::int32_t k : frame.mesh.element(e)) {
      const auto i = static_cast<std::size_t>(k);
      low[i] = std::min(low[i], frame.y[i] + half * (y_low - frame.y[i]));
      high[i] = std::max(high[i], frame.y[i] + half * (y_high - frame.y[i]));
    }
  }
  const std::vector<double> area = projected_cell_area(frame);
  for (std::size_t i = 0; i < n; ++i) {
    const double side = std::sqrt(area[i]);
    const double across = 0.5 * (high[i] - low[i]);
    const double along = across > 0 ? area[i] / across : side;
    spacing[i] = frame.used[i] ? along : 0;
  }
  return spacing;
}

void scatter(const Users& users, std::int64_t first, std::int64_t count, const double* rows,
             std::int64_t stride, RowMatrix<double>& out) {
  for (std::int64_t p = 0; p < count; ++p) {
    const auto j = static_cast<std::size_t>(first + p);
    for (std::int64_t k = users.start[j]; k < users.start[j + 1]; ++k)
      axpy(users.value[static_cast<std::size_t>(k)], rows + p * stride,
           out.row(users.row[static_cast<std::size_t>(k)]), out.columns());
  }
}

// Derivatives along the surface instead of along its projection.
void follow_surface(const Frame& frame, ContactOperators& op) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  op.upstream_path.resize(op.upstream.size());
  for (std::size_t i = 0; i < n; ++i) {
    const double cosine = dot(frame.t1[i], frame.axes.t1);
    if (!op.upstream.empty()) {
      op.upstream_path[i] = op.upstream[i] / cosine;
      continue;
    }
    for (auto k = static_cast<std::size_t>(op.convection.start[i]);
         k < static_cast<std::size_t>(op.convection.start[i + 1]); ++k)
      op.convection.value[k] *= cosine;
  }
}

double largest(const RowMatrix<double>& block) {
  double value = 0;
  for (std::int64_t k = 0; k < block.rows() * block.columns(); ++k)
    value = std::max(value, std::abs(block.data()[k]));
  return value;
}

void drop_vanished_coupling(ContactOperators& op) {
  constexpr double rounding = 1e-12;
  const auto vanishes = [&](double coupling, double direct) {
    return coupling <= rounding * direct;
  };
  const double along = std::max(largest(op.block[0][0]), largest(op.block[0][1]));
  const double across = std::max(largest(op.block[1][0]), largest(op.block[1][1]));
  if (!vanishes(std::max(largest(op.block[2][0]), largest(op.block[2][1])),
                largest(op.block[2][2])) ||
      !vanishes(std::max(largest(op.block[0][2]), largest(op.block[1][2])),
                std::max(along, across)))
    return;
  for (int c = 0; c < 2; ++c) {
    op.block[2][c].release();
    op.block[c][2].release();
  }
  op.coupled = false;
  op.coupling_vanished = true;
}

// Says what is needed before the machine starts to swap or an allocation fails half way.
void require_memory(std::int64_t n, const bool (&rows)[3][3]) {
  double blocks = 0;
  for (const auto& row : rows)
    for (const bool wanted : row) blocks += wanted;
  const double gigabytes = blocks * static_cast<double>(n) * static_cast<double>(n) * 8 / 1e9;
  const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                         static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e9;
  if (gigabytes > machine)
    fail(Status::err_memory,
         "the operators of a frame of %lld nodes need %.1f GB, this machine has %.1f GB",
         static_cast<long long>(n), gigabytes, machine);
}

}  // namespace

std::size_t ContactOperators::bytes() const {
  std::size_t sum = 0;
  for (const auto& row : block)
    for (const auto& matrix : row) sum += matrix.bytes();
  return sum + convection.value.capacity() * (sizeof(double) + sizeof(std::int32_t));
}

void prepare_convection(const Frame& frame, Scheme scheme, double step, ContactOperators& op) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  op.slip_x = frame.x;
  op.slip_y = frame.y;
  op.upstream.clear();
  op.upstream_path.clear();
  op.convection = SparseRows{};
  switch (scheme) {
    case Scheme::godunov:
      op.convection = godunov(frame, 1, 0);
      break;
    case Scheme::least_squares:
      op.convection = least_squares(frame, 1, 0);
      break;
    case Scheme::characteristic:
      op.upstream = spacing_along_flow(frame);
      for (std::size_t i = 0; i < n; ++i) {
        op.upstream[i] *= step;
        op.slip_x[i] += op.upstream[i] / 2;  // second order: the difference is centred there
      }
  }
  if (frame.curved()) follow_surface(frame, op);
}

void convect(const ContactOperators& op, const double* w, const double* ahead,
             std::vector<double> (&slip)[2]) {
  const std::size_t n = op.slip_x.size();
  for (auto& v : slip) v.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t c = 0; c < 2; ++c) {
      if (!op.upstream.empty()) {
        if (op.upstream[k] > 0) slip[c][k] = (w[3 * k + c] - ahead[3 * k + c]) / op.path(k);
        continue;
      }
      for (auto j = static_cast<std::size_t>(op.convection.start[k]);
           j < static_cast<std::size_t>(op.convection.start[k + 1]); ++j)
        slip[c][k] +=
            op.convection.value[j] * w[3 * static_cast<std::size_t>(op.convection.column[j]) + c];
    }
}

void assemble_operators(const Frame& frame, const Compliance& compliance, bool want_tangential,
                        ContactOperators& op) {
  const std::int64_t n = frame.nodes();
  op.nodes = n;
  op.coupled = compliance.couples() && !op.coupling_vanished;
  const bool normal = !op.normal;
  const bool tangential = want_tangential && !op.tangential;
  // With coupling, a frictionless scene still needs no tangential column.
  const bool normal_coupled = op.coupled && want_tangential && op.block[2][0].empty();
  if (!normal && !tangential && !normal_coupled) return;

  bool rows[3][3] = {};
  rows[2][2] = normal;
  rows[2][0] = rows[2][1] = normal_coupled;
  for (int r = 0; r < 2; ++r) {
    rows[r][0] = rows[r][1] = tangential;
    rows[r][2] = tangential && op.coupled;
  }
  require_memory(n, rows);
  RowMatrix<double> buffer[3][3];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      if (!rows[r][c]) continue;
      op.block[r][c].resize(n, n);
      if (r < 2) {
        std::fill(op.block[r][c].data(), op.block[r][c].data() + n * n, 0.0);
        buffer[r][c].resize(chunk, n);
      }
    }
  const Users users = op.upstream.empty() && tangential ? transpose(op.convection, n) : Users{};

  std::vector<double> px, py;
  for (std::int64_t first = 0; first < n; first += chunk) {
    const std::int64_t count = std::min(chunk, n - first);
    const auto at = static_cast<std::size_t>(first);
    const auto size = static_cast<std::size_t>(count);
    ComplianceBlock out;
    out.stride = n;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        if (!rows[r][c]) continue;
        out.a[r][c] = r == 2 ? op.block[2][c].row(first) : buffer[r][c].data();
      }
    compliance.block({{frame.x.data() + at, size}, {frame.y.data() + at, size}}, out);
    if (!tangential) continue;
    if (op.upstream.empty()) {
      for (int r = 0; r < 2; ++r)
        for (int c = 0; c < 3; ++c)
          if (rows[r][c]) scatter(users, first, count, buffer[r][c].data(), n, op.block[r][c]);
      continue;
    }
    // Characteristic scheme: (w(x_I) - w(x_I + delta e)) / delta, both displacements exact.
    px.assign(frame.x.begin() + first, frame.x.begin() + first + count);
    py.assign(frame.y.begin() + first, frame.y.begin() + first + count);
    for (std::size_t p = 0; p < size; ++p) px[p] += op.upstream[at + p];
    ComplianceBlock ahead;
    ahead.stride = n;
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c)
        if (rows[r][c]) {
          std::copy(buffer[r][c].data(), buffer[r][c].data() + count * n,
                    op.block[r][c].row(first));
          ahead.a[r][c] = buffer[r][c].data();
        }
    compliance.block({{px.data(), size}, {py.data(), size}}, ahead);
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 3; ++c) {
        if (!rows[r][c]) continue;
        for (std::int64_t p = 0; p < count; ++p) {
          const double delta = op.path(at + static_cast<std::size_t>(p));
          const double factor = delta > 0 ? 1 / delta : 0;
          double* s = op.block[r][c].row(first + p);
          const double* w = buffer[r][c].row(p);
          for (std::int64_t k = 0; k < n; ++k) s[k] = factor * (s[k] - w[k]);
        }
      }
  }
  op.normal = true;
  if (tangential) op.tangential = true;
  if (tangential && op.coupled) drop_vanished_coupling(op);
}

}  // namespace rollcon
