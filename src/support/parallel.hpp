#pragma once
/// Runs loops on threads of the library's own, which live as long as the loop. OpenMP's threads would outlive it: its
/// runtime ends the process when it cannot make them, hangs in a forked child, and gives them whatever floating-point
/// environment the host had when they were born.

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "support/interrupt.hpp"

namespace rollcon {

/// Calls work(data, thread) once for each number in 0 .. threads - 1, at the same time; 0 is the calling thread. The
/// others have stacks of their own size, take no signals of the host, and compute in the standard floating-point
/// environment. Numbers for which no thread can be had are left out. Rethrows the first exception once all threads have
/// ended. While the caller waits for the others its Interrupt is asked.
void run_threads(int threads, void (*work)(void*, int), void* data);

/// Says whether this thread is one of several that run_threads() keeps busy: loops within use no more.
bool in_threads();

/// Calls work(i, thread) for i in 0 .. count - 1, in chunks of neighbours that threads take as they come. thread is
/// below `threads`; equal ones never run at the same time. Which thread gets which i is not defined: work must not
/// depend on it. With one thread, with one chunk, and within another such loop the caller runs a plain loop. After an
/// exception the chunks not yet begun are skipped. Before each chunk the caller of the whole (interrupt.hpp) may stop
/// it, by Cancelled.
template <class Work>
void parallel_for(std::int64_t count, std::int64_t chunk, int threads, const Work& work) {
  const std::int64_t chunks = (count + chunk - 1) / chunk;
  if (threads <= 1 || chunks <= 1 || in_threads()) {
    for (std::int64_t first = 0; first < count; first += chunk) {
      check_interrupt();
      const std::int64_t end = std::min(first + chunk, count);
      for (std::int64_t i = first; i < end; ++i) work(i, 0);
    }
    return;
  }
  struct Loop {
    const Work& work;
    std::int64_t count, chunk;
    Interrupt* interrupt;
    std::atomic<std::int64_t> next{0};
  } loop{work, count, chunk, Interrupt::current()};
  run_threads(
      static_cast<int>(std::min<std::int64_t>(threads, chunks)),
      [](void* data, int thread) {
        Loop& l = *static_cast<Loop*>(data);
        for (;;) {
          const std::int64_t first = l.next.fetch_add(l.chunk);
          if (first >= l.count) return;
          const std::int64_t end = std::min(first + l.chunk, l.count);
          try {
            if (l.interrupt) l.interrupt->check(thread == 0);
            for (std::int64_t i = first; i < end; ++i) l.work(i, thread);
          } catch (...) {
            l.next.store(l.count);
            throw;
          }
        }
      },
      &loop);
}

}  // namespace rollcon
