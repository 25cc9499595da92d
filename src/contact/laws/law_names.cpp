#include "contact/laws/friction_law.hpp"

namespace rollcon {

std::span<const LawName> law_names() {
  static constexpr LawName names[] = {{"coulomb", &coulomb}};
  return names;
}

}  // namespace rollcon
