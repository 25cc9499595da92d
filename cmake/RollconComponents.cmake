# Defines components: parts that a build may go without, one option ROLLCON_WITH_<NAME> each. What is built stands in
# ROLLCON_BUILD_<NAME>. An absent component is not compiled, and nothing of its own is looked for or linked;
# src/**/<component>_absent.cpp then says so to its callers.

# Some options had no WITH up to 0.1. An entry that an old build folder still holds is dropped.
foreach(_name IN ITEMS CHOLMOD UMFPACK OPENMP)
  if(DEFINED CACHE{ROLLCON_${_name}})
    get_property(_help CACHE ROLLCON_${_name} PROPERTY HELPSTRING)
    if(NOT _help MATCHES "command line")
      unset(ROLLCON_${_name} CACHE)
    endif()
  endif()
  if(DEFINED ROLLCON_${_name})
    set(_value "${ROLLCON_${_name}}")
    unset(ROLLCON_${_name} CACHE)
    message(FATAL_ERROR "ROLLCON_${_name} is now called ROLLCON_WITH_${_name}: give "
      "-DROLLCON_WITH_${_name}=${_value}")
  endif()
endforeach()

# Components of rollcon's own sources are on.
option(ROLLCON_WITH_BEM "Boundary-element bodies" ON)
option(ROLLCON_WITH_PROCEDURES "The published solution procedures" ON)
option(ROLLCON_WITH_VTU "rollcon_contact_write: VTU files" ON)
option(ROLLCON_WITH_OPENMP "Loops on several threads (OpenMP)" ON)
option(ROLLCON_WITH_CNTC "librollcon_cntc: the library interface of CONTACT" ${ROLLCON_TESTS})
foreach(_name IN ITEMS BEM PROCEDURES VTU OPENMP CNTC)
  set(ROLLCON_BUILD_${_name} ${ROLLCON_WITH_${_name}})
endforeach()

# Components that need a library from outside are taken where it is found (AUTO) and required where ON.
# rollcon_wish(<NAME> <doc>) makes the option and sets _wish_<NAME> to AUTO, ON or OFF.
macro(rollcon_wish _name _doc)
  set(ROLLCON_WITH_${_name} AUTO CACHE STRING "${_doc}: ON, OFF, or AUTO, where found")
  set_property(CACHE ROLLCON_WITH_${_name} PROPERTY STRINGS AUTO ON OFF)
  string(TOUPPER "${ROLLCON_WITH_${_name}}" _wish_${_name})
  if(NOT _wish_${_name} STREQUAL "AUTO")
    set(_wish_${_name} OFF)
    if(ROLLCON_WITH_${_name})
      set(_wish_${_name} ON)
    endif()
  endif()
endmacro()
rollcon_wish(FEM "Finite-element bodies; need CHOLMOD")
rollcon_wish(CHOLMOD "CHOLMOD (GPL-2.0-or-later), for finite-element bodies")
rollcon_wish(UMFPACK "UMFPACK (GPL-2.0-or-later), for the published procedures")
rollcon_wish(FFTW "FFTW (GPL-2.0-or-later), for regular frames on half-spaces")

# Sets ROLLCON_BUILD_<NAME>, and lists what is linked in ROLLCON_EXTERNALS: rollcon_external_component(<NAME> <Debian
# package>)
set(ROLLCON_EXTERNALS "")
include(rollconExternal)
macro(rollcon_external_component _name _package)
  string(TOLOWER ${_name} _lower)
  set(ROLLCON_BUILD_${_name} OFF)
  if(NOT _wish_${_name} STREQUAL "OFF")
    rollcon_find_external(${_lower})
    if(TARGET rollcon::${_lower} AND ROLLCON_${_name}_INCLUDE)
      set(ROLLCON_BUILD_${_name} ON)
      list(APPEND ROLLCON_EXTERNALS ${_lower})
    elseif(_wish_${_name} STREQUAL "AUTO")
      message(STATUS "${_name} was not found: built without it (Debian: ${_package})")
    else()
      message(FATAL_ERROR "ROLLCON_WITH_${_name} is ON, but ${_name} was not found "
        "(library: ${ROLLCON_${_name}_LIBRARY}, header: ${ROLLCON_${_name}_INCLUDE}). Install it "
        "(Debian: ${_package}), name ROLLCON_${_name}_LIBRARY and ROLLCON_${_name}_INCLUDE, or set "
        "ROLLCON_WITH_${_name}=OFF")
    endif()
  endif()
endmacro()

# A factorisation that nothing would use is not looked for.
macro(rollcon_unused _name)
  if(_wish_${_name} STREQUAL "ON")
    message(STATUS "ROLLCON_WITH_${_name} is ON, but nothing in this build would use it: left out")
  endif()
  set(_wish_${_name} OFF)
endmacro()
if(_wish_FEM STREQUAL "OFF")
  rollcon_unused(CHOLMOD)
endif()
if(NOT ROLLCON_BUILD_PROCEDURES)
  rollcon_unused(UMFPACK)
endif()
rollcon_external_component(CHOLMOD libsuitesparse-dev)
rollcon_external_component(UMFPACK libsuitesparse-dev)
rollcon_external_component(FFTW libfftw3-dev)

set(ROLLCON_BUILD_FEM OFF)
if(NOT _wish_FEM STREQUAL "OFF")
  if(ROLLCON_BUILD_CHOLMOD)
    set(ROLLCON_BUILD_FEM ON)
  elseif(_wish_FEM STREQUAL "ON")
    message(FATAL_ERROR "ROLLCON_WITH_FEM is ON, but finite-element bodies need CHOLMOD "
      "(ROLLCON_WITH_CHOLMOD is ${ROLLCON_WITH_CHOLMOD}; Debian: libsuitesparse-dev)")
  endif()
endif()
foreach(_name IN ITEMS CHOLMOD UMFPACK FFTW)
  if(ROLLCON_BUILD_${_name})
    list(APPEND ROLLCON_LICENCES "GPL-2.0-or-later (${_name})")
  endif()
endforeach()
