! A Fortran program that speaks CONTACT's interface by the compiler's own names: a contact of Hertz in SIMPACK's units.
program transcript
   implicit none
   include 'rollcon_cntc.inc'
   integer :: ire, icp, imodul, ifcver, ierror, mx, my, flags(3), values(3)
   double precision :: params(8), fn, tx, ty, mz, pen, eldiv
   integer, allocatable :: division(:)

   ire = 5; icp = 1; imodul = 3
   call cntc_initializefirst(ifcver, ierror, 0, ' ', ' ', 'transcript_f90', 1, 1, 14)
   call cntc_initialize(ire, imodul, ifcver, ierror, ' ', 1)
   if (ierror /= 0 .or. ifcver /= 2520) stop 1
   flags = [CNTC_if_units, CNTC_ic_tang, 0]
   values = [CNTC_un_spck, 3, 0]
   call cntc_setflags(ire, icp, 3, flags, values)
   params(1:4) = [0.28d0, 0.28d0, 82d9, 82d9]
   call cntc_setmaterialparameters(ire, icp, 0, 4, params)
   params(1:2) = 0.33d0
   call cntc_setfrictionmethod(ire, icp, 0, 2, params)
   params(1:5) = [44d0, 48d0, 0.8d0, 0.5d0, 1.0083d0]
   call cntc_sethertzcontact(ire, icp, -2, 5, params)
   call cntc_setreferencevelocity(ire, icp, 10d0)
   call cntc_setnormalforce(ire, icp, 106700d0)
   call cntc_setcreepages(ire, icp, 1.6d-3, 0d0, 0d0)
   call cntc_calculate(ire, icp, ierror)
   if (ierror < 0) stop 2
   call cntc_getcontactforces(ire, icp, fn, tx, ty, mz)
   call cntc_getpenetration(ire, icp, pen)
   write (*, '(a, 3f12.5)') ' Fx/(fstat Fn), Fn in kN, approach in mm: ', tx/(0.33d0*fn), fn/1000, pen*1000
   if (abs(tx/(0.33d0*fn) - 0.7831d0) > 0.01d0) stop 3
   if (abs(pen - 0.07651d-3) > 1d-6) stop 4
   call cntc_getnumelements(ire, icp, mx, my)
   allocate (division(mx*my))
   call cntc_getelementdivision(ire, icp, mx*my, division)
   eldiv = count(division == 1)/dble(count(division > 0))
   write (*, '(a, f8.4)') ' stick over contact: ', eldiv
   if (abs(eldiv - 596d0/1384) > 0.03d0) stop 5
   deallocate (division)
   call cntc_finalize(ire)
end program
