#pragma once
/// Sums compliances on one frame: the two bodies of a pair.

#include <memory>
#include <vector>

#include "bodies/model/compliance.hpp"

namespace rollcon {

/// Requires at least one part.
std::unique_ptr<Compliance> make_sum(std::vector<std::unique_ptr<Compliance>> parts);

}  // namespace rollcon
