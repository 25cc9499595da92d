#pragma once
/// Keeps the BLAS within a thread budget for the length of a scope, and puts the host's own setting back. One thread
/// where the caller's stack is too small for OpenBLAS's work on several.

namespace rollcon {

class BlasThreads {
 public:
  /// Throws Error(err_memory) where OpenBLAS would find no room for its buffer.
  explicit BlasThreads(int threads);
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;
};

}  // namespace rollcon
