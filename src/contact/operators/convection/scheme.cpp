/// A scheme's rows and samples.

#include <utility>

#include "contact/operators/convection/convection.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// w(x_I) - w(x_I + delta e), both displacements exact.
SparseRows differences(const std::vector<double>& ahead) {
  SparseRows rows;
  const std::size_t n = ahead.size();
  rows.start.push_back(0);
  for (std::size_t k = 0; k < n; ++k) {
    if (ahead[k] > 0) {
      rows.column.push_back(static_cast<std::int32_t>(k));
      rows.value.push_back(1);
      rows.column.push_back(static_cast<std::int32_t>(n + k));
      rows.value.push_back(-1);
    }
    rows.start.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  return rows;
}

Convection with_rows(const Frame& frame, SparseRows rows) {
  return {.rows = std::move(rows),
          .factor = std::vector<double>(frame.x.size(), 1.0),
          .ahead = {},
          .slip_x = frame.x,
          .slip_y = frame.y};
}

// Every node's own displacement.
SparseRows identity(std::size_t nodes) {
  SparseRows rows;
  rows.value.assign(nodes, 1.0);
  for (std::size_t k = 0; k < nodes; ++k) rows.column.push_back(static_cast<std::int32_t>(k));
  for (std::size_t k = 0; k <= nodes; ++k) rows.start.push_back(static_cast<std::int64_t>(k));
  return rows;
}

struct Row {
  Scheme scheme;
  const char* name;
  Convection (*make)(const Frame& frame, double step, bool ends_at_edge);
};

// A scheme is a row of this table, and an allowed value of the option `convection`; that of time steps takes their
// place where a scene has them.
constexpr Row schemes[] = {
    {Scheme::least_squares, "least_squares",
     [](const Frame& frame, double, bool) { return with_rows(frame, least_squares(frame, 1, 0)); }},
    {Scheme::godunov, "godunov",
     [](const Frame& frame, double, bool) { return with_rows(frame, godunov(frame, 1, 0)); }},
    {Scheme::characteristic, "characteristic",
     [](const Frame& frame, double step, bool ends_at_edge) {
       const std::vector<double> ahead = characteristic_steps(frame, step);
       Convection c = with_rows(frame, differences(ahead));
       for (std::size_t i = 0; i < ahead.size(); ++i) {
         c.factor[i] = ahead[i] > 0 ? 1 / ahead[i] : 0;
         c.slip_x[i] += ahead[i] / 2;  // second order: the difference is centred there
       }
       c.ahead = ahead;
       if (ends_at_edge) take_slip_at_nodes(frame, c);
       return c;
     }},
    {Scheme::time_step, "none: a step in time, displacements of the step before are carried along",
     [](const Frame& frame, double, bool) { return with_rows(frame, identity(frame.x.size())); }},
};

const Row& row_of(Scheme scheme) {
  for (const Row& row : schemes)
    if (row.scheme == scheme) return row;
  return schemes[0];
}

}  // namespace

Scheme scheme_of(const std::string& name) {
  for (const Row& row : schemes)
    if (name == row.name) return row.scheme;
  return schemes[0].scheme;
}

const char* name_of(Scheme scheme) {
  return row_of(scheme).name;
}

Convection make_convection(const Frame& frame, Scheme scheme, bool ends_at_edge, double step) {
  Convection c = row_of(scheme).make(frame, step, ends_at_edge);
  if (scheme == Scheme::time_step) return c;
  // Along the surface.
  for (std::size_t i = 0; i < frame.t1.size(); ++i) c.factor[i] *= dot(frame.t1[i], frame.axes.t1);
  return c;
}

void convect(const Convection& convection, const double* w, const double* ahead, std::vector<double> (&slip)[2]) {
  const SparseRows& d = convection.rows;
  const std::size_t n = convection.slip_x.size();
  for (std::size_t c = 0; c < 2; ++c) {
    slip[c].assign(n, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      double sum = 0;
      for (auto j = at(d.start[k]); j < at(d.start[k + 1]); ++j) {
        const std::size_t sample = at(d.column[j]);
        sum += d.value[j] * (sample < n ? w[3 * sample + c] : ahead[3 * (sample - n) + c]);
      }
      slip[c][k] = convection.factor[k] * sum;
    }
  }
}

}  // namespace rollcon
