/// Implements the calls that return results of contacts.

#include <algorithm>
#include <iterator>

#include "capi/columns.hpp"
#include "capi/guard.hpp"
#include "capi/results.hpp"
#include "support/stress_invariants.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

InAxes checked_axes(int32_t axes) {
  if (axes != ROLLCON_LOCAL && axes != ROLLCON_GLOBAL)
    fail(Status::err_argument, "axes is %d; allowed: 0 (local), 1 (global)", axes);
  return static_cast<InAxes>(axes);
}

void require_capacity(int64_t capacity) {
  require_count(capacity, "capacity");
}

void require_body_number(int32_t which) {
  if (which != 1 && which != 2) fail(Status::err_argument, "which is %d; allowed: 1, 2", which);
}

}  // namespace

rollcon_status rollcon_contact_get_size(const rollcon_contact* contact, int64_t* nodes, int64_t* elements) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    if (nodes) *nodes = c.nodes();
    if (elements) *elements = c.elements();
  });
}

rollcon_status rollcon_contact_get_tractions(const rollcon_contact* contact, int32_t axes, int64_t capacity,
                                             double* t) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    const InAxes in = checked_axes(axes);
    require_capacity(capacity);
    require_pointer(t, "t");
    c.tractions(in, capacity, t);
    require_finite_results(c.nodes(), 3, t, "t");
  });
}

rollcon_status rollcon_contact_get_field(const rollcon_contact* contact, int32_t field, int32_t axes, int64_t capacity,
                                         double* v, int64_t* n_values) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    if (field < ROLLCON_FIELD_POINT || field > ROLLCON_FIELD_TEMPERATURE)
      fail(Status::err_argument, "field is %d; allowed: %d to %d", field, ROLLCON_FIELD_POINT,
           ROLLCON_FIELD_TEMPERATURE);
    const InAxes in = checked_axes(axes);
    const auto which = static_cast<Field>(field);
    const std::int64_t count = c.field(which, in, 0, nullptr);
    if (!wants_copy(count, capacity, v, "v", n_values, "doubles")) return;
    c.field(which, in, capacity, v);
    require_finite_results(c.nodes(), static_cast<int>(count / c.nodes()), v, "v");
  });
}

rollcon_status rollcon_contact_get_node_states(const rollcon_contact* contact, int64_t capacity, int32_t* status) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_capacity(capacity);
    require_pointer(status, "status");
    c.node_status(capacity, status);
  });
}

rollcon_status rollcon_contact_get_resultant(const rollcon_contact* contact, int32_t axes, double* force,
                                             double* moment) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    double f[3], m[3];
    c.resultant(checked_axes(axes), f, m);
    require_finite_results(1, 3, f, "force");
    require_finite_results(1, 3, m, "moment");
    if (force) std::copy_n(f, 3, force);
    if (moment) std::copy_n(m, 3, moment);
  });
}

rollcon_status rollcon_contact_get_motion(const rollcon_contact* contact, double* approach, double* creep) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    double a = 0, xi[3];
    c.motion(&a, xi);
    if (approach) *approach = a;
    if (creep) std::copy_n(xi, 3, creep);
  });
}

rollcon_status rollcon_contact_get_tilt(const rollcon_contact* contact, double* tilt) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_pointer(tilt, "tilt");
    double found[2];
    c.motion(nullptr, nullptr, found);
    std::copy_n(found, 2, tilt);
  });
}

rollcon_status rollcon_contact_get_sensitivity(const rollcon_contact* contact, int32_t parameter, double* force,
                                               double* moment, double* approach, double* creep) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    if (parameter < ROLLCON_LONGITUDINAL || parameter > ROLLCON_TILT_2)
      fail(Status::err_argument,
           "parameter is %d; allowed: %d to %d (longitudinal, lateral, normal, spin, friction, tilt 1, tilt 2)",
           parameter, ROLLCON_LONGITUDINAL, ROLLCON_TILT_2);
    double f[3], m[3], a = 0, xi[3];
    c.sensitivity(static_cast<Parameter>(parameter), f, m, &a, xi);
    require_finite_results(1, 3, f, "force");
    require_finite_results(1, 3, m, "moment");
    if (force) std::copy_n(f, 3, force);
    if (moment) std::copy_n(m, 3, moment);
    if (approach) *approach = a;
    if (creep) std::copy_n(xi, 3, creep);
  });
}

rollcon_status rollcon_contact_get_displacements_at(const rollcon_contact* contact, int32_t which, int64_t n,
                                                    const double* xy, double* u) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_body_number(which);
    require_points(n, 3);
    if (n > 0) {
      require_pointer(xy, "xy");
      require_pointer(u, "u");
    }
    require_finite_points(n, xy, 2, "xy");
    c.displacements_at(which, n, xy, u);
    require_finite_results(n, 3, u, "u");
  });
}

rollcon_status rollcon_contact_get_fields_at(const rollcon_contact* contact, int32_t which, int64_t n,
                                             const double* xyz, int32_t in_axes, double* u, double* stress) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_body_number(which);
    require_points(n, 6);
    if (n > 0) require_pointer(xyz, "xyz");
    if (in_axes != ROLLCON_IN_CONTACT && in_axes != ROLLCON_IN_BODY)
      fail(Status::err_argument, "in_axes is %d; allowed: 0 (in contact), 1 (in body)", in_axes);
    require_finite_points(n, xyz, 3, in_axes == ROLLCON_IN_BODY ? "xyz" : "12n");
    c.fields_at(which, in_axes == ROLLCON_IN_BODY, n, xyz, u, stress);
    require_finite_fields(n, u, stress);
  });
}

