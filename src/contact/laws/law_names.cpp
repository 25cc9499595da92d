#include "contact/laws/friction_law.hpp"

namespace rollcon {

// Each maker is in the file of its law.
MakeFriction make_coulomb, make_exponential, make_linear, make_orthotropic, make_orthotropic_collinear, make_rational,
    make_temperature;

std::span<const LawName> law_names() {
  static constexpr const char* falling = "3 or 5 parameters: muk, mu1, s1, and mu2, s2";
  static constexpr LawName names[] = {
      {"coulomb", "1 parameter: mu", 1, 1, make_coulomb},
      {"orthotropic", "3 parameters: mu1, mu2, angle", 3, 3, make_orthotropic},
      {"orthotropic_collinear", "3 parameters: mu1, mu2, angle", 3, 3, make_orthotropic_collinear},
      {"linear", falling, 3, 5, make_linear},
      {"rational", falling, 3, 5, make_rational},
      {"exponential", falling, 3, 5, make_exponential},
      {"temperature", "4 to 64 parameters: T1, mu1, T2, mu2, ...", 4, 64, make_temperature},
  };
  return names;
}

}  // namespace rollcon
