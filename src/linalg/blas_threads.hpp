#pragma once
/// Holds the BLAS within a thread budget for the length of a scope, and puts back what was set before. The BLAS gets
/// one thread where the caller's stack is too small for OpenBLAS's work on several, or the address space for their
/// buffers.

namespace rollcon {

class BlasThreads {
 public:
  /// Throws Error(err_memory) where OpenBLAS would find no room for its buffer.
  explicit BlasThreads(int threads);
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int former_ = 1;
};

}  // namespace rollcon
