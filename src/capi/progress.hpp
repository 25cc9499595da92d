#pragma once
/// Progress callbacks of the host.

#include <cstdint>

#include "contact/scene/enumerators.hpp"

namespace rollcon::capi {

/// Calls that of the Object that `user` points to.
std::int32_t call_progress(const Event& event, void* user);

}  // namespace rollcon::capi
