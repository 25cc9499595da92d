/* Integrates the motion of a wheelset that runs along a straight track on its primary springs. rollcon gives the forces
   of both wheels, SUNDIALS's CVODE integrates. Units are mm, N, s and tonne; x is forward, y to the right, z down. */
#ifndef ROLLCON_EXAMPLES_WHEELSET_MOTION_H
#define ROLLCON_EXAMPLES_WHEELSET_MOTION_H

#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "rollcon.h"

/* The state has lateral shift y, height z, roll and yaw; their rates; and the pitch rate less that of a wheel of
   nominal radius. */
enum { shift_y, height, roll, yaw, rate_y, rate_z, rate_roll, rate_yaw, more_pitch, states };
enum { wheels = 2 };

/* Inertia, springs and dampers are along y and z, then about x and z: in t and t mm^2, N/mm and N mm, N s/mm and
   N mm s. */
static const double inertia[4] = {1.5, 1.5, 0.9e6, 0.9e6}, pitch_inertia = 0.12e6;
static const double spring[4] = {2000, 1200, 1.2e9, 3e9}, damper[4] = {2, 40, 4e7, 2e6};
static const double wheelset_weight = 112000 /* N, with its load */, nominal_radius = 460;

typedef struct {
  rollcon_context* context;
  rollcon_body* body[2];
  rollcon_table* table;
  rollcon_wheelrail* wheel[wheels];
  double speed;
  double at_rest; /* height at which the springs carry nothing */
  long solves;    /* solves of a wheel */
  long told[2];   /* solves with a warning, and solves without an answer */
  double force[3], moment[3];
} wheelset;

/* Ends the program with the library's message if a status is below zero. */
static int32_t wheelset_must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

/* Makes a wheelset with wheels S1002 on rails 60E1. by: 0 solves each patch, 1 takes tangential forces from the
   standard table, 2 takes pressures from ellipses, too. */
static void wheelset_make(wheelset* set, double accuracy, double speed, int by) {
  static const char* const shape[2] = {"s1002", "60e1"};
  const double unit = 1, shear = 82000, poisson = 0.28, mu = 0.3;
  int i;
  memset(set, 0, sizeof *set);
  set->speed = speed;
  wheelset_must(rollcon_context_create(ROLLCON_ABI, &set->context));
  wheelset_must(rollcon_context_set_threads(set->context, 1));
  for (i = 0; i < 2; ++i) {
    wheelset_must(rollcon_body_create(set->context, ROLLCON_BODY_HALFSPACE, &set->body[i]));
    wheelset_must(rollcon_body_set_elastic(set->body[i], 0, 2 * shear * (1 + poisson), poisson));
    wheelset_must(rollcon_body_set_profile_shape(set->body[i], shape[i], 1, &unit));
  }
  if (by > 0) wheelset_must(rollcon_table_standard(set->context, &set->table));
  for (i = 0; i < wheels; ++i) {
    rollcon_wheelrail** const wheel = &set->wheel[i];
    wheelset_must(
        rollcon_wheelrail_create(set->context, set->body[0], set->body[1], i ? ROLLCON_LEFT : ROLLCON_RIGHT, wheel));
    wheelset_must(rollcon_wheelrail_set_track(*wheel, 1435, 14, atan(1.0 / 40)));
    wheelset_must(rollcon_wheelrail_set_wheelset(*wheel, 1360, -70, nominal_radius));
    wheelset_must(rollcon_wheelrail_set_friction(*wheel, "coulomb", 1, &mu));
    wheelset_must(rollcon_wheelrail_set_real(*wheel, "accuracy", accuracy));
    if (by > 0) wheelset_must(rollcon_wheelrail_set_table(*wheel, set->table));
    if (by > 1) wheelset_must(rollcon_wheelrail_set_int(*wheel, "hertzian", 1));
  }
}

static void wheelset_release(wheelset* set) {
  int i;
  for (i = 0; i < wheels; ++i) rollcon_wheelrail_release(set->wheel[i]);
  rollcon_table_release(set->table);
  for (i = 0; i < 2; ++i) rollcon_body_release(set->body[i]);
  rollcon_context_release(set->context);
}

