#pragma once
/// Finds how much memory this process may have now, for callers who are about to ask for much of it: a refusal that
/// names need and limit is worth more than a machine that swaps, an allocation that fails half way, or a process that
/// is killed.

#include <cstdint>
#include <string>

namespace rollcon {

struct MemoryLimit {
  double bytes = 0;       ///< infinite where nothing limits
  const char* what = "";  ///< words in a message before the bytes: "this machine has free"; static text
};

/// Says where to look; a test puts in its own.
struct MemorySources {
  double available = 0;                      ///< bytes that the machine can give without swapping; 0: unknown
  std::string groups = "/proc/self/cgroup";  ///< membership in control groups
  std::string mount = "/sys/fs/cgroup";      ///< where their hierarchies are mounted
  double address_space = 0, data = 0;        ///< bytes left of RLIMIT_AS and RLIMIT_DATA
};

/// Returns what the machine has available and what is left of this process's limits (RLIMIT_AS, RLIMIT_DATA).
MemorySources memory_sources();

/// Returns the least of what the machine has available and what the control groups of this process (version 1 and 2,
/// those above its own included) leave, for memory that is written to. Any thread may call it.
MemoryLimit memory_limit(const MemorySources& sources);
/// Returns the least of what RLIMIT_AS and RLIMIT_DATA leave to this process, for memory that is asked for.
MemoryLimit allocation_limit(const MemorySources& sources);

/// Holds the memory for one purpose: what is asked for, and how much of that will be written to.
struct MemoryNeed {
  double allocated = 0, written = 0;  ///< bytes
};

/// Throws Error(err_memory) "<subject> 1.2 GB, this machine has free 1 GB: <remedy>" where this process cannot have
/// that. Needs below 16 MiB pass unseen: the limits are not read for them. The subject includes its verb, and is
/// formatted as printf does.
void require_memory(const MemoryNeed& need, const char* remedy, const char* subject, ...)
    __attribute__((format(printf, 3, 4)));

/// Returns the bytes that this process may have now by all limits; 0 where memory to look for them is lacking.
double memory_left() noexcept;

/// Throws Error(err_memory) after an allocation has failed: "out of memory: this machine has free 1 GB; <subject> 1.2
/// GB: <remedy>"; a need of 0 is not known, and told as "more than that". The subject includes its verb, and is
/// formatted as printf does.
[[noreturn]] void refuse_more_memory(double need, const char* remedy, const char* subject, ...)
    __attribute__((format(printf, 3, 4)));

}  // namespace rollcon
