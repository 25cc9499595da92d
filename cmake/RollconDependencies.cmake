# Libraries that rollcon links: LAPACK, OpenMP, CHOLMOD and UMFPACK. ROLLCON_LICENCES collects what the
# build carries.

set(ROLLCON_LICENCES "BSD-3-Clause (rollcon)")

# A static rollcon is linked by targets of the parent project, which must see these targets too.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)

if(NOT BLA_VENDOR)
  set(BLA_VENDOR OpenBLAS)
  find_package(LAPACK QUIET)
  if(NOT LAPACK_FOUND)
    unset(BLA_VENDOR)
  endif()
endif()
find_package(LAPACK REQUIRED)
if(LAPACK_LIBRARIES MATCHES "openblas")
  set(ROLLCON_LAPACK_NAME "OpenBLAS")
  list(APPEND ROLLCON_LICENCES "BSD-3-Clause (OpenBLAS)")
else()
  set(ROLLCON_LAPACK_NAME "LAPACK")
  list(APPEND ROLLCON_LICENCES "that of the LAPACK found: ${LAPACK_LIBRARIES}")
endif()

if(ROLLCON_OPENMP)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
  list(APPEND ROLLCON_LICENCES "that of the compiler's OpenMP runtime")
endif()
find_package(Threads REQUIRED)

# Headers alone, inside the library alone: the search tree of surfaces is Boost.Geometry's.
find_package(Boost 1.74 REQUIRED)
list(APPEND ROLLCON_LICENCES "BSL-1.0 (Boost headers)")

# Sparse factorisations for finite-element bodies: taken where found, unless an option says which.
include(rollconSuiteSparse)
set(ROLLCON_SPARSE "")
foreach(_name IN ITEMS cholmod umfpack)
  string(TOUPPER ${_name} _option)
  if(NOT DEFINED ROLLCON_${_option} OR ROLLCON_${_option})
    rollcon_find_suitesparse(${_name})
    set(_found ON)
    if(NOT TARGET rollcon::${_name} OR NOT ROLLCON_${_option}_INCLUDE)
      set(_found OFF)
      if(ROLLCON_${_option})
        message(FATAL_ERROR "ROLLCON_${_option} is ON, but ${_name} of SuiteSparse was not found "
          "(library: ${ROLLCON_${_option}_LIBRARY}, header: ${ROLLCON_${_option}_INCLUDE}). Install "
          "it (Debian: libsuitesparse-dev), name ROLLCON_${_option}_LIBRARY and "
          "ROLLCON_${_option}_INCLUDE, or set ROLLCON_${_option}=OFF")
      endif()
      message(STATUS "${_option} of SuiteSparse was not found: built without it "
        "(Debian: libsuitesparse-dev)")
    endif()
  endif()
  option(ROLLCON_${_option} "Link ${_option} (GPL-2.0-or-later)" ${_found})
  if(ROLLCON_${_option})
    list(APPEND ROLLCON_SPARSE ${_name})
    list(APPEND ROLLCON_LICENCES "GPL-2.0-or-later (${_option})")
  endif()
endforeach()

# Libraries a program needs beside a static rollcon, by name: a C or Fortran linker adds no C++
# runtime, and no OpenMP runtime, by itself.
set(ROLLCON_RUNTIME ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_ITEM ROLLCON_RUNTIME gcc gcc_s c ${CMAKE_C_IMPLICIT_LINK_LIBRARIES})
list(APPEND ROLLCON_RUNTIME m ${CMAKE_THREAD_LIBS_INIT})
if(ROLLCON_OPENMP)
  list(PREPEND ROLLCON_RUNTIME ${OpenMP_CXX_LIB_NAMES})
endif()
list(REMOVE_DUPLICATES ROLLCON_RUNTIME)
