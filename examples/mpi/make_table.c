/* Makes a creep-force table by as many processes as there are.

       mpiexec -n 4 make_table [file [coarse]]

   Each process solves its part of the samples and sends its numbers to the first, which writes the table to the file
   (table.rct unless given). The table does not depend on how many processes there are. "coarse" makes a small table in
   a second; without it, it is that of the defaults, which takes some 40 minutes of processor time. */
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rollcon.h"

/* Ends all processes with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  MPI_Abort(MPI_COMM_WORLD, 1);
  return status;
}

static void set_coarse(rollcon_table* table) {
  must(rollcon_table_set_ratios(table, 4, 0.5, 2));
  must(rollcon_table_set_resolution(table, 4, 4, 4));
  must(rollcon_table_set_frame(table, 6, 6));
}

/* Gathers the samples in the first process: they are not a number where a process has none. */
static void gather(rollcon_table* table, int rank, int ranks) {
  int64_t count;
  double* samples;
  int from;
  must(rollcon_table_get_samples(table, 0, NULL, &count));
  samples = malloc((size_t)count * sizeof *samples);
  if (!samples) MPI_Abort(MPI_COMM_WORLD, 1);
  if (rank == 0) {
    for (from = 1; from < ranks; ++from) {
      MPI_Recv(samples, (int)count, MPI_DOUBLE, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      must(rollcon_table_add_samples(table, count, samples));
    }
  } else {
    must(rollcon_table_get_samples(table, count, samples, &count));
    MPI_Send(samples, (int)count, MPI_DOUBLE, 0, 0, MPI_COMM_WORLD);
  }
  free(samples);
}

static void show(const rollcon_table* table) {
  const double input[9] = {82000, 0.28, 0.3, 6, 4, 1e5, 1e-3, -5e-4, 1e-4};
  double force[3];
  must(rollcon_table_evaluate(table, 1, input, force));
  printf("a steel wheel under 100 kN: %.1f N along, %.1f N across the rolling direction, moment %.1f N mm\n", force[0],
         force[1], force[2]);
}

int main(int argc, char** argv) {
  const char* file = argc > 1 ? argv[1] : "table.rct";
  int rank, ranks;
  rollcon_context* context;
  rollcon_table* table;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_context_set_threads(context, 1)); /* the processes are the threads */
  must(rollcon_table_create(context, &table));
  if (argc > 2 && strcmp(argv[2], "coarse") == 0) set_coarse(table);
  must(rollcon_table_make(table, rank, ranks));
  gather(table, rank, ranks);
  if (rank == 0) {
    must(rollcon_table_save(table, file));
    show(table);
    printf("wrote %s, made by %d processes\n", file, ranks);
  }
  rollcon_table_release(table);
  rollcon_context_release(context);
  MPI_Finalize();
  return 0;
}
