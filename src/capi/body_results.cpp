/// Implements the calls that return results of bodies.

#include "bodies/body_results.hpp"

#include <algorithm>

#include "capi/guard.hpp"
#include "capi/results.hpp"

using namespace rollcon;
using namespace rollcon::capi;

rollcon_status rollcon_body_get_size(const rollcon_body* body, int64_t* nodes, int64_t* elements) {
  return with_body(__func__, body, [&](const Body& b) {
    const auto [n, m] = b.size();
    if (nodes) *nodes = n;
    if (elements) *elements = m;
  });
}

rollcon_status rollcon_body_get_group_nodes(const rollcon_body* body, const char* group, int32_t index_base,
                                            int64_t capacity, int32_t* nodes, int64_t* n_nodes) {
  return with_body(__func__, body, [&](const Body& b) {
    require_index_base(index_base);
    const std::vector<std::int32_t> list = b.group_nodes(group);
    if (wants_copy(static_cast<int64_t>(list.size()), capacity, nodes, "nodes", n_nodes, "ids"))
      std::transform(list.begin(), list.end(), nodes, [&](std::int32_t node) { return node + index_base; });
  });
}

rollcon_status rollcon_body_get_displacements(const rollcon_body* body, int64_t capacity, double* u) {
  return with_body(__func__, body, [&](const Body& b) {
    require_count(capacity, "capacity");
    require_pointer(u, "u");
    body_displacements(b, capacity, u);
  });
}

rollcon_status rollcon_body_get_reaction(const rollcon_body* body, double* force, double* moment) {
  return with_body(__func__, body, [&](const Body& b) {
    Vec3 f, m;
    body_reaction(b, f, m);
    if (force) std::copy(f.begin(), f.end(), force);
    if (moment) std::copy(m.begin(), m.end(), moment);
  });
}

rollcon_status rollcon_body_get_node_stresses(const rollcon_body* body, int64_t nodes, const double* u,
                                              double* stress) {
  return with_body(__func__, body, [&](const Body& b) {
    require_pointer(stress, "stress");
    body_node_stresses(b, {nodes, u}, stress);
    require_finite_results(b.size().first, 6, stress, "stress");
  });
}

rollcon_status rollcon_body_get_point_stresses(const rollcon_body* body, int64_t nodes, const double* u,
                                               int64_t capacity, double* stress, double* xyz, int64_t* n_rows) {
  return with_body(__func__, body, [&](const Body& b) {
    const void* wanted = stress ? stress : xyz;
    const std::int64_t points = body_stress_points(b);
    if (!wants_copy(points, capacity, wanted, "stress and xyz", n_rows, "points")) return;
    body_point_stresses(b, {nodes, u}, stress, xyz);
    require_finite_fields(points, xyz, stress);
  });
}

rollcon_status rollcon_body_get_fields_at(const rollcon_body* body, int64_t nodes, const double* u, int64_t n,
                                          const double* xyz, double* displacement, double* stress) {
  return with_body(__func__, body, [&](const Body& b) {
    require_points(n, 6);
    if (n > 0) require_pointer(xyz, "xyz");
    require_finite_points(n, xyz, 3, "xyz");
    body_fields_at(b, {nodes, u}, n, xyz, displacement, stress);
    require_finite_fields(n, displacement, stress);
  });
}

rollcon_status rollcon_body_write(const rollcon_body* body, const char* path, int64_t nodes, const double* u) {
  return with_body(__func__, body, [&](const Body& b) {
    require_pointer(path, "path");
    if (*path == '\0') fail(Status::err_argument, "path is empty");
    write_body(b, {nodes, u}, path);
  });
}

rollcon_status rollcon_body_get_stat(const rollcon_body* body, const char* name, double* value) {
  return with_body(__func__, body, [&](const Body& b) {
    require_pointer(value, "value");
    *value = body_statistic(b, name);
  });
}
