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

// Returns the bytes in a file of a control group; infinite for "max" (version 2), for the largest number that version 1
// writes instead, and where there is no such file.
double limit_in(const std::string& file) {
  std::ifstream in(file);
  double bytes = 0;
  if (!(in >> bytes) || !(bytes > 0) || bytes > 0x1p62) return infinite;
  return bytes;
}

// Returns the number behind a word in /proc/meminfo or the statistics of a group; 0 where there is none.
double number_behind(const std::string& word, const std::string& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.rfind(word, 0) == 0) return std::strtod(line.c_str() + word.size(), nullptr);
  return 0;
}

/// Names the files of one version of control groups, and the word in its statistics for cached files, whose memory can
/// be reclaimed.
struct GroupFiles {
  const char *limit, *used, *cached;
};
constexpr GroupFiles version_1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file "},
    version_2{"memory.max", "memory.current", "inactive_file "};

// Returns what a group and all above it leave: a container may show its own group as the root, so that the path of the
// membership leads nowhere while the root has the limit.
double left_of_group(const std::string& mount, std::string path, const GroupFiles& file) {
  double least = infinite;
  for (;;) {
    const std::string folder = mount + path + "/";
    if (const double limit = limit_in(folder + file.limit); limit < infinite) {
      const double used = limit_in(folder + file.used);
      const double held = used < infinite ? used - number_behind(file.cached, folder + "memory.stat") : 0;
      least = std::min(least, std::max(0.0, limit - std::max(0.0, held)));
    }
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return least;
    path.resize(slash);
  }
}

bool lists_memory(const std::string& controllers) {
  return ("," + controllers + ",").find(",memory,") != std::string::npos;
}

// Reads lines "number:controllers:path"; version 2 has no controllers.
double left_of_groups(const MemorySources& sources) {
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
      // Version 2 is mounted alone, or beside version 1.
      for (const char* below : {"", "/unified"})
        least = std::min(least, left_of_group(sources.mount + below, path, version_2));
    } else if (lists_memory(controllers)) {
      least = std::min(least, left_of_group(sources.mount + "/memory", path, version_1));
    }
  }
  return least;
}

// Returns column `column` of /proc/self/statm, which counts pages, in bytes; 0 where there is no such file.
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

MemoryLimit least_limit() {
  const MemorySources sources = memory_sources();
  const MemoryLimit allocation = allocation_limit(sources), memory = memory_limit(sources);
  return allocation.bytes < memory.bytes ? allocation : memory;
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
  sources.available = 1024 * number_behind("MemAvailable:", "/proc/meminfo");
  sources.address_space = left_of(RLIMIT_AS, total_size);
  sources.data = left_of(RLIMIT_DATA, data_size);
  return sources;
}

MemoryLimit memory_limit(const MemorySources& sources) {
  MemoryLimit least{infinite, "unlimited"};
  if (sources.available > 0) take_least(least, sources.available, "this machine has free");
  take_least(least, left_of_groups(sources), "the control group of this process leaves");
  return least;
}

MemoryLimit allocation_limit(const MemorySources& sources) {
  MemoryLimit least{infinite, "unlimited"};
  take_least(least, sources.address_space, "the limit on address space leaves this process");
  take_least(least, sources.data, "the limit on data leaves this process");
  return least;
}

const char* out_of_memory_text() noexcept {
  thread_local char text[128];
  std::snprintf(text, sizeof text, "out of memory");
  try {
    const MemoryLimit least = least_limit();
    std::snprintf(text, sizeof text, "out of memory: %s %.3g GB", least.what, 1e-9 * least.bytes);
  } catch (...) {
    // Looking needs memory, too; on failure the short text stays.
  }
  return text;
}

double memory_left() noexcept {
  try {
    return least_limit().bytes;
  } catch (...) {
    return 0;
  }
}

void refuse_more_memory(double need, const char* remedy, const char* subject, ...) {
  std::va_list args;
  va_start(args, subject);
  const std::string who = formatted(subject, args);
  va_end(args);
  const bool known = need > 0 && need < infinite;
  char bytes[32];
  std::snprintf(bytes, sizeof bytes,
                known                         ? "%.3g GB"
                : who.ends_with(" more than") ? "that"
                                              : "more than that",
                1e-9 * need);
  fail(Status::err_memory, "%s; %s %s: %s", out_of_memory_text(), who.c_str(), bytes, remedy);
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
