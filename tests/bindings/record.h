/* Replaces rollcon in tests of the layers over C: it computes nothing, writes down
   with which arguments each function was called, and gives numbers that tell each result from every
   other. recorded_calls.c has its functions. */
#ifndef ROLLCON_TESTS_RECORD_H
#define ROLLCON_TESTS_RECORD_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Returns for tests the arguments of the last call of a function, as text; "never called". */
const char* recorder_said(const char* function);
/* Sets the status that every call that has one returns from now on. Failing calls give no results. */
void recorder_answers(int32_t status);
/* Returns the names of the functions that were never called, separated by blanks. */
const char* recorder_missing(void);

/* Serves recorded_calls.c: a call begins, tells its arguments, and ends with the status. */
enum { RECORD_NODES = 3, RECORD_ELEMENTS = 2, RECORD_ROWS = 2, RECORD_VALUES = 6, RECORD_COUNT = 2 };
void record_begin(int function);
void record_handle(const void* handle);
void record_integer(int64_t value);
void record_real(double value);
void record_text(const char* text);
void record_integers(const int32_t* values, int64_t n);
void record_reals(const double* values, int64_t n);
void record_nodes(const double* x, int64_t n, int64_t node_stride, int64_t component_stride);
void record_room(const void* place); /* whether there is room for a result */
int32_t record_end(void);
int64_t record_words(const char* text);
int64_t record_nodes_of(int32_t type);

/* Gives results of the argument at a position; nothing after a failure, nor where there is no room. */
void give_integer32(int32_t* place, int64_t n, int position);
void give_integer64(int64_t* place, int position);
void give_count(int64_t* place, int64_t value);
void give_reals(double* place, int64_t n, int position);
void give_text(char* place, int64_t capacity, int64_t* needed, int function);
void* give_handle(int kind);

extern const char* const recorded_names[];
extern const int recorded_number;

#ifdef __cplusplus
}
#endif
#endif
