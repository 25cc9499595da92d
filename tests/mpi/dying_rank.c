/* Lets the last rank die before a joint call: the launcher ends the others, which must not wait for it. */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "rollcon.h"

int main(int argc, char** argv) {
  const double mu = 0.3, value[4] = {8e4, 8e4, 8e4, 8e4};
  double result[4];
  int64_t width;
  int rank, ranks;
  rollcon_context* context;
  rollcon_body* plain;
  rollcon_contact* contact;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  rollcon_context_create(ROLLCON_ABI, &context);
  rollcon_context_set_communicator(context, (int32_t)MPI_Comm_c2f(MPI_COMM_WORLD));
  rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &plain);
  rollcon_body_set_elastic(plain, 0, 210e3, 0.28);
  rollcon_contact_create(context, plain, plain, &contact);
  rollcon_contact_set_gap_quadratic(contact, 0.001, 0.001, 0);
  rollcon_contact_set_friction(contact, "coulomb", 1, &mu);
  rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 8, 8, -8, 8, -8, 8);
  rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, value[0]);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank == 0 && rollcon_contact_solve(contact) == ROLLCON_OK) {
    printf("all ranks are ready\n");
    fflush(stdout);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank == ranks - 1) _exit(3);
  rollcon_contact_solve_many(contact, "normal", 4, value, "approach", 1, result, &width, NULL);
  if (rank == 0) printf("all ranks ended\n");
  MPI_Finalize();
  return 0;
}
