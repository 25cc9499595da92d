# Builds the library: one set of objects, from which the shared and the static library are made. The static one also
# serves the unit tests, which reach inside.

# Rooms come in the order of docs: each may use only those before it.
set(ROLLCON_ROOMS support linalg mesh io quadrature geometry bodies contact procedures framing tables wheelrail capi)

add_library(rollcon_objects OBJECT)
set(ROLLCON_SOURCES "")
foreach(_room IN LISTS ROLLCON_ROOMS)
  file(GLOB_RECURSE _found CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/src/${_room}/*.cpp" "${PROJECT_SOURCE_DIR}/src/${_room}/*_each_set.hpp")
  list(APPEND ROLLCON_SOURCES ${_found})
endforeach()
include(RollconSources)
list(JOIN ROLLCON_LICENCES ", " ROLLCON_LICENCES_TEXT)
configure_file("${PROJECT_SOURCE_DIR}/cmake/build_info.hpp.in"
  "${PROJECT_BINARY_DIR}/generated/build_info.hpp")
set_target_properties(rollcon_objects PROPERTIES
  POSITION_INDEPENDENT_CODE ON
  CXX_EXTENSIONS OFF
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON)
target_include_directories(rollcon_objects PRIVATE
  "${PROJECT_SOURCE_DIR}/src" "${PROJECT_SOURCE_DIR}/include" "${PROJECT_BINARY_DIR}/generated")
target_link_libraries(rollcon_objects PRIVATE rollcon_flags)
target_compile_definitions(rollcon_objects PRIVATE ROLLCON_BUILDING)
target_compile_options(rollcon_objects PRIVATE
  ${ROLLCON_SANITIZE_OPTIONS} ${ROLLCON_COVERAGE_OPTIONS} ${ROLLCON_FUZZ_OPTIONS})
if(ROLLCON_BUILD_OPENMP)
  target_link_libraries(rollcon_objects PRIVATE OpenMP::OpenMP_CXX)
else()
  # OpenMP's pragmas then mean nothing, and neither do counts of threads.
  target_compile_options(rollcon_objects PRIVATE -Wno-unknown-pragmas -Wno-unused-parameter)
endif()
if(ROLLCON_PRECOMPILE STREQUAL "ALL")
  rollcon_precompile(rollcon_objects)
endif()
list(TRANSFORM ROLLCON_EXTERNALS PREPEND rollcon:: OUTPUT_VARIABLE _externals)

# The C boundary carries debug information in a developer's build: the ABI dump is made from it.
if(ROLLCON_TESTS AND NOT ROLLCON_SANITIZE)
  set(_capi ${ROLLCON_SOURCES})
  list(FILTER _capi INCLUDE REGEX "/src/capi/")
  list(REMOVE_ITEM ROLLCON_SOURCES ${_capi})
  if(ROLLCON_UNITY STREQUAL "ALL")
    rollcon_unity(_capi 1)
  endif()
  set_property(SOURCE ${_capi} APPEND PROPERTY COMPILE_OPTIONS -g)
  set_property(SOURCE ${_capi} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  target_sources(rollcon_objects PRIVATE ${_capi})
endif()

rollcon_kernels(ROLLCON_SOURCES ROLLCON_KERNELS)
if(ROLLCON_UNITY STREQUAL "ALL")
  rollcon_unity(ROLLCON_SOURCES 8)
endif()
target_sources(rollcon_objects PRIVATE ${ROLLCON_SOURCES} ${ROLLCON_KERNELS})

function(rollcon_common_properties target)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME rollcon LINKER_LANGUAGE CXX)
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
endfunction()

if(ROLLCON_SHARED)
  add_library(rollcon_shared SHARED $<TARGET_OBJECTS:rollcon_objects>)
  add_library(rollcon::shared ALIAS rollcon_shared)
  rollcon_common_properties(rollcon_shared)
  set_target_properties(rollcon_shared PROPERTIES
    EXPORT_NAME shared VERSION ${PROJECT_VERSION} SOVERSION ${ROLLCON_ABI})
  target_link_libraries(rollcon_shared PRIVATE ${_externals} LAPACK::LAPACK Threads::Threads)
  if(ROLLCON_BUILD_OPENMP)
    target_link_libraries(rollcon_shared PRIVATE OpenMP::OpenMP_CXX)
  endif()
  # Hidden visibility still exports instantiations of the C++ library; the script leaves the API.
  set(_map "${PROJECT_SOURCE_DIR}/cmake/rollcon.map")
  if(EXISTS "${_map}" AND NOT WIN32)
    target_link_options(rollcon_shared PRIVATE "LINKER:--version-script=${_map}")
    set_property(TARGET rollcon_shared APPEND PROPERTY LINK_DEPENDS "${_map}")
  endif()
  if(NOT WIN32)
    target_link_options(rollcon_shared PRIVATE "LINKER:-z,noexecstack")
  endif()
  if(NOT ROLLCON_SANITIZE AND NOT WIN32)
    target_link_options(rollcon_shared PRIVATE "LINKER:-z,defs")
  endif()
endif()

if(ROLLCON_STATIC OR ROLLCON_TESTS)
  add_library(rollcon_static STATIC $<TARGET_OBJECTS:rollcon_objects>)
  add_library(rollcon::static ALIAS rollcon_static)
  rollcon_common_properties(rollcon_static)
  set_target_properties(rollcon_static PROPERTIES EXPORT_NAME static)
  target_link_libraries(rollcon_static PRIVATE ${_externals} LAPACK::LAPACK)
  if(ROLLCON_BUILD_OPENMP)
    target_link_libraries(rollcon_static INTERFACE "$<BUILD_INTERFACE:${OpenMP_CXX_LIBRARIES}>")
  endif()
  # The libraries go by name, because neither FindThreads nor FindOpenMP serves a project in Fortran alone.
  target_link_libraries(rollcon_static INTERFACE "$<INSTALL_INTERFACE:${ROLLCON_RUNTIME}>"
    "$<BUILD_INTERFACE:${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES};${CMAKE_THREAD_LIBS_INIT}>")
endif()

# The target rollcon::rollcon is the shared library where there is one.
if(ROLLCON_SHARED)
  add_library(rollcon ALIAS rollcon_shared)
  add_library(rollcon::rollcon ALIAS rollcon_shared)
else()
  add_library(rollcon ALIAS rollcon_static)
  add_library(rollcon::rollcon ALIAS rollcon_static)
endif()

# Unit tests and benchmarks see the inside by this target.
if(TARGET rollcon_static)
  add_library(rollcon_inside INTERFACE)
  target_include_directories(rollcon_inside INTERFACE "${PROJECT_SOURCE_DIR}/src"
    "${PROJECT_BINARY_DIR}/generated")
  target_compile_features(rollcon_inside INTERFACE cxx_std_20)
  target_link_libraries(rollcon_inside INTERFACE rollcon_static rollcon_flags LAPACK::LAPACK)
  if(ROLLCON_BUILD_OPENMP)
    target_link_libraries(rollcon_inside INTERFACE OpenMP::OpenMP_CXX)
  endif()
endif()
