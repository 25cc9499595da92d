# Compiles inner loops once for each instruction set, chosen at run time (src/support/instruction_set.hpp):
# src/**/X_each_set.hpp defines ROLLCON_COMPILED(name), which this build folder's sources X_baseline.cpp, X_avx2.cpp and
# X_avx512.cpp make name_baseline and so on.

# Takes the *_each_set.hpp out of the first list and puts the sources made of them into the second one:
# rollcon_kernels(<list of sources> <list of kernels>)
function(rollcon_kernels sources kernels)
  set(headers ${${sources}})
  list(FILTER headers INCLUDE REGEX "_each_set\\.hpp$")
  list(FILTER ${sources} EXCLUDE REGEX "_each_set\\.hpp$")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(flags_avx2 -mavx2 -mfma)
    set(flags_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mfma -mprefer-vector-width=512)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # GCC's own AVX-512 header, when inlined, draws this warning.
      list(APPEND flags_avx512 -Wno-maybe-uninitialized -Wno-uninitialized)
    endif()
  endif()
  set(made "")
  foreach(header IN LISTS headers)
    file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}/src" "${header}")
    foreach(set IN ITEMS baseline avx2 avx512)
      string(REPLACE "_each_set.hpp" "_${set}.cpp" source "${PROJECT_BINARY_DIR}/generated/src/${name}")
      file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT
        "#define ROLLCON_SET_NAME \"@set@\"\n#define ROLLCON_COMPILED(name) name##_@set@\n#include \"@name@\"\n")
      set_source_files_properties("${source}" PROPERTIES
        COMPILE_OPTIONS "${flags_${set}}" SKIP_PRECOMPILE_HEADERS ON)
      list(APPEND made "${source}")
    endforeach()
  endforeach()
  set(${sources} ${${sources}} PARENT_SCOPE)
  set(${kernels} ${made} PARENT_SCOPE)
endfunction()
