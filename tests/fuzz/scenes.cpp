#include "scenes.hpp"

#include <cmath>

namespace fuzz {
namespace {

constexpr int around_top = 5;  // number of surfaces: the side z = size
constexpr int gap_of_mesh = 7;

void make_elastic(World& world, rollcon_body* body, std::int32_t type) {
  const int n[3] = {2, 1, 1};
  const double size[3] = {1, 1, 0.5};
  give_mesh(world, body, make_box(type, n, size));
  rollcon_body_set_elastic(body, 0, 200, 0.3);
}

rollcon_body* make_body(World& world, std::int32_t kind) {
  rollcon_body* body = nullptr;
  rollcon_context* context = world.contexts[0].handle;
  FUZZ_CALL(world, rollcon_body_create, context, kind, &body);
  return body ? world.add(body, context) : nullptr;
}

void set_frame(rollcon_contact* contact, double z) {
  constexpr int n = 5;
  std::vector<double> x;
  std::vector<std::int32_t> element;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) x.insert(x.end(), {1.0 * i / n, 1.0 * j / n, z});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int corner = j * (n + 1) + i;
      element.insert(element.end(), {corner, corner + 1, corner + n + 2, corner + n + 1});
    }
  rollcon_contact_frame_nodes(contact, (n + 1) * (n + 1), x.data(), 3, 1);
  rollcon_contact_frame_add_elements(contact, ROLLCON_QUAD4, n * n, element.data(), 0, 0);
}

struct OptionValue {
  std::string name, text;
  std::int32_t type = 0;
  double number = 0;
};

/// Returns the options of a new contact.
std::vector<OptionValue> read_standard_options() {
  std::vector<OptionValue> all;
  rollcon_context* context = nullptr;
  rollcon_body* body = nullptr;
  rollcon_contact* contact = nullptr;
  rollcon_context_create(ROLLCON_ABI, &context);
  rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body);
  rollcon_contact_create(context, body, body, &contact);
  for (std::int32_t i = 0; i < rollcon_option_count(ROLLCON_OF_CONTACT); ++i) {
    OptionValue option;
    char name[64] = "", text[64] = "";
    rollcon_option_info(ROLLCON_OF_CONTACT, i, sizeof name, name, nullptr, nullptr, &option.type, nullptr, nullptr,
                        &option.number);
    option.name = name;
    if (option.type == ROLLCON_TYPE_STR) rollcon_contact_get_str(contact, name, sizeof text, text, nullptr);
    option.text = text;
    all.push_back(option);
  }
  rollcon_contact_release(contact);
  rollcon_body_release(body);
  rollcon_context_release(context);
  return all;
}

/// Says whether there are results, which obey the laws.
bool solved(std::int32_t status) {
  return status == ROLLCON_OK || status == ROLLCON_RIM_CONTACT || status == ROLLCON_COARSE ||
         status == ROLLCON_INACCURATE;
}

void set_standard_options(rollcon_contact* contact) {
  static const std::vector<OptionValue> standard = read_standard_options();
  for (const OptionValue& option : standard) {
    const char* name = option.name.c_str();
    if (option.type == ROLLCON_TYPE_INT)
      rollcon_contact_set_int(contact, name, static_cast<std::int64_t>(option.number));
    if (option.type == ROLLCON_TYPE_REAL) rollcon_contact_set_real(contact, name, option.number);
    if (option.type == ROLLCON_TYPE_STR) rollcon_contact_set_str(contact, name, option.text.c_str());
  }
  shorten(contact, 60);
}

}  // namespace

void shorten(rollcon_contact* contact, int iterations) {
  rollcon_contact_set_int(contact, "max_iterations", iterations);
  rollcon_contact_set_real(contact, "frame_accuracy", least_frame_accuracy);
}

void give_mesh(World& world, rollcon_body* body, const Box& box) {
  FUZZ_CALL(world, rollcon_body_set_nodes, body, box.nodes(), box.x.data(), 3, 1);
  if (box.side.empty()) {
    FUZZ_CALL(world, rollcon_body_add_elements, body, box.type, box.elements(), box.element.data(), 0, 0);
    FUZZ_CALL(world, rollcon_body_tag_faces_of_nodes, body, static_cast<std::int64_t>(box.at_top.size()),
              box.at_top.data(), 0, around_top + 1);
  }
  for (std::size_t e = 0; e < box.side.size(); ++e)
    FUZZ_CALL(world, rollcon_body_add_elements, body, box.type, 1,
              &box.element[e * static_cast<std::size_t>(box.per_element)], 0, box.side[e] + 1);
  std::int32_t kind = 0;
  rollcon_body_get_kind(body, &kind);
  if (kind != ROLLCON_BODY_RIGID)
    FUZZ_CALL(world, rollcon_body_set_support, body, static_cast<std::int64_t>(box.at_bottom.size()),
              box.at_bottom.data(), 0, ROLLCON_DOF_XYZ, nullptr);
}

