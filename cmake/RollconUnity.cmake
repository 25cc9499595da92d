# Compiles sources together, for builds that begin with nothing, such as CI's. It is off elsewhere: an edited source
# should compile alone, and a missing include show.

# Replaces in the list sources without options of their own by a few joined ones in this build folder:
# rollcon_unity(<list of sources> <number> [<option of unity.py>])
function(rollcon_unity list number)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(joined "")
  set(alone "")
  foreach(source IN LISTS ${list})
    get_source_file_property(options "${source}" COMPILE_OPTIONS)
    if(options OR NOT source MATCHES "\\.cpp$")
      list(APPEND alone "${source}")
    else()
      list(APPEND joined "${source}")
    endif()
  endforeach()
  set(script "${PROJECT_SOURCE_DIR}/cmake/unity.py")
  # Names in an edited source may keep it from standing where it stood.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${joined} "${script}")
  string(MAKE_C_IDENTIFIER "${list}" name)
  execute_process(COMMAND "${Python3_EXECUTABLE}" "${script}" ${ARGN} -I "${PROJECT_SOURCE_DIR}/src"
    -I "${PROJECT_SOURCE_DIR}/tests" "${CMAKE_CURRENT_BINARY_DIR}/unity/${name}" ${number} ${joined}
    OUTPUT_VARIABLE groups COMMAND_ERROR_IS_FATAL ANY OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REPLACE "\n" ";" groups "${groups}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC takes what stands behind a `#line` for a header.
    set_source_files_properties(${groups} PROPERTIES COMPILE_OPTIONS -Wno-subobject-linkage)
  endif()
  set(${list} ${alone} ${groups} PARENT_SCOPE)
endfunction()
