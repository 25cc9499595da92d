#include "support/scene.hpp"

#include <cmath>
#include <stdexcept>

namespace rollcon::scenes {

RollingPair::RollingPair(std::optional<Elastic> body1, std::optional<Elastic> body2, int threads) {
  if (rollcon_context_create(rollcon_abi(), &context_) != 0)
    throw std::runtime_error("rollcon_context_create failed");
  check(rollcon_context_set_threads(context_, threads), "set_threads");
  const std::optional<Elastic> material[2] = {body1, body2};
  for (int i = 0; i < 2; ++i) {
    const std::int32_t kind = material[i] ? ROLLCON_BODY_HALFSPACE : ROLLCON_BODY_RIGID;
    check(rollcon_body_create(context_, kind, &body_[i]), "body_create");
    if (material[i])
      check(rollcon_body_set_elastic(body_[i], 0, material[i]->young(), material[i]->poisson),
            "body_set_elastic");
  }
  check(rollcon_contact_create(context_, body_[0], body_[1], &contact_), "contact_create");
}

RollingPair::~RollingPair() {
  rollcon_contact_release(contact_);
  rollcon_body_release(body_[0]);
  rollcon_body_release(body_[1]);
  rollcon_context_release(context_);
}

std::int32_t RollingPair::check(std::int32_t status, const char* what) const {
  if (status >= 0) return status;
  std::string text(1000, '\0');
  std::int64_t needed = 0;
  rollcon_context_get_error(context_, static_cast<std::int64_t>(text.size()), text.data(), &needed);
  throw std::runtime_error(std::string(what) + ": " + rollcon_status_string(status) + ": " +
                           text.c_str());
}

RollingPair& RollingPair::frame(const SurfaceMesh& mesh) {
  nodes_ = mesh.node.size();
  check(rollcon_contact_set_frame_nodes(contact_, mesh.nodes(), mesh.node[0].data(), 3, 1),
        "set_frame_nodes");
  // Runs of elements of one type go in together.
  for (std::int64_t first = 0; first < mesh.elements();) {
    std::int64_t last = first;
    const auto at = [&](std::int64_t e) { return mesh.type[static_cast<std::size_t>(e)]; };
    while (last < mesh.elements() && at(last) == at(first)) ++last;
    check(rollcon_contact_add_frame_elements(contact_, static_cast<std::int32_t>(at(first)),
                                             last - first, mesh.element(first).data(), 0, 0),
          "add_frame_elements");
    first = last;
  }
  return *this;
}

RollingPair& RollingPair::rolling_at(double angle) {
  const double origin[3] = {0, 0, 0}, normal[3] = {0, 0, 1};
  const double rolling[3] = {std::cos(angle), std::sin(angle), 0};
  check(rollcon_contact_set_axes(contact_, origin, rolling, normal), "set_axes");
  return *this;
}

RollingPair& RollingPair::gap(const std::vector<double>& h) {
  check(rollcon_contact_set_gap(contact_, static_cast<std::int64_t>(h.size()), h.data()),
        "set_gap");
  return *this;
}

RollingPair& RollingPair::gap_quadratic(double A, double B, double C) {
  check(rollcon_contact_set_gap_quadratic(contact_, A, B, C), "set_gap_quadratic");
  return *this;
}

RollingPair& RollingPair::speed(double v) {
  check(rollcon_contact_set_rolling(contact_, v), "set_rolling");
  return *this;
}

RollingPair& RollingPair::creep(double longitudinal, double lateral, double spin) {
  check(rollcon_contact_set_creep(contact_, longitudinal, lateral, spin), "set_creep");
  return *this;
}

RollingPair& RollingPair::creep_field(const std::vector<double>& slip_pairs) {
  const auto n = static_cast<std::int64_t>(slip_pairs.size() / 2);
  check(rollcon_contact_set_creep_field(contact_, n, slip_pairs.data()), "set_creep_field");
  return *this;
}

RollingPair& RollingPair::approach(double value) {
  check(rollcon_contact_prescribe(contact_, ROLLCON_NORMAL, ROLLCON_BY_MOTION, value), "prescribe");
  return *this;
}

RollingPair& RollingPair::load(double value) {
  return tangential_force(ROLLCON_NORMAL, value);
}

RollingPair& RollingPair::tangential_force(std::int32_t direction, double value) {
  check(rollcon_contact_prescribe(contact_, direction, ROLLCON_BY_FORCE, value), "prescribe");
  return *this;
}

RollingPair& RollingPair::friction(double mu) {
  check(rollcon_contact_set_friction(contact_, "coulomb", 1, &mu), "set_friction");
  return *this;
}

RollingPair& RollingPair::option(const char* name, const char* value) {
  check(rollcon_contact_set_str(contact_, name, value), name);
  return *this;
}

RollingPair& RollingPair::option(const char* name, double value) {
  check(rollcon_contact_set_real(contact_, name, value), name);
  return *this;
}

RollingPair& RollingPair::option(const char* name, std::int64_t value) {
  check(rollcon_contact_set_int(contact_, name, value), name);
  return *this;
}

std::int32_t RollingPair::solve() {
  return check(rollcon_contact_solve(contact_), "solve");
}

void RollingPair::reset() {
  check(rollcon_contact_reset(contact_), "reset");
}

std::vector<double> RollingPair::field(std::int32_t which, std::size_t components) const {
  std::vector<double> values(components * nodes_);
  std::int64_t count = 0;
  check(rollcon_contact_get_field(contact_, which, ROLLCON_LOCAL,
                                  static_cast<std::int64_t>(values.size()), values.data(), &count),
        "get_field");
  return values;
}

Solution RollingPair::solution() const {
  Solution s;
  s.traction.resize(nodes_);
  s.slip.resize(nodes_);
  s.state.resize(nodes_);
  const auto n = static_cast<std::int64_t>(nodes_);
  check(rollcon_contact_get_tractions(contact_, ROLLCON_LOCAL, n, s.traction[0].data()),
        "get_tractions");
  check(rollcon_contact_get_status(contact_, n, s.state.data()), "get_status");
  check(rollcon_contact_get_resultant(contact_, ROLLCON_LOCAL, s.force.data(), s.moment.data()),
        "get_resultant");
  check(rollcon_contact_get_motion(contact_, &s.approach, s.creep.data()), "get_motion");
  const std::vector<double> point = field(ROLLCON_FIELD_POINT, 3);
  const std::vector<double> slip = field(ROLLCON_FIELD_SLIP, 2);
  for (std::size_t k = 0; k < nodes_; ++k) {
    s.x.push_back(point[3 * k]);
    s.y.push_back(point[3 * k + 1]);
    s.slip[k] = {slip[2 * k], slip[2 * k + 1]};
  }
  s.pressure = field(ROLLCON_FIELD_PRESSURE, 1);
  s.gap = field(ROLLCON_FIELD_GAP, 1);
  s.area = field(ROLLCON_FIELD_AREA, 1);
  s.weight = field(ROLLCON_FIELD_WEIGHT, 1);
  return s;
}

std::vector<double> RollingPair::displacements_at(int body, const std::vector<double>& xy) const {
  std::vector<double> u(xy.size() / 2 * 3);
  check(rollcon_contact_get_displacements_at(
            contact_, body, static_cast<std::int64_t>(xy.size() / 2), xy.data(), u.data()),
        "get_displacements_at");
  return u;
}

double RollingPair::stat(const char* name) const {
  double value = 0;
  check(rollcon_contact_get_stat(contact_, name, &value), name);
  return value;
}

}  // namespace rollcon::scenes
