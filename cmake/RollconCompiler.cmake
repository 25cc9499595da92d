# Says how rollcon's own code is compiled. Nothing here reaches a user of the library.

# Instruction sets are chosen at run time: there is no -march here. RollconKernels.cmake
# compiles what differs once for each of them.
add_library(rollcon_flags INTERFACE)
target_compile_features(rollcon_flags INTERFACE cxx_std_20)
target_compile_options(rollcon_flags INTERFACE
  $<$<COMPILE_LANGUAGE:C,CXX>:-Wall;-Wextra>
  $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor;-Woverloaded-virtual>)

# What the sources use of POSIX comes from here. GCC takes formats for those of Microsoft.
if(WIN32)
  target_include_directories(rollcon_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:${CMAKE_CURRENT_LIST_DIR}/windows>)
  target_compile_options(rollcon_flags INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include posix.hpp -Wno-format>")
endif()

# GCC 12 and 13 see overlapping copies in std::string's own code.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14)
  target_compile_options(rollcon_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict>)
endif()
if(ROLLCON_WERROR)
  target_compile_options(rollcon_flags INTERFACE $<$<COMPILE_LANGUAGE:C,CXX,Fortran>:-Werror>)
endif()

# Sanitizers cover everything of the build. With ROLLCON_SANITIZE_TESTS off they cover the library alone,
# and what was compiled of the tests without them in the same folder is only linked anew.
set(ROLLCON_SANITIZE_OPTIONS "")
if(ROLLCON_SANITIZE)
  list(JOIN ROLLCON_SANITIZE "," _sanitizers)
  set(_options -fsanitize=${_sanitizers} -fno-omit-frame-pointer)
  if("undefined" IN_LIST ROLLCON_SANITIZE)
    list(APPEND _options -fno-sanitize-recover=undefined)
  endif()
  if(ROLLCON_SANITIZE_TESTS)
    add_compile_options(${_options} -g)
  else()
    # The options are those of debugging, whatever the tests' build type is; GCC warns of what it has instrumented.
    # Checks of every pointer for null and alignment take half of the compiler's time; the address sanitizer sees the
    # first kind as well.
    set(ROLLCON_SANITIZE_OPTIONS ${_options} -fno-sanitize=null,alignment -g1 -O1 -UNDEBUG -Wno-error)
  endif()
  add_link_options(-fsanitize=${_sanitizers})
endif()
# Coverage counts the library's own code alone: tests then compile as they do without it. Counts that
# threads lose do not matter where any count will do; atomic ones make inner loops six times slower.
set(ROLLCON_COVERAGE_OPTIONS "")
if(ROLLCON_COVERAGE)
  set(ROLLCON_COVERAGE_OPTIONS --coverage -fprofile-update=single)
  add_link_options(--coverage)
endif()
# libFuzzer is told of the library's branches and comparisons.
set(ROLLCON_FUZZ_OPTIONS "")
if(ROLLCON_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR NOT ROLLCON_SANITIZE)
    message(FATAL_ERROR "ROLLCON_FUZZ needs Clang and ROLLCON_SANITIZE")
  endif()
  set(ROLLCON_FUZZ_OPTIONS -fsanitize=fuzzer-no-link)
endif()
