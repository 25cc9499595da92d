!> The least a Fortran program does with rollcon: version, a context, goodbye; once through the
!> module, once through the FORTRAN 77 layer.
program package_fortran
  use rollcon
  implicit none
  external :: rcinit, rcfree
  type(rc_context) :: context
  integer :: stat, context_id

  call context%create(stat=stat)
  if (stat /= 0) error stop 'context%create failed'
  if (context%id() == 0) error stop 'a context has an id'
  call context%free()

  call rcinit(context_id, stat)
  if (stat /= 0 .or. context_id == 0) error stop 'rcinit failed'
  call rcfree(context_id, stat)
  if (stat /= 0 .or. context_id /= 0) error stop 'rcfree failed'
  print '(3a)', 'rollcon ', rc_version_string(), ' from Fortran'
end program
