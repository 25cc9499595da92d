# Finds the libraries that rollcon links: LAPACK, OpenMP and those of components. ROLLCON_LICENCES collects what the
# build carries.

set(ROLLCON_LICENCES "BSD-3-Clause (rollcon)")

# A static rollcon is linked by targets of the parent project, which must see these targets too.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)

include(RollconComponents)

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

if(ROLLCON_BUILD_OPENMP)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
  list(APPEND ROLLCON_LICENCES "that of the compiler's OpenMP runtime")
endif()
find_package(Threads REQUIRED)

# These are the libraries that a program needs beside a static rollcon, by name: a C or Fortran linker adds no C++
# runtime, and no OpenMP runtime, by itself.
set(ROLLCON_RUNTIME ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_ITEM ROLLCON_RUNTIME gcc gcc_s c ${CMAKE_C_IMPLICIT_LINK_LIBRARIES})
list(APPEND ROLLCON_RUNTIME m ${CMAKE_THREAD_LIBS_INIT})
if(ROLLCON_BUILD_OPENMP)
  list(PREPEND ROLLCON_RUNTIME ${OpenMP_CXX_LIB_NAMES})
endif()
list(REMOVE_DUPLICATES ROLLCON_RUNTIME)
