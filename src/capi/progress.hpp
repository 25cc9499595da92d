#pragma once
/// Passes progress events on to the host's callbacks.

#include <cstdint>

#include "contact/scene/enumerators.hpp"

namespace rollcon::capi {

/// Calls the progress callback of the Object that `user` points to.
std::int32_t call_progress(const Event& event, void* user);

}  // namespace rollcon::capi
