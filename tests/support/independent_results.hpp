#pragma once
/// Collects what the public functions return of a solve, and where the nodes lie: the raw material of independent_laws.

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/independent_laws.hpp"
#include "support/independent_surface.hpp"

namespace rollcon::laws {

inline void must(std::int32_t status, const char* what) {
  if (status < 0) throw std::runtime_error(std::string(what) + ": " + rollcon_status_string(status));
}

/// Holds results of the public functions, in local axes.
struct Results {
  std::vector<double> traction, gap, slip, weight, area, friction, power;
  std::vector<std::int32_t> state;
  double force[3] = {}, moment[3] = {}, approach = 0, creep[3] = {};

  explicit Results(const rollcon_contact* contact) {
    std::int64_t n = 0;
    must(rollcon_contact_get_size(contact, &n, nullptr), "get_size");
    traction.resize(static_cast<std::size_t>(3 * n));
    state.resize(static_cast<std::size_t>(n));
    must(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, n, traction.data()), "get_tractions");
    must(rollcon_contact_get_node_states(contact, n, state.data()), "get_status");
    must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment), "get_resultant");
    must(rollcon_contact_get_motion(contact, &approach, creep), "get_motion");
    const auto field = [&](std::int32_t which, std::int64_t components) {
      std::vector<double> v(static_cast<std::size_t>(components * n));
      std::int64_t count = 0;
      must(rollcon_contact_get_field(contact, which, ROLLCON_LOCAL, components * n, v.data(), &count), "get_field");
      return v;
    };
    gap = field(ROLLCON_FIELD_GAP, 1);
    slip = field(ROLLCON_FIELD_SLIP, 2);
    weight = field(ROLLCON_FIELD_WEIGHT, 1);
    area = field(ROLLCON_FIELD_AREA, 1);
    friction = field(ROLLCON_FIELD_FRICTION, 1);
    power = field(ROLLCON_FIELD_FRICTION_POWER, 1);
  }

  bool finite() const {
    bool all = std::isfinite(approach);
    const auto look = [&](const double* v, std::size_t n) {
      for (std::size_t k = 0; k < n; ++k) all = all && std::isfinite(v[k]);
    };
    for (const auto* v : {&traction, &gap, &slip, &weight, &area, &friction, &power}) look(v->data(), v->size());
    look(force, 3), look(moment, 3), look(creep, 3);
    return all;
  }
};

/// Returns positions in the axes.
inline Plane project(const Given& given) {
  const double scale = 1 / length(given.normal);
  const Vec3 n = scale * given.normal;
  Vec3 t1 = given.rolling - dot(given.rolling, n) * n;
  t1 = (1 / length(t1)) * t1;
  const Vec3 t2 = cross(n, t1);
  Plane at;
  for (const Vec3& node : given.frame.node) {
    const Vec3 d = node - given.origin;
    at.x.push_back(dot(d, t1));
    at.y.push_back(dot(d, t2));
  }
  return at;
}

}  // namespace rollcon::laws
