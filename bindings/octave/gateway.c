/* Implements the one MEX function of rollcon: rollcon_mex('body_create', ...). The files of +rollcon call it. It uses
   C89 and the classic C interface of MEX, which Octave has as well. */
#include "gateway.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char* name_of_status(int32_t status) {
  static const struct {
    int32_t status;
    const char* name;
  } names[] = {{1, "NOT_CONVERGED"}, {2, "NO_CONTACT"},        {3, "CANCELLED"},      {4, "RIM_CONTACT"},
               {5, "COARSE"},        {6, "INACCURATE"},        {7, "TOO_DEEP"},       {8, "DERAILED"},
               {-1, "ERR_ARGUMENT"}, {-2, "ERR_HANDLE"},       {-3, "ERR_NONFINITE"}, {-4, "ERR_MESH"},
               {-5, "ERR_STATE"},    {-6, "ERR_OPTION"},       {-7, "ERR_CAPACITY"},  {-8, "ERR_SINGULAR"},
               {-9, "ERR_MEMORY"},   {-10, "ERR_UNSUPPORTED"}, {-11, "ERR_BUSY"},     {-12, "ERR_LOAD"},
               {-13, "ERR_IO"}};
  size_t i;
  for (i = 0; i < sizeof names / sizeof names[0]; ++i)
    if (names[i].status == status) return names[i].name;
  return "ERR_INTERNAL";
}

void refuse(call* c, const char* name, const char* what) {
  char text[300];
  snprintf(text, sizeof text, "%s: %s %s", c->function, name, what);
  mexErrMsgIdAndTxt("rollcon:ERR_ARGUMENT", "%s", text);
}

/* ---------------------------------------------------------------------------------------- arguments */

int has_more(const call* c) {
  return c->nrhs > 0;
}

void no_more(call* c) {
  if (c->nrhs > 0) mexErrMsgIdAndTxt("rollcon:ERR_ARGUMENT", "%s: %d argument(s) too many", c->function, c->nrhs);
}

static const mxArray* next(call* c, const char* name) {
  if (c->nrhs < 1) refuse(c, name, "is missing");
  --c->nrhs;
  return *c->prhs++;
}

static int is_real(const mxArray* a) {
  return (mxIsDouble(a) || mxIsLogical(a) || mxIsNumeric(a)) && !mxIsComplex(a) && !mxIsSparse(a);
}

/* Returns entry i of a real array of any class of numbers. */
static double entry_of(const mxArray* a, size_t i) {
  const void* p = mxGetData(a);
  switch (mxGetClassID(a)) {
    case mxDOUBLE_CLASS:
      return ((const double*)p)[i];
    case mxSINGLE_CLASS:
      return ((const float*)p)[i];
    case mxINT8_CLASS:
      return ((const int8_t*)p)[i];
    case mxUINT8_CLASS:
      return ((const uint8_t*)p)[i];
    case mxINT16_CLASS:
      return ((const int16_t*)p)[i];
    case mxUINT16_CLASS:
      return ((const uint16_t*)p)[i];
    case mxINT32_CLASS:
      return ((const int32_t*)p)[i];
    case mxUINT32_CLASS:
      return ((const uint32_t*)p)[i];
    case mxINT64_CLASS:
      return (double)((const int64_t*)p)[i];
    case mxUINT64_CLASS:
      return (double)((const uint64_t*)p)[i];
    case mxLOGICAL_CLASS:
      return ((const mxLogical*)p)[i] ? 1 : 0;
    default:
      return mxGetNaN();
  }
}

double take_real(call* c, const char* name) {
  const mxArray* a = next(c, name);
  if (!is_real(a) || mxGetNumberOfElements(a) != 1) refuse(c, name, "is not one real number");
  return entry_of(a, 0);
}

static int64_t whole(call* c, const char* name, double value) {
  if (!(fabs(value) <= 9007199254740992.0) || value != floor(value)) refuse(c, name, "is no integer");
  return (int64_t)value;
}

static int32_t narrow(call* c, const char* name, double value) {
  const int64_t i = whole(c, name, value);
  if (i < -INT32_MAX - 1 || i > INT32_MAX) refuse(c, name, "does not fit 32 bits");
  return (int32_t)i;
}

int64_t take_integer(call* c, const char* name) {
  return whole(c, name, take_real(c, name));
}

int32_t take_handle(call* c, const char* name) {
  return narrow(c, name, take_real(c, name));
}

