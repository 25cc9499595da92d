# Installs libraries, header, Fortran source, CMake package, pkg-config file. Shared and static have an export set each,
# so that separate builds may be installed side by side.

include(CMakePackageConfigHelpers)
include(RollconTexts)
include(rollconFortranTarget)

set(_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/rollcon")
set(_fortran_dir "${CMAKE_INSTALL_DATADIR}/rollcon/fortran")

foreach(_kind IN ITEMS shared static)
  string(TOUPPER ${_kind} _option)
  if(ROLLCON_${_option})
    install(TARGETS rollcon_${_kind} EXPORT rollcon_${_kind}
      RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT library
      LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT development
      ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
    install(EXPORT rollcon_${_kind} NAMESPACE rollcon:: FILE rollcon-${_kind}-targets.cmake
      DESTINATION "${_package_dir}" COMPONENT development)
  endif()
endforeach()

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  COMPONENT development FILES_MATCHING PATTERN "*.h")
list(TRANSFORM ROLLCON_FORTRAN_SOURCES PREPEND "${PROJECT_SOURCE_DIR}/fortran/"
  OUTPUT_VARIABLE _fortran_sources)
install(FILES ${_fortran_sources} "${PROJECT_SOURCE_DIR}/fortran/rollcon.inc" DESTINATION "${_fortran_dir}" COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT license)
if(ROLLCON_PYTHON AND ROLLCON_SHARED)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/bindings/python/rollcon" DESTINATION lib/python3/dist-packages
    COMPONENT python FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
endif()
if(ROLLCON_SHARED)
  rollcon_install_octave()
endif()
if(ROLLCON_DOCS)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DOCDIR}/docs" COMPONENT documents
    PATTERN api.md EXCLUDE PATTERN "reference_*.md" EXCLUDE)
  rollcon_install_references()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT documents
    PATTERN CMakeLists.txt EXCLUDE PATTERN __pycache__ EXCLUDE)
  # The pages go to their places, so that links between them lead there.
  foreach(_page IN ITEMS README.md CHANGELOG.md CONTRIBUTING.md RELEASING.md SECURITY.md SUPPORT.md AUTHORS.md CITATION.cff
      fortran/README.md bindings/python/README.md bindings/api_contract.md)
    get_filename_component(_folder "${_page}" DIRECTORY)
    install(FILES "${PROJECT_SOURCE_DIR}/${_page}" DESTINATION "${CMAKE_INSTALL_DOCDIR}/${_folder}" COMPONENT documents)
  endforeach()
endif()
install(FILES "${PROJECT_SOURCE_DIR}/src/tables/steel.rct" DESTINATION "${CMAKE_INSTALL_DATADIR}/rollcon"
  COMPONENT library)

# The package of a static rollcon looks for libraries of components where this build found them, then
# anywhere.
set(_external_libraries "")
foreach(_name IN LISTS ROLLCON_EXTERNALS)
  string(TOUPPER ${_name} _option)
  list(PREPEND _external_libraries "${ROLLCON_${_option}_LIBRARY}")
endforeach()
if(ROLLCON_BUILD_FFTW)
  list(APPEND _external_libraries "${ROLLCON_FFTW_FLOAT_LIBRARY}")
endif()
set(_external_folders "")
foreach(_library IN LISTS _external_libraries)
  get_filename_component(_folder "${_library}" DIRECTORY)
  list(APPEND _external_folders "${_folder}")
endforeach()
list(REMOVE_DUPLICATES _external_folders)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/rollconConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/rollconConfig.cmake"
  INSTALL_DESTINATION "${_package_dir}" PATH_VARS _fortran_dir)
# A minor version only adds to the interface.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/rollconConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/rollconConfig.cmake"
  "${PROJECT_BINARY_DIR}/rollconConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/rollconFortranTarget.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/rollconExternal.cmake"
  DESTINATION "${_package_dir}" COMPONENT development)

# The pkg-config file lists libraries by name, and their folder only where the linker would not look by itself. Archives
# of SuiteSparse and of a LAPACK need archives of their own, where shared libraries bring along what they need.
set(_behind_external "")
set(_behind_lapack "")
if(ROLLCON_BUILD_CHOLMOD OR ROLLCON_BUILD_UMFPACK)
  foreach(_name IN ITEMS amd camd colamd ccolamd metis suitesparseconfig)
    find_library(ROLLCON_${_name}_ARCHIVE lib${_name}.a)
    mark_as_advanced(ROLLCON_${_name}_ARCHIVE)
    if(ROLLCON_${_name}_ARCHIVE)
      list(APPEND _behind_external "${ROLLCON_${_name}_ARCHIVE}")
    endif()
  endforeach()
endif()
foreach(_name IN ITEMS gfortran quadmath)
  execute_process(COMMAND ${CMAKE_C_COMPILER} -print-file-name=lib${_name}.a OUTPUT_VARIABLE _file
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(IS_ABSOLUTE "${_file}")
    list(APPEND _behind_lapack "-l${_name}")
  endif()
endforeach()
set(_private "")
foreach(_library IN LISTS _external_libraries _behind_external LAPACK_LIBRARIES _behind_lapack ROLLCON_RUNTIME)
  if(IS_ABSOLUTE "${_library}")
    get_filename_component(_folder "${_library}" DIRECTORY)
    get_filename_component(_name "${_library}" NAME_WE)
    if(NOT _folder IN_LIST CMAKE_C_IMPLICIT_LINK_DIRECTORIES)
      list(APPEND _private "-L${_folder}")
    endif()
    string(REGEX REPLACE "^lib" "-l" _name "${_name}")
    list(APPEND _private "${_name}")
  elseif(_library MATCHES "^-")
    list(APPEND _private "${_library}")
  else()
    list(APPEND _private "-l${_library}")
  endif()
endforeach()
list(REMOVE_DUPLICATES _private)
list(JOIN _private " " ROLLCON_PC_PRIVATE)
set(ROLLCON_PC_LIBS "-lrollcon")
if(NOT ROLLCON_SHARED)
  string(APPEND ROLLCON_PC_LIBS " ${ROLLCON_PC_PRIVATE}")
endif()
list(JOIN ROLLCON_FORTRAN_SOURCES " " ROLLCON_PC_FORTRAN)
list(TRANSFORM ROLLCON_FORTRAN_SOURCES PREPEND "\${fortrandir}/" OUTPUT_VARIABLE _fortran_paths)
list(JOIN _fortran_paths " " ROLLCON_PC_FORTRAN_PATHS)
file(RELATIVE_PATH ROLLCON_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" ROLLCON_PC_PREFIX "${ROLLCON_PC_PREFIX}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/rollcon.pc.in" "${PROJECT_BINARY_DIR}/rollcon.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/rollcon.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
  COMPONENT development)

# Settings for the shell of a user whose prefix is none of the system's.
file(RELATIVE_PATH ROLLCON_SETTINGS_PREFIX "/${CMAKE_INSTALL_DATADIR}/rollcon" "/")
string(REGEX REPLACE "/$" "" ROLLCON_SETTINGS_PREFIX "${ROLLCON_SETTINGS_PREFIX}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/environment.sh.in" "${PROJECT_BINARY_DIR}/environment.sh" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/environment.sh" DESTINATION "${CMAKE_INSTALL_DATADIR}/rollcon"
  COMPONENT development)
