/* A table of creep forces, computed by as many processes as there are: elliptic contacts of equal
   steel bodies over the ratio of semi-axes, both creepages and spin.

       mpiexec -n 4 creepage_table [file [creepages]]

   Rank 0 writes the table to the file (creepage_table.csv unless given). The unit of work is a row:
   one ratio, one lateral creepage and one spin; along it the longitudinal creepage grows, each
   solve starting from the last. Rows are dealt out in turn, and each begins with a reset, so that
   the table does not depend on how many ranks there are. Ranks need nothing of each other until the
   end: no rank waits for another one's rows. "creepages" is the length of a row.
   Units: mm, N, MPa. */
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

#include "rollcon.h"

enum { ALONG = 16, ACROSS = 12 }; /* elements of the frame */
enum { RATIOS = 3, LATERALS = 5, SPINS = 3, ROWS = RATIOS * LATERALS * SPINS };
enum { VALUES = 5 }; /* of one solve: approach, two forces, moment, status */

static const double young = 210000, poisson = 0.28, mu = 0.3, pressure = 1000;
static const double ratio[RATIOS] = {0.5, 1, 2};                   /* a/b, a along the rolling direction, ab = 1 */
static const double lateral[LATERALS] = {-0.8, -0.4, 0, 0.4, 0.8}; /* over the unit of creepage */
static const double spin[SPINS] = {0, 0.5, 1};
static const double longest = 1; /* longitudinal creepage at the end of a row, likewise */

static rollcon_context* context;
static rollcon_body* steel;
static rollcon_contact* contact;

/* A status below zero ends all ranks with the library's own words. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  MPI_Abort(MPI_COMM_WORLD, 1);
  return status;
}

static double load(void) {
  return 2.0 / 3 * acos(-1.0) * pressure;
}

/* Forces of creepages are measured by it: shear modulus G, semi-axes a and b with ab = 1. */
static double unit_of_creepage(void) {
  return mu * load() * 2 * (1 + poisson) / young;
}

/* Complete elliptic integrals of both kinds by the arithmetic-geometric mean; m = k^2 < 1. */
static void elliptic(double m, double* first, double* second) {
  double a = 1, g = sqrt(1 - m), sum = m / 2, power = 0.5;
  while (fabs(a - g) > 1e-15 * a) {
    const double half = (a - g) / 2, mean = (a + g) / 2;
    g = sqrt(a * g);
    a = mean;
    power *= 2;
    sum += power * half * half;
  }
  *first = acos(-1.0) / (2 * a);
  *second = *first * (1 - sum);
}

/* Hertz: curvatures of the gap A x^2 + B y^2 that make semi-axes a (along x) and b. */
static void curvatures(double a, double b, double* A, double* B) {
  const double modulus = young / (2 * (1 - poisson * poisson)), large = fmax(a, b), small = fmin(a, b),
               m = 1 - small * small / (large * large);
  double K, E, along, across; /* along and across the longer semi-axis */
  elliptic(m, &K, &E);
  if (m < 1e-12) {
    along = across = acos(-1.0) * pressure / (4 * modulus * a);
  } else {
    along = pressure / modulus * small / (m * large * large) * (K - E);
    across = pressure / modulus * small / (m * large * large) * (E * large * large / (small * small) - K);
  }
  *A = a >= b ? along : across;
  *B = a >= b ? across : along;
}

static void set_ellipse(double axis_ratio) {
  const double a = sqrt(axis_ratio), b = 1 / a;
  double A, B;
  curvatures(a, b, &A, &B);
  must(rollcon_contact_frame_ellipse(contact, ALONG, ACROSS, a, b, 0));
  must(rollcon_contact_set_gap_quadratic(contact, A, B, 0));
}

/* Every rank has a context of its own, and one thread: the other cores belong to other ranks. */
static void set_scene(void) {
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_context_set_threads(context, 1));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &steel));
  must(rollcon_body_set_elastic(steel, 0, young, poisson));
  must(rollcon_contact_create(context, steel, steel, &contact));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_set_rolling(contact, 1));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load()));
  /* A table is made once, and read and interpolated many times. */
  must(rollcon_contact_set_real(contact, "tolerance", 1e-12));
}