const char* take_text(call* c, const char* name) {
  const mxArray* a = next(c, name);
  char* text;
  if (mxIsEmpty(a)) return "";
  if (!mxIsChar(a)) refuse(c, name, "is no text");
  text = mxArrayToString(a);
  if (!text) refuse(c, name, "is no line of text");
  return text;
}

int32_t take_enumerator(call* c, const char* name, const enumerator* list, int sum) {
  const char* text;
  int32_t value = 0;
  if (c->nrhs < 1 || !mxIsChar(*c->prhs)) return narrow(c, name, take_real(c, name));
  text = take_text(c, name);
  while (*text) {
    char word[40], allowed[600] = "";
    const enumerator* e;
    size_t n = strcspn(text, " +|"), i;
    const size_t length = n < sizeof word - 1 ? n : sizeof word - 1;
    for (i = 0; i < length; ++i) word[i] = (char)(text[i] >= 'A' && text[i] <= 'Z' ? text[i] + 32 : text[i]);
    word[length] = '\0';
    text += sum ? n + strspn(text + n, " +|") : strlen(text);
    for (e = list; e->name && strcmp(e->name, word) != 0; ++e)
      snprintf(allowed + strlen(allowed), sizeof allowed - strlen(allowed), "%s%s", e == list ? "" : ", ", e->name);
    if (!e->name) {
      char what[700];
      snprintf(what, sizeof what, "is '%s'; allowed: %s", word, allowed);
      mexErrMsgIdAndTxt("rollcon:ERR_ARGUMENT", "%s: %s %s", c->function, name, what);
    }
    value |= e->value;
  }
  return value;
}

void* room(int64_t entries, size_t size) {
  return mxCalloc(entries > 0 ? (size_t)entries : 1, size);
}

/* Returns the size of the next array, checked against what it must be; 0 for an empty one. */
static const mxArray* sized(call* c, const char* name, int64_t* n, int width) {
  const mxArray* a = next(c, name);
  char what[120];
  int64_t entries, rows;
  if (!is_real(a) || mxGetNumberOfDimensions(a) > 2) refuse(c, name, "is no real matrix");
  entries = (int64_t)mxGetNumberOfElements(a);
  rows = width == 0 ? entries : (int64_t)mxGetM(a);
  /* One row may be given as a column. */
  if (width > 1 && entries == width && mxGetN(a) == 1) rows = 1;
  if (width > 0 && entries != rows * width) {
    snprintf(what, sizeof what, "has %d column(s); needed: %d", (int)mxGetN(a), width);
    refuse(c, name, what);
  }
  if (*n >= 0 && rows != *n) {
    snprintf(what, sizeof what, "has %ld %s; needed: %ld", (long)rows, width == 0 ? "entries" : "row(s)", (long)*n);
    refuse(c, name, what);
  }
  *n = rows;
  return a;
}

const double* take_reals(call* c, const char* name, int64_t* n, int width, int optional) {
  const mxArray* a;
  double* values;
  int64_t i, w;
  const int columns = width == 0 ? 1 : width;
  if (optional && (c->nrhs < 1 || mxIsEmpty(*c->prhs))) {
    if (c->nrhs > 0) next(c, name);
    return NULL;
  }
  a = sized(c, name, n, width);
  values = room(*n * columns, sizeof *values);
  for (i = 0; i < *n; ++i)
    for (w = 0; w < columns; ++w) values[i * columns + w] = entry_of(a, (size_t)(i + w * *n));
  return values;
}

const double* take_columns(call* c, const char* name, int64_t* n) {
  const mxArray* a = sized(c, name, n, 3);
  double* values = room(*n * 3, sizeof *values);
  int64_t i;
  for (i = 0; i < *n * 3; ++i) values[i] = entry_of(a, (size_t)i);
  return values;
}

const int32_t* take_integers(call* c, const char* name, int64_t* n, int width) {
  const mxArray* a = sized(c, name, n, width);
  int32_t* values;
  int64_t i, w;
  const int columns = width == 0 ? 1 : width;
  values = room(*n * columns, sizeof *values);
  for (i = 0; i < *n; ++i)
    for (w = 0; w < columns; ++w) values[i * columns + w] = narrow(c, name, entry_of(a, (size_t)(i + w * *n)));
  return values;
}

int nodes_of_type(int32_t type) {
  switch (type) {
    case ROLLCON_TRI3:
      return 3;
    case ROLLCON_QUAD4:
    case ROLLCON_TET4:
      return 4;
    case ROLLCON_TRI6:
    case ROLLCON_WEDGE6:
      return 6;
    case ROLLCON_QUAD8:
    case ROLLCON_HEX8:
      return 8;
    case ROLLCON_QUAD9:
      return 9;
    case ROLLCON_TET10:
      return 10;
    case ROLLCON_WEDGE15:
      return 15;
    case ROLLCON_HEX20:
      return 20;
    default:
      return 0; /* the library says that it knows no such type */
  }
}

