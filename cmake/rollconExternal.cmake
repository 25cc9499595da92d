# Finds libraries by hand, as imported targets, because SuiteSparse 5 and Debian's FFTW bring no CMake package. It is
# used by rollcon's own build and, for a static rollcon, by its CMake package.

# Defines the target rollcon::<name>, or nothing where a library or the header is missing. The header is needed to build
# rollcon only: rollcon_find_external(<cholmod|mumps|umfpack|fftw|mpi> [<folder to look in first>...])
function(rollcon_find_external name)
  if(TARGET rollcon::${name})
    return()
  endif()
  string(TOUPPER ${name} upper)
  set(header ${name}.h)
  set(libraries ${name})
  if(name STREQUAL "mumps")
    set(header dmumps_c.h)
    set(libraries dmumps_seq)  # without MPI
  elseif(name STREQUAL "fftw")
    set(header fftw3.h)
    set(libraries fftw3 fftw3f)  # doubles, floats
  endif()
  set(found "")
  foreach(library IN LISTS libraries)
    set(variable ROLLCON_${upper}_LIBRARY)
    if(library STREQUAL "fftw3f")
      set(variable ROLLCON_FFTW_FLOAT_LIBRARY)
    endif()
    find_library(${variable} ${library} HINTS ${ARGN} DOC "Library ${library}")
    mark_as_advanced(${variable})
    if(NOT ${variable})
      return()
    endif()
    list(APPEND found "${${variable}}")
  endforeach()
  find_path(ROLLCON_${upper}_INCLUDE ${header} PATH_SUFFIXES suitesparse mpi DOC "Folder of ${header}")
  mark_as_advanced(ROLLCON_${upper}_INCLUDE)
  list(POP_FRONT found first)
  add_library(rollcon::${name} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(rollcon::${name} PROPERTIES
    IMPORTED_LOCATION "${first}" INTERFACE_LINK_LIBRARIES "${found}")
  if(ROLLCON_${upper}_INCLUDE)
    set_target_properties(rollcon::${name} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${ROLLCON_${upper}_INCLUDE}")
  endif()
endfunction()