rollcon_status rollcon_contact_get_body_displacements(const rollcon_contact* contact, int32_t which, int64_t capacity,
                                                      double* u, int64_t* n_values) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_body_number(which);
    if (wants_copy(c.body_displacements(which, nullptr), capacity, u, "u", n_values, "doubles"))
      c.body_displacements(which, u);
  });
}

rollcon_status rollcon_contact_get_body_power(const rollcon_contact* contact, int32_t which, int64_t capacity,
                                              double* power, int64_t* n_values) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_body_number(which);
    const std::vector<double> found = c.body_power(which);
    if (wants_copy(std::ssize(found), capacity, power, "power", n_values, "doubles"))
      std::copy(found.begin(), found.end(), power);
  });
}

rollcon_status rollcon_contact_write_body(const rollcon_contact* contact, int32_t which, const char* path) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_body_number(which);
    require_pointer(path, "path");
    if (*path == '\0') fail(Status::err_argument, "path is empty");
    c.write_body(which, path);
  });
}

rollcon_status rollcon_contact_get_temperatures_at(const rollcon_contact* contact, int64_t n, const double* xy,
                                                   double* temperature) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_points(n, 2);
    if (n > 0) {
      require_pointer(xy, "xy");
      require_pointer(temperature, "temperature");
    }
    require_finite_points(n, xy, 2, "xy");
    c.temperatures_at(n, xy, temperature);
    require_finite_results(n, 2, temperature, "temperature");
  });
}

rollcon_status rollcon_contact_get_fatigue_index(const rollcon_contact* contact, double shear_yield, double* index) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_finite(shear_yield, "shear_yield");
    if (!(shear_yield > 0)) fail(Status::err_argument, "shear_yield is %g; allowed: above 0", shear_yield);
    require_pointer(index, "index");
    *index = c.fatigue_index(shear_yield);
  });
}

rollcon_status rollcon_contact_find_stress(const rollcon_contact* contact, int32_t which, const char* measure,
                                           int32_t n, const double* parameters, double* value, double place[3]) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_body_number(which);
    require_pointer(measure, "measure");
    require_pointer(value, "value");
    require_points(n, 1);
    if (n > 0) require_pointer(parameters, "parameters");
    require_finite_points(n, parameters, 1, "parameters");
    Vec3 at{};
    const double found = c.find_stress(which, measure, {parameters, static_cast<std::size_t>(n)}, at);
    require_finite_results(1, 1, &found, "value");
    *value = found;
    if (place) std::copy(at.begin(), at.end(), place);
  });
}

rollcon_status rollcon_contact_get_equivalent_ellipse(const rollcon_contact* contact, double inputs[9],
                                                      double center[2]) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_pointer(inputs, "inputs");
    require_pointer(center, "center");
    const EquivalentEllipse e = c.equivalent_ellipse();
    const double longitudinal = e.creepage[0] + strain_creepage(e.strained, e.load, e.a, e.b);
    const double all[] = {e.shear, e.poisson, e.friction, e.a, e.b, e.load, longitudinal, e.creepage[1], e.creepage[2]};
    std::copy(std::begin(all), std::end(all), inputs);
    std::copy(e.centre.begin(), e.centre.end(), center);
  });
}

rollcon_status rollcon_stress_invariants(int64_t n, const double* stress, double* principal, double* von_mises,
                                         double* shear) {
  return guarded(__func__, nullptr, [&] {
    require_points(n, 6);
    if (n > 0) require_pointer(stress, "stress");
    static constexpr const char* name[] = {"s11", "s22", "s33", "s12", "s13", "s23"};
    for (int64_t i = 0; i < 6 * n; ++i)
      if (!std::isfinite(stress[i]))
        fail(Status::err_nonfinite, "component %s of stress %lld (counting from 0) is %g", name[i % 6],
             static_cast<long long>(i / 6), stress[i]);
    for (int64_t i = 0; i < n; ++i) {
      const StressInvariants s = stress_invariants(stress + 6 * i);
      if (principal) std::copy_n(s.principal, 3, principal + 3 * i);
      if (von_mises) von_mises[i] = s.von_mises;
      if (shear) shear[i] = s.shear;
    }
  });
}

rollcon_status rollcon_contact_get_history(const rollcon_contact* contact, const char* columns, int64_t capacity,
                                           double* rows, int64_t* n_rows) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    static constexpr const char* known[] = {"phase",         "iteration",     "residual_normal", "residual_tangential",
                                            "step",          "nodes_contact", "nodes_slip",      "seconds",
                                            "error_function"};
    constexpr std::size_t width = std::size(known);
    const std::vector<std::size_t> wanted = read_names(columns, "columns", known);
    const std::span<const double> history = c.history(), merit = c.error_function();
    if (!wants_copy(std::ssize(merit), capacity, rows, "rows", n_rows, "rows")) return;
    for (std::size_t k = 0; k < merit.size(); ++k) {
      double row[width];
      std::copy_n(history.begin() + static_cast<std::ptrdiff_t>((width - 1) * k), width - 1, row);
      row[width - 1] = merit[k];
      rows = copy_columns(wanted, row, rows);
    }
  });
}

rollcon_status rollcon_contact_write(const rollcon_contact* contact, const char* path) {
  return with_contact(__func__, contact, [&](const Contact& c) {
    require_pointer(path, "path");
    if (*path == '\0') fail(Status::err_argument, "path is empty");
    c.write(path);
  });
}
