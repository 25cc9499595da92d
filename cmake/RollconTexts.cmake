# Installs what git does not hold: the references of the documents, and the package for MATLAB and Octave. The
# installation writes them with Python 3.11 from bindings/api.toml; without it, they are taken from the sources, which
# are a tarball's.

# Sets rollcon_texts to the folder that will have them, or to nothing: rollcon_write_texts(<component>)
function(rollcon_write_texts component)
  set(texts "${PROJECT_BINARY_DIR}/texts")
  find_package(Python3 3.11 QUIET COMPONENTS Interpreter)
  if(Python3_FOUND)
    install(CODE "execute_process(COMMAND \"${Python3_EXECUTABLE}\" \"${PROJECT_SOURCE_DIR}/bindings/generate.py\"
      --texts \"${texts}\" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
  elseif(EXISTS "${PROJECT_SOURCE_DIR}/docs/api.md" AND EXISTS "${PROJECT_SOURCE_DIR}/bindings/octave/rollcon_calls.c")
    set(texts "${PROJECT_SOURCE_DIR}")
  else()
    message(STATUS "Without Python 3.11 the references and the package for Octave are not written, so not installed")
    set(texts "")
  endif()
  set(rollcon_texts "${texts}" PARENT_SCOPE)
endfunction()

function(rollcon_install_octave)
  rollcon_write_texts(development)
  if(rollcon_texts)
    set(folder "${CMAKE_INSTALL_DATADIR}/rollcon/octave")
    set(sources "${PROJECT_SOURCE_DIR}/bindings/octave")
    install(FILES "${sources}/gateway.c" "${sources}/gateway.h" "${sources}/rollcon_build.m"
      "${rollcon_texts}/bindings/octave/rollcon_calls.c" DESTINATION "${folder}" COMPONENT development)
    install(DIRECTORY "${rollcon_texts}/bindings/octave/+rollcon" DESTINATION "${folder}" COMPONENT development)
  endif()
endfunction()

function(rollcon_install_references)
  rollcon_write_texts(documents)
  if(rollcon_texts)
    install(FILES "${rollcon_texts}/docs/api.md" "${rollcon_texts}/docs/reference_fortran.md"
      "${rollcon_texts}/docs/reference_python.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}/docs" COMPONENT documents)
  endif()
endfunction()