// Makes bodies by recipe. 0: half-space on a rigid plane; 1: two half-spaces; 2, 3: boundary elements on either; 4 to
// 6: finite elements on a rigid plane; 7: half-space under a rigid mesh.
void make_bodies(World& world, int recipe) {
  const bool meshed = recipe >= 2 && recipe <= 6;
  const std::int32_t kind = recipe < 2 || recipe == gap_of_mesh ? ROLLCON_BODY_HALFSPACE
                            : recipe < 4                        ? ROLLCON_BODY_BEM
                                                                : ROLLCON_BODY_FEM;
  static const std::int32_t type[recipes] = {
      0, 0, ROLLCON_QUAD4, ROLLCON_TRI3, ROLLCON_HEX8, ROLLCON_TET10, ROLLCON_WEDGE15, 0};
  rollcon_body* one = make_body(world, kind);
  rollcon_body* two = make_body(world, recipe == 1 || recipe == 3 ? ROLLCON_BODY_HALFSPACE : ROLLCON_BODY_RIGID);
  if (!one || !two) return;
  if (meshed)
    make_elastic(world, one, type[recipe]);
  else
    rollcon_body_set_elastic(one, 0, 1e4, 0.3);
  if (recipe == 1 || recipe == 3) rollcon_body_set_elastic(two, 0, 3e4, 0.1);
  if (recipe == gap_of_mesh) {
    const int n[3] = {2, 2, 1};
    const double size[3] = {1, 1, 0.5};
    give_mesh(world, two, make_box(ROLLCON_TRI3, n, size));
  }
  rollcon_contact* contact = nullptr;
  rollcon_context* context = world.contexts[0].handle;
  FUZZ_CALL(world, rollcon_contact_create, context, one, two, &contact);
  if (contact) set_scene(world.add(contact, context), recipe);
}

void set_scene(rollcon_contact* contact, int recipe) {
  const double mu = 0.1, identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, zero[3] = {0, 0, 0};
  const bool on_body = recipe >= 2 && recipe <= 6;
  const double origin[3] = {0.5, 0.5, on_body ? 0.5 : 0}, rolling[3] = {1, 0, 0}, normal[3] = {0, 0, 1};
  rollcon_contact_set_progress(contact, nullptr, nullptr);
  for (int which = 1; which <= 2; ++which) rollcon_contact_set_pose(contact, which, identity, zero);
  if (!on_body || rollcon_contact_frame_from_body(contact, 1, around_top + 1) != ROLLCON_OK)
    set_frame(contact, on_body ? 0.5 : 0);
  rollcon_contact_set_axes(contact, origin, rolling, normal);
  if (recipe != gap_of_mesh) rollcon_contact_set_gap_quadratic(contact, 0.1, on_body ? 0.02 : 0.15, 0);
  rollcon_contact_set_friction(contact, "coulomb", 1, &mu);
  rollcon_contact_set_rolling(contact, 10);
  for (const std::int32_t direction : {ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_SPIN})
    rollcon_contact_prescribe(contact, direction, ROLLCON_BY_MOTION, direction == 1 ? 1e-3 : 0);
  rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, on_body ? 0.028 : 0.01);
  set_standard_options(contact);
}

