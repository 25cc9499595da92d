# Reads headers of others once instead of by every source, for builds that begin with nothing, such as CI's. It is off
# elsewhere, so that a missing include shows and caches of compilers work.

set(ROLLCON_PRECOMPILED <algorithm> <array> <atomic> <cmath> <complex> <cstdint> <cstring> <limits>
  <map> <memory> <mutex> <numbers> <numeric> <optional> <span> <string> <tuple> <utility> <vector>)

# Precompiles for a target: rollcon_precompile(<target> <headers besides>...)
function(rollcon_precompile target)
  set(headers "")
  foreach(header IN LISTS ROLLCON_PRECOMPILED ARGN)
    list(APPEND headers "$<$<COMPILE_LANGUAGE:CXX>:${header}>")
  endforeach()
  target_precompile_headers(${target} PRIVATE ${headers})
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endfunction()
