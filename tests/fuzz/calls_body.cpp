// Calls the functions of bodies: inputs, preparing, saving, results.

#include "calls.hpp"
#include "scenes.hpp"

namespace fuzz {
namespace {

std::int64_t nodes_of(const rollcon_body* body) {
  std::int64_t nodes = 0;
  rollcon_body_get_size(body, &nodes, nullptr);
  return nodes;
}

void create(World& w) {
  if (w.bodies.size() >= 8) return;
  rollcon_context* c = w.context();
  rollcon_body* made = nullptr;
  const std::int32_t kind = w.in.one_in(8) ? w.in.integer32() : 1 + w.in.below(4);
  if (FUZZ_CALL(w, rollcon_body_create, c, kind, w.in.one_in(30) ? nullptr : &made) == ROLLCON_OK)
    w.add(made, c);
  else
    require(made == nullptr, "a handle of nothing");
}

void retain(World& w) {
  rollcon_body* b = w.body();
  if (FUZZ_CALL(w, rollcon_body_retain, b) != ROLLCON_OK) return;
  for (auto& entry : w.bodies)
    if (entry.handle == b) ++entry.references;
}

void release(World& w) {
  rollcon_body* b = w.body();
  rollcon_body_release(b);
  for (auto& entry : w.bodies)
    if (entry.handle == b && entry.references > 0) --entry.references;
}

void set_elastic(World& w) {
  FUZZ_CALL(w, rollcon_body_set_elastic, w.body(), w.in.integer32(), w.in.positive(), w.in.real());
}

void give_box(World& w) {
  const int n[3] = {1 + w.in.below(2), 1 + w.in.below(2), 1};
  const double size[3] = {1, 1, 0.5};
  rollcon_body* b = w.body();
  if (w.context_of(b)) give_mesh(w, b, make_box(element_types[w.in.below(11)], n, size));
}

void set_nodes(World& w) {
  const std::int64_t n = array_size(w.in, 12), used = n > 0 ? n : 0;
  const bool packed = !w.in.one_in(4);
  const std::int64_t stride = packed ? 3 : 1, step = packed ? 1 : used;
  const std::vector<double> x = w.in.reals(static_cast<std::size_t>(3 * used));
  const bool odd = w.in.one_in(16);
  FUZZ_CALL(w, rollcon_body_set_nodes, w.body(), n, maybe_null(w.in, x), odd ? -w.in.below(3) : stride, step);
}

void add_elements(World& w) {
  rollcon_body* b = w.body();
  const std::int32_t type = element_type(w.in);
  const std::int64_t n = array_size(w.in, 4);
  const std::vector<std::int32_t> connectivity = ids(w.in, n > 0 ? n * nodes_of_type(type) : 0, nodes_of(b));
  FUZZ_CALL(w, rollcon_body_add_elements, b, type, n, maybe_null(w.in, connectivity),
            w.in.one_in(8) ? w.in.integer32() : 0, w.in.below(8));
}

void tag_faces(World& w) {
  const std::int64_t n = array_size(w.in, 6);
  const std::vector<std::int32_t> elements = ids(w.in, n, 4), faces = ids(w.in, n, 6);
  FUZZ_CALL(w, rollcon_body_tag_faces, w.body(), n, maybe_null(w.in, elements), maybe_null(w.in, faces), w.in.below(3),
            w.in.below(8));
}

void tag_faces_of_nodes(World& w) {
  rollcon_body* b = w.body();
  const std::int64_t n = array_size(w.in);
  const std::vector<std::int32_t> nodes = ids(w.in, n, nodes_of(b));
  FUZZ_CALL(w, rollcon_body_tag_faces_of_nodes, b, n, maybe_null(w.in, nodes), w.in.below(2), w.in.below(8));
}

void set_support(World& w) {
  rollcon_body* b = w.body();
  const std::int64_t n = array_size(w.in);
  const std::vector<std::int32_t> nodes = ids(w.in, n, nodes_of(b));
  const std::vector<double> values = w.in.reals(3 * nodes.size());
  FUZZ_CALL(w, rollcon_body_set_support, b, n, maybe_null(w.in, nodes), w.in.below(2),
            w.in.one_in(8) ? w.in.integer32() : 1 + w.in.below(7), w.in.one_in(2) ? nullptr : values.data());
}

void set_loads(World& w) {
  rollcon_body* b = w.body();
  const std::vector<double> traction = w.in.reals(3);
  const std::int64_t n = array_size(w.in, 3);
  const std::vector<std::int32_t> tags = ids(w.in, n, 8);
  switch (w.in.below(6)) {
    case 5: {
      const std::vector<std::int32_t> nodes = ids(w.in, n, nodes_of(b));
      const std::vector<double> values = w.in.reals(3 * nodes.size());
      FUZZ_CALL(w, rollcon_body_set_node_tractions, b, w.in.below(8), n, maybe_null(w.in, nodes), w.in.below(2),
                w.in.one_in(2) ? nullptr : traction.data(), maybe_null(w.in, values));
      break;
    }
    case 3:
      FUZZ_CALL(w, rollcon_body_set_body_force, b, w.in.below(3), maybe_null(w.in, traction));
      break;
    case 4:
      FUZZ_CALL(w, rollcon_body_set_rotation, b, w.in.below(3), w.in.real(), traction.data(),
                maybe_null(w.in, traction));
      break;
    case 0:
      FUZZ_CALL(w, rollcon_body_set_traction, b, w.in.below(8), maybe_null(w.in, traction));
      break;
    case 1:
      FUZZ_CALL(w, rollcon_body_set_pressure, b, w.in.below(8), traction[0]);
      break;
    default:
      FUZZ_CALL(w, rollcon_body_set_contact_faces, b, n, maybe_null(w.in, tags));
  }
}

void options(World& w) {
  rollcon_body* b = w.body();
  const std::string name = w.in.text(known_names());
  const char* text = w.in.one_in(40) ? nullptr : name.c_str();
  Output<std::int64_t> integer(1);
  Output<double> real(1);
  switch (w.in.below(4)) {
    case 0:
      FUZZ_CALL(w, rollcon_body_set_int, b, text, w.in.integer());
      break;
    case 1:
      FUZZ_CALL(w, rollcon_body_set_real, b, text, w.in.real());
      break;
    case 2:
      require(FUZZ_CALL(w, rollcon_body_get_int, b, text, integer.data()) == ROLLCON_OK || integer.untouched(),
              "a failed call wrote into its output");
      break;
    default:
      require(FUZZ_CALL(w, rollcon_body_get_real, b, text, real.data()) == ROLLCON_OK || real.untouched(),
              "a failed call wrote into its output");
  }
}

void prepare(World& w) {
  if (w.prepares_left-- > 0) FUZZ_CALL(w, rollcon_body_prepare, w.body());
}

void results(World& w) {
  rollcon_body* b = w.body();
  std::int64_t nodes = 0, elements = 0;
  FUZZ_CALL(w, rollcon_body_get_size, b, &nodes, &elements);
  std::int32_t kind = 0;
  FUZZ_CALL(w, rollcon_body_get_kind, b, &kind);
  const std::int64_t capacity = nodes - w.in.below(2);
  Output<double> u(3 * (capacity > 0 ? capacity : 0)), resultant(6), value(1);
  bool good = FUZZ_CALL(w, rollcon_body_get_displacements, b, capacity, u.data()) == ROLLCON_OK;
  require(good ? all_finite(u.values()) : u.untouched(), "displacements of a body");
  good = FUZZ_CALL(w, rollcon_body_get_reaction, b, resultant.data(),
                   w.in.one_in(4) ? nullptr : resultant.data() + 3) == ROLLCON_OK;
  require(good ? all_finite(resultant.values()) : resultant.untouched(), "reaction of a body");
  good = FUZZ_CALL(w, rollcon_body_get_stat, b, w.in.text(known_names()).c_str(), value.data()) == ROLLCON_OK;
  require(good || value.untouched(), "a failed call wrote into its output");
}

void fields(World& w) {
  const rollcon_body* b = w.body();
  std::int64_t nodes = 0, elements = 0, points = 0;
  FUZZ_CALL(w, rollcon_body_get_size, b, &nodes, &elements);
  const std::int64_t given = nodes - (w.in.one_in(8) ? 1 : 0);
  std::vector<double> moved = w.in.reals(static_cast<std::size_t>(given > 0 ? 3 * given : 0));
  const double* u = w.in.one_in(3) ? nullptr : moved.data();
  Output<double> stress(6 * nodes);
  bool good = FUZZ_CALL(w, rollcon_body_get_node_stresses, b, given, u, stress.data()) == ROLLCON_OK;
  require(good ? all_finite(stress.values()) : stress.untouched(), "stresses at nodes");
  FUZZ_CALL(w, rollcon_body_get_point_stresses, b, given, u, 0, nullptr, nullptr, &points);
  Output<double> at_points(6 * points), place(3 * points);
  good = FUZZ_CALL(w, rollcon_body_get_point_stresses, b, given, u, points, at_points.data(), place.data(), nullptr) ==
         ROLLCON_OK;
  require(
      good ? all_finite(at_points.values()) && all_finite(place.values()) : at_points.untouched() && place.untouched(),
      "stresses at integration points");
  const std::int64_t n = array_size(w.in, 4);
  std::vector<double> xyz = w.in.reals(static_cast<std::size_t>(n > 0 ? 3 * n : 0));
  Output<double> displacement(n > 0 ? 3 * n : 0), there(n > 0 ? 6 * n : 0);
  good = FUZZ_CALL(w, rollcon_body_get_fields_at, b, given, u, n, maybe_null(w.in, xyz), displacement.data(),
                   there.data()) == ROLLCON_OK;
  require(good ? all_finite(displacement.values()) && all_finite(there.values())
               : displacement.untouched() && there.untouched(),
          "fields in a body");
  if (w.files_left-- > 0) FUZZ_CALL(w, rollcon_body_write, b, w.path().c_str(), given, u);
}

void save(World& w) {
  const std::string path = w.path();
  if (w.files_left-- > 0 && w.prepares_left-- > 0)
    FUZZ_CALL(w, rollcon_body_save, w.body(), w.in.one_in(40) ? nullptr : path.c_str());
}

void load(World& w) {
  if (w.bodies.size() >= 8) return;
  rollcon_context* c = w.context();
  rollcon_body* made = nullptr;
  if (FUZZ_CALL(w, rollcon_body_load, c, w.path().c_str(), &made) == ROLLCON_OK)
    w.add(made, c);
  else
    require(made == nullptr, "a handle of nothing");
}

void copy(World& w) {
  if (w.bodies.size() >= 8) return;
  rollcon_body *from = w.body(), *made = nullptr;
  if (FUZZ_CALL(w, rollcon_body_copy, from, &made) == ROLLCON_OK)
    w.add(made, const_cast<rollcon_context*>(w.context_of(from)));
  else
    require(made == nullptr, "a handle of nothing");
}

}  // namespace

std::span<const Call> body_calls() {
  static const Call calls[] = {
      create,      retain,    release, set_elastic, set_nodes, add_elements, give_box, tag_faces, tag_faces_of_nodes,
      set_support, set_loads, options, set_elastic, prepare,   results,      fields,   results,   save,
      load,        copy};
  return calls;
}

}  // namespace fuzz
