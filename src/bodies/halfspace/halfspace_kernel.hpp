#pragma once
/// Half-spaces as a translation kernel.

#include <memory>

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/model/translation.hpp"

namespace rollcon {

std::shared_ptr<const TranslationKernel> make_halfspace_kernel(HalfspaceConstants c);

}  // namespace rollcon