std::int32_t solve_and_check(World& world, rollcon_contact* contact) {
  const std::int32_t status = FUZZ_CALL(world, rollcon_contact_solve, contact);
  if (status < 0) return status;
  std::int64_t nodes = 0;
  rollcon_contact_get_size(contact, &nodes, nullptr);
  Output<double> traction(3 * nodes), force(3), moment(3), motion(4);
  FUZZ_CALL(world, rollcon_contact_get_tractions, contact, ROLLCON_LOCAL, nodes, traction.data());
  FUZZ_CALL(world, rollcon_contact_get_resultant, contact, ROLLCON_LOCAL, force.data(), moment.data());
  FUZZ_CALL(world, rollcon_contact_get_motion, contact, motion.data(), motion.data() + 1);
  const std::string with = "status " + std::to_string(status) + ", but ";
  require(all_finite(traction.values()), with + "a traction is not finite");
  require(all_finite(force.values()), with + "a force is not finite");
  require(all_finite(moment.values()), with + "a moment is not finite");
  require(all_finite(motion.values()), with + "a motion is not finite");
  if (!solved(status)) return status;
  // Nodes of no element may have any gap and slip.
  std::vector<std::int32_t> state(static_cast<std::size_t>(nodes));
  rollcon_contact_get_node_states(contact, nodes, state.data());
  for (const std::int32_t which : {ROLLCON_FIELD_GAP, ROLLCON_FIELD_SLIP, ROLLCON_FIELD_RIGID_SLIP}) {
    const std::size_t width = which == ROLLCON_FIELD_GAP ? 1 : 3;
    Output<double> field(3 * nodes);
    FUZZ_CALL(world, rollcon_contact_get_field, contact, which, ROLLCON_GLOBAL, 3 * nodes, field.data(), nullptr);
    for (std::size_t i = 0; i < width * state.size(); ++i)
      require(state[i / width] == ROLLCON_EXCLUDED || std::isfinite(field.values()[i]),
              with + "field " + std::to_string(which) + " is not finite");
  }
  for (std::size_t i = 0; i < traction.values().size(); i += 3)
    require(traction.values()[i + 2] <= 0, with + "a normal traction pulls");
  return status;
}

void require_usable(World& world, rollcon_contact* contact, int recipe) {
  if (recipe == gap_of_mesh || rollcon_id_of(contact) == 0 || world.bodies.size() < 2) return;
  // The contact would answer only with a failure that its context remembers.
  rollcon_context_set_latch(const_cast<rollcon_context*>(world.context_of(contact)), 0);
  rollcon_contact* fresh = nullptr;
  rollcon_context* context = nullptr;
  require(rollcon_context_create(ROLLCON_ABI, &context) == ROLLCON_OK, "no context");
  world.add(context);
  rollcon_context_set_threads(context, 1);
  rollcon_contact_create(context, world.bodies[0].handle, world.bodies[1].handle, &fresh);
  if (!fresh) return;
  world.add(fresh, context);
  std::int32_t status[2];
  double force[2][3] = {{0, 0, 0}, {0, 0, 0}};
  std::string text[2];
  rollcon_contact* const both[2] = {contact, fresh};
  for (int i = 0; i < 2; ++i) {
    set_scene(both[i], recipe);
    rollcon_contact_reset(both[i]);
    status[i] = solve_and_check(world, both[i]);
    if (status[i] >= 0)
      rollcon_contact_get_resultant(both[i], ROLLCON_LOCAL, force[i], nullptr);
    else
      text[i] = rollcon_last_error();
  }
  require(status[0] == status[1], "given the same scene, a used contact ends with status " + std::to_string(status[0]) +
                                      ", a fresh one with " + std::to_string(status[1]) + ". " + text[0] + text[1]);
  if (!solved(status[0])) return;
  const double scale = std::hypot(force[1][0], force[1][1], force[1][2]);
  for (int c = 0; c < 3; ++c)
    require(std::abs(force[0][c] - force[1][c]) <= 1e-7 * scale,
            "given the same scene, a used contact finds a force of " + std::to_string(force[0][c]) + ", a fresh one " +
                std::to_string(force[1][c]));
}

namespace {

std::vector<double> force_of_scene(int recipe) {
  Input nothing(nullptr, 0);
  World world(nothing);
  rollcon_context* context = nullptr;
  require(rollcon_context_create(ROLLCON_ABI, &context) == ROLLCON_OK, "no context");
  rollcon_context_set_threads(world.add(context), 1);
  make_bodies(world, recipe);
  if (world.contacts.empty()) return {};  // without its component
  const std::int32_t status = solve_and_check(world, world.contacts[0].handle);
  std::vector<double> force(3);
  rollcon_contact_get_resultant(world.contacts[0].handle, ROLLCON_LOCAL, force.data(), nullptr);
  require(solved(status) && force[2] < 0,
          "scene " + std::to_string(recipe) + " ends with status " + std::to_string(status));
  return force;
}

}  // namespace

void require_sound_library() {
  static int asked = 0;
  static std::vector<double> first[recipes];
  // All recipes come at first, then one at a time.
  for (int recipe = 0; recipe < recipes; ++recipe) {
    if (asked == 0)
      first[recipe] = force_of_scene(recipe);
    else if (asked % recipes == recipe)
      require(force_of_scene(recipe) == first[recipe],
              "scene " + std::to_string(recipe) + " has another solution than at first");
  }
  ++asked;
}

}  // namespace fuzz
