/// Implements the calls that tell facts about the library.

#include <cstring>

#include "build_info.hpp"
#include "capi/api_tables.hpp"
#include "capi/guard.hpp"
#include "rollcon.h"
#include "support/last_error.hpp"

using namespace rollcon::capi;

int32_t rollcon_version(void) {
  return 10000 * ROLLCON_VERSION_MAJOR + 100 * ROLLCON_VERSION_MINOR + ROLLCON_VERSION_PATCH;
}

int32_t rollcon_abi(void) {
  return ROLLCON_ABI;
}

const char* rollcon_version_string(void) {
  return ROLLCON_VERSION_STRING;
}

const char* rollcon_build_info(void) {
  return "rollcon " ROLLCON_VERSION_STRING "; licences: " ROLLCON_BUILD_LICENCES "; compiler: " ROLLCON_BUILD_COMPILER
         "; build type: " ROLLCON_BUILD_TYPE "; LAPACK: " ROLLCON_BUILD_LAPACK
#if ROLLCON_BUILD_OPENMP
         "; OpenMP: on";
#else
         "; OpenMP: off";
#endif
}

int32_t rollcon_has_feature(const char* name) {
  if (!name) return 0;
  for (const Feature& feature : feature_table) {
    if (std::strcmp(feature.name, name) == 0) return feature.built ? 1 : 0;
  }
  return 0;
}

const char* rollcon_last_error(void) {
  return rollcon::last_error();
}

const char* rollcon_last_caveat(void) {
  return rollcon::last_caveat();
}

int32_t rollcon_report(const void* handle, int32_t status, const char* text) {
  const rollcon::QuietFloatingPoint quiet;
  const auto failure = status < 0 ? static_cast<rollcon::Status>(status) : rollcon::Status::err_argument;
  const std::shared_ptr<Object> object = handles().find(handle);
  return static_cast<int32_t>(report(nullptr, object ? object->context.get() : nullptr, failure, text ? text : ""));
}

const char* rollcon_status_string(int32_t status) {
  for (const StatusText& entry : status_table) {
    if (entry.status == status) return entry.text;
  }
  return "unknown status";
}
