// Calls the functions of contacts: making, frame, axes, motion, loads, friction, settings.

#include <cstring>

#include "calls.hpp"
#include "scenes.hpp"

namespace fuzz {
namespace {

std::int64_t nodes_of(const rollcon_contact* contact) {
  std::int64_t nodes = 0;
  rollcon_contact_get_size(contact, &nodes, nullptr);
  return nodes;
}

/// Returns a count for an array over the nodes of the frame, mostly theirs.
std::int64_t nodal_size(World& w, const rollcon_contact* contact) {
  return w.in.one_in(6) ? array_size(w.in) : nodes_of(contact);
}

void create(World& w) {
  if (w.contacts.size() >= 4) return;
  rollcon_context* c = w.context();
  rollcon_contact* made = nullptr;
  rollcon_body* one = w.body();
  rollcon_body* two = w.body();
  if (FUZZ_CALL(w, rollcon_contact_create, c, one, two, w.in.one_in(30) ? nullptr : &made) == ROLLCON_OK) {
    w.add(made, c);
    shorten(made, 40);
  } else {
    require(made == nullptr, "a handle of nothing");
  }
}

void retain(World& w) {
  rollcon_contact* c = w.contact();
  if (FUZZ_CALL(w, rollcon_contact_retain, c) != ROLLCON_OK) return;
  for (auto& entry : w.contacts)
    if (entry.handle == c) ++entry.references;
}

void release(World& w) {
  rollcon_contact* c = w.contact();
  rollcon_contact_release(c);
  for (auto& entry : w.contacts)
    if (entry.handle == c && entry.references > 0) --entry.references;
}

void set_frame_nodes(World& w) {
  const std::int64_t n = array_size(w.in, 16), used = n > 0 ? n : 0;
  const bool packed = !w.in.one_in(4);
  std::vector<double> x = w.in.reals(static_cast<std::size_t>(3 * used));
  if (packed && !w.in.one_in(4))
    for (std::size_t i = 2; i < x.size(); i += 3) x[i] = 0;
  FUZZ_CALL(w, rollcon_contact_frame_nodes, w.contact(), n, maybe_null(w.in, x), packed ? 3 : 1, packed ? 1 : used);
}

/// Gives a lattice, perhaps with some of its nodes moved.
void give_lattice(World& w) {
  rollcon_contact* c = w.contact();
  const int n = 2 + w.in.below(4), m = 2 + w.in.below(4);
  const double width = 1 + w.in.real() / 4, z = w.in.one_in(4) ? w.in.real() : 0;
  std::vector<double> x;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) x.insert(x.end(), {width * i / (n - 1), width * j / (m - 1), z});
  for (int moved = w.in.below(3); moved > 0; --moved)
    x[static_cast<std::size_t>(w.in.byte()) % x.size()] += w.in.real() / 8;
  FUZZ_CALL(w, rollcon_contact_frame_nodes, c, n * m, x.data(), 3, 1);
  std::vector<std::int32_t> element;
  const bool triangles = w.in.one_in(3);
  for (int j = 0; j + 1 < m; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int a = j * n + i;
      if (triangles)
        element.insert(element.end(), {a, a + 1, a + n + 1, a, a + n + 1, a + n});
      else
        element.insert(element.end(), {a, a + 1, a + n + 1, a + n});
    }
  FUZZ_CALL(w, rollcon_contact_frame_add_elements, c, triangles ? ROLLCON_TRI3 : ROLLCON_QUAD4,
            static_cast<std::int64_t>(element.size()) / (triangles ? 3 : 4), element.data(), 0, 0);
}

void add_frame_elements(World& w) {
  rollcon_contact* c = w.contact();
  const std::int32_t type = element_type(w.in);
  const std::int64_t n = array_size(w.in, 4);
  const std::vector<std::int32_t> connectivity = ids(w.in, n > 0 ? n * nodes_of_type(type) : 0, nodes_of(c));
  FUZZ_CALL(w, rollcon_contact_frame_add_elements, c, type, n, maybe_null(w.in, connectivity),
            w.in.one_in(8) ? w.in.integer32() : 0, w.in.integer32());
}

void frame_from_body(World& w) {
  FUZZ_CALL(w, rollcon_contact_frame_from_body, w.contact(), w.in.below(4), w.in.below(8));
}

void set_pose(World& w) {
  static const double turn[4][9] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},
                                    {1, 0, 0, 0, -1, 0, 0, 0, -1},
                                    {0, -1, 0, 1, 0, 0, 0, 0, 1},
                                    {0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1}};
  const std::vector<double> any = w.in.reals(w.in.one_in(4) ? 9 : 0), translation = w.in.reals(3);
  const double* rotation = any.empty() ? turn[w.in.below(4)] : any.data();
  FUZZ_CALL(w, rollcon_contact_set_pose, w.contact(), w.in.below(4), rotation, maybe_null(w.in, translation));
}

