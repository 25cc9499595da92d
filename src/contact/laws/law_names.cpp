#include "contact/laws/friction_law.hpp"

namespace rollcon {

std::span<const LawName> law_names() {
  static constexpr LawName names[] = {
      {"coulomb", "1 parameter: mu", 1, 1, make_coulomb},
      {"orthotropic", "3 parameters: mu1, mu2, angle", 3, 3, make_orthotropic},
      {"orthotropic_collinear", "3 parameters: mu1, mu2, angle", 3, 3, make_orthotropic_collinear},
  };
  return names;
}

}  // namespace rollcon
