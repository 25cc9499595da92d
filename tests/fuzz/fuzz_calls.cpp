// Makes sequences of calls of the C interface. The first byte chooses a scene to begin with; each further call takes a
// byte for the function and what it needs for its arguments.

#include "calls.hpp"
#include "scenes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fuzz;
  static int inputs = 0;
  Input in(data, size);
  {
    World world(in);
    rollcon_context* context = nullptr;
    require(rollcon_context_create(ROLLCON_ABI, &context) == ROLLCON_OK, "no context");
    rollcon_context_set_threads(world.add(context), 1);
    const int begin = in.byte(), recipe = begin % (recipes + 1);
    if (recipe < recipes) make_bodies(world, recipe);
    const std::span<const Call> kinds[] = {context_calls(), body_calls(),     body_calls(),  contact_calls(),
                                           contact_calls(), contact_calls(),  solve_calls(), solve_calls(),
                                           result_calls(),  wheelrail_calls()};
    for (int left = 60; left > 0 && in.more(); --left) {
      const std::span<const Call> calls = kinds[in.below(static_cast<int>(std::size(kinds)))];
      calls[in.byte() % calls.size()](world);
    }
    // The check does not follow each input, because it takes as long as the calls.
    if (recipe < recipes && begin / (recipes + 1) % 4 == 0 && !world.contacts.empty())
      require_usable(world, world.contacts[0].handle, recipe);
  }
  if (++inputs % 50 == 1) require_sound_library();
  return 0;
}
