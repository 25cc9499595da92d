#include "support/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "support/element_runs.hpp"

namespace rollcon::scenes {

namespace {

AnyBody half_space_or_rigid(const std::optional<Elastic>& material) {
  if (material) return HalfspaceBody{*material};
  return RigidBody{};
}

std::vector<std::int32_t> nodes_of_tag(const SurfaceMesh& mesh, std::int32_t tag) {
  std::set<std::int32_t> nodes;
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    if (mesh.tag[static_cast<std::size_t>(e)] == tag)
      for (const std::int32_t k : mesh.element(e)) nodes.insert(k);
  return {nodes.begin(), nodes.end()};
}

}  // namespace

double traction_difference(const Solution& s, const Solution& reference) {
  if (s.nodes() != reference.nodes() || s.nodes() == 0) return std::nan("");
  double pressure = 0, friction = 0, normal = 0, tangential = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    const auto &a = s.traction[k], &b = reference.traction[k];
    pressure = std::max(pressure, std::abs(b[2]));
    friction = std::max(friction, std::hypot(b[0], b[1]));
    const double n = std::abs(a[2] - b[2]), t = std::hypot(a[0] - b[0], a[1] - b[1]);
    if (!std::isfinite(n) || !std::isfinite(t)) return std::nan("");
    normal = std::max(normal, n);
    tangential = std::max(tangential, t);
  }
  return std::max(normal / pressure, friction > 0 ? tangential / friction : tangential);
}

MeshedBody meshed(SurfaceMesh mesh, const Elastic& material) {
  MeshedBody body;
  body.mesh = std::move(mesh);
  body.material = material;
  return body;
}

MeshedBody meshed(volumes::Mesh mesh, const Elastic& material) {
  MeshedBody body = meshed(std::move(mesh.surface), material);
  body.volume = std::move(mesh.volume);
  return body;
}

namespace {

/// Throws with the library's message when status < 0.
std::int32_t check(rollcon_context*, std::int32_t status, const char* what) {
  if (status >= 0) return status;
  throw std::runtime_error(std::string(what) + ": " + rollcon_status_string(status) + ": " + rollcon_last_error());
}

void give_mesh(rollcon_context* context, rollcon_body* made, const MeshedBody& body) {
  const auto must = [&](std::int32_t status, const char* what) { check(context, status, what); };
  const SurfaceMesh& mesh = body.mesh;
  must(rollcon_body_set_nodes(made, mesh.nodes(), mesh.node[0].data(), 3, 1), "body_set_nodes");
  const auto add = [&](std::int32_t type, std::int32_t tag, std::int64_t count, const std::int32_t* connectivity) {
    must(rollcon_body_add_elements(made, type, count, connectivity, 0, tag), "body_add_elements");
  };
  for_runs(body.volume, add);
  for_runs(mesh, add);
  std::vector<Slide> support = body.slide;
  for (const std::int32_t tag : body.held_tag) support.push_back({tag, 7});
  for (const auto& [tag, dof_mask] : support) {
    const std::vector<std::int32_t> held = nodes_of_tag(mesh, tag);
    must(rollcon_body_set_support(made, static_cast<std::int64_t>(held.size()), held.data(), 0, dof_mask, nullptr),
         "body_set_support");
  }
  if (!body.contact_tag.empty())
    must(rollcon_body_set_contact_faces(made, static_cast<std::int64_t>(body.contact_tag.size()),
                                        body.contact_tag.data()),
         "body_set_contact_faces");
  for (const auto& [name, value] : body.option) must(rollcon_body_set_real(made, name.c_str(), value), name.c_str());
  for (const auto& [name, value] : body.int_option) must(rollcon_body_set_int(made, name.c_str(), value), name.c_str());
}

void turn(rollcon_context* context, rollcon_body* made, const SurfaceMesh& mesh) {
  const auto by_z = [](const Vec3& a, const Vec3& b) { return a[2] < b[2]; };
  const auto [low, high] = std::minmax_element(mesh.node.begin(), mesh.node.end(), by_z);
  std::vector<std::int32_t> held, tread;
  for (std::size_t k = 0; k < mesh.node.size(); ++k) {
    if (mesh.node[k][2] < (*low)[2] + 1e-9) held.push_back(static_cast<std::int32_t>(k));
    if (mesh.node[k][2] > (*high)[2] - 1e-9) tread.push_back(static_cast<std::int32_t>(k));
  }
  const double origin[3] = {0, 0, 0}, axis[3] = {0, 1, 0};
  const std::int32_t tag = 2;
  check(context, rollcon_body_set_support(made, std::ssize(held), held.data(), 0, 7, nullptr), "body_set_support");
  check(context, rollcon_body_tag_faces_of_nodes(made, std::ssize(tread), tread.data(), 0, tag), "tag_faces_of_nodes");
  check(context, rollcon_body_set_contact_faces(made, 1, &tag), "body_set_contact_faces");
  check(context, rollcon_body_revolve(made, origin, axis), "body_revolve");
}

std::int32_t kind_of(const AnyBody& body) {
  if (std::holds_alternative<HalfspaceBody>(body)) return ROLLCON_BODY_HALFSPACE;
  const auto* meshed = std::get_if<MeshedBody>(&body);
  if (!meshed || !meshed->material) return ROLLCON_BODY_RIGID;
  if (meshed->turned) return ROLLCON_BODY_SECTION;
  return meshed->volume.elements() > 0 ? ROLLCON_BODY_FEM : ROLLCON_BODY_BEM;
}

}  // namespace

