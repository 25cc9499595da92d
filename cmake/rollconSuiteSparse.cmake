# Parts of SuiteSparse as imported targets, found by hand: version 5 brings no CMake package. Used by
# rollcon's own build and, for a static rollcon, by its CMake package.

# rollcon_find_suitesparse(<cholmod|umfpack> [<folder to look in first>...]) defines the target
# rollcon::<name>, or nothing where library or header is missing.
function(rollcon_find_suitesparse name)
  if(TARGET rollcon::${name})
    return()
  endif()
  string(TOUPPER ${name} upper)
  find_library(ROLLCON_${upper}_LIBRARY ${name} HINTS ${ARGN}
    DOC "Library ${name} of SuiteSparse")
  find_path(ROLLCON_${upper}_INCLUDE ${name}.h PATH_SUFFIXES suitesparse
    DOC "Folder of ${name}.h of SuiteSparse")
  mark_as_advanced(ROLLCON_${upper}_LIBRARY ROLLCON_${upper}_INCLUDE)
  if(NOT ROLLCON_${upper}_LIBRARY)
    return()
  endif()
  add_library(rollcon::${name} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(rollcon::${name} PROPERTIES
    IMPORTED_LOCATION "${ROLLCON_${upper}_LIBRARY}")
  if(ROLLCON_${upper}_INCLUDE)
    set_target_properties(rollcon::${name} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${ROLLCON_${upper}_INCLUDE}")
  endif()
endfunction()
