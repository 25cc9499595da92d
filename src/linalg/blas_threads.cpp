#include "linalg/blas_threads.hpp"

#include <mutex>

// OpenBLAS's own control; weak, so that another BLAS links as well and keeps its own setting.
extern "C" {
__attribute__((weak)) void openblas_set_num_threads(int threads);
__attribute__((weak)) int openblas_get_num_threads(void);
}

namespace rollcon {
namespace {

// The setting belongs to the process. Solves that run at the same time share the first one's
// choice; the last to leave restores the host's.
std::mutex mutex;
int users = 0;
int hosts_threads = 0;

}  // namespace

BlasThreads::BlasThreads(int threads) {
  if (!openblas_set_num_threads || !openblas_get_num_threads) return;
  const std::lock_guard lock(mutex);
  if (users++ > 0) return;
  hosts_threads = openblas_get_num_threads();
  if (hosts_threads != threads) openblas_set_num_threads(threads);
}

BlasThreads::~BlasThreads() {
  if (!openblas_set_num_threads || !openblas_get_num_threads) return;
  const std::lock_guard lock(mutex);
  if (--users > 0) return;
  if (openblas_get_num_threads() != hosts_threads) openblas_set_num_threads(hosts_threads);
}

}  // namespace rollcon
