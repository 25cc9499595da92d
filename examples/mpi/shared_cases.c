/* Solves a list of creepages, as creep curves need it, on all ranks of an MPI program.

       mpiexec -n 4 shared_cases

   Every rank makes the same calls with the same data, and gets all results. Rank 0 prints some of them. The
   library must be built with ROLLCON_WITH_MPI=ON. */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

enum { CASES = 200 };

/* Ends all processes with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  MPI_Abort(MPI_COMM_WORLD, 1);
  return status;
}

int main(int argc, char** argv) {
  static double creepage[CASES][2], force[CASES][3];
  const double mu = 0.3;
  int rank, ranks, k;
  double start;
  rollcon_context* context;
  rollcon_body *wheel, *rail;
  rollcon_contact* contact;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_context_set_threads(context, 1)); /* each process has one thread */
  must(rollcon_context_set_communicator(context, (int32_t)MPI_Comm_c2f(MPI_COMM_WORLD)));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &wheel));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &rail));
  must(rollcon_body_set_elastic(wheel, 0, 210e3, 0.28));
  must(rollcon_body_set_elastic(rail, 0, 210e3, 0.28));
  must(rollcon_contact_create(context, wheel, rail, &contact));
  must(rollcon_contact_set_gap_quadratic(contact, 1 / 920.0, 1 / 600.0, 0));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 28, 28, -7, 7, -7, 7));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 80e3));
  for (k = 0; k < CASES; ++k) {
    creepage[k][0] = -0.0005 * (k % 20);
    creepage[k][1] = 0.0005 * (k / 20);
  }
  start = MPI_Wtime();
  must(rollcon_contact_solve_many(contact, "longitudinal lateral", CASES, creepage[0], "force", 3, force[0], NULL,
                                  NULL));
  start = MPI_Wtime() - start;
  if (rank == 0) {
    for (k = 0; k < CASES; k += 49)
      printf("creepages %7.4f, %6.4f: forces %7.0f, %7.0f N\n", creepage[k][0], creepage[k][1], force[k][0],
             force[k][1]);
    fprintf(stderr, "%d cases by %d ranks: %.2f s\n", (int)CASES, ranks, start);
  }
  rollcon_contact_release(contact);
  rollcon_body_release(wheel);
  rollcon_body_release(rail);
  rollcon_context_release(context);
  MPI_Finalize();
  return 0;
}
