#include "world.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>

namespace fuzz {
namespace {

template <class Handle>
bool alive(const Handle* handle) {
  return rollcon_id_of(handle) != 0;
}

template <class Handle>
Handle* garbage(World& world, int how) {
  const auto fake = [](std::uintptr_t n) { return reinterpret_cast<Handle*>(n); };
  switch (how % 6) {
    case 0:
      return nullptr;
    case 1:
      return world.contexts.empty() ? nullptr : reinterpret_cast<Handle*>(world.contexts[0].handle);
    case 2:
      return world.bodies.empty() ? nullptr : reinterpret_cast<Handle*>(world.bodies[0].handle);
    case 3:
      return world.contacts.empty() ? nullptr : reinterpret_cast<Handle*>(world.contacts[0].handle);
    case 4:
      return fake(static_cast<std::uintptr_t>(world.in.word(8)));
    default:
      return fake(static_cast<std::uintptr_t>(world.in.word(4)) & 0x7fffffffU);
  }
}

template <class Handle>
Handle* pick(World& world, const std::vector<Owned<Handle>>& list) {
  const int how = world.in.byte();
  if (how >= 244 || list.empty()) return garbage<Handle>(world, how);
  return list[static_cast<std::size_t>(how) % list.size()].handle;
}

template <class Handle>
const rollcon_context* context_in(const std::vector<Owned<Handle>>& list, const void* handle) {
  for (const auto& entry : list)
    if (entry.handle == handle && alive(handle)) return entry.context;
  return nullptr;
}

template <class Handle>
void release_all(std::vector<Owned<Handle>>& list, void (*release)(Handle*)) {
  for (auto& entry : list) {
    for (int i = 0; i < entry.references; ++i) release(entry.handle);
    require(!alive(entry.handle), "a handle is alive after its last reference was released");
  }
}

}  // namespace

World::World(Input& input) : in(input) {}

World::~World() {
  release_all(contexts, rollcon_context_release);
  release_all(bodies, rollcon_body_release);
  release_all(contacts, rollcon_contact_release);
  release_all(wheelrails, rollcon_wheelrail_release);
}

rollcon_context* World::context() {
  return pick(*this, contexts);
}
rollcon_body* World::body() {
  return pick(*this, bodies);
}
rollcon_contact* World::contact() {
  return pick(*this, contacts);
}

rollcon_wheelrail* World::wheelrail() {
  return pick(*this, wheelrails);
}

rollcon_context* World::add(rollcon_context* made) {
  contexts.push_back({made, made, 1});
  return made;
}
rollcon_body* World::add(rollcon_body* made, rollcon_context* of) {
  bodies.push_back({made, of, 1});
  return made;
}
rollcon_contact* World::add(rollcon_contact* made, rollcon_context* of) {
  contacts.push_back({made, of, 1});
  return made;
}
rollcon_wheelrail* World::add(rollcon_wheelrail* made, rollcon_context* of) {
  wheelrails.push_back({made, of, 1});
  return made;
}

const rollcon_context* World::context_of(const void* handle) const {
  const rollcon_context* found = context_in(contexts, handle);
  if (!found) found = context_in(bodies, handle);
  if (!found) found = context_in(contacts, handle);
  if (!found) found = context_in(wheelrails, handle);
  return found && alive(found) ? found : nullptr;
}

const std::string& own_folder() {
  static const struct Folder {
    std::string name;
    Folder() {
      std::string pattern = (std::filesystem::temp_directory_path() / "rollcon_fuzz_XXXXXX").string();
      require(mkdtemp(pattern.data()) != nullptr, "no temporary folder");
      name = pattern;
      require(mkfifo((name + "/pipe").c_str(), 0600) == 0, "no pipe");
    }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(name, ignored);
    }
  } folder;
  return folder.name;
}

// Paths lie only in the folder, so that a library that replaces what it should not does no harm.
std::string World::path() {
  switch (in.below(12)) {
    case 0:
      return "";
    case 1:
      return own_folder();
    case 2:
      return own_folder() + "/no/such/folder/file";
    case 3:
      return own_folder() + "/" + std::string(300, 'x');
    case 4:
      return own_folder() + "/pipe";
    default:
      return own_folder() + "/" + static_cast<char>('a' + in.below(2));
  }
}

}  // namespace fuzz
