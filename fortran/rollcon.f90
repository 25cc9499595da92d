!> Gives the Fortran 2008 view of the rollcon library: types rc_context, rc_body, rc_contact, rc_wheelrail and rc_table,
!> the functions that need no object, and, from module rollcon_c, all enumerators (ROLLCON_...) and the C functions
!> themselves.
module rollcon
  use rollcon_c
  use rollcon_support, only: rc_int, rc_long, rc_real, rc_last_error, rc_last_caveat, rc_version, rc_abi, rc_version_string, &
    rc_build_info, rc_has_feature, rc_status_string
  use rollcon_context
  use rollcon_body
  use rollcon_contact
  use rollcon_wheelrail
  use rollcon_table
  use rollcon_tables
  implicit none
  public
end module rollcon
