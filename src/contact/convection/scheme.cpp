/// Lists schemes by name, with what they have in common.

#include <utility>

#include "contact/convection/convection.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {

// Each maker is in the file of its scheme.
MakeConvection make_characteristic, make_godunov, make_least_squares, make_time_step;

namespace {

constexpr Scheme schemes[] = {
    {"characteristic", make_characteristic},
    {"least_squares", make_least_squares},
    {"godunov", make_godunov},
};

}  // namespace

// Initialisers of other files may use these before main.
constinit const Scheme Scheme::characteristic = schemes[0];
constinit const Scheme Scheme::time_step = {"none: a step in time, displacements of the step before are carried along",
                                            make_time_step};

const std::string& scheme_names() {
  static const std::string names = [] {
    std::string text;
    for (const Scheme& row : schemes) text.append(text.empty() ? "" : "|").append(row.name);
    return text;
  }();
  return names;
}

const Scheme& scheme_of(const std::string& name) {
  for (const Scheme& row : schemes)
    if (name == row.name) return row;
  fail(Status::err_internal, "no scheme '%s'", name.c_str());
}

Convection at_nodes(const Frame& frame, SparseRows rows) {
  return {.rows = std::move(rows),
          .factor = std::vector<double>(frame.x.size(), 1.0),
          .ahead = {},
          .slip_x = frame.x,
          .slip_y = frame.y};
}

Convection make_convection(const Frame& frame, const Scheme& scheme, bool ends_at_edge, double step) {
  Convection c = scheme.make(frame, step, ends_at_edge);
  if (scheme == Scheme::time_step) return c;
  // On a curved frame derivatives are along the surface.
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
