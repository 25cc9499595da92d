#pragma once
/// Makes files of saved bodies with changed contents and right checksums.

#include <cstdint>
#include <vector>

#include "input.hpp"

namespace fuzz {

using Bytes = std::vector<std::uint8_t>;

/// Returns what rollcon_body_save writes for body 1 (rigid meshes: 2) of a scene after a solve.
const Bytes& saved_body(int recipe);

/// Edits sections the way the input says. Afterwards the table of sections and the checksums are right again, unless
/// the input wants them wrong.
Bytes forged(const Bytes& good, Input& in);

}  // namespace fuzz
