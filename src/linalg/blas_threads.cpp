#include "linalg/blas_threads.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "support/error.hpp"

#ifdef __GLIBC__
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

extern "C" void* __libc_stack_end;  // beginning of the first thread's stack
#endif

// OpenBLAS's own control is weak, so that another BLAS links as well and keeps its own setting.
extern "C" {
__attribute__((weak)) void openblas_set_num_threads(int threads);
__attribute__((weak)) int openblas_get_num_threads(void);
__attribute__((weak)) void* blas_memory_alloc(int where);
__attribute__((weak)) void blas_memory_free(void* buffer);
}

namespace rollcon {
namespace {

// The setting belongs to the process. Callers at the same time follow the first one's choice; the last to leave
// restores the host's setting.
std::mutex mutex;
int users = 0;
int hosts_threads = 0;
int callers = 0;       ///< threads with a scope
int buffers = 0;       ///< OpenBLAS's buffers for callers
int most_threads = 1;  ///< most threads that OpenBLAS has had, its caller included
thread_local int scopes = 0;

// OpenBLAS's getrf keeps 3.2 MB on the stack of the thread that calls it when it uses several threads.
constexpr std::uintptr_t stack_for_threads = std::uintptr_t{5} << 20U;

#ifdef __GLIBC__
long process_id() {
  return getpid();
}

/// Lowest address of the calling thread's stack; 0: not known.
std::uintptr_t stack_bottom() {
  // Asking costs an allocation.
  thread_local std::uintptr_t bottom = 0;
  if (bottom != 0) return bottom;
  if (getpid() == gettid()) {
    rlimit limit{};
    const auto top = reinterpret_cast<std::uintptr_t>(__libc_stack_end);
    if (getrlimit(RLIMIT_STACK, &limit) != 0) return 0;
    return bottom = limit.rlim_cur < top ? top - limit.rlim_cur : 1;
  }
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
  void* lowest = nullptr;
  std::size_t size = 0;
  if (pthread_attr_getstack(&attributes, &lowest, &size) == 0) bottom = reinterpret_cast<std::uintptr_t>(lowest);
  pthread_attr_destroy(&attributes);
  return bottom;
}

bool has_stack_for_threads() {
  const char here = 0;
  const std::uintptr_t bottom = stack_bottom();
  return bottom != 0 && reinterpret_cast<std::uintptr_t>(&here) - bottom > stack_for_threads;
}

/// OpenBLAS maps a buffer for every thread that works in it at a time, and asks for ever where it cannot have one.
bool has_room_for(int buffers, int stacks) {
  const std::size_t bytes = static_cast<std::size_t>(128 * buffers + 12 * stacks) << 20U;
  void* room = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) return false;
  munmap(room, bytes);
  return true;
}
#else
long process_id() {
  return 0;
}

bool has_stack_for_threads() {
  return true;
}

bool has_room_for(int, int) {
  return true;
}
#endif

long owner = process_id();  ///< the process that has the threads which OpenBLAS keeps

/// Makes OpenBLAS map so many buffers, which it keeps: later allocations may leave no room for them.
void map_buffers(int count) {
  if (!blas_memory_alloc || !blas_memory_free) return;
  std::vector<void*> buffer(static_cast<std::size_t>(std::min(count, 64)));
  for (void*& b : buffer) b = blas_memory_alloc(0);
  for (void* b : buffer) blas_memory_free(b);
}

/// Maps buffers for so many callers. Other callers may be using theirs.
void require_buffers(int count) {
  // A forked child has none of the threads that OpenBLAS keeps. OpenBLAS makes all of them anew when it next needs one:
  // now, since they may take the buffers that are there before a caller does.
  const int restarted = process_id() == owner ? 0 : most_threads - 1;
  if (count <= buffers && restarted == 0) return;
  const int more = std::max(count - buffers, 0), held = more > 0 ? count + restarted : 0;
  if (!has_room_for(more > 0 ? more + callers + restarted : 0, more + restarted))
    fail(Status::err_memory, "OpenBLAS needs 128 MiB of address space for a thread, and this process has no more");
  buffers = std::max(buffers, count);
  owner = process_id();
  if (restarted > 0) openblas_set_num_threads(openblas_get_num_threads());
  map_buffers(held);
}

/// Says whether OpenBLAS can have so many threads. Each of its threads takes a buffer when it starts. Buffers for new
/// threads are mapped first, and one for the caller; else threads would take the caller's.
bool can_have_threads(int threads) {
  const int more = std::max(threads - most_threads, 0);
  if (!has_stack_for_threads() || (more > 0 && !has_room_for(more, more))) return false;
  if (more > 0) map_buffers(1 + more);
  most_threads += more;
  return true;
}

}  // namespace

BlasThreads::BlasThreads(int threads) {
  if (!openblas_set_num_threads || !openblas_get_num_threads) return;
  const std::lock_guard lock(mutex);
  former_ = openblas_get_num_threads();
  // Threads that the host has added may have taken callers' buffers.
  const int added = std::max(former_ - most_threads, 0);
  buffers = std::max(buffers - added, 0);
  most_threads += added;
  if (scopes == 0) require_buffers(callers + 1);
  if (scopes++ == 0) ++callers;
  if (users++ == 0) hosts_threads = former_;
  if (callers > 1) return;
  if (threads > 1 && !can_have_threads(threads)) threads = 1;
  if (former_ != threads) openblas_set_num_threads(threads);
}

BlasThreads::~BlasThreads() {
  if (!openblas_set_num_threads || !openblas_get_num_threads) return;
  const std::lock_guard lock(mutex);
  if (--scopes == 0) --callers;
  if (--users > 0 && (scopes == 0 || callers > 1)) return;
  const int before = users > 0 ? former_ : hosts_threads;
  if (openblas_get_num_threads() != before) openblas_set_num_threads(before);
}

}  // namespace rollcon
