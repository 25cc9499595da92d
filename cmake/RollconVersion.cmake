# Version and ABI number stand in the public header, nowhere else. The ABI number is the SONAME; it
# changes only with a break.
set(_header "${CMAKE_CURRENT_SOURCE_DIR}/include/rollcon.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${_header}")
foreach(_name IN ITEMS VERSION_MAJOR VERSION_MINOR VERSION_PATCH ABI)
  file(STRINGS "${_header}" _line REGEX "^#define ROLLCON_${_name} +[0-9]+")
  if(NOT _line MATCHES "([0-9]+)[^0-9]*$")
    message(FATAL_ERROR "${_header} does not define ROLLCON_${_name}")
  endif()
  set(ROLLCON_${_name} ${CMAKE_MATCH_1})
endforeach()
set(ROLLCON_VERSION ${ROLLCON_VERSION_MAJOR}.${ROLLCON_VERSION_MINOR}.${ROLLCON_VERSION_PATCH})
