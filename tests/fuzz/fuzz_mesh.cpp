// Takes meshes of bodies and frames in every element type, whole or spoilt, through preparation and a solve. Prepared
// bodies are saved and loaded: the copy gives the body's answers to the last bit.

#include <algorithm>

#include "calls.hpp"
#include "scenes.hpp"

namespace fuzz {
namespace {

Box any_box(Input& in, std::int32_t type) {
  const int n[3] = {1 + in.below(3), 1 + in.below(2), 1 + in.below(2)};
  double size[3] = {1, 1, 1};
  for (double& s : size)
    if (in.one_in(4)) s = in.positive();
  return make_box(type, n, size);
}

void spoil(Input& in, Box& box) {
  if (box.element.empty()) return;
  const auto some = [&](std::size_t n) { return static_cast<std::size_t>(in.byte()) % n; };
  const auto width = static_cast<std::size_t>(box.per_element);
  for (int edits = in.below(6); edits > 0 && box.element.size() > width; --edits) {
    const auto first = box.element.begin() + static_cast<std::ptrdiff_t>(some(box.element.size() / width) * width);
    const auto last = first + static_cast<std::ptrdiff_t>(width);
    switch (in.below(9)) {
      case 0:
        box.x[some(box.x.size())] = in.real();
        break;
      case 1:
        box.x[some(box.x.size())] += in.real() / 16;
        break;
      case 2:
        *(first + static_cast<std::ptrdiff_t>(some(width))) = ids(in, 1, box.nodes())[0];
        break;
      case 3:
        std::swap(*first, *(first + static_cast<std::ptrdiff_t>(some(width))));
        break;
      case 4:
        std::reverse(first, last);
        break;
      case 5:
        box.element.erase(first, last);
        break;
      case 6: {
        const std::vector<std::int32_t> copy(first, last);
        box.element.insert(box.element.end(), copy.begin(), copy.end());
        break;
      }
      case 7: {  // a node upon, or next to, another
        const std::size_t a = some(box.x.size() / 3), b = some(box.x.size() / 3);
        const double off = in.one_in(2) ? 0 : in.real() * 1e-9;
        for (std::size_t c = 0; c < 3; ++c) box.x[3 * a + c] = box.x[3 * b + c] + off;
        break;
      }
      default: {  // a node without element
        const std::vector<double> more = in.reals(3);
        box.x.insert(box.x.end(), more.begin(), more.end());
      }
    }
  }
  box.side.resize(std::min(box.side.size(), box.element.size() / width));
  box.side.resize(box.element.size() / width, 0);
}

/// Gives elements of volumes all at once, those of surfaces by sides, each with a tag of its own.
void give_elements(World& w, rollcon_body* body, const Box& box, bool volume) {
  const std::int32_t tag = w.in.below(3);
  if (volume) {
    FUZZ_CALL(w, rollcon_body_add_elements, body, box.type, box.elements(), box.element.data(), 0, tag);
    return;
  }
  for (std::size_t e = 0; e < box.side.size(); ++e)
    FUZZ_CALL(w, rollcon_body_add_elements, body, box.type, 1,
              &box.element[e * static_cast<std::size_t>(box.per_element)], 0, box.side[e] + 1);
}

void name_faces(World& w, rollcon_body* body, const Box& box) {
  FUZZ_CALL(w, rollcon_body_tag_faces_of_nodes, body, static_cast<std::int64_t>(box.at_top.size()), box.at_top.data(),
            0, 6);
  if (w.in.one_in(3)) {
    const std::vector<std::int32_t> elements = ids(w.in, 3, box.elements()), faces = ids(w.in, 3, 6);
    FUZZ_CALL(w, rollcon_body_tag_faces, body, 3, elements.data(), faces.data(), 0, w.in.below(8));
  }
  if (w.in.one_in(3)) {  // by surface elements
    const std::int32_t type = element_types[w.in.below(5)];
    const std::vector<std::int32_t> nodes = ids(w.in, nodes_of_type(type), box.nodes());
    FUZZ_CALL(w, rollcon_body_add_elements, body, type, 1, nodes.data(), 0, w.in.below(8));
  }
}

void hold_and_load(World& w, rollcon_body* body, const Box& box) {
  const int how = w.in.below(8);
  const std::vector<std::int32_t> nodes = how == 0 ? ids(w.in, 1 + w.in.below(4), box.nodes()) : box.at_bottom;
  const std::vector<double> values = w.in.reals(how < 3 ? 3 * nodes.size() : 0);
  FUZZ_CALL(w, rollcon_body_set_support, body, static_cast<std::int64_t>(nodes.size()), nodes.data(), 0,
            how == 1 ? 1 + w.in.below(7) : ROLLCON_DOF_XYZ, values.empty() ? nullptr : values.data());
  for (int loads = w.in.below(3); loads > 0; --loads) {
    const std::vector<double> traction = w.in.reals(3);
    if (w.in.one_in(2))
      FUZZ_CALL(w, rollcon_body_set_traction, body, w.in.below(8), traction.data());
    else
      FUZZ_CALL(w, rollcon_body_set_pressure, body, w.in.below(8), traction[0]);
  }
  if (w.in.one_in(4)) {
    const std::vector<std::int32_t> tags = ids(w.in, 1 + w.in.below(2), 8);
    FUZZ_CALL(w, rollcon_body_set_contact_faces, body, static_cast<std::int64_t>(tags.size()), tags.data());
  }
}

void set_options(World& w, rollcon_body* body) {
  for (int options = w.in.below(3); options > 0; --options) {
    char name[64] = "";
    std::int32_t type = 0;
    double low = 0, high = 0;
    rollcon_option_info(ROLLCON_OF_BODY, w.in.byte() % rollcon_option_count(ROLLCON_OF_BODY), sizeof name, name,
                        nullptr, nullptr, &type, &low, &high, nullptr);
    const double value = low + w.in.byte() / 255.0 * (high - low);
    if (type == ROLLCON_TYPE_INT)
      FUZZ_CALL(w, rollcon_body_set_int, body, name, static_cast<std::int64_t>(value));
    else
      FUZZ_CALL(w, rollcon_body_set_real, body, name, value);
  }
}

std::vector<double> answer(World& w, rollcon_body* body, std::int64_t nodes) {
  Output<double> u(3 * nodes), reaction(6);
  if (FUZZ_CALL(w, rollcon_body_get_displacements, body, nodes, u.data()) != ROLLCON_OK) return {};
  FUZZ_CALL(w, rollcon_body_get_reaction, body, reaction.data(), reaction.data() + 3);
  std::vector<double> all = u.values();
  all.insert(all.end(), reaction.values().begin(), reaction.values().end());
  require(all_finite(all), "displacements or reaction are not finite");
  return all;
}

void save_and_load(World& w, rollcon_body* body, std::int64_t nodes) {
  const std::string path = own_folder() + "/body";
  rollcon_body* copy = nullptr;
  if (FUZZ_CALL(w, rollcon_body_save, body, path.c_str()) != ROLLCON_OK) return;
  // The copy is in a context of its own: in the body's context it would use what the body has.
  rollcon_context* other = nullptr;
  require(rollcon_context_create(ROLLCON_ABI, &other) == ROLLCON_OK, "no context");
  rollcon_context_set_threads(w.add(other), 1);
  require(FUZZ_CALL(w, rollcon_body_load, other, path.c_str(), &copy) == ROLLCON_OK, "what was saved cannot be loaded");
  w.add(copy, other);
  require(answer(w, body, nodes) == answer(w, copy, nodes), "a loaded body answers otherwise");
}

/// Brings the body that was prepared, or a rigid or elastic neighbour, into contact.
void bring_into_contact(World& w, rollcon_context* context, rollcon_body* body) {
  rollcon_body* other = nullptr;
  rollcon_contact* contact = nullptr;
  const bool rigid = w.in.one_in(2);
  std::int32_t kind = 0;
  rollcon_body_get_kind(body, &kind);
  const bool elastic_other = !rigid || kind == ROLLCON_BODY_RIGID;
  rollcon_body_create(context, elastic_other ? ROLLCON_BODY_HALFSPACE : ROLLCON_BODY_RIGID, &other);
  w.add(other, context);
  if (elastic_other) rollcon_body_set_elastic(other, 0, 100, 0.25);
  const bool first = !w.in.one_in(4);
  FUZZ_CALL(w, rollcon_contact_create, context, first ? body : other, first ? other : body, &contact);
  if (!contact) return;
  w.add(contact, context);
  double top[3] = {w.in.real() / 8, w.in.real() / 8, 1};
  const double rolling[3] = {1, 0, 0}, normal[3] = {0, 0, first ? 1.0 : -1.0}, mu = w.in.positive();
  if (w.in.one_in(8)) top[2] = w.in.real();
  FUZZ_CALL(w, rollcon_contact_set_axes, contact, top, rolling, normal);
  if (w.in.one_in(4)) {  // a frame laid on the body
    std::vector<double> x;
    const double width = w.in.positive();
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) x.insert(x.end(), {width * i / 2, width * j / 2, 1});
    const std::int32_t quads[] = {0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 7, 6, 4, 5, 8, 7};
    FUZZ_CALL(w, rollcon_contact_frame_nodes, contact, 9, x.data(), 3, 1);
    FUZZ_CALL(w, rollcon_contact_frame_add_elements, contact, ROLLCON_QUAD4, 4, quads, 0, 0);
  } else {
    FUZZ_CALL(w, rollcon_contact_frame_from_body, contact, first ? 1 : 2, w.in.one_in(4) ? w.in.below(8) : 6);
  }
  if (w.in.one_in(2)) FUZZ_CALL(w, rollcon_contact_set_gap_quadratic, contact, 0.05, 0.05, 0.0);
  FUZZ_CALL(w, rollcon_contact_set_friction, contact, "coulomb", 1, &mu);
  FUZZ_CALL(w, rollcon_contact_prescribe, contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, w.in.positive() / 64);
  FUZZ_CALL(w, rollcon_contact_set_creep, contact, w.in.real() / 1024, w.in.real() / 1024, 0.0);
  shorten(contact, 30);
  solve_and_check(w, contact);
}

void try_body(World& w, rollcon_context* context) {
  const std::int32_t kinds[] = {ROLLCON_BODY_FEM, ROLLCON_BODY_BEM, ROLLCON_BODY_FEM, ROLLCON_BODY_RIGID};
  const std::int32_t kind = kinds[w.in.below(4)];
  const bool volume = kind == ROLLCON_BODY_FEM;
  rollcon_body* body = nullptr;
  if (FUZZ_CALL(w, rollcon_body_create, context, kind, &body) != ROLLCON_OK) return;
  w.add(body, context);
  Box box = any_box(w.in, element_types[volume ? 5 + w.in.below(6) : w.in.below(5)]);
  spoil(w.in, box);
  FUZZ_CALL(w, rollcon_body_set_nodes, body, box.nodes(), box.x.data(), 3, 1);
  give_elements(w, body, box, volume);
  if (volume) name_faces(w, body, box);
  if (kind != ROLLCON_BODY_RIGID) {
    hold_and_load(w, body, box);
    for (int tag = 0; tag < 3; ++tag)
      FUZZ_CALL(w, rollcon_body_set_elastic, body, tag, w.in.one_in(4) ? w.in.positive() : 200.0,
                w.in.one_in(4) ? w.in.real() : 0.3);
  }
  set_options(w, body);
  const bool prepared = FUZZ_CALL(w, rollcon_body_prepare, body) == ROLLCON_OK;
  if (prepared) {
    answer(w, body, box.nodes());
    if (w.in.one_in(4)) save_and_load(w, body, box.nodes());
  }
  if (prepared || w.in.one_in(8)) bring_into_contact(w, context, body);
}

void try_frame(World& w) {
  make_bodies(w, 1);
  rollcon_contact* contact = w.contacts.at(0).handle;
  Box box = any_box(w.in, element_types[w.in.below(5)]);
  std::vector<std::int32_t> top;
  const auto width = static_cast<std::size_t>(box.per_element);
  for (std::size_t e = 0; e < box.side.size(); ++e)
    if (box.side[e] == 5) top.insert(top.end(), &box.element[e * width], &box.element[e * width] + width);
  box.element = top;
  for (std::size_t i = 2; i < box.x.size(); i += 3) box.x[i] -= 1;
  spoil(w.in, box);
  FUZZ_CALL(w, rollcon_contact_frame_nodes, contact, box.nodes(), box.x.data(), 3, 1);
  FUZZ_CALL(w, rollcon_contact_frame_add_elements, contact, box.type, box.elements(), box.element.data(), 0, 0);
  if (w.in.one_in(4)) {
    const std::int32_t type = element_types[w.in.below(5)];
    const std::vector<std::int32_t> nodes = ids(w.in, nodes_of_type(type), box.nodes());
    FUZZ_CALL(w, rollcon_contact_frame_add_elements, contact, type, 1, nodes.data(), 0, 1);
  }
  if (w.in.one_in(3)) {
    static const char* const values[] = {"dense", "table", "fft"};
    rollcon_contact_set_str(contact, "operators", values[w.in.below(3)]);
    static const char* const schemes[] = {"characteristic", "least_squares", "godunov"};
    rollcon_contact_set_str(contact, "convection", schemes[w.in.below(3)]);
  }
  if (solve_and_check(w, contact) < 0) require_usable(w, contact, 1);
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fuzz;
  Input in(data, size);
  World world(in);
  rollcon_context* context = nullptr;
  require(rollcon_context_create(ROLLCON_ABI, &context) == ROLLCON_OK, "no context");
  rollcon_context_set_threads(world.add(context), 1);
  if (in.one_in(4))
    try_frame(world);
  else
    try_body(world, context);
  return 0;
}
