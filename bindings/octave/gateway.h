/* Declares what the calls of the gateway have in common: values of MATLAB and Octave become those of C, and back.
   rollcon_calls.c has a function for each one of rollcon_layers.h. */
#ifndef ROLLCON_OCTAVE_GATEWAY_H
#define ROLLCON_OCTAVE_GATEWAY_H

#include <mex.h>
#include <stdint.h>

#include "rollcon_layers.h"

/* Holds one call: what is left of the arguments, and the results so far. */
typedef struct call {
  const char* function; /* "rollcon.body_create" */
  int nlhs, nrhs, given;
  mxArray** plhs;
  const mxArray** prhs;
} call;

typedef struct enumerator {
  const char* name; /* in lower case, without a prefix: "fem" */
  int32_t value;
} enumerator;

typedef struct entry {
  const char* name;
  void (*function)(call*);
  int most_results;
} entry;

extern const entry calls[];
extern const int number_of_calls;

/* Take the next argument. These functions end the call with an error that names it where it is no such thing. Memory
   is freed when the call ends, however it ends. */
int32_t take_handle(call* c, const char* name);
double take_real(call* c, const char* name);
int64_t take_integer(call* c, const char* name);
/* Takes a number, or a name of the enumerators; several, with blanks between them, are added where `sum` is set. */
int32_t take_enumerator(call* c, const char* name, const enumerator* list, int sum);
const char* take_text(call* c, const char* name);
/* Takes n rows of `width` numbers, for C; *n >= 0: so many; width 0: any array, entry after entry. [] is NULL if
   optional. */
const double* take_reals(call* c, const char* name, int64_t* n, int width, int optional);
const int32_t* take_integers(call* c, const char* name, int64_t* n, int width);
/* Takes rows of numbers in the order of memory: x(n, 3). */
const double* take_columns(call* c, const char* name, int64_t* n);
/* Says whether there is a further argument; [] is none. */
int has_more(const call* c);
void no_more(call* c);

/* Give results, in their order; those that nobody asked for are dropped. */
void give_real(call* c, double value);
void give_text(call* c, const char* text);
void give_reals(call* c, const double* values, int64_t n, int64_t width);
void give_integers(call* c, const int32_t* values, int64_t n, int offset);
/* Returns room for a result in C. */
void* room(int64_t entries, size_t size);

/* Ends the call with the error rollcon:ERR_... for a status below 0; above 0 gives the warning rollcon:NOT_CONVERGED,
   ... */
void finish(call* c, int32_t status);
/* Ends the call with the error of a function that takes an argument. */
void refuse(call* c, const char* name, const char* what);
int nodes_of_type(int32_t type);
int64_t count_words(const char* text);

/* Is written by hand, because its arguments depend on each other. */
void call_contact_solve_many(call* c);

#endif
