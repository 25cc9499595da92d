#pragma once
/// Makes a translation kernel of half-spaces.

#include <memory>

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/model/translation.hpp"

namespace rollcon {

std::shared_ptr<const TranslationKernel> make_halfspace_kernel(HalfspaceConstants c);

}  // namespace rollcon