rollcon_body* make_body(rollcon_context* context, const AnyBody& body) {
  rollcon_body* made = nullptr;
  check(context, rollcon_body_create(context, kind_of(body), &made), "body_create");
  const auto* meshed = std::get_if<MeshedBody>(&body);
  std::optional<Elastic> material;
  if (meshed) material = meshed->material;
  if (const auto* half = std::get_if<HalfspaceBody>(&body)) material = half->material;
  if (material)
    check(context, rollcon_body_set_elastic(made, 0, material->young(), material->poisson), "body_set_elastic");
  if (meshed) give_mesh(context, made, *meshed);
  if (meshed && meshed->turned) turn(context, made, meshed->mesh);
  return made;
}

RollingPair::RollingPair(std::optional<Elastic> body1, std::optional<Elastic> body2, int threads)
    : RollingPair(half_space_or_rigid(body1), half_space_or_rigid(body2), threads) {}

RollingPair::RollingPair(const AnyBody& body1, const AnyBody& body2, int threads) {
  if (rollcon_context_create(rollcon_abi(), &context_) != 0) throw std::runtime_error("rollcon_context_create failed");
  check(rollcon_context_set_threads(context_, threads), "set_threads");
  body_[0] = make_body(context_, body1);
  if (std::holds_alternative<TwinBody>(body2)) {
    body_[1] = body_[0];
    check(rollcon_body_retain(body_[0]), "body_retain");
  } else {
    body_[1] = make_body(context_, body2);
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
  return scenes::check(context_, status, what);
}

RollingPair& RollingPair::frame(const SurfaceMesh& mesh) {
  check(rollcon_contact_frame_nodes(contact_, mesh.nodes(), mesh.node[0].data(), 3, 1), "set_frame_nodes");
  for_runs(mesh, [&](std::int32_t type, std::int32_t tag, std::int64_t count, const std::int32_t* connectivity) {
    check(rollcon_contact_frame_add_elements(contact_, type, count, connectivity, 0, tag), "add_frame_elements");
  });
  return *this;
}

RollingPair& RollingPair::rectangle(ElementType type, int nx, int ny, double half_x, double half_y) {
  check(rollcon_contact_frame_rectangle(contact_, static_cast<std::int32_t>(type), nx, ny, -half_x, half_x, -half_y,
                                        half_y),
        "frame_rectangle");
  return *this;
}

RollingPair& RollingPair::frame_from_body(int which, std::int32_t tag) {
  check(rollcon_contact_frame_from_body(contact_, which, tag), "frame_from_body");
  return *this;
}

RollingPair& RollingPair::pose(int which, const std::array<Vec3, 3>& rotation, const Vec3& translation) {
  check(rollcon_contact_set_pose(contact_, which, rotation[0].data(), translation.data()), "set_pose");
  return *this;
}

RollingPair& RollingPair::axes(const Vec3& origin, const Vec3& rolling, const Vec3& normal) {
  check(rollcon_contact_set_axes(contact_, origin.data(), rolling.data(), normal.data()), "set_axes");
  return *this;
}

RollingPair& RollingPair::rolling_at(double angle) {
  return axes({0, 0, 0}, {std::cos(angle), std::sin(angle), 0}, {0, 0, 1});
}

RollingPair& RollingPair::gap(const std::vector<double>& h) {
  check(rollcon_contact_set_gap(contact_, static_cast<std::int64_t>(h.size()), h.data()), "set_gap");
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
  const bool procedure = std::string(name) == "procedure";
  check(procedure ? rollcon_contact_set_procedure(contact_, value) : rollcon_contact_set_str(contact_, name, value),
        name);
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
  std::int64_t nodes = 0, count = 0;
  check(rollcon_contact_get_size(contact_, &nodes, nullptr), "get_size");
  std::vector<double> values(components * static_cast<std::size_t>(nodes));
  check(rollcon_contact_get_field(contact_, which, ROLLCON_LOCAL, static_cast<std::int64_t>(values.size()),
                                  values.data(), &count),
        "get_field");
  return values;
}

Solution RollingPair::solution() const {
  Solution s;
  std::int64_t n = 0;
  check(rollcon_contact_get_size(contact_, &n, nullptr), "get_size");
  const auto nodes = static_cast<std::size_t>(n);
  s.traction.resize(nodes);
  s.slip.resize(nodes);
  s.state.resize(nodes);
  check(rollcon_contact_get_tractions(contact_, ROLLCON_LOCAL, n, s.traction[0].data()), "get_tractions");
  check(rollcon_contact_get_node_states(contact_, n, s.state.data()), "get_status");
  check(rollcon_contact_get_resultant(contact_, ROLLCON_LOCAL, s.force.data(), s.moment.data()), "get_resultant");
  check(rollcon_contact_get_motion(contact_, &s.approach, s.creep.data()), "get_motion");
  const std::vector<double> point = field(ROLLCON_FIELD_POINT, 3);
  const std::vector<double> slip = field(ROLLCON_FIELD_SLIP, 2);
  for (std::size_t k = 0; k < nodes; ++k) {
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
  check(rollcon_contact_get_displacements_at(contact_, body, static_cast<std::int64_t>(xy.size() / 2), xy.data(),
                                             u.data()),
        "get_displacements_at");
  return u;
}

double RollingPair::stat(const char* name) const {
  double value = 0;
  check(rollcon_contact_get_stat(contact_, name, &value), name);
  return value;
}

double RollingPair::body_stat(int which, const char* name) const {
  double value = 0;
  check(rollcon_body_get_stat(body_[which - 1], name, &value), name);
  return value;
}

std::string RollingPair::plan() const {
  std::string text(4000, '\0');
  std::int64_t needed = 0;
  check(rollcon_contact_get_plan(contact_, static_cast<std::int64_t>(text.size()), text.data(), &needed), "get_plan");
  return text.c_str();
}

}  // namespace rollcon::scenes
