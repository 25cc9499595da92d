#pragma once
/// Saves and restores the floating-point environment of a thread. fesetenv loads the x87 unit's environment, which
/// takes longer than all other guards of a call together; a control word does instead where neither that nor the modes
/// are out of the ordinary.

#include <cfenv>

#if defined(__x86_64__) && defined(__GLIBC__)
#include <xmmintrin.h>
#define ROLLCON_FAST_FP_STATE
#endif

namespace rollcon {

class FpState {
 public:
  void save() noexcept {
#ifdef ROLLCON_FAST_FP_STATE
    mxcsr_ = _mm_getcsr();
    x87_ = read_x87();
    plain_ = (mxcsr_ & ~sse_flags) == sse_default && x87_.control == x87_default;
    if (plain_) return;
#endif
    std::fegetenv(&whole_);
  }

  /// Makes the thread trap nothing, round to nearest and keep subnormals; call it after save(). Flags need not change.
  void quiet() const noexcept {
#ifdef ROLLCON_FAST_FP_STATE
    if (plain_) return;
#endif
    std::fesetenv(FE_DFL_ENV);
  }

  /// Restores what save() saved, flags included.
  void restore() const noexcept {
#ifdef ROLLCON_FAST_FP_STATE
    if (plain_) {
      const X87 now = read_x87();
      if (now.control != x87_.control || now.status != x87_.status) restore_x87();
      _mm_setcsr(mxcsr_);
      return;
    }
#endif
    std::fesetenv(&whole_);
  }

 private:
  std::fenv_t whole_;  ///< whole environment, where it is not plain
#ifdef ROLLCON_FAST_FP_STATE
  static constexpr unsigned sse_default = 0x1f80, sse_flags = 0x3f;
  static constexpr unsigned short x87_default = 0x37f;
  struct X87 {
    unsigned short control, status;
  };
  static X87 read_x87() noexcept {
    X87 now;
    __asm__ __volatile__("fnstcw %0" : "=m"(now.control));
    __asm__ __volatile__("fnstsw %0" : "=m"(now.status));
    return now;
  }
  // Something was computed in long double.
  void restore_x87() const noexcept {
    std::fenv_t now;
    std::fegetenv(&now);
    now.__control_word = x87_.control;
    now.__status_word = x87_.status;
    std::fesetenv(&now);
  }
  unsigned mxcsr_;
  X87 x87_;
  bool plain_;
#endif
};

}  // namespace rollcon
