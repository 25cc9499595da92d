# Defines rollcon::fortran, compiled here and now: name mangling, integer widths and module files are those of this
# build's compiler and flags. It is used by rollcon's own build and by its CMake package.

# A module comes after those it uses, for users who compile by hand.
set(ROLLCON_FORTRAN_SOURCES rollcon_c.f90 rollcon_support.f90 rollcon_tables.f90
  rollcon_context.f90 rollcon_body_plain.f90 rollcon_body.f90 rollcon_contact_plain.f90 rollcon_contact.f90
  rollcon_table_plain.f90 rollcon_table.f90 rollcon_wheelrail_plain.f90 rollcon_wheelrail.f90
  rollcon.f90 rollcon_f77_names.f90 rollcon_f77_support.f90 rollcon_f77.f90)

function(rollcon_add_fortran directory)
  if(TARGET rollcon::fortran)
    return()
  endif()
  list(TRANSFORM ROLLCON_FORTRAN_SOURCES PREPEND "${directory}/" OUTPUT_VARIABLE sources)
  set(modules "${CMAKE_CURRENT_BINARY_DIR}/rollcon_modules")
  add_library(rollcon_fortran STATIC EXCLUDE_FROM_ALL ${sources})
  add_library(rollcon::fortran ALIAS rollcon_fortran)
  set_target_properties(rollcon_fortran PROPERTIES
    POSITION_INDEPENDENT_CODE ON Fortran_MODULE_DIRECTORY "${modules}")
  target_include_directories(rollcon_fortran PUBLIC "${modules}" "${directory}")
  target_link_libraries(rollcon_fortran PUBLIC rollcon::rollcon)
endfunction()
