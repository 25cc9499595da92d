# Adds tests that run a program on ranks of MPI.

# They have one machine, no network, perhaps fewer cores than ranks, perhaps root: MPICH (HYDRA) and Open MPI are told
# so by the environment.
set(ROLLCON_RANKS_ENVIRONMENT "OMP_WAIT_POLICY=passive" "OPENBLAS_NUM_THREADS=1" "HYDRA_LAUNCHER=fork"
  "HYDRA_IFACE=lo" "OMPI_ALLOW_RUN_AS_ROOT=1" "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"
  "OMPI_MCA_rmaps_base_oversubscribe=1" "OMPI_MCA_plm=isolated" "OMPI_MCA_btl=self,vader")

# rollcon_ranks_test(<name> <ranks> <target> [<argument>...])
function(rollcon_ranks_test _name _ranks _target)
  add_test(NAME ${_name} COMMAND "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} ${_ranks} ${MPIEXEC_PREFLAGS}
    "$<TARGET_FILE:${_target}>" ${MPIEXEC_POSTFLAGS} ${ARGN})
  set_tests_properties(${_name} PROPERTIES TIMEOUT ${ROLLCON_TEST_TIMEOUT} ENVIRONMENT "${ROLLCON_RANKS_ENVIRONMENT}"
    PROCESSORS ${_ranks})
endfunction()
