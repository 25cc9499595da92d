/* Implements the recorder of record.h, for one thread at a time. */
#include "record.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FUNCTIONS = 400, LENGTH = 1000 };
static char lines[FUNCTIONS][LENGTH];
static int called[FUNCTIONS];
static char* line = lines[0];
static int32_t answer = 0;

static void put(const char* format, ...) {
  va_list arguments;
  size_t at = strlen(line);
  va_start(arguments, format);
  vsnprintf(line + at, LENGTH - at, format, arguments);
  va_end(arguments);
}

void recorder_answers(int32_t status) {
  answer = status;
}

const char* recorder_said(const char* function) {
  for (int i = 0; i < recorded_number; ++i)
    if (!strcmp(recorded_names[i], function)) return called[i] ? lines[i] : "never called";
  return "no such function";
}

const char* recorder_missing(void) {
  static char names[FUNCTIONS * 40];
  names[0] = 0;
  for (int i = 0; i < recorded_number; ++i) {
    if (called[i]) continue;
    if (names[0]) strcat(names, " ");
    strcat(names, recorded_names[i]);
  }
  return names;
}

void record_begin(int function) {
  if (function >= FUNCTIONS) abort(); /* no room: FUNCTIONS must be greater */
  called[function] = 1;
  line = lines[function];
  line[0] = 0;
}

static void blank(void) {
  if (line[0]) put(" ");
}

/* Writes down kind and number, which give_handle made. */
void record_handle(const void* handle) {
  static const char* const kinds[] = {"handle", "context", "body", "contact", "wheelrail", "table"};
  const intptr_t id = (intptr_t)handle;
  blank();
  if (handle)
    put("%s%d", kinds[id >> 28], (int)(id & 0xffffff));
  else
    put("null");
}

void record_integer(int64_t value) {
  blank();
  put("%lld", (long long)value);
}

void record_real(double value) {
  blank();
  put("%.10g", value);
}

void record_text(const char* text) {
  blank();
  put(text ? "<%s>" : "null", text);
}

void record_room(const void* place) {
  blank();
  put(place ? "room" : "null");
}

void record_integers(const int32_t* values, int64_t n) {
  blank();
  put(values ? "[" : "null");
  for (int64_t i = 0; values && i < n; ++i) put(i ? " %d" : "%d", (int)values[i]);
  if (values) put("]");
}

void record_reals(const double* values, int64_t n) {
  blank();
  put(values ? "[" : "null");
  for (int64_t i = 0; values && i < n; ++i) put(i ? " %.10g" : "%.10g", values[i]);
  if (values) put("]");
}

void record_nodes(const double* x, int64_t n, int64_t node_stride, int64_t component_stride) {
  blank();
  put("[");
  for (int64_t i = 0; i < n; ++i)
    for (int64_t j = 0; j < 3; ++j) put(i || j ? " %.10g" : "%.10g", x[i * node_stride + j * component_stride]);
  put("]");
}

int32_t record_end(void) {
  return answer;
}

int64_t record_words(const char* text) {
  int64_t words = 0;
  for (; text && *text; ++text) words += *text != ' ' && (text[1] == ' ' || !text[1]);
  return words;
}

int64_t record_nodes_of(int32_t type) {
  static const int known[][2] = {{203, 3},  {206, 6}, {214, 4},  {218, 8}, {219, 9}, {304, 4},
                                 {310, 10}, {326, 6}, {335, 15}, {338, 8}, {350, 20}};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i)
    if (known[i][0] == type) return known[i][1];
  return 0;
}

void give_integer32(int32_t* place, int64_t n, int position) {
  for (int64_t i = 0; answer >= 0 && place && i < n; ++i) place[i] = (int32_t)(100 * position + i);
}

void give_integer64(int64_t* place, int position) {
  give_count(place, 100 * position);
}

void give_count(int64_t* place, int64_t value) {
  if (answer >= 0 && place) *place = value;
}

void give_reals(double* place, int64_t n, int position) {
  for (int64_t i = 0; answer >= 0 && place && i < n; ++i) place[i] = 100 * position + (double)i + 0.5;
}

void give_text(char* place, int64_t capacity, int64_t* needed, int function) {
  char text[100];
  const int64_t length = snprintf(text, sizeof text, "text of %s", recorded_names[function]) + 1;
  if (answer < 0) return;
  if (place && capacity >= length) memcpy(place, text, (size_t)length);
  if (needed) *needed = length;
}

void* give_handle(int kind) {
  static int numbers[5];
  if (answer < 0) return NULL;
  return (void*)(((intptr_t)kind << 28) + ++numbers[kind]);
}
