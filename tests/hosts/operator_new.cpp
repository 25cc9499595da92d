/// Tests a host that replaced operator new by an allocator of its own, whose blocks free() must never see: everything
/// that the library takes from it comes back to it.

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "flows.hpp"

namespace {

constexpr std::uint64_t mark = 0x726f6c6c636f6e21U;
std::atomic<std::int64_t> live{0}, made{0}, foreign{0};

struct Header {
  std::uint64_t mark;
  std::size_t offset;  ///< offset of the block from what malloc gave
};

void* take(std::size_t size, std::size_t alignment) noexcept {
  const std::size_t offset = (sizeof(Header) + alignment - 1) / alignment * alignment;
  auto* memory =
      static_cast<char*>(std::aligned_alloc(alignment, (offset + size + alignment - 1) / alignment * alignment));
  if (!memory) return nullptr;
  ++live;
  ++made;
  ::new (static_cast<void*>(memory + offset - sizeof(Header))) Header{mark, offset};
  return memory + offset;
}

void give_back(void* block) noexcept {
  if (!block) return;
  auto* header = reinterpret_cast<Header*>(static_cast<char*>(block) - sizeof(Header));
  if (header->mark != mark) {
    ++foreign;
    return;
  }
  header->mark = 0;
  --live;
  std::free(static_cast<char*>(block) - header->offset);
}

void* take_or_throw(std::size_t size, std::size_t alignment) {
  if (void* block = take(size, alignment)) return block;
  throw std::bad_alloc();
}

constexpr std::size_t standard = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

// clang-format off
[[gnu::noinline]] void* operator new(std::size_t n) { return take_or_throw(n, standard); }
[[gnu::noinline]] void* operator new[](std::size_t n) { return take_or_throw(n, standard); }
[[gnu::noinline]] void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return take(n, standard); }
[[gnu::noinline]] void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return take(n, standard); }
[[gnu::noinline]] void* operator new(std::size_t n, std::align_val_t a) { return take_or_throw(n, static_cast<std::size_t>(a)); }
[[gnu::noinline]] void* operator new[](std::size_t n, std::align_val_t a) { return take_or_throw(n, static_cast<std::size_t>(a)); }
[[gnu::noinline]] void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept { return take(n, static_cast<std::size_t>(a)); }
[[gnu::noinline]] void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept { return take(n, static_cast<std::size_t>(a)); }
[[gnu::noinline]] void operator delete(void* p) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete[](void* p) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete[](void* p, std::size_t) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete[](void* p, std::align_val_t) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete(void* p, const std::nothrow_t&) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete[](void* p, const std::nothrow_t&) noexcept { give_back(p); }
// clang-format on

int main() {
  using namespace hosts;
  Verdict verdict;
  for (const Flow& flow : flows()) {
    std::int64_t before = 0, taken = 0;
    for (int repeat = 0; repeat < 3; ++repeat) {
      before = live;
      taken = made;
      Caller call;
      call.threads = 2;
      flow.run(call);
    }
    const std::int64_t kept = live - before;
    std::printf("%s: %lld blocks of the host's allocator, %lld kept (bound 0), %lld foreign (0)\n", flow.name,
                static_cast<long long>(made - taken), static_cast<long long>(kept), static_cast<long long>(foreign));
    verdict.expect(made > taken, "%s: the allocator is not used", flow.name);
    verdict.expect(kept <= 0 && foreign == 0, "%s: blocks are lost or mixed up", flow.name);
  }
  return verdict.exit_code();
}
