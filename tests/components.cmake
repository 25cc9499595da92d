# Tests that need components of the library: not built where one of them is absent. The public tests
# ask rollcon_has_feature instead, and skip.

function(rollcon_tests_need components pattern)
  foreach(_name IN LISTS components)
    if(NOT ROLLCON_BUILD_${_name})
      list(FILTER sources EXCLUDE REGEX "/tests/(${pattern})")
    endif()
  endforeach()
  set(sources "${sources}" PARENT_SCOPE)
endfunction()

# rollcon_drop_absent_tests(): takes them out of the caller's list `sources`.
macro(rollcon_drop_absent_tests)
  rollcon_tests_need(FEM "bodies/fem/|mesh/(volume_|surface_coupling)")
  rollcon_tests_need(FEM "validation/(ring_on_halfspace|error_estimate)")
  rollcon_tests_need(BEM "bodies/bem/|validation/(rings|wheel_on_rail|conformal|procedures_limits)_test")
  rollcon_tests_need("FEM;BEM" "bodies/(compliance_suite|expanded_compliance|equal_bodies|forged_files)")
  rollcon_tests_need("FEM;BEM"
    "validation/(any_pair|blocks|conformal_fits|contact_patch|fine_frame|finer_than_faces|half_model)")
  rollcon_tests_need("FEM;BEM" "stability/bodies_")
  rollcon_tests_need(PROCEDURES "contact/(monolithic|procedure)|validation/(procedure|half_model)")
  rollcon_tests_need("FEM;BEM" "contact/monolithic|validation/procedures_test")
  rollcon_tests_need(VTU "io/vtu")
  if(NOT ROLLCON_BUILD_CHOLMOD)
    list(FILTER sources EXCLUDE REGEX "/tests/linalg/sparse_(factor|groups)")
  endif()
  rollcon_tests_need(UMFPACK "linalg/sparse_lu")
  if(NOT ROLLCON_BUILD_FEM AND NOT ROLLCON_BUILD_BEM)
    list(FILTER sources EXCLUDE REGEX "/tests/bodies/(frame_on_body|response_cache)")
  endif()
endmacro()
