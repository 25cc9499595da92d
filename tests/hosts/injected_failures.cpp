#include "injected_failures.hpp"

#include <dlfcn.h>
#include <link.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>

// These names are those that glibc's own allocator keeps for those who replace the public ones.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace hosts {
namespace {

struct Code {
  std::uintptr_t begin = 0, end = 0;
};

std::atomic<std::int64_t> live{0}, made{0}, until_failure{-1}, left_alone{0};
std::atomic<bool> failed{false}, all_later{false};
std::atomic<const void*> failed_caller{nullptr};
/// The stop serves a debugger, which then shows who asked for the memory.
const bool stop_at_failure = std::getenv("ROLLCON_STOP_AT_FAILURE") != nullptr;
std::array<Code, 8> code;
std::atomic<std::size_t> codes{0};

bool is_spared(const void* caller) {
  const auto at = reinterpret_cast<std::uintptr_t>(caller);
  for (std::size_t i = 0; i < codes; ++i)
    if (at >= code[i].begin && at < code[i].end) return true;
  return false;
}

/// Counts an allocation. Returns false if it is to fail.
bool may_succeed(const void* caller) {
  made.fetch_add(1, std::memory_order_relaxed);
  if (until_failure.load(std::memory_order_relaxed) < 0) return true;
  if (is_spared(caller)) {
    ++left_alone;
    return true;
  }
  std::int64_t left = until_failure.load();
  while (left > 0 && !until_failure.compare_exchange_weak(left, left - 1)) {
  }
  if (left != 0) return true;
  if (!all_later) until_failure = -1;
  if (stop_at_failure) __builtin_trap();
  if (!failed.exchange(true)) failed_caller = caller;
  errno = ENOMEM;
  return false;
}

void* given(void* block) {
  if (block) live.fetch_add(1, std::memory_order_relaxed);
  return block;
}

}  // namespace

std::int64_t live_blocks() {
  return live;
}

std::int64_t allocations() {
  return made;
}

void fail_after(std::int64_t successes, bool lasting) {
  until_failure = -1;
  left_alone = 0;
  failed = false;
  all_later = lasting;
  until_failure = successes;
}

bool has_failed() {
  return failed;
}

const char* failed_in() {
  Dl_info info{};
  return failed && dladdr(failed_caller, &info) && info.dli_fname ? info.dli_fname : "";
}

std::int64_t successes_left() {
  return until_failure;
}

std::int64_t spared() {
  return left_alone;
}

void spare(const char* library) {
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* wanted) {
        if (!std::strstr(info->dlpi_name, static_cast<const char*>(wanted))) return 0;
        for (int i = 0; i < info->dlpi_phnum; ++i) {
          const auto& segment = info->dlpi_phdr[i];
          if (segment.p_type != PT_LOAD || !(segment.p_flags & PF_X) || codes == code.size()) continue;
          const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
          code[codes] = {begin, begin + segment.p_memsz};
          ++codes;
        }
        return 0;
      },
      const_cast<char*>(library));
}

}  // namespace hosts

using hosts::given;
using hosts::may_succeed;

extern "C" {

void* malloc(std::size_t size) {
  return may_succeed(__builtin_return_address(0)) ? given(__libc_malloc(size)) : nullptr;
}

void* calloc(std::size_t count, std::size_t size) {
  return may_succeed(__builtin_return_address(0)) ? given(__libc_calloc(count, size)) : nullptr;
}

void* realloc(void* block, std::size_t size) {
  if (!may_succeed(__builtin_return_address(0))) return nullptr;
  void* moved = __libc_realloc(block, size);
  if (!block) return given(moved);
  if (!moved && size == 0) hosts::live.fetch_sub(1, std::memory_order_relaxed);
  return moved;
}

void* memalign(std::size_t alignment, std::size_t size) {
  return may_succeed(__builtin_return_address(0)) ? given(__libc_memalign(alignment, size)) : nullptr;
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return may_succeed(__builtin_return_address(0)) ? given(__libc_memalign(alignment, size)) : nullptr;
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  void* found = may_succeed(__builtin_return_address(0)) ? given(__libc_memalign(alignment, size)) : nullptr;
  if (!found) return ENOMEM;
  *block = found;
  return 0;
}

void free(void* block) {
  if (!block) return;
  hosts::live.fetch_sub(1, std::memory_order_relaxed);
  __libc_free(block);
}

}  // extern "C"
