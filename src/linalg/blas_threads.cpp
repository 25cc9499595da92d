#include "linalg/blas_threads.hpp"

#include <cstdint>
#include <mutex>

#include "support/error.hpp"

#ifdef __GLIBC__
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

extern "C" void* __libc_stack_end;  // where the stack of the first thread begins
#endif

// OpenBLAS's own control; weak, so that another BLAS links as well and keeps its own setting.
extern "C" {
__attribute__((weak)) void openblas_set_num_threads(int threads);
__attribute__((weak)) int openblas_get_num_threads(void);
}

namespace rollcon {
namespace {

// The setting belongs to the process. Solves that run at the same time share the first one's choice; the last to leave
// restores the host's.
std::mutex mutex;
int users = 0;
int hosts_threads = 0;
int callers = 0;       ///< threads with a scope
int most_callers = 0;  ///< at a time: so many buffers OpenBLAS has, or could have had
thread_local int scopes = 0;

// OpenBLAS's getrf keeps 3.2 MB on the stack of the thread that calls it when it uses several.
constexpr std::uintptr_t stack_for_threads = std::uintptr_t{5} << 20U;

#ifdef __GLIBC__
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
/// OpenBLAS maps a buffer for every thread that calls it at a time, and asks for ever where it cannot have one.
void require_buffer() {
  constexpr std::size_t bytes = std::size_t{129} << 20U;
  void* room = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED)
    fail(Status::err_memory, "OpenBLAS needs 128 MiB of address space for a thread, and this process has no more");
  munmap(room, bytes);
}
#else
bool has_stack_for_threads() {
  return true;
}

void require_buffer() {}
#endif

}  // namespace

BlasThreads::BlasThreads(int threads) {
  if (!openblas_set_num_threads || !openblas_get_num_threads) return;
  const std::lock_guard lock(mutex);
  if (scopes == 0 && callers >= most_callers) {
    require_buffer();
    most_callers = callers + 1;
  }
  if (scopes++ == 0) ++callers;
  if (users++ > 0) return;
  hosts_threads = openblas_get_num_threads();
  if (threads > 1 && !has_stack_for_threads()) threads = 1;
  if (hosts_threads != threads) openblas_set_num_threads(threads);
}

BlasThreads::~BlasThreads() {
  if (!openblas_set_num_threads || !openblas_get_num_threads) return;
  const std::lock_guard lock(mutex);
  if (--scopes == 0) --callers;
  if (--users > 0) return;
  if (openblas_get_num_threads() != hosts_threads) openblas_set_num_threads(hosts_threads);
}

}  // namespace rollcon
