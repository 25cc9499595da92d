# Adds the Fortran interface in rollcon's own build.
enable_language(Fortran)
include(rollconFortranTarget)

file(GLOB _present CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/fortran"
  "${PROJECT_SOURCE_DIR}/fortran/*.f90")
list(REMOVE_ITEM _present ${ROLLCON_FORTRAN_SOURCES})
if(_present)
  message(FATAL_ERROR "fortran/: not listed in cmake/rollconFortranTarget.cmake: ${_present}")
endif()

rollcon_add_fortran("${PROJECT_SOURCE_DIR}/fortran")
set_target_properties(rollcon_fortran PROPERTIES EXCLUDE_FROM_ALL OFF)
target_compile_options(rollcon_fortran PRIVATE
  $<$<Fortran_COMPILER_ID:GNU>:-Wall;-Wextra;-std=f2008;-fimplicit-none>)
target_link_libraries(rollcon_fortran PRIVATE $<BUILD_INTERFACE:rollcon_flags>)
