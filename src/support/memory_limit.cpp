#include "support/memory_limit.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double small_need = 16.0 * 1024 * 1024;

void take_least(MemoryLimit& least, double bytes, const char* what) {
  if (bytes < least.bytes) least = {bytes, what};
}

// Bytes in a file of a control group; infinite for "max" (version 2), for the largest number that version 1 writes
// instead, and where there is no such file.
double limit_in(const std::string& file) {
  std::ifstream in(file);
  double bytes = 0;
  if (!(in >> bytes) || !(bytes > 0) || bytes > 0x1p62) return infinite;
  return bytes;
}

// Of a group and of all above it: a container may show its own group as the root, so that the path of the membership
// leads nowhere while the root has the limit.
double limit_of_group(const std::string& mount, std::string path, const char* file) {
  double least = infinite;
  for (;;) {
    least = std::min(least, limit_in(mount + path + "/" + file));
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return least;
    path.resize(slash);
  }
}

bool lists_memory(const std::string& controllers) {
  return ("," + controllers + ",").find(",memory,") != std::string::npos;
}

// Lines "number:controllers:path"; version 2 has no controllers.
double limit_of_groups(const MemorySources& sources) {
  double least = infinite;
  std::ifstream in(sources.groups);
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    std::string path = line.substr(second + 1);
    if (path == "/") path.clear();
    if (controllers.empty()) {
      // Mounted alone, or beside version 1.
      for (const char* below : {"", "/unified"})
        least = std::min(least, limit_of_group(sources.mount + below, path, "memory.max"));
    } else if (lists_memory(controllers)) {
      least = std::min(least, limit_of_group(sources.mount + "/memory", path, "memory.limit_in_bytes"));
    }
  }
  return least;
}

// Pages of column `column` of /proc/self/statm, in bytes; 0 where there is no such file.
double in_use(int column) {
  std::ifstream in("/proc/self/statm");
  double pages = 0;
  for (int k = 0; k <= column; ++k)
    if (!(in >> pages)) return 0;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double left_of(int resource, int column) {
  rlimit limit{};
  if (getrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return infinite;
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - in_use(column));
}

std::string formatted(const char* format, std::va_list args) {
  char text[512];
  std::vsnprintf(text, sizeof text, format, args);
  return text;
}

}  // namespace

MemorySources memory_sources() {
  constexpr int total_size = 0, data_size = 5;  // columns of statm
  MemorySources sources;
  sources.machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  sources.address_space = left_of(RLIMIT_AS, total_size);
  sources.data = left_of(RLIMIT_DATA, data_size);
  return sources;
}

MemoryLimit memory_limit(const MemorySources& sources) {
  MemoryLimit least{infinite, "unlimited"};
  if (sources.machine > 0) take_least(least, sources.machine, "this machine has");
  take_least(least, limit_of_groups(sources), "the control group of this process may use");
  return least;
}

MemoryLimit allocation_limit(const MemorySources& sources) {
  MemoryLimit least{infinite, "unlimited"};
  take_least(least, sources.address_space, "the limit on address space leaves this process");
  take_least(least, sources.data, "the limit on data leaves this process");
  return least;
}

void require_memory(const MemoryNeed& need, const char* remedy, const char* subject, ...) {
  const double most = std::max(need.allocated, need.written);
  if (most < small_need) return;
  const MemorySources sources = memory_sources();
  const MemoryLimit allocation = allocation_limit(sources), memory = memory_limit(sources);
  const bool allowed = need.allocated <= allocation.bytes, there = need.written <= memory.bytes;
  if (allowed && there) return;
  std::va_list args;
  va_start(args, subject);
  const std::string who = formatted(subject, args);
  va_end(args);
  const MemoryLimit& limit = there ? allocation : memory;
  fail(Status::err_memory, "%s %.3g GB, %s %.3g GB: %s", who.c_str(), 1e-9 * (there ? need.allocated : need.written),
       limit.what, 1e-9 * limit.bytes, remedy);
}

}  // namespace rollcon
