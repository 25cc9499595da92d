/* The least a C program does with rollcon: version, a context, a body, goodbye. */
#include <rollcon.h>
#include <stdio.h>

int main(void) {
  rollcon_context* context = NULL;
  rollcon_body* body = NULL;
  int failures = 0;
  const int32_t header = ROLLCON_VERSION_MAJOR * 10000 + ROLLCON_VERSION_MINOR * 100 + ROLLCON_VERSION_PATCH;

  if (rollcon_version() != header) ++failures;
  if (rollcon_abi() != ROLLCON_ABI) ++failures;
  if (rollcon_context_create(ROLLCON_ABI, &context) != ROLLCON_OK) ++failures;
  if (rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &body) != ROLLCON_OK) ++failures;
  rollcon_body_release(body);
  rollcon_context_release(context);
  printf("rollcon %s from C: %d failures\n", rollcon_version_string(), failures);
  return failures;
}
