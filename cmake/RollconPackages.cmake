# Makes Debian packages by CPack, one for each component of the installation: scripts/package.sh calls it, and checks
# them.
find_program(ROLLCON_GZIP gzip)
mark_as_advanced(ROLLCON_GZIP)
if(NOT ROLLCON_GZIP OR NOT PROJECT_IS_TOP_LEVEL OR NOT ROLLCON_SHARED OR NOT ROLLCON_STATIC OR NOT ROLLCON_PYTHON OR NOT ROLLCON_DOCS)
  return()
endif()

# The maintainer is whoever makes a package, by the variables that Debian's own tools take. Without them the address
# says that there is none: no mail reaches the domain "invalid".
set(_maintainer "The rollcon authors <nobody@rollcon.invalid>")
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(_maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(ROLLCON_MAINTAINER "${_maintainer}" CACHE STRING "Maintainer of Debian packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rollcon)
set(CPACK_PACKAGE_VENDOR "The rollcon authors")
set(CPACK_PACKAGE_VERSION ${ROLLCON_VERSION_DEBIAN})
set(CPACK_PACKAGE_CONTACT "${ROLLCON_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "frictional rolling contact of elastic bodies")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL library development python documents)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# CPack indents the lines, and makes a dot of an empty one.
set(_what "rollcon finds pressures, tractions, stick and slip of two elastic bodies in\n\
steady rolling: wheel and rail, roller and raceway. Bodies are half-spaces,\n\
rigid, or of finite or boundary elements.\n\n")
set(_shared librollcon${ROLLCON_ABI})

# Adds a package: rollcon_package(<component> <name> <section> <summary> <last paragraph>)
macro(rollcon_package component name section summary text)
  string(TOUPPER ${component} _upper)
  set(CPACK_DEBIAN_${_upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${_upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${_upper}_DESCRIPTION "${summary}\n${_what}${text}")
  # Every package of Debian has these files in its folder of documents.
  set(_folder "${PROJECT_BINARY_DIR}/packages/${name}")
  configure_file("${PROJECT_SOURCE_DIR}/packaging/debian/copyright" "${_folder}/copyright" COPYONLY)
  set(ROLLCON_PACKAGE ${name})
  configure_file("${PROJECT_SOURCE_DIR}/packaging/debian/changelog.in" "${_folder}/changelog.Debian" @ONLY)
  execute_process(COMMAND "${ROLLCON_GZIP}" -9nf "${_folder}/changelog.Debian")
  install(FILES "${_folder}/copyright" "${_folder}/changelog.Debian.gz" DESTINATION share/doc/${name}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

rollcon_package(library ${_shared} libs "frictional rolling contact - shared library"
  "This package holds the shared library and its creep-force table for steel.")
rollcon_package(development librollcon-dev libdevel "frictional rolling contact - development files"
  "This package holds the header, the static library, Fortran sources, and files\nfor CMake and pkg-config.")
rollcon_package(python python3-rollcon python "frictional rolling contact - Python 3 package"
  "This package holds the module rollcon for Python 3.")
rollcon_package(documents rollcon-doc doc "frictional rolling contact - documents and examples"
  "This package holds documents as plain files and example programs.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
file(WRITE "${PROJECT_BINARY_DIR}/packages/shlibs" "librollcon ${ROLLCON_ABI} ${_shared} (>= ${ROLLCON_VERSION_DEBIAN})\n")
file(WRITE "${PROJECT_BINARY_DIR}/packages/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA
  "${PROJECT_BINARY_DIR}/packages/shlibs" "${PROJECT_BINARY_DIR}/packages/triggers")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${_shared} (= ${ROLLCON_VERSION_DEBIAN}-1)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
  "rollcon-doc, libopenblas-dev, libsuitesparse-dev, libfftw3-dev, gfortran")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${_shared} (>= ${ROLLCON_VERSION_DEBIAN}), python3:any, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-matplotlib)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${PROJECT_SOURCE_DIR}/packaging/debian/postinst" "${PROJECT_SOURCE_DIR}/packaging/debian/prerm")
include(CPack)
