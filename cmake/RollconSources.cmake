# Says which sources belong to which component: those of absent ones are not compiled.

function(rollcon_any_built result)
  set(${result} OFF PARENT_SCOPE)
  foreach(_name IN LISTS ARGN)
    if(ROLLCON_BUILD_${_name})
      set(${result} ON PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# Compiles sources where any of these components is built: rollcon_belongs(<regular expression under src/>
# <components>...)
macro(rollcon_belongs _pattern)
  rollcon_any_built(_built ${ARGN})
  if(NOT _built)
    list(FILTER ROLLCON_SOURCES EXCLUDE REGEX "/src/(${_pattern})")
  endif()
endmacro()

# Compiles a file where none of the components is built, and any of those after FOR, which call them; without FOR
# everybody does: rollcon_stands_for(<file under src/> <components>... [FOR <components>...])
macro(rollcon_stands_for _file)
  cmake_parse_arguments(_stand "" "" "FOR" ${ARGN})
  rollcon_any_built(_built ${_stand_UNPARSED_ARGUMENTS})
  set(_called ON)
  if(_stand_FOR)
    rollcon_any_built(_called ${_stand_FOR})
  endif()
  if(_called AND NOT _built)
    list(APPEND ROLLCON_SOURCES "${PROJECT_SOURCE_DIR}/src/${_file}")
  endif()
endmacro()

list(FILTER ROLLCON_SOURCES EXCLUDE REGEX "_absent\\.cpp$")

rollcon_belongs("bodies/(fem/|section/|condensed/|nodal_loads|model/felt_)" FEM)
rollcon_belongs("mesh/volume_" FEM)
rollcon_belongs("geometry/(surface_coupling|coupled_element|plane_chart|convex_polygon)" FEM)
rollcon_stands_for(bodies/fem_absent.cpp FEM)
rollcon_stands_for(mesh/volume_absent.cpp FEM)
rollcon_stands_for(mesh/volume_shape_absent.cpp FEM)

rollcon_belongs("bodies/bem/" BEM)
rollcon_stands_for(bodies/bem_absent.cpp BEM)

# Both kinds of elastic bodies with a mesh use these; rigid ones need none of it.
rollcon_belongs("bodies/(displacement_beside|meshed_|remainder_|frame_on_body|model/(response_cache|saved_responses|supports))" FEM BEM)
rollcon_stands_for(bodies/meshed_absent.cpp FEM BEM)

rollcon_belongs("procedures/" PROCEDURES)

rollcon_belongs("linalg/sparse_matrix" FEM BEM PROCEDURES)
rollcon_belongs("linalg/sparse_checks" CHOLMOD MUMPS UMFPACK)
rollcon_belongs("linalg/sparse_(order\\.|groups)" CHOLMOD MUMPS)
rollcon_belongs("linalg/sparse_(order_)?cholmod" CHOLMOD)
rollcon_belongs("linalg/sparse_mumps" MUMPS)
rollcon_belongs("linalg/sparse_lu" UMFPACK)
rollcon_stands_for(linalg/cholmod_absent.cpp CHOLMOD MUMPS FOR FEM PROCEDURES)
rollcon_stands_for(linalg/umfpack_absent.cpp UMFPACK FOR PROCEDURES)
rollcon_belongs("linalg/(hierarchical_hmat|skeleton)" HMAT)
rollcon_stands_for(linalg/hierarchical_absent.cpp HMAT FOR BEM)
rollcon_belongs("linalg/condensed_factor" CHOLMOD MUMPS)
if(ROLLCON_BUILD_FEM AND NOT (ROLLCON_BUILD_MUMPS AND ROLLCON_BUILD_MPI))
  list(APPEND ROLLCON_SOURCES "${PROJECT_SOURCE_DIR}/src/linalg/shared_factor_absent.cpp")
endif()
rollcon_belongs("linalg/factored_matrix" FEM BEM PROCEDURES)

rollcon_belongs("support/ranks_mpi" MPI)
rollcon_stands_for(support/ranks_absent.cpp MPI)

rollcon_belongs("io/vtu" VTU)
rollcon_stands_for(io/vtu_absent.cpp VTU)

# The headers from outside are seen by the files alone that use them: a build that is configured anew with other
# components compiles little again.
macro(rollcon_sees _pattern _external)
  if(TARGET rollcon::${_external})
    get_target_property(_folder rollcon::${_external} INTERFACE_INCLUDE_DIRECTORIES)
    set(_files ${ROLLCON_SOURCES})
    list(FILTER _files INCLUDE REGEX "/src/(${_pattern})")
    if(NOT _folder IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
      set_source_files_properties(${_files} PROPERTIES COMPILE_OPTIONS "-isystem;${_folder}")
    endif()
  endif()
endmacro()
rollcon_sees("linalg/sparse_" cholmod)
rollcon_sees("linalg/sparse_mumps" mumps)
rollcon_sees("linalg/sparse_lu" umfpack)
rollcon_sees("linalg/fft" fftw)
rollcon_sees("support/ranks_mpi" mpi)
rollcon_sees("linalg/hierarchical_hmat" hmat)
