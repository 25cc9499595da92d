// Reads mesh files: they are refused with a text, or give a body or frame that can be asked, tagged and prepared. The
// first byte chooses a file that is changed the way the other bytes say; with 255 and 254 they are the file, .msh or
// .inp.

#include <fstream>
#include <iterator>
#include <sstream>

#include "scenes.hpp"

namespace fuzz {
namespace {

const std::vector<std::string>& names() {
  static const std::vector<std::string> list = {"hex20.inp",   "hex8.inp",    "tet10.inp",      "tet4.msh",
                                                "tet4_22.msh", "hex8_22.msh", "wedge18_22.msh", "wedge6.msh",
                                                "hex27.msh",   "hex20.msh"};
  return list;
}

std::string content(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(std::string(ROLLCON_TEST_DATA) + "/meshes/" + name, std::ios::binary).rdbuf();
  require(!text.str().empty(), "no file " + name);
  return text.str();
}

/// Removes, repeats or replaces bytes, words and lines.
std::string changed(std::string text, Input& in) {
  static const char* const words[] = {"-1",
                                      "0",
                                      "99999999999",
                                      "1e400",
                                      "nan",
                                      "*ELSET, ELSET=bar\nbar, bar\n",
                                      "\n",
                                      ",",
                                      "1, 9223372036854775807, 1",
                                      "*SURFACE, NAME=s\nbar, S3\n",
                                      "generate",
                                      "\"",
                                      "$End",
                                      "\xff\xff\xff\x7f",
                                      "2147483648",
                                      "*NSET, NSET=n, ELSET=bar\n",
                                      "-9223372036854775808",
                                      "9223372036854775807",
                                      "68719476736",
                                      "4611686018427387904"};
  for (int edits = 1 + in.below(4); edits > 0 && !text.empty(); --edits) {
    const auto place = [&] {
      return (static_cast<std::size_t>(in.byte()) * 256 + static_cast<std::size_t>(in.byte())) % text.size();
    };
    const std::size_t at = place();
    const auto word = [&] { return words[in.below(static_cast<int>(std::size(words)))]; };
    switch (in.below(6)) {
      case 0:
        text[at] = static_cast<char>(in.byte());
        break;
      case 1:
        text.erase(at, 1 + static_cast<std::size_t>(in.byte()));
        break;
      case 2:
        text.insert(at, text.substr(place(), 1 + static_cast<std::size_t>(in.byte())));
        break;
      case 3:
        text.insert(at, word());
        break;
      case 4: {  // a whole number, which all places that have it lose at once
        const std::size_t from = text.find_first_of("123456789", at);
        if (from == std::string::npos) break;
        const std::string number = text.substr(from, text.find_first_not_of("0123456789", from) - from), other = word();
        for (std::size_t i = from; (i = text.find(number, i)) != std::string::npos; i += other.size())
          text.replace(i, number.size(), other);
        break;
      }
      default:
        text.resize(at);
    }
  }
  return text;
}

void ask_groups(World& w, rollcon_body* body) {
  std::int32_t groups = 0;
  std::int64_t nodes = 0;
  FUZZ_CALL(w, rollcon_body_get_group_count, body, &groups);
  FUZZ_CALL(w, rollcon_body_get_size, body, &nodes, nullptr);
  for (std::int32_t i = 0; i < groups && i < 6; ++i) {
    char name[64] = "";
    std::int64_t n = 0;
    if (FUZZ_CALL(w, rollcon_body_get_group_name, body, i, sizeof name, name, nullptr) != ROLLCON_OK) continue;
    if (FUZZ_CALL(w, rollcon_body_get_group_nodes, body, name, 0, 0, nullptr, &n) != ROLLCON_OK) continue;
    Output<std::int32_t> ids(n);
    if (n > 0 && FUZZ_CALL(w, rollcon_body_get_group_nodes, body, name, 0, n, ids.data(), nullptr) == ROLLCON_OK) {
      for (std::size_t k = 0; k < ids.values().size(); ++k)
        require(ids.values()[k] >= 0 && ids.values()[k] < nodes && (k == 0 || ids.values()[k - 1] < ids.values()[k]),
                "nodes of a group are no ascending nodes of the body");
      if (i == 1) FUZZ_CALL(w, rollcon_body_set_support, body, n, ids.data(), 0, ROLLCON_DOF_XYZ, nullptr);
    }
    FUZZ_CALL(w, rollcon_body_tag_group, body, name, w.in.below(4));
  }
}

void read_body(World& w, rollcon_context* context, const std::string& path, const char* part) {
  const std::int32_t kinds[] = {ROLLCON_BODY_FEM, ROLLCON_BODY_FEM, ROLLCON_BODY_BEM, ROLLCON_BODY_RIGID};
  const std::int32_t kind = kinds[w.in.below(4)];
  rollcon_body* body = nullptr;
  if (FUZZ_CALL(w, rollcon_body_create, context, kind, &body) != ROLLCON_OK) return;
  w.add(body, context);
  if (FUZZ_CALL(w, rollcon_body_read_mesh, body, path.c_str(), part) != ROLLCON_OK) {
    std::int64_t nodes = -1;
    FUZZ_CALL(w, rollcon_body_get_size, body, &nodes, nullptr);
    require(nodes == 0, "a failed call changed the body");
    return;
  }
  ask_groups(w, body);
  for (int tag = 0; tag < 14 && kind != ROLLCON_BODY_RIGID; ++tag)
    FUZZ_CALL(w, rollcon_body_set_elastic, body, tag, 200.0, 0.3);
  FUZZ_CALL(w, rollcon_body_prepare, body);
}

void read_frame(World& w, const std::string& path, const char* part) {
  make_bodies(w, 1);
  rollcon_contact* contact = w.contacts.at(0).handle;
  if (FUZZ_CALL(w, rollcon_contact_frame_from_file, contact, path.c_str(), part) != ROLLCON_OK) return;
  std::int64_t nodes = 0, elements = 0;
  FUZZ_CALL(w, rollcon_contact_get_size, contact, &nodes, &elements);
  require(nodes > 0 && elements > 0, "a frame of nothing");
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fuzz;
  Input in(data, size);
  const int first = in.byte();
  const bool raw = first >= 254;
  const std::string& base = names()[static_cast<std::size_t>(first) % names().size()];
  const bool gmsh = raw ? first == 255 : base.ends_with(".msh");
  const std::string text = raw ? std::string(data + (size > 0 ? 1 : 0), data + size) : changed(content(base), in);
  const std::string path = own_folder() + (gmsh ? "/mesh.msh" : "/mesh.inp");
  std::ofstream(path, std::ios::binary) << text;
  World world(in);
  rollcon_context* context = nullptr;
  require(rollcon_context_create(ROLLCON_ABI, &context) == ROLLCON_OK, "no context");
  rollcon_context_set_threads(world.add(context), 1);
  static const char* const parts[] = {"", "bar", "low_end", "nothing"};
  const char* part = parts[in.below(4)];
  if (in.one_in(4))
    read_frame(world, path, part);
  else
    read_body(world, context, path, part);
  return 0;
}