/* Solves both wheels at a state and adds their forces and moments. Returns the worst status. */
static int32_t wheelset_solve(wheelset* set, const double* q) {
  const double position[6] = {0, q[shift_y], q[height], q[roll], q[yaw], 0};
  const double velocity[6] = {set->speed,   q[rate_y],   q[rate_z],
                              q[rate_roll], q[rate_yaw], q[more_pitch] - set->speed / nominal_radius};
  int32_t worst = ROLLCON_OK;
  int i, k;
  memset(set->force, 0, sizeof set->force);
  memset(set->moment, 0, sizeof set->moment);
  for (i = 0; i < wheels; ++i) {
    double force[3], moment[3];
    int32_t status;
    wheelset_must(rollcon_wheelrail_set_position(set->wheel[i], position));
    wheelset_must(rollcon_wheelrail_set_velocity(set->wheel[i], velocity));
    status = rollcon_wheelrail_solve(set->wheel[i]);
    ++set->solves;
    if (status < 0) return ++set->told[1], status;
    set->told[0] += status != ROLLCON_OK;
    if (status > worst) worst = status;
    wheelset_must(rollcon_wheelrail_get_resultant(set->wheel[i], ROLLCON_IN_TRACK, force, moment));
    for (k = 0; k < 3; ++k) set->force[k] += force[k], set->moment[k] += moment[k];
  }
  return worst;
}

/* Computes the rate of the state whose forces were solved last. */
static void wheelset_rate(const wheelset* set, const double* q, double* rate) {
  const double turning = pitch_inertia * (q[more_pitch] - set->speed / nominal_radius);
  const double load[4] = {set->force[1], set->force[2] + wheelset_weight + spring[1] * set->at_rest,
                          set->moment[0] + turning * q[rate_yaw], set->moment[2] - turning * q[rate_roll]};
  int k;
  for (k = 0; k < 4; ++k) {
    rate[k] = q[rate_y + k];
    rate[rate_y + k] = (load[k] - spring[k] * q[k] - damper[k] * q[rate_y + k]) / inertia[k];
  }
  rate[more_pitch] = set->moment[1] / pitch_inertia;
}

/* Computes the derivatives of that rate, column by column; the state was solved last. */
static int32_t wheelset_jacobian(wheelset* set, const double* q, double* column) {
  static const int entry[states] = {1, 2, 3, 4, 7, 8, 9, 10, 11}; /* in position, then velocity */
  const double turning = pitch_inertia * (q[more_pitch] - set->speed / nominal_radius);
  int i, j, k;
  memset(column, 0, states * states * sizeof *column);
  for (j = 0; j < states; ++j)
    for (i = 0; i < wheels; ++i) {
      double* const by = column + j * states;
      double force[3], moment[3];
      const int32_t status = rollcon_wheelrail_get_derivative(set->wheel[i], entry[j], force, moment, NULL);
      if (status < 0) return status;
      by[rate_y] += force[1] / inertia[0];
      by[rate_z] += force[2] / inertia[1];
      by[rate_roll] += moment[0] / inertia[2];
      by[rate_yaw] += moment[2] / inertia[3];
      by[more_pitch] += moment[1] / pitch_inertia;
    }
  for (k = 0; k < 4; ++k) {
    column[(rate_y + k) * states + k] = 1;
    column[k * states + rate_y + k] -= spring[k] / inertia[k];
    column[(rate_y + k) * states + rate_y + k] -= damper[k] / inertia[k];
  }
  column[rate_yaw * states + rate_roll] += turning / inertia[2];
  column[rate_roll * states + rate_yaw] -= turning / inertia[3];
  column[more_pitch * states + rate_roll] += pitch_inertia * q[rate_yaw] / inertia[2];
  column[more_pitch * states + rate_yaw] -= pitch_inertia * q[rate_roll] / inertia[3];
  return ROLLCON_OK;
}

/* Finds height, roll and pitch rate at which the wheelset, held at a shift, is in equilibrium. The vertical springs
   carry nothing at that height. */