/* ------------------------------------------------------------------------------------------ results */

static int wanted(const call* c) {
  return c->given == 0 || c->given < c->nlhs;
}

void give_real(call* c, double value) {
  if (wanted(c)) c->plhs[c->given++] = mxCreateDoubleScalar(value);
}

void give_text(call* c, const char* text) {
  if (wanted(c)) c->plhs[c->given++] = mxCreateString(text);
}

void give_reals(call* c, const double* values, int64_t n, int64_t width) {
  mxArray* a;
  double* p;
  int64_t i, w;
  if (!wanted(c)) return;
  a = mxCreateDoubleMatrix((mwSize)n, (mwSize)width, mxREAL);
  p = mxGetPr(a);
  for (i = 0; i < n; ++i)
    for (w = 0; w < width; ++w) p[i + w * n] = values[i * width + w];
  c->plhs[c->given++] = a;
}

void give_integers(call* c, const int32_t* values, int64_t n, int offset) {
  mxArray* a;
  double* p;
  int64_t i;
  if (!wanted(c)) return;
  a = mxCreateDoubleMatrix((mwSize)n, 1, mxREAL);
  p = mxGetPr(a);
  for (i = 0; i < n; ++i) p[i] = (double)values[i] + offset;
  c->plhs[c->given++] = a;
}

void finish(call* c, int32_t status) {
  char id[40];
  snprintf(id, sizeof id, "rollcon:%s", name_of_status(status));
  if (status < 0) mexErrMsgIdAndTxt(id, "%s", rollcon_last_error());
  if (status > 0) mexWarnMsgIdAndTxt(id, "%s", rollcon_last_caveat());
  (void)c;
}

int64_t count_words(const char* text) {
  int64_t words = 0;
  while (*text) {
    text += strspn(text, " ");
    if (*text) ++words;
    text += strcspn(text, " ");
  }
  return words;
}

/* ------------------------------------------------------------------------------------------ by hand */

/* Computes [results, status] from (contact, parameters, values, columns): results has a row for each case. */
void call_contact_solve_many(call* c) {
  rollcon_contact* contact = rollcon_contact_from_id(take_handle(c, "contact"));
  const char *parameters = take_text(c, "parameters"), *columns;
  int64_t n = -1, width = 0;
  int32_t *status, worst;
  const double* values;
  double* results;
  values = take_reals(c, "values", &n, (int)count_words(parameters), 0);
  columns = take_text(c, "columns");
  no_more(c);
  if (*columns) {
    worst = rollcon_contact_solve_many(contact, parameters, n, values, columns, 0, NULL, &width, NULL);
    if (worst < 0) finish(c, worst);
  }
  results = room(n * width, sizeof *results);
  status = room(n, sizeof *status);
  worst = rollcon_contact_solve_many(contact, parameters, n, values, columns, width, results, NULL, status);
  if (worst < 0) finish(c, worst);
  give_reals(c, results, n, width);
  give_integers(c, status, n, 0);
  finish(c, worst);
}

/* ---------------------------------------------------------------------------------------------- MEX */

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  char function[80], verb[64];
  call c;
  int i;
  if (!mexIsLocked()) mexLock(); /* handles are alive: the library must stay */
  if (nrhs < 1 || !mxIsChar(prhs[0]) || mxGetString(prhs[0], verb, sizeof verb) != 0)
    mexErrMsgIdAndTxt("rollcon:ERR_ARGUMENT", "rollcon_mex: the first argument is the name of a function");
  for (i = 0; i < number_of_calls && strcmp(calls[i].name, verb) != 0; ++i) continue;
  if (i == number_of_calls) mexErrMsgIdAndTxt("rollcon:ERR_ARGUMENT", "rollcon_mex: there is no function '%s'", verb);
  snprintf(function, sizeof function, "rollcon.%s", verb);
  c.function = function;
  c.nlhs = nlhs;
  c.nrhs = nrhs - 1;
  c.given = 0;
  c.plhs = plhs;
  c.prhs = prhs + 1;
  if (nlhs > calls[i].most_results)
    mexErrMsgIdAndTxt("rollcon:ERR_ARGUMENT", "%s: %d results wanted; it has %d", function, nlhs,
                      calls[i].most_results);
  calls[i].function(&c);
}
