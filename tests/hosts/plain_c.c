/* Tests a host in C, compiled without exceptions and unwind tables, with callbacks: failures come back as
   statuses through its frames, whatever happens inside. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "rollcon.h"

static int failures = 0;
static rollcon_contact* inner = NULL;

static void check(int right, const char* what, int status) {
  if (right) return;
  printf("WRONG: %s: status %d\n", what, status);
  ++failures;
}

/* Uses the library in a callback, where calls fail. */
static int32_t ROLLCON_CALL progress(const rollcon_event* event, void* user) {
  int64_t iteration = 0;
  int32_t* calls = user;
  check(rollcon_event_get_int(event, ROLLCON_EVENT_ITERATION, &iteration) == ROLLCON_OK, "event", 0);
  check(rollcon_contact_solve(inner) == ROLLCON_ERR_STATE, "solve of an empty contact", 0);
  check(rollcon_contact_set_rolling(inner, NAN) == ROLLCON_ERR_NONFINITE, "speed NaN", 0);
  return ++*calls == 3;
}

static void ROLLCON_CALL sink(int32_t level, const char* message, void* user) {
  (void)level;
  *(size_t*)user += strlen(message);
}

int main(void) {
  rollcon_context* context = NULL;
  rollcon_body *sphere = NULL, *plane = NULL;
  rollcon_contact* contact = NULL;
  double force[3];
  int32_t calls = 0, status;
  const double friction = 0.1;
  size_t characters = 0;
#define OK(call)                       \
  do {                                 \
    status = call;                     \
    check(status >= 0, #call, status); \
  } while (0)
  OK(rollcon_context_create(ROLLCON_ABI, &context));
  OK(rollcon_context_set_log(context, ROLLCON_LOG_DEBUG, sink, &characters));
  OK(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &sphere));
  OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &plane));
  OK(rollcon_body_set_elastic(sphere, 0, 1e4, 0.3));
  OK(rollcon_contact_create(context, sphere, plane, &contact));
  OK(rollcon_contact_create(context, sphere, plane, &inner));
  OK(rollcon_contact_frame_rectangle(contact, ROLLCON_QUAD4, 6, 6, -1.5, 1.5, -1.5, 1.5));
  OK(rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0));
  OK(rollcon_contact_set_friction(contact, "coulomb", 1, &friction));
  OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02));
  OK(rollcon_contact_set_creep(contact, 1e-3, 0, 0));
  OK(rollcon_contact_set_progress(contact, progress, &calls));
  OK(rollcon_contact_solve(contact));
  check(status == ROLLCON_CANCELLED, "cancelled by the callback", status);
  OK(rollcon_contact_set_progress(contact, NULL, NULL));
  OK(rollcon_contact_solve(contact));
  OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, NULL));
  check(force[2] < 0, "force", 0);
  check(rollcon_contact_solve(NULL) == ROLLCON_ERR_ARGUMENT, "no contact", 0);
  check(rollcon_contact_solve((rollcon_contact*)context) == ROLLCON_ERR_HANDLE, "wrong kind", 0);
  rollcon_contact_release(inner);
  rollcon_contact_release(contact);
  rollcon_body_release(plane);
  rollcon_body_release(sphere);
  rollcon_context_release(context);
  printf("%d calls back, %lu characters of log, normal force %g\n", (int)calls, (unsigned long)characters, force[2]);
  check(calls == 3 && characters > 0, "callbacks", calls);
  return failures > 0;
}
