/// Tests a host that loads the library a hundred times, solves with threads, and unloads it. Neither memory nor threads
/// nor mappings grow. The first time it loads and solves while it traps.
///
/// Usage: load_unload LIBRARY.

#include <dlfcn.h>
#include <fenv.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "rollcon.h"

namespace {

struct Library {
  void* handle;
  explicit Library(const char* path) : handle(dlopen(path, RTLD_NOW | RTLD_LOCAL)) {
    if (handle) return;
    std::printf("%s\n", dlerror());
    std::exit(1);
  }
  ~Library() { dlclose(handle); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  template <class F>
  F* find(F*, const char* name) const {
    void* symbol = dlsym(handle, name);
    if (!symbol) {
      std::printf("no %s\n", name);
      std::exit(1);
    }
    return reinterpret_cast<F*>(symbol);
  }
};

int failures = 0;

void require(std::int32_t status, const char* what) {
  if (status >= 0) return;
  std::printf("WRONG: %s: %d\n", what, status);
  ++failures;
}

#define OF(library, function, ...) require((library).find(&function, #function)(__VA_ARGS__), #function)

/// Rolls a sphere on a plane: a half-space and, where there are some, boundary elements.
double solve(const Library& l, std::int32_t threads) {
  rollcon_context* context = nullptr;
  rollcon_body *sphere = nullptr, *plane = nullptr;
  rollcon_contact* contact = nullptr;
  const double friction = 0.1;
  double force[3] = {};
  OF(l, rollcon_context_create, ROLLCON_ABI, &context);
  OF(l, rollcon_context_set_threads, context, threads);
  OF(l, rollcon_body_create, context, ROLLCON_BODY_HALFSPACE, &sphere);
  OF(l, rollcon_body_create, context, ROLLCON_BODY_RIGID, &plane);
  OF(l, rollcon_body_set_elastic, sphere, 0, 1e4, 0.3);
  OF(l, rollcon_contact_create, context, sphere, plane, &contact);
  OF(l, rollcon_contact_frame_rectangle, contact, ROLLCON_QUAD4, 12, 12, -1.5, 1.5, -1.5, 1.5);
  OF(l, rollcon_contact_set_gap_quadratic, contact, 0.01, 0.01, 0);
  OF(l, rollcon_contact_set_friction, contact, "coulomb", 1, &friction);
  OF(l, rollcon_contact_prescribe, contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 300);
  OF(l, rollcon_contact_set_creep, contact, 1e-3, 2e-4, 1e-3);
  for (const char* operators : {"dense", "table"}) {
    OF(l, rollcon_contact_set_str, contact, "operators", operators);
    OF(l, rollcon_contact_reset, contact);
    OF(l, rollcon_contact_solve, contact);
  }
  OF(l, rollcon_contact_get_resultant, contact, ROLLCON_LOCAL, force, nullptr);
  l.find(&rollcon_contact_release, "rollcon_contact_release")(contact);
  l.find(&rollcon_body_release, "rollcon_body_release")(sphere);
  l.find(&rollcon_body_release, "rollcon_body_release")(plane);
  l.find(&rollcon_context_release, "rollcon_context_release")(context);
  return force[0];
}

struct Process {
  long kilobytes = 0, threads = 0, mappings = 0, of_library = 0;
  Process() {
    std::ifstream status("/proc/self/status"), maps("/proc/self/maps");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("VmRSS:")) kilobytes = std::atol(line.c_str() + 6);
      if (line.starts_with("Threads:")) threads = std::atol(line.c_str() + 8);
    }
    for (std::string line; std::getline(maps, line); ++mappings)
      of_library += line.find("librollcon") != std::string::npos;
  }
  void print(const char* when) const {
    std::printf("%s: %ld kB, %ld threads, %ld mappings, %ld of them of the library\n", when, kilobytes, threads,
                mappings, of_library);
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  double right = 0;
  {
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    const Library library(argv[1]);
    right = solve(library, 2);
    fedisableexcept(FE_ALL_EXCEPT);
  }
  constexpr int times = 100, warm = 20, half = 60;
  Process early, middle;
  for (int k = 0; k < times; ++k) {
    if (k == warm) early = Process();
    if (k == half) middle = Process();
    const Library library(argv[1]);
    const double force = solve(library, 1 + k % 2);
    if (!(force == right || (force - right) * (force - right) < 1e-18 * right * right)) {
      std::printf("WRONG: force %.17g after %d loads, %.17g at first\n", force, k, right);
      ++failures;
    }
  }
  const Process late;
  early.print("after 20 loads");
  middle.print("after 60");
  late.print("after 100");
  // The runtimes of the libraries below keep their threads; nothing may grow any more. The heap may be enlarged once,
  // by 2 MB; what is lost each time is lost in both halves.
  const long lost = std::min(middle.kilobytes - early.kilobytes, late.kilobytes - middle.kilobytes);
  if (lost > 1000 || late.threads > early.threads || late.mappings > early.mappings + 4) {
    std::printf("WRONG: it grows\n");
    ++failures;
  }
  return failures > 0;
}
