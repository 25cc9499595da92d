#pragma once
/// Gives METIS random numbers of its own within this scope, for one call at a time. METIS draws from the process's
/// random numbers and seeds them, so that orders would depend on who else runs, and the host's sequence on rollcon.
/// METIS also takes SIGABRT and SIGTERM, and gives them back without the flags and masks that the host had set; this
/// scope restores them whole.

#include <signal.h>

#include <cstdlib>
#include <mutex>

namespace rollcon {

class MetisRandom {
 public:
  MetisRandom() : lock_(mutex()), hosts_(initstate(1, state_, sizeof state_)) {
    sigaction(SIGABRT, nullptr, &abort_);
    sigaction(SIGTERM, nullptr, &terminate_);
  }
  ~MetisRandom() {
    sigaction(SIGABRT, &abort_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
    setstate(hosts_);
  }
  MetisRandom(const MetisRandom&) = delete;
  MetisRandom& operator=(const MetisRandom&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex the_mutex;
    return the_mutex;
  }
  std::lock_guard<std::mutex> lock_;
  char state_[128];
  char* hosts_;
  struct sigaction abort_, terminate_;
};

}  // namespace rollcon