void set_axes(World& w) {
  const std::vector<double> origin = w.in.reals(3), rolling = w.in.reals(3), normal = w.in.reals(3);
  const double x[3] = {1, 0, 0}, z[3] = {0, 0, 1};
  FUZZ_CALL(w, rollcon_contact_set_axes, w.contact(), maybe_null(w.in, origin), w.in.one_in(3) ? rolling.data() : x,
            w.in.one_in(3) ? normal.data() : z);
}

void set_gap(World& w) {
  rollcon_contact* c = w.contact();
  if (w.in.one_in(2)) {
    FUZZ_CALL(w, rollcon_contact_set_gap_quadratic, c, w.in.real(), w.in.real(), w.in.real());
    return;
  }
  const std::int64_t n = nodal_size(w, c);
  std::vector<double> gap = w.in.reals(static_cast<std::size_t>(n > 0 ? n : 0));
  FUZZ_CALL(w, rollcon_contact_set_gap, c, n, maybe_null(w.in, gap));
}

void set_motion(World& w) {
  rollcon_contact* c = w.contact();
  switch (w.in.below(5)) {
    case 4: {
      const std::vector<double> velocity = w.in.reals(3), turning = w.in.reals(3), point = w.in.reals(3);
      FUZZ_CALL(w, rollcon_contact_set_velocity, c, w.in.one_in(12) ? w.in.integer32() : w.in.below(3),
                maybe_null(w.in, velocity), maybe_null(w.in, turning), maybe_null(w.in, point));
      break;
    }
    case 0:
      FUZZ_CALL(w, rollcon_contact_set_rolling, c, w.in.positive());
      break;
    case 1:
      FUZZ_CALL(w, rollcon_contact_set_creep, c, w.in.real(), w.in.real(), w.in.real());
      break;
    default:
      FUZZ_CALL(w, rollcon_contact_prescribe, c, w.in.one_in(12) ? w.in.integer32() : 1 + w.in.below(4),
                w.in.one_in(12) ? w.in.integer32() : 1 + w.in.below(2), w.in.real());
  }
}

void set_fields(World& w) {
  rollcon_contact* c = w.contact();
  const std::int64_t n = nodal_size(w, c);
  const std::vector<double> field = w.in.reals(static_cast<std::size_t>(n > 0 ? 2 * n : 0));
  std::vector<double> mu(field.begin(), field.begin() + (n > 0 ? n : 0));
  for (double& value : mu)
    if (!w.in.one_in(30)) value = value < 0 ? -value : value;
  if (w.in.one_in(2))
    FUZZ_CALL(w, rollcon_contact_set_creep_field, c, n, maybe_null(w.in, field));
  else
    FUZZ_CALL(w, rollcon_contact_set_friction_field, c, n, maybe_null(w.in, mu));
}

void set_friction(World& w) {
  const std::vector<double> mu{w.in.positive(), 0};
  const std::string law = w.in.one_in(12) ? w.in.text({"coulomb ", "Coulomb", ""}) : "coulomb";
  FUZZ_CALL(w, rollcon_contact_set_friction, w.contact(), w.in.one_in(40) ? nullptr : law.c_str(),
            w.in.one_in(12) ? static_cast<std::int32_t>(array_size(w.in, 2)) : 1, maybe_null(w.in, mu));
}

