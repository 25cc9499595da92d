#pragma once
/// How checks of meshes report: the first offender and their number.

#include <cstdio>
#include <string>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_type.hpp"
#include "support/error.hpp"

namespace rollcon {

const char* name(ElementType type);
const char* name(VolumeType type);

/// Counts the offenders and remembers the first; fails at the end of the sweep.
struct Tally {
  long long count = 0;
  std::string first;

  template <class... Args>
  void add(const char* format, Args... args) {
    if (count++ > 0) return;
    char text[256];
    std::snprintf(text, sizeof text, format, args...);
    first = text;
  }
  /// where: "frame", "surface" or "volume"; base: what the caller's numbers count from.
  void fail_if_any(const char* what, const char* where, std::int32_t base) const {
    if (count > 0)
      fail(Status::err_mesh, "%s; %lld such in the %s; first: %s (counting from %d)", what, count,
           where, first.c_str(), base);
  }
};

/// Nodes in range, no node twice in an element, no element twice. Before anything is computed.
void check_connectivity(const SurfaceMesh& mesh, const char* where);

}  // namespace rollcon