/* out: VALUES for each longitudinal creepage. */
static void solve_row(int row, int creepages, double* out) {
  const double unit = unit_of_creepage(), limit = mu * load();
  int i;
  must(rollcon_contact_reset(contact));
  for (i = 0; i < creepages; ++i, out += VALUES) {
    double force[3], moment[3], creep[3];
    must(rollcon_contact_set_creep(contact, unit * longest * i / (creepages - 1),
                                   unit * lateral[row / SPINS % LATERALS], unit * spin[row % SPINS]));
    out[4] = must(rollcon_contact_solve(contact));
    must(rollcon_contact_get_motion(contact, &out[0], creep));
    must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment));
    out[1] = force[0] / limit;
    out[2] = force[1] / limit;
    out[3] = moment[2] / limit;
  }
}

static void write_table(const char* path, int creepages, const double* table) {
  FILE* file = fopen(path, "w");
  double sum = 0;
  long odd = 0;
  int row, i, v;
  if (!file) {
    perror(path);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  fprintf(file, "a/b,xi1,xi2,spin,approach,Fx/(mu N),Fy/(mu N),Mz/(mu N sqrt(ab)),status\n");
  for (row = 0; row < ROWS; ++row) {
    for (i = 0; i < creepages; ++i, table += VALUES) {
      const double unit = unit_of_creepage();
      fprintf(file, "%g,%.17g,%.17g,%.17g", ratio[row / (SPINS * LATERALS)], unit * longest * i / (creepages - 1),
              unit * lateral[row / SPINS % LATERALS], unit * spin[row % SPINS]);
      for (v = 0; v < 4; ++v) {
        fprintf(file, ",%.17g", table[v]);
        sum += fabs(table[v]);
      }
      fprintf(file, ",%d\n", (int)table[4]);
      odd += table[4] != ROLLCON_OK;
    }
  }
  if (fclose(file) != 0) {
    perror(path);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  printf("%d solves in %d rows, %ld with a caveat; sum of magnitudes %.10f\n", ROWS * creepages, ROWS, odd, sum);
}

int main(int argc, char** argv) {
  const char* path;
  double *mine, *table = NULL, start, seconds, slowest;
  int rank, ranks, creepages, row, present = -1;

  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  path = argc > 1 ? argv[1] : "creepage_table.csv";
  creepages = argc > 2 ? atoi(argv[2]) : 9;
  if (creepages < 2) {
    if (rank == 0) fprintf(stderr, "creepages: %s; allowed: 2 and more\n", argv[2]);
    MPI_Finalize();
    return 1;
  }
  start = MPI_Wtime();
  set_scene();
  mine = calloc((size_t)(ROWS * creepages) * VALUES, sizeof *mine);
  if (rank == 0) table = calloc((size_t)(ROWS * creepages) * VALUES, sizeof *table);
  if (!mine || (rank == 0 && !table)) MPI_Abort(MPI_COMM_WORLD, 1);

  for (row = rank; row < ROWS; row += ranks) {
    if (row / (SPINS * LATERALS) != present) {
      present = row / (SPINS * LATERALS);
      set_ellipse(ratio[present]);
    }
    solve_row(row, creepages, mine + (size_t)(row * creepages) * VALUES);
  }
  seconds = MPI_Wtime() - start;

  /* Each number comes from one rank, all others add zero. */
  MPI_Reduce(mine, table, ROWS * creepages * VALUES, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(&seconds, &slowest, 1, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  if (rank == 0) {
    write_table(path, creepages, table);
    fprintf(stderr, "%d rank(s), %.3f s\n", ranks, slowest);
  }
  free(table);
  free(mine);
  rollcon_contact_release(contact);
  rollcon_body_release(steel);
  rollcon_context_release(context);
  MPI_Finalize();
  return 0;
}