void set_option(World& w) {
  rollcon_contact* c = w.contact();
  static const std::vector<std::string> texts = {
      "characteristic", "least_squares",  "godunov",         "auto",          "lu",
      "gmres",          "gmres_adaptive", "dense",           "table",         "fft",
      "condensed",      "monolithic",     "exact",           "b_derivative",  "reduced",
      "jacobi",         "simplified",     "pseudo_temporal", "extrapolation", "none",
      "diagonal",       "bodies",         "kept_lu",         "armijo",        "off"};
  const std::string name = w.in.text(known_names()), value = w.in.text(texts);
  const char* text = w.in.one_in(40) ? nullptr : name.c_str();
  switch (w.in.below(4)) {
    case 0: {
      // Long solves find nothing.
      const std::int64_t n = w.in.integer();
      if (name != "max_iterations" || n <= 60) FUZZ_CALL(w, rollcon_contact_set_int, c, text, n);
      break;
    }
    case 1: {
      const double x = w.in.positive() / 16;
      if (name != "frame_accuracy" || x >= least_frame_accuracy) FUZZ_CALL(w, rollcon_contact_set_real, c, text, x);
      break;
    }
    default:
      FUZZ_CALL(w, rollcon_contact_set_str, c, text, w.in.one_in(40) ? nullptr : value.c_str());
  }
}

/// Takes the name of an option of contacts and, mostly, a value in range.
void set_option_in_range(World& w) {
  char name[64] = "";
  std::int32_t type = 0;
  double low = 0, high = 0, standard = 0;
  rollcon_option_info(ROLLCON_OF_CONTACT, w.in.byte() % rollcon_option_count(ROLLCON_OF_CONTACT), sizeof name, name,
                      nullptr, nullptr, &type, &low, &high, &standard);
  const double part = w.in.byte() / 255.0;
  if (std::strcmp(name, "frame_accuracy") == 0) low = least_frame_accuracy;
  const double value = low + part * part * part * (high - low);
  rollcon_contact* c = w.contact();
  if (w.in.one_in(16)) FUZZ_CALL(w, rollcon_contact_set_procedure, c, w.in.one_in(2) ? "" : "line_search=off system");
  if (type == ROLLCON_TYPE_INT && high <= 1)
    FUZZ_CALL(w, rollcon_contact_set_int, c, name, static_cast<std::int64_t>(value + 0.5));
  if (type == ROLLCON_TYPE_REAL) FUZZ_CALL(w, rollcon_contact_set_real, c, name, value);
}

void get_option(World& w) {
  const rollcon_contact* c = w.contact();
  const std::string name = w.in.text(known_names());
  Output<std::int64_t> integer(1);
  Output<double> real(1);
  require(FUZZ_CALL(w, rollcon_contact_get_int, c, name.c_str(), integer.data()) == ROLLCON_OK || integer.untouched(),
          "a failed call wrote into its output");
  require(FUZZ_CALL(w, rollcon_contact_get_real, c, name.c_str(), real.data()) == ROLLCON_OK || real.untouched(),
          "a failed call wrote into its output");
  std::int64_t need = 1;
  rollcon_contact_get_str(c, name.c_str(), 0, nullptr, &need);
  ask<char>(w, need, [&](std::int64_t capacity, char* text, std::int64_t* needed) {
    return FUZZ_CALL(w, rollcon_contact_get_str, c, name.c_str(), capacity, text, needed);
  });
}

}  // namespace

std::span<const Call> contact_calls() {
  static const Call calls[] = {create,
                               retain,
                               release,
                               set_frame_nodes,
                               add_frame_elements,
                               give_lattice,
                               set_option,
                               set_friction,
                               set_pose,
                               set_axes,
                               set_gap,
                               set_motion,
                               set_motion,
                               set_fields,
                               get_option,
                               frame_from_body,
                               set_option_in_range,
                               set_option_in_range};
  return calls;
}

}  // namespace fuzz
