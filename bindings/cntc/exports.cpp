// Exports the functions of the table in both spellings.
#include "bodies.hpp"
#include "dispatch.hpp"
#include "rollcon_cntc.h"

#define CNTC_ROW(name, category, body, parameters, ...)                                \
  extern "C" CNTC_API void name parameters {                                           \
    cntc::run<cntc::Category::category>(#name, &cntc::body, __VA_ARGS__);              \
  }                                                                                    \
  extern "C" CNTC_API void name##_ parameters; /* the spelling of Fortran compilers */ \
  extern "C" CNTC_API void name##_ parameters {                                        \
    cntc::run<cntc::Category::category>(#name, &cntc::body, __VA_ARGS__);              \
  }

#include "functions.inc"

extern "C" CNTC_API void cntc_finalizelast(void) {
  cntc::finalize_last();
}
extern "C" CNTC_API void cntc_finalizelast_(void);
extern "C" CNTC_API void cntc_finalizelast_(void) {
  cntc::finalize_last();
}
