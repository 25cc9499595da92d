# Finds SUNDIALS's integrator CVODE, for an example and a benchmark: ROLLCON_SUNDIALS are its libraries, or nothing.

find_path(ROLLCON_SUNDIALS_INCLUDE cvode/cvode.h)
set(ROLLCON_SUNDIALS "")
foreach(_part IN ITEMS cvode nvecserial sunmatrixdense sunlinsoldense)
  find_library(ROLLCON_SUNDIALS_${_part} sundials_${_part})
  mark_as_advanced(ROLLCON_SUNDIALS_${_part})
  list(APPEND ROLLCON_SUNDIALS ${ROLLCON_SUNDIALS_${_part}})
endforeach()
mark_as_advanced(ROLLCON_SUNDIALS_INCLUDE)
if(NOT ROLLCON_SUNDIALS_INCLUDE OR "${ROLLCON_SUNDIALS}" MATCHES "NOTFOUND")
  set(ROLLCON_SUNDIALS "")
endif()
