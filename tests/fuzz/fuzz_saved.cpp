// Loads files of saved bodies: they are refused with a text, or give a body that can be asked and solved with. The
// first byte chooses a body to be saved and forged the way the other bytes say; with 255 they are the file.

#include <cstdio>

#include "forge.hpp"
#include "scenes.hpp"

namespace fuzz {
namespace {

void write_file(const std::string& path, const Bytes& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  require(file && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size(), "cannot write '" + path + "'");
  std::fclose(file);
}

void ask(World& w, rollcon_body* body) {
  std::int64_t nodes = 0;
  std::int32_t kind = 0;
  FUZZ_CALL(w, rollcon_body_get_size, body, &nodes, nullptr);
  FUZZ_CALL(w, rollcon_body_get_kind, body, &kind);
  Output<double> u(3 * nodes), reaction(6), value(1);
  const bool good = FUZZ_CALL(w, rollcon_body_get_displacements, body, nodes, u.data()) == ROLLCON_OK;
  require(good || u.untouched(), "a failed call wrote into its output");
  FUZZ_CALL(w, rollcon_body_get_reaction, body, reaction.data(), reaction.data() + 3);
  for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_BODY); ++i) {
    char name[64] = "";
    rollcon_stat_info(ROLLCON_OF_BODY, i, sizeof name, name, nullptr, nullptr, nullptr);
    FUZZ_CALL(w, rollcon_body_get_stat, body, name, value.data());
  }
}

void solve(World& w, rollcon_context* context, rollcon_body* body) {
  rollcon_body* other = nullptr;
  rollcon_contact* contact = nullptr;
  std::int32_t kind = 0;
  rollcon_body_get_kind(body, &kind);
  const bool rigid = kind == ROLLCON_BODY_RIGID;
  rollcon_body_create(context, rigid ? ROLLCON_BODY_HALFSPACE : ROLLCON_BODY_RIGID, &other);
  w.add(other, context);
  if (rigid) rollcon_body_set_elastic(other, 0, 100, 0.3);
  FUZZ_CALL(w, rollcon_contact_create, context, body, other, &contact);
  w.add(contact, context);
  set_scene(contact, kind == ROLLCON_BODY_HALFSPACE || rigid ? 0 : 2);
  shorten(contact, 20);
  // Factors of any kind may solve to anything: only the call itself is judged.
  FUZZ_CALL(w, rollcon_contact_solve, contact);
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fuzz;
  static const std::string path = own_folder() + "/body", copy = own_folder() + "/copy";
  Input in(data, size);
  const int first = in.byte();
  write_file(path, first == 255 ? Bytes(data + 1, data + size) : forged(saved_body(first % recipes), in));
  World world(in);
  rollcon_context* context = nullptr;
  rollcon_body* body = nullptr;
  require(rollcon_context_create(ROLLCON_ABI, &context) == ROLLCON_OK, "no context");
  rollcon_context_set_threads(world.add(context), 1);
  if (FUZZ_CALL(world, rollcon_body_load, context, path.c_str(), &body) != ROLLCON_OK) {
    require(body == nullptr, "a handle of nothing");
    return 0;
  }
  world.add(body, context);
  ask(world, body);
  solve(world, context, body);
  rollcon_body* again = nullptr;
  if (FUZZ_CALL(world, rollcon_body_save, body, copy.c_str()) == ROLLCON_OK &&
      FUZZ_CALL(world, rollcon_body_load, context, copy.c_str(), &again) == ROLLCON_OK)
    world.add(again, context);
  return 0;
}
