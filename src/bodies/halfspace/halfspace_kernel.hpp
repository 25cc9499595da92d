#pragma once
/// Makes a translation kernel of half-spaces.

#include <memory>
#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "bodies/model/translation.hpp"

namespace rollcon {

std::shared_ptr<const TranslationKernel> make_halfspace_kernel(HalfspaceConstants c);
/// Makes the kernel of half-spaces with lags, for lattices whose first axis is t1.
std::shared_ptr<const TranslationKernel> make_lagging_kernel(HalfspaceConstants c, std::vector<LaggingBody> bodies);

}  // namespace rollcon
