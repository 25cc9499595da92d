#pragma once
/// Files of saved bodies with changed contents and right checksums.

#include <cstdint>
#include <vector>

#include "input.hpp"

namespace fuzz {

using Bytes = std::vector<std::uint8_t>;

/// What rollcon_body_save writes for body 1 (rigid meshes: 2) of a scene after
/// a solve.
const Bytes& saved_body(int recipe);

/// Edits sections as the input says. Afterwards table of sections and checksums
/// are right again, unless the input wants them wrong.
Bytes forged(const Bytes& good, Input& in);

}  // namespace fuzz