static void wheelset_settle(wheelset* set, double* q) {
  static const int unknown[3] = {height, roll, more_pitch}, row[3] = {rate_z, rate_roll, more_pitch};
  double column[states * states], rate[states];
  double z[wheels];
  int n, i, j, k;
  for (i = 0; i < wheels; ++i)
    wheelset_must(
        rollcon_wheelrail_prescribe_vertical(set->wheel[i], ROLLCON_BY_FORCE, wheelset_weight / (double)wheels));
  wheelset_must(wheelset_solve(set, q));
  for (i = 0; i < wheels; ++i) {
    wheelset_must(rollcon_wheelrail_get_stat(set->wheel[i], "z", &z[i]));
    wheelset_must(rollcon_wheelrail_prescribe_vertical(set->wheel[i], ROLLCON_BY_MOTION, 0));
  }
  q[height] = (z[0] + z[1]) / 2;
  q[roll] = (z[0] - z[1]) / 1500; /* distance of both contacts */
  for (n = 0; n < 30; ++n) {
    double a[3][4], change = 0;
    set->at_rest = q[height];
    wheelset_must(wheelset_solve(set, q));
    wheelset_rate(set, q, rate);
    wheelset_must(wheelset_jacobian(set, q, column));
    for (i = 0; i < 3; ++i) {
      for (j = 0; j < 3; ++j) a[i][j] = column[unknown[j] * states + row[i]];
      if (i == 0) a[0][0] += spring[1] / inertia[1];
      a[i][3] = -rate[row[i]];
    }
    for (k = 0; k < 3; ++k)
      for (i = 0; i < 3; ++i) {
        const double factor = a[i][k] / a[k][k];
        for (j = k; i != k && j < 4; ++j) a[i][j] -= factor * a[k][j];
      }
    for (k = 0; k < 3; ++k) {
      q[unknown[k]] += a[k][3] / a[k][k];
      change += fabs(a[k][3] / a[k][k]);
    }
    if (change < 1e-9) break;
  }
  set->at_rest = q[height];
}

/* CVODE calls both functions below: for the rate, and for its Jacobian. */
static int wheelset_right_side(realtype t, N_Vector state, N_Vector rate, void* of) {
  wheelset* const set = (wheelset*)of;
  (void)t;
  if (wheelset_solve(set, N_VGetArrayPointer(state)) < 0) return 1; /* CVODE takes a shorter step */
  wheelset_rate(set, N_VGetArrayPointer(state), N_VGetArrayPointer(rate));
  return 0;
}

static int wheelset_matrix(realtype t, N_Vector state, N_Vector rate, SUNMatrix jacobian, void* of, N_Vector a,
                           N_Vector b, N_Vector c) {
  wheelset* const set = (wheelset*)of;
  (void)t, (void)rate, (void)a, (void)b, (void)c;
  if (wheelset_solve(set, N_VGetArrayPointer(state)) < 0) return 1;
  return wheelset_jacobian(set, N_VGetArrayPointer(state), SUNDenseMatrix_Data(jacobian)) < 0;
}

/* Integrates from a state over `points` intervals of time and writes the shift at the end of each. own: 1 takes
   derivatives from rollcon, 0 lets CVODE take differences. Returns the number of steps, or -1 if CVODE gave up. */
static long wheelset_run(wheelset* set, double* q, double tolerance, int own, double interval, int points,
                         double* shift) {
  static const double size[states] = {1, 1e-2, 1e-4, 1e-3, 10, 1, 1e-2, 1e-2, 1e-2};
  SUNContext context;
  N_Vector state, absolute;
  SUNMatrix matrix;
  SUNLinearSolver solver;
  void* cvode;
  long steps = 0;
  int i, failed = 0;
  SUNContext_Create(NULL, &context);
  state = N_VMake_Serial(states, q, context);
  absolute = N_VNew_Serial(states, context);
  for (i = 0; i < states; ++i) N_VGetArrayPointer(absolute)[i] = tolerance * size[i];
  matrix = SUNDenseMatrix(states, states, context);
  solver = SUNLinSol_Dense(state, matrix, context);
  cvode = CVodeCreate(CV_BDF, context);
  CVodeInit(cvode, wheelset_right_side, 0, state);
  CVodeSVtolerances(cvode, tolerance, absolute);
  CVodeSetUserData(cvode, set);
  CVodeSetMaxNumSteps(cvode, 100000);
  CVodeSetLinearSolver(cvode, solver, matrix);
  if (own) CVodeSetJacFn(cvode, wheelset_matrix);
  for (i = 0; i < points && !failed; ++i) {
    realtype at;
    failed = CVode(cvode, (i + 1) * interval, state, &at, CV_NORMAL) < 0;
    shift[i] = q[shift_y];
  }
  CVodeGetNumSteps(cvode, &steps);
  CVodeFree(&cvode);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(absolute);
  N_VDestroy(state);
  SUNContext_Free(&context);
  return failed ? -1 : steps;
}
#endif
